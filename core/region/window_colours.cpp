// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/window_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/error.h"
#include "core/depth/colour_fill.h"
#include "core/depth/linear_light.h"

namespace relievo {
namespace {

/// Between which two nodes a sample lies along one axis.
struct Between {
  int low = 0, high = 0;
  float part = 0;
};

std::array<Between, kWindowSamples> axisOf(double start_mm, double step_mm, int nodes,
                                           double first_mm, double spacing_mm) {
  std::array<Between, kWindowSamples> axis;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const double at = start_mm + (static_cast<double>(i) + 0.5) * step_mm;
    const double index = std::clamp((at - first_mm) / spacing_mm, 0.0, nodes - 1.0);
    const int low = static_cast<int>(index);
    axis[i] = {low, std::min(low + 1, nodes - 1), static_cast<float>(index - low)};
  }
  return axis;
}

bool mayHaveColour(Origin origin) {
  return origin != Origin::base_plane && origin != Origin::outside;
}

template <std::size_t Size>
using Pixels = std::vector<std::array<std::uint8_t, Size>>;

template <std::size_t Size>
Pixels<Size> sampled(const Pixels<Size>& level, const GridFrame& nodes, const RegionWindow& window,
                     const Transfer& transfer) {
  if (level.empty()) return {};
  const double step = window.spacingMm();
  const auto columns =
      axisOf(window.region.x_mm, step, nodes.size.cols, nodes.first_x_mm, nodes.spacing_mm);
  const auto lines =
      axisOf(window.region.y_mm, step, nodes.size.rows, nodes.first_y_mm, nodes.spacing_mm);
  Pixels<Size> out(kWindowCount);
  for (std::size_t j = 0; j < kWindowSamples; ++j) {
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      const std::size_t sample = j * kWindowSamples + i;
      if (!mayHaveColour(window.origins[sample])) continue;
      std::array<float, Size> sums{};
      const auto add = [&](int col, int row, float share) {
        const auto& pixel = level[nodes.size.index({.col = col, .row = row})];
        const float weight = share * static_cast<float>(pixel[Size - 1]);
        for (std::size_t k = 0; k + 1 < Size; ++k) {
          sums[k] += weight * static_cast<float>(transfer.light[pixel[k]]);
        }
        sums[Size - 1] += weight;
      };
      const Between& u = columns[i];
      const Between& v = lines[j];
      add(u.low, v.low, (1 - u.part) * (1 - v.part));
      add(u.high, v.low, u.part * (1 - v.part));
      add(u.low, v.high, (1 - u.part) * v.part);
      add(u.high, v.high, u.part * v.part);
      const float alpha = sums[Size - 1];
      if (!(alpha > 0)) continue;
      for (std::size_t k = 0; k + 1 < Size; ++k) {
        out[sample][k] = transfer.storedOf(sums[k] / alpha);
      }
      out[sample][Size - 1] = static_cast<std::uint8_t>(std::clamp(alpha + 0.5F, 1.0F, 255.0F));
    }
  }
  return out;
}

template <std::size_t Size>
Pixels<Size> withRing(Pixels<Size> inner, int ring) {
  if (ring == 0 || inner.empty()) return inner;
  const int across = kWindowSamples + 2 * ring;
  const auto inside = [ring](int i) {
    return static_cast<std::size_t>(std::clamp(i - ring, 0, kWindowSamples - 1));
  };
  Pixels<Size> out;
  out.reserve(static_cast<std::size_t>(across) * static_cast<std::size_t>(across));
  for (int row = 0; row < across; ++row) {
    for (int col = 0; col < across; ++col) {
      out.push_back(inner[inside(row) * kWindowSamples + inside(col)]);
    }
  }
  return out;
}

}  // namespace

GridColours windowColours(const std::vector<GridColours>& levels, const GridFrame& nodes,
                          const RegionWindow& window, int ring) {
  if (levels.empty()) return {};
  const int level = window.region.level.value;
  if (level < 0 || level >= static_cast<int>(levels.size())) {
    throw ArgumentError("The region names a level that the pyramid does not have.");
  }
  const GridColours& from = levels[static_cast<std::size_t>(level)];
  GridColours made{.colours = sampled(from.colours, nodes, window, sRgb()),
                   .intensities = sampled(from.intensities, nodes, window, proportional())};
  coverRim(made, window.origins, {.cols = kWindowSamples, .rows = kWindowSamples});
  return {.colours = withRing(std::move(made.colours), ring),
          .intensities = withRing(std::move(made.intensities), ring)};
}

}  // namespace relievo
