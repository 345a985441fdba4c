// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include "core/prepare/align/align_cloud.h"

namespace relievo::align {
namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr pclCloud(std::span<const Point3f> points) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const Point3f& p : points) cloud->push_back({p[0], p[1], p[2]});
  return cloud;
}

}  // namespace

std::vector<Point3f> normalsOf(std::span<const Point3f> places, std::span<const Point3f> surface,
                               double radius) {
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;  // Every core; per point alone.
  estimation.setInputCloud(pclCloud(places));
  estimation.setSearchSurface(pclCloud(surface));
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setRadiusSearch(radius);
  pcl::PointCloud<pcl::Normal> found;
  estimation.compute(found);
  std::vector<Point3f> normals;
  normals.reserve(found.size());
  for (const pcl::Normal& n : found) normals.push_back({n.normal_x, n.normal_y, n.normal_z});
  return normals;
}

}  // namespace relievo::align
