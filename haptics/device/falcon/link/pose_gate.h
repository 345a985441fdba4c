// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo::falcon {

/// Can the hand have come here? An answer has no checksum: one altered nibble is a valid place up
/// to 200 mm away, and a spring would believe it. A place that hand and arms cannot have reached
/// since the last one is held back; what is reachable grows with time, so that a hand that truly
/// went there is believed some milliseconds later, and a place that nobody can reach never is.
class PoseGate {
 public:
  /// A tap against a stop brakes harder, and is believed one or two answers later.
  static constexpr double kMostMmPerS2 = 300'000;
  static constexpr double kMostMmPerS = 3000;
  /// Three counts: two places of a hand at rest.
  static constexpr double kGrainMm = 0.15;
  /// So many in a row; with the next one the line is at fault.
  static constexpr int kMostHeld = 5;

  /// Between which times the place was taken.
  struct When {
    std::int64_t asked_ns = 0, came_ns = 0;
  };
  /// @return false: it is held back
  bool takes(DeviceMm place, When when) RELIEVO_REALTIME;
  /// The next place is believed, wherever it is.
  void reset() RELIEVO_REALTIME { *this = {}; }
  int held() const RELIEVO_REALTIME { return held_; }  ///< In a row.

 private:
  DeviceMm place_;
  DeviceMmPerS velocity_;
  std::int64_t time_ns_ = 0;
  double speed_mm_per_s_ = 0;  // Of late, at most: a late answer makes a hand seem slow.
  double slack_s_ = 0;         // It may have been taken so much earlier.
  int held_ = 0;
  bool known_ = false, speed_known_ = false;
};

}  // namespace relievo::falcon
