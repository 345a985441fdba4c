// SPDX-License-Identifier: BSD-3-Clause
// Layout: LAS specification 1.4 R15, section 2.4; earlier versions are prefixes of it.
#include "core/io/las/las_header.h"

#include <cmath>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/scalar.h"
#include "core/io/read_scan.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

constexpr std::size_t kHeader = 227;  ///< Versions 1.0 to 1.2.
constexpr std::size_t kHeader14 = 375;
constexpr std::array<std::size_t, 11> kRecordBytes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

template <class T>
T fieldAt(std::string_view bytes, std::size_t at) {
  return loadAs<T>(bytes.data() + at, ByteOrder::little);
}

void checkVersion(std::string_view bytes, const std::filesystem::path& file) {
  const int major = fieldAt<std::uint8_t>(bytes, 24);
  const int minor = fieldAt<std::uint8_t>(bytes, 25);
  if (major == 1 && minor <= 4) return;
  throwReadError(file, said<MessageId::refused_las_version>(major, minor));
}

std::uint64_t pointCount(std::string_view bytes, const LasHeader& header) {
  const std::uint64_t legacy = fieldAt<std::uint32_t>(bytes, 107);
  if (header.minor < 4) return legacy;
  const auto count = fieldAt<std::uint64_t>(bytes, 247);
  return count != 0 ? count : legacy;
}

void checkRecords(const LasHeader& header, const std::filesystem::path& file) {
  const auto format = static_cast<std::size_t>(header.point_format);
  if (format >= kRecordBytes.size()) {
    throwReadError(file, said<MessageId::refused_las_format>(format),
                   said<MessageId::advice_export_again>());
  }
  if (header.record_bytes < kRecordBytes[format]) {
    throwReadError(file,
                   said<MessageId::refused_las_record_bytes>(format, header.record_bytes,
                                                             kRecordBytes[format]),
                   said<MessageId::advice_export_again>());
  }
  if (header.points_at < header.header_bytes) {
    throwReadError(file, said<MessageId::refused_las_points_at>(),
                   said<MessageId::advice_export_again>());
  }
}

void readScales(std::string_view bytes, LasHeader& header, const std::filesystem::path& file) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scale[axis] = fieldAt<double>(bytes, 131 + 8 * axis);
    header.offset[axis] = fieldAt<double>(bytes, 155 + 8 * axis);
    if (!std::isfinite(header.scale[axis]) || header.scale[axis] == 0 ||
        !std::isfinite(header.offset[axis])) {
      throwReadError(file, said<MessageId::refused_las_scale>(),
                     said<MessageId::advice_export_again>());
    }
  }
}

/// Stored as largest and smallest x, then y, then z.
std::optional<FileBounds> statedBounds(std::string_view bytes) {
  const auto at = [bytes](std::size_t i) { return fieldAt<double>(bytes, 179 + 8 * i); };
  const FileBounds bounds{{at(1), at(3), at(5)}, {at(0), at(2), at(4)}};
  if (!isFinite(bounds.min) || !isFinite(bounds.max)) return std::nullopt;
  const bool inverted =
      bounds.min.x > bounds.max.x || bounds.min.y > bounds.max.y || bounds.min.z > bounds.max.z;
  if (inverted || bounds.min == bounds.max) return std::nullopt;
  return bounds;
}

}  // namespace

LasHeader parseLasHeader(std::string_view bytes, const std::filesystem::path& file) {
  requireReadersAllowed("parseLasHeader");
  if (bytes.size() < kHeader) {
    throw failure<MessageId::shorter_than_las_header>(shownName(file));
  }
  checkVersion(bytes, file);
  LasHeader header;
  header.minor = fieldAt<std::uint8_t>(bytes, 25);
  header.header_bytes = fieldAt<std::uint16_t>(bytes, 94);
  const std::size_t needed = header.minor >= 4 ? kHeader14 : kHeader;
  if (bytes.size() < needed) {
    throw failure<MessageId::shorter_than_las_header>(shownName(file));
  }
  if (header.header_bytes < needed) {
    throwReadError(file, said<MessageId::refused_las_header_bytes>(header.header_bytes, needed),
                   said<MessageId::advice_export_again>());
  }
  header.points_at = fieldAt<std::uint32_t>(bytes, 96);
  header.variable_records = fieldAt<std::uint32_t>(bytes, 100);
  constexpr unsigned kFormatBits = 0x3F;  // The others say that it is packed.
  const unsigned format = fieldAt<std::uint8_t>(bytes, 104);
  header.point_format = static_cast<int>(format & kFormatBits);
  header.packed = format > kFormatBits;
  header.record_bytes = fieldAt<std::uint16_t>(bytes, 105);
  checkRecords(header, file);
  header.points = pointCount(bytes, header);
  readScales(bytes, header, file);
  header.stated_bounds = statedBounds(bytes);
  return header;
}

}  // namespace relievo
