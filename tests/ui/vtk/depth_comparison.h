// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/depth/rules/rasterize.h"
#include "ui/vtk/depth_capture.h"

namespace relievo {

struct Difference {
  double same_mask = 0;   ///< Share of cells.
  double largest_mm = 0;  ///< Two cells and more from a silhouette.
  double depth_range_mm = 0;
  std::size_t compared = 0;
};

/// A silhouette is where the surface ends or jumps by more than `jump_mm` between neighbours.
inline Difference compare(const FrontDepths& a, const FrontDepths& b, GridSize size,
                          double jump_mm) {
  Difference result;
  std::size_t same = 0;
  float lowest = INFINITY, highest = -INFINITY;
  for (std::size_t i = 0; i < a.size(); ++i) {
    same += std::isnan(a[i]) == std::isnan(b[i]) ? 1U : 0U;
    if (std::isnan(a[i])) continue;
    lowest = std::min(lowest, a[i]);
    highest = std::max(highest, a[i]);
  }
  result.same_mask = static_cast<double>(same) / static_cast<double>(a.size());
  result.depth_range_mm = static_cast<double>(highest - lowest);
  for (int row = 2; row + 2 < size.rows; ++row) {
    for (int col = 2; col + 2 < size.cols; ++col) {
      const auto here = static_cast<double>(a[size.index({col, row})]);
      bool clear = true;
      for (int dr = -2; dr <= 2 && clear; ++dr) {
        for (int dc = -2; dc <= 2 && clear; ++dc) {
          const std::size_t i = size.index({col + dc, row + dr});
          clear = std::abs(static_cast<double>(a[i]) - here) < jump_mm && !std::isnan(b[i]);
        }
      }
      if (!clear) continue;
      ++result.compared;
      result.largest_mm = std::max(result.largest_mm,
                                   std::abs(here - static_cast<double>(b[size.index({col, row})])));
    }
  }
  return result;
}

/// The measure: largest difference 2e-5 of the depth range, mask equal in 99.9 % of cells.
inline void expectEnginesAgree(const FrontDepths& cpu, const FrontDepths& gl, GridSize size,
                               double jump_mm, double at_least_compared) {
  const Difference d = compare(cpu, gl, size, jump_mm);
  EXPECT_GE(d.same_mask, 0.999);
  EXPECT_LE(d.largest_mm, 2e-5 * d.depth_range_mm) << "of " << d.depth_range_mm << " mm";
  EXPECT_GE(static_cast<double>(d.compared), at_least_compared * static_cast<double>(size.count()));
  if (std::getenv("RELIEVO_TEST_FIGURES")) {
    std::printf("same mask %.6f, largest difference %.2e of the range, %zu cells\n", d.same_mask,
                d.largest_mm / d.depth_range_mm, d.compared);
  }
}

}  // namespace relievo
