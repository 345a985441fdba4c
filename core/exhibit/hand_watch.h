// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/vec3.h"

namespace relievo {

/// What a visitor's hand does, as far as a visit depends on it. No clock: time is an argument, in
/// seconds from anywhere. [one thread]
class HandWatch {
 public:
  static constexpr double kStirMm = 5;     ///< Less is a hand that rests.
  static constexpr double kRestMm = 4;     ///< Slower than 5 mm/s over the 0.8 s of a pause.
  static constexpr double kStillMm = 0.2;  ///< Less than a living hand trembles within 2 s.

  /// Where the hand is, mm of hand. @return true: it has moved since it last was said to have
  bool moved(const DeviceMm& at, double now_s) {
    rest_.follow(at, kRestMm, now_s);
    still_.follow(at, kStillMm, now_s);
    if (!stirred_) {
      stirred_ = at;  // The first place is no movement.
      return false;
    }
    if (isWithin(at, *stirred_, kStirMm)) return false;
    stirred_ = at;
    return true;
  }
  /// Since when it rests, as far as was told; where nothing is told, it has not moved.
  double restsS(double now_s) const { return rest_.lastsS(now_s); }
  double stillS(double now_s) const { return still_.lastsS(now_s); }

 private:
  static bool isWithin(const DeviceMm& a, const DeviceMm& b, double mm) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) < mm;
  }
  /// Where it has been since.
  struct Anchor {
    std::optional<DeviceMm> at;
    double since_s = 0;
    void follow(const DeviceMm& now, double mm, double now_s) {
      if (at && isWithin(now, *at, mm)) return;
      at = now;
      since_s = now_s;
    }
    double lastsS(double now_s) const { return at ? now_s - since_s : 0; }
  };

  std::optional<DeviceMm> stirred_;
  Anchor rest_, still_;
};

}  // namespace relievo
