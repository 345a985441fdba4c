// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/region/window.h"

namespace relievo {

inline constexpr double kHoverMm = 0.5;  ///< The resting hand floats this far above, mm of hand.
inline constexpr double kPressDepthMm = 2.0;  ///< First press depth, mm of hand.

/// Bilinear height of the window at a view position, view mm; constant beyond the outermost
/// samples.
double windowHeightMm(const RegionWindow& window, double x_mm, double y_mm);

/// Where a hand that is moved by mouse or keys goes: over (x, y), `depth` mm of hand below the
/// surface there if pressing, else kHoverMm of hand above it.
ViewMm handOver(const RegionWindow& window, double x_mm, double y_mm, bool pressing,
                double depth_hand_mm);

}  // namespace relievo
