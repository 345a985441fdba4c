// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "haptics/proxy/patch.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Part of a straight way within one cell, 0 .. 1, at which it first goes below the patch; kNever
/// if it does not. The way starts on or above it: what rounding says otherwise counts as on it.
double crossing(const BilinearPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME;
double crossing(const BicubicPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME;

/// Height of a straight way above a bicubic patch as a polynomial of its part s, 0 .. 1.
using Sextic = std::array<double, 7>;
Sextic heightAbove(const BicubicPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME;
/// Least s in 0 .. 1 from which the polynomial is below zero, for a value >= 0 at 0; else kNever.
double firstBelowZero(const Sextic& polynomial) RELIEVO_REALTIME;

}  // namespace relievo
