// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_reader.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/formats/ply_header.h"
#include "core/io/las/las_header.h"
#include "core/io/las/las_unit.h"
#include "core/io/las/las_values.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"
#include "core/io/worker/reader_guard.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kBufferBytes = 1 << 20;
/// Coordinates and flags, at the beginning of each record of LAS.
constexpr std::size_t kPointBytes = kLasFlagsAt + 1;

FileFormat formatOf(const std::filesystem::path& file) {
  const std::uint64_t size = checkedFileSize(file);
  return findFormat(readHead(file, kSniffedBytes), file, size).format;
}

void readAll(int fd, std::uint64_t at, std::span<char> bytes, const std::filesystem::path& file) {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(fd, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      throw failure<MessageId::file_became_shorter>(shownName(file));
    }
    at += static_cast<std::uint64_t>(got);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

}  // namespace

std::optional<std::uint64_t> bytesBeforePoints(const PlyHeader& header) {
  if (header.encoding == PlyEncoding::ascii || header.vertices().hasList()) return std::nullopt;
  std::uint64_t bytes = header.body_start;
  for (std::size_t e = 0; e < header.vertex_element; ++e) {
    const PlyElement& element = header.elements[e];
    if (element.hasList()) return std::nullopt;
    const std::uint64_t record = element.leastBytes();
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() / 2;
    if (record != 0 && element.count > (kMost - bytes) / record) return std::nullopt;
    bytes += element.count * record;
  }
  return bytes;
}

PointReader::PointReader(const std::filesystem::path& file, const ImportOptions& options,
                         const Task& task, StreamedParts parts) {
  requireReadersAllowed("PointReader");
  head_.info.file = file;
  head_.info.reader = "relievo";
  const FileFormat format = formatOf(file);
  fd_ = std::make_shared<OwnedFd>(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd_->get() < 0) {
    throw failure<MessageId::file_not_read>(shownName(file), std::strerror(errno));
  }
  file_bytes_ = checkedFileSize(file);
  if (format == FileFormat::las || format == FileFormat::laz) {
    openLas(options, task, parts);
  } else if (format == FileFormat::ply) {
    openPly(options);
  } else {
    throwReadError(file, said<MessageId::refused_kind_in_blocks>());
  }
  if (colour_) {
    // Of different types, which is as good as never, the one that says least.
    const auto same = [this](const StoredNumber& n) { return n.type == (*colour_)[0].type; };
    head_.colour_type =
        std::all_of(colour_->begin(), colour_->end(), same) ? (*colour_)[0].type : ScalarType::f64;
  }
  if (intensity_) head_.intensity_type = intensity_->type;
  head_.is_packed = packed_ != nullptr;
  if (packed_) head_.kept_bytes = packed_->keptBytes();
}

void PointReader::openLas(const ImportOptions& options, const Task& task, StreamedParts parts) {
  const std::string head = readHead(head_.info.file, kLasHeadBytes);
  const LasHeader header = parseLasHeader(head, head_.info.file);
  head_.info.format = (header.packed ? "LAZ 1." : "LAS 1.") + std::to_string(header.minor) +
                      " point format " + std::to_string(header.point_format);
  points_at_ = header.points_at;
  record_bytes_ = header.record_bytes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    coordinates_[axis] = {4 * axis, ScalarType::i32, header.scale[axis], header.offset[axis]};
  }
  head_.stated_bounds = header.stated_bounds;
  const LasPlaces places = lasPlaces(header.point_format);
  if (!options.scan.keep_withheld) withheld_bit_ = places.withheld_bit;
  std::size_t last_byte = kPointBytes;
  if (places.colour) {
    const auto channel = [&](std::size_t k) {
      return StoredNumber{*places.colour + 2 * k, ScalarType::u16};
    };
    colour_ = std::array{channel(0), channel(1), channel(2)};
    head_.colour_source = "red green blue";
    last_byte = *places.colour + 6;
  }
  intensity_ = StoredNumber{kLasIntensityAt, ScalarType::u16};
  head_.word_intensities = true;
  const double factor = readLasUnit(head, header, head_.info);
  if (!head_.info.unit) head_.system = lasSystem(head, header);
  head_.warnings_before_system = head_.info.warnings.size();
  convertHeights(factor);
  if (!header.packed) return setFound(header.points, options);
  const LazBytesSource source{
      .size = file_bytes_,
      .read = [fd = fd_, file = head_.info.file](std::uint64_t at, std::uint64_t bytes) {
        std::string read(static_cast<std::size_t>(bytes), '\0');
        readAll(fd->get(), at, read, file);
        return read;
      }};
  const bool values = parts == StreamedParts::values;
  record_bytes_ = values ? last_byte : kPointBytes;
  LazFile laz = readLazFile(source, header, head_.info.file);
  if (!laz.has_list) head_.info.warnings.push_back(said<MessageId::laz_list_missing>());
  setPoints(laz.points, header.points, options);
  // Withheld points are told by their flags.
  const LazWanted wanted{
      .classes = false, .flags = true, .intensities = values, .colours = values, .others = false};
  packed_ = std::make_shared<LazPoints>(source, std::move(laz), head_.info.file,
                                        LazKept{.bytes = record_bytes_, .wanted = wanted}, task);
}

void PointReader::convertHeights(double factor) noexcept {
  coordinates_[2].scale *= factor;
  coordinates_[2].shift *= factor;
  if (!head_.stated_bounds) return;
  head_.stated_bounds->min.z *= factor;
  head_.stated_bounds->max.z *= factor;
}

void PointReader::openPly(const ImportOptions& options) {
  const PlyHeader header =
      parsePlyHeader(readHead(head_.info.file, kMaxHeaderBytes), head_.info.file);
  const auto before = bytesBeforePoints(header);
  if (!before) {
    throwReadError(head_.info.file, said<MessageId::refused_ply_in_blocks>());
  }
  const bool big = header.encoding == PlyEncoding::binary_big_endian;
  head_.info.format = big ? "PLY binary_big_endian" : "PLY binary_little_endian";
  head_.info.unit = header.unit;
  head_.info.warnings = header.warnings;
  points_at_ = *before;
  record_bytes_ = static_cast<std::size_t>(header.vertices().leastBytes());
  order_ = header.byteOrder();
  const RecordLayout layout = recordLayoutOf(header);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    coordinates_[axis] = {layout.xyz[axis].offset, layout.xyz[axis].type};
  }
  colour_ = layout.colour;
  head_.colour_source = layout.colour_source;
  intensity_ = layout.intensity;
  setFound(header.vertices().count, options);
}

void PointReader::setFound(std::uint64_t promised, const ImportOptions& options) {
  plantedFault(record_bytes_ == 41);
  const std::uint64_t room =
      points_at_ < file_bytes_ ? (file_bytes_ - points_at_) / record_bytes_ : 0;
  setPoints(std::min(promised, room), promised, options);
}

/// @throw FileError  fewer than promised, and that is not accepted; none
void PointReader::setPoints(std::uint64_t found, std::uint64_t promised,
                            const ImportOptions& options) {
  head_.info.points = found;
  if (head_.info.points < promised) {
    const Task task;
    handleTruncation({RecordKind::points, promised, head_.info.points, head_.info.points},
                     {head_.info.file, {}, options, task}, head_.info);
  }
  if (head_.info.points == 0) {
    throw failure<MessageId::no_points>(shownName(head_.info.file));
  }
}

void PointReader::readRecords(std::uint64_t first, std::size_t count,
                              std::vector<char>& buffer) const {
  if (packed_) return packed_->read(first, count, buffer.data());
  readAll(fd_->get(), points_at_ + first * record_bytes_,
          std::span(buffer).first(count * record_bytes_), head_.info.file);
}

FilePoint PointReader::pointOf(const char* record) const noexcept {
  std::array<double, 3> p{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Coordinate& c = coordinates_[axis];
    p[axis] = loadDouble(record + c.offset, c.type, order_) * c.scale + c.shift;
  }
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const bool left_out =
      withheld_bit_ != 0 && (static_cast<std::uint8_t>(record[kLasFlagsAt]) & withheld_bit_) != 0;
  const bool usable = !left_out && std::all_of(p.begin(), p.end(), [](double v) {
    return std::abs(v) <= kFarthestCoordinate;
  });
  return usable ? FilePoint{p[0], p[1], p[2]} : FilePoint{kNaN, kNaN, kNaN};
}

StoredValues PointReader::valuesOf(const char* record) const noexcept {
  const auto number = [&](const StoredNumber& n) {
    return static_cast<float>(loadDouble(record + n.offset, n.type, order_));
  };
  StoredValues values;
  if (colour_)
    values.colour = {number((*colour_)[0]), number((*colour_)[1]), number((*colour_)[2])};
  if (intensity_) values.intensity = number(*intensity_);
  return values;
}

std::size_t PointReader::read(std::uint64_t first, std::span<FilePoint> block,
                              std::span<StoredValues> values) const {
  if (first >= head_.info.points) return 0;
  const auto wanted =
      static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), head_.info.points - first));
  const std::size_t at_once = std::max<std::size_t>(1, kBufferBytes / record_bytes_);
  std::vector<char> buffer(std::min(wanted, at_once) * record_bytes_);
  for (std::size_t done = 0; done < wanted;) {
    const std::size_t count = std::min(wanted - done, at_once);
    readRecords(first + done, count, buffer);
    for (std::size_t i = 0; i < count; ++i) {
      const char* const record = buffer.data() + i * record_bytes_;
      block[done + i] = pointOf(record);
      if (!values.empty()) values[done + i] = valuesOf(record);
    }
    done += count;
  }
  return wanted;
}

std::vector<PointRange> PointReader::cheapSample(std::uint64_t points) const {
  return packed_ ? packed_->cheapSample(points) : std::vector<PointRange>{};
}

}  // namespace relievo
