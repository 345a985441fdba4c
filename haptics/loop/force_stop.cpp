// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/force_stop.h"

#include <algorithm>

namespace relievo {

bool ForceStop::heldLong(bool down, bool asked, std::int64_t now_ns) RELIEVO_REALTIME {
  if (down && !down_) {
    down_ns_ = now_ns;
    counts_ = asked;
  }
  down_ = down;
  return down && counts_ && 1e-9 * static_cast<double>(now_ns - down_ns_) >= kHeldS;
}

ForceOptions ForceStop::applied(ForceOptions asked, const ForceStopOptions& options,
                                std::uint32_t buttons, std::int64_t now_ns) RELIEVO_REALTIME {
  const bool held = heldLong((buttons & options.buttons) != 0, asked.forces_on, now_ns);
  if (!asked.forces_on) {
    reason_ = StopReason::none;
    return asked;
  }
  if (reason_ == StopReason::none && options.window_silent) {
    reason_ = StopReason::window_silent;
    silent_ns_ = now_ns;
  }
  if (held) reason_ = StopReason::held;
  double left = reason_ == StopReason::held ? 0 : 1;
  if (reason_ == StopReason::window_silent) {
    left = std::max(0.0, 1 - 1e-9 * static_cast<double>(now_ns - silent_ns_) / kFadeS);
  }
  asked.forces_on = left > 0;
  asked.strength *= left;
  return asked;
}

}  // namespace relievo
