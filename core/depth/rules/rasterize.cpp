// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/rasterize.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/depth/rules/grid_points.h"
#include "core/depth/rules/point_rule.h"
#include "core/depth/rules/triangle_rows.h"

namespace relievo {
namespace {

constexpr float kEmpty = std::numeric_limits<float>::quiet_NaN();

void drawTriangle(const GridPoint& a, const GridPoint& b, const GridPoint& c, GridSize size,
                  double spacing_mm, CapturedDepths& out) {
  const double area = doubleArea(a, b, c);
  if (std::abs(area) < kLeastDoubleArea) return;  // No surface toward the viewer.
  const TrianglePlane plane(a, b, c, area);
  const auto steep = static_cast<std::uint8_t>(plane.rise() > kSteepRise * spacing_mm ? 1 : 0);
  forEachSample(a, b, c, size, 0, size.rows, [&](int col, int row) {
    const std::size_t cell = size.index({.col = col, .row = row});
    const auto height = static_cast<float>(plane.zAt(col, row));
    if (out.front[cell] >= height) return;  // False where the cell is still NaN.
    out.front[cell] = height;
    out.steep[cell] = steep;
  });
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
