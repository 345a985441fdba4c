// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/losses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/depth/rules/grid_points.h"

namespace relievo {
namespace {

/// What lies hidden below one cell.
struct Behind {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
};

class HiddenCounter {
 public:
  HiddenCounter(const DepthRequest& request, const FrontDepths& front)
      : size_(request.frame.size),
        limit_(static_cast<float>(kHiddenCells * request.frame.spacing_mm)),
        front_(front),
        behind_(front.size()) {}

  void add(const GridPoint& p, double amount) {
    const int col = nearestIndex(p.u, size_.cols);
    const int row = nearestIndex(p.v, size_.rows);
    if (col < 0 || row < 0) return;
    const std::size_t cell = size_.index({.col = col, .row = row});
    found_.all += amount;
    const auto z = static_cast<float>(p.z);
    if (!(z < front_[cell] - limit_)) return;  // Also where nothing is in front.
    found_.hidden += amount;
    behind_[cell].low = std::min(behind_[cell].low, z);
    behind_[cell].high = std::max(behind_[cell].high, z);
  }

  HiddenSurface result() const {
    HiddenSurface found = found_;
    for (const Behind& behind : behind_) {
      if (behind.low > behind.high) continue;
      ++found.cells;
      found.cells_in_layers += behind.high - behind.low > limit_ ? 1 : 0;
    }
    return found;
  }

 private:
  GridSize size_;
  float limit_;
  const FrontDepths& front_;
  std::vector<Behind> behind_;
  HiddenSurface found_;
};

void addTriangles(const DepthRequest& request, HiddenCounter& counter, const Task& task) {
  const GridFromPoint grid_from_point(request);
  const double spacing = request.frame.spacing_mm;
  for (std::size_t i = 0; i < request.scan.triangles.size(); ++i) {
    if (i % (1U << 16U) == 0) task.check();
    const auto& t = request.scan.triangles[i];
    const GridPoint a = grid_from_point(request.scan.points[t[0]]);
    const GridPoint b = grid_from_point(request.scan.points[t[1]]);
    const GridPoint c = grid_from_point(request.scan.points[t[2]]);
    const double ux = (b.u - a.u) * spacing;
    const double uy = (b.v - a.v) * spacing;
    const double uz = b.z - a.z;
    const double vx = (c.u - a.u) * spacing;
    const double vy = (c.v - a.v) * spacing;
    const double vz = c.z - a.z;
    const double area = 0.5 * std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
    counter.add(
        {.u = (a.u + b.u + c.u) / 3, .v = (a.v + b.v + c.v) / 3, .z = (a.z + b.z + c.z) / 3}, area);
  }
}

}  // namespace

HiddenSurface countHidden(const DepthRequest& request, const FrontDepths& front, const Task& task) {
  HiddenCounter counter(request, front);
  if (!request.scan.triangles.empty()) {
    addTriangles(request, counter, task);
    return counter.result();
  }
  const GridFromPoint grid_from_point(request);
  for (std::size_t i = 0; i < request.scan.points.size(); ++i) {
    if (i % (1U << 16U) == 0) task.check();
    counter.add(grid_from_point(request.scan.points[i]), 1);
  }
  return counter.result();
}

DepthLosses lossesOf(const HiddenSurface& hidden, std::size_t outliers,
                     std::size_t seen_through_points, const OriginCounts& cells) {
  DepthLosses losses{.outliers = outliers};
  if (hidden.all > 0) {
    losses.hidden_share = (hidden.hidden + static_cast<double>(seen_through_points)) / hidden.all;
  }
  const auto all = std::accumulate(cells.begin(), cells.end(), std::size_t{0});
  const auto inside =
      static_cast<double>(all - cells[static_cast<std::size_t>(CellStatus::outside)]);
  if (inside == 0) return losses;
  const std::size_t steep = cells[static_cast<std::size_t>(CellStatus::steep)];
  losses.steep_share = static_cast<double>(steep) / inside;
  // Behind most cells of a body lies its back, which is no undercut; there only more layers are.
  const bool has_back = 2 * static_cast<double>(hidden.cells) > inside;
  losses.undercut_share =
      static_cast<double>(has_back ? hidden.cells_in_layers : hidden.cells) / inside;
  return losses;
}

}  // namespace relievo
