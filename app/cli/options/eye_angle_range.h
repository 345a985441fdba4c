// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/options/number_option.h"
#include "core/relief/eye_angle.h"

namespace relievo::batch {

/// What --eye-angle may be, of every verb that has it.
inline constexpr NumberRange kEyeAngles{
    .low = kLeastEyeAngleDeg, .high = kMostEyeAngleDeg, .unit = "degrees"};

}  // namespace relievo::batch
