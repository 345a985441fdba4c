// SPDX-License-Identifier: BSD-3-Clause
// 3D Studio meshes: vertices and faces as stored. Materials, key frames and the objects' own axes
// are left aside: vertex lists hold world coordinates already.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/io/formats/little_endian.h"
#include "core/io/formats/scalar.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint16_t kMain = 0x4D4D;
constexpr std::uint16_t kScene = 0x3D3D;
constexpr std::uint16_t kObject = 0x4000;
constexpr std::uint16_t kMesh = 0x4100;
constexpr std::uint16_t kVertices = 0x4110;
constexpr std::uint16_t kFaces = 0x4120;

constexpr std::size_t kChunkHead = 6;  ///< Kind and length.
constexpr std::size_t kVertexBytes = 12;
constexpr std::size_t kFaceBytes = 8;  ///< Three corners and flags.

struct Chunk {
  std::uint16_t kind = 0;
  std::string_view body;
};

/// The file is a tree of chunks, each with its length; a chunk beyond its parent is cut there.
class ThreeDsReader {
 public:
  explicit ThreeDsReader(const ReadJob& job) : job_(job), builder_(job.file, job.options) {}

  Scan read() {
    builder_.info().format = "3DS";
    job_.task.report("reading mesh", 0);
    std::string_view rest = job_.bytes;
    const auto main = takeChunk(rest);
    if (!main || main->kind != kMain) refuseTree();
    std::string_view parts = main->body;
    while (const auto part = takeChunk(parts)) {
      if (part->kind == kScene) readScene(part->body);
    }
    if (cut_) {
      cut_->complete_points = builder_.pointCount();
      handleTruncation(*cut_, job_, builder_.info());
    } else if (beyond_ > 0) {
      handleTruncation({RecordKind::bytes, job_.bytes.size() + beyond_, job_.bytes.size(),
                        builder_.pointCount()},
                       job_, builder_.info());
    }
    return builder_.finish();
  }

 private:
  [[noreturn]] void refuseTree() const {
    throwReadError(job_.file, said<MessageId::refused_no_3ds>(),
                   said<MessageId::advice_copy_or_export>());
  }

  /// Takes the next chunk off `rest`. @return  nothing at the end
  std::optional<Chunk> takeChunk(std::string_view& rest) {
    job_.task.check();
    if (rest.size() < kChunkHead) return std::nullopt;
    const std::uint64_t length = loadAs<std::uint32_t>(rest.data() + 2, ByteOrder::little);
    if (length < kChunkHead) refuseTree();
    if (length > rest.size()) beyond_ = std::max(beyond_, length - rest.size());
    const auto kept = static_cast<std::size_t>(std::min<std::uint64_t>(length, rest.size()));
    const Chunk chunk{u16At(rest, 0), rest.substr(kChunkHead, kept - kChunkHead)};
    rest.remove_prefix(kept);
    return chunk;
  }

  void readScene(std::string_view rest) {
    while (const auto part = takeChunk(rest)) {
      if (part->kind != kObject) continue;
      const std::size_t name_end = part->body.find('\0');
      if (name_end == std::string_view::npos) continue;  // Cut; noted by its length.
      std::string_view kinds = part->body.substr(name_end + 1);
      while (const auto kind = takeChunk(kinds)) {
        if (kind->kind == kMesh) readMesh(kind->body);
      }
    }
  }

  /// Faces count their corners from the first vertex of their own mesh, and may come before it.
  void readMesh(std::string_view rest) {
    std::vector<std::string_view> faces;
    const std::uint64_t base = builder_.pointCount();
    while (const auto part = takeChunk(rest)) {
      if (part->kind == kVertices) readVertices(part->body);
      if (part->kind == kFaces) faces.push_back(part->body);
    }
    for (const std::string_view list : faces) readFaces(list, base);
  }

  void readVertices(std::string_view list) {
    const std::size_t found = completeRecords(list, kVertexBytes, RecordKind::points);
    for (std::size_t i = 0; i < found; ++i) {
      const char* const at = list.data() + 2 + i * kVertexBytes;
      builder_.addPoint(loadDouble(at, ScalarType::f32, ByteOrder::little),
                        loadDouble(at + 4, ScalarType::f32, ByteOrder::little),
                        loadDouble(at + 8, ScalarType::f32, ByteOrder::little));
    }
    noteCutAt(builder_.pointCount());
  }

  void readFaces(std::string_view list, std::uint64_t base) {
    const std::size_t found = completeRecords(list, kFaceBytes, RecordKind::faces);
    for (std::size_t i = 0; i < found; ++i) {
      std::array<std::int64_t, 3> corners{};
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint64_t corner = base + u16At(list, 2 + i * kFaceBytes + 2 * c);
        const bool own = corner < builder_.pointCount();
        plantedFault(!own && i > 0);
        corners[c] = own ? static_cast<std::int64_t>(corner) : -1;
      }
      builder_.addFace(corners);
    }
    noteCutAt(builder_.faceCount());
  }

  /// Records of a list that starts with their number.
  std::size_t completeRecords(std::string_view list, std::size_t record_bytes, RecordKind records) {
    missing_ = 0;
    const std::size_t promised = list.size() < 2 ? 0 : u16At(list, 0);
    const std::size_t found =
        list.size() < 2 ? 0 : std::min(promised, (list.size() - 2) / record_bytes);
    if (found < promised) {
      missing_ = promised - found;
      missing_records_ = records;
    }
    return found;
  }

  void noteCutAt(std::uint64_t found) {
    if (missing_ == 0 || cut_) return;
    cut_ = Truncation{missing_records_, found + missing_, found, 0};
  }

  const ReadJob& job_;
  ScanBuilder builder_;
  std::uint64_t beyond_ = 0;  ///< Bytes that chunks promise beyond their parent's end, at most.
  std::uint64_t missing_ = 0;
  RecordKind missing_records_ = RecordKind::points;
  std::optional<Truncation> cut_;
};

}  // namespace

Scan read3ds(const ReadJob& job) {
  return ThreeDsReader(job).read();
}

}  // namespace relievo
