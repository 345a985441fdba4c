// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/las_header.h"
#include "core/io/las_records.h"
#include "core/io/las_unit.h"
#include "core/io/planted_fault.h"
#include "core/io/ply_header.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/system_unit.h"
#include "core/io/unpack_las.h"

namespace relievo {
namespace {

constexpr std::size_t kBufferBytes = 1 << 20;
constexpr std::uint64_t kMostPoints = 1'000'000'000'000;  // A packed header may say anything.

FileFormat formatOf(const std::filesystem::path& file) {
  const std::uint64_t size = checkedFileSize(file);
  return findFormat(readHead(file, kSniffedBytes), file, size).format;
}

/// Bytes before the points, if points and all that comes before them have records of fixed size.
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

}  // namespace

bool PointStream::canStream(const std::filesystem::path& file) {
  const FileFormat format = formatOf(file);
  if (format == FileFormat::las || format == FileFormat::laz) return true;
  if (format != FileFormat::ply) return false;
  return bytesBeforePoints(parsePlyHeader(readHead(file, kMaxHeaderBytes), file)).has_value();
}

bool PointStream::isPacked(const std::filesystem::path& file) {
  return formatOf(file) == FileFormat::laz;
}

PointStream::PointStream(const std::filesystem::path& file, const ImportOptions& options,
                         const Task& task) {
  info_.file = file;
  info_.reader = "relievo";
  const FileFormat format = formatOf(file);
  if (format == FileFormat::laz) openPacked(options, task);
  const std::filesystem::path& read = unpacked_ ? unpacked_->file() : file;
  fd_.reset(::open(read.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd_.get() < 0) refuseScan(file, std::string(std::strerror(errno)) + ".");
  if (!unpacked_) file_bytes_ = checkedFileSize(file);
  if (format == FileFormat::las || unpacked_) {
    openLas(read, options);
  } else if (format == FileFormat::ply) {
    openPly(options);
  } else {
    refuseScan(file,
               "only LAS, LAZ and binary PLY files are read in blocks. Convert it to LAS first.");
  }
}

void PointStream::openPacked(const ImportOptions& options, const Task& task) {
  unpacked_ = std::make_shared<UnpackedLas>(info_.file, task);
  if (options.accept_incomplete) {
    unpacked_->waitForAll(task);  // How many there are is to be known first.
  } else {
    unpacked_->waitFor(kLasHeadBytes);
  }
  if (formatOf(unpacked_->file()) != FileFormat::las) {
    refuseScan(info_.file, "what it was unpacked to is no LAS file.");
  }
}

void PointStream::openLas(const std::filesystem::path& las, const ImportOptions& options) {
  const std::string head = readHead(las, kLasHeadBytes);
  const LasHeader header = parseLasHeader(head, info_.file);
  info_.format = "LAS 1." + std::to_string(header.minor) + " point format " +
                 std::to_string(header.point_format);
  points_at_ = header.points_at;
  record_bytes_ = header.record_bytes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    coordinates_[axis] = {4 * axis, ScalarType::i32, header.scale[axis], header.offset[axis]};
  }
  stated_bounds_ = header.stated_bounds;
  if (!options.scan.keep_withheld) withheld_bit_ = lasPlaces(header.point_format).withheld_bit;
  double factor = readLasUnit(head, header, info_);
  factor *= addUnitOfSystem(head, header, info_);
  coordinates_[2].scale *= factor;
  coordinates_[2].shift *= factor;
  const auto convertBounds = [&] {
    if (!stated_bounds_) return;
    stated_bounds_->min.z *= factor;
    stated_bounds_->max.z *= factor;
  };
  convertBounds();
  if (!unpacked_) return setFound(header.points, options);
  // Some programs write counts and bounds last.
  const LasHeader packed = packedLasHeader(info_.file);
  info_.format.replace(0, 3, "LAZ");
  stated_bounds_ = packed.stated_bounds;
  convertBounds();
  const std::uint64_t promised = std::min(packed.points, kMostPoints);
  file_bytes_ =
      options.accept_incomplete ? checkedFileSize(las) : points_at_ + promised * record_bytes_;
  setFound(promised, options);
}

void PointStream::openPly(const ImportOptions& options) {
  const PlyHeader header = parsePlyHeader(readHead(info_.file, kMaxHeaderBytes), info_.file);
  const auto before = bytesBeforePoints(header);
  if (!before) {
    refuseScan(info_.file,
               "its points have no fixed places in the file (text, or lists). Save it as binary "
               "PLY, or as LAS.");
  }
  const bool big = header.encoding == PlyEncoding::binary_big_endian;
  info_.format = big ? "PLY binary_big_endian" : "PLY binary_little_endian";
  info_.unit = header.unit;
  info_.warnings = header.warnings;
  points_at_ = *before;
  record_bytes_ = static_cast<std::size_t>(header.vertices().leastBytes());
  order_ = header.byteOrder();
  std::size_t offset = 0;
  for (std::size_t p = 0; p < header.vertices().properties.size(); ++p) {
    const PlyProperty& property = header.vertices().properties[p];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (header.xyz[axis] == p) coordinates_[axis] = {offset, property.type};
    }
    offset += byteSize(property.type);
  }
  setFound(header.vertices().count, options);
}

void PointStream::setFound(std::uint64_t promised, const ImportOptions& options) {
  plantedFault(record_bytes_ == 41);
  const std::uint64_t room =
      points_at_ < file_bytes_ ? (file_bytes_ - points_at_) / record_bytes_ : 0;
  info_.points = std::min(promised, room);
  if (info_.points < promised) {
    const Task task;
    handleShortfall({"points", promised, info_.points, info_.points},
                    {info_.file, {}, options, task}, info_);
  }
  if (info_.points == 0) {
    refuseScan(info_.file, "it has 0 points. Choose another file.");
  }
}

void PointStream::readBytes(std::uint64_t at, std::span<char> bytes) const {
  if (unpacked_ && !unpacked_->waitFor(at + bytes.size())) {
    refuseScan(info_.file,
               "unpacked it has fewer points than its header says. The file is probably damaged; "
               "copy or export it again.");
  }
  while (!bytes.empty()) {
    const ssize_t got = ::pread(fd_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      refuseScan(info_.file, "it became shorter while it was read, or its disk failed. Try again.");
    }
    at += static_cast<std::uint64_t>(got);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

FilePoint PointStream::pointOf(const char* record) const noexcept {
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

std::size_t PointStream::read(std::uint64_t first, std::span<FilePoint> block) const {
  if (first >= info_.points) return 0;
  const auto wanted =
      static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), info_.points - first));
  const std::size_t at_once = std::max<std::size_t>(1, kBufferBytes / record_bytes_);
  std::vector<char> buffer(std::min(wanted, at_once) * record_bytes_);
  for (std::size_t done = 0; done < wanted;) {
    const std::size_t count = std::min(wanted - done, at_once);
    readBytes(points_at_ + (first + done) * record_bytes_,
              std::span(buffer).first(count * record_bytes_));
    for (std::size_t i = 0; i < count; ++i) {
      block[done + i] = pointOf(buffer.data() + i * record_bytes_);
    }
    done += count;
  }
  return wanted;
}

}  // namespace relievo
