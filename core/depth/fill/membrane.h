// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"

namespace relievo {

/// More cells than this in one hole are beyond the direct solver's memory and patience.
inline constexpr std::size_t kMostMembraneCells = 120'000;
/// What it takes for each cell while it works; 2185 to 2315 were measured at 11 000 to 119 000.
inline constexpr std::size_t kMembraneCellBytes = 2400;

/// Heights beside a hole, by cell; cells that are not in it take no part.
using Rim = std::unordered_map<std::size_t, float>;

/// Cells so far from one of a hole's cells are looked at, if they lie in the grid.
inline constexpr std::array<Cell, 12> kRimReach{{{.col = -2, .row = 0},
                                                 {.col = -1, .row = 0},
                                                 {.col = 1, .row = 0},
                                                 {.col = 2, .row = 0},
                                                 {.col = 0, .row = -2},
                                                 {.col = 0, .row = -1},
                                                 {.col = 0, .row = 1},
                                                 {.col = 0, .row = 2},
                                                 {.col = -1, .row = -1},
                                                 {.col = 1, .row = -1},
                                                 {.col = -1, .row = 1},
                                                 {.col = 1, .row = 1}}};
inline constexpr int kRimRows = 2;

/// A thin plate over one hole: the heights z of its cells that make
///   sum (z_xx^2 + 2 z_xy^2 + z_yy^2)
/// least, second differences over the hole and its rim, so that the fill leaves the rim without a
/// crease and a cubic goes on through a hole as it was (biharmonic; Duchon 1977). Sparse Cholesky.
/// @param hole  indices of the hole's cells
/// @return  in their order; nothing where the rim does not determine the plate, or where the hole
///          has more than `kMostMembraneCells` cells
/// @throw Cancelled
std::vector<float> membraneOver(const std::vector<std::size_t>& hole, const Rim& rim, GridSize size,
                                const Task& task = {});

}  // namespace relievo
