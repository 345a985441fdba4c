// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/vec3.h"

namespace relievo {

/// Shares of points, in squares of the view that hold some eight points each.
struct LayerShares {
  /// In two groups over the same ground, one behind the other. Walls and steps, whose groups lie
  /// side by side, do not count.
  double layered = 0;
  double upright = 0;  ///< In others, on walls seen edge-on: they rise by six sides of the square.
  double in_patches = 0;  ///< Of the layered: half of the squares around are layered, too.
};

/// How much of an object lies behind itself, seen along -z.
/// @param points  a sample of them is enough; mm, any origin [worker]
LayerShares layerShares(const std::vector<ViewMm>& points);

inline constexpr double kLayered = 0.1;
inline constexpr double kMostlyUpright = 0.5;  ///< Layered and upright together.

/// Smaller parts that lie behind themselves: noise and edges scatter layered squares, or set them
/// along lines between others.
inline constexpr double kInPatches = 0.04;

/// Is what is seen to be found in 3-D? From any of these shares on.
bool liesInLayers(const std::vector<ViewMm>& points);

}  // namespace relievo
