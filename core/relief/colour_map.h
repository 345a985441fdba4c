// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/relief/look.h"

namespace relievo {

/// 8-bit sRGB.
using Rgb8 = std::array<std::uint8_t, 3>;

/// Colour for t in [0, 1]; t beyond is held at the ends, and what is not a number is mid grey.
/// Every map grows lighter from 0 to 1, so that it survives a grey printer. Viridis: a polynomial
/// of degree 6 through the published map of van der Walt and Smith (2015); cividis: the published
/// polynomial for the map of Nunez, Anderton and Renslow (2018).
Rgb8 colourOf(ColourMap map, double t);

}  // namespace relievo
