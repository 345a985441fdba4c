// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tile_store.h"

#include <malloc.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

#include "core/base/bands.h"
#include "core/base/threads.h"
#include "core/tiles/job/job_folder.h"

namespace relievo {
namespace {

constexpr double kSpillDownTo = 0.75;            // Of the budget: many tiles at once, in long runs.
constexpr std::size_t kPiecePoints = 1U << 16U;  // Of a tile, that are in memory once more.

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

/// State of one cell in the spill file.
struct StoredState {
  CellState state;
  std::uint16_t cell = 0;
};

}  // namespace

double sumUnit(std::uint64_t points, double most_mm) {
  constexpr int kFinest = -30;  // 1 nm / 1000; finer than any float height.
  const double most = std::max(static_cast<double>(points) * most_mm, 1e-300);
  // Half a bit of rounding per point needs no more than one bit in all.
  const int exponent = static_cast<int>(std::ceil(std::log2(most))) - 61;
  return std::ldexp(1.0, std::max(exponent, kFinest));
}

template <class Point>
TileStoreOf<Point>::TileStoreOf(GridSize map, TileStoreOptions options)
    : layout_{map},
      options_(std::move(options)),
      units_per_mm_(1 / options_.sum_unit_mm),
      tiles_(static_cast<std::size_t>(layout_.count())),
      starts_(tiles_.size() + 1),
      spill_(options_.spill_folder) {
  threads_ = threadCount(options_.threads);
}

template <class Point>
TileStoreOf<Point>::~TileStoreOf() = default;

template <class Point>
std::size_t TileStoreOf<Point>::leastMemoryBytes(GridSize map) {
  return 2 * static_cast<std::size_t>(TileLayout{map}.count()) * (sizeof(Block) + sizeof(Tile));
}

template <class Point>
std::size_t TileStoreOf<Point>::pointsAtOnce() const noexcept {
  constexpr std::size_t kBytesAPoint = 40;  // As read, and sorted.
  return std::clamp<std::size_t>(options_.memory_bytes / 8 / kBytesAPoint, 1024, 1U << 20U);
}

template <class Point>
std::size_t TileStoreOf<Point>::statesBytes(std::uint32_t tile) const {
  return layout_.sizeOf(static_cast<int>(tile)).count() * sizeof(CellState);
}

template <class Point>
void TileStoreOf<Point>::add(std::span<const Placed> points) {
  if (points.empty()) return;
  ++adds_;
  point_count_ += points.size();
  const std::vector<Share> shares = sortByTile(points);
  const std::size_t needed = bytesNeeded(shares);
  if (resident_bytes_ + needed > options_.memory_bytes) makeRoom(needed);
  for (const Share& share : shares) prepare(share);
  // Each tile belongs to one thread, so that none waits for another.
  parallelFor(static_cast<int>(shares.size()), threads_, [&](int first, int end) {
    for (int i = first; i < end; ++i) take(shares[static_cast<std::size_t>(i)]);
  });
  for (const Share& share : shares) {
    Tile& tile = tiles_[share.tile];
    if (!tile.states.empty() && !tile.blocks.empty()) giveBack(tile);
  }
}

template <class Point>
void TileStoreOf<Point>::adopt(std::filesystem::path file, std::span<const TileRun> runs) {
  adopted_.push_back(std::move(file));
  const auto number = static_cast<std::uint32_t>(adopted_.size());
  for (const TileRun& run : runs) {
    Tile& tile = tiles_[run.tile];
    tile.runs.push_back({.at = run.at, .count = run.points, .states = false, .file = number});
    tile.at_edge += run.at_edge;
    point_count_ += run.points;
  }
}

template <class Point>
std::vector<TileRun> TileStoreOf<Point>::sorted(std::span<const Placed> points,
                                                std::vector<Point>& out) {
  std::vector<TileRun> runs;
  out.clear();
  out.reserve(points.size());
  for (const Share& share : sortByTile(points)) {
    TileRun run{.tile = share.tile,
                .points = static_cast<std::uint32_t>(share.points.size()),
                .at = out.size()};
    for (const Placed& point : share.points) {
      out.push_back(point.point);
      run.at_edge += isAtEdge(static_cast<int>(share.tile), point.point.cell) ? 1U : 0U;
    }
    runs.push_back(run);
  }
  return runs;
}

template <class Point>
void TileStoreOf<Point>::readRun(const Run& run, std::size_t done, std::span<Point> points) const {
  const std::uint64_t at = run.at + done * sizeof(Point);
  if (run.file == 0) {
    spill_.read(at, std::as_writable_bytes(points));
  } else {
    readPart(adopted_[run.file - 1], at, std::as_writable_bytes(points));
  }
}

template <class Point>
std::vector<typename TileStoreOf<Point>::Share> TileStoreOf<Point>::sortByTile(
    std::span<const Placed> points) {
  std::fill(starts_.begin(), starts_.end(), 0);
  for (const Placed& point : points) ++starts_[point.tile + 1];
  std::vector<Share> shares;
  sorted_.resize(points.size());
  for (std::uint32_t tile = 0; tile < tiles_.size(); ++tile) {
    const std::uint32_t count = starts_[tile + 1];
    starts_[tile + 1] += starts_[tile];
    if (count > 0) {
      shares.push_back({.tile = tile, .points = {sorted_.data() + starts_[tile], count}});
    }
  }
  std::vector<std::uint32_t> next = starts_;
  for (const Placed& point : points) sorted_[next[point.tile]++] = point;
  return shares;
}

template <class Point>
std::size_t TileStoreOf<Point>::bytesNeeded(const std::vector<Share>& shares) const {
  std::size_t bytes = 0;
  for (const Share& share : shares) {
    const Tile& tile = tiles_[share.tile];
    if (!tile.states.empty()) continue;
    const std::size_t blocks = (share.points.size() + kBlockPoints - 1) / kBlockPoints;
    const std::size_t as_points = blocks * sizeof(Block);
    bytes += options_.merges ? std::min(as_points, statesBytes(share.tile)) : as_points;
  }
  return bytes;
}

template <class Point>
void TileStoreOf<Point>::makeRoom(std::size_t needed) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i].points > 0 || !tiles_[i].states.empty()) order.push_back(i);
  }
  const auto bytes = [&](std::uint32_t i) {
    return tiles_[i].states.empty() ? tiles_[i].blocks.size() * sizeof(Block) : statesBytes(i);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (tiles_[a].touched != tiles_[b].touched) return tiles_[a].touched < tiles_[b].touched;
    return bytes(a) != bytes(b) ? bytes(a) > bytes(b) : a < b;
  });
  const auto target =
      static_cast<std::size_t>(kSpillDownTo * static_cast<double>(options_.memory_bytes));
  for (const std::uint32_t i : order) {
    if (resident_bytes_ + needed <= target) break;
    spill(tiles_[i]);
  }
}

template <class Point>
std::size_t TileStoreOf<Point>::pointsIn(int tile_number) const noexcept {
  const Tile& tile = tiles_[static_cast<std::size_t>(tile_number)];
  std::size_t points = tile.points;
  for (const Run& run : tile.runs) points += run.states ? 0 : run.count;
  return points;
}

template <class Point>
std::size_t TileStoreOf<Point>::edgePointsIn(int tile) const noexcept {
  return tiles_[static_cast<std::size_t>(tile)].at_edge;
}

template <class Point>
bool TileStoreOf<Point>::isAtEdge(int tile, std::uint16_t cell) const noexcept {
  return layout_.isAtEdge(tile, cell, options_.edge_cells);
}

template <class Point>
void TileStoreOf<Point>::keepWithin(std::size_t bytes) {
  options_.memory_bytes = std::min(options_.memory_bytes, bytes);
  if (resident_bytes_ > options_.memory_bytes) makeRoom(0);
  std::vector<std::unique_ptr<Block>>().swap(free_blocks_);
  std::vector<Placed>().swap(sorted_);
  ::malloc_trim(0);  // Blocks are small, so that the C library would keep them.
}

template <class Point>
std::unique_ptr<typename TileStoreOf<Point>::Block> TileStoreOf<Point>::takeBlock() {
  resident_bytes_ += sizeof(Block);
  if (free_blocks_.empty()) return std::make_unique<Block>();
  std::unique_ptr<Block> block = std::move(free_blocks_.back());
  free_blocks_.pop_back();
  return block;
}

template <class Point>
void TileStoreOf<Point>::giveBack(Tile& tile) {
  resident_bytes_ -= tile.blocks.size() * sizeof(Block);
  const std::size_t most_spare = options_.memory_bytes / 16 / sizeof(Block);
  for (std::unique_ptr<Block>& block : tile.blocks) {
    if (free_blocks_.size() < most_spare) free_blocks_.push_back(std::move(block));
  }
  tile.blocks.clear();
  tile.points = 0;
}

/// Room for the share's points, so that `take` allocates nothing.
template <class Point>
void TileStoreOf<Point>::prepare(const Share& share) {
  Tile& tile = tiles_[share.tile];
  tile.touched = adds_;
  if (!tile.states.empty()) return;
  const std::size_t points = tile.points + share.points.size();
  const std::size_t blocks = (points + kBlockPoints - 1) / kBlockPoints;
  if (options_.merges && blocks * sizeof(Block) > statesBytes(share.tile)) {
    tile.states.resize(layout_.sizeOf(static_cast<int>(share.tile)).count());
    resident_bytes_ += statesBytes(share.tile);
    return;
  }
  while (tile.blocks.size() < blocks) tile.blocks.push_back(takeBlock());
}

template <class Point>
void TileStoreOf<Point>::mergeInto(std::vector<CellState>& states, const Point& p) const {
  states[p.cell].add(p.z, std::llround(static_cast<double>(p.z) * units_per_mm_));
}

template <class Point>
void TileStoreOf<Point>::mergeBlocks(const Tile& tile, std::vector<CellState>& states) const {
  for (std::size_t i = 0; i < tile.points; ++i) {
    mergeInto(states, (*tile.blocks[i / kBlockPoints])[i % kBlockPoints]);
  }
}

template <class Point>
void TileStoreOf<Point>::take(const Share& share) {
  Tile& tile = tiles_[share.tile];
  if (!tile.states.empty()) {
    mergeBlocks(tile, tile.states);  // None, but when the tile begins to merge.
    for (const Placed& point : share.points) mergeInto(tile.states, point.point);
    return;
  }
  for (const Placed& point : share.points) {
    (*tile.blocks[tile.points / kBlockPoints])[tile.points % kBlockPoints] = point.point;
    ++tile.points;
  }
  if constexpr (!std::is_same_v<Point, CellPoint>) return;  // Nobody asks for their edges.
  for (const Placed& point : share.points) {
    tile.at_edge += isAtEdge(static_cast<int>(share.tile), point.point.cell) ? 1 : 0;
  }
}

template <class Point>
void TileStoreOf<Point>::spill(Tile& tile) {
  if (!tile.states.empty()) spillStates(tile);
  if (tile.points > 0) spillPoints(tile);
  giveBack(tile);
}

template <class Point>
void TileStoreOf<Point>::spillPoints(Tile& tile) {
  Run run{.at = spill_.size(), .count = static_cast<std::uint32_t>(tile.points), .states = false};
  std::vector<Point> points;  // A piece: the whole tile may be much of the budget.
  points.reserve(std::min(tile.points, kPiecePoints));
  for (std::size_t i = 0; i < tile.points; ++i) {
    points.push_back((*tile.blocks[i / kBlockPoints])[i % kBlockPoints]);
    if (points.size() < kPiecePoints && i + 1 < tile.points) continue;
    spill_.append(bytesOf(points));
    points.clear();
  }
  tile.runs.push_back(run);
}

template <class Point>
void TileStoreOf<Point>::spillStates(Tile& tile) {
  std::vector<StoredState> stored;
  for (std::size_t cell = 0; cell < tile.states.size(); ++cell) {
    if (tile.states[cell].count == 0) continue;
    stored.push_back({.state = tile.states[cell], .cell = static_cast<std::uint16_t>(cell)});
  }
  tile.runs.push_back({.at = spill_.append(bytesOf(stored)),
                       .count = static_cast<std::uint32_t>(stored.size()),
                       .states = true});
  resident_bytes_ -= tile.states.size() * sizeof(CellState);
  std::vector<CellState>().swap(tile.states);
}

template <class Point>
void TileStoreOf<Point>::mergeRun(const Run& run, std::vector<CellState>& states) const {
  if (run.states) {
    std::vector<StoredState> stored(run.count);
    spill_.read(run.at, std::as_writable_bytes(std::span(stored)));
    for (const StoredState& s : stored) states[s.cell].merge(s.state);
  } else {
    std::vector<Point> stored;
    for (std::size_t done = 0; done < run.count; done += stored.size()) {
      stored.resize(std::min(run.count - done, kPiecePoints));
      readRun(run, done, stored);
      for (const Point& p : stored) mergeInto(states, p);
    }
  }
}

template <class Point>
std::vector<CellState> TileStoreOf<Point>::states(int tile_number) const {
  const Tile& tile = tiles_[static_cast<std::size_t>(tile_number)];
  std::vector<CellState> states = tile.states;
  states.resize(layout_.sizeOf(tile_number).count());
  mergeBlocks(tile, states);
  for (const Run& run : tile.runs) mergeRun(run, states);
  return states;
}

template <class Point>
void TileStoreOf<Point>::forEachPiece(
    int tile_number, const std::function<void(std::span<const Point>)>& take) const {
  assert(!options_.merges);
  const Tile& tile = tiles_[static_cast<std::size_t>(tile_number)];
  std::vector<Point> piece;
  for (const Run& run : tile.runs) {
    for (std::size_t done = 0; done < run.count; done += piece.size()) {
      piece.resize(std::min(run.count - done, kPiecePoints));
      readRun(run, done, piece);
      take(piece);
    }
  }
  for (std::size_t i = 0; i < tile.points; i += kBlockPoints) {
    take(std::span(*tile.blocks[i / kBlockPoints]).first(std::min(tile.points - i, kBlockPoints)));
  }
}

template <class Point>
template <class Wanted>
std::vector<Point> TileStoreOf<Point>::pointsOf(int tile, std::size_t count,
                                                const Wanted& wanted) const {
  std::vector<Point> points;
  points.reserve(count);  // Grown step by step it would take up to twice the room.
  forEachPiece(tile, [&](std::span<const Point> piece) {
    for (const Point& p : piece) {
      if (wanted(p.cell)) points.push_back(p);
    }
  });
  if constexpr (std::is_same_v<Point, CellPoint>) {
    std::sort(points.begin(), points.end(),
              [](const Point& a, const Point& b) { return comesBefore(a, b); });
  }
  return points;
}

template <class Point>
std::vector<Point> TileStoreOf<Point>::points(int tile) const {
  return pointsOf(tile, pointsIn(tile), [](std::uint16_t) { return true; });
}

template <class Point>
std::vector<Point> TileStoreOf<Point>::points(int tile, RowRange rows) const {
  const GridSize size = layout_.sizeOf(tile);
  const int first = std::max(rows.first, 0), end = std::min(rows.end, size.rows);
  if (first == 0 && end == size.rows) return points(tile);
  const auto low = static_cast<unsigned>(first * size.cols);
  const auto cells = static_cast<unsigned>(std::max(end - first, 0) * size.cols);
  const auto is_wanted = [low, cells](std::uint16_t cell) { return cell - low < cells; };
  std::size_t count = 0;
  forEachPiece(tile, [&](std::span<const Point> piece) {
    for (const Point& p : piece) count += is_wanted(p.cell) ? 1 : 0;
  });
  return pointsOf(tile, count, is_wanted);
}

template <class Point>
std::vector<Point> TileStoreOf<Point>::edgePoints(int tile) const {
  return pointsOf(tile, edgePointsIn(tile),
                  [this, tile](std::uint16_t cell) { return isAtEdge(tile, cell); });
}

template class TileStoreOf<CellPoint>;
template class TileStoreOf<ValuePoint>;

}  // namespace relievo
