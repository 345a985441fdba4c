// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/link/pose_gate.h"

#include <algorithm>

namespace relievo::falcon {

bool PoseGate::takes(DeviceMm place, When when) RELIEVO_REALTIME {
  constexpr double kPeriodS = 1e-3;
  const auto seconds = [](std::int64_t from_ns, std::int64_t to_ns) RELIEVO_REALTIME {
    return std::max(0.0, 1e-9 * static_cast<double>(to_ns - from_ns));
  };
  // Answers come one period after their question, and one late is usual.
  const double slack_s = std::max(0.0, seconds(when.asked_ns, when.came_ns) - 2 * kPeriodS);
  const double passed_s = seconds(time_ns_, when.came_ns);
  const double least_s = std::max(kPeriodS, passed_s);
  const DeviceMm way = place - place_;
  if (known_) {
    const double late_s = slack_s + slack_s_, most_s = least_s + late_s;
    const DeviceMm drift{passed_s * velocity_.x, passed_s * velocity_.y, passed_s * velocity_.z};
    // Each of the two times that the speed is taken from can be late as well.
    const double late_mm = (2 * kPeriodS + late_s) * speed_mm_per_s_;
    const double reach_mm = kGrainMm + late_mm + 0.5 * kMostMmPerS2 * most_s * most_s;
    const double farthest_mm = kGrainMm + kMostMmPerS * (most_s + kPeriodS);
    if ((speed_known_ && norm(way - drift) > reach_mm) || norm(way) > farthest_mm) {
      ++held_;
      return false;
    }
    speed_known_ = true;
    const double per_s = 1 / least_s;
    velocity_ = {per_s * way.x, per_s * way.y, per_s * way.z};
    speed_mm_per_s_ = std::max(norm(velocity_), 0.9 * speed_mm_per_s_);
  }
  known_ = true;
  held_ = 0;
  place_ = place;
  time_ns_ = when.came_ns;
  slack_s_ = slack_s;
  return true;
}

}  // namespace relievo::falcon
