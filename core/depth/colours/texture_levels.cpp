// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/texture_levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/depth/colours/linear_light.h"

namespace relievo {
namespace {

constexpr double kSameFineness =
    1e-3;  // Levels; eight texels a sample are level 3 but for rounding.

/// Mean of up to four texels in linear light; those without colour do not count.
Rgba meanOf(const std::array<Rgba, 4>& texels) {
  const Transfer& transfer = sRgb();
  std::array<std::uint32_t, 3> sums{};
  std::uint32_t count = 0;
  for (const Rgba& texel : texels) {
    if (texel[3] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) sums[k] += transfer.light[texel[k]];
    ++count;
  }
  if (count == 0) return {};
  Rgba mean{0, 0, 0, 255};
  for (std::size_t k = 0; k < 3; ++k) mean[k] = transfer.stored[(sums[k] + count / 2) / count];
  return mean;
}

}  // namespace

TextureLevels::TextureLevels(const Texture& texture, const Task& task) {
  const std::size_t count = std::size_t{texture.cols} * texture.rows;
  if (count == 0 || texture.texels.size() != count) return;
  levels_.push_back({texture.cols, texture.rows, texture.texels.data()});
  while (levels_.back().cols > 1 || levels_.back().rows > 1) {
    const Level fine = levels_.back();
    Level coarse{(fine.cols + 1) / 2, (fine.rows + 1) / 2, nullptr};
    std::vector<Rgba>& texels = coarser_.emplace_back();
    texels.reserve(std::size_t{coarse.cols} * coarse.rows);
    for (std::uint32_t row = 0; row < coarse.rows; ++row) {
      if (row % 64 == 0) task.check();
      const Rgba* const low = fine.texels + std::size_t{2 * row} * fine.cols;
      const Rgba* const high = 2 * row + 1 < fine.rows ? low + fine.cols : low;
      for (std::uint32_t col = 0; col < coarse.cols; ++col) {
        const std::size_t left = std::size_t{2} * col;
        const std::size_t right = std::min<std::size_t>(left + 1, fine.cols - 1);
        texels.push_back(meanOf({low[left], low[right], high[left], high[right]}));
      }
    }
    coarse.texels = texels.data();
    levels_.push_back(coarse);
  }
}

std::optional<std::array<float, 3>> TextureLevels::at(double u, double v, double texels) const {
  if (levels_.empty() || !std::isfinite(u) || !std::isfinite(v)) return std::nullopt;
  const double wanted = texels > 1 ? std::ceil(std::log2(texels) - kSameFineness) : 0;
  const auto most = static_cast<double>(levels_.size() - 1);
  const Level& level = levels_[static_cast<std::size_t>(std::min(wanted, most))];
  struct Place {
    std::size_t low = 0, high = 0;
    float part = 0;
  };
  // Between the middles of texels; beyond the outermost their colour continues.
  const auto place = [](double t, std::uint32_t count) {
    const double x = std::clamp(t * count - 0.5, 0.0, count - 1.0);
    const auto low = static_cast<std::size_t>(x);
    return Place{low, std::min<std::size_t>(low + 1, count - 1),
                 static_cast<float>(x - static_cast<double>(low))};
  };
  const auto repeated = [](double t) { return t >= 0 && t <= 1 ? t : t - std::floor(t); };
  const Place col = place(repeated(u), level.cols);
  const Place row = place(1 - repeated(v), level.rows);  // Rows begin at the top.
  const Transfer& transfer = sRgb();
  std::array<float, 3> sums{};
  float weights = 0;
  const auto add = [&](std::size_t c, std::size_t r, float weight) {
    const Rgba& texel = level.texels[r * level.cols + c];
    if (texel[3] == 0) return;
    for (std::size_t k = 0; k < 3; ++k) {
      sums[k] += weight * static_cast<float>(transfer.light[texel[k]]);
    }
    weights += weight;
  };
  add(col.low, row.low, (1 - col.part) * (1 - row.part));
  add(col.high, row.low, col.part * (1 - row.part));
  add(col.low, row.high, (1 - col.part) * row.part);
  add(col.high, row.high, col.part * row.part);
  if (!(weights > 0)) return std::nullopt;
  for (float& sum : sums) sum /= weights;
  return sums;
}

}  // namespace relievo
