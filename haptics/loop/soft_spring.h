// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// A spring over ground of differing firmness, per N/mm of its stiffness, in one tick.
struct SoftPull {
  double energy_mm2 = 0;   ///< 1/2 part d^2.
  DeviceMm pull;           ///< Its force on the hand.
  DeviceMm hand;           ///< Where that hand is.
  double least_share = 0;  ///< No less of it may be felt: as soft as the ground may get at all.
};

/// The proxy goes where the hand is nearest, not where the spring's energy is least. Where it slips
/// from soft ground onto firm ground, distance falls but energy may rise, and a hand that let go
/// there would have it as a gift. Then only so much of the spring is felt as the hand paid for,
/// until a slip the other way gives it back or the hand lets go: a closed way gains nothing.
struct SoftSpring {
  double share = 1;  ///< Of the spring, that is felt; (0, 1].
  SoftPull last;
  bool watched = false;  ///< `last` is of the tick before.

  /// A hand that goes farther in one tick was late or was moved: what it paid is not known.
  static constexpr double kMostWayMm = 1;
};

/// share E - share' E' = mean force times way, as far as share <= 1 allows. [haptic loop]
SoftSpring yielded(SoftSpring spring, const SoftPull& now) RELIEVO_REALTIME;

}  // namespace relievo
