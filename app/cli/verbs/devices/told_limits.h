// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "haptics/device/device.h"

namespace relievo::batch {

/// Before the limits that a device told of itself when it was opened, in a log's header: a plug-in,
/// without which nobody knows them.
inline constexpr std::string_view kToldLimits = "device told ";

/// All that a core is given of them, in one line of JSON.
std::string toldLimits(const DeviceInfo& device);
/// @return nothing if the text is none that toldLimits() wrote
std::optional<DeviceInfo> fromToldLimits(std::string_view text);

}  // namespace relievo::batch
