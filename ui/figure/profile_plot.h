// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/measure/measure.h"

namespace relievo {

/// Heights along a line as a plot with vector text, 120 x 60 mm. Needs a FigureSession or window.
/// @throw ArgumentError  no row
std::string profileSvg(const std::vector<ProfileRow>& rows);

}  // namespace relievo
