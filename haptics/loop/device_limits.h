// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "haptics/device/device.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// What is asked for, within the device's data sheet: its largest force, stiffness, damping and
/// slew cap what the options say; its encoders and its delay are made known to the passivity stage.
/// The only place where that is done; doing it twice changes nothing.
HapticOptions withinDevice(HapticOptions options, const DeviceInfo& device) RELIEVO_REALTIME;

/// What withinDevice() takes off, in one sentence for people and recordings; empty: nothing.
/// [any thread]
std::string limitedText(const HapticOptions& asked, const DeviceInfo& device);

}  // namespace relievo
