// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/measure/measure.h"

namespace relievo {

/// Heights along a line as a plot with vector text, 120 x 60 mm. Needs a FigureSession or window.
/// @throw ArgumentError  no row
std::string profileSvg(const std::vector<ProfileRow>& rows);

/// The same as CSV: along_mm, x_mm, y_mm, z_mm, uncertainty_mm, origin. The comment lines name the
/// input. Numbers as shortest round-trip doubles.
std::string profileCsv(const std::vector<ProfileRow>& rows, const std::string& input,
                       const std::string& sha256);

}  // namespace relievo
