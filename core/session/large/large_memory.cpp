// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/large_memory.h"

#include <algorithm>
#include <string>

#include "core/base/failure.h"
#include "core/base/threads.h"
#include "core/tiles/colours/band_colours.h"
#include "core/tiles/tile_layout.h"
#include "core/tiles/tile_store.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMegabyte = 1'000'000;
constexpr std::uint64_t kProgram = 80 * kMegabyte;  ///< Code, libraries, GDAL's blocks of tiles.

/// Bands of one row of tiles while gaps are filled: depths, layers and masks of each thread.
std::uint64_t bandBytes(GridSize size, int threads) {
  constexpr std::uint64_t kBytesPerCell = 40;
  constexpr std::uint64_t kRows = kTileSide + 32;
  return kBytesPerCell * kRows * static_cast<std::uint64_t>(size.cols) *
         static_cast<std::uint64_t>(threads);
}

/// Rows of tiles of every level that are being written, and one bit and a 64th of push-pull per
/// cell.
std::uint64_t writingBytes(GridSize size) {
  return 2 * 6 * static_cast<std::uint64_t>(kTileSide) * static_cast<std::uint64_t>(size.cols) +
         size.count() / 2;
}

std::uint64_t megabytes(std::uint64_t bytes) {
  return (bytes + kMegabyte - 1) / kMegabyte;
}

}  // namespace

namespace {

[[noreturn]] void refuse(const GridFrame& frame, const LargeMapOptions& large,
                         std::uint64_t needed) {
  throw failure<MessageId::tiles_need_memory>(frame.size.cols, frame.size.rows, megabytes(needed),
                                              megabytes(large.memory_bytes));
}

}  // namespace

MemoryPlan planMemory(const GridFrame& frame, const LargeMapOptions& large,
                      const std::function<std::uint64_t(int threads)>& held_bytes) {
  // While points are sorted into tiles: the store and a block of points being sorted; while cells
  // get their heights: the store and three rows of tiles, which hold what the store let go of.
  const std::uint64_t gridding = 2 * TileStore::leastMemoryBytes(frame.size) + 64 * kMegabyte;
  const auto held = [&](int threads) { return kProgram + (held_bytes ? held_bytes(threads) : 0); };
  const auto filling = [&](int threads) {
    return bandBytes(frame.size, threads) + writingBytes(frame.size);
  };
  const auto needed = [&](int threads) {
    return held(threads) + std::max(filling(threads), gridding);
  };
  int threads = threadCount(large.threads);
  if (large.threads == 0) {
    while (threads > 1 && needed(threads) > large.memory_bytes) --threads;
  }
  if (needed(threads) > large.memory_bytes) refuse(frame, large, needed(threads));
  const std::uint64_t free_bytes = large.memory_bytes - held(threads);
  // While gaps are filled, depths may take 0.4 of what filling leaves; so may colours.
  const std::uint64_t making = BandColours::memoryBytes(frame.size, threads);
  const std::uint64_t colours = making + ValueStore::leastMemoryBytes(frame.size) + 8 * kMegabyte;
  const std::uint64_t room = (free_bytes - filling(threads)) * 5 / 10;
  return {.threads = threads,
          .held_bytes = held(threads),
          .points_bytes = static_cast<std::size_t>((free_bytes - 64 * kMegabyte) * 6 / 10),
          .gridding_bytes = static_cast<std::size_t>(free_bytes),
          .depths_bytes = static_cast<std::size_t>((free_bytes - filling(threads)) * 8 / 10),
          .values_bytes = room >= colours ? static_cast<std::size_t>(room - making) * 8 / 10 : 0,
          .colours_need = held(threads) + filling(threads) + 2 * colours};
}

std::uint64_t diskBytes(const std::vector<GridFrame>& frames, std::optional<std::uint64_t> points,
                        const MemoryPlan& plan) {
  constexpr std::uint64_t kCell = sizeof(float) + 1;  // Height and origin.
  constexpr std::uint64_t kPoint = sizeof(CellPoint);
  std::uint64_t bytes = 0;
  for (const GridFrame& frame : frames) bytes += kCell * frame.size.count();
  if (!points) return bytes;
  const std::uint64_t in_tiles = kPoint * *points;
  return bytes + sizeof(float) * frames.front().size.count() + in_tiles -
         std::min<std::uint64_t>(in_tiles, plan.points_bytes);
}

void requireDisk(const GridFrame& frame, const std::filesystem::path& folder, std::uint64_t needed,
                 std::optional<std::uint64_t> free_bytes) {
  if (!free_bytes || needed <= *free_bytes) return;
  throw failure<MessageId::disk_needed>(frame.size.cols, frame.size.rows, megabytes(needed), folder,
                                        megabytes(*free_bytes));
}

namespace {

// Of 16 bytes a point in a tile the rules make places, order and neighbours: thrice as much
// (measured: 2.7).
constexpr std::uint64_t kWorkBytes = 3 * sizeof(CellPoint);
// What a tile's cells take beside their points: depths, counts, spreads, places of rows.
constexpr std::uint64_t kTileBytes = 4 * kMegabyte;

}  // namespace

std::size_t amplePoints(const MemoryPlan& plan) noexcept {
  return plan.gridding_bytes / 4 / static_cast<std::uint64_t>(plan.threads) / kWorkBytes;
}

std::size_t samplingBytes(const MemoryPlan& plan, const GridFrame& frame,
                          const LargeMapOptions& large, std::size_t points) {
  const std::uint64_t work = kWorkBytes * points;
  const std::uint64_t least = TileStore::leastMemoryBytes(frame.size);
  if (work + least > plan.gridding_bytes) refuse(frame, large, plan.held_bytes + work + least);
  return static_cast<std::size_t>(plan.gridding_bytes - work);
}

GriddingMemory griddingMemory(const MemoryPlan& plan, const GridFrame& frame,
                              const LargeMapOptions& large, const GriddingNeeds& needs) {
  const std::uint64_t least = TileStore::leastMemoryBytes(frame.size);
  // A row of tiles with its heights, once more while it is kept or completed; steep cells, a bit
  // each.
  constexpr std::uint64_t kRowBytes = 26;
  const std::uint64_t edges = sizeof(CellPoint) * needs.edge_points + frame.size.count() / 8 +
                              kRowBytes * kTileSide * static_cast<std::uint64_t>(frame.size.cols);
  const auto needed = [&](int workers, std::size_t at_once) {
    return edges + static_cast<std::uint64_t>(workers) *
                       (kTileBytes + kWorkBytes * (at_once + needs.around));
  };
  const std::uint64_t sampling = kWorkBytes * needs.sample_points;
  const auto fits = [&](int workers, std::size_t at_once) {
    return std::max(needed(workers, at_once), sampling) + least <= plan.gridding_bytes;
  };
  // Every part of a tile reads through the whole of it, so that fewer threads are better than more
  // than some parts.
  constexpr std::size_t kFewParts = 6;
  const std::size_t wanted = std::max(needs.least_at_once, needs.at_once / kFewParts);
  int workers = plan.threads;
  while (workers > 1 && !fits(workers, wanted)) --workers;
  const std::size_t least_here = fits(workers, wanted) ? wanted : needs.least_at_once;
  if (!fits(workers, least_here)) {
    const std::uint64_t work = std::max(needed(workers, least_here), sampling);
    refuse(frame, large, plan.held_bytes + work + least);
  }
  // As much more as there is room for, but for what the store has use for.
  const std::uint64_t room =
      plan.gridding_bytes - (least_here < wanted ? least : plan.gridding_bytes / 4);
  std::size_t at_once = least_here;
  if (needed(workers, at_once) < room) {
    const std::uint64_t left = (room - needed(workers, at_once)) / kWorkBytes;
    at_once += static_cast<std::size_t>(left / static_cast<unsigned>(workers));
  }
  at_once = std::max(std::min(at_once, needs.at_once), least_here);
  const std::uint64_t work = std::max(needed(workers, at_once), sampling);
  return {.store_bytes = static_cast<std::size_t>(plan.gridding_bytes - work),
          .room = {.workers = workers, .points_at_once = at_once}};
}

}  // namespace relievo
