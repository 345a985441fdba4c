// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/disc_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

namespace relievo {
namespace {

constexpr DiscRaster kRaster{.size = {.cols = 210, .rows = 170}, .pixel_mm = 0.5};

/// As surfaceDiscs makes them.
SurfaceDisc disc(std::array<float, 3> centre, std::array<float, 3> normal, float spacing) {
  SurfaceDisc made;
  made.centre = centre;
  made.normal = normal;
  const float length = std::hypot(normal[2], normal[0]);
  made.right = {normal[2] / length, 0, -normal[0] / length};
  const auto& [a, b, c] = normal;
  const auto& r = made.right;
  made.up = {b * r[2] - c * r[1], c * r[0] - a * r[2], a * r[1] - b * r[0]};
  made.radius = 1.95F * spacing;
  made.reach.fill(made.radius);
  made.spacing = spacing;
  return made;
}

/// A ball of 40 mm around the raster's middle, both its sides, in no order.
std::vector<SurfaceDisc> ballOfDiscs(std::size_t count) {
  std::mt19937 random(82);
  std::normal_distribution<float> normal(0, 1);
  std::vector<SurfaceDisc> discs;
  const auto spacing = static_cast<float>(40 * std::sqrt(4 * std::numbers::pi / double(count)));
  while (discs.size() < count) {
    std::array<float, 3> n{normal(random), normal(random), normal(random)};
    const float length = std::hypot(n[0], n[1], n[2]);
    for (float& c : n) c /= length;
    const std::array<float, 3> centre{52 + 40 * n[0], 42 + 40 * n[1], 50 + 40 * n[2]};
    if (n[2] < 0) n = {-n[0], -n[1], -n[2]};
    discs.push_back(disc(centre, n, spacing));
  }
  return discs;
}

bool areTheSameBytes(const std::vector<FrontPiece>& a, const std::vector<FrontPiece>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

TEST(DiscRaster, HiddenDiscsThatAreSkippedChangeNoByte) {
  for (const std::size_t count : {300U, 5000U, 40'000U}) {
    const std::vector<SurfaceDisc> discs = ballOfDiscs(count);
    EXPECT_TRUE(areTheSameBytes(drawDiscs(discs, kRaster, HiddenDiscs::skipped, {}),
                                drawDiscs(discs, kRaster, HiddenDiscs::drawn, {})))
        << count;
  }
}

TEST(DiscRaster, ADiscThatRisesOutOfTheFrontIsDrawnThoughItsMiddleIsHidden) {
  std::vector<SurfaceDisc> discs;
  for (int row = 0; row < 43; ++row) {
    for (int col = 0; col < 53; ++col) {
      discs.push_back(
          disc({2.0F * static_cast<float>(col), 2.0F * static_cast<float>(row), 10}, {0, 0, 1}, 2));
    }
  }
  SurfaceDisc rising = disc({60, 40, 5}, {-0.70710678F, 0, 0.70710678F}, 2);
  rising.radius = 16;
  rising.reach.fill(rising.radius);
  discs.push_back(rising);
  const auto pieces = drawDiscs(discs, kRaster, HiddenDiscs::skipped, {});
  EXPECT_TRUE(areTheSameBytes(pieces, drawDiscs(discs, kRaster, HiddenDiscs::drawn, {})));
  // 10 mm to the right of its middle it is 10 mm higher.
  const FrontPiece& piece = pieces[kRaster.size.index({.col = 140, .row = 80})];
  EXPECT_NEAR(static_cast<double>(piece.z), 15, 0.5);
}

TEST(DiscRaster, ShowsTheNearHalfOfABall) {
  const auto pieces = drawDiscs(ballOfDiscs(20'000), kRaster, HiddenDiscs::skipped, {});
  for (int row = 0; row < kRaster.size.rows; ++row) {
    for (int col = 0; col < kRaster.size.cols; ++col) {
      const double x = (col + 0.5) * kRaster.pixel_mm - 52;
      const double y = (row + 0.5) * kRaster.pixel_mm - 42;
      if (std::hypot(x, y) > 30) continue;
      const FrontPiece& piece = pieces[kRaster.size.index({.col = col, .row = row})];
      ASSERT_NEAR(static_cast<double>(piece.z), 50 + std::sqrt(1600 - x * x - y * y), 0.5);
    }
  }
}

TEST(DiscRaster, ARimHidesWhatLiesFarBehindAndMakesNothingWider) {
  // Spacing 4 mm, cut 2 mm beyond its middle to the right; the back ends at 53.
  SurfaceDisc cut = disc({50, 40, 40}, {0, 0, 1}, 4);
  cut.reach[0] = 2;
  SurfaceDisc back = disc({48, 40, 10}, {0, 0, 1}, 4);
  back.reach[0] = 5;
  const auto heightAt = [&](const std::vector<SurfaceDisc>& discs, double x) {
    const int col = static_cast<int>(x / kRaster.pixel_mm);
    return static_cast<double>(drawDiscs(discs, kRaster, HiddenDiscs::skipped,
                                         {})[kRaster.size.index({.col = col, .row = 80})]
                                   .z);
  };
  EXPECT_EQ(heightAt({cut, back}, 51.3), 40);
  EXPECT_EQ(heightAt({cut, back}, 52.8), 40);  // The rim: half a spacing.
  EXPECT_TRUE(std::isnan(heightAt({cut}, 52.8)));
  EXPECT_TRUE(std::isnan(heightAt({cut, back}, 53.3)));  // With nothing behind the object ends.
  back.reach[0] = 7;
  EXPECT_EQ(heightAt({cut, back}, 54.3), 10);  // Beyond the rim.
  back.centre[2] = 33;                         // Within two tolerances, 10.8 mm: the same surface.
  EXPECT_EQ(heightAt({cut, back}, 52.8), 33);
}

TEST(DiscRaster, WhatLiesFarDownASteepSurfaceDoesNotSinkItsUpperEdge) {
  // Rising by 5: half a spacing behind it, across it, is 2.5 spacings down along the view.
  const std::array<float, 3> normal{0.98058F, 0, 0.19612F};
  const SurfaceDisc edge = disc({50, 40, 40}, normal, 4);
  SurfaceDisc below = disc({50, 40, 30}, normal, 4);
  const std::size_t at = kRaster.size.index({.col = 100, .row = 80});
  const auto height = [&](const std::vector<SurfaceDisc>& discs) {
    return static_cast<double>(drawDiscs(discs, kRaster, HiddenDiscs::skipped, {})[at].z);
  };
  EXPECT_NEAR(height({edge}), 40, 2);
  EXPECT_NEAR(height({below}), height({edge}) - 10, 1e-4);
  EXPECT_EQ(height({edge, below}), height({edge}));
  below.centre[2] = 38;  // Within a spacing: the mean.
  EXPECT_NEAR(height({edge, below}), height({edge}) - 1, 1e-4);
}

TEST(DiscRaster, OfPiecesEquallyHighTheFirstOneSaysHowDenseThePointsAre) {
  std::vector<SurfaceDisc> discs;
  for (const float spacing : {4.0F, 8.0F, 2.0F, 6.0F, 3.0F}) {
    discs.push_back(disc({50, 40, 10}, {0, 0, 1}, spacing));
  }
  const std::size_t middle = kRaster.size.index({.col = 100, .row = 80});
  EXPECT_EQ(drawDiscs(discs, kRaster, HiddenDiscs::skipped, {})[middle].spacing, 4);
  // The fifth is drawn before the second.
  discs.front().centre[2] = 9;
  EXPECT_EQ(drawDiscs(discs, kRaster, HiddenDiscs::skipped, {})[middle].spacing, 8);
}

}  // namespace
}  // namespace relievo
