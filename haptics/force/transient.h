// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Short knocks along the normal that a spring alone cannot give: on a new contact, as hard as the
/// hand came (Kuchenbecker et al. 2006), and a faint tick where measured ground begins or ends.
struct TransientOptions {
  double contact_n = 0;               ///< Largest knock of a new contact; 0: none.
  double contact_n_s_per_mm = 0.002;  ///< And so much per mm/s of the hand against the surface.
  double crossing_n = 0;              ///< Of the tick between measured and other ground; 0: none.
  double most_mj = 0.02;              ///< A knock ends before it has done more work on the hand.
  friend bool operator==(const TransientOptions&, const TransientOptions&) = default;
};

inline constexpr double kMostContactN = 0.5, kMostCrossingN = 0.2;
inline constexpr int kKnockTicks = 24;       ///< Then a knock is over.
inline constexpr int kRefractoryTicks = 40;  ///< From one to the next.

struct TransientState {
  DeviceMm normal;      ///< Of the running knock.
  double size_n = 0;    ///< Before it decayed.
  double last_n = 0;    ///< What it gave in the last tick.
  double given_mj = 0;  ///< Its work on the hand so far.
  int age = kRefractoryTicks;
  bool contact = false, measured = true;  ///< Of the last tick.
};

struct TransientInput {
  DeviceMm normal{0, 0, 1};  ///< Unit normal of the surface.
  DeviceMm velocity, moved;  ///< Of the hand, mm/s and mm.
  double spring_n = 0;       ///< What the other forces push along the normal; a knock never pulls.
  bool contact = false;
  bool measured = true;  ///< Ground under the proxy.
};

struct ContactTransient {
  DeviceN force;
  TransientState state;
};

/// One tick: begins a knock where there is a reason and gives the running one's share, a sine of
/// 200 Hz that decays within 6 ms.
ContactTransient knock(const TransientOptions& options, const TransientInput& input,
                       TransientState state) RELIEVO_REALTIME;

}  // namespace relievo
