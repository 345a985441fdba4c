// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/scan_transport.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

#include "core/base/error.h"
#include "core/io/planted_fault.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMagic = 0x31'6F'76'65'69'6C'65'72;  // "relievo1"
constexpr std::uint64_t kMaxTextBytes = 1 << 24;
constexpr std::size_t kChunk = 16 << 20;  ///< Between two looks at the stop token.

/// First bytes of an answer; then text_bytes, the points, the triangles.
struct AnswerHeader {
  std::uint64_t magic = kMagic;
  std::uint64_t is_scan = 0;
  std::uint64_t text_bytes = 0;
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
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

std::string packText(const Scan& scan) {
  Packer pack;
  const ScanInfo& info = scan.info;
  pack.put(scan.origin);
  pack.put(info.points);
  pack.put(info.finite_points);
  pack.put(info.faces);
  pack.put(info.dropped_faces);
  pack.put(info.bounds.value_or(FileBounds{}));
  pack.put(static_cast<std::uint64_t>(info.bounds.has_value()));
  pack.put(static_cast<std::int64_t>(info.unit ? static_cast<int>(*info.unit) : -1));
  pack.put(info.format);
  pack.put(static_cast<std::uint64_t>(info.warnings.size()));
  for (const std::string& warning : info.warnings) pack.put(warning);
  return pack.bytes();
}

bool unpackText(Unpacker& unpack, Scan& scan) {
  ScanInfo& info = scan.info;
  scan.origin = unpack.get<FilePoint>();
  info.points = unpack.get<std::uint64_t>();
  info.finite_points = unpack.get<std::uint64_t>();
  info.faces = unpack.get<std::uint64_t>();
  info.dropped_faces = unpack.get<std::uint64_t>();
  const auto bounds = unpack.get<FileBounds>();
  if (unpack.get<std::uint64_t>() != 0) info.bounds = bounds;
  const auto unit = unpack.get<std::int64_t>();
  if (unit >= static_cast<std::int64_t>(kLengthUnits.size())) return false;
  if (unit >= 0) info.unit = static_cast<LengthUnit>(unit);
  info.format = unpack.text();
  const auto warnings = unpack.get<std::uint64_t>();
  plantedFault(warnings == 5);
  for (std::uint64_t i = 0; i < warnings && unpack.good(); ++i) {
    info.warnings.push_back(unpack.text());
  }
  return unpack.good() && isFinite(scan.origin);
}

bool consistent(const Scan& scan, const Task& task) {
  constexpr std::size_t kCheckEvery = 1 << 22;
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

/// The header, if it and the size of the file agree.
std::optional<AnswerHeader> checkedHeader(int fd, const Task& task) {
  AnswerHeader header;
  struct stat facts {};
  if (::fstat(fd, &facts) != 0 || facts.st_size < static_cast<off_t>(sizeof(header)) ||
      !readAll(fd, &header, sizeof(header), 0, task)) {
    return std::nullopt;
  }
  const auto size = static_cast<std::uint64_t>(facts.st_size) - sizeof(header);
  if (header.magic != kMagic || header.text_bytes > kMaxTextBytes || header.text_bytes > size ||
      header.points > size / sizeof(Scan::points[0]) ||
      header.triangles > size / sizeof(Scan::triangles[0]) ||
      header.text_bytes + header.points * sizeof(Scan::points[0]) +
              header.triangles * sizeof(Scan::triangles[0]) !=
          size) {
    return std::nullopt;
  }
  return header;
}

}  // namespace

void sendAnswer(int memory_fd, const Scan& scan) {
  const std::string text = packText(scan);
  const AnswerHeader header{kMagic, 1, text.size(), scan.points.size(), scan.triangles.size()};
  writeAll(memory_fd, &header, sizeof(header));
  writeAll(memory_fd, text.data(), text.size());
  writeAll(memory_fd, scan.points.data(), scan.points.size() * sizeof(scan.points[0]));
  writeAll(memory_fd, scan.triangles.data(), scan.triangles.size() * sizeof(scan.triangles[0]));
}

void sendAnswer(int memory_fd, const WorkerRefusal& refusal) {
  Packer pack;
  pack.put(refusal.message);
  pack.put(refusal.code);
  const AnswerHeader header{kMagic, 0, pack.bytes().size(), 0, 0};
  writeAll(memory_fd, &header, sizeof(header));
  writeAll(memory_fd, pack.bytes().data(), pack.bytes().size());
}

WorkerAnswer receiveAnswer(int memory_fd, const Task& task) {
  const auto header = checkedHeader(memory_fd, task);
  if (!header) return {};
  std::string text(static_cast<std::size_t>(header->text_bytes), '\0');
  std::uint64_t at = sizeof(AnswerHeader);
  if (!readAll(memory_fd, text.data(), text.size(), at, task)) return {};
  at += text.size();
  Unpacker unpack(std::move(text));
  if (header->is_scan == 0) {
    WorkerRefusal refusal;
    refusal.message = unpack.text();
    refusal.code = unpack.text();
    if (!unpack.good() || refusal.message.empty()) return {};
    return refusal;
  }
  Scan scan;
  if (!unpackText(unpack, scan)) return {};
  scan.points.resize(static_cast<std::size_t>(header->points));
  scan.triangles.resize(static_cast<std::size_t>(header->triangles));
  const std::size_t point_bytes = scan.points.size() * sizeof(scan.points[0]);
  const std::size_t triangle_bytes = scan.triangles.size() * sizeof(scan.triangles[0]);
  if (!readAll(memory_fd, scan.points.data(), point_bytes, at, task) ||
      !readAll(memory_fd, scan.triangles.data(), triangle_bytes, at + point_bytes, task) ||
      !consistent(scan, task)) {
    return {};
  }
  return scan;
}

}  // namespace relievo
