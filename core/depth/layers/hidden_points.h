// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/depth_request.h"

namespace relievo {

/// A sparse cloud of a closed object shows its back through the gaps of its front. Empties the
/// cells that lie more than `kSeeThroughCells` sample distances below cells around them (the front)
/// if the area around without any front is no larger than a sampling gap can be by chance: neither
/// connected over more cells, nor a square of more cells, than chance leaves empty where the cloud
/// is as dense as it is there. Grooves, holes and the feet of walls are larger and stay. Where less
/// than 55 % of the cells are measured chance leaves areas of any size; there the cells are emptied
/// that lie so far below most of the measured cells around them.
/// Cells with a clear way of `kGapReach` cells in three of eight directions are never emptied.
/// To be used only where the data leave sampling gaps. Looks `seeThroughReach` cells around.
/// @param radius  of the neighbourhood that counts in sparse parts, cells, >= 1
/// @param threads  as threadsFor wants them
/// @return cells emptied @throw Cancelled
std::size_t dropSeenThrough(FrontDepths& depths, const GridFrame& frame, int radius,
                            const Task& task = {}, int threads = 0);

inline constexpr double kSeeThroughCells = 4;
inline constexpr int kSeeThroughPasses = 2;
inline constexpr int kGapReach = 16;
/// Of the neighbours of a cell at kGapReach, too, is asked what they are.
inline constexpr int seeThroughReach(int radius) {
  return kSeeThroughPasses * (radius > kGapReach + 1 ? radius : kGapReach + 1);
}

}  // namespace relievo
