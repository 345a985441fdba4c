// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// What motors can take.
struct HeatRules {
  double max_force_n = 0;         ///< For a short time.
  double continuous_force_n = 0;  ///< For as long as one likes.
  double time_s = 20;             ///< Of their warming and cooling.
};

/// Keeps motors from what they can show for a moment only. Their heat is the square of the force,
/// averaged over some time: at the square of the continuous force they are as warm as they may be
/// for good. From half of that on the largest force falls, and reaches the continuous one there; so
/// it does with what a thermometer of the device says. [link]
class HeatBudget {
 public:
  explicit HeatBudget(const HeatRules& rules = {}) : rules_(rules) {
    rules_.continuous_force_n = std::min(rules_.continuous_force_n, rules_.max_force_n);
  }

  /// What of a force is shown from now on, until the next call.
  DeviceN shown(DeviceN wanted, std::int64_t now_ns) RELIEVO_REALTIME {
    warm(now_ns);
    const double wanted_n = norm(wanted);
    const double part = wanted_n > allowedN() ? allowedN() / wanted_n : 1;
    shown_n_ = part * wanted_n;
    return part * wanted;
  }
  /// 0 cold .. 1 at its limit; negative: it has no thermometer.
  void measured(double hottest) RELIEVO_REALTIME { hottest_ = hottest; }

  /// The largest force now.
  double allowedN() const RELIEVO_REALTIME {
    constexpr double kFallsFrom = 0.5;
    const double over = std::clamp((used() - kFallsFrom) / (1 - kFallsFrom), 0.0, 1.0);
    return rules_.max_force_n + over * (rules_.continuous_force_n - rules_.max_force_n);
  }
  /// 0 cold .. 1 as warm as they may be for good.
  double used() const RELIEVO_REALTIME {
    const double most = rules_.continuous_force_n * rules_.continuous_force_n;
    return std::max(hottest_, most > 0 ? squares_ / most : 0);
  }

 private:
  /// By the force that was shown since the last call.
  void warm(std::int64_t now_ns) RELIEVO_REALTIME {
    constexpr std::int64_t kLongestNs = 1'000'000'000;  // A sleep of the computer is no push.
    const std::int64_t since_ns = last_ns_ == 0 ? 0 : now_ns - last_ns_;
    last_ns_ = now_ns;
    const double since_s =
        1e-9 * static_cast<double>(std::clamp<std::int64_t>(since_ns, 0, kLongestNs));
    squares_ += (shown_n_ * shown_n_ - squares_) * since_s / (rules_.time_s + since_s);
  }

  HeatRules rules_;
  double squares_ = 0;  // N^2, averaged.
  double shown_n_ = 0, hottest_ = -1;
  std::int64_t last_ns_ = 0;
};

}  // namespace relievo
