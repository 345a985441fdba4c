// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/relief/look.h"

namespace relievo {

/// 8-bit sRGB.
using Rgb8 = std::array<std::uint8_t, 3>;

/// Colour for t in [0, 1]; t beyond is held at the ends, and what is not a number is mid grey.
/// Every map grows lighter from 0 to 1, so that it survives a grey printer. The tables are our own,
/// at most 1/255 beside each of the 256 published colours: viridis, 25 colours, of van der Walt and
/// Smith (2015); cividis, 14, of Nunez, Anderton and Renslow (2018); batlow, 17, of Crameri (2018),
/// Scientific colour maps 8.0, doi:10.5281/zenodo.8035877 (see Crameri, Shephard and Heron 2020).
Rgb8 colourOf(ColourMap map, double t);

}  // namespace relievo
