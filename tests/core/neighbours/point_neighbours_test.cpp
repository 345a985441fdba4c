// SPDX-License-Identifier: BSD-3-Clause
#include "core/neighbours/point_neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace relievo {
namespace {

std::vector<Point3f> scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-10, 10);
  std::vector<Point3f> points(count);
  for (Point3f& p : points) p = {place(random), place(random), place(random) / 50};
  return points;
}

float squaredDistance(const Point3f& a, const Point3f& b) {
  const float x = a[0] - b[0];
  const float y = a[1] - b[1];
  const float z = a[2] - b[2];
  return x * x + y * y + z * z;
}

/// Squared distances from a point to all others and itself, rising.
std::vector<float> allDistances(const std::vector<Point3f>& points, const Point3f& from) {
  std::vector<float> distances;
  for (const Point3f& p : points) distances.push_back(squaredDistance(p, from));
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(PointNeighbours, NearestPlacesAreThoseOfALookAtAllPoints) {
  const std::vector<Point3f> points = scattered(3000, 1);
  const PointNeighbours neighbours(points);
  ASSERT_EQ(neighbours.places(), points.size());
  std::vector<int> seen(points.size(), 0);
  neighbours.nearest(9, 2, {}, [&](const NearPlaces& near) {
    ++seen[near.of];
    const std::vector<float> expected = allDistances(points, neighbours.place(near.of));
    ASSERT_EQ(near.places.size(), 9U);
    EXPECT_EQ(near.places[0], near.of);
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_FLOAT_EQ(near.squared[k], expected[k]);
      EXPECT_FLOAT_EQ(squaredDistance(neighbours.place(near.places[k]), neighbours.place(near.of)),
                      expected[k]);
    }
  });
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(points.size()));
}

TEST(PointNeighbours, EqualPointsAreOnePlaceThatKnowsAllOfThem) {
  std::vector<Point3f> points = scattered(100, 2);
  points.insert(points.end(), points.begin(), points.begin() + 40);
  points.push_back({0.0F, 1, 2});
  points.push_back({-0.0F, 1, 2});
  const PointNeighbours neighbours(points);
  EXPECT_EQ(neighbours.places(), 101U);
  std::vector<std::uint32_t> numbers;
  for (std::size_t place = 0; place < neighbours.places(); ++place) {
    const auto at = neighbours.pointsAt(place);
    ASSERT_FALSE(at.empty());
    EXPECT_TRUE(std::is_sorted(at.begin(), at.end()));
    for (const std::uint32_t i : at) EXPECT_EQ(points[i], neighbours.place(place));
    numbers.insert(numbers.end(), at.begin(), at.end());
  }
  std::sort(numbers.begin(), numbers.end());
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(numbers, all);
}

TEST(PointNeighbours, TwoHundredThousandEqualPointsAreOnePlace) {
  const std::vector<Point3f> points(200'000, Point3f{1, 2, 3});
  const PointNeighbours neighbours(points);
  EXPECT_EQ(neighbours.places(), 1U);
  EXPECT_EQ(neighbours.pointsAt(0).size(), points.size());
  neighbours.nearest(8, 0, {}, [](const NearPlaces& near) { EXPECT_EQ(near.places.size(), 1U); });
}

TEST(PointNeighbours, WithinARadiusAreAllThatLieInItAndOnIt) {
  std::vector<Point3f> points;
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 20; ++y)
      points.push_back({static_cast<float>(x), static_cast<float>(y), 0});
  }
  const PointNeighbours neighbours(points);
  neighbours.within(1, 1000, 2, {}, [&](const NearPlaces& near) {
    const Point3f& p = neighbours.place(near.of);
    const int borders = (p[0] == 0 || p[0] == 19 ? 1 : 0) + (p[1] == 0 || p[1] == 19 ? 1 : 0);
    EXPECT_EQ(near.places.size(), 5U - static_cast<std::size_t>(borders));
    EXPECT_EQ(near.places[0], near.of);
  });
}

TEST(PointNeighbours, OtherPointsFindTheirNearestPlace) {
  const std::vector<Point3f> points = scattered(500, 3);
  const std::vector<Point3f> queries = scattered(200, 4);
  const PointNeighbours neighbours(points);
  neighbours.nearestTo(queries, 1, 0, {}, [&](const NearPlaces& near) {
    EXPECT_FLOAT_EQ(near.squared[0], allDistances(points, queries[near.of])[0]);
  });
}

TEST(PointNeighbours, ResultsAreTheSameForAnyNumberOfThreads) {
  const std::vector<Point3f> points = scattered(20'000, 5);
  const PointNeighbours neighbours(points);
  const auto of = [&](int threads) {
    std::vector<std::vector<std::uint32_t>> found(points.size());
    neighbours.nearest(5, threads, {}, [&](const NearPlaces& near) {
      found[near.of].assign(near.places.begin(), near.places.end());
    });
    return found;
  };
  EXPECT_EQ(of(1), of(3));
}

TEST(PointNeighbours, NoPointsHaveNoPlacesAndPointsThatAreNotFiniteAreRefused) {
  const PointNeighbours none(std::span<const Point3f>{});
  EXPECT_EQ(none.places(), 0U);
  none.nearest(3, 0, {}, [](const NearPlaces&) { FAIL(); });
  const std::vector<Point3f> bad{{0, 0, 0}, {0, std::numeric_limits<float>::quiet_NaN(), 0}};
  EXPECT_THROW(PointNeighbours{bad}, ArgumentError);
}

TEST(PointNeighbours, AStopRequestEndsTheSearch) {
  const std::vector<Point3f> points = scattered(50'000, 6);
  std::stop_source source;
  Task task;
  task.stop = source.get_token();
  const PointNeighbours neighbours(points, task);
  EXPECT_THROW(neighbours.nearest(8, 2, task, [&](const NearPlaces&) { source.request_stop(); }),
               Cancelled);
}

}  // namespace
}  // namespace relievo
