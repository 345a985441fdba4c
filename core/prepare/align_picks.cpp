// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align_picks.h"

#include <pcl/point_types.h>
#include <pcl/registration/transformation_estimation_svd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/prepare/align_math.h"

namespace relievo::align {
namespace {

constexpr double kLeastAngle = 5 * std::numbers::pi / 180;
constexpr double kMostStretch = 1.5;    ///< Of the picks' spread, one scan over the other.
constexpr std::size_t kTriangles = 32;  ///< Of the first so many picks all are tried.

using Places = std::vector<Eigen::Vector3d>;

double angleAt(const Eigen::Vector3d& corner, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d u = a - corner;
  const Eigen::Vector3d v = b - corner;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Of the best triangle of the picks its smallest angle; 0 where they lie in one line.
double bestAngle(const Places& places) {
  const std::size_t count = std::min(places.size(), kTriangles);
  double best = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        best = std::max(best, std::min({angleAt(places[i], places[j], places[k]),
                                        angleAt(places[j], places[k], places[i]),
                                        angleAt(places[k], places[i], places[j])}));
      }
    }
  }
  return best;
}

Eigen::Vector3d meanOf(const Places& places) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : places) mean += p;
  return mean / static_cast<double>(places.size());
}

double spreadOf(const Places& places, const Eigen::Vector3d& mean) {
  double sum = 0;
  for (const Eigen::Vector3d& p : places) sum += (p - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(places.size()));
}

/// PCL's points are float: from the mean, or projected coordinates lose the picks.
pcl::PointCloud<pcl::PointXYZ> pclCloud(const Places& places, const Eigen::Vector3d& mean) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const Eigen::Vector3d& p : places) {
    const Eigen::Vector3f d = (p - mean).cast<float>();
    cloud.push_back({d.x(), d.y(), d.z()});
  }
  return cloud;
}

}  // namespace

PickedFit fitPicks(std::span<const PickedPair> picks, const std::string& scan) {
  if (picks.size() < 3) {
    throw ArgumentError(scan + ": " + std::to_string(picks.size()) +
                        " picked pairs; three or more are needed. Nothing was aligned.");
  }
  Places on_scan;
  Places on_reference;
  for (const PickedPair& pair : picks) {
    on_scan.push_back(vector(pair.point));
    on_reference.push_back(vector(pair.reference));
  }
  if (std::min(bestAngle(on_scan), bestAngle(on_reference)) < kLeastAngle) {
    throw ArgumentError(scan +
                        ": the picked places lie nearly in one line, which leaves open how the "
                        "scan is turned about it. Nothing was aligned; pick one more place well "
                        "beside that line.");
  }
  const Eigen::Vector3d scan_mean = meanOf(on_scan);
  const Eigen::Vector3d reference_mean = meanOf(on_reference);
  const double stretch = spreadOf(on_reference, reference_mean) / spreadOf(on_scan, scan_mean);
  if (!(stretch < kMostStretch && stretch > 1 / kMostStretch)) {
    throw ArgumentError(scan +
                        ": the picked places are not equally far from each other on the two "
                        "scans. Nothing was aligned; look whether the pairs are in the same order "
                        "and the scans in the same unit.");
  }
  const pcl::registration::TransformationEstimationSVD<pcl::PointXYZ, pcl::PointXYZ, double> svd;
  Eigen::Matrix4d found;
  svd.estimateRigidTransformation(pclCloud(on_scan, scan_mean),
                                  pclCloud(on_reference, reference_mean), found);
  LocalPose local = LocalPose::Identity();
  local.matrix() = found;
  if (!found.allFinite() || local.linear().determinant() <= 0) {
    throw ArgumentError(scan +
                        ": the picked places fit a mirror image only. Nothing was aligned; "
                        "look whether the pairs are in the same order.");
  }
  local = exactlyRigid(local);
  const auto file = [](const Eigen::Vector3d& p) { return FilePoint{p.x(), p.y(), p.z()}; };
  PickedFit fit{fileFromMiddles(local, file(reference_mean), file(scan_mean)), 0};
  double squares = 0;
  for (const PickedPair& pair : picks) {
    const FilePoint miss = fit.pose(pair.point) - pair.reference;
    squares += dot(miss, miss);
  }
  fit.error = std::sqrt(squares / static_cast<double>(picks.size()));
  return fit;
}

}  // namespace relievo::align
