// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/depth/rules/cell_points.h"
#include "core/depth/rules/point_rule.h"
#include "core/tiles/tile_store.h"

namespace relievo {

/// Cells; no rule looks farther.
inline constexpr int kRuleReach = 8;

// How many points lie in which rows, asked of what the store has: it decides how much can be worked
// on at once where points lie dense.

/// In each row of a tile, lowest first. [any thread, after the last add] @throw WriteError
std::vector<std::size_t> pointsOfRows(const TileStore& store, int tile);

/// In some rows of the map. @pre they are the map's [any thread, after the last add]
/// @throw WriteError
std::size_t pointsInRows(const TileStore& store, RowRange rows);

/// How rows may be cut apart.
struct RowCuts {
  int reach = 0;       ///< Rows around a part that it looks at.
  int step = 1;        ///< Parts end at multiples of it ...
  int first_step = 1;  ///< ... counted from here; 1 to `step`.
};

/// How a tile's rows may be cut. Rules that look around share sums between rows, so that they are
/// cut where core/depth begins them anew.
RowCuts cutsOf(const TileLayout& layout, int tile, PointRule rule);
bool looksAround(PointRule rule) noexcept;
/// A tile with kRuleReach cells around it, as far as the map goes.
CellRange withAround(const TileLayout& layout, int tile) noexcept;

/// Cuts rows into parts that look at no more than `most` points each, as few as can be; a part of
/// one step may have more. Nothing is cut where all together are no more.
std::vector<RowRange> rowsWithin(const std::vector<std::size_t>& points, const RowCuts& cuts,
                                 std::size_t most);

/// The most points that a part of one step looks at: less cannot be worked on.
std::size_t leastAtOnce(const std::vector<std::size_t>& points, const RowCuts& cuts);

/// The most points that are looked at together to choose a rule. @throw WriteError
std::size_t samplePoints(const TileStore& store);

/// What heights are made from, beside the store.
struct GriddingNeeds {
  std::size_t edge_points = 0;  ///< In the fullest three rows of tiles, near the tiles' edges.
  std::size_t around = 0;       ///< About, of these, around one tile.
  std::size_t at_once = 0;  ///< Points of a tile that are looked at together: of all its rows ...
  std::size_t least_at_once = 0;  ///< ... and of those that cannot be cut further.
  std::size_t sample_points = 0;  ///< Looked at before, if the rule asks for it.
};

/// @pre the store counts points within kRuleReach of edges
/// @param ample  tiles of no more points are not looked into: so many can be had anyway
/// @throw WriteError
GriddingNeeds griddingNeeds(const TileStore& store, PointRule rule, std::size_t ample);

}  // namespace relievo
