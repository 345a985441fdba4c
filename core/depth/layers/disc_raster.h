// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/layers/surface_discs.h"

namespace relievo {

/// What is in front at a pixel of the raster.
struct FrontPiece {
  float z;          ///< NaN without a surface.
  float tolerance;  ///< What lies no farther off along z is the same surface.
  float spacing;    ///< Of the points there.
};

/// Where discs are drawn: `size` pixels, the first one's corner at 0, 0.
struct DiscRaster {
  GridSize size;
  double pixel_mm = 1;
};

/// Discs that lie behind others wherever they are seen change nothing.
enum class HiddenDiscs {
  skipped,  ///< Most of them, by tiles of pixels: of a closed cloud more than half.
  drawn,    ///< As an oracle: the same bytes, later.
};

/// What is in front of all discs at each pixel: of pieces as near to the foremost as its tolerance
/// lets them be the same surface, and no farther than a spacing along the view, the mean. Before a
/// back that lies far behind, a disc reaches half a spacing farther: chance leaves gaps between an
/// edge and the last points before it. Of pieces equally high the first disc's tolerance counts. On
/// all cores, the same bytes for any number of them. [worker] @throw Cancelled
std::vector<FrontPiece> drawDiscs(const std::vector<SurfaceDisc>& discs, const DiscRaster& raster,
                                  HiddenDiscs hidden, const Task& task);

}  // namespace relievo
