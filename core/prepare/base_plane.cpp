// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/base_plane.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <cmath>
#include <random>
#include <utility>

#include <Eigen/Eigenvalues>

namespace relievo {
namespace {

constexpr int kMostTries = 1000;
constexpr double kCertainty = 0.999;

/// PCL draws its samples from the front of this list by a generator of its own, always the same.
/// Another order is another draw; the first seed keeps the order, in which memory is read fastest.
pcl::IndicesPtr orderOf(std::size_t points, std::uint32_t seed) {
  auto order = std::make_shared<pcl::Indices>(points);
  for (std::size_t i = 0; i < points; ++i) (*order)[i] = static_cast<pcl::index_t>(i);
  if (seed == Base{}.seed) return order;
  std::mt19937_64 random(seed);
  for (std::size_t i = points; i > 1; --i) std::swap((*order)[i - 1], (*order)[random() % i]);
  return order;
}

Eigen::Vector3d vectorOf(const Point3f& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

struct Fit {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(), middle = Eigen::Vector3d::Zero();
};

template <class Numbers>
Fit fitted(std::span<const Point3f> points, const Numbers& numbers) {
  Fit fit;
  for (const auto i : numbers) fit.middle += vectorOf(points[static_cast<std::size_t>(i)]);
  fit.middle /= static_cast<double>(numbers.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto i : numbers) {
    const Eigen::Vector3d d = vectorOf(points[static_cast<std::size_t>(i)]) - fit.middle;
    spread += d * d.transpose();
  }
  // Ascending: the first axis is the one along which they are thinnest.
  fit.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return fit;
}

}  // namespace

std::optional<BasePlane> basePlane(std::span<const Point3f> points, double distance,
                                   std::uint32_t seed, const Task& task) {
  if (points.size() < 3) return std::nullopt;
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const Point3f& p : points) cloud->emplace_back(p[0], p[1], p[2]);
  task.check();
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setMaxIterations(kMostTries);
  segmentation.setProbability(kCertainty);
  segmentation.setDistanceThreshold(distance);
  segmentation.setNumberOfThreads(1);  // With more the plane depends on who is first.
  segmentation.setOptimizeCoefficients(false);
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(orderOf(points.size(), seed));
  pcl::ModelCoefficients coefficients;
  pcl::PointIndices inliers;
  segmentation.segment(inliers, coefficients);
  if (inliers.indices.size() < 3) return std::nullopt;
  task.check();

  Fit fit = fitted(points, inliers.indices);
  if (!fit.normal.allFinite()) return std::nullopt;
  BasePlane plane;
  std::size_t above = 0;
  std::size_t below = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double height = fit.normal.dot(vectorOf(points[i]) - fit.middle);
    if (std::abs(height) <= distance) {
      plane.on_it.push_back(static_cast<std::uint32_t>(i));
    } else {
      ++(height > 0 ? above : below);
    }
  }
  // A plane with nothing beside it keeps the side that is up in the file.
  if (below > above || (below == above && fit.normal.z() < 0)) fit.normal = -fit.normal;
  for (int axis = 0; axis < 3; ++axis) {
    plane.normal[static_cast<std::size_t>(axis)] = fit.normal[axis];
    plane.middle[static_cast<std::size_t>(axis)] = fit.middle[axis];
  }
  return plane;
}

Pose layingFlat(const BasePlane& plane, const FilePoint& centre) {
  const auto& n = plane.normal;
  // Rodrigues: from n to (0, 0, 1) about n x z; upside down about x.
  Rotation r{1, 0, 0, 0, -1, 0, 0, 0, -1};
  if (n[2] > -1 + 1e-12) {
    const double h = 1 / (1 + n[2]);
    r = {1 - h * n[0] * n[0],
         -h * n[0] * n[1],
         -n[0],
         -h * n[0] * n[1],
         1 - h * n[1] * n[1],
         -n[1],
         n[0],
         n[1],
         n[2]};
  }
  const FilePoint c{centre.x + plane.middle[0], centre.y + plane.middle[1],
                    centre.z + plane.middle[2]};
  return Pose{{r[0], r[1], r[2], c.x - (r[0] * c.x + r[1] * c.y + r[2] * c.z), r[3], r[4], r[5],
               c.y - (r[3] * c.x + r[4] * c.y + r[5] * c.z), r[6], r[7], r[8],
               c.z - (r[6] * c.x + r[7] * c.y + r[8] * c.z), 0, 0, 0, 1}};
}

}  // namespace relievo
