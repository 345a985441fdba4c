// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

// Plots of force and height show at least so much, so that noise stays small.

inline constexpr double kLeastForceN = 1;
inline constexpr double kLeastHeightMm = 0.05;

}  // namespace relievo
