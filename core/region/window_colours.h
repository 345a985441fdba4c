// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/depth/colours/colours.h"
#include "core/depth/colours/stored_colours.h"
#include "core/region/window.h"

namespace relievo {

/// Where the colours of a level's nodes are had, row by row: in memory or in tiles. Each gives the
/// `count` nodes of a row from `first_col` on, valid until its next call; null: there are none.
struct ColourNodes {
  std::function<const Rgba*(int row, int first_col, int count)> colours;
  std::function<const GreyAlpha*(int row, int first_col, int count)> intensities;
};

/// Nodes of a level in memory, which must outlive them. One thread at a time.
ColourNodes nodesOf(const StoredColours& level, GridSize size);

/// Colours of a window's 200 x 200 samples: between the nodes of its level as its heights are, in
/// linear light weighted by alpha; none where the nearest cell is a
/// hole, and beyond the object but for the samples beside it. Apart
/// from RegionWindow, which stays small for the loop. [any thread]
/// @param nodes  frame of the window's level, @param level  its colours
/// @param ring  as windowMap: rings of samples more that continue the border
/// @return  empty if the level has none
GridColours windowColours(const ColourNodes& level, const GridFrame& nodes,
                          const RegionWindow& window, int ring = 0);

}  // namespace relievo
