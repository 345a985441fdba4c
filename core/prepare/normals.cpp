// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/normals.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace relievo {
namespace {

constexpr double kFlat = 1e-10;  ///< Share of the longest axis that makes a second one.

Eigen::Vector3d vectorOf(const Point3f& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// @return  zero if the places lie on a line
Eigen::Vector3d normalAt(const PointNeighbours& neighbours, const NearPlaces& near) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::uint32_t place : near.places) middle += vectorOf(neighbours.place(place));
  middle /= static_cast<double>(near.places.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const std::uint32_t place : near.places) {
    const Eigen::Vector3d d = vectorOf(neighbours.place(place)) - middle;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Eigen::Vector3d& lengths = axes.eigenvalues();
  if (!(lengths[1] > kFlat * lengths[2])) return Eigen::Vector3d::Zero();
  return axes.eigenvectors().col(0);
}

}  // namespace

std::vector<Point3f> normalsOf(const PointNeighbours& neighbours, std::size_t points, int count,
                               const std::optional<Point3f>& viewpoint, const Task& task) {
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < neighbours.places(); ++i) inside += vectorOf(neighbours.place(i));
  if (neighbours.places() > 0) inside /= static_cast<double>(neighbours.places());
  std::vector<Point3f> normals(points);
  neighbours.nearest(count, 0, task, [&](const NearPlaces& near) {
    Eigen::Vector3d normal = normalAt(neighbours, near);
    const Eigen::Vector3d place = vectorOf(neighbours.place(near.of));
    const Eigen::Vector3d outward =
        viewpoint ? Eigen::Vector3d(vectorOf(*viewpoint) - place) : Eigen::Vector3d(place - inside);
    if (normal.dot(outward) < 0) normal = -normal;
    const Point3f stored{static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                         static_cast<float>(normal.z())};
    for (const std::uint32_t point : neighbours.pointsAt(near.of)) normals[point] = stored;
  });
  return normals;
}

}  // namespace relievo
