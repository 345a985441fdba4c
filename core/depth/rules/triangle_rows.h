// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/grid.h"
#include "core/depth/rules/grid_points.h"

namespace relievo {

/// The part of the line v = row that lies in the triangle; empty if low > high.
struct RowSpan {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void addEdge(const GridPoint& a, const GridPoint& b, double row) {
    const double v_low = std::min(a.v, b.v);
    const double v_high = std::max(a.v, b.v);
    if (row < v_low - kEdgeTolerance || row > v_high + kEdgeTolerance) return;
    if (v_high - v_low <= kEdgeTolerance) {
      low = std::min({low, a.u, b.u});
      high = std::max({high, a.u, b.u});
      return;
    }
    const double t = std::clamp((row - a.v) / (b.v - a.v), 0.0, 1.0);
    const double u = a.u + t * (b.u - a.u);
    low = std::min(low, u);
    high = std::max(high, u);
  }
};

/// Seen from the front: twice its area in cells, with the sign of its turn.
inline double doubleArea(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
}
inline constexpr double kLeastDoubleArea = 1e-14;  ///< Below: edge-on, no surface to be seen.

/// Calls visit(col, row) for the samples of some rows on a triangle, its edges included.
template <class Visit>
void forEachSample(const GridPoint& a, const GridPoint& b, const GridPoint& c, GridSize size,
                   int first_row, int end_row, Visit&& visit) {
  const double lowest = std::max(std::min({a.v, b.v, c.v}) - kEdgeTolerance, 0.0 + first_row);
  const double highest = std::min(std::max({a.v, b.v, c.v}) + kEdgeTolerance, end_row - 1.0);
  if (!(lowest <= highest)) return;
  const auto last = static_cast<int>(std::floor(highest));
  for (auto row = static_cast<int>(std::ceil(lowest)); row <= last; ++row) {
    RowSpan span;
    span.addEdge(a, b, row);
    span.addEdge(b, c, row);
    span.addEdge(c, a, row);
    const double low = std::max(span.low - kEdgeTolerance, 0.0);
    const double high = std::min(span.high + kEdgeTolerance, size.cols - 1.0);
    if (!(low <= high)) continue;
    for (int col = static_cast<int>(std::ceil(low)); col <= high; ++col) visit(col, row);
  }
}

/// z of the triangle's plane over a sample. Held within its corners: a needle seen almost edge-on
/// must not shoot beyond them.
class TrianglePlane {
 public:
  TrianglePlane(const GridPoint& a, const GridPoint& b, const GridPoint& c, double double_area)
      : a_(a),
        slope_u_(((b.z - a.z) * (c.v - a.v) - (c.z - a.z) * (b.v - a.v)) / double_area),
        slope_v_(((c.z - a.z) * (b.u - a.u) - (b.z - a.z) * (c.u - a.u)) / double_area),
        low_(std::min({a.z, b.z, c.z})),
        high_(std::max({a.z, b.z, c.z})) {}

  double rise() const { return std::hypot(slope_u_, slope_v_); }  ///< mm per cell.
  double zAt(int col, int row) const {
    return std::clamp(a_.z + slope_u_ * (col - a_.u) + slope_v_ * (row - a_.v), low_, high_);
  }

 private:
  GridPoint a_;
  double slope_u_, slope_v_, low_, high_;
};

}  // namespace relievo
