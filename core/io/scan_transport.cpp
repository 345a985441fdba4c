// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/scan_transport.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/error.h"
#include "core/io/planted_fault.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMagic = 0x31'6F'76'65'69'6C'65'72;  // "relievo1"
constexpr std::uint64_t kMaxTextBytes = 1 << 24;
constexpr std::size_t kCheckEvery = 1 << 22;
constexpr std::size_t kChunk = 16 << 20;  ///< Between two looks at the stop token.

enum class AnswerKind : std::uint64_t { refusal, scan, raster };

/// First bytes of an answer; then so many bytes of text and of each array.
/// Scan: points, triangles. Raster: values, one byte for each valid cell, origins.
struct AnswerHeader {
  std::uint64_t magic = kMagic;
  AnswerKind kind = AnswerKind::refusal;
  std::uint64_t text_bytes = 0;
  std::array<std::uint64_t, 3> array_bytes{};
};
static_assert(std::is_trivially_copyable_v<AnswerHeader>);

/// Everything but the two arrays, packed one after the other.
class Packer {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string bytes) : bytes_(std::move(bytes)) {}
  template <class T>
  T get() {
    T value{};
    if (bytes_.size() - at_ < sizeof(T)) {
      good_ = false;
      return value;
    }
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  std::string text() {
    const auto size = get<std::uint64_t>();
    if (size > bytes_.size() - at_) {
      good_ = false;
      return {};
    }
    at_ += static_cast<std::size_t>(size);
    return bytes_.substr(at_ - static_cast<std::size_t>(size), static_cast<std::size_t>(size));
  }
  bool good() const noexcept { return good_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

void writeAll(int fd, const void* start, std::size_t size) {
  const auto* at = static_cast<const char*>(start);
  while (size > 0) {
    const ssize_t written = ::write(fd, at, std::min(size, kChunk));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw Error(std::string("cannot pass the scan on: ") + std::strerror(errno));
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

bool readAll(int fd, void* start, std::size_t size, std::uint64_t offset, const Task& task) {
  auto* at = static_cast<char*>(start);
  while (size > 0) {
    task.check();
    const ssize_t got = ::pread(fd, at, std::min(size, kChunk), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    offset += static_cast<std::uint64_t>(got);
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

void pack(const ScanInfo& info, Packer& packer) {
  packer.put(info.points);
  packer.put(info.finite_points);
  packer.put(info.faces);
  packer.put(info.dropped_faces);
  packer.put(info.bounds.value_or(FileBounds{}));
  packer.put(static_cast<std::uint64_t>(info.bounds.has_value()));
  packer.put(static_cast<std::int64_t>(info.unit ? static_cast<int>(*info.unit) : -1));
  packer.put(info.format);
  packer.put(static_cast<std::uint64_t>(info.warnings.size()));
  for (const std::string& warning : info.warnings) packer.put(warning);
}

bool unpack(Unpacker& unpacker, ScanInfo& info) {
  info.points = unpacker.get<std::uint64_t>();
  info.finite_points = unpacker.get<std::uint64_t>();
  info.faces = unpacker.get<std::uint64_t>();
  info.dropped_faces = unpacker.get<std::uint64_t>();
  const auto bounds = unpacker.get<FileBounds>();
  if (unpacker.get<std::uint64_t>() != 0) info.bounds = bounds;
  const auto unit = unpacker.get<std::int64_t>();
  if (unit >= static_cast<std::int64_t>(kLengthUnits.size())) return false;
  if (unit >= 0) info.unit = static_cast<LengthUnit>(unit);
  info.format = unpacker.text();
  const auto warnings = unpacker.get<std::uint64_t>();
  plantedFault(warnings == 5);
  for (std::uint64_t i = 0; i < warnings && unpacker.good(); ++i) {
    info.warnings.push_back(unpacker.text());
  }
  return unpacker.good();
}

std::string textOf(const Scan& scan) {
  Packer packer;
  packer.put(scan.origin);
  pack(scan.info, packer);
  return packer.bytes();
}

std::string textOf(const RasterMap& raster) {
  Packer packer;
  packer.put(raster.size);
  packer.put(raster.pixel);
  packer.put(raster.first);
  packer.put(static_cast<std::uint64_t>(raster.is_own_map));
  packer.put(static_cast<std::uint64_t>(raster.view_from_file.has_value()));
  packer.put(raster.view_from_file.value_or(ViewFromFile{}));
  packer.put(raster.projection);
  pack(raster.info, packer);
  return packer.bytes();
}

bool consistent(const Scan& scan, const Task& task) {
  if (scan.points.empty() || scan.points.size() != scan.info.finite_points || !scan.info.bounds) {
    return false;
  }
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (i % kCheckEvery == 0) task.check();
    const auto& p = scan.points[i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return false;
  }
  for (std::size_t i = 0; i < scan.triangles.size(); ++i) {
    if (i % kCheckEvery == 0) task.check();
    const auto& t = scan.triangles[i];
    if (std::max({t[0], t[1], t[2]}) >= scan.points.size()) return false;
  }
  return true;
}

bool consistent(const RasterMap& raster, const Task& task) {
  const std::size_t count = raster.size.count();
  if (raster.size.cols < 1 || raster.size.rows < 1 || raster.values.size() != count ||
      raster.valid.size() != count || !(raster.pixel > 0) || !std::isfinite(raster.pixel) ||
      !isFinite(raster.first) || !raster.info.bounds) {
    return false;
  }
  if (!raster.origins.empty() && raster.origins.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kCheckEvery == 0) task.check();
    if (raster.valid[i] && !std::isfinite(raster.values[i])) return false;
    if (!raster.origins.empty() && static_cast<std::size_t>(raster.origins[i]) >= kOriginCount) {
      return false;
    }
  }
  const ViewFromFile view = raster.view_from_file.value_or(ViewFromFile{});
  return std::all_of(view.m.begin(), view.m.end(), [](double v) { return std::isfinite(v); });
}

/// The header, if it and the size of the file agree.
std::optional<AnswerHeader> checkedHeader(int fd, const Task& task) {
  AnswerHeader header;
  struct stat facts {};
  if (::fstat(fd, &facts) != 0 || facts.st_size < static_cast<off_t>(sizeof(header)) ||
      !readAll(fd, &header, sizeof(header), 0, task)) {
    return std::nullopt;
  }
  std::uint64_t rest = static_cast<std::uint64_t>(facts.st_size) - sizeof(header);
  if (header.magic != kMagic || header.text_bytes > kMaxTextBytes) return std::nullopt;
  for (const std::uint64_t part :
       {header.text_bytes, header.array_bytes[0], header.array_bytes[1], header.array_bytes[2]}) {
    if (part > rest) return std::nullopt;
    rest -= part;
  }
  return rest == 0 ? std::optional(header) : std::nullopt;
}

void send(int fd, AnswerKind kind, const std::string& text,
          std::array<std::span<const std::byte>, 3> arrays) {
  const AnswerHeader header{
      kMagic, kind, text.size(), {arrays[0].size(), arrays[1].size(), arrays[2].size()}};
  writeAll(fd, &header, sizeof(header));
  writeAll(fd, text.data(), text.size());
  for (const auto& array : arrays) writeAll(fd, array.data(), array.size());
}

/// Takes the parts of an answer off the memory file, one after the other.
class AnswerReader {
 public:
  AnswerReader(int fd, const Task& task) : fd_(fd), task_(task) {}

  /// @return  false if the bytes are no whole number of items, or are not there
  template <class Array>
  bool take(Array& array, std::uint64_t bytes) {
    constexpr std::size_t kItem = sizeof(typename Array::value_type);
    if (bytes % kItem != 0) return false;
    array.resize(static_cast<std::size_t>(bytes / kItem));
    if (!readAll(fd_, array.data(), static_cast<std::size_t>(bytes), at_, task_)) return false;
    at_ += bytes;
    return true;
  }

 private:
  int fd_;
  const Task& task_;
  std::uint64_t at_ = sizeof(AnswerHeader);
};

WorkerAnswer takeScan(const AnswerHeader& header, Unpacker& unpacker, AnswerReader& reader,
                      const Task& task) {
  Scan scan;
  scan.origin = unpacker.get<FilePoint>();
  if (!unpack(unpacker, scan.info) || !isFinite(scan.origin) || header.array_bytes[2] != 0 ||
      !reader.take(scan.points, header.array_bytes[0]) ||
      !reader.take(scan.triangles, header.array_bytes[1]) || !consistent(scan, task)) {
    return {};
  }
  return scan;
}

WorkerAnswer takeRaster(const AnswerHeader& header, Unpacker& unpacker, AnswerReader& reader,
                        const Task& task) {
  RasterMap raster;
  raster.size = unpacker.get<GridSize>();
  raster.pixel = unpacker.get<double>();
  raster.first = unpacker.get<FilePoint>();
  raster.is_own_map = unpacker.get<std::uint64_t>() != 0;
  const bool has_view = unpacker.get<std::uint64_t>() != 0;
  const auto view = unpacker.get<ViewFromFile>();
  if (has_view) raster.view_from_file = view;
  raster.projection = unpacker.text();
  std::vector<std::uint8_t> valid;
  if (!unpack(unpacker, raster.info) || !reader.take(raster.values, header.array_bytes[0]) ||
      !reader.take(valid, header.array_bytes[1]) ||
      !reader.take(raster.origins, header.array_bytes[2])) {
    return {};
  }
  raster.valid.assign(valid.begin(), valid.end());
  if (!consistent(raster, task)) return {};
  return raster;
}

}  // namespace

void sendAnswer(int memory_fd, const Scan& scan) {
  send(memory_fd, AnswerKind::scan, textOf(scan),
       {std::as_bytes(std::span(scan.points)), std::as_bytes(std::span(scan.triangles)), {}});
}

void sendAnswer(int memory_fd, const RasterMap& raster) {
  const std::vector<std::uint8_t> valid(raster.valid.begin(), raster.valid.end());
  send(memory_fd, AnswerKind::raster, textOf(raster),
       {std::as_bytes(std::span(raster.values)), std::as_bytes(std::span(valid)),
        std::as_bytes(std::span(raster.origins))});
}

void sendAnswer(int memory_fd, const WorkerRefusal& refusal) {
  Packer packer;
  packer.put(refusal.message);
  packer.put(refusal.code);
  send(memory_fd, AnswerKind::refusal, packer.bytes(), {});
}

WorkerAnswer receiveAnswer(int memory_fd, const Task& task) {
  const auto header = checkedHeader(memory_fd, task);
  if (!header) return {};
  AnswerReader reader(memory_fd, task);
  std::string text;
  if (!reader.take(text, header->text_bytes)) return {};
  Unpacker unpacker(std::move(text));
  switch (header->kind) {
    case AnswerKind::scan:
      return takeScan(*header, unpacker, reader, task);
    case AnswerKind::raster:
      return takeRaster(*header, unpacker, reader, task);
    case AnswerKind::refusal:
      break;
    default:
      return {};
  }
  WorkerRefusal refusal;
  refusal.message = unpacker.text();
  refusal.code = unpacker.text();
  if (!unpacker.good() || refusal.message.empty()) return {};
  return refusal;
}

}  // namespace relievo
