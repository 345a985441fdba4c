// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace relievo {

HorizonSearch::HorizonSearch(const DepthMap& map, double radius_samples) : map_(map) {
  const int steps = std::max(1, static_cast<int>(std::floor(radius_samples)));
  for (int d = 0; d < kDirections; ++d) {
    const double angle = 2 * std::numbers::pi * d / kDirections;
    for (int k = 1; k <= steps; ++k) {
      // Rounded so that the axes' directions meet the samples themselves.
      const double x = std::round(1e9 * k * std::cos(angle)) / 1e9;
      const double y = std::round(1e9 * k * std::sin(angle)) / 1e9;
      const double col = std::floor(x);
      const double row = std::floor(y);
      rays_[static_cast<std::size_t>(d)].push_back(
          {.col = static_cast<int>(col),
           .row = static_cast<int>(row),
           .right = static_cast<float>(x - col),
           .up = static_cast<float>(y - row),
           .per_mm = static_cast<float>(1 / (k * map.frame.spacing_mm))});
    }
  }
}

HorizonSearch::Tangents HorizonSearch::tangents(Cell at) const {
  const GridSize size = map_.frame.size;
  const float here = map_.heightMm(at);
  const auto height = [&](int col, int row, float& out) {
    const Cell cell{col, row};
    if (!size.contains(cell) || map_.origin(cell) == CellStatus::outside) return false;
    out = map_.heightMm(cell);
    return true;
  };
  Tangents tangents{};
  for (std::size_t d = 0; d < rays_.size(); ++d) {
    float highest = -std::numeric_limits<float>::infinity();
    for (const Step& s : rays_[d]) {
      const int col = at.col + s.col;
      const int row = at.row + s.row;
      std::array<float, 4> h{};
      if (!height(col, row, h[0])) break;
      h[1] = h[2] = h[3] = h[0];
      if (s.right > 0 && !height(col + 1, row, h[1])) break;
      if (s.up > 0 && !height(col, row + 1, h[2])) break;
      if (s.right > 0 && s.up > 0 && !height(col + 1, row + 1, h[3])) break;
      const float lower = h[0] + s.right * (h[1] - h[0]);
      const float upper = s.right > 0 && s.up > 0 ? h[2] + s.right * (h[3] - h[2]) : h[2];
      const float z = s.up > 0 ? lower + s.up * (upper - lower) : lower;
      highest = std::max(highest, (z - here) * s.per_mm);
    }
    tangents[d] = std::isfinite(highest) ? highest : 0.0F;
  }
  return tangents;
}

double HorizonSearch::skyView(Cell at) const {
  double sum = 0;
  for (const float tangent : tangents(at)) {
    const double t = std::max(0.0, static_cast<double>(tangent));
    sum += t / std::sqrt(1 + t * t);
  }
  return 1 - sum / kDirections;
}

double HorizonSearch::openness(Cell at) const {
  double sum = 0;
  for (const float tangent : tangents(at)) sum += std::atan(static_cast<double>(tangent));
  return 90 - sum / kDirections * 180 / std::numbers::pi;
}

}  // namespace relievo
