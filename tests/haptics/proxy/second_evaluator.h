// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/region/window.h"

namespace relievo::test {

// The surface between a window's samples once more, in long double, from the equations of
// docs/paper.md and docs/adr/0020 and from the window's own heights. Shares nothing with haptics/.

using Real = long double;

/// The sample at or below a coordinate and the part of the cell beyond it. Sample i lies at
/// (i + 1/2) cells; outside the outermost samples the surface goes on as a constant.
struct Between {
  int low = 0;
  Real part = 0;
};
inline Between between(Real along_mm, const Region& region, Real first_mm) {
  const Real at = (along_mm - first_mm) * kWindowSamples / static_cast<Real>(region.side_mm) - 0.5L;
  if (!(at > 0)) return {0, 0};
  if (at >= kWindowSamples - 1) return {kWindowSamples - 2, 1};
  const int low = static_cast<int>(std::floor(at));
  return {low, at - low};
}

inline Real sampleOf(const RegionWindow& window, int col, int row) {
  return static_cast<Real>(window.heights_mm[static_cast<std::size_t>(row) * kWindowSamples +
                                             static_cast<std::size_t>(col)]);
}

/// The paper's facets, f(x, y) in view mm.
inline Real facetHeight(const RegionWindow& window, Real x, Real y) {
  const Between col = between(x, window.region, static_cast<Real>(window.region.x_mm));
  const Between row = between(y, window.region, static_cast<Real>(window.region.y_mm));
  const auto along = [&](int r) {
    return (1 - col.part) * sampleOf(window, col.low, r) +
           col.part * sampleOf(window, col.low + 1, r);
  };
  return (1 - row.part) * along(row.low) + row.part * along(row.low + 1);
}

using RealLine = std::array<Real, kWindowSamples>;

/// Second derivatives, per cell, of the C2 cubic through equally spaced values without a knot at
/// the second and the last but one: m[i-1] + 4 m[i] + m[i+1] = 6 d[i], d the second differences,
/// and there m[0] = 2 m[1] - m[2], so that m[1] = d[1].
inline RealLine secondDerivatives(const RealLine& f) {
  constexpr int kLast = kWindowSamples - 1;
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const auto d = [&](int i) { return f[at(i - 1)] - 2 * f[at(i)] + f[at(i + 1)]; };
  RealLine m{}, upper{}, right{};
  m[1] = d(1);
  m[at(kLast - 1)] = d(kLast - 1);
  // Gaussian elimination between the two that are known.
  right[1] = m[1];
  for (int i = 2; i <= kLast - 2; ++i) {
    const Real pivot = 4 - upper[at(i - 1)];
    upper[at(i)] = 1 / pivot;
    right[at(i)] = (6 * d(i) - right[at(i - 1)]) / pivot;
  }
  for (int i = kLast - 2; i >= 2; --i) m[at(i)] = right[at(i)] - upper[at(i)] * m[at(i + 1)];
  m[0] = 2 * m[1] - m[2];
  m[at(kLast)] = 2 * m[at(kLast - 1)] - m[at(kLast - 2)];
  return m;
}

/// The cubic between two values with these second derivatives.
inline Real cubicAt(Real f0, Real f1, Real m0, Real m1, Real t) {
  return (1 - t) * f0 + t * f1 - t * (1 - t) / 6 * ((2 - t) * m0 + (1 + t) * m1);
}

/// The C2 bicubic spline: cubics along every row, and through their values at x one along y.
class SplineTruth {
 public:
  explicit SplineTruth(const RegionWindow& window) : region_(window.region) {
    for (int row = 0; row < kWindowSamples; ++row) {
      RealLine& f = rows_.emplace_back();
      for (int col = 0; col < kWindowSamples; ++col) {
        f[static_cast<std::size_t>(col)] = sampleOf(window, col, row);
      }
      bends_.push_back(secondDerivatives(f));
    }
  }
  /// f(x, y) in view mm.
  Real height(Real x, Real y) const {
    const Between col = between(x, region_, static_cast<Real>(region_.x_mm));
    const Between row = between(y, region_, static_cast<Real>(region_.y_mm));
    const auto i = static_cast<std::size_t>(col.low), j = static_cast<std::size_t>(row.low);
    RealLine g{};
    for (std::size_t r = 0; r < g.size(); ++r) {
      g[r] = cubicAt(rows_[r][i], rows_[r][i + 1], bends_[r][i], bends_[r][i + 1], col.part);
    }
    const RealLine m = secondDerivatives(g);
    return cubicAt(g[j], g[j + 1], m[j], m[j + 1], row.part);
  }

 private:
  Region region_;
  std::vector<RealLine> rows_, bends_;
};

}  // namespace relievo::test
