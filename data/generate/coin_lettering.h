// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "data/generate/shapes.h"

namespace relievo::samples {

struct Stroke {
  Point2 from, to;
};

/// The coin's inscription as strokes bent around the centre, read clockwise from the left.
/// @param radius_mm  of the baseline  @param height_mm  of a letter
std::vector<Stroke> coinLettering(double radius_mm, double height_mm);

}  // namespace relievo::samples
