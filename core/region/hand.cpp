// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/hand.h"

#include <algorithm>

namespace relievo {

double windowHeightMm(const RegionWindow& window, double x_mm, double y_mm) {
  const double step = window.spacingMm();
  const auto split = [&](double position, double start, std::size_t& low) {
    const double index = std::clamp((position - start) / step - 0.5, 0.0, kWindowSamples - 1.0);
    low = std::min(static_cast<std::size_t>(index), std::size_t{kWindowSamples - 2});
    return index - static_cast<double>(low);
  };
  std::size_t col = 0;
  std::size_t row = 0;
  const double u = split(x_mm, window.region.x_mm, col);
  const double v = split(y_mm, window.region.y_mm, row);
  const auto at = [&](std::size_t c, std::size_t r) {
    return static_cast<double>(window.heights_mm[r * kWindowSamples + c]);
  };
  return (1 - v) * ((1 - u) * at(col, row) + u * at(col + 1, row)) +
         v * ((1 - u) * at(col, row + 1) + u * at(col + 1, row + 1));
}

ViewMm handOver(const RegionWindow& window, double x_mm, double y_mm, bool pressing,
                double depth_hand_mm) {
  const double object_per_hand = handMapping(window).objectMmPerHandMm();
  const double lift_hand_mm = pressing ? -depth_hand_mm : kHoverMm;
  return {x_mm, y_mm, windowHeightMm(window, x_mm, y_mm) + lift_hand_mm * object_per_hand};
}

}  // namespace relievo
