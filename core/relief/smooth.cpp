// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/smooth.h"

#include <algorithm>
#include <cmath>

#include "core/base/bands.h"

namespace relievo {
namespace {

std::vector<float> gaussian(double sigma) {
  const int radius = std::max(1, static_cast<int>(std::ceil(4 * sigma)));
  std::vector<float> weights;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
  }
  return weights;
}

/// Sum of `in` under the weights along one axis; beyond the grid there is nothing.
std::vector<float> filtered(const std::vector<float>& in, GridSize size,
                            const std::vector<float>& weights, bool along_rows, const Task& task) {
  const int radius = static_cast<int>(weights.size() / 2);
  const int count = along_rows ? size.cols : size.rows;
  const std::size_t stride = along_rows ? 1 : static_cast<std::size_t>(size.cols);
  std::vector<float> out(in.size());
  parallelFor(size.rows, threadsFor(size.count(), 0), [&](int first, int end) {
    for (int row = first; row < end; ++row) {
      task.check();
      for (int col = 0; col < size.cols; ++col) {
        const int at = along_rows ? col : row;
        const int from = std::max(-radius, -at);
        const int to = std::min(radius, count - 1 - at);
        const std::size_t i = size.index({col, row});
        const float* value = in.data() + i - static_cast<std::size_t>(-from) * stride;
        const float* weight = weights.data() + radius + from;
        float sum = 0;
        for (int k = from; k <= to; ++k, value += stride) sum += *weight++ * *value;
        out[i] = sum;
      }
    }
  });
  return out;
}

}  // namespace

std::vector<float> smoothed(const DepthMap& map, double sigma_samples, const Task& task) {
  const GridSize size = map.frame.size;
  const std::vector<float> weights = gaussian(sigma_samples);
  std::vector<float> heights(size.count(), 0);
  std::vector<float> known(size.count(), 0);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (map.origins[i] == CellStatus::outside) continue;
    heights[i] = map.heights_mm[i];
    known[i] = 1;
  }
  for (const bool along_rows : {true, false}) {
    heights = filtered(heights, size, weights, along_rows, task);
    known = filtered(known, size, weights, along_rows, task);
  }
  for (std::size_t i = 0; i < heights.size(); ++i) {
    heights[i] = known[i] > 0 ? heights[i] / known[i] : map.heights_mm[i];
  }
  return heights;
}

}  // namespace relievo
