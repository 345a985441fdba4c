// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/depth/depth_request.h"

namespace relievo {

inline constexpr double kEdgeTolerance = 1e-7;  ///< Cells; samples on an edge belong to it.

/// A point in grid units: sample (col, row) is at u = col, v = row; z in view mm.
struct GridPoint {
  double u = 0, v = 0, z = 0;
};

/// Maps stored points (file units from the scan's origin) to grid units.
class GridFromPoint {
 public:
  explicit GridFromPoint(const DepthRequest& request)
      : m_(request.view_from_file.m),
        // The large part (UTM easting, northing) is added once, in double.
        shift_(request.view_from_file(request.scan.origin)),
        frame_(request.frame) {}

  GridPoint operator()(const std::array<float, 3>& p) const noexcept {
    const auto x = static_cast<double>(p[0]);
    const auto y = static_cast<double>(p[1]);
    const auto z = static_cast<double>(p[2]);
    const double view_x = m_[0] * x + m_[1] * y + m_[2] * z + shift_.x;
    const double view_y = m_[4] * x + m_[5] * y + m_[6] * z + shift_.y;
    return {.u = (view_x - frame_.first_x_mm) / frame_.spacing_mm,
            .v = (view_y - frame_.first_y_mm) / frame_.spacing_mm,
            .z = m_[8] * x + m_[9] * y + m_[10] * z + shift_.z};
  }

 private:
  std::array<double, 16> m_;
  ViewMm shift_;
  GridFrame frame_;
};

/// Nearest sample, with the half cell around the grid's rim included. Out of the grid: -1.
inline int nearestIndex(double u, int count) {
  const double index = u + 0.5;
  if (!(index >= 0 && index < count + 1.0)) return -1;
  const int i = static_cast<int>(index);  // Cut off, which is down: a call to floor costs more.
  // u = count - 0.5 lies on the rim itself and belongs to the last sample.
  return i == count ? (u <= count - 0.5 + kEdgeTolerance ? count - 1 : -1) : i;
}

/// Calls visit(cell index, view z) for every point on the grid, in the file's order.
/// @throw Cancelled
template <class Visit>
void forEachPoint(const DepthRequest& request, const Task& task, Visit&& visit) {
  constexpr std::size_t kCheckEvery = 1U << 16U;
  const GridFromPoint grid_from_point(request);
  const GridSize size = request.frame.size;
  const std::size_t count = request.scan.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kCheckEvery == 0) {
      task.check();
      task.report("Depth map", static_cast<double>(i) / static_cast<double>(count));
    }
    const GridPoint p = grid_from_point(request.scan.points[i]);
    const int col = nearestIndex(p.u, size.cols);
    const int row = nearestIndex(p.v, size.rows);
    if (col >= 0 && row >= 0) visit(size.index({.col = col, .row = row}), p.z);
  }
}

}  // namespace relievo
