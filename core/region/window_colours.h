// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/depth/colours.h"
#include "core/region/window.h"

namespace relievo {

/// Colours of a window's 200 x 200 samples: between the nodes of its level as its heights are, in
/// linear light weighted by alpha; none where the nearest cell is a
/// hole, and beyond the object but for the samples beside it. Apart
/// from RegionWindow, which stays small for the loop. [any thread]
/// @param levels  of colourLevels
/// @param nodes  frame of the window's level
/// @param ring  as windowMap: rings of samples more that continue the border
/// @return  empty if `levels` is
GridColours windowColours(const std::vector<GridColours>& levels, const GridFrame& nodes,
                          const RegionWindow& window, int ring = 0);

}  // namespace relievo
