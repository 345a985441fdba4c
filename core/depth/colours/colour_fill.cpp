// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/colour_fill.h"

#include <algorithm>

#include "core/base/bands.h"
#include "core/depth/colours/colours.h"

namespace relievo {
namespace {

constexpr int kBandRows = 256;
static_assert(kBareReach == 1 << 3 && kBandRows % kBareReach == 0);

/// Between which two coarser cells a finer one lies, and how near to the second: the coarser lie
/// at 2 c + 0.5.
struct Between {
  int low = 0, high = 0;
  float part = 0;
};
Between under(int fine, int count) {
  const double x = std::clamp((fine - 0.5) / 2, 0.0, count - 1.0);
  const int low = static_cast<int>(x);
  return {low, std::min(low + 1, count - 1), static_cast<float>(x - low)};
}

template <class Value>
Value mixed(const Value& a, const Value& b, const Value& c, const Value& d, float u, float v) {
  Value out{};
  for (std::size_t k = 0; k + 1 < out.size(); ++k) {
    out[k] += (1 - v) * (1 - u) * a[k];
    out[k] += (1 - v) * u * b[k];
    out[k] += v * (1 - u) * c[k];
    out[k] += v * u * d[k];
  }
  return out;
}

}  // namespace

ColourWish wishOf(CellStatus origin) noexcept {
  if (origin == CellStatus::interpolated) return ColourWish::always;
  return origin == CellStatus::measured || origin == CellStatus::steep ? ColourWish::near
                                                                       : ColourWish::none;
}

template <std::size_t Channels>
ColourFill<Channels>::ColourFill(GridSize size, const Transfer& transfer)
    : size_(size), transfer_(&transfer) {
  squares_.size = {.cols = (size.cols + kBareReach - 1) / kBareReach, .rows = 0};
}

/// Sums of light times weight become means, and weights at most 1.
template <std::size_t Channels>
void ColourFill<Channels>::divide(Layer& layer) {
  for (auto& cell : layer.cells) {
    if (!(cell[Channels] > 0)) continue;
    for (std::size_t k = 0; k < Channels; ++k) cell[k] /= cell[Channels];
    cell[Channels] = std::min(cell[Channels], 1.0F);
  }
}

template <std::size_t Channels>
typename ColourFill<Channels>::Layer ColourFill<Channels>::halved(const Layer& fine) {
  Layer coarse{.size = {.cols = (fine.size.cols + 1) / 2, .rows = (fine.size.rows + 1) / 2},
               .cells = {}};
  coarse.cells.resize(coarse.size.count());
  for (int row = 0; row < fine.size.rows; ++row) {
    for (int col = 0; col < fine.size.cols; ++col) {
      const auto& value = fine.cells[fine.size.index({.col = col, .row = row})];
      auto& cell = coarse.cells[coarse.size.index({.col = col / 2, .row = row / 2})];
      for (std::size_t k = 0; k < Channels; ++k) cell[k] += value[Channels] * value[k];
      cell[Channels] += value[Channels];
    }
  }
  divide(coarse);
  return coarse;
}

/// Half as many cells each way as the pixels, which begin at an even row.
template <std::size_t Channels>
typename ColourFill<Channels>::Layer ColourFill<Channels>::lightOf(const Pixel<Channels>* pixels,
                                                                   int rows) const {
  Layer light{.size = {.cols = (size_.cols + 1) / 2, .rows = (rows + 1) / 2}, .cells = {}};
  light.cells.resize(light.size.count());
  for (int row = 0; row < rows; ++row) {
    auto* const cells = &light.cells[light.size.index({.col = 0, .row = row / 2})];
    for (std::size_t col = 0; col < static_cast<std::size_t>(size_.cols); ++col) {
      const Pixel<Channels>& pixel = *pixels++;
      if (pixel[Channels] == 0) continue;
      auto& cell = cells[col / 2];
      for (std::size_t k = 0; k < Channels; ++k) {
        cell[k] += static_cast<float>(transfer_->light[pixel[k]]);
      }
      cell[Channels] += 1;
    }
  }
  divide(light);
  return light;
}

/// Cells of which nothing is known get what lies under them. The layers' first rows are those of
/// these numbers.
template <std::size_t Channels>
void ColourFill<Channels>::push(Layer& fine, int fine_row, const Layer& coarse, int coarse_row) {
  const int coarse_end = coarse_row + coarse.size.rows;
  for (int row = 0; row < fine.size.rows; ++row) {
    const Between v = under(fine_row + row, coarse_end);
    const int low = std::max(v.low - coarse_row, 0);
    const int high = std::max(v.high - coarse_row, 0);
    for (int col = 0; col < fine.size.cols; ++col) {
      auto& cell = fine.cells[fine.size.index({.col = col, .row = row})];
      if (cell[Channels] > 0) continue;
      const Between u = under(col, coarse.size.cols);
      const auto at = [&](int c, int r) -> const typename Layer::Value& {
        return coarse.cells[coarse.size.index({.col = c, .row = r})];
      };
      cell =
          mixed(at(u.low, low), at(u.high, low), at(u.low, high), at(u.high, high), u.part, v.part);
    }
  }
}

template <std::size_t Channels>
void ColourFill<Channels>::add(const Pixel<Channels>* pixels, int rows) {
  const Layer made = halved(halved(lightOf(pixels, rows)));
  squares_.cells.insert(squares_.cells.end(), made.cells.begin(), made.cells.end());
  squares_.size.rows += made.size.rows;
}

template <std::size_t Channels>
bool ColourFill<Channels>::close(const Task& task) {
  has_some_.reserve(squares_.cells.size());
  for (const auto& cell : squares_.cells) has_some_.push_back(cell[Channels] > 0 ? 1 : 0);
  std::vector<Layer> layers;
  layers.push_back(std::move(squares_));
  while (layers.back().size.cols > 1 || layers.back().size.rows > 1) {
    task.check();
    layers.push_back(halved(layers.back()));
  }
  const bool any = layers.back().cells.front()[Channels] > 0;
  for (std::size_t level = layers.size() - 1; level-- > 0;) {
    task.check();
    push(layers[level], 0, layers[level + 1], 0);
  }
  squares_ = std::move(layers.front());
  return any;
}

template <std::size_t Channels>
typename ColourFill<Channels>::Band ColourFill<Channels>::bandOf(int first,
                                                                 int rows) const noexcept {
  const int end = std::min(first + rows, size_.rows);
  const int from = std::max(0, first - kAround) / kBareReach * kBareReach;
  const int to = (end + kAround + kBareReach - 1) / kBareReach * kBareReach;
  return {.first = first, .end = end, .from = from, .to = std::min(to, size_.rows)};
}

template <std::size_t Channels>
void ColourFill<Channels>::fill(const Band& band, const Pixel<Channels>* around,
                                const std::function<ColourWish(std::size_t)>& wish,
                                Pixel<Channels>* out) const {
  // Off by one coarse row at the rim of what is given, which the rows around keep away.
  Layer twos = lightOf(around, band.to - band.from);
  Layer fours = halved(twos);
  push(fours, band.from / 4, squares_, 0);
  push(twos, band.from / 2, fours, band.from / 4);
  const int coarse_row = band.from / 2;
  for (int row = band.first; row < band.end; ++row) {
    const Between v = under(row, coarse_row + twos.size.rows);
    for (int col = 0; col < size_.cols; ++col) {
      const std::size_t i = size_.index({.col = col, .row = row - band.first});
      if (out[i][Channels] != 0) continue;
      const ColourWish wanted = wish(i);
      if (wanted == ColourWish::none) continue;
      const std::size_t square =
          squares_.size.index({.col = col / kBareReach, .row = row / kBareReach});
      if (wanted == ColourWish::near && has_some_[square] == 0) continue;
      const Between u = under(col, twos.size.cols);
      const auto at = [&](int c, int r) -> const typename Layer::Value& {
        return twos.cells[twos.size.index({.col = c, .row = r - coarse_row})];
      };
      const auto light = mixed(at(u.low, v.low), at(u.high, v.low), at(u.low, v.high),
                               at(u.high, v.high), u.part, v.part);
      for (std::size_t k = 0; k < Channels; ++k) out[i][k] = transfer_->storedOf(light[k]);
      out[i][Channels] = kBetweenAlpha;
    }
  }
}

namespace {

template <std::size_t Channels>
bool someLack(const std::vector<Pixel<Channels>>& pixels, const DepthMap& map) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i][Channels] == 0 && wishOf(map.origins[i]) != ColourWish::none) return true;
  }
  return false;
}

}  // namespace

template <std::size_t Channels>
void fillColours(std::vector<Pixel<Channels>>& pixels, const DepthMap& map,
                 const Transfer& transfer, int threads, const Task& task) {
  if (!someLack<Channels>(pixels, map)) return;
  const GridSize size = map.frame.size;
  ColourFill<Channels> fill(size, transfer);
  for (int row = 0; row < size.rows; row += kBandRows) {
    task.check();
    fill.add(&pixels[size.index({.col = 0, .row = row})], std::min(kBandRows, size.rows - row));
  }
  if (!fill.close(task)) return;
  // Bands are filled in place: what a neighbour needs of them is kept as it was.
  const int bands = (size.rows + kBandRows - 1) / kBandRows;
  const auto at = [&](int row) {
    return pixels.begin() + static_cast<std::ptrdiff_t>(size.index({.col = 0, .row = row}));
  };
  struct Rim {
    std::vector<Pixel<Channels>> below, above;
  };
  std::vector<Rim> rims(static_cast<std::size_t>(bands));
  for (int number = 0; number < bands; ++number) {
    const auto band = fill.bandOf(number * kBandRows, kBandRows);
    rims[static_cast<std::size_t>(number)] = {.below = {at(band.from), at(band.first)},
                                              .above = {at(band.end), at(band.to)}};
  }
  parallelFor(bands, std::min(bands, threadsFor(size.count(), threads)), [&](int first, int end) {
    for (int number = first; number < end; ++number) {
      task.check();
      const auto band = fill.bandOf(number * kBandRows, kBandRows);
      const Rim& rim = rims[static_cast<std::size_t>(number)];
      std::vector<Pixel<Channels>> around = rim.below;
      around.insert(around.end(), at(band.first), at(band.end));
      around.insert(around.end(), rim.above.begin(), rim.above.end());
      const std::size_t start = size.index({.col = 0, .row = band.first});
      fill.fill(
          band, around.data(), [&](std::size_t i) { return wishOf(map.origins[start + i]); },
          &pixels[start]);
    }
  });
}

void fillColours(GridColours& colours, const DepthMap& map, const Task& task) {
  fillColours<3>(colours.colours, map, sRgb(), 0, task);
  fillColours<1>(colours.intensities, map, proportional(), 0, task);
}

namespace {

template <std::size_t Size>
void coverRim(std::vector<std::array<std::uint8_t, Size>>& pixels,
              std::span<const CellStatus> origins, GridSize size) {
  if (pixels.empty()) return;
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const std::size_t i = size.index({.col = col, .row = row});
      if (origins[i] != CellStatus::outside || pixels[i][Size - 1] != 0) continue;
      for (int k = 0; k < 9; ++k) {
        const Cell beside{.col = col + k % 3 - 1, .row = row + k / 3 - 1};
        if (!size.contains(beside)) continue;
        const std::size_t from = size.index(beside);
        if (origins[from] == CellStatus::outside || pixels[from][Size - 1] == 0) continue;
        pixels[i] = pixels[from];
        break;
      }
    }
  }
}

}  // namespace

void coverRim(GridColours& colours, std::span<const CellStatus> origins, GridSize size) {
  coverRim(colours.colours, origins, size);
  coverRim(colours.intensities, origins, size);
}

template class ColourFill<3>;
template class ColourFill<1>;
template void fillColours<3>(std::vector<Pixel<3>>&, const DepthMap&, const Transfer&, int,
                             const Task&);
template void fillColours<1>(std::vector<Pixel<1>>&, const DepthMap&, const Transfer&, int,
                             const Task&);

}  // namespace relievo
