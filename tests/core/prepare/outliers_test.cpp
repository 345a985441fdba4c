// SPDX-License-Identifier: BSD-3-Clause
// PCL's own filters are the judge: the same points stay, to the last one.
#include "core/prepare/outliers.h"

#include <gtest/gtest.h>
#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/point_types.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/core/prepare/made_clouds.h"

namespace relievo {
namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr cloudOf(const std::vector<Point3f>& points) {
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Point3f& p : points) cloud->emplace_back(p[0], p[1], p[2]);
  return cloud;
}

std::vector<std::uint32_t> numbers(const pcl::Indices& indices) {
  return {indices.begin(), indices.end()};
}

std::vector<std::uint32_t> statisticalByPcl(const std::vector<Point3f>& points, Outliers step) {
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setInputCloud(cloudOf(points));
  filter.setMeanK(step.neighbours);
  filter.setStddevMulThresh(step.deviations);
  pcl::Indices kept;
  filter.filter(kept);
  return numbers(kept);
}

std::vector<std::uint32_t> radiusByPcl(const std::vector<Point3f>& points, double radius,
                                       int neighbours) {
  pcl::RadiusOutlierRemoval<pcl::PointXYZ> filter;
  filter.setInputCloud(cloudOf(points));
  filter.setRadiusSearch(radius);
  filter.setMinNeighborsInRadius(neighbours);
  pcl::Indices kept;
  filter.filter(kept);
  return numbers(kept);
}

struct Case {
  std::string name;
  std::vector<Point3f> points;
};

std::vector<Case> cases() {
  std::vector<Case> all{{"relief", test::reliefWithOutliers(20000, 0.01, 1)},
                        {"flyers alone", test::reliefWithOutliers(3000, 1, 2)}};
  for (const double part : {0.01, 0.1, 0.5, 1.0}) {
    all.push_back({"duplicates " + std::to_string(part),
                   test::withDuplicates(test::reliefWithOutliers(8000, 0.01, 3), part, 4)});
  }
  Case line{"a line", {}};
  for (int i = 0; i < 3000; ++i) line.points.push_back({0.1F * static_cast<float>(i), 0, 0});
  line.points.push_back({400, 0, 0});
  all.push_back(line);
  Case utm{"coordinates of a map", test::reliefWithOutliers(8000, 0.01, 5)};
  for (Point3f& p : utm.points) p = {p[0] + 500000, p[1] + 5400000, p[2]};
  all.push_back(utm);
  Case one_place{"one place", std::vector<Point3f>(500, Point3f{1, 2, 3})};
  one_place.points.push_back({9, 9, 9});
  all.push_back(one_place);
  for (const std::size_t few : {std::size_t{2}, std::size_t{5}, std::size_t{9}}) {
    all.push_back({std::to_string(few) + " points", test::reliefWithOutliers(few, 0.2, 6)});
  }
  return all;
}

TEST(Outliers, ThatStayAreThoseOfPclsStatisticalFilter) {
  for (const Case& made : cases()) {
    const PointNeighbours neighbours(made.points);
    for (const int k : {1, 8, 50}) {
      // PCL reads beyond its own list where there are fewer points than neighbours.
      if (made.points.size() < static_cast<std::size_t>(k) + 1) continue;
      for (const double deviations : {0.5, 2.0}) {
        const Outliers step{.neighbours = k, .deviations = deviations};
        EXPECT_EQ(withoutOutliers(neighbours, made.points.size(), step, {}),
                  statisticalByPcl(made.points, step))
            << made.name << ", k " << k << ", " << deviations;
      }
    }
  }
}

TEST(Outliers, FewerPointsThanNeighboursIsNoCrashAndKeepsWhatIsNear) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{7}}) {
    std::vector<Point3f> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({static_cast<float>(i), 0, 0});
    const PointNeighbours neighbours(points);
    EXPECT_EQ(withoutOutliers(neighbours, count, {.neighbours = 50, .deviations = 2}, {}).size(),
              count);
  }
  std::vector<Point3f> points(20, Point3f{});
  for (std::size_t i = 0; i < 20; ++i) points[i][0] = static_cast<float>(i);
  points.push_back({500, 0, 0});
  const auto kept = withoutOutliers(PointNeighbours(points), points.size(),
                                    {.neighbours = 50, .deviations = 2}, {});
  EXPECT_EQ(kept.size(), 20U);
  EXPECT_EQ(kept.back(), 19U);
}

TEST(Lonely, ThatStayAreThoseOfPclsRadiusFilter) {
  for (const Case& made : cases()) {
    const PointNeighbours neighbours(made.points);
    for (const int count : {1, 8, 50}) {
      for (const double radius : {0.05, 0.8, 3.0}) {
        EXPECT_EQ(withoutLonely(neighbours, made.points.size(), radius, count, {}),
                  radiusByPcl(made.points, radius, count))
            << made.name << ", " << count << " within " << radius;
      }
    }
  }
}

TEST(Spacing, IsTheDistanceOfALatticeHoweverOftenItsPointsAreStored) {
  std::vector<Point3f> points;
  for (int i = 0; i < 900; ++i) {
    points.push_back({0.25F * static_cast<float>(i % 30), 0.25F * static_cast<float>(i / 30), 7});
  }
  EXPECT_DOUBLE_EQ(spacingOf(PointNeighbours(points), {}), 0.25);
  EXPECT_DOUBLE_EQ(spacingOf(PointNeighbours(test::withDuplicates(points, 1, 1)), {}), 0.25);
  EXPECT_EQ(spacingOf(PointNeighbours(std::vector<Point3f>(5, Point3f{1, 1, 1})), {}), 0);
}

}  // namespace
}  // namespace relievo
