// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/fill/mask.h"

namespace relievo {

/// More cells than this in one hole are beyond the direct solver's memory and patience.
inline constexpr std::size_t kMostMembraneCells = 120'000;

/// Lays a thin plate over one hole: the heights z of its cells that make
///   sum (z_xx^2 + 2 z_xy^2 + z_yy^2)
/// least, second differences over the hole and its rim, so that the fill leaves the rim without a
/// crease and a cubic goes on through a hole as it was (biharmonic; Duchon 1977). Sparse Cholesky.
/// @param known  1: the cell's value counts as rim; cells neither in the hole nor known take no
/// part
/// @param hole  indices of the hole's cells
/// @return false, and nothing changed: the rim does not determine the plate, or the hole has more
///         than `kMostMembraneCells` cells
/// @throw Cancelled
bool fillWithMembrane(std::vector<float>& values, const Mask& known,
                      const std::vector<std::size_t>& hole, GridSize size, const Task& task = {});

}  // namespace relievo
