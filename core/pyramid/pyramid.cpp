// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/pyramid.h"

#include <array>
#include <cstddef>

namespace relievo {
namespace {

constexpr std::array<double, 5> kKernel{1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16};

/// Mirrored without repeating the edge sample: -1 -> 1, n -> n - 2.
int mirrored(int i, int count) {
  if (count == 1) return 0;
  const int period = 2 * (count - 1);
  i = ((i % period) + period) % period;
  return i < count ? i : period - i;
}

GridSize halved(GridSize size) {
  return {.cols = (size.cols + 1) / 2, .rows = (size.rows + 1) / 2};
}

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
std::vector<float> reduced(const std::vector<float>& in, GridSize size, const Task& task) {
  const GridSize out_size = halved(size);
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
  Pyramid pyramid;
  pyramid.levels.push_back(baseLevel(map));
  while (pyramid.levels.back().frame.size.cols > options.coarsest_samples ||
         pyramid.levels.back().frame.size.rows > options.coarsest_samples) {
    const PyramidLevel& fine = pyramid.levels.back();
    PyramidLevel coarse;
    coarse.frame = fine.frame;
    coarse.frame.size = halved(fine.frame.size);
    coarse.frame.spacing_mm = fine.frame.spacing_mm * pyramid.factor;
    coarse.heights_mm = reduced(fine.heights_mm, fine.frame.size, task);
    coarse.measured = reduced(fine.measured, fine.frame.size, task);
    pyramid.levels.push_back(std::move(coarse));
  }
  return pyramid;
}

}  // namespace relievo
