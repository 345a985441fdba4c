// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/prepare/align/align_cloud.h"
#include "core/prepare/align/align_math.h"
#include "tests/core/prepare/align_objects.h"

namespace relievo::test {

/// How near the best of all methods comes on average: the Cramer-Rao bound of the part's pose, from
/// independent noise along the surface's normals on all points of what both parts have in common,
/// over surfaces that are known exactly but for it. Points of the finer part around one of the
/// coarser count as its noise divided by their number.
/// @param part  the coarser of the two  @param noise_mm  standard deviation
/// @return  root mean squares, of the turn and of the shift in the middle of the part
inline PoseError poseBound(const MadeObject& object, const Part& part, const Part& finer,
                           double noise_mm) {
  const auto onObject = [](const Part& p) {
    std::vector<Point3f> points;
    for (const auto& q : p.points) {
      const FilePoint at = p.object_from_part(p.origin + FilePoint{static_cast<double>(q[0]),
                                                                   static_cast<double>(q[1]),
                                                                   static_cast<double>(q[2])});
      points.push_back(
          {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
    }
    return points;
  };
  const std::vector<Point3f> points = onObject(part);
  const PointNeighbours own(points), others(onObject(finer));
  constexpr int kNear = 16;
  const auto farthest = [&](const PointNeighbours& among) {
    std::vector<double> squared(points.size());
    among.nearestTo(points, kNear, 0, {}, [&](const NearPlaces& near) {
      squared[near.of] = static_cast<double>(near.squared.back());
    });
    return squared;
  };
  const std::vector<double> around = farthest(own), beside = farthest(others);
  // Normals of the surface itself, at points without noise.
  const std::vector<Point3f> clean = onObject(makePart(object, {{}, 300'000, 0, {}, {}, 77}));
  const std::vector<Point3f> normals =
      align::normalsOf(points, clean, 3 * std::sqrt(object.diagonal * object.diagonal / 300'000.0));
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Point3f& p : points) middle += align::vector(p) / static_cast<double>(points.size());
  Eigen::Matrix<double, 6, 6> known = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d normal = align::vector(normals[i]);
    // Where the other part is not, its points are far beyond those of this one.
    if (!normal.allFinite() || beside[i] > 2 * around[i]) continue;
    Eigen::Matrix<double, 6, 1> row;
    row << (align::vector(points[i]) - middle).cross(normal), normal;
    known += row * row.transpose() / (noise_mm * noise_mm * (1 + beside[i] / around[i]));
  }
  const Eigen::Matrix<double, 6, 6> spread = known.inverse();
  return {std::sqrt(spread.topLeftCorner<3, 3>().trace()) * 180 / std::numbers::pi,
          std::sqrt(spread.bottomRightCorner<3, 3>().trace())};
}

}  // namespace relievo::test
