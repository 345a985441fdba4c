// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// What one tick may send, said from its inputs alone and not by the stages that made the force.
struct ForceBounds {
  bool zero = false;  ///< Nothing may be sent.
  double most_n = 0;  ///< Largest force, of a position this old.
  /// Largest change from the last force, or from what `most_n` leaves of it: a cap that came down
  /// takes hold at once. Letting go is always allowed. So force rises and turns slowly and may
  /// fall fast, but only toward zero.
  double most_step_n = 0;
};

/// Second opinion on every tick, counted in the loop: nobody has to trust the force chain.
struct ForceAudit {
  std::uint64_t ticks = 0;
  std::uint64_t zero_demanded = 0;     ///< Ticks whose inputs demand zero ...
  std::uint64_t zero_violations = 0;   ///< ... and that sent something.
  std::uint64_t limit_violations = 0;  ///< More than the cap, or no finite number.
  std::uint64_t step_violations = 0;   ///< A larger change than the slew limit allows.
  double largest_n = 0;                ///< Of all forces.
  std::uint64_t fast_falls = 0;        ///< Ticks in which a lower cap took more than that: allowed.
  double largest_step_n = 0;           ///< Of all changes as the limit counts them.
  std::uint64_t guided_ticks = 0;      ///< Ticks in which the hand was led ...
  std::uint64_t guide_violations = 0;  ///< ... by more force or power than GuideBounds.
  double largest_guide_n = 0;          ///< Of all forces that led.
  double largest_fed_mw = 0;           ///< Largest power that a moving target fed in.

  std::uint64_t violations() const RELIEVO_REALTIME {
    return zero_violations + limit_violations + step_violations + guide_violations;
  }
};

/// @param before  the force of the tick before, as the device got it
ForceAudit audited(ForceAudit audit, const ForceBounds& bounds, DeviceN before,
                   DeviceN sent) RELIEVO_REALTIME;

/// What may lead a hand: a target that moves is no spring, and its power is bounded instead.
struct GuideBounds {
  double most_n = 2;    ///< Of all that is sent.
  double most_mw = 80;  ///< Force along the way, times the target's speed; N mm/s = mW.
};
/// One more tick of a hand that is led. @param fed_mw  power that the target's way fed in
ForceAudit auditedGuide(ForceAudit audit, const GuideBounds& bounds, DeviceN sent,
                        double fed_mw) RELIEVO_REALTIME;

}  // namespace relievo
