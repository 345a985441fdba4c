// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colour_fill.h"

#include <algorithm>

#include "core/depth/colours.h"

namespace relievo {
namespace {

/// Cells half as many each way: means of light, and in the last channel how much is known.
template <std::size_t Channels>
struct Layer {
  using Value = std::array<float, Channels + 1>;
  GridSize size;
  std::vector<Value> cells;

  explicit Layer(GridSize fine)
      : size{.cols = (fine.cols + 1) / 2, .rows = (fine.rows + 1) / 2},
        cells(size.count(), Value{}) {}

  void add(Cell fine, const Value& value) {
    Value& cell = cells[size.index({.col = fine.col / 2, .row = fine.row / 2})];
    for (std::size_t k = 0; k < Channels; ++k) cell[k] += value[Channels] * value[k];
    cell[Channels] += value[Channels];
  }
  void finish() {
    for (Value& cell : cells) {
      if (!(cell[Channels] > 0)) continue;
      for (std::size_t k = 0; k < Channels; ++k) cell[k] /= cell[Channels];
      cell[Channels] = std::min(cell[Channels], 1.0F);
    }
  }

  /// Bilinear under a finer cell; that lies at (f - 0.5) / 2.
  Value under(Cell fine) const {
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
    const float u = split(fine.col, size.cols, c0, c1);
    const float v = split(fine.row, size.rows, r0, r1);
    Value out{};
    const auto add = [&](int col, int row, float weight) {
      const Value& cell = cells[size.index({.col = col, .row = row})];
      for (std::size_t k = 0; k < Channels; ++k) out[k] += weight * cell[k];
    };
    add(c0, r0, (1 - v) * (1 - u));
    add(c1, r0, (1 - v) * u);
    add(c0, r1, v * (1 - u));
    add(c1, r1, v * u);
    return out;
  }
};

template <std::size_t Channels>
std::vector<Layer<Channels>> pulledLayers(const std::vector<Pixel<Channels>>& pixels, GridSize size,
                                          const Transfer& transfer, const Task& task) {
  std::vector<Layer<Channels>> layers;
  layers.emplace_back(size);
  for (int row = 0; row < size.rows; ++row) {
    if (row % 64 == 0) task.check();
    for (int col = 0; col < size.cols; ++col) {
      const Pixel<Channels>& pixel = pixels[size.index({.col = col, .row = row})];
      if (pixel[Channels] == 0) continue;
      typename Layer<Channels>::Value value{};
      for (std::size_t k = 0; k < Channels; ++k) {
        value[k] = static_cast<float>(transfer.light[pixel[k]]);
      }
      value[Channels] = 1;
      layers.front().add({.col = col, .row = row}, value);
    }
  }
  layers.front().finish();
  while (layers.back().size.cols > 1 || layers.back().size.rows > 1) {
    task.check();
    const Layer<Channels>& fine = layers.back();
    Layer<Channels> coarse(fine.size);
    for (int row = 0; row < fine.size.rows; ++row) {
      for (int col = 0; col < fine.size.cols; ++col) {
        const Cell cell{.col = col, .row = row};
        coarse.add(cell, fine.cells[fine.size.index(cell)]);
      }
    }
    coarse.finish();
    layers.push_back(std::move(coarse));
  }
  return layers;
}

template <std::size_t Channels>
void pushDown(std::vector<Layer<Channels>>& layers, const Task& task) {
  for (std::size_t level = layers.size() - 1; level-- > 0;) {
    task.check();
    Layer<Channels>& fine = layers[level];
    for (int row = 0; row < fine.size.rows; ++row) {
      for (int col = 0; col < fine.size.cols; ++col) {
        const Cell at{.col = col, .row = row};
        auto& cell = fine.cells[fine.size.index(at)];
        const float known = cell[Channels];
        if (known >= 1) continue;
        const auto coarse = layers[level + 1].under(at);
        for (std::size_t k = 0; k < Channels; ++k) {
          cell[k] = known * cell[k] + (1 - known) * coarse[k];
        }
      }
    }
  }
}

enum class Wish { none, near, always };
Wish wishOf(Origin origin) {
  if (origin == Origin::interpolated) return Wish::always;
  return origin == Origin::measured || origin == Origin::steep ? Wish::near : Wish::none;
}

}  // namespace

template <std::size_t Channels>
void fillColours(std::vector<Pixel<Channels>>& pixels, const DepthMap& map,
                 const Transfer& transfer, const Task& task) {
  bool some_lack = false;
  for (std::size_t i = 0; i < pixels.size() && !some_lack; ++i) {
    some_lack = pixels[i][Channels] == 0 && wishOf(map.origins[i]) != Wish::none;
  }
  if (!some_lack) return;
  const GridSize size = map.frame.size;
  std::vector<Layer<Channels>> layers = pulledLayers<Channels>(pixels, size, transfer, task);
  if (!(layers.back().cells.front()[Channels] > 0)) return;  // No colour anywhere.
  static_assert(kBareReach == 2 << 2);
  const std::size_t near_layer = std::min<std::size_t>(2, layers.size() - 1);
  pushDown(layers, task);  // Leaves the weights as they are.
  const Layer<Channels>& near = layers[near_layer];
  for (int row = 0; row < size.rows; ++row) {
    if (row % 64 == 0) task.check();
    for (int col = 0; col < size.cols; ++col) {
      const Cell at{.col = col, .row = row};
      const std::size_t i = size.index(at);
      Pixel<Channels>& pixel = pixels[i];
      const Wish wish = wishOf(map.origins[i]);
      if (pixel[Channels] != 0 || wish == Wish::none) continue;
      const Cell square{.col = std::min(col / kBareReach, near.size.cols - 1),
                        .row = std::min(row / kBareReach, near.size.rows - 1)};
      const bool is_near = near.cells[near.size.index(square)][Channels] > 0;
      if (wish == Wish::near && !is_near) continue;
      const auto light = layers.front().under(at);
      for (std::size_t k = 0; k < Channels; ++k) pixel[k] = transfer.storedOf(light[k]);
      pixel[Channels] = kBetweenAlpha;
    }
  }
}

void fillColours(GridColours& colours, const DepthMap& map, const Task& task) {
  fillColours<3>(colours.colours, map, sRgb(), task);
  fillColours<1>(colours.intensities, map, proportional(), task);
}

namespace {

template <std::size_t Size>
void coverRim(std::vector<std::array<std::uint8_t, Size>>& pixels, std::span<const Origin> origins,
              GridSize size) {
  if (pixels.empty()) return;
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const std::size_t i = size.index({.col = col, .row = row});
      if (origins[i] != Origin::outside || pixels[i][Size - 1] != 0) continue;
      for (int k = 0; k < 9; ++k) {
        const Cell beside{.col = col + k % 3 - 1, .row = row + k / 3 - 1};
        if (!size.contains(beside)) continue;
        const std::size_t from = size.index(beside);
        if (origins[from] == Origin::outside || pixels[from][Size - 1] == 0) continue;
        pixels[i] = pixels[from];
        break;
      }
    }
  }
}

}  // namespace

void coverRim(GridColours& colours, std::span<const Origin> origins, GridSize size) {
  coverRim(colours.colours, origins, size);
  coverRim(colours.intensities, origins, size);
}

template void fillColours<3>(std::vector<Pixel<3>>&, const DepthMap&, const Transfer&, const Task&);
template void fillColours<1>(std::vector<Pixel<1>>&, const DepthMap&, const Transfer&, const Task&);

}  // namespace relievo
