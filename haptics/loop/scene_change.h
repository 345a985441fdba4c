// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "haptics/proxy/proxy.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

class BlendedSurface;  // haptics/proxy/blend.h

/// The spring before and after a change, N per mm of hand.
struct SpringChange {
  double was_n_per_mm = 0.5, now_n_per_mm = 0.5;  ///< On firm ground.
  double softest_part = 1;                        ///< FieldOptions::softest_part.
};

/// How much of the spring's force reaches the hand.
struct FeltSpring {
  double gain = 1;                                           ///< Strength times rise; 0: nothing.
  double limit_n = std::numeric_limits<double>::infinity();  ///< More is not felt.
  double pull_n = 0;                                         ///< Of the fields above a surface.
};

/// What the surface did to the spring of a hand that held still, in one tick of a change.
struct SurfaceLift {
  double before_mm = 0, after_mm = 0;  ///< The spring's length, mm of hand.
  double softer = 1;                   ///< Its stiffness before, of that after.

  /// Energy that the surface put into the spring by moving, mJ; below 0 it took some. Nobody owes
  /// it: it is no error of the rendering, which the passivity stage would take back.
  /// @param k       N/mm now, as it reaches the hand
  /// @param most_n  where the force stops growing
  double givenMj(double k, double most_n) const RELIEVO_REALTIME;
};

/// One surface turning into the next under the hand: level, window, gain, fill or view changed. The
/// proxy stays on the blended surface, and surface and spring change no faster than the hand should
/// feel: by the force that it does feel, not by the surfaces' heights. A hand that touches neither
/// has the new one at once, and lifting off ends it. [haptic loop]
class SceneChange {
 public:
  static constexpr double kLeastTicks = 200;       ///< Of a change in contact without difference.
  static constexpr double kMostStepN = 0.004;      ///< Aimed at: change of force in a tick at rest.
  static constexpr double kMostCreepTicks = 2000;  ///< Then the next window has waited enough.

  /// From `was` to `now`: the proxy is carried over by its place in the hand's space.
  ProxyState begin(const HapticSpace& was, const HapticSpace& now, ProxyState proxy,
                   SpringChange spring) RELIEVO_REALTIME;
  bool running() const RELIEVO_REALTIME { return running_; }
  void stop() RELIEVO_REALTIME { running_ = false; }
  /// The spring of this tick.
  double stiffness() const RELIEVO_REALTIME { return stiffnessAt(weight_); }
  /// How much of the new surface is felt, 0 .. 1.
  double weight() const RELIEVO_REALTIME { return weight_; }

  /// One tick: the surface moves on and takes the proxy with it, then the hand moves to `hip`.
  /// Works with the converged proxy, whatever options.kind says.
  /// @param proxy  in: of the last tick; out: of this one
  SurfaceLift follow(const HapticSpace& was, const HapticSpace& now, ProxyState& proxy,
                     GridPoint hip, const ProxyOptions& options,
                     const FeltSpring& felt) RELIEVO_REALTIME;
  /// Unit normal of the blended surface at the proxy.
  GridPoint normal(const HapticSpace& was, const HapticSpace& now,
                   const ProxyState& proxy) const RELIEVO_REALTIME;

 private:
  friend struct NamedFields;  // Recordings hold every member by its name.
  double stiffnessAt(double weight) const RELIEVO_REALTIME {
    return spring_.was_n_per_mm + weight * (spring_.now_n_per_mm - spring_.was_n_per_mm);
  }
  double differenceInPlace(const HapticSpace& was, const HapticSpace& now,
                           const ProxyState& proxy) const RELIEVO_REALTIME;
  double mostStep(const HapticSpace& was, const HapticSpace& now, const ProxyState& proxy,
                  const FeltSpring& felt) const RELIEVO_REALTIME;

  GridPoint felt(const ProxyState& state, double cell_mm,
                 const FeltSpring& felt) const RELIEVO_REALTIME;
  ProxyState goal(const BlendedSurface& surface, ProxyState at, GridPoint hip,
                  const ProxyOptions& options) const RELIEVO_REALTIME;

  bool running_ = false;
  bool lets_go_ = false;  // The proxy has no ground any more, and its force goes away step by step.
  double creep_ticks_ = 0;  // Since the new surface is there.
  double weight_ = 1;
  SpringChange spring_;
};

}  // namespace relievo
