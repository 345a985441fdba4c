// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/colours/cell_colours.h"
#include "core/depth/depth_request.h"
#include "core/depth/layers/front_surface.h"
#include "core/depth/rules/point_rule.h"
#include "core/io/las/laz_points.h"
#include "core/tiles/points/point_source.h"
#include "core/tiles/tile_store.h"

namespace relievo {

/// Can the rule be computed from CellState alone?
bool isMergeable(PointRule rule);

/// Points that were not put into tiles, because something is before them or no surface is there;
/// counted only where there is a front.
struct LeftOut {
  std::uint64_t hidden = 0, strays = 0;
  std::uint64_t on_front = 0;  ///< The others.
};

/// Reads all points and puts each into the tile of its nearest sample; those outside the grid are
/// left out. [worker]
/// @param front  of a cloud that lies behind itself: only points on it count; null: all do
/// @throw Cancelled, FileError, WriteError
LeftOut scatterIntoTiles(const PointSource& source, const ViewFromFile& view_from_file,
                         const GridFrame& frame, TileStore& store, const Task& task,
                         const FrontSurface* front = nullptr);

/// What it does with some of the points, which stay in their order. [worker]
std::vector<TilePoint> placedPoints(const PointSource& source, const ViewFromFile& view_from_file,
                                    const GridFrame& frame, const PointRange& range, int threads,
                                    LeftOut& left_out, const FrontSurface* front);

/// The same with what the scan says of the points, for BandColours; all points, wherever they lie
/// behind each other. [worker]
/// @param view_from_file  of the finished map: z above the base plane
/// @return  how many points have which intensity, also of those outside the grid
/// @throw Cancelled, FileError, WriteError
IntensityCounts scatterValues(const ValueSource& source, const ViewFromFile& view_from_file,
                              const GridFrame& frame, ValueStore& store, const Task& task);

/// proposeRule of core/depth: the same rows of the map are looked at. Only if the store does not
/// merge. [worker] @throw Cancelled
RuleProposal proposeRule(const TileStore& store, double spacing_mm, const Task& task);

/// pointNoise of core/depth, likewise. [worker] @throw Cancelled
double pointNoise(const TileStore& store, double spacing_mm, const Task& task);

/// Rows of what the rule found; as in CapturedDepths.
struct DepthRows {
  int first_row = 0, rows = 0;
  std::vector<float> front;
  std::vector<float> between;           ///< Empty if the rule gives none.
  std::vector<std::uint8_t> steep;      ///< Empty if not known.
  std::vector<float> points;            ///< In each cell, whole numbers; empty if not known.
  std::optional<HiddenSurface> hidden;  ///< Of these rows' cells; if known.
  std::size_t outliers = 0;             ///< Points in these rows that were left out.
};

/// Adds what other cells have.
inline HiddenSurface operator+(const HiddenSurface& a, const HiddenSurface& b) {
  return {.hidden = a.hidden + b.hidden,
          .all = a.all + b.all,
          .cells = a.cells + b.cells,
          .cells_in_layers = a.cells_in_layers + b.cells_in_layers};
}

/// Depths of the whole map by a rule, tile row after tile row, lowest first: core/depth's own
/// scatterPoints on each tile with `kRuleReach` cells around it; for a store that merges, from the
/// states. [worker]
/// @throw Cancelled, WriteError
using TakeDepths = std::function<void(const DepthRows& rows)>;
/// How much is worked on at once; the depths are the same for any.
struct GriddingRoom {
  int workers = 0;  ///< 0: as many as the store's threads.
  /// Each looks at no more points of a tile than that, if rows can be cut so (RowCuts).
  std::size_t points_at_once = std::numeric_limits<std::size_t>::max();
};
/// makeDepths row of tiles after row of tiles, lowest first; rows may be left out.
class DepthMaker {
 public:
  /// @param store  stays as it is as long as this lives [worker] @throw Cancelled, WriteError
  DepthMaker(const TileStore& store, PointRule rule, double spacing_mm, const GriddingRoom& room,
             const Task& task);
  ~DepthMaker();
  DepthMaker(const DepthMaker&) = delete;
  DepthMaker& operator=(const DepthMaker&) = delete;

  /// The row's depths, until the next is asked for. [worker] @throw Cancelled, WriteError
  const DepthRows& row(int tile_row, const Task& task);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

void makeDepths(const TileStore& store, PointRule rule, double spacing_mm, const TakeDepths& take,
                const Task& task, const GriddingRoom& room = {});

}  // namespace relievo
