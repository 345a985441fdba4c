// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/rules/cell_points.h"
#include "core/tiles/cell_state.h"
#include "core/tiles/spill_file.h"
#include "core/tiles/tile_layout.h"

namespace relievo {

struct TileStoreOptions {
  /// The rule only asks for CellState, so that a full tile may forget its points.
  bool merges = false;
  std::size_t memory_bytes = std::size_t{512} << 20U;  ///< For points and states.
  std::filesystem::path spill_folder = ".";
  double sum_unit_mm = 1.0 / (1 << 20);  ///< A power of two; see sumUnit.
  int edge_cells = 8;                    ///< So near to a tile's edge points are edgePoints.
  int threads = 0;                       ///< 0: as many as there are usable cores.
};

/// The largest resolution at which `points` heights of at most `most_mm` add up without overflow.
double sumUnit(std::uint64_t points, double most_mm);

/// Points of one tile that lie in a file one after the other.
struct TileRun {
  std::uint32_t tile = 0, points = 0;
  std::uint32_t at_edge = 0;   ///< Of these, within `edge_cells` of the tile's edge.
  std::uint32_t reserved = 0;  ///< 0: the file is the same from the same points.
  std::uint64_t at = 0;        ///< Of the first.
};

/// The points of a map that is larger than memory, tile by tile: places (CellPoint), or what the
/// scan says of them (ValuePoint). A tile begins as a list of points
/// and, where the rule allows, becomes an array of states once that is smaller. Above the memory
/// budget the tiles that were not touched for longest go to one spill file, as runs that are never
/// read before the tile is asked for: nothing is written or read twice. What a tile holds at the
/// end depends on the points alone, not on order, blocks, threads or budget.
template <class Point>
class TileStoreOf {
 public:
  using Placed = TilePointOf<Point>;

  TileStoreOf(GridSize map, TileStoreOptions options);
  ~TileStoreOf();
  TileStoreOf(const TileStoreOf&) = delete;
  TileStoreOf& operator=(const TileStoreOf&) = delete;

  /// Adds some points. They cost 40 bytes each for a while. [owner] @throw WriteError
  void add(std::span<const Placed> points);

  /// Adds points that lie in a file, which stays as it is as long as this lives. [owner]
  void adopt(std::filesystem::path file, std::span<const TileRun> runs);
  /// The points by tile, for such a file; `at` counts points. [owner]
  std::vector<TileRun> sorted(std::span<const Placed> points, std::vector<Point>& out);

  const TileLayout& layout() const noexcept { return layout_; }
  double sumUnitMm() const noexcept { return options_.sum_unit_mm; }
  bool merges() const noexcept { return options_.merges; }
  int threads() const noexcept { return threads_; }
  /// How many points are best added at once.
  std::size_t pointsAtOnce() const noexcept;

  /// The state of every cell of a tile. [any thread, after the last add] @throw WriteError
  std::vector<CellState> states(int tile) const;

  /// Points of some rows of a tile, counted in the tile, CellPoints in the order of comesBefore,
  /// others in any; room is made for these alone. Only if the store does not merge. [any thread,
  /// after the last add] @throw WriteError
  std::vector<Point> points(int tile, RowRange rows) const;
  std::vector<Point> points(int tile) const;
  /// Likewise those within `edge_cells` of the tile's edge.
  std::vector<Point> edgePoints(int tile) const;

  /// Gives them piece by piece, in any order, and needs memory for one piece. Likewise.
  void forEachPiece(int tile, const std::function<void(std::span<const Point>)>& take) const;

  std::size_t pointsIn(int tile) const noexcept;
  /// Of these, the ones within `edge_cells` of the tile's edge.
  std::size_t edgePointsIn(int tile) const noexcept;

  /// Gives memory back: from now on at most `bytes` are kept, the rest goes to the spill file. To
  /// be asked after the last add. [owner] @throw WriteError
  void keepWithin(std::size_t bytes);

  std::uint64_t pointCount() const noexcept { return point_count_; }
  std::size_t residentBytes() const noexcept { return resident_bytes_; }
  std::uint64_t spilledBytes() const noexcept { return spill_.size(); }

  /// A budget below this cannot be kept: each tile keeps one block of points.
  static std::size_t leastMemoryBytes(GridSize map);

 private:
  static constexpr std::size_t kBlockPoints = 1024;
  using Block = std::array<Point, kBlockPoints>;
  /// Part of a tile in the spill file, or in one that was adopted.
  struct Run {
    std::uint64_t at = 0;
    std::uint32_t count = 0;
    bool states = false;
    std::uint32_t file = 0;  ///< Of the adopted ones, from 1; 0: the spill file.
  };
  struct Tile {
    std::vector<std::unique_ptr<Block>> blocks;
    std::size_t points = 0;         ///< In the blocks.
    std::vector<CellState> states;  ///< Empty until the tile merges.
    std::vector<Run> runs;
    std::uint64_t touched = 0;  ///< Number of the last add.
    std::size_t at_edge = 0;    ///< Of all points, runs and blocks.
  };
  struct Share {  ///< Of an add: points of one tile, contiguous after sorting.
    std::uint32_t tile = 0;
    std::span<const Placed> points;
  };

  bool isAtEdge(int tile, std::uint16_t cell) const noexcept;
  template <class Wanted>
  std::vector<Point> pointsOf(int tile, std::size_t count, const Wanted& wanted) const;
  std::vector<Share> sortByTile(std::span<const Placed> points);
  std::size_t bytesNeeded(const std::vector<Share>& shares) const;
  void makeRoom(std::size_t needed);
  void prepare(const Share& share);
  void take(const Share& share);
  /// Points `done`, `done` + 1, ... of a run.
  void readRun(const Run& run, std::size_t done, std::span<Point> points) const;
  void mergeInto(std::vector<CellState>& states, const Point& point) const;
  void mergeBlocks(const Tile& tile, std::vector<CellState>& states) const;
  void mergeRun(const Run& run, std::vector<CellState>& states) const;
  void spill(Tile& tile);
  void spillPoints(Tile& tile);
  void spillStates(Tile& tile);
  std::unique_ptr<Block> takeBlock();
  void giveBack(Tile& tile);
  std::size_t statesBytes(std::uint32_t tile) const;

  TileLayout layout_;
  TileStoreOptions options_;
  int threads_ = 1;
  double units_per_mm_ = 1;
  std::vector<Tile> tiles_;
  std::vector<std::unique_ptr<Block>> free_blocks_;
  std::vector<Placed> sorted_;
  std::vector<std::uint32_t> starts_;  ///< Per tile, for sorting.
  std::size_t resident_bytes_ = 0;
  std::uint64_t adds_ = 0;
  std::uint64_t point_count_ = 0;
  SpillFile spill_;
  std::vector<std::filesystem::path> adopted_;
};

using TileStore = TileStoreOf<CellPoint>;
using ValueStore = TileStoreOf<ValuePoint>;
extern template class TileStoreOf<CellPoint>;
extern template class TileStoreOf<ValuePoint>;

}  // namespace relievo
