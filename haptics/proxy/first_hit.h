// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/proxy/surface.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

struct Hit {
  bool found = false;
  GridPoint point;  ///< On the surface if found, else the segment's end.
};

/// How a ray finds its way; the result is the same to the last bit.
enum class RayWalk : std::uint8_t { cells, blocks };

/// Where a segment that starts on or above the surface first goes below it; exact up to rounding.
/// A start on the surface with a direction that leads away from it is not a hit. At most 404 cells
/// are visited, whatever the length; beyond a few cells whole blocks that lie below the segment are
/// passed in one step.
Hit firstHit(const BilinearSurface& surface, GridPoint from, GridPoint to,
             RayWalk walk = RayWalk::blocks) RELIEVO_REALTIME;
Hit firstHit(const SplineSurface& surface, GridPoint from, GridPoint to,
             RayWalk walk = RayWalk::blocks) RELIEVO_REALTIME;
Hit firstHit(const HapticSpace& space, GridPoint from, GridPoint to,
             RayWalk walk = RayWalk::blocks) RELIEVO_REALTIME;

}  // namespace relievo
