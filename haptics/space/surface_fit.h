// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/space/haptic_space.h"

namespace relievo {

// When is a bend of the profile at a sample a crease, and not a part of a curve? Bends are second
// differences, slope per cell; docs/adr/0020.

/// Alone in the noise a crease is believed from this bend on: about 17 degrees, less than a hand
/// can tell in the direction of a force (18 with sight).
inline constexpr double kLeastCrease = 0.3;
/// It must differ from the mean of its neighbours' by this part of itself: waves of more than 6.4
/// samples per period are smooth whatever their height.
inline constexpr double kLeastContrast = 0.45;
/// From this bend on, 3 degrees, a crease is believed that begins after two samples without bend
/// and goes on in the lines of samples on both sides.
inline constexpr double kLeastLine = 0.05;
/// From this bend on, half a degree, a crease is believed that also goes on in the lines on both
/// sides, between straight parts that end in creases or go on for two samples.
inline constexpr double kLeastFaint = 0.01;
/// "Without bend": this part of the crease's own.
inline constexpr double kQuiet = 0.1;

/// Prepares slopes, twists, breaks and tops from the heights of `space`. [worker]
/// The spline: de Boor, "Bicubic spline interpolation", 1962, in Hermite form; along a line of
/// samples it ends with a parabola at a break and without a knot at the window's border.
void fitSurface(HapticSpace& space, SurfaceKind kind);

}  // namespace relievo
