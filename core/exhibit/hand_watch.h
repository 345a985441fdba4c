// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/vec3.h"

namespace relievo {

/// Seconds that were waited for something, looked at now and then. No clock, as below.
class WaitWatch {
 public:
  /// @param waits  still waited for; else it begins anew @return how long by now
  double look(bool waits, double now_s) {
    constexpr double kLongestLookS = 1;  // Who stood still longer has not waited so long.
    const double since_s = std::min(now_s - std::exchange(looked_s_, now_s), kLongestLookS);
    return waited_s_ = waits ? waited_s_ + since_s : 0;
  }

 private:
  double looked_s_ = 0, waited_s_ = 0;
};

/// What a visitor's hand does, as far as a visit depends on it. No clock: time is an argument, in
/// seconds from anywhere. [one thread]
class HandWatch {
 public:
  static constexpr double kStirMm = 5;     ///< Less is a hand that rests.
  static constexpr double kRestMm = 4;     ///< Slower than 5 mm/s over the 0.8 s of a pause.
  static constexpr double kStillMm = 0.2;  ///< Less than a living hand trembles within 2 s.
  static constexpr double kSinkS = 3;      ///< Of a grip that nobody holds any more.

  /// Where the hand is, mm of hand. @return true: it has moved since it last was said to have
  bool moved(const DeviceMm& at, double now_s) {
    rest_.follow(at, kRestMm, now_s);
    still_.follow(at, kStillMm, now_s);
    return hasStirred(stirred_, at);
  }
  /// Where the grip of the device is, mm of hand, told now and then, also while nothing is open.
  /// @param is_idle  no visit is on @return true: a hand has moved it; not where it sinks at the
  /// end of a visit, because forces have ended
  bool gripMoved(const DeviceMm& at, bool is_idle, double now_s) {
    if (!is_idle) sinks_until_s_ = now_s + kSinkS;
    return hasStirred(gripped_, at) && !(is_idle && now_s < sinks_until_s_);
  }
  /// Since when it rests, as far as was told; where nothing is told, it has not moved.
  double restsS(double now_s) const { return rest_.lastsS(now_s); }
  double stillS(double now_s) const { return still_.lastsS(now_s); }

 private:
  static bool isWithin(const DeviceMm& a, const DeviceMm& b, double mm) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) < mm;
  }
  static bool hasStirred(std::optional<DeviceMm>& from, const DeviceMm& at) {
    if (from && isWithin(at, *from, kStirMm)) return false;
    return std::exchange(from, at).has_value();  // The first place is no movement.
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

  std::optional<DeviceMm> stirred_, gripped_;
  double sinks_until_s_ = 0;
  Anchor rest_, still_;
};

}  // namespace relievo
