// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/push_pull.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

struct Layer {
  GridSize size;
  std::vector<float> value, weight;
};

/// Pull: each coarse cell is the weighted mean of its up to four fine cells.
Layer pulled(const Layer& fine) {
  Layer coarse;
  coarse.size = {.cols = (fine.size.cols + 1) / 2, .rows = (fine.size.rows + 1) / 2};
  coarse.value.assign(coarse.size.count(), 0.0F);
  coarse.weight.assign(coarse.size.count(), 0.0F);
  for (int row = 0; row < fine.size.rows; ++row) {
    for (int col = 0; col < fine.size.cols; ++col) {
      const std::size_t from = fine.size.index({.col = col, .row = row});
      const std::size_t to = coarse.size.index({.col = col / 2, .row = row / 2});
      coarse.value[to] += fine.weight[from] * fine.value[from];
      coarse.weight[to] += fine.weight[from];
    }
  }
  for (std::size_t i = 0; i < coarse.value.size(); ++i) {
    if (coarse.weight[i] > 0) coarse.value[i] /= coarse.weight[i];
    coarse.weight[i] = std::min(coarse.weight[i], 1.0F);
  }
  return coarse;
}

/// Push: bilinear value of the coarse grid under a fine cell; fine cell f lies at (f - 0.5) / 2.
float coarseValue(const Layer& coarse, Cell fine) {
  const auto split = [](int f, int count, int& low, int& high) {
    const double x = std::clamp((f - 0.5) / 2, 0.0, count - 1.0);
    low = static_cast<int>(x);
    high = std::min(low + 1, count - 1);
    return static_cast<float>(x - low);
  };
  int c0 = 0;
  int c1 = 0;
  int r0 = 0;
  int r1 = 0;
  const float u = split(fine.col, coarse.size.cols, c0, c1);
  const float v = split(fine.row, coarse.size.rows, r0, r1);
  const auto at = [&](int col, int row) {
    return coarse.value[coarse.size.index({.col = col, .row = row})];
  };
  return (1 - v) * ((1 - u) * at(c0, r0) + u * at(c1, r0)) +
         v * ((1 - u) * at(c0, r1) + u * at(c1, r1));
}

}  // namespace

void pushPull(std::vector<float>& values, const Mask& known, GridSize size, const Task& task) {
  std::vector<Layer> layers(1);
  layers[0].size = size;
  layers[0].value.assign(values.size(), 0.0F);
  layers[0].weight.assign(values.size(), 0.0F);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (known[i] == 0) continue;
    layers[0].value[i] = values[i];
    layers[0].weight[i] = 1;
  }
  while (layers.back().size.cols > 1 || layers.back().size.rows > 1) {
    task.check();
    layers.push_back(pulled(layers.back()));
  }
  for (std::size_t level = layers.size() - 1; level-- > 0;) {
    task.check();
    Layer& fine = layers[level];
    for (int row = 0; row < fine.size.rows; ++row) {
      for (int col = 0; col < fine.size.cols; ++col) {
        const std::size_t i = fine.size.index({.col = col, .row = row});
        const float w = fine.weight[i];
        if (w >= 1) continue;
        fine.value[i] =
            w * fine.value[i] + (1 - w) * coarseValue(layers[level + 1], {.col = col, .row = row});
      }
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (known[i] == 0) values[i] = layers[0].value[i];
  }
}

}  // namespace relievo
