// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace relievo {
namespace {

/// Points over a square of 100 mm: x y z of each by `height` of the place.
template <class Height>
std::vector<ViewMm> scattered(std::size_t count, double left, const Height& height) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 100);
  std::vector<ViewMm> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = place(random);
    const double y = place(random);
    points.push_back({left + x, y - 40, height(x, y, i)});
  }
  return points;
}

TEST(LayerShares, OfOneSheetAreNone) {
  const auto points = scattered(20'000, -30, [](double x, double, std::size_t) { return 0.3 * x; });
  const LayerShares shares = layerShares(points);
  EXPECT_EQ(shares.layered, 0);
  EXPECT_EQ(shares.upright, 0);
}

TEST(LayerShares, OfTwoSheetsOverHalfTheGroundAreThatHalf) {
  // Over the right half every other point lies 20 mm deeper.
  const auto points = scattered(40'000, 1000, [](double x, double, std::size_t i) {
    return x > 50 && i % 2 == 0 ? -20.0 : 0.0;
  });
  EXPECT_NEAR(layerShares(points).layered, 0.5,
              0.05);  // A few points may lie side by side by chance.
  EXPECT_TRUE(liesInLayers(points));
}

TEST(LayerShares, OfAStepAreNoneThoughItsSquaresHoldBothHeights) {
  const auto points =
      scattered(40'000, 0, [](double x, double, std::size_t) { return x > 50 ? 20.0 : 0.0; });
  EXPECT_LT(layerShares(points).layered, 0.02);
}

TEST(LayerShares, DoNotDependOnTheOrderOfThePoints) {
  auto points = scattered(
      30'000, 0, [](double x, double y, std::size_t i) { return i % 3 == 0 ? x / 3 : 50 + y / 9; });
  const LayerShares before = layerShares(points);
  std::shuffle(points.begin(), points.end(), std::mt19937(9));
  const LayerShares after = layerShares(points);
  EXPECT_GT(before.layered, 0.5);
  EXPECT_EQ(before.layered, after.layered);
  EXPECT_EQ(before.upright, after.upright);
}

/// Points on the two large faces of boxes, as their area is; `from` and `to` are opposite corners.
std::vector<ViewMm> plates(std::size_t count, const std::vector<std::array<ViewMm, 2>>& boxes) {
  double all = 0;
  for (const auto& [from, to] : boxes) all += (to.x - from.x) * (to.y - from.y);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<ViewMm> points;
  for (const auto& [from, to] : boxes) {
    const ViewMm d = to - from;
    const auto members = static_cast<std::size_t>(static_cast<double>(count) * d.x * d.y / all);
    for (std::size_t i = 0; i < members; ++i) {
      points.push_back(
          {from.x + d.x * unit(random), from.y + d.y * unit(random), i % 2 == 0 ? from.z : to.z});
    }
  }
  return points;
}

TEST(LayerShares, AGripOfABladeSeenBroadsideLiesBehindItself) {
  // The blade's faces lie closer than its points, those of its grip, one point in fourteen, do not.
  const auto points =
      plates(20'000, {{{{0, 0, 0}, {200, 20, 0.1}}}, {{{200, 6, -4}, {240, 14, 4}}}});
  const LayerShares shares = layerShares(points);
  EXPECT_LT(shares.layered, kLayered);
  EXPECT_GT(shares.in_patches, 0.05);
  EXPECT_TRUE(liesInLayers(points));
}

TEST(LayerShares, OfABladeSeenEdgeOnAreMostThoughItCoversLittleOfItsBox) {
  // Tapered to its tip: 200 mm long, 1 mm thick, 10 mm high. Squares as wide as twice its thickness
  // would hold both faces side by side, and the tip's would not rise by six of their sides.
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<ViewMm> points;
  while (points.size() < 20'000) {
    const double x = unit(random);
    const double z = unit(random);
    if (z > 1 - x) continue;
    const double half = 0.5 - 0.4 * x;
    points.push_back({200 * x, points.size() % 2 == 0 ? half : -half, 10 * z});
  }
  EXPECT_GT(layerShares(points).layered, 0.8);
  EXPECT_TRUE(liesInLayers(points));
}

TEST(LayerShares, OfAnOpenStripAreNoneThoughItCoversLittleOfItsBox) {
  auto points = scattered(20'000, 0, [](double x, double y, std::size_t) { return 0.3 * x + y; });
  for (ViewMm& p : points) p = {4 * p.x, 0.05 * p.y, p.z / 9};
  const LayerShares shares = layerShares(points);
  EXPECT_LT(shares.layered, 0.01);
  EXPECT_FALSE(liesInLayers(points));
}

TEST(LayerShares, OfNoisyStepsLieAlongLinesAndDoNotMeet) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.42);  // 0.6 of the spacing.
  auto points =
      scattered(20'000, 0, [](double x, double, std::size_t) { return 30 * std::floor(x / 20); });
  for (ViewMm& p : points) p = {p.x + noise(random), p.y + noise(random), p.z + noise(random)};
  const LayerShares shares = layerShares(points);
  EXPECT_GT(shares.layered, 0.04);
  EXPECT_LT(shares.in_patches, 0.02);
  EXPECT_FALSE(liesInLayers(points));
}

TEST(LayerShares, OfPointsOnALineAndOfAFewAreNone) {
  std::vector<ViewMm> line;
  for (int i = 0; i < 1000; ++i) line.push_back({0.1 * i, 3, i % 2 == 0 ? 0.0 : 40.0});
  EXPECT_GT(layerShares(line).layered, 0.9);  // Two lines, one behind the other.
  line.resize(3);
  EXPECT_EQ(layerShares(line).layered, 0);
}

}  // namespace
}  // namespace relievo
