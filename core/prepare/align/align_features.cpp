// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/fpfh_omp.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>

#include "core/prepare/align/align_start.h"

namespace relievo::align {
namespace {

constexpr double kFeatureCells = 5;  ///< Radius of the neighbourhood.

}  // namespace

Features featuresOf(const OrientedSet& coarse) {
  auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (std::size_t i = 0; i < coarse.points.size(); ++i) {
    const Point3f& p = coarse.points[i];
    const Point3f& n = coarse.normals[i];
    points->push_back({p[0], p[1], p[2]});
    normals->push_back({n[0], n[1], n[2]});
  }
  pcl::FPFHEstimationOMP<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33> estimation;
  estimation.setInputCloud(points);
  estimation.setInputNormals(normals);
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setRadiusSearch(kFeatureCells * coarse.cell);
  pcl::PointCloud<pcl::FPFHSignature33> found;
  estimation.compute(found);
  Features features;
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::array<float, 33> histogram{};
    std::copy_n(static_cast<const float*>(found[i].histogram), histogram.size(), histogram.begin());
    // A point with no neighbour: PCL's tree of features does not survive its NaN.
    if (!std::all_of(histogram.begin(), histogram.end(),
                     [](float value) { return std::isfinite(value); })) {
      continue;
    }
    features.points.push_back(coarse.points[i]);
    features.histograms.push_back(histogram);
  }
  return features;
}

}  // namespace relievo::align
