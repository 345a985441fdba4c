// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "core/base/line_corners.h"
#include "haptics/device/virtual_hand.h"
#include "haptics/guide/guide_path.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo::test {

/// What happened to a hand that was led.
struct Led {
  double rms_mm = 0;    ///< Of its distance from the path while it was led along it.
  double worst_mm = 0;  ///< Likewise.
  double largest_n = 0;
  double fastest_mm_per_s = 0;
  double seconds = 0;    ///< From the first tick that led to the last.
  double against_s = 0;  ///< Longest time in a row above 1.5 N.
  GuideEnd end = GuideEnd::none;
  ForceAudit audit;
};

/// Core, virtual hand and a person who gives way: the aim follows the hand with this time constant.
/// Unless a person wants something else.
class LedHand {
 public:
  LedHand(const VirtualHandOptions& hand, const GuidePath& path, double gives_way_s,
          double strength = 0.6)
      : space_(spaceOf(80, [](double, double) { return 0.0; })),
        hand_(hand),
        path_(path),
        gives_way_s_(gives_way_s) {
    path_.id = 1;
    path_.scene_id = 0;
    HapticOptions options;
    options.force.forces_on = true;
    options.force.strength = strength;
    options.guide.path = 1;
    options_ = withinDevice(options, hand_.info());
    hand_.open();
  }

  using Wish = std::function<DeviceMm(double t_s, DeviceMm hand, DeviceMm aim)>;
  std::function<void(const HapticSample&, double t_s)> each = [](const HapticSample&, double) {};
  HapticOptions& options() { return options_; }
  VirtualHand& hand() { return hand_; }
  HapticCore& core() { return core_; }

  /// Until the guide lets go, or so long.
  Led run(DeviceMm start, double most_s, const Wish& wish = {}) {
    Led led;
    DeviceMm aim = start;
    hand_.placeAt(start);
    double squares = 0, against = 0;
    int ticks = 0, on = 0;
    for (int i = 0; i < static_cast<int>(1000 * most_s); ++i) {
      now_ns_ += 1'000'000;
      const double t_s = 1e-3 * i;
      aim = wish ? wish(t_s, hand_.position(), aim)
                 : aim + (0.001 / gives_way_s_) * (hand_.position() - aim);
      if (i > 0) hand_.moveTo(aim);
      const HapticSample sample =
          core_.tick(*space_, options_, hand_.read(now_ns_), now_ns_, &path_);
      hand_.send(sample.force, now_ns_);
      each(sample, t_s);
      if (sample.guide == GuidePhase::off) {
        if (on == 0) continue;
        led.end = sample.guide_end;
        break;
      }
      ++on;
      const double force = norm(sample.force);
      led.largest_n = std::max(led.largest_n, force);
      led.fastest_mm_per_s = std::max(led.fastest_mm_per_s, norm(hand_.velocity()));
      against = force > 1.5 ? against + 0.001 : 0;
      led.against_s = std::max(led.against_s, against);
      if (sample.guide == GuidePhase::approaching) continue;
      const double off = distance(hand_.position());
      squares += off * off;
      led.worst_mm = std::max(led.worst_mm, off);
      ++ticks;
    }
    led.rms_mm = ticks > 0 ? std::sqrt(squares / ticks) : std::numeric_limits<double>::infinity();
    led.seconds = 1e-3 * on;
    led.audit = core_.audit();
    return led;
  }

  /// From the path, by its corners and not by the law's search.
  double distance(DeviceMm p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < path_.stretches(); ++i) {
      least = std::min(least, distanceFromStretch(p, path_.start(i), path_.end(i)));
    }
    return least;
  }

 private:
  std::unique_ptr<HapticSpace> space_;
  VirtualHand hand_;
  GuidePath path_;
  double gives_way_s_;
  HapticOptions options_;
  HapticCore core_;
  std::int64_t now_ns_ = 0;
};

inline std::vector<DeviceMm> circle(double radius_mm, int points = 72) {
  std::vector<DeviceMm> line;
  for (int i = 0; i < points; ++i) {
    const double a = 2 * std::acos(-1.0) * i / points;
    line.push_back({radius_mm * std::cos(a), radius_mm * std::sin(a), 0});
  }
  return line;
}

inline std::vector<DeviceMm> square(double side_mm) {
  const double h = side_mm / 2;
  return {{h, h, 0}, {-h, h, 0}, {-h, -h, 0}, {h, -h, 0}};
}

/// Ten points: five out, five in.
inline std::vector<DeviceMm> star() {
  std::vector<DeviceMm> line;
  for (int i = 0; i < 10; ++i) {
    const double a = std::acos(-1.0) * (i / 5.0 + 0.5), r = i % 2 == 0 ? 30 : 14;
    line.push_back({r * std::cos(a), r * std::sin(a), 0});
  }
  return line;
}

}  // namespace relievo::test
