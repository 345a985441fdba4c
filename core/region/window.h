// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/transform.h"
#include "core/depth/depth_map.h"
#include "core/pyramid/pyramid.h"
#include "core/region/region.h"
#include "core/region/region_window.h"

namespace relievo {

/// Bilinear between the nodes of the region's level, clamped within the map; beyond the map
/// height 0 and origin outside. [any thread]
/// @throw ArgumentError  no such level, side not > 0, or gain not finite and > 0
RegionWindow sampleWindow(const DepthMap& map, const Pyramid& pyramid, const Region& region,
                          double gain = 1);

/// What a window is cut from, wherever its rows are: a level in memory, or tiles of a file.
struct WindowRows {
  GridFrame map;    ///< Level 0: says where the map ends.
  GridFrame nodes;  ///< The region's level.
  GridFrame cells;  ///< Of the origins; covers the map.
  int levels = 1;
  /// Heights of the level's nodes first_col ... first_col + count - 1 of a row; valid until the
  /// call after the next.
  std::function<const float*(int row, int first_col, int count)> heights;
  /// Likewise the origins of cells.
  std::function<const CellStatus*(int row, int first_col, int count)> origins;
};
/// The same from there. [as the two functions] @throw ArgumentError  as above, but for the level
RegionWindow sampleWindow(const WindowRows& rows, const Region& region, double gain = 1);

/// The window as a grid of its own, in view mm: for drawing and for files.
/// @param ring  1 adds one ring of samples that continue the border's heights, so that a drawn
///              surface covers the whole region and not only up to its outermost samples
DepthMap windowMap(const RegionWindow& window, int ring = 0);

/// How a window lies in the hand's workspace: one scale for x, y and z.
struct HandMapping {
  double device_per_view = 1;  ///< 1 mm on the object is this many mm of hand.
  DeviceFromView device_from_view;

  /// "1 mm of hand = s mm on the object".
  double objectMmPerHandMm() const noexcept { return 1 / device_per_view; }
};

inline constexpr double kHandWidthMm =
    80;  ///< A window's side fills this much of the hand's space.
inline constexpr double kHandHeightMm = 60;  ///< Its heights at most this much.

/// Scale 80/side, or 60/(max - min) if smaller; the window's centre at mid height maps to the
/// device origin.
HandMapping handMapping(const RegionWindow& window);

}  // namespace relievo
