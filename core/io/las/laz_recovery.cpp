// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/las/laz_recovery.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/io/formats/scalar.h"

namespace relievo {
namespace {

std::uint32_t countAt(const std::string& bytes, std::size_t at) {
  return loadAs<std::uint32_t>(bytes.data() + at, ByteOrder::little);
}

/// The chunk at `at` by what it says of itself. Nothing where it is cut, or none.
std::optional<LazChunk> layeredChunk(const LazBytesSource& source, const LazLayout& layout,
                                     std::uint64_t at) {
  const std::size_t layers =
      std::accumulate(layout.items.begin(), layout.items.end(), std::size_t{0},
                      [](std::size_t sum, const LazItem& item) { return sum + layersOf(item); });
  const std::size_t head_bytes = layout.record_bytes + 4 + 4 * layers;
  if (at > source.size || source.size - at < head_bytes) return std::nullopt;
  const std::string head = source.read(at, head_bytes);
  LazChunk chunk{.at = at, .bytes = head_bytes, .points = countAt(head, layout.record_bytes)};
  for (std::size_t i = 0; i < layers; ++i) {
    chunk.bytes += countAt(head, layout.record_bytes + 4 + 4 * i);
  }
  if (chunk.points == 0 || chunk.bytes > source.size - at) return std::nullopt;
  return chunk;
}

/// The chunk of at most so many points at `at`, by unpacking it.
std::optional<LazChunk> streamChunk(const LazBytesSource& source, const LazLayout& layout,
                                    std::uint64_t at, std::uint64_t most_points) {
  // What cannot be packed takes little more than its records.
  const std::uint64_t most_bytes = 2 * (most_points + 64) * layout.record_bytes;
  if (at >= source.size) return std::nullopt;
  const std::string bytes = source.read(at, std::min(most_bytes, source.size - at));
  LazChunk chunk{.at = at, .bytes = bytes.size()};
  try {
    const auto decoder = openLazChunk(layout, bytes, most_points);
    std::vector<char> record(layout.record_bytes);
    while (chunk.points < most_points) {
      decoder->decode(record.data(), 1);
      if (decoder->missingBytes() > 0) break;
      ++chunk.points;
    }
    if (chunk.points == most_points) chunk.bytes -= decoder->unusedBytes();
  } catch (const LazDamage&) {
    // The points before it stay.
  }
  return chunk.points > 0 ? std::optional(chunk) : std::nullopt;
}

}  // namespace

std::vector<LazChunk> findLazChunks(const LazBytesSource& source, const LazLayout& layout,
                                    std::uint64_t start, std::uint32_t chunk_points,
                                    std::uint64_t promised) {
  std::vector<LazChunk> found;
  if (!layout.layered && chunk_points == 0) return found;
  std::uint64_t at = start;
  for (std::uint64_t first = 0; first < promised;) {
    const std::uint64_t most = std::min<std::uint64_t>(chunk_points, promised - first);
    std::optional<LazChunk> chunk =
        layout.layered ? layeredChunk(source, layout, at) : streamChunk(source, layout, at, most);
    if (!chunk || chunk->points > promised - first) break;
    chunk->first = first;
    first += chunk->points;
    at += chunk->bytes;
    found.push_back(*chunk);
    if (!layout.layered && chunk->points < most) break;
  }
  return found;
}

}  // namespace relievo
