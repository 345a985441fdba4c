// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Time-domain passivity (Hannaford and Ryu 2002): what flows out of the hand's port is added up
/// tick by tick; energy that the surface gave and never got is taken back by damping.
struct PassivityOptions {
  bool on = true;
  double most_damping_n_s_per_mm = 0.006;  ///< The controller's damping is never more than this.
  double reserve_mj = 0.02;  ///< Dissipation that is remembered as credit; N mm = mJ; >= 0.
  double most_debt_mj = 50;  ///< More is forgiven: one hard event must not be felt for long; >= 0.
  // From the device's record.
  double position_step_mm = 0;  ///< One encoder count; below it a speed is noise.
  int force_delay_ticks = 0;    ///< From send() until the force is felt; 0 .. 2.
};

struct PassivityState {
  std::array<DeviceN, 4> sent{};  ///< Forces of the last ticks, newest first.
  double margin_mj = 0;           ///< Dissipated so far, at most the reserve; < 0: owed.
  double stored_mj = 0;           ///< Energy in the springs at the last tick.
  bool started = false;
};

/// The observer. In the last period the hand moved by `moved` while it felt a force that was
/// computed 1 + force_delay_ticks ticks ago and held since: that much energy flowed. What now
/// stands in the surface's springs is not lost.
/// @param moved   the hand's last step, mm
/// @param stored  energy of the springs at this place and this strength, mJ
PassivityState observe(const PassivityOptions& options, DeviceMm moved, double stored_mj,
                       PassivityState state) RELIEVO_REALTIME;

/// The controller: damping against `velocity` (mm/s, filtered) that would take back what is owed
/// within `dt_s`, but never more than the largest damping. Zero while nothing is owed, and where
/// the hand moved less than one count over the filter's `window_s`: that debt is carried on.
DeviceN passivityForce(const PassivityOptions& options, const PassivityState& state,
                       DeviceMm velocity, double window_s, double dt_s) RELIEVO_REALTIME;

/// Remembers the force that leaves for the device.
PassivityState sentOut(PassivityState state, DeviceN force) RELIEVO_REALTIME;

/// After a new surface or a pause: nothing is owed for what happened in between.
PassivityState rebased(PassivityState state) RELIEVO_REALTIME;

/// Energy of a spring of `k` N/mm stretched by `length_mm` whose force stops growing at `most_n`.
double springEnergyMj(double k, double length_mm, double most_n) RELIEVO_REALTIME;

}  // namespace relievo
