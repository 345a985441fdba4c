// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rasterize.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/depth/grid_points.h"
#include "core/depth/point_rule.h"

namespace relievo {
namespace {

constexpr float kEmpty = std::numeric_limits<float>::quiet_NaN();

/// The part of the line v = row that lies in the triangle; empty if low > high.
struct Span {
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

void drawTriangle(const GridPoint& a, const GridPoint& b, const GridPoint& c, GridSize size,
                  double spacing_mm, CapturedDepths& out) {
  const double area = (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
  if (std::abs(area) < 1e-14) return;  // Seen edge-on: no surface toward the viewer.
  const double slope_u = ((b.z - a.z) * (c.v - a.v) - (c.z - a.z) * (b.v - a.v)) / area;
  const double slope_v = ((c.z - a.z) * (b.u - a.u) - (b.z - a.z) * (c.u - a.u)) / area;
  const auto steep =
      static_cast<std::uint8_t>(std::hypot(slope_u, slope_v) > kSteepRise * spacing_mm ? 1 : 0);
  const double z_low = std::min({a.z, b.z, c.z});
  const double z_high = std::max({a.z, b.z, c.z});
  const auto first_row =
      static_cast<int>(std::ceil(std::max(std::min({a.v, b.v, c.v}) - kEdgeTolerance, 0.0)));
  const auto last_row = static_cast<int>(
      std::floor(std::min(std::max({a.v, b.v, c.v}) + kEdgeTolerance, size.rows - 1.0)));
  for (int row = first_row; row <= last_row; ++row) {
    Span span;
    span.addEdge(a, b, row);
    span.addEdge(b, c, row);
    span.addEdge(c, a, row);
    const double low = std::max(span.low - kEdgeTolerance, 0.0);
    const double high = std::min(span.high + kEdgeTolerance, size.cols - 1.0);
    if (!(low <= high)) continue;
    for (int col = static_cast<int>(std::ceil(low)); col <= high; ++col) {
      // Clamped: a needle seen almost edge-on must not shoot beyond its own corners.
      const double z =
          std::clamp(a.z + slope_u * (col - a.u) + slope_v * (row - a.v), z_low, z_high);
      const std::size_t cell = size.index({.col = col, .row = row});
      const auto height = static_cast<float>(z);
      if (out.front[cell] >= height) continue;  // False where the cell is still NaN.
      out.front[cell] = height;
      out.steep[cell] = steep;
    }
  }
}

void drawTriangles(const DepthRequest& request, CapturedDepths& out, const Task& task) {
  const GridFromPoint grid_from_point(request);
  std::vector<GridPoint> corners;
  corners.reserve(request.scan.points.size());
  for (const auto& point : request.scan.points) corners.push_back(grid_from_point(point));
  const std::size_t count = request.scan.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 1024 == 0) {
      task.check();
      task.report("Depth map", static_cast<double>(i) / static_cast<double>(count));
    }
    const auto& t = request.scan.triangles[i];
    drawTriangle(corners[t[0]], corners[t[1]], corners[t[2]], request.frame.size,
                 request.frame.spacing_mm, out);
  }
}

}  // namespace

CapturedDepths rasterize(const DepthRequest& request, const Task& task) {
  if (request.scan.triangles.empty()) return scatterPoints(request, task);
  CapturedDepths out;
  out.front.assign(request.frame.size.count(), kEmpty);
  out.steep.assign(out.front.size(), 0);
  drawTriangles(request, out, task);
  return out;
}

}  // namespace relievo
