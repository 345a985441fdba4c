// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/region/region.h"
#include "core/session/surface.h"

namespace relievo {

/// What the next finer level says about a region: heights at 400 x 400 places, view mm times
/// `gain`, row 0 at the lowest y; place (i, j) at x_mm + (i + 0.5) side/400. Empty: the region's
/// level is the finest. [any thread]
/// @throw ArgumentError, FileError  as windowOf
std::vector<float> finerHeights(const Surface& surface, const Region& region, double gain = 1);

}  // namespace relievo
