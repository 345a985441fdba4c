// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/force/oscillation.h"
#include "haptics/force/passivity.h"
#include "haptics/force/transient.h"
#include "haptics/rt/realtime.h"

namespace relievo {

struct ForceOptions {
  double stiffness_n_per_mm = 0.5;  ///< The paper's k, N per mm of hand; > 0.
  double damping_n_s_per_mm = 0;    ///< Against the speed of pressing in, of the hand; >= 0.
  double strength = 0.6;            ///< What people set: the spring's force times this, 0 .. 1.
  double lift_n = 0;      ///< Upward, against the grip's weight; not scaled by strength; 0: none.
  bool lift_out = false;  ///< Upward is out of the surface, which lies; false: along it, y.
  double limit_n = 6;     ///< Cap; never above the device's own limit.
  double engage_slew_n_per_s = 20;    ///< Largest rise of force per second while forces come on.
  double contact_slew_n_per_s = 200;  ///< Largest change of force per second afterwards.
  double rise_s = 1;                  ///< Forces fade in over this time.
  double stale_after_s = 0.010;       ///< Positions older than this lower the cap ...
  double stale_zero_s = 0.020;        ///< ... to zero at this age.
  double quiet_n = 0.3;               ///< Forces come on only after the spring's force was below
  int quiet_ticks = 5;                ///< this for so many ticks in a row.
  TransientOptions transient;
  PassivityOptions passivity;
  OscillationOptions oscillation;
  bool forces_on = false;  ///< Asked for; what happens then is EngagePhase.
};

/// k of Detail 1, 2, 3 and of all finer ones, N per mm of hand.
using DetailStiffness = std::array<double, 4>;

/// k by detail, from the stability map (docs/dev/stability.md): at most 75 % of what is stable with
/// the passivity stage, and no more than is stable without it where a level carries texture.
inline constexpr DetailStiffness kDetailStiffness{0.8, 0.8, 0.6, 0.5};
double stiffnessForDetail(int detail,
                          const DetailStiffness& of = kDetailStiffness) RELIEVO_REALTIME;

/// What holds the grip once forces have risen so far, 0 .. 1.
DeviceN liftOf(const ForceOptions& options, double rise) RELIEVO_REALTIME;

enum class EngagePhase : std::uint8_t { off, waiting, rising, on };

struct ForceState {
  DeviceN last;  ///< Sent in the last tick; the slew limit starts from it.
  EngagePhase phase = EngagePhase::off;
  double rise = 0;  ///< 0 .. 1 while rising.
  int quiet = 0;    ///< Quiet ticks in a row while waiting.
  TransientState transient;
  PassivityState passivity;
  OscillationState oscillation;
};

struct ForceInput {
  DeviceMm proxy, hip;
  double spring_mm = -1;  ///< Length of the spring where it is not from proxy to hip; < 0: it is.
  DeviceMm normal{0, 0, 1};       ///< Unit normal of the surface at the proxy.
  DeviceMm velocity;              ///< Of the hand, mm/s, filtered.
  DeviceMm moved;                 ///< The hand's last step, mm.
  double speed_window_s = 0.008;  ///< Over which `velocity` was measured.
  DeviceN fields;                 ///< Of texture, softness, magnet, cushion; N at full strength.
  double fields_mj = 0;           ///< Energy that stands in them.
  double given_mj = 0;            ///< Of that: put in on purpose in this tick; nobody owes it.
  bool contact = false;
  bool measured = true;  ///< Ground under the proxy.
  bool fault = false;    ///< Zero force at once.
  bool resumed = false;  ///< First tick after a pause: zero, then the force rises.
  double age_s = 0;      ///< Of the position.
  double dt_s = 0.001;   ///< Nominal period; a late tick does not widen the slew limit.
};

struct ForceResult {
  DeviceN force;         ///< On the hand.
  double command_n = 0;  ///< Its norm before slew and cap.
  bool limited = false;  ///< Slew, cap or the finite check changed it.
  double limit_n = 0;    ///< The cap that held.
  DeviceN damped{};      ///< The passivity controller's share of the command.
  ForceState state{};
};

// The stages, in the order in which they run. Slew, cap and finite check run on every path.
/// F = -k d (paper sec. 4), d from the proxy to the HIP; zero in free space.
DeviceN springForce(const ForceOptions& options, const ForceInput& input) RELIEVO_REALTIME;
/// -b v_n along the normal while the hand presses in; zero while it leaves, so that the surface
/// never pulls. A last step outward also gives zero: the filter's lag must not push the hand out.
DeviceN dampingForce(const ForceOptions& options, const ForceInput& input) RELIEVO_REALTIME;
/// Waits for quiet, then rises. Afterwards `rise` is the factor of the spring's force.
ForceState engage(const ForceOptions& options, const ForceInput& input, DeviceN spring,
                  ForceState state) RELIEVO_REALTIME;
/// Moves from `last` toward `wanted` by at most `step_n`.
DeviceN slewed(DeviceN wanted, DeviceN last, double step_n) RELIEVO_REALTIME;
/// Shortened to at most `limit_n`, same direction.
DeviceN capped(DeviceN force, double limit_n) RELIEVO_REALTIME;
/// The cap for a position of this age.
double limitForAge(const ForceOptions& options, double age_s) RELIEVO_REALTIME;
/// Zero if a component is not a finite number.
DeviceN finiteOrZero(DeviceN force) RELIEVO_REALTIME;

/// The inputs leave no choice: forces are off or not risen yet, a fault, positions too old.
bool zeroDemanded(const ForceOptions& options, const ForceInput& input,
                  const ForceState& state) RELIEVO_REALTIME;

/// All stages of one tick: sum with fields and knocks, passivity, ramp and strength, slew, cap,
/// finite check. Where zero is demanded the force is zero in this very tick.
ForceResult force(const ForceOptions& options, const ForceInput& input,
                  ForceState state) RELIEVO_REALTIME;

/// The spring with its fields and knocks and only the finite check after them: no ramp, slew, cap
/// or zero on a fault, so that F = -k d can be checked from outside. Only for a hand that nobody
/// holds; force() never comes here.
ForceResult bareForce(const ForceOptions& options, const ForceInput& input,
                      ForceState state) RELIEVO_REALTIME;

/// A new surface or the end of a fault: what was engaged fades in anew.
ForceState refade(ForceState state) RELIEVO_REALTIME;
/// No tick came for a while: as refade(), from zero.
ForceState resumed(ForceState state) RELIEVO_REALTIME;

}  // namespace relievo
