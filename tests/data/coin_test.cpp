// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/coin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "data/generate/ply_bytes.h"
#include "tests/data/checksum.h"
#include "tests/data/empty_squares.h"

namespace relievo::samples {
namespace {

const Cloud& coin() {
  static const Cloud kCloud = makeCoin();
  return kCloud;
}

TEST(Coin, HasHalfAMillionPointsAndIs24MillimetresAcross) {
  EXPECT_GE(coin().points.size(), 400'000U);
  EXPECT_LE(coin().points.size(), 600'000U);
  const auto [low, high] = std::minmax_element(coin().points.begin(), coin().points.end());
  EXPECT_NEAR((*high)[0] - (*low)[0], 24, 0.1);
}

TEST(Coin, PointsDifferFromTheTrueSurfaceByTheScannersNoise) {
  double sum = 0;
  double sum_of_squares = 0;
  for (const auto& [x, y, z] : coin().points) {
    // On a steep edge the rounding of x and y to 0.1 um moves the height by as much.
    const double off = z - coinHeightMm(x, y);
    ASSERT_LT(std::abs(off), 6 * kCoinNoiseMm + 0.001) << "at " << x << ", " << y;
    sum += off;
    sum_of_squares += off * off;
  }
  const auto n = static_cast<double>(coin().points.size());
  EXPECT_NEAR(sum / n, 0, 1e-4);
  EXPECT_NEAR(std::sqrt(sum_of_squares / n), kCoinNoiseMm, 2e-4);
}

TEST(Coin, LetteringRimAndWheelStandAboveTheField) {
  EXPECT_GT(coinHeightMm(11.5, 0), coinHeightMm(8.2, 0) + 0.3) << "rim";
  EXPECT_GT(coinHeightMm(5.9, 0.5), coinHeightMm(7, 0.5) + 0.2) << "wheel";
  double highest = 0;
  for (int degree = 0; degree < 360; ++degree) {
    const double angle = degree * 3.14159265 / 180;
    highest = std::max(highest, coinHeightMm(9.6 * std::cos(angle), 9.6 * std::sin(angle)));
  }
  EXPECT_GT(highest, coinHeightMm(8.2, 0) + 0.2) << "letters";
  EXPECT_TRUE(std::isnan(coinHeightMm(12.1, 0)));
}

TEST(Coin, IsEmptyInTheShadowOfReliefAndOnlyThere) {
  // With about 30 points in a square of 0.24 mm, an empty one is not chance.
  const SquareCounts counts(coin(), -12, -12, 24, 24, 0.24);
  const auto on_coin = [](double x, double y) { return std::hypot(x, y) < 11.5; };
  const std::size_t empty = counts.empty(on_coin);
  EXPECT_GT(empty, 5U);
  EXPECT_LT(empty, 300U);
  const auto flat_field = [](double x, double y) { return std::hypot(x - 8.2, y) < 0.2; };
  EXPECT_EQ(counts.empty(flat_field), 0U);
}

TEST(Coin, IsScannedMoreDenselyInSomePlacesThanInOthers) {
  const SquareCounts counts(coin(), -12, -12, 24, 24, 2);
  const auto both_passes = static_cast<double>(counts.at(-5, 5));
  const auto one_pass = static_cast<double>(counts.at(7, -5));
  EXPECT_GT(both_passes, 1.4 * one_pass);
}

TEST(Coin, ReferenceIsTheClosedFormAtItsSamples) {
  const Reference reference = coinReference();
  const std::size_t i = 400U * 801U + 123U;
  EXPECT_FLOAT_EQ(reference.z[i],
                  static_cast<float>(coinHeightMm(reference.x(123), reference.y(400))));
  EXPECT_TRUE(std::isnan(reference.z.front()));
}

TEST(Coin, GivesTheSameBytesOnEveryRun) {
  const std::string first = plyBytes(coin());
  EXPECT_EQ(first, plyBytes(makeCoin()));
  EXPECT_EQ(checksum(first), 15049460450343189638U);
}

}  // namespace
}  // namespace relievo::samples
