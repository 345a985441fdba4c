// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/base/bands.h"
#include "core/base/error.h"
#include "core/pyramid/halve.h"
#include "core/pyramid/kernel.h"

namespace relievo {
namespace {

constexpr double kMostCellsInAll = 536'870'912;  // Twice the largest map: 4 GiB with the shares.

void sumRows(const Taps& taps, const std::vector<float>& in, GridSize size, double* out) {
  std::fill(out, out + size.cols, 0.0);
  for (std::size_t k = 0; k < taps.weights.size(); ++k) {
    const int row = mirrored(taps.first + static_cast<int>(k), size.rows);
    const float* from = &in[size.index({.col = 0, .row = row})];
    const double weight = taps.weights[k];
    for (int i = 0; i < size.cols; ++i) out[i] += weight * static_cast<double>(from[i]);
  }
}

/// The paper's equation (sec. 5) for any M. The kernel is separable: first down the columns, whole
/// rows at a time, then along the one row that is left.
std::vector<float> reducedBy(const PyramidOptions& options, const std::vector<float>& in,
                             GridSize size, GridSize out_size, const Task& task) {
  const std::vector<Taps> rows = tapsOfAxis(size.rows, options.factor);
  const std::vector<Taps> cols = tapsOfAxis(size.cols, options.factor);
  const int before = -cols.front().first;
  const Taps& end = cols.back();
  const int after = std::max(0, end.first + static_cast<int>(end.weights.size()) - size.cols);
  std::vector<float> out(out_size.count());
  inBands(out_size.rows, threadsFor(size.count(), options.threads), [&](int first, int last) {
    std::vector<double> padded(static_cast<std::size_t>(before + size.cols + after));
    double* sum = padded.data() + before;
    for (int j = first; j < last; ++j) {
      if (j % 16 == 0) task.check();
      sumRows(rows[static_cast<std::size_t>(j)], in, size, sum);
      for (int i = 1; i <= before; ++i) sum[-i] = sum[mirrored(-i, size.cols)];
      for (int i = size.cols; i < size.cols + after; ++i) sum[i] = sum[mirrored(i, size.cols)];
      for (int i = 0; i < out_size.cols; ++i) {
        const Taps& at = cols[static_cast<std::size_t>(i)];
        const double value =
            std::inner_product(at.weights.begin(), at.weights.end(), sum + at.first, 0.0);
        out[out_size.index({.col = i, .row = j})] = static_cast<float>(value);
      }
    }
  });
  return out;
}

std::vector<float> reduced(const PyramidOptions& options, const std::vector<float>& in,
                           GridSize size, GridSize out_size, const Task& task) {
  if (options.factor == 2) return halved(in, size, out_size, options.threads, task);
  return reducedBy(options, in, size, out_size, task);
}

GridSize reducedSize(GridSize size, double factor) {
  return {.cols = reducedCount(size.cols, factor), .rows = reducedCount(size.rows, factor)};
}

bool isCoarsest(GridSize size, const PyramidOptions& options) {
  return size.cols <= options.coarsest_samples && size.rows <= options.coarsest_samples;
}

/// @throw ArgumentError
void requireFactor(GridSize size, const PyramidOptions& options) {
  if (!(options.factor > 1) || !(options.factor <= kMostFactor)) {
    throw ArgumentError(
        "The pyramid's factor M must be above 1 and at most 8. Nothing was made; 2 is the "
        "paper's.");
  }
  auto cells = static_cast<double>(size.count());
  for (; !isCoarsest(size, options); cells += static_cast<double>(size.count())) {
    size = reducedSize(size, options.factor);
    if (cells > kMostCellsInAll) {
      throw ArgumentError(
          "The pyramid's factor M is so near to 1 that its levels do not fit into memory. Nothing "
          "was made; choose a larger one.");
    }
  }
}

PyramidLevel baseLevel(const DepthMap& map) {
  PyramidLevel level{.frame = map.frame, .heights_mm = map.heights_mm, .measured = {}};
  level.measured.resize(map.origins.size());
  for (std::size_t i = 0; i < map.origins.size(); ++i) {
    const Origin origin = map.origins[i];
    level.measured[i] = origin == Origin::measured ? 1.0F : 0.0F;
    // Holes and outside take part with the base plane's height, also in maps from elsewhere.
    const bool on_base = origin == Origin::base_plane || origin == Origin::outside;
    level.heights_mm[i] = on_base ? 0.0F : level.heights_mm[i];
  }
  return level;
}

}  // namespace

Pyramid buildPyramid(const DepthMap& map, const PyramidOptions& options, const Task& task) {
  const double factor = options.factor;
  requireFactor(map.frame.size, options);
  Pyramid pyramid{.factor = factor, .levels = {}};
  pyramid.levels.push_back(baseLevel(map));
  while (!isCoarsest(pyramid.levels.back().frame.size, options)) {
    const PyramidLevel& fine = pyramid.levels.back();
    const GridSize size = fine.frame.size;
    PyramidLevel coarse;
    coarse.frame = fine.frame;
    coarse.frame.size = reducedSize(size, factor);
    coarse.frame.spacing_mm =
        map.frame.spacing_mm * std::pow(factor, static_cast<double>(pyramid.levels.size()));
    coarse.heights_mm = reduced(options, fine.heights_mm, size, coarse.frame.size, task);
    coarse.measured = reduced(options, fine.measured, size, coarse.frame.size, task);
    pyramid.levels.push_back(std::move(coarse));
  }
  return pyramid;
}

}  // namespace relievo
