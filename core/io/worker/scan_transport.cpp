// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/scan_transport.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/base/large_pages.h"
#include "core/io/file_check.h"
#include "core/io/point_block.h"
#include "core/io/worker/answer_text.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMagic = 0x32'6F'76'65'69'6C'65'72;  // "relievo2"
constexpr std::size_t kArrays = 10;
constexpr std::size_t kPointBytes = sizeof(std::array<float, 3>);
constexpr std::uint32_t kMostTexels = 16384;  ///< Of a side.
constexpr std::uint64_t kMaxTextBytes = 1 << 24;
constexpr std::size_t kCheckEvery = 1 << 22;
constexpr std::size_t kPieceBytes = 192 << 10;
constexpr std::size_t kChunk = 16 << 20;  ///< Between two looks at the stop token.
constexpr std::uint64_t kMaxCols = 1 << 24;

enum class AnswerKind : std::uint64_t { refusal, scan, raster, text, other_program };

/// First bytes of an answer; then so many bytes of each array, then of text.
/// Scan: points, triangles, colours, intensities, classes, parts, texture corners, textures of
/// triangles, texels of all textures. Raster: heights (NaN: none), origins. Text: its bytes.
struct AnswerHeader {
  std::uint64_t magic = kMagic;
  AnswerKind kind = AnswerKind::refusal;
  std::uint64_t text_bytes = 0;
  std::array<std::uint64_t, kArrays> array_bytes{};

  std::uint64_t arrayAt(std::size_t array) const noexcept {
    return std::accumulate(array_bytes.begin(),
                           array_bytes.begin() + static_cast<std::ptrdiff_t>(array),
                           std::uint64_t{sizeof(AnswerHeader)});
  }
  std::uint64_t textAt() const noexcept { return arrayAt(kArrays); }
};
static_assert(std::is_trivially_copyable_v<AnswerHeader>);

void writeAll(int fd, const void* start, std::size_t size, std::uint64_t at) {
  const auto* from = static_cast<const char*>(start);
  while (size > 0) {
    const ssize_t written = ::pwrite(fd, from, std::min(size, kChunk), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EFBIG) refuseLength();
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

std::string textOf(const Scan& scan, const std::optional<LasSystem>& system) {
  Packer packer;
  packer.put(scan.origin);
  pack(scan.info, packer);
  packer.put(static_cast<std::uint64_t>(scan.textures.size()));
  for (const Texture& texture : scan.textures) {
    packer.put(texture.cols);
    packer.put(texture.rows);
  }
  packer.put(static_cast<std::uint64_t>(system.has_value()));
  if (system) pack(*system, packer);
  return packer.bytes();
}

std::string textOf(const RasterHead& raster) {
  Packer packer;
  packer.put(raster.size);
  packer.put(raster.pixel);
  packer.put(raster.first);
  packer.put(static_cast<std::uint64_t>(raster.is_placed));
  packer.put(static_cast<std::uint64_t>(raster.is_own_map));
  packer.put(static_cast<std::uint64_t>(raster.view_from_file.has_value()));
  packer.put(raster.view_from_file.value_or(ViewFromFile{}));
  packer.put(raster.projection);
  packer.put(raster.set);
  pack(raster.info, packer);
  return packer.bytes();
}

/// Lists of points and of triangles as long as those, indices within what they name.
bool valuesConsistent(const Scan& scan, const Task& task) {
  const auto fits = [](std::size_t list, std::size_t all) { return list == 0 || list == all; };
  const std::size_t points = scan.points.size(), triangles = scan.triangles.size();
  if (!fits(scan.colours.size(), points) || !fits(scan.intensities.size(), points) ||
      !fits(scan.classes.size(), points) || !fits(scan.returns.size(), points) ||
      !fits(scan.parts.size(), points) || !fits(scan.texture_of.size(), triangles) ||
      scan.texture_corners.size() != scan.texture_of.size() ||
      scan.intensities.empty() == scan.info.intensity.has_value() ||
      (!scan.colours.empty() && !scan.info.colour)) {
    return false;
  }
  const std::size_t parts = scan.info.parts.size(), textures = scan.textures.size();
  task.check();
  const auto is_part = [parts](std::uint8_t part) { return part < parts; };
  const auto is_texture = [textures](std::uint16_t texture) {
    return texture == kNoTexture || texture < textures;
  };
  const auto is_finite = [](const TextureCorners& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const std::array<float, 2>& c) {
      return std::isfinite(c[0]) && std::isfinite(c[1]);
    });
  };
  return std::all_of(scan.parts.begin(), scan.parts.end(), is_part) &&
         std::all_of(scan.texture_of.begin(), scan.texture_of.end(), is_texture) &&
         std::all_of(scan.texture_corners.begin(), scan.texture_corners.end(), is_finite);
}

/// @param finite  so many of the points are known to be
bool consistent(const Scan& scan, std::size_t finite, const Task& task) {
  if (scan.points.empty() || scan.points.size() != scan.info.finite_points || !scan.info.bounds) {
    return false;
  }
  for (std::size_t i = finite; i < scan.points.size(); i += kCheckEvery) {
    task.check();
    const std::size_t count = std::min(kCheckEvery, scan.points.size() - i);
    if (!areFinite(std::span(scan.points).subspan(i, count))) return false;
  }
  for (std::size_t i = 0; i < scan.triangles.size(); ++i) {
    if (i % kCheckEvery == 0) task.check();
    const auto& t = scan.triangles[i];
    if (std::max({t[0], t[1], t[2]}) >= scan.points.size()) return false;
  }
  return valuesConsistent(scan, task);
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
  const auto take = [&rest](std::uint64_t part) {
    if (part > rest) return false;
    rest -= part;
    return true;
  };
  if (!std::all_of(header.array_bytes.begin(), header.array_bytes.end(), take) ||
      !take(header.text_bytes)) {
    return std::nullopt;
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
          std::span<const std::span<const std::byte>> arrays,
          const std::vector<Texture>& textures = {}) {
  AnswerHeader header;
  header.kind = kind;
  header.text_bytes = text.size();
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    header.array_bytes[i] = arrays[i].size();
    writeAll(fd, arrays[i].data(), arrays[i].size(), header.arrayAt(i));
  }
  std::uint64_t& texel_bytes = header.array_bytes[kArrays - 1];
  for (const Texture& texture : textures) {
    const auto bytes = std::as_bytes(std::span(texture.texels));
    writeAll(fd, bytes.data(), bytes.size(), header.arrayAt(kArrays - 1) + texel_bytes);
    texel_bytes += bytes.size();
  }
  writeHeader(fd, header, text);
}

/// An array of an answer, from its place in the file.
/// @return  false if the bytes are no whole number of items, or are not there
template <class Array>
bool take(int fd, std::uint64_t at, std::uint64_t bytes, Array& array, const Task& task) {
  constexpr std::size_t kItem = sizeof(typename Array::value_type);
  if (bytes % kItem != 0) return false;
  const auto all = static_cast<std::size_t>(bytes / kItem);
  reserveLarge(array, all);
  // Piece by piece: what resize sets is still in the nearer memory when it is written over.
  constexpr std::size_t kPiece = std::max<std::size_t>(1, kPieceBytes / kItem);
  while (array.size() < all) {
    const std::size_t done = array.size();
    array.resize(std::min(done + kPiece, all));
    const std::size_t piece = (array.size() - done) * kItem;
    if (!readAll(fd, array.data() + done, piece, at + done * kItem, task)) return false;
  }
  return true;
}

/// The texels of all textures, one after the other. @return  false if sizes do not agree
bool takeTextures(int fd, const AnswerHeader& header, Unpacker& unpacker, Scan& scan,
                  const Task& task) {
  std::uint64_t rest = header.array_bytes[kArrays - 1];
  std::uint64_t at = header.arrayAt(kArrays - 1);
  const auto count = unpacker.get<std::uint64_t>();
  if (count >= kNoTexture) return false;
  for (std::uint64_t i = 0; i < count && unpacker.good(); ++i) {
    Texture& texture = scan.textures.emplace_back();
    texture.cols = unpacker.get<std::uint32_t>();
    texture.rows = unpacker.get<std::uint32_t>();
    if (texture.cols < 1 || texture.cols > kMostTexels || texture.rows < 1 ||
        texture.rows > kMostTexels) {
      return false;
    }
    const std::uint64_t bytes = std::uint64_t{texture.cols} * texture.rows * sizeof(Rgba);
    if (bytes > rest || !take(fd, at, bytes, texture.texels, task)) return false;
    rest -= bytes;
    at += bytes;
  }
  return unpacker.good() && rest == 0;
}

WorkerAnswer takeScan(int fd, const AnswerHeader& header, Unpacker& unpacker, const Task& task,
                      PointsAhead& ahead) {
  Scan scan;
  scan.points = ahead.give();
  if (scan.points.size() * kPointBytes > header.array_bytes[0]) scan.points.clear();
  const std::size_t finite = scan.points.size();
  scan.origin = unpacker.get<FilePoint>();
  const auto taken = [&](std::size_t array, auto& list) {
    return take(fd, header.arrayAt(array), header.array_bytes[array], list, task);
  };
  if (!unpack(unpacker, scan.info) || !isFinite(scan.origin) || !taken(0, scan.points) ||
      !taken(1, scan.triangles) || !taken(2, scan.colours) || !taken(3, scan.intensities) ||
      !taken(4, scan.classes) || !taken(5, scan.parts) || !taken(6, scan.texture_corners) ||
      !taken(7, scan.texture_of) || !taken(8, scan.returns) ||
      !takeTextures(fd, header, unpacker, scan, task) || !consistent(scan, finite, task)) {
    return {};
  }
  const bool has_system = unpacker.get<std::uint64_t>() != 0;
  LasSystem system;
  if ((has_system && !unpack(unpacker, system)) || !unpacker.good()) return {};
  if (has_system) return ScanOfSystem{.scan = std::move(scan), .system = system};
  return scan;
}

WorkerAnswer takeRaster(int fd, const AnswerHeader& header, Unpacker& unpacker) {
  RasterHead raster;
  raster.size = unpacker.get<GridSize>();
  raster.pixel = unpacker.get<double>();
  raster.first = unpacker.get<FilePoint>();
  raster.is_placed = unpacker.get<std::uint64_t>() != 0;
  raster.is_own_map = unpacker.get<std::uint64_t>() != 0;
  const bool has_view = unpacker.get<std::uint64_t>() != 0;
  const auto view = unpacker.get<ViewFromFile>();
  if (has_view) raster.view_from_file = view;
  raster.projection = unpacker.text();
  raster.set = unpacker.text();
  if (!unpack(unpacker, raster.info) || !consistent(raster)) return {};
  const std::uint64_t cells = raster.size.count();
  const std::uint64_t heights = header.array_bytes[0], origins = header.array_bytes[1];
  if (heights / sizeof(float) != cells || heights % sizeof(float) != 0 ||
      (origins != 0 && origins != cells)) {
    return {};
  }
  OwnedFd own(::fcntl(fd, F_DUPFD_CLOEXEC, 0));
  if (own.get() < 0) return {};
  return RasterRows(std::move(raster), std::move(own), sizeof(header),
                    origins != 0 ? std::optional(sizeof(header) + heights) : std::nullopt);
}

WorkerAnswer takeText(int fd, const AnswerHeader& header, const Task& task) {
  constexpr std::uint64_t kMostBytes = 1ULL << 30U;
  WorkerText text;
  if (header.array_bytes[0] > kMostBytes ||
      !take(fd, header.arrayAt(0), header.array_bytes[0], text.bytes, task)) {
    return {};
  }
  return text;
}

WorkerAnswer takeProgram(Unpacker& unpacker) {
  const auto program = unpacker.get<std::uint64_t>();
  if (!unpacker.good() || program > static_cast<std::uint64_t>(ImportProgram::libraries)) return {};
  return OtherProgram{static_cast<ImportProgram>(program)};
}

}  // namespace

void refuseLength() {
  rlimit files{};
  ::getrlimit(RLIMIT_FSIZE, &files);
  throw AnswerTooLong(files.rlim_cur);
}

namespace {

void sendScan(int fd, const Scan& scan, const std::optional<LasSystem>& system) {
  const auto bytes = [](const auto& list) { return std::as_bytes(std::span(list)); };
  const std::array<std::span<const std::byte>, kArrays - 1> arrays{
      bytes(scan.points),          bytes(scan.triangles),  bytes(scan.colours),
      bytes(scan.intensities),     bytes(scan.classes),    bytes(scan.parts),
      bytes(scan.texture_corners), bytes(scan.texture_of), bytes(scan.returns)};
  send(fd, AnswerKind::scan, textOf(scan, system), arrays, scan.textures);
}

}  // namespace

void sendAnswer(int fd, const Scan& scan) {
  sendScan(fd, scan, std::nullopt);
}

void sendAnswer(int fd, const ScanOfSystem& scan) {
  sendScan(fd, scan.scan, scan.system);
}

void sendAnswer(int fd, const WorkerText& text) {
  const std::array<std::span<const std::byte>, 1> arrays{std::as_bytes(std::span(text.bytes))};
  send(fd, AnswerKind::text, {}, arrays);
}

void sendAnswer(int fd, const OtherProgram& other) {
  Packer packer;
  packer.put(static_cast<std::uint64_t>(other.program));
  send(fd, AnswerKind::other_program, packer.bytes(), {});
}

void sendAnswer(int fd, const WorkerRefusal& refusal) {
  Packer packer;
  packer.put(refusal.message);
  packer.put(refusal.code);
  packer.put(refusal.of_catalogue);
  send(fd, AnswerKind::refusal, packer.bytes(), {});
}

void PointsAnswer::expect(std::uint64_t count) {
  // So that the parent can make room once.
  if (::ftruncate(fd_, static_cast<off_t>(sizeof(AnswerHeader) + count * kPointBytes)) == 0) return;
  if (errno == EFBIG) refuseLength();
}

void PointsAnswer::take(std::span<const std::array<float, 3>> points) {
  writeAll(fd_, points.data(), points.size_bytes(), sizeof(AnswerHeader) + count_ * kPointBytes);
  count_ += points.size();
  tell_(count_);
}

void PointsAnswer::finish(const Scan& scan) const {
  if (count_ == 0) return sendAnswer(fd_, scan);
  AnswerHeader header;
  header.kind = AnswerKind::scan;
  header.array_bytes[0] = count_ * kPointBytes;
  const std::string text = textOf(scan, std::nullopt);
  header.text_bytes = text.size();
  writeHeader(fd_, header, text);
}

void PointsAhead::take(std::uint64_t ready, const Task& task) {
  if (!is_good_ || ready <= points_.size()) return;
  struct stat facts {};
  const bool is_long_enough =
      ::fstat(fd_, &facts) == 0 && facts.st_size > static_cast<off_t>(sizeof(AnswerHeader));
  const std::uint64_t most =
      is_long_enough
          ? (static_cast<std::uint64_t>(facts.st_size) - sizeof(AnswerHeader)) / kPointBytes
          : 0;
  is_good_ = ready <= most;
  if (!is_good_) return;
  if (points_.empty()) reserveLarge(points_, static_cast<std::size_t>(most));
  constexpr std::size_t kPiece = kPieceBytes / kPointBytes;
  while (is_good_ && points_.size() < ready) {
    const std::size_t done = points_.size();
    points_.resize(std::min<std::size_t>(done + kPiece, static_cast<std::size_t>(ready)));
    const auto piece = std::span(points_).subspan(done);
    is_good_ = readAll(fd_, piece.data(), piece.size_bytes(),
                       sizeof(AnswerHeader) + done * kPointBytes, task) &&
               areFinite(piece);
    if (!is_good_) points_.resize(done);
  }
}

void RasterAnswer::begin(const RasterHead& head, bool has_origins) {
  size_ = head.size;
  const std::uint64_t bytes =
      sizeof(AnswerHeader) +
      size_.count() * (sizeof(float) + (has_origins ? sizeof(CellStatus) : 0));
  // Asked before the work; a file system that cannot say so fails while it is written.
  const int error = ::posix_fallocate(fd_, 0, static_cast<off_t>(bytes));
  if (error == EFBIG) refuseLength();
  if (error != ENOSPC) return;
  throw failure<MessageId::heights_lack_room>(shownName(head.info.file),
                                              CountArgument::grouped((bytes >> 20U) + 1));
}

RasterSink RasterAnswer::sink() {
  return {.begin = [this](const RasterHead& head, bool origins) { begin(head, origins); },
          .row =
              [this](int row, const float* heights, const CellStatus* origins) {
                const auto cols = static_cast<std::size_t>(size_.cols);
                const std::uint64_t cell = size_.index({.col = 0, .row = row});
                const std::uint64_t at = sizeof(AnswerHeader) + cell * sizeof(float);
                writeAll(fd_, heights, cols * sizeof(float), at);
                if (origins == nullptr) return;
                const std::uint64_t after = sizeof(AnswerHeader) + size_.count() * sizeof(float);
                writeAll(fd_, origins, cols * sizeof(CellStatus), after + cell);
              }};
}

void RasterAnswer::finish(const RasterEnd& end) {
  const std::string text = textOf(end.head);
  const std::uint64_t cells = size_.count();
  AnswerHeader header;
  header.kind = AnswerKind::raster;
  header.text_bytes = text.size();
  header.array_bytes[0] = cells * sizeof(float);
  header.array_bytes[1] = end.has_origins ? cells : 0;
  writeHeader(fd_, header, text);
}

WorkerAnswer receiveAnswer(int fd, const Task& task) {
  return receiveAnswer(fd, task, PointsAhead(fd));
}

WorkerAnswer receiveAnswer(int fd, const Task& task, PointsAhead ahead) {
  const auto header = checkedHeader(fd, task);
  if (!header) return {};
  std::string text;
  if (!take(fd, header->textAt(), header->text_bytes, text, task)) return {};
  Unpacker unpacker(std::move(text));
  switch (header->kind) {
    case AnswerKind::scan:
      return takeScan(fd, *header, unpacker, task, ahead);
    case AnswerKind::raster:
      return takeRaster(fd, *header, unpacker);
    case AnswerKind::text:
      return takeText(fd, *header, task);
    case AnswerKind::other_program:
      return takeProgram(unpacker);
    case AnswerKind::refusal:
      break;
    default:
      return {};
  }
  WorkerRefusal refusal;
  refusal.message = unpacker.text();
  refusal.code = unpacker.text();
  refusal.of_catalogue = unpacker.text();
  if (!unpacker.good() || refusal.message.empty()) return {};
  return refusal;
}

}  // namespace relievo
