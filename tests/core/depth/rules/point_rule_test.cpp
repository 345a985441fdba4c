// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/point_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "core/depth/rules/rasterize.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

constexpr double kNoiseMm = 0.02;
constexpr double kSpacing = 0.25;
constexpr int kCells = 120;  // 30 mm.

double relief(double x, double y) {
  return 3 + 0.4 * std::sin(x / 5) * std::cos(y / 6);
}

/// Points scattered over the relief with noise; `outliers` of them anywhere within 20 mm about it.
Scan noisyRelief(double points_per_cell, double outliers, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> across(-0.5 * kSpacing, (kCells - 0.5) * kSpacing);
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> noise(0, kNoiseMm);
  Scan scan;
  const auto count = static_cast<std::size_t>(points_per_cell * kCells * kCells);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = across(random);
    const double y = across(random);
    double z = relief(x, y) + noise(random);
    if (share(random) < outliers) z += 20 * (share(random) - 0.5);
    scan.points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  }
  test::finishScan(scan);
  return scan;
}

DepthRequest requestOf(const Scan& scan, PointRule rule = PointRule::front) {
  return {.scan = scan,
          .view_from_file = {},
          .frame = {.size = {.cols = kCells, .rows = kCells},
                    .spacing_mm = kSpacing,
                    .first_x_mm = 0,
                    .first_y_mm = 0},
          .rule = rule};
}

struct Difference {
  double bias = 0, rms = 0;
};

Difference fromTruth(const Scan& scan, PointRule rule) {
  const DepthRequest request = requestOf(scan, rule);
  const FrontDepths depths = rasterize(request).front;
  double sum = 0;
  double squares = 0;
  int count = 0;
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) {
      const float z = depths[request.frame.size.index({.col = col, .row = row})];
      if (std::isnan(z)) continue;
      const double off = static_cast<double>(z) - relief(col * kSpacing, row * kSpacing);
      sum += off;
      squares += off * off;
      ++count;
    }
  }
  return {.bias = sum / count, .rms = std::sqrt(squares / count)};
}

/// One cell with these points.
float heightOf(std::initializer_list<float> heights, PointRule rule) {
  Scan scan;
  for (const float z : heights) scan.points.push_back({0.1F, -0.1F, z});
  test::finishScan(scan);
  DepthRequest request = requestOf(scan, rule);
  request.frame.size = {.cols = 2, .rows = 1};
  const FrontDepths depths = rasterize(request).front;
  EXPECT_TRUE(std::isnan(depths[1]));
  return depths[0];
}

TEST(PointRule, TheFrontMostPointIsLiftedByNoiseAndTheMiddleIsNot) {
  const Scan scan = noisyRelief(16, 0, 1);
  EXPECT_GT(fromTruth(scan, PointRule::front).bias, kNoiseMm);
  for (const PointRule rule : {PointRule::top_mean, PointRule::median, PointRule::mean}) {
    const Difference off = fromTruth(scan, rule);
    EXPECT_NEAR(off.bias, 0, 0.02 * kNoiseMm) << describe(rule);
    EXPECT_LT(off.rms, 0.5 * kNoiseMm) << describe(rule);
  }
}

TEST(PointRule, OutliersDoNotSpoilTheMedian) {
  const double clean = fromTruth(noisyRelief(16, 0, 2), PointRule::median).rms;
  const Scan scan = noisyRelief(16, 0.005, 2);
  EXPECT_LT(fromTruth(scan, PointRule::median).rms, 1.1 * clean);
  EXPECT_GT(fromTruth(scan, PointRule::front).rms, 20 * clean);
  EXPECT_GT(fromTruth(scan, PointRule::mean).rms, 1.5 * fromTruth(scan, PointRule::median).rms);
  EXPECT_LT(fromTruth(scan, PointRule::top_mean).rms, fromTruth(scan, PointRule::front).rms / 4);
}

TEST(PointRule, OutliersAreCountedAndLeftOutByEveryRuleButWallsStay) {
  Scan scan = noisyRelief(3, 0, 7);
  scan.points.push_back({15, 15, 20});
  scan.points.push_back({20.1F, 9, -12});
  for (const PointRule rule : {PointRule::front, PointRule::top_mean, PointRule::quadratic}) {
    const CapturedDepths found = rasterize(requestOf(scan, rule));
    EXPECT_EQ(found.outliers, 2U) << describe(rule);
    for (const float z : found.front) {
      if (std::isnan(z)) continue;
      ASSERT_NEAR(z, 3, 0.6) << describe(rule);
    }
  }
  // A wall of 10 mm across the middle, no denser than the ground.
  Scan wall = noisyRelief(3, 0, 8);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 14'400; ++i) {
    wall.points.push_back({15, 29 * uniform(random), 3 + 10 * uniform(random)});
  }
  EXPECT_LE(rasterize(requestOf(wall, PointRule::front)).outliers, 3U);
}

TEST(PointRule, SplatAndQuadraticComeNearerToTheTruthThanACellsOwnMean) {
  const Scan scan = noisyRelief(1.6, 0, 9);
  const double mean = fromTruth(scan, PointRule::mean).rms;
  const double splat = fromTruth(scan, PointRule::splat).rms;
  const double quadratic = fromTruth(scan, PointRule::quadratic).rms;
  EXPECT_LT(splat, 0.85 * mean);
  EXPECT_LT(quadratic, 0.7 * splat);
}

TEST(PointRule, APlaneComesBackAsThatPlaneBySplatWithinItsNoiseAndByQuadraticsExactly) {
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> across(-0.5 * kSpacing, (kCells - 0.5) * kSpacing);
  Scan plane;
  for (int i = 0; i < 2 * kCells * kCells; ++i) {
    const double x = across(random);
    const double y = across(random);
    plane.points.push_back(
        {static_cast<float>(x), static_cast<float>(y), static_cast<float>(4 + 0.3 * x - 0.2 * y)});
  }
  test::finishScan(plane);
  const DepthRequest request = requestOf(plane, PointRule::quadratic);
  const CapturedDepths found = rasterize(request);
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) {
      const float z = found.between[request.frame.size.index({.col = col, .row = row})];
      ASSERT_FALSE(std::isnan(z)) << col << ' ' << row;
      ASSERT_NEAR(z, 4 + 0.3 * col * kSpacing - 0.2 * row * kSpacing, 2e-6);
    }
  }
}

TEST(PointRule, AStepStaysAStepUnderLocalQuadratics) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> across(-0.5 * kSpacing, (kCells - 0.5) * kSpacing);
  std::normal_distribution<double> noise(0, kNoiseMm);
  Scan step;
  for (int i = 0; i < 3 * kCells * kCells; ++i) {
    const double x = across(random);
    const double z = (x > 15.1 ? 5 : 1) + noise(random);
    step.points.push_back(
        {static_cast<float>(x), static_cast<float>(across(random)), static_cast<float>(z)});
  }
  test::finishScan(step);
  const DepthRequest request = requestOf(step, PointRule::quadratic);
  const CapturedDepths found = rasterize(request);
  for (std::size_t i = 0; i < found.front.size(); ++i) {
    if (std::isnan(found.front[i])) continue;
    const auto col = static_cast<int>(i % kCells);
    // The edge lies in column 60; beside it nothing rings.
    if (col == 60) continue;
    ASSERT_NEAR(found.front[i], col > 60 ? 5 : 1, 6 * kNoiseMm) << col;
  }
}

TEST(PointRule, ALocalQuadraticDoesNotLeaveItsPointsBehind) {
  // Relief finer than the cells, seen beside gaps: fits of a few points on one side.
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> across(-0.5 * kSpacing, (kCells - 0.5) * kSpacing);
  Scan rough;
  while (rough.points.size() < 2 * kCells * kCells) {
    const double x = across(random);
    const double y = across(random);
    if (std::fmod(x + 0.3 * y + 10, 2.5) < 0.9) continue;
    const double z = 1 + 0.5 * std::sin(9 * x) * std::cos(11 * y);
    rough.points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  }
  test::finishScan(rough);
  const CapturedDepths found = rasterize(requestOf(rough, PointRule::quadratic));
  float low = 1;
  float high = 1;
  for (const std::vector<float>& heights : {found.front, found.between}) {
    for (const float z : heights) {
      if (std::isnan(z)) continue;
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  EXPECT_GE(low, 0.1F);
  EXPECT_LE(high, 1.9F);
}

TEST(PointRule, EveryRuleGivesTheSameBytesForAnyNumberOfThreads) {
  Scan scan = noisyRelief(5, 0.002, 12);
  for (const char* name :
       {"front", "second", "topmean", "median", "mean", "splat", "quadratic", "min"}) {
    DepthRequest request = requestOf(scan, *pointRule(name));
    request.threads = 1;
    const CapturedDepths one = rasterize(request);
    for (const int threads : {2, 3, 7}) {
      request.threads = threads;
      const CapturedDepths more = rasterize(request);
      const auto same = [](const std::vector<float>& a, const std::vector<float>& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), 4 * a.size()) == 0;
      };
      EXPECT_TRUE(same(one.front, more.front)) << name << threads;
      EXPECT_TRUE(same(one.between, more.between)) << name << threads;
      EXPECT_TRUE(same(one.quality.spreads_mm, more.quality.spreads_mm)) << name << threads;
      EXPECT_EQ(one.quality.counts, more.quality.counts) << name << threads;
      EXPECT_EQ(one.outliers, more.outliers) << name << threads;
    }
  }
}

TEST(PointRule, CountAndSpreadOfACellAreThoseOfItsTopLayer) {
  Scan scan;
  for (const float z : {5.0F, 5.2F, 4.8F, 1.0F}) scan.points.push_back({0, 0, z});
  test::finishScan(scan);
  const CapturedDepths found = rasterize(requestOf(scan, PointRule::front));
  EXPECT_EQ(found.quality.counts[0], 4U);
  EXPECT_NEAR(found.quality.spreads_mm[0], 0.2, 1e-6);
  EXPECT_EQ(found.quality.counts[1], 0U);
  ASSERT_TRUE(found.hidden);
  EXPECT_EQ(found.hidden->hidden, 1);
  EXPECT_EQ(found.hidden->all, 4);
  EXPECT_EQ(found.hidden->cells, 1U);
}

TEST(PointRule, EachRuleTakesItsPointsOfACell) {
  EXPECT_FLOAT_EQ(heightOf({1, 4, 2, 9}, PointRule::front), 9);
  EXPECT_FLOAT_EQ(heightOf({1, 4, 2, 9}, PointRule::second), 4);
  EXPECT_FLOAT_EQ(heightOf({1, 4, 2, 9}, PointRule::median), 3);
  EXPECT_FLOAT_EQ(heightOf({1, 4, 9}, PointRule::median), 4);
  EXPECT_FLOAT_EQ(heightOf({1, 4, 2, 9}, PointRule::mean), 4);
  EXPECT_FLOAT_EQ(heightOf({4, 1, 2, 9}, PointRule::lowest), 1);
  // Second 5: the layer within 1.5 cells of it; the outlier at 9 and the back at 1 are not in it.
  EXPECT_FLOAT_EQ(heightOf({1, 5, 4.75F, 1.1F, 9, 4.875F}, PointRule::top_mean), 4.875F);
}

TEST(PointRule, TheOnlyPointOfACellIsItsHeightByEveryRule) {
  for (const char* name :
       {"front", "second", "topmean", "median", "mean", "splat", "quadratic", "min"}) {
    const auto rule = pointRule(name);
    ASSERT_TRUE(rule) << name;
    EXPECT_EQ(heightOf({2.5F}, *rule), 2.5F) << name;
  }
  EXPECT_FALSE(pointRule("max"));
}

TEST(PointRule, EqualPointsAreCountedEachForItself) {
  EXPECT_FLOAT_EQ(heightOf({7, 7, 1}, PointRule::second), 7);
  EXPECT_FLOAT_EQ(heightOf({7, 7, 1}, PointRule::median), 7);
}

TEST(PointRule, TheTopLayerIsKeptApartFromTheBack) {
  Scan scan = noisyRelief(12, 0, 3);
  const Scan back = noisyRelief(12, 0, 4);
  for (auto p : back.points) {
    p[2] -= 6;
    scan.points.push_back(p);
  }
  EXPECT_NEAR(fromTruth(scan, PointRule::top_mean).bias, 0, 0.1 * kNoiseMm);
  EXPECT_LT(fromTruth(scan, PointRule::mean).bias, -2);
  EXPECT_EQ(proposeRule(requestOf(scan)).rule, PointRule::top_mean);
  EXPECT_EQ(englishText(proposeRule(requestOf(scan)).reason),
            "24.0 points per cell in several layers");
}

TEST(PointRule, IsProposedFromTheDataInWords) {
  const Scan lattice = test::latticeScan(kCells, kCells, kSpacing, relief);
  EXPECT_EQ(proposeRule(requestOf(lattice)).rule, PointRule::front);
  EXPECT_EQ(englishText(proposeRule(requestOf(lattice)).reason), "one point at each sample");
  const Scan sparse = noisyRelief(2.5, 0, 5);
  EXPECT_EQ(proposeRule(requestOf(sparse)).rule, PointRule::quadratic);
  EXPECT_EQ(englishText(proposeRule(requestOf(sparse)).reason), "2.5 points per cell");
  const Scan dense = noisyRelief(16, 0.0005, 6);
  EXPECT_EQ(proposeRule(requestOf(dense)).rule, PointRule::median);
  EXPECT_EQ(englishText(proposeRule(requestOf(dense)).reason), "16.0 points per cell in one layer");
}

}  // namespace
}  // namespace relievo
