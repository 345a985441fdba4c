// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/pictures/scan_points.h"

#include <algorithm>
#include <cmath>

#include "core/prepare/normals.h"
#include "core/prepare/outliers.h"

namespace relievo {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb kStone{204, 200, 193};
constexpr int kNormalNeighbours = 12;
constexpr std::size_t kCheckEvery = 1U << 16U;

/// Where a picture's points are counted from.
FilePoint middleOf(const Scan& scan) {
  const auto& box = scan.info.bounds;
  return box ? 0.5 * (box->min + box->max) : scan.origin;
}

Point3f placed(const Scan& scan, std::size_t point, const FilePoint& origin) {
  const FilePoint d = scan.point(point) - origin;
  return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}

/// Each point's normal is that of the triangles around it, each counted by its area; and how long
/// their edges are on average.
void takeTriangles(const Scan& scan, CloudPoints& cloud, const Task& task) {
  cloud.triangles = scan.triangles;
  std::vector<FilePoint> sums(scan.points.size());
  double edges = 0;
  std::size_t done = 0;
  for (const auto& t : scan.triangles) {
    if (done++ % kCheckEvery == 0) task.check();
    const FilePoint a = scan.point(t[0]), ab = scan.point(t[1]) - a, ac = scan.point(t[2]) - a;
    const FilePoint doubled_area{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z,
                                 ab.x * ac.y - ab.y * ac.x};
    for (const std::uint32_t corner : t) sums[corner] = sums[corner] + doubled_area;
    edges += 0.5 * (norm(ab) + norm(ac));
  }
  cloud.spacing = edges / static_cast<double>(scan.triangles.size());
  cloud.normals.reserve(sums.size());
  for (const FilePoint& sum : sums) {
    const double length = norm(sum);
    const FilePoint n = length > 0 ? (1 / length) * sum : FilePoint{};
    cloud.normals.push_back(
        {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
  }
}

}  // namespace

ShownPoints shownPoints(const Scan& scan, std::size_t most, const Task& task) {
  ShownPoints shown;
  const std::size_t all = scan.points.size();
  const std::size_t count = std::min(all, std::max<std::size_t>(most, 1));
  std::vector<Point3f> points;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kCheckEvery == 0) task.check();
    const std::size_t point = i * all / count;
    shown.numbers.push_back(static_cast<std::uint32_t>(point));
    points.push_back(scan.points[point]);
  }
  const PointNeighbours neighbours(points, task);
  shown.normals = normalsOf(neighbours, points.size(), kNormalNeighbours, std::nullopt, task);
  shown.spacing = spacingOf(neighbours, task);
  return shown;
}

std::array<std::uint8_t, 3> shownColour(const Scan& scan, std::size_t point) {
  if (!scan.colours.empty() && scan.colours[point][3] != 0) {
    const Rgba& c = scan.colours[point];
    return {c[0], c[1], c[2]};
  }
  if (!scan.intensities.empty()) {
    const auto grey = static_cast<std::uint8_t>(60 + scan.intensities[point] * 180 / 65535);
    return {grey, grey, grey};
  }
  return kStone;
}

CloudPoints drawnScan(const Scan& scan, std::size_t most, const Task& task) {
  CloudPoints cloud;
  cloud.origin = middleOf(scan);
  const auto add = [&](std::size_t point) {
    if (cloud.points.size() % kCheckEvery == 0) task.check();
    cloud.points.push_back(placed(scan, point, cloud.origin));
    cloud.colours.push_back(shownColour(scan, point));
  };
  // A mesh whose corners are stored for each triangle has three points to one of them.
  const bool is_small = scan.triangles.size() <= most && scan.points.size() <= 3 * most;
  if (!scan.triangles.empty() && is_small) {
    for (std::size_t i = 0; i < scan.points.size(); ++i) add(i);
    takeTriangles(scan, cloud, task);
    return cloud;
  }
  ShownPoints shown = shownPoints(scan, most, task);
  for (const std::uint32_t point : shown.numbers) add(point);
  cloud.normals = std::move(shown.normals);
  cloud.spacing = shown.spacing;
  return cloud;
}

}  // namespace relievo
