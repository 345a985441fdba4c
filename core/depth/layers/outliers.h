// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/depth/rules/cell_points.h"

namespace relievo {

/// Takes outliers out of the rows: points farther than `kOutlierCells` sample distances, along the
/// view, from every other point in the 3 x 3 cells around, where these others lie together. Walls
/// and places with few points lose nothing. Points of the outermost rows are judged by half of
/// their surroundings: load one row more than needed.
/// @return outliers of the cells `counted`
std::size_t dropOutliers(RowPoints& rows, double spacing_mm, const CellRange& counted);

inline constexpr double kOutlierCells = 4;
inline constexpr int kOutlierReach = 2;

}  // namespace relievo
