// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/depth/depth_map.h"

namespace relievo::test {

/// 100 x 100 mm, a sample each 0.5 mm, all measured.
inline DepthMap mapOf(const std::function<double(double, double)>& z) {
  DepthMap map;
  map.frame = {.size = {.cols = 200, .rows = 200},
               .spacing_mm = 0.5,
               .first_x_mm = 0.25,
               .first_y_mm = 0.25};
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 200; ++col) {
      map.heights_mm.push_back(static_cast<float>(z(map.frame.xMm(col), map.frame.yMm(row))));
    }
  }
  map.origins.assign(map.frame.size.count(), CellStatus::measured);
  return map;
}

}  // namespace relievo::test
