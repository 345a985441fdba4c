// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/device/device.h"
#include "haptics/force/force_model.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// What of a device decides how stiff a surface may be.
struct DeviceTiming {
  double rate_hz = 1000;        ///< New places of the hand, and forces, per second; > 0.
  int delay_ticks = 1;          ///< DeviceInfo::force_delay_ticks, in ticks of that rate.
  double position_step_mm = 0;  ///< One count of the encoders; 0: finer than matters.
};

/// The largest stiffness, N per mm of hand, up to which every grip and every scene of the stability
/// map (docs/dev/stability.md) is still with the passivity stage.
double stableStiffness(const DeviceTiming& timing) RELIEVO_REALTIME;
/// The same without the stage.
double stableStiffnessAlone(const DeviceTiming& timing) RELIEVO_REALTIME;

/// Of that, so much is used: surfaces and hands differ from those of the map.
inline constexpr double kStabilityMargin = 0.75;

/// kDetailStiffness as far as this device holds it: Detail 1 and 2 with the margin of the stage,
/// finer ones no more than what is stable without it.
DetailStiffness detailStiffness(const DeviceTiming& timing) RELIEVO_REALTIME;

DeviceTiming timingOf(const DeviceInfo& device) RELIEVO_REALTIME;
/// The default of a level on a device.
double stiffnessForDetail(int detail, const DeviceInfo& device) RELIEVO_REALTIME;

}  // namespace relievo
