// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/fill/grid_rows.h"

namespace relievo {

/// One byte per cell, 0 or 1; row-major. Bytes, not bits: the loops below run at memory speed.
using Mask = std::vector<std::uint8_t>;

/// Morphological closing with a square of 2 radius + 1 cells; cost independent of the radius.
/// What lies beyond the grid neither fills nor erodes.
/// @param threads  as threadsFor wants them
Mask closed(const Mask& mask, GridSize size, int radius, int threads = 0);

/// Smallest closing radius that closes the gaps the data's own spacing leaves: from the share of
/// occupied cells in the sparser parts of the covered area, points taken as scattered at random
/// (a square of (2r+1)^2 cells is empty by chance with probability exp(-density (2r+1)^2)).
/// Points on a regular grid with a point in every cell need none: 0.
int samplingGapRadius(const BitRows& measured);
/// @param shares  of measured cells in the squares that hold any
int samplingGapRadius(std::vector<double> shares, GridSize size);

}  // namespace relievo
