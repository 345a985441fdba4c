// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "core/recording/touch_row.h"
#include "core/region/region.h"
#include "haptics/rt/realtime.h"
#include "haptics/sound/touch_events.h"

namespace relievo::sound {

/// Heights between which the tone goes from low to high, view mm without the windows' gain.
struct ToneHeights {
  double low_mm = 0, high_mm = 0;
};

/// What the sound of a row depends on besides the row itself.
struct HeardPlace {
  const Region* region = nullptr;  ///< Of the row's window; null: it is not known.
  double gain = 1;                 ///< Of its heights.
  ToneHeights heights;
  double left_mm = 0,
         right_mm = 0;  ///< From the left ear to the right one, where no region is known.
};

/// Where a value lies between two others, 0 .. 1; 0.5 where they are the same. Ends that stand the
/// other way round turn it round.
inline double shareOf(double value, double low, double high) RELIEVO_REALTIME {
  return high != low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
}

/// What is heard of one row: of a recording, or of a touch that goes on. The one function for both.
TouchSample touchSampleOf(const TouchRow& row, const HeardPlace& place) RELIEVO_REALTIME;

}  // namespace relievo::sound
