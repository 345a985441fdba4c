// SPDX-License-Identifier: BSD-3-Clause
// The record "laszip encoded" and the list of chunks.
#include "core/io/las/laz_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/scalar.h"
#include "core/io/las/laz_fields.h"
#include "core/io/las/laz_recovery.h"
#include "core/io/read_scan.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

constexpr std::size_t kRecordHead = 54;                   ///< Of a variable length record.
constexpr std::uint64_t kMostPoints = 1'000'000'000'000;  // A header may say anything.
constexpr std::uint64_t kMostHead = 64U << 20U;
constexpr std::uint32_t kVariable = ~std::uint32_t{0};  ///< Chunks of any number of points.
constexpr std::uint64_t kPointer = 8;  ///< Bytes before the first chunk: where the list is.
constexpr std::uint64_t kTableAtEnd = ~std::uint64_t{0};

enum Compressor : std::uint16_t { kOneStream = 1, kChunks = 2, kLayers = 3 };

template <class T>
T numberAt(std::string_view bytes, std::size_t at) {
  return loadAs<T>(bytes.data() + at, ByteOrder::little);
}

[[noreturn]] void refuse(const std::filesystem::path& file, Message what) {
  throwReadError(file, std::move(what), said<MessageId::advice_damaged_copy>());
}

struct Packing {
  std::uint16_t compressor = 0;
  std::uint32_t chunk_points = 0;
};

bool isKnown(const LazItem& item, bool layered) {
  const auto sized = [&item](std::size_t bytes) { return item.bytes == bytes; };
  switch (item.kind) {
    case LazItemKind::bytes:
      return !layered && item.bytes > 0;
    case LazItemKind::point10:
      return !layered && sized(20);
    case LazItemKind::time:
      return !layered && sized(8);
    case LazItemKind::colour10:
      return !layered && sized(6);
    case LazItemKind::waves10:
      return !layered && sized(LazWaves::kBytes);
    case LazItemKind::point14:
      return layered && sized(30);
    case LazItemKind::colour14:
      return layered && sized(6);
    case LazItemKind::colour_infrared14:
      return layered && sized(8);
    case LazItemKind::waves14:
      return layered && sized(LazWaves::kBytes);
    case LazItemKind::bytes14:
      return layered && item.bytes > 0;
    default:
      return false;
  }
}

void checkItem(const LazItem& item, bool layered, const std::filesystem::path& file) {
  if (!isKnown(item, layered)) {
    refuse(file, said<MessageId::refused_laz_fields>(static_cast<int>(item.kind), item.bytes));
  }
  // Waveforms of point formats 4 and 5 have one version.
  const unsigned newest = item.kind == LazItemKind::waves10 ? 1 : 2;
  const bool known = layered ? item.version >= 2 && item.version <= 4
                             : item.version >= 1 && item.version <= newest;
  if (!known) {
    throwReadError(file, said<MessageId::refused_laz_version>(item.version),
                   said<MessageId::advice_convert_to_las>());
  }
}

Packing readPacking(std::string_view record, LazLayout& layout, const LasHeader& header,
                    const std::filesystem::path& file) {
  constexpr std::size_t kFixed = 34, kEach = 6;
  if (record.size() < kFixed) refuse(file, said<MessageId::refused_laz_record_cut>());
  Packing packing{numberAt<std::uint16_t>(record, 0), numberAt<std::uint32_t>(record, 12)};
  if (packing.chunk_points == 0) packing.chunk_points = kVariable;  // LASzip reads it so.
  if (packing.compressor < kOneStream || packing.compressor > kLayers ||
      numberAt<std::uint16_t>(record, 2) != 0) {
    throwReadError(file, said<MessageId::refused_laz_way>(packing.compressor),
                   said<MessageId::advice_convert_to_las>());
  }
  layout.layered = packing.compressor == kLayers;
  const std::size_t count = numberAt<std::uint16_t>(record, 32);
  if (count == 0 || record.size() < kFixed + kEach * count) {
    refuse(file, said<MessageId::refused_laz_record_cut>());
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kFixed + kEach * i;
    LazItem item{static_cast<LazItemKind>(numberAt<std::uint16_t>(record, at)),
                 numberAt<std::uint16_t>(record, at + 2), numberAt<std::uint16_t>(record, at + 4)};
    checkItem(item, layout.layered, file);
    layout.record_bytes += item.bytes;
    layout.items.push_back(item);
  }
  const LazItemKind first = layout.items.front().kind;
  if (first != (layout.layered ? LazItemKind::point14 : LazItemKind::point10)) {
    refuse(file, said<MessageId::refused_laz_record_start>());
  }
  if (layout.layered != (header.point_format >= 6)) {
    refuse(file, said<MessageId::refused_laz_record_format>(header.point_format));
  }
  if (layout.record_bytes != header.record_bytes) {
    refuse(file,
           said<MessageId::refused_laz_record_bytes>(header.record_bytes, layout.record_bytes));
  }
  return packing;
}

/// Numbers of points and bytes of all chunks, from the table at `place`. @return  it is whole
bool readTable(std::string_view table, const Packing& packing, std::uint64_t most_bytes,
               std::vector<LazChunk>& chunks) {
  ArithmeticDecoder decoder(table);
  IntegerModel numbers(32, 2);
  std::uint32_t points = 0, bytes = 0;
  std::uint64_t all_bytes = 0;
  for (LazChunk& chunk : chunks) {
    if (packing.chunk_points == kVariable)
      chunk.points = points = numbers.decode(decoder, points, 0);
    chunk.bytes = bytes = numbers.decode(decoder, bytes, 1);
    if (decoder.missingBytes() > kLazSlack) return false;
    all_bytes += bytes;
    if (all_bytes <= most_bytes) continue;
    if (decoder.missingBytes() > 0) return false;
    throw LazDamage(said<MessageId::laz_more_bytes_than_there_are>());
  }
  // Coders count on a few zeros behind the end; where other bytes stood there, the sum is wrong.
  return decoder.missingBytes() == 0 || all_bytes == most_bytes;
}

/// Chunks as the list says, at `at` from its ninth byte on.
/// @return  nothing where the file ends within the list
std::optional<std::vector<LazChunk>> readList(const LazBytesSource& source, const Packing& packing,
                                              std::uint64_t at, std::uint64_t start,
                                              std::uint64_t count,
                                              const std::filesystem::path& file) {
  std::vector<LazChunk> chunks(static_cast<std::size_t>(count));
  // Each number takes at most some five bytes, most of them one.
  const std::uint64_t left = source.size - at;
  const std::uint64_t table_bytes = std::min<std::uint64_t>(left, 16 * count + 64);
  const std::string table = source.read(at, table_bytes);
  try {
    if (!readTable(table, packing, at - start, chunks)) return std::nullopt;
  } catch (const LazDamage& damage) {
    refuse(file, said<MessageId::refused_laz_list>(damage.why));
  }
  std::uint64_t chunk_at = start;
  for (LazChunk& chunk : chunks) {
    chunk.at = chunk_at;
    chunk_at += chunk.bytes;
  }
  return chunks;
}

/// @return  nothing where the file ends before or within its list of chunks
std::optional<std::vector<LazChunk>> readChunks(const LazBytesSource& source,
                                                const Packing& packing, const LasHeader& header,
                                                const LazLayout& layout,
                                                const std::filesystem::path& file) {
  constexpr std::uint64_t kTableHead = 8;
  if (header.points_at + kPointer > source.size) return std::nullopt;
  auto place = numberAt<std::uint64_t>(source.read(header.points_at, kPointer), 0);
  if (place == kTableAtEnd) {
    place = numberAt<std::uint64_t>(source.read(source.size - kPointer, kPointer), 0);
  }
  const std::uint64_t start = header.points_at + kPointer;
  if (source.size < kTableHead || place > source.size - kTableHead) return std::nullopt;
  if (place < start)
    refuse(file, said<MessageId::refused_laz_list>(said<MessageId::laz_list_in_header>()));
  const std::string head = source.read(place, kTableHead);
  const std::uint64_t count = numberAt<std::uint32_t>(head, 4);
  if (numberAt<std::uint32_t>(head, 0) != 0 || count > (place - start) / layout.record_bytes) {
    refuse(file, said<MessageId::refused_laz_list>(said<MessageId::laz_list_none>()));
  }
  return readList(source, packing, place + kTableHead, start, count, file);
}

/// Fills in what chunks of a fixed size leave open, and numbers the points.
void countPoints(const Packing& packing, std::uint64_t promised, std::vector<LazChunk>& chunks,
                 const std::filesystem::path& file) {
  if (packing.chunk_points != kVariable && !chunks.empty()) {
    const std::uint64_t before = packing.chunk_points * (chunks.size() - 1);
    for (LazChunk& chunk : chunks) chunk.points = packing.chunk_points;
    chunks.back().points = promised > before ? promised - before : 0;
    if (chunks.back().points > packing.chunk_points) chunks.back().points = 0;
  }
  std::uint64_t first = 0;
  for (LazChunk& chunk : chunks) {
    chunk.first = first;
    first += chunk.points;
  }
  const bool empty = std::any_of(chunks.begin(), chunks.end(),
                                 [](const LazChunk& chunk) { return chunk.points == 0; });
  if (empty || first != promised) {
    refuse(file, said<MessageId::refused_laz_counts>(CountArgument::grouped(promised),
                                                     CountArgument::grouped(chunks.size())));
  }
}

}  // namespace

std::optional<std::string_view> lasRecord(std::string_view head, const LasHeader& header,
                                          std::string_view owner, std::uint16_t number) {
  std::uint64_t at = header.header_bytes;
  for (std::uint32_t i = 0; i < header.variable_records; ++i) {
    if (at + kRecordHead > head.size()) return std::nullopt;
    const std::string_view record = head.substr(static_cast<std::size_t>(at));
    const std::size_t bytes = numberAt<std::uint16_t>(record, 20);
    const std::string_view name = record.substr(2, 16);
    if (name.substr(0, name.find('\0')) == owner && numberAt<std::uint16_t>(record, 18) == number) {
      return record.substr(kRecordHead, bytes);
    }
    at += kRecordHead + bytes;
  }
  return std::nullopt;
}

LazFile readLazFile(const LazBytesSource& source, const LasHeader& header,
                    const std::filesystem::path& file) {
  requireReadersAllowed("readLazFile");
  const std::string head = source.read(0, std::min({header.points_at, source.size, kMostHead}));
  const auto record = lasRecord(head, header, "laszip encoded", 22204);
  if (!record) {
    throwReadError(file, said<MessageId::refused_laz_without_record>(),
                   said<MessageId::advice_copy_or_export>());
  }
  LazFile laz;
  const Packing packing = readPacking(*record, laz.layout, header, file);
  if (header.points == 0) throw failure<MessageId::no_points>(shownName(file));
  if (header.points > kMostPoints) {
    refuse(file, said<MessageId::refused_laz_many_points>(CountArgument::grouped(header.points)));
  }
  if (packing.compressor == kOneStream) {
    if (header.points_at >= source.size)
      refuse(file, said<MessageId::refused_laz_without_points>());
    laz.has_sizes = false;
    laz.points = header.points;
    laz.chunks = {{.at = header.points_at,
                   .bytes = source.size - header.points_at,
                   .first = 0,
                   .points = header.points}};
    return laz;
  }
  auto chunks = readChunks(source, packing, header, laz.layout, file);
  if (!chunks) {
    laz.has_list = false;
    const std::uint32_t each = packing.chunk_points == kVariable ? 0 : packing.chunk_points;
    laz.chunks =
        findLazChunks(source, laz.layout, header.points_at + kPointer, each, header.points);
    for (const LazChunk& chunk : laz.chunks) laz.points += chunk.points;
    return laz;
  }
  laz.chunks = std::move(*chunks);
  laz.points = header.points;
  countPoints(packing, header.points, laz.chunks, file);
  if (const auto root = lasRecord(head, header, "copc", 1); root && laz.layout.layered) {
    readCopcLevels(source, *root, laz, file);
  }
  return laz;
}

void refuseLazChunk(const std::filesystem::path& file, std::size_t chunk, const LazDamage& damage) {
  refuse(file, said<MessageId::refused_laz_block>(CountArgument::grouped(chunk + 1), damage.why));
}

}  // namespace relievo
