// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "haptics/force/force_model.h"
#include "haptics/loop/surface_fields.h"
#include "haptics/proxy/proxy.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// What people set of how a surface feels.
struct FeltSettings {
  double strength = 0.6;
  DetailStiffness stiffness_n_per_mm = kDetailStiffness;  ///< As they hold, by detail or not.
  double damping_n_s_per_mm = 0;
  double lift_n = 0;
  double static_friction = 0, dynamic_friction = 0;
  FieldOptions fields;
  friend bool operator==(const FeltSettings&, const FeltSettings&) = default;
};

/// What the hand felt in the last tick.
struct FeltNow {
  int detail = 1;
  double depth_mm = 0;        ///< From proxy to hand; 0: free.
  double speed_mm_per_s = 0;  ///< Of the hand.
  double rise = 0;            ///< ForceState::rise; 0: nothing.
};

/// Strength, stiffness, damping, friction and fields on their way from what was felt to what is
/// asked for: no faster than the hand should feel it. Free, or without force, they are there at
/// once; strength 0 always is. [haptic loop]
class SettingsBlend {
 public:
  static constexpr double kMostStepN = 0.004;  ///< Change of force in a tick at rest.

  /// The settings of this tick.
  /// @param surface_changes  a surface changes too: only the strength goes on meanwhile
  FeltSettings toward(const FeltSettings& asked, const FeltNow& now,
                      bool surface_changes) RELIEVO_REALTIME;
  void reset() RELIEVO_REALTIME { started_ = false; }

 private:
  friend struct NamedFields;  // Recordings hold every member by its name.
  bool started_ = false;
  FeltSettings felt_;
};

}  // namespace relievo
