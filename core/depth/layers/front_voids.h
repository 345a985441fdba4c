// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/layers/disc_raster.h"
#include "core/depth/layers/surface_discs.h"

namespace relievo {

/// Chance leaves gaps between the discs, through which the back is seen: pixels that the front
/// surrounds closely, on all eight sides, four of the points' spacings from rim to rim, or six
/// where the gap is narrower than a spacing. They become front. A narrow hollow of the object looks
/// the same from before, but there points stand on its walls: it stays.
/// @param pieces  of a raster of `size` pixels of `pixel_mm` @throw Cancelled
void closeVoids(std::vector<FrontPiece>& pieces, GridSize size, double pixel_mm,
                const std::vector<SurfaceDisc>& discs, const Task& task);

}  // namespace relievo
