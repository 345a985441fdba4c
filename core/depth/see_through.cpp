// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/see_through.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace relievo {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();

/// Neighbours above this count as standing in front of a cell of this depth.
float limitAbove(float depth, const GridFrame& frame) {
  return depth + static_cast<float>(kSeeThroughCells * frame.spacing_mm);
}

/// Highest value within `radius` along one line of `count` cells that are `stride` apart.
void highestAlong(const float* in, float* out, std::ptrdiff_t count, std::ptrdiff_t stride,
                  std::ptrdiff_t radius) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    float highest = kNone;
    const std::ptrdiff_t last = std::min(i + radius, count - 1);
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(i - radius, 0); k <= last; ++k) {
      highest = std::max(highest, in[k * stride]);
    }
    out[i * stride] = highest;
  }
}

/// Highest measured depth in the square around every cell; rows first, then columns.
FrontDepths highestAround(const FrontDepths& depths, GridSize size, int radius) {
  FrontDepths known = depths;
  for (float& z : known) z = std::isnan(z) ? kNone : z;
  FrontDepths along_rows(depths.size());
  for (int row = 0; row < size.rows; ++row) {
    const std::size_t start = size.index({.col = 0, .row = row});
    highestAlong(&known[start], &along_rows[start], size.cols, 1, radius);
  }
  for (int col = 0; col < size.cols; ++col) {
    const auto start = static_cast<std::size_t>(col);
    highestAlong(&along_rows[start], &known[start], size.rows, size.cols, radius);
  }
  return known;
}

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
    const FrontDepths highest = highestAround(depths, frame.size, radius);
    std::vector<std::size_t> hidden;
    for (int row = 0; row < frame.size.rows; ++row) {
      if (row % 16 == 0) task.check();
      for (int col = 0; col < frame.size.cols; ++col) {
        const std::size_t i = frame.size.index({.col = col, .row = row});
        // Hardly any cell has a neighbour that high; only those are looked at closely.
        if (std::isnan(depths[i]) || highest[i] <= limitAbove(depths[i], frame)) continue;
        if (isSeenThrough(depths, frame, {.col = col, .row = row}, radius)) hidden.push_back(i);
      }
    }
    for (const std::size_t i : hidden) depths[i] = std::numeric_limits<float>::quiet_NaN();
    dropped += hidden.size();
  }
  return dropped;
}

}  // namespace relievo
