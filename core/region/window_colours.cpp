// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/window_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/depth/colours/colour_fill.h"
#include "core/depth/colours/linear_light.h"

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

bool mayHaveColour(CellStatus origin) {
  return origin != CellStatus::base_plane && origin != CellStatus::outside;
}

template <std::size_t Size>
using Pixels = std::vector<std::array<std::uint8_t, Size>>;

/// The two rows of nodes that samples lie between, as far as a window needs them.
template <std::size_t Size>
class RowPair {
 public:
  using Pixel = std::array<std::uint8_t, Size>;
  using RowAt = std::function<const Pixel*(int row, int first_col, int count)>;
  RowPair(const RowAt& row_at, int first_col, int count)
      : row_at_(row_at), first_col_(first_col), count_(count) {}

  void load(int low, int high) {
    if (low == rows_[1].number) std::swap(rows_[0], rows_[1]);
    load(rows_[0], low);
    load(rows_[1], high);
  }
  const Pixel& at(std::size_t row, int col) const {
    return rows_[row].pixels[static_cast<std::size_t>(col - first_col_)];
  }

 private:
  struct Row {
    int number = -1;
    Pixels<Size> pixels;
  };
  void load(Row& row, int number) {
    if (row.number == number) return;
    const Pixel* const from = row_at_(number, first_col_, count_);
    row.pixels.assign(from, from + count_);
    row.number = number;
  }

  const RowAt& row_at_;
  int first_col_, count_;
  std::array<Row, 2> rows_;
};

template <std::size_t Size>
Pixels<Size> sampled(const typename RowPair<Size>::RowAt& row_at, const GridFrame& nodes,
                     const RegionWindow& window, const Transfer& transfer) {
  if (!row_at) return {};
  const double step = window.spacingMm();
  const auto columns =
      axisOf(window.region.x_mm, step, nodes.size.cols, nodes.first_x_mm, nodes.spacing_mm);
  const auto lines =
      axisOf(window.region.y_mm, step, nodes.size.rows, nodes.first_y_mm, nodes.spacing_mm);
  RowPair<Size> rows(row_at, columns.front().low, columns.back().high - columns.front().low + 1);
  Pixels<Size> out(kWindowCount);
  for (std::size_t j = 0; j < kWindowSamples; ++j) {
    const Between& v = lines[j];
    rows.load(v.low, v.high);
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      const std::size_t sample = j * kWindowSamples + i;
      if (!mayHaveColour(window.origins[sample])) continue;
      std::array<float, Size> sums{};
      const auto add = [&](int col, std::size_t row, float share) {
        const auto& pixel = rows.at(row, col);
        const float weight = share * static_cast<float>(pixel[Size - 1]);
        for (std::size_t k = 0; k + 1 < Size; ++k) {
          sums[k] += weight * static_cast<float>(transfer.light[pixel[k]]);
        }
        sums[Size - 1] += weight;
      };
      const Between& u = columns[i];
      add(u.low, 0, (1 - u.part) * (1 - v.part));
      add(u.high, 0, u.part * (1 - v.part));
      add(u.low, 1, (1 - u.part) * v.part);
      add(u.high, 1, u.part * v.part);
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

ColourNodes nodesOf(const StoredColours& level, GridSize size) {
  const auto rows = [&level, size](auto pixel) {
    return [&level, size, line = std::vector<decltype(pixel)>()](int row, int first_col,
                                                                 int count) mutable {
      line.resize(static_cast<std::size_t>(count));
      level.read(size.index({.col = first_col, .row = row}), line);
      return static_cast<const decltype(pixel)*>(line.data());
    };
  };
  ColourNodes nodes;
  if (level.hasColours()) nodes.colours = rows(Rgba{});
  if (level.hasIntensities()) nodes.intensities = rows(GreyAlpha{});
  return nodes;
}

GridColours windowColours(const ColourNodes& level, const GridFrame& nodes,
                          const RegionWindow& window, int ring) {
  GridColours made{.colours = sampled<4>(level.colours, nodes, window, sRgb()),
                   .intensities = sampled<2>(level.intensities, nodes, window, proportional())};
  coverRim(made, window.origins, {.cols = kWindowSamples, .rows = kWindowSamples});
  return {.colours = withRing(std::move(made.colours), ring),
          .intensities = withRing(std::move(made.intensities), ring)};
}

}  // namespace relievo
