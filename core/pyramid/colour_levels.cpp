// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/colour_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/bands.h"
#include "core/depth/linear_light.h"
#include "core/pyramid/row_reducer.h"

namespace relievo {
namespace {

/// How much a cell counts, by its alpha.
using Weights = std::array<float, 256>;

/// Shares of what comes from the scan.
Weights coarserWeights() {
  Weights weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = static_cast<float>(i) / 255;
  return weights;
}

/// Of the finest level: what is interpolated weighs next to nothing, and so decides only alone.
Weights finestWeights() {
  constexpr float kNextToNothing = 1.0F / 4096;
  Weights weights = coarserWeights();
  weights[kBetweenAlpha] = kNextToNothing;
  return weights;
}

/// Rows of a level as the numbers that are averaged: per channel light times weight, then the
/// weight. Keeps the rows that one coarser row is made of.
template <std::size_t Size>
class LightRows {
 public:
  static constexpr std::size_t kPlanes = Size;  ///< Channels, and the weight in place of alpha.

  LightRows(const std::vector<std::array<std::uint8_t, Size>>& pixels, GridSize size,
            const Transfer& transfer, const Weights& weights, std::size_t kept)
      : pixels_(pixels),
        size_(size),
        weights_(weights),
        rows_(kept, -1),
        planes_(kept * kPlanes * static_cast<std::size_t>(size.cols)) {
    for (std::size_t i = 0; i < light_.size(); ++i) light_[i] = transfer.light[i];
  }

  const float* at(int row, std::size_t plane) {
    const std::size_t slot = static_cast<std::size_t>(row) % rows_.size();
    const auto cols = static_cast<std::size_t>(size_.cols);
    float* const planes = &planes_[slot * kPlanes * cols];
    if (rows_[slot] != row) {
      rows_[slot] = row;
      const auto* const pixels = &pixels_[size_.index({.col = 0, .row = row})];
      for (std::size_t i = 0; i < cols; ++i) {
        const float weight = weights_[pixels[i][Size - 1]];
        for (std::size_t k = 0; k + 1 < Size; ++k) {
          planes[k * cols + i] = weight * light_[pixels[i][k]];
        }
        planes[(Size - 1) * cols + i] = weight;
      }
    }
    return planes + plane * cols;
  }

 private:
  const std::vector<std::array<std::uint8_t, Size>>& pixels_;
  GridSize size_;
  const Weights& weights_;
  std::array<float, 256> light_{};
  std::vector<int> rows_;
  std::vector<float> planes_;
};

template <std::size_t Size>
std::vector<std::array<std::uint8_t, Size>> coarser(
    const std::vector<std::array<std::uint8_t, Size>>& fine, GridSize size, double factor,
    const Transfer& transfer, const Weights& weights, int threads, const Task& task) {
  if (fine.empty()) return {};
  const GridSize out_size = RowReducer(size, factor).coarseSize();
  std::vector<std::array<std::uint8_t, Size>> out(out_size.count());
  inBands(out_size.rows, threadsFor(size.count(), threads), [&](int first, int end) {
    RowReducer reducer(size, factor);
    int most_rows = 1;
    for (int row = first; row < end; ++row) {
      const RowReducer::Rows rows = reducer.rowsFor(row);
      most_rows = std::max(most_rows, rows.end - rows.first);
    }
    LightRows<Size> light(fine, size, transfer, weights, static_cast<std::size_t>(most_rows));
    std::array<std::vector<float>, Size> sums;
    for (std::vector<float>& plane : sums) plane.resize(static_cast<std::size_t>(out_size.cols));
    for (int row = first; row < end; ++row) {
      if (row % 16 == 0) task.check();
      for (std::size_t plane = 0; plane < Size; ++plane) {
        reducer.reduce(
            row, [&](int fine_row) { return light.at(fine_row, plane); }, sums[plane].data());
      }
      auto* const pixels = &out[out_size.index({.col = 0, .row = row})];
      const std::vector<float>& share = sums[Size - 1];
      for (std::size_t i = 0; i < share.size(); ++i) {
        if (!(share[i] > 0)) continue;
        for (std::size_t k = 0; k + 1 < Size; ++k) {
          pixels[i][k] = transfer.storedOf(sums[k][i] / share[i]);
        }
        const float alpha = std::clamp(255 * share[i] + 0.5F, 1.0F, 255.0F);
        pixels[i][Size - 1] = static_cast<std::uint8_t>(alpha);
      }
    }
  });
  return out;
}

}  // namespace

std::vector<GridColours> colourLevels(GridColours&& finest, const Pyramid& pyramid, int threads,
                                      const Task& task) {
  std::vector<GridColours> levels;
  if (finest.empty()) return levels;
  levels.push_back(std::move(finest));
  Weights weights = finestWeights();
  for (std::size_t level = 1; level < pyramid.levels.size(); ++level) {
    const GridSize size = pyramid.levels[level - 1].frame.size;
    const GridColours& fine = levels.back();
    GridColours next{
        .colours = coarser(fine.colours, size, pyramid.factor, sRgb(), weights, threads, task),
        .intensities = coarser(fine.intensities, size, pyramid.factor, proportional(), weights,
                               threads, task)};
    levels.push_back(std::move(next));
    weights = coarserWeights();
  }
  return levels;
}

}  // namespace relievo
