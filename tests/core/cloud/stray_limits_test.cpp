// SPDX-License-Identifier: BSD-3-Clause
#include "core/cloud/stray_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace relievo {
namespace {

using Points = std::vector<std::array<float, 3>>;

AxisBox boxOf(const Points& points) {
  AxisBox box{.min = {1e300, 1e300, 1e300}, .max = {-1e300, -1e300, -1e300}};
  for (const auto& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], static_cast<double>(p[axis]));
      box.max[axis] = std::max(box.max[axis], static_cast<double>(p[axis]));
    }
  }
  return box;
}

std::optional<AxisBox> limitsOf(const Points& points) {
  return strayLimits({.points = points}, boxOf(points)).strays;
}

/// Which points lie outside, by number.
std::vector<std::size_t> outside(const Points& points, const std::optional<AxisBox>& limits) {
  std::vector<std::size_t> found;
  const PointsView view{.points = points};
  for (std::size_t i = 0; limits && i < points.size(); ++i) {
    if (!contains(*limits, view.at(i))) found.push_back(i);
  }
  return found;
}

/// Which points are strays, by number.
std::vector<std::size_t> straysOf(const Points& points) {
  return outside(points, limitsOf(points));
}

/// Which points are strays or of groups, by number.
std::vector<std::size_t> groupedOf(const Points& points) {
  return outside(points, strayLimits({.points = points}, boxOf(points)).groups);
}

class Clouds {
 public:
  explicit Clouds(unsigned seed) : random_(seed) {}

  float uniform(double low, double high) {
    return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  Points sphere(std::size_t count, double radius) {
    std::normal_distribution<double> normal;
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<double, 3> d{normal(random_), normal(random_), normal(random_)};
      const double f = radius / std::hypot(d[0], d[1], d[2]);
      points.push_back({static_cast<float>(f * d[0]), static_cast<float>(f * d[1]),
                        static_cast<float>(f * d[2])});
    }
    return points;
  }
  /// 300 x 200 with 20 of relief.
  Points relief(std::size_t count) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
      const float x = uniform(0, 300);
      const float y = uniform(0, 200);
      points.push_back({x, y, 10 * std::sin(x / 20) * std::cos(y / 15)});
    }
    return points;
  }
  /// All over a box so many times the object's.
  void scatter(Points& points, std::size_t count, double times) {
    const AxisBox box = boxOf(points);
    const double half = 0.5 * times * longestSide(box);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<float, 3> p{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double middle = 0.5 * (box.min[axis] + box.max[axis]);
        p[axis] = uniform(middle - half, middle + half);
      }
      points.push_back(p);
    }
  }
  void shuffle(Points& points) { std::shuffle(points.begin(), points.end(), random_); }

 private:
  std::mt19937_64 random_;
};

TEST(StrayLimits, TwelveOfTwentyThousandAreFoundAndNoOther) {
  Clouds clouds(1);
  Points points = clouds.relief(19'988);
  for (int i = 0; i < 12; ++i) {
    points.push_back({clouds.uniform(2e4, 3e4), clouds.uniform(-1e4, 1e4), clouds.uniform(0, 9e3)});
  }
  const std::vector<std::size_t> strays = straysOf(points);
  ASSERT_EQ(strays.size(), 12U);
  EXPECT_EQ(strays.front(), 19'988U);
}

TEST(StrayLimits, AFlippedBitIsOneStray) {
  Clouds clouds(2);
  for (const float far : {3.1e6F, -3.1e6F, 1e30F, -1e38F}) {
    for (const std::size_t axis : {0U, 1U, 2U}) {
      Points points = clouds.relief(5'000);
      points[77][axis] = far;
      EXPECT_EQ(straysOf(points), std::vector<std::size_t>{77}) << far << ' ' << axis;
    }
  }
}

TEST(StrayLimits, StraysOnSeveralScalesAreAllFound) {
  Clouds clouds(3);
  Points points = clouds.sphere(50'000, 1);
  for (const float far : {10.0F, 1e3F, 1e6F, 1e12F, 1e20F, 1e30F, 1e38F}) {
    points.push_back({far, -far / 3, far / 7});
  }
  EXPECT_EQ(straysOf(points).size(), 7U);
}

TEST(StrayLimits, AHundredthScatteredAroundIsFoundAtEveryDensity) {
  for (const std::size_t count : {5'000U, 20'000U, 100'000U, 1'000'000U}) {
    for (const double times : {3.0, 10.0, 1000.0}) {
      Clouds clouds(4);
      Points points = clouds.sphere(count, 50);
      clouds.scatter(points, count / 100, times);
      const std::vector<std::size_t> strays = straysOf(points);
      // Those that fell near the object stay: in a box of 1.25 sides, of a side found to 1/8.
      const double near = std::pow(1.25 * 1.125 / times, 3);
      const double expected = (1 - near) * static_cast<double>(count) / 100;
      EXPECT_GE(static_cast<double>(strays.size()), expected - 4 * std::sqrt(near * expected) - 1)
          << count << ' ' << times;
      EXPECT_TRUE(strays.empty() || strays.front() >= count) << "a point of the object";
    }
  }
}

TEST(StrayLimits, DoNotDependOnTheOrderOfPoints) {
  Clouds clouds(5);
  for (const std::size_t count : {40U, 700U, 20'000U}) {
    Points points = clouds.relief(count);
    clouds.scatter(points, std::max<std::size_t>(1, count / 150), 50);
    const auto first = limitsOf(points);
    for (int round = 0; round < 5; ++round) {
      clouds.shuffle(points);
      const auto again = limitsOf(points);
      ASSERT_EQ(first.has_value(), again.has_value()) << count;
      if (!first) continue;
      EXPECT_EQ(first->min, again->min);
      EXPECT_EQ(first->max, again->max);
    }
  }
}

TEST(StrayLimits, DoNotDependOnScaleOrOnWhichAxisIsWhich) {
  Clouds clouds(6);
  Points points = clouds.relief(20'000);
  clouds.scatter(points, 60, 30);
  const std::vector<std::size_t> truth = straysOf(points);
  ASSERT_GT(truth.size(), 50U);
  for (const float scale : {0x1p-20F, 0x1p-3F, 0x1p40F}) {
    Points scaled = points;
    for (auto& p : scaled) p = {scale * p[0], scale * p[1], scale * p[2]};
    EXPECT_EQ(straysOf(scaled), truth) << scale;
  }
  Points turned = points;
  for (auto& p : turned) p = {p[2], p[0], p[1]};
  EXPECT_EQ(straysOf(turned), truth);
}

TEST(StrayLimits, TurnedInSpaceTheFarOnesAreStillFound) {
  Clouds clouds(7);
  Points points = clouds.relief(20'000);
  for (int i = 0; i < 12; ++i) points.push_back({9e3F + 500 * static_cast<float>(i), 4e3F, 2e3F});
  for (const double angle : {0.3, 0.9, 1.4, 2.5}) {
    Points turned = points;
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    for (auto& p : turned) p = {c * p[0] - s * p[2], p[1], s * p[0] + c * p[2]};
    EXPECT_EQ(straysOf(turned).size(), 12U) << angle;
  }
}

TEST(StrayLimits, ADistantDenseObjectIsNoStray) {
  Clouds clouds(8);
  for (const double share : {0.5, 0.1, 0.02, 0.005}) {
    Points points = clouds.sphere(100'000, 10);
    const auto count = static_cast<std::size_t>(share * 100'000);
    for (const auto& p : clouds.sphere(count, 2)) {
      points.push_back({p[0] + 500, p[1] + 300, p[2]});
    }
    EXPECT_TRUE(straysOf(points).empty()) << share;
  }
}

TEST(StrayLimits, AClumpOfAThousandthToAHundredthIsAGroup) {
  for (const double share : {0.0012, 0.003, 0.0099}) {
    Clouds clouds(14);
    Points points = clouds.sphere(100'000, 10);
    const auto count = static_cast<std::size_t>(share * 100'000);
    for (const auto& p : clouds.sphere(count, 2)) {
      points.push_back({p[0] + 500, p[1] + 300, p[2]});
    }
    EXPECT_TRUE(straysOf(points).empty()) << share;
    const std::vector<std::size_t> grouped = groupedOf(points);
    ASSERT_EQ(grouped.size(), count) << share;
    EXPECT_EQ(grouped.front(), 100'000U);
    // Single points as well: they are strays, and outside of both boxes.
    points.push_back({-4000, 0, 0});
    EXPECT_EQ(straysOf(points), std::vector<std::size_t>{points.size() - 1}) << share;
    EXPECT_EQ(groupedOf(points).size(), count + 1) << share;
  }
}

TEST(StrayLimits, GroupsThatStretchNothingOrAreMoreThanAHundredthAreNone) {
  Clouds clouds(15);
  const auto with = [&clouds](std::size_t count, float x) {
    Points points = clouds.sphere(100'000, 10);
    for (const auto& p : clouds.sphere(count, 1)) points.push_back({p[0] + x, p[1], p[2]});
    return points;
  };
  EXPECT_TRUE(groupedOf(with(500, 15)).empty()) << "a ball beside it, near";
  EXPECT_EQ(groupedOf(with(500, 60)).size(), 500U);
  EXPECT_TRUE(groupedOf(with(1'500, 60)).empty());
  Points several = with(500, 60);
  for (const auto& p : clouds.sphere(600, 1)) several.push_back({p[0], p[1] - 70, p[2]});
  EXPECT_TRUE(groupedOf(several).empty()) << "together more than a hundredth";
  // One stray far beyond a group that is near.
  Points near = with(500, 15);
  near.push_back({3'000, 0, 0});
  EXPECT_EQ(straysOf(near).size(), 1U);
  EXPECT_TRUE(groupedOf(near).empty());
}

TEST(StrayLimits, LegitimateShapesLoseNothing) {
  Clouds clouds(9);
  EXPECT_TRUE(straysOf(clouds.relief(20'000)).empty());
  EXPECT_TRUE(groupedOf(clouds.relief(20'000)).empty());
  Points terraces;
  for (int i = 0; i < 40'000; ++i) {
    const float x = clouds.uniform(0, 100);
    terraces.push_back({x, clouds.uniform(0, 80), 10 * std::floor(x / 20)});
  }
  EXPECT_TRUE(straysOf(terraces).empty());
  EXPECT_TRUE(groupedOf(terraces).empty());
  // A lance: a thousandth of the points on half the length of all.
  Points lance = clouds.sphere(100'000, 10);
  for (int i = 0; i < 100; ++i) lance.push_back({0, 0, 10 + 0.3F * static_cast<float>(i)});
  EXPECT_TRUE(straysOf(lance).empty());
  EXPECT_TRUE(groupedOf(lance).empty());
  // Density falling with the square of the distance, as around a scanner.
  Points room;
  for (int i = 0; i < 200'000; ++i) {
    const float r = 1 / clouds.uniform(0.02, 1);
    const float angle = clouds.uniform(0, 2 * std::numbers::pi);
    room.push_back({r * std::cos(angle), r * std::sin(angle), clouds.uniform(0, 0.1)});
  }
  EXPECT_TRUE(straysOf(room).empty());
  EXPECT_TRUE(groupedOf(room).empty());
}

TEST(StrayLimits, SparseAndTinyCloudsLoseNothing) {
  Clouds clouds(10);
  for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 10U, 19U}) {
    Points points = clouds.relief(count);
    points.back() = {1e9F, 0, 0};
    EXPECT_TRUE(straysOf(points).empty()) << count;
  }
  for (const std::size_t count : {20U, 30U, 50U, 100U, 300U, 999U, 1'000U, 3'000U}) {
    for (int round = 0; round < 50; ++round) {
      EXPECT_TRUE(straysOf(clouds.relief(count)).empty()) << count;
      EXPECT_TRUE(straysOf(clouds.sphere(count, 3)).empty()) << count;
    }
  }
  // Each point twice as far as the one before: nowhere is an end.
  Points doubling;
  for (int i = 0; i < 60; ++i) doubling.push_back({std::exp2f(static_cast<float>(i)), 0, 0});
  EXPECT_TRUE(straysOf(doubling).empty());
  EXPECT_TRUE(straysOf(Points(1'000, {1, 2, 3})).empty());
  Points spot(1'000, {1, 2, 3});
  spot[5] = {1e30F, 0, 0};
  EXPECT_TRUE(straysOf(spot).empty()) << "there is no object beside it";
}

TEST(StrayLimits, ASmallCloudLosesOnePointThatIsFarOff) {
  Clouds clouds(11);
  for (const std::size_t count : {40U, 100U, 500U}) {
    Points points = clouds.relief(count);
    points[count / 2] = {1e5F, 1e5F, 0};
    EXPECT_EQ(straysOf(points), std::vector<std::size_t>{count / 2}) << count;
  }
}

TEST(StrayLimits, MoreThanAHundredthAreNoStrays) {
  Clouds clouds(12);
  Points points = clouds.sphere(20'000, 10);
  clouds.scatter(points, 1'000, 100);
  EXPECT_TRUE(straysOf(points).empty());
}

TEST(StrayLimits, CountsOfPartsAreThoseOfTheWhole) {
  Clouds clouds(13);
  Points points = clouds.relief(30'000);
  clouds.scatter(points, 100, 40);
  const AxisBox box = boxOf(points);
  const PointsView view{.points = points};
  const StrayGrid grid = strayGrid(view, box);
  StrayCounts whole(grid);
  std::array<StrayCounts, 3> parts{StrayCounts(grid), StrayCounts(grid), StrayCounts(grid)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    whole.add(view.at(i));
    parts[i % 3].add(view.at(i));
  }
  parts[0].add(parts[1]);
  parts[0].add(parts[2]);
  EXPECT_EQ(parts[0].points(), whole.points());
  ASSERT_TRUE(whole.limits(box).strays.has_value());
  EXPECT_EQ(parts[0].limits(box).strays->min, whole.limits(box).strays->min);
  EXPECT_EQ(parts[0].limits(box).strays->max, whole.limits(box).strays->max);
}

}  // namespace
}  // namespace relievo
