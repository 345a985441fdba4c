// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "data/generate/sample.h"

/// A struck coin, 24 mm across: rim, circle of beads, lettering around, a sixteen-spoked wheel in
/// the middle. Seen as two scans from the side deliver it: noise, uneven density, and empty spots
/// in the shadow of letters. Millimetres, z up, z = 0 at the lowest point of the field.
namespace relievo::samples {

inline constexpr double kCoinRadiusMm = 12;
inline constexpr double kCoinNoiseMm = 0.01;  ///< Standard deviation, along z.
inline constexpr double kCoinReferenceSpacingMm = 0.03;

/// True height; NaN off the coin.
double coinHeightMm(double x_mm, double y_mm);

Cloud makeCoin();
Reference coinReference();

}  // namespace relievo::samples
