// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/grid.h"

namespace relievo {

/// One byte per cell, 0 or 1; row-major. Bytes, not bits: the loops below run at memory speed.
using Mask = std::vector<std::uint8_t>;

/// Morphological closing with a square of 2 radius + 1 cells; cost independent of the radius.
/// What lies beyond the grid neither fills nor erodes.
Mask closed(const Mask& mask, GridSize size, int radius);

/// Smallest closing radius that closes the gaps the data's own spacing leaves: from the share of
/// occupied cells in the sparser parts of the covered area, points taken as scattered at random
/// (a square of (2r+1)^2 cells is empty by chance with probability exp(-density (2r+1)^2)).
/// Points on a regular grid with a point in every cell need none: 0.
int samplingGapRadius(const Mask& measured, GridSize size);

/// The two halves of it, for maps whose mask is never in memory as a whole. Side of the squares
/// whose occupancy is looked at; 0 if nothing is measured.
int occupancySide(std::size_t measured_cells, GridSize size);
/// @param shares  of measured cells in the squares that hold any; squares begin at cell (0, 0), and
///                those that reach over the grid do not count
int samplingGapRadius(std::vector<double> shares, GridSize size);

/// 4-connected components of the cells where `mask` is 0.
struct EmptyAreas {
  std::vector<int> label;          ///< Per cell: index into the lists below, -1 where mask is 1.
  std::vector<std::size_t> cells;  ///< Size of each component.
  std::vector<bool> at_border;     ///< Touches the border of the grid: outside the object.
};
EmptyAreas emptyAreas(const Mask& mask, GridSize size);

}  // namespace relievo
