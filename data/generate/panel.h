// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "data/generate/sample.h"

/// A bas-relief panel of 300 x 200 mm, 40 mm deep: a procession in a beaded frame. The figures
/// overlap and stand off the ground, so there is surface that cannot be seen from the front. Taken
/// by three scanners, from the front and from both sides; what none of them saw is missing.
/// Millimetres, z toward the viewer, z = 0 at the ground.
namespace relievo::samples {

inline constexpr double kPanelWidthMm = 300;
inline constexpr double kPanelHeightMm = 200;
inline constexpr double kPanelNoiseMm = 0.03;  ///< Standard deviation, along the scanner's ray.
inline constexpr double kPanelReferenceSpacingMm = 0.25;

/// Height of the front-most surface, to 0.001 mm; NaN off the panel.
double panelHeightMm(double x_mm, double y_mm);

/// Distance to the nearest surface or less; zero on every surface, hidden ones too; negative
/// inside.
double panelDistanceMm(double x_mm, double y_mm, double z_mm);

Cloud makePanel();
Reference panelReference();

}  // namespace relievo::samples
