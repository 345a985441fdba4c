// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/region/region.h"

namespace relievo {

/// Which part of the pink window a pointer is on.
enum class PinkPart {
  outside,
  inside,
  left,
  right,
  bottom,
  top,
  left_bottom,
  right_bottom,
  left_top,
  right_top
};

/// @param tolerance_mm  how far from an edge still counts as on it
PinkPart pinkPartAt(const Region& window, double x_mm, double y_mm, double tolerance_mm);

/// A square drawn from where the pointer went down to where it is.
RectMm drawnSquare(double from_x_mm, double from_y_mm, double to_x_mm, double to_y_mm);

/// The square after an edge or a corner was dragged to (x, y); the opposite edge or corner stays.
/// Never smaller than `least_mm`.
RectMm resizedSquare(const Region& start, PinkPart part, double x_mm, double y_mm, double least_mm);

}  // namespace relievo
