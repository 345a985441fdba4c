// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/pink_window.h"

#include <algorithm>
#include <cmath>

namespace relievo {

PinkPart pinkPartAt(const Region& window, double x_mm, double y_mm, double tolerance_mm) {
  const double right = window.x_mm + window.side_mm;
  const double top = window.y_mm + window.side_mm;
  if (x_mm < window.x_mm - tolerance_mm || x_mm > right + tolerance_mm ||
      y_mm < window.y_mm - tolerance_mm || y_mm > top + tolerance_mm) {
    return PinkPart::outside;
  }
  // A tiny window must keep an inside by which it can be moved.
  const double reach = std::min(tolerance_mm, window.side_mm / 4);
  const bool on_left = x_mm < window.x_mm + reach;
  const bool on_right = x_mm > right - reach;
  const bool on_bottom = y_mm < window.y_mm + reach;
  const bool on_top = y_mm > top - reach;
  if (on_left) {
    if (on_bottom) return PinkPart::left_bottom;
    return on_top ? PinkPart::left_top : PinkPart::left;
  }
  if (on_right) {
    if (on_bottom) return PinkPart::right_bottom;
    return on_top ? PinkPart::right_top : PinkPart::right;
  }
  if (on_bottom) return PinkPart::bottom;
  return on_top ? PinkPart::top : PinkPart::inside;
}

RectMm drawnSquare(double from_x_mm, double from_y_mm, double to_x_mm, double to_y_mm) {
  const double dx = to_x_mm - from_x_mm;
  const double dy = to_y_mm - from_y_mm;
  const double side = std::max(std::abs(dx), std::abs(dy));
  return {dx < 0 ? from_x_mm - side : from_x_mm, dy < 0 ? from_y_mm - side : from_y_mm, side, side};
}

RectMm resizedSquare(const Region& start, PinkPart part, double x_mm, double y_mm,
                     double least_mm) {
  const double right = start.x_mm + start.side_mm;
  const double top = start.y_mm + start.side_mm;
  const bool from_left =
      part == PinkPart::left || part == PinkPart::left_bottom || part == PinkPart::left_top;
  const bool from_right =
      part == PinkPart::right || part == PinkPart::right_bottom || part == PinkPart::right_top;
  const bool from_bottom =
      part == PinkPart::bottom || part == PinkPart::left_bottom || part == PinkPart::right_bottom;
  const bool from_top =
      part == PinkPart::top || part == PinkPart::left_top || part == PinkPart::right_top;
  double side = least_mm;
  if (from_left) side = std::max(side, right - x_mm);
  if (from_right) side = std::max(side, x_mm - start.x_mm);
  if (from_bottom) side = std::max(side, top - y_mm);
  if (from_top) side = std::max(side, y_mm - start.y_mm);
  RectMm rect{start.centreX() - 0.5 * side, start.centreY() - 0.5 * side, side, side};
  if (from_left) rect.x_mm = right - side;
  if (from_right) rect.x_mm = start.x_mm;
  if (from_bottom) rect.y_mm = top - side;
  if (from_top) rect.y_mm = start.y_mm;
  return rect;
}

}  // namespace relievo
