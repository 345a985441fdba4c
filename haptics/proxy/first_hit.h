// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/proxy/patch.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

struct Hit {
  bool found = false;
  GridPoint point;  ///< On the surface if found, else the segment's end.
};

/// Where a segment that starts on or above the surface first goes below it; exact up to rounding.
/// A start on the surface with a direction that leads away from it is not a hit. At most 404 cells
/// are visited, whatever the length.
Hit firstHit(const HapticSpace& space, GridPoint from, GridPoint to) RELIEVO_REALTIME;

/// Rate at which a point that leaves `from` along `direction` rises above the surface: the
/// direction's z less the surface's slope in the cell it enters. > 0: free.
double riseRate(const HapticSpace& space, GridPoint from, GridPoint direction) RELIEVO_REALTIME;

}  // namespace relievo
