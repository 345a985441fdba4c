// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/relief_n.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo::samples {
namespace {

TEST(ReliefN, HasTheDensityNoiseAndHeightsItPromises) {
  const auto points = makeReliefN({.points = 200'000});
  ASSERT_EQ(points.size(), 200'000U);
  double squares = 0;
  double left = 0;
  double right = 0;
  for (const auto& p : points) {
    const double truth = reliefNHeightMm(static_cast<double>(p[0]), static_cast<double>(p[1]));
    ASSERT_GE(truth, 0);
    ASSERT_LE(truth, 5);
    ASSERT_FALSE(isReliefNHole(static_cast<double>(p[0]), static_cast<double>(p[1])));
    squares += std::pow(static_cast<double>(p[2]) - truth, 2);
    left += p[0] < 5 ? 1 : 0;
    right += p[0] > 95 ? 1 : 0;
  }
  EXPECT_NEAR(std::sqrt(squares / 200'000), kReliefNNoiseMm, 0.01 * kReliefNNoiseMm);
  // Densities at 2.5 and 97.5 mm: 1.075 to 3.925.
  EXPECT_NEAR(right / left, 3.925 / 1.075, 0.15);
}

TEST(ReliefN, ItsHolesHaveTheirArea) {
  double area = 0;
  for (const Disc& hole : kReliefNHoles) area += std::numbers::pi * hole.radius_mm * hole.radius_mm;
  EXPECT_NEAR(area, kReliefNHoleAreaMm2, 1e-9);
  EXPECT_TRUE(isReliefNHole(30, 60));
  EXPECT_FALSE(isReliefNHole(30, 66.01));
}

TEST(ReliefN, IsTheSameForTheSameSeedAndGrowsByAppending) {
  const auto few = makeReliefN({.points = 1000});
  const auto more = makeReliefN({.points = 3000});
  EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin()));
  EXPECT_NE(few, makeReliefN({.points = 1000, .seed = 801}));
}

TEST(ReliefN, OutliersAreAsManyAsAskedFor) {
  const auto points = makeReliefN({.points = 200'000, .outlier_share = 0.01});
  const auto outliers = std::count_if(points.begin(), points.end(), [](const auto& p) {
    const double truth = reliefNHeightMm(static_cast<double>(p[0]), static_cast<double>(p[1]));
    return std::abs(static_cast<double>(p[2]) - truth) > 0.15;
  });
  EXPECT_NEAR(static_cast<double>(outliers), 2000 * (1 - 0.15 / kReliefNOutlierMm), 150);
}

}  // namespace
}  // namespace relievo::samples
