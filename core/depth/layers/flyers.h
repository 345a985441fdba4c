// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/depth/rules/cell_points.h"

namespace relievo {

/// Takes flyers out of the rows: points farther than `kFlyerCells` sample distances, along the
/// view, from every other point in the 3 x 3 cells around, where these others lie together. Walls
/// and places with few points lose nothing. Points of the outermost rows are judged by half of
/// their surroundings: load one row more than needed.
/// @return flyers of the cells `counted`
std::size_t dropFlyers(RowPoints& rows, double spacing_mm, const CellRange& counted);

inline constexpr double kFlyerCells = 4;
inline constexpr int kFlyerReach = 2;

}  // namespace relievo
