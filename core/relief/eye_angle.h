// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/relief/stereo.h"

namespace relievo {

/// Of what may be chosen between the eyes' directions, by every option, field and file, up to
/// kMostEyeAngleDeg: less is no depth.
inline constexpr double kLeastEyeAngleDeg = 0.01;

}  // namespace relievo
