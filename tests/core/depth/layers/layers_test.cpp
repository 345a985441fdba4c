// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/layers.h"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(LayerShares, OfPointsOnALineAndOfAFewAreNone) {
  std::vector<ViewMm> line;
  for (int i = 0; i < 1000; ++i) line.push_back({0.1 * i, 3, i % 2 == 0 ? 0.0 : 40.0});
  EXPECT_GT(layerShares(line).layered, 0.9);  // Two lines, one behind the other.
  line.resize(3);
  EXPECT_EQ(layerShares(line).layered, 0);
}

}  // namespace
}  // namespace relievo
