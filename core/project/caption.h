// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/project/project.h"

namespace relievo {

/// The text that belongs under a figure: object, unit, view, engine, rule, grid, holes, shares of
/// measured cells, detail, level, M, gain, light or relief image, stereo, scale, checksum, program.
/// Dot decimals, as in files.
/// @param paper_per_mm  of the region's panel: millimetres of paper per millimetre of object
/// @param eye_angle_deg  as drawn, if in stereo
std::string captionOf(const Project& project, const Surface& surface, double paper_per_mm,
                      double eye_angle_deg);

/// A number with at most `digits` significant digits and no trailing zeros.
std::string shortNumber(double value, int digits = 4);

}  // namespace relievo
