// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/depth_request.h"

namespace relievo {

/// A sparse cloud of a closed object shows its back through the gaps of its front. Empties the
/// cells that lie more than `kSeeThroughCells` sample distances below most of the measured cells
/// around them; straight walls, slopes and outlines have at most half of their neighbours that much
/// higher and stay. To be used only where the data leave sampling gaps.
/// @param radius  of the neighbourhood, cells, >= 1
/// @return cells emptied @throw Cancelled
std::size_t dropSeenThrough(FrontDepths& depths, const GridFrame& frame, int radius,
                            const Task& task = {});

inline constexpr double kSeeThroughCells = 4;

}  // namespace relievo
