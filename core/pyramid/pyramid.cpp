// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/error.h"
#include "core/pyramid/kernel.h"

namespace relievo {
namespace {

constexpr std::array<double, 5> kKernel{1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16};
constexpr double kMostCellsInAll = 536'870'912;  // Twice the largest map: 4 GiB with the shares.

/// One row filtered and decimated along x.
void reduceRow(const float* in, int cols, double* out, int out_cols) {
  for (int i = 0; i < out_cols; ++i) {
    const int c = 2 * i;
    double sum = 0;
    if (c >= 2 && c + 2 < cols) {
      for (int m = 0; m < 5; ++m) {
        sum += kKernel[static_cast<std::size_t>(m)] * static_cast<double>(in[c - 2 + m]);
      }
    } else {
      for (int m = 0; m < 5; ++m) {
        sum += kKernel[static_cast<std::size_t>(m)] *
               static_cast<double>(in[mirrored(c - 2 + m, cols)]);
      }
    }
    out[i] = sum;
  }
}

/// g_l(i, j) = sum_m sum_n w(m, n) g_{l-1}(2i + m, 2j + n)   (paper, sec. 5)
/// w is separable: rows first, then columns over a ring of five reduced rows.
std::vector<float> halved(const std::vector<float>& in, GridSize size, GridSize out_size,
                          const Task& task) {
  const auto out_cols = static_cast<std::size_t>(out_size.cols);
  std::vector<float> out(out_size.count());
  std::array<std::vector<double>, 5> ring;
  std::array<int, 5> ring_row{-1, -1, -1, -1, -1};
  for (auto& line : ring) line.resize(out_cols);

  const auto reduced_row = [&](int row) -> const std::vector<double>& {
    const auto slot = static_cast<std::size_t>(row % 5);
    if (ring_row[slot] != row) {
      reduceRow(&in[size.index({.col = 0, .row = row})], size.cols, ring[slot].data(),
                out_size.cols);
      ring_row[slot] = row;
    }
    return ring[slot];
  };

  std::vector<double> sum(out_cols);
  for (int j = 0; j < out_size.rows; ++j) {
    if (j % 64 == 0) task.check();
    sum.assign(out_cols, 0.0);
    for (int n = 0; n < 5; ++n) {
      const std::vector<double>& line = reduced_row(mirrored(2 * j - 2 + n, size.rows));
      const double w = kKernel[static_cast<std::size_t>(n)];
      for (std::size_t i = 0; i < out_cols; ++i) sum[i] += w * line[i];
    }
    float* to = &out[out_size.index({.col = 0, .row = j})];
    for (std::size_t i = 0; i < out_cols; ++i) to[i] = static_cast<float>(sum[i]);
  }
  return out;
}

/// The same for any M: columns first, whole rows at a time, then along the row that is left.
std::vector<float> reducedBy(double factor, const std::vector<float>& in, GridSize size,
                             GridSize out_size, const Task& task) {
  const std::vector<Taps> rows = tapsOfAxis(size.rows, factor);
  const std::vector<Taps> cols = tapsOfAxis(size.cols, factor);
  const int before = -cols.front().first;
  const auto& end = cols.back();
  const int after = std::max(0, end.first + static_cast<int>(end.weights.size()) - size.cols);
  std::vector<double> sum(static_cast<std::size_t>(before + size.cols + after));
  std::vector<float> out(out_size.count());
  for (int j = 0; j < out_size.rows; ++j) {
    if (j % 16 == 0) task.check();
    const auto begin = sum.begin() + before;
    std::fill(begin, begin + size.cols, 0.0);
    const Taps& taps = rows[static_cast<std::size_t>(j)];
    for (std::size_t k = 0; k < taps.weights.size(); ++k) {
      const int row = mirrored(taps.first + static_cast<int>(k), size.rows);
      const float* from = &in[size.index({.col = 0, .row = row})];
      const double weight = taps.weights[k];
      for (int i = 0; i < size.cols; ++i) begin[i] += weight * static_cast<double>(from[i]);
    }
    for (int i = 1; i <= before; ++i) begin[-i] = begin[mirrored(-i, size.cols)];
    for (int i = 0; i < after; ++i)
      begin[size.cols + i] = begin[mirrored(size.cols + i, size.cols)];
    for (int i = 0; i < out_size.cols; ++i) {
      const Taps& at = cols[static_cast<std::size_t>(i)];
      double value = 0;
      for (std::size_t k = 0; k < at.weights.size(); ++k) {
        value += at.weights[k] * begin[at.first + static_cast<int>(k)];
      }
      out[out_size.index({.col = i, .row = j})] = static_cast<float>(value);
    }
  }
  return out;
}

std::vector<float> reduced(double factor, const std::vector<float>& in, GridSize size,
                           GridSize out_size, const Task& task) {
  if (factor == 2) return halved(in, size, out_size, task);
  return reducedBy(factor, in, size, out_size, task);
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
  level.measured.reserve(map.origins.size());
  for (std::size_t i = 0; i < map.origins.size(); ++i) {
    level.measured.push_back(map.origins[i] == Origin::measured ? 1.0F : 0.0F);
    // Holes and outside take part with the base plane's height, also in maps from elsewhere.
    if (map.origins[i] == Origin::base_plane || map.origins[i] == Origin::outside) {
      level.heights_mm[i] = 0;
    }
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
    coarse.heights_mm = reduced(factor, fine.heights_mm, size, coarse.frame.size, task);
    coarse.measured = reduced(factor, fine.measured, size, coarse.frame.size, task);
    pyramid.levels.push_back(std::move(coarse));
  }
  return pyramid;
}

}  // namespace relievo
