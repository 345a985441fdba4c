// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/mask.h"

namespace relievo {

/// Gives every cell where `known` is 0 a smooth value from the known cells around it, by averaging
/// upward through coarser grids and interpolating back down (push-pull; Gortler et al. 1996,
/// "The Lumigraph", sec. 3.5). Known cells keep their value. Values of unknown cells are ignored.
/// @throw Cancelled
void pushPull(std::vector<float>& values, const Mask& known, GridSize size, const Task& task = {});

}  // namespace relievo
