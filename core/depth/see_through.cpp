// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/see_through.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace relievo {
namespace {

bool isSeenThrough(const FrontDepths& depths, const GridFrame& frame, Cell cell, int radius) {
  const float limit =
      depths[frame.size.index(cell)] + static_cast<float>(kSeeThroughCells * frame.spacing_mm);
  int measured = 0;
  int higher = 0;
  for (int row = std::max(0, cell.row - radius);
       row <= std::min(frame.size.rows - 1, cell.row + radius); ++row) {
    for (int col = std::max(0, cell.col - radius);
         col <= std::min(frame.size.cols - 1, cell.col + radius); ++col) {
      const float z = depths[frame.size.index({.col = col, .row = row})];
      if (std::isnan(z)) continue;
      ++measured;
      higher += z > limit ? 1 : 0;
    }
  }
  return 2 * higher > measured;  // The cell itself is one of the measured and not higher.
}

}  // namespace

std::size_t dropSeenThrough(FrontDepths& depths, const GridFrame& frame, int radius,
                            const Task& task) {
  std::size_t dropped = 0;
  // Twice: without the first pass's cells the rest stands out better.
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<std::size_t> hidden;
    for (int row = 0; row < frame.size.rows; ++row) {
      if (row % 16 == 0) task.check();
      for (int col = 0; col < frame.size.cols; ++col) {
        const std::size_t i = frame.size.index({.col = col, .row = row});
        if (std::isnan(depths[i])) continue;
        if (isSeenThrough(depths, frame, {.col = col, .row = row}, radius)) hidden.push_back(i);
      }
    }
    for (const std::size_t i : hidden) depths[i] = std::numeric_limits<float>::quiet_NaN();
    dropped += hidden.size();
  }
  return dropped;
}

}  // namespace relievo
