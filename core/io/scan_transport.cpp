// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/scan_transport.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/large_pages.h"
#include "core/io/file_check.h"
#include "core/io/planted_fault.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMagic = 0x31'6F'76'65'69'6C'65'72;  // "relievo1"
constexpr std::uint64_t kMaxTextBytes = 1 << 24;
constexpr std::size_t kCheckEvery = 1 << 22;
constexpr std::size_t kChunk = 16 << 20;  ///< Between two looks at the stop token.
constexpr std::uint64_t kMaxCols = 1 << 24;

enum class AnswerKind : std::uint64_t { refusal, scan, raster };

/// First bytes of an answer; then so many bytes of each array, then of text.
/// Scan: points, triangles. Raster: heights (NaN: none), origins.
struct AnswerHeader {
  std::uint64_t magic = kMagic;
  AnswerKind kind = AnswerKind::refusal;
  std::uint64_t text_bytes = 0;
  std::array<std::uint64_t, 2> array_bytes{};

  std::uint64_t textAt() const noexcept {
    return sizeof(AnswerHeader) + array_bytes[0] + array_bytes[1];
  }
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

void writeAll(int fd, const void* start, std::size_t size, std::uint64_t at) {
  const auto* from = static_cast<const char*>(start);
  while (size > 0) {
    const ssize_t written = ::pwrite(fd, from, std::min(size, kChunk), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EFBIG) throw std::bad_alloc();  // The worker's limit.
    if (written <= 0) throw Error(std::string("cannot pass the scan on: ") + std::strerror(errno));
    from += written;
    at += static_cast<std::uint64_t>(written);
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

std::string textOf(const RasterHead& raster) {
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

bool consistent(const RasterHead& raster) {
  const auto& bounds = raster.info.bounds;
  const ViewFromFile view = raster.view_from_file.value_or(ViewFromFile{});
  return raster.size.cols >= 1 && raster.size.rows >= 1 && raster.pixel > 0 &&
         std::isfinite(raster.pixel) && isFinite(raster.first) && bounds && isFinite(bounds->min) &&
         isFinite(bounds->max) && static_cast<std::uint64_t>(raster.size.cols) <= kMaxCols &&
         std::all_of(view.m.begin(), view.m.end(), [](double v) { return std::isfinite(v); });
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
       {header.array_bytes[0], header.array_bytes[1], header.text_bytes}) {
    if (part > rest) return std::nullopt;
    rest -= part;
  }
  return rest == 0 ? std::optional(header) : std::nullopt;
}

void writeHeader(int fd, const AnswerHeader& header, const std::string& text) {
  writeAll(fd, text.data(), text.size(), header.textAt());
  writeAll(fd, &header, sizeof(header), 0);
  if (::ftruncate(fd, static_cast<off_t>(header.textAt() + text.size())) != 0) {
    throw Error(std::string("cannot pass the scan on: ") + std::strerror(errno));
  }
}

void send(int fd, AnswerKind kind, const std::string& text,
          std::array<std::span<const std::byte>, 2> arrays) {
  const AnswerHeader header{kMagic, kind, text.size(), {arrays[0].size(), arrays[1].size()}};
  writeAll(fd, arrays[0].data(), arrays[0].size(), sizeof(header));
  writeAll(fd, arrays[1].data(), arrays[1].size(), sizeof(header) + arrays[0].size());
  writeHeader(fd, header, text);
}

/// An array of an answer, from its place in the file.
/// @return  false if the bytes are no whole number of items, or are not there
template <class Array>
bool take(int fd, std::uint64_t at, std::uint64_t bytes, Array& array, const Task& task) {
  constexpr std::size_t kItem = sizeof(typename Array::value_type);
  if (bytes % kItem != 0) return false;
  reserveLarge(array, static_cast<std::size_t>(bytes / kItem));
  array.resize(static_cast<std::size_t>(bytes / kItem));
  return readAll(fd, array.data(), static_cast<std::size_t>(bytes), at, task);
}

WorkerAnswer takeScan(int fd, const AnswerHeader& header, Unpacker& unpacker, const Task& task) {
  Scan scan;
  scan.origin = unpacker.get<FilePoint>();
  const auto [points, triangles] = header.array_bytes;
  if (!unpack(unpacker, scan.info) || !isFinite(scan.origin) ||
      !take(fd, sizeof(header), points, scan.points, task) ||
      !take(fd, sizeof(header) + points, triangles, scan.triangles, task) ||
      !consistent(scan, task)) {
    return {};
  }
  return scan;
}

WorkerAnswer takeRaster(int fd, const AnswerHeader& header, Unpacker& unpacker) {
  RasterHead raster;
  raster.size = unpacker.get<GridSize>();
  raster.pixel = unpacker.get<double>();
  raster.first = unpacker.get<FilePoint>();
  raster.is_own_map = unpacker.get<std::uint64_t>() != 0;
  const bool has_view = unpacker.get<std::uint64_t>() != 0;
  const auto view = unpacker.get<ViewFromFile>();
  if (has_view) raster.view_from_file = view;
  raster.projection = unpacker.text();
  if (!unpack(unpacker, raster.info) || !consistent(raster)) return {};
  const std::uint64_t cells = raster.size.count();
  const auto [heights, origins] = header.array_bytes;
  if (heights / sizeof(float) != cells || heights % sizeof(float) != 0 ||
      (origins != 0 && origins != cells)) {
    return {};
  }
  OwnedFd own(::fcntl(fd, F_DUPFD_CLOEXEC, 0));
  if (own.get() < 0) return {};
  return RasterRows(std::move(raster), std::move(own), sizeof(header),
                    origins != 0 ? std::optional(sizeof(header) + heights) : std::nullopt);
}

}  // namespace

void sendAnswer(int fd, const Scan& scan) {
  send(fd, AnswerKind::scan, textOf(scan),
       {std::as_bytes(std::span(scan.points)), std::as_bytes(std::span(scan.triangles))});
}

void sendAnswer(int fd, const WorkerRefusal& refusal) {
  Packer packer;
  packer.put(refusal.message);
  packer.put(refusal.code);
  send(fd, AnswerKind::refusal, packer.bytes(), {});
}

void RasterAnswer::begin(const RasterHead& head, bool has_origins) {
  size_ = head.size;
  const std::uint64_t bytes =
      sizeof(AnswerHeader) + size_.count() * (sizeof(float) + (has_origins ? sizeof(Origin) : 0));
  // Asked before the work; a file system that cannot say so fails while it is written.
  const int error = ::posix_fallocate(fd_, 0, static_cast<off_t>(bytes));
  if (error == EFBIG) throw std::bad_alloc();
  if (error != ENOSPC) return;
  throw FileError("Cannot read " + shownName(head.info.file) + ": its heights take " +
                  grouped((bytes >> 20U) + 1) +
                  " MB, and there is less room where they are kept meanwhile. Free some space, or "
                  "write the result to another disk.");
}

RasterSink RasterAnswer::sink() {
  return {.begin = [this](const RasterHead& head, bool origins) { begin(head, origins); },
          .row =
              [this](int row, const float* heights, const Origin* origins) {
                const auto cols = static_cast<std::size_t>(size_.cols);
                const std::uint64_t cell = size_.index({.col = 0, .row = row});
                const std::uint64_t at = sizeof(AnswerHeader) + cell * sizeof(float);
                writeAll(fd_, heights, cols * sizeof(float), at);
                if (origins == nullptr) return;
                const std::uint64_t after = sizeof(AnswerHeader) + size_.count() * sizeof(float);
                writeAll(fd_, origins, cols * sizeof(Origin), after + cell);
              }};
}

void RasterAnswer::finish(const RasterEnd& end) {
  const std::string text = textOf(end.head);
  const std::uint64_t cells = size_.count();
  writeHeader(fd_,
              {kMagic,
               AnswerKind::raster,
               text.size(),
               {cells * sizeof(float), end.has_origins ? cells : 0}},
              text);
}

WorkerAnswer receiveAnswer(int fd, const Task& task) {
  const auto header = checkedHeader(fd, task);
  if (!header) return {};
  std::string text;
  if (!take(fd, header->textAt(), header->text_bytes, text, task)) return {};
  Unpacker unpacker(std::move(text));
  switch (header->kind) {
    case AnswerKind::scan:
      return takeScan(fd, *header, unpacker, task);
    case AnswerKind::raster:
      return takeRaster(fd, *header, unpacker);
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
