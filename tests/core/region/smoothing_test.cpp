// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/pyramid/pyramid.h"

namespace relievo {
namespace {

/// A ridge of 1 mm height, one sample wide, along y.
DepthMap ridge(int cols, int col, double spacing_mm) {
  DepthMap map;
  map.frame = {.size = {.cols = cols, .rows = 9},
               .spacing_mm = spacing_mm,
               .first_x_mm = 0.5 * spacing_mm,
               .first_y_mm = 0.5 * spacing_mm};
  map.heights_mm.assign(map.frame.size.count(), 0);
  map.origins.assign(map.frame.size.count(), CellStatus::measured);
  for (int row = 0; row < map.frame.size.rows; ++row) {
    map.heights_mm[map.frame.size.index({.col = col, .row = row})] = 1;
  }
  return map;
}

/// How the height of a row lies about a place.
struct Moments {
  double sum = 0, second = 0;
  void add(const PyramidLevel& level, double place_mm) {
    for (int col = 0; col < level.frame.size.cols; ++col) {
      const double off = level.frame.first_x_mm + col * level.frame.spacing_mm - place_mm;
      const double z = level.heights_mm[level.frame.size.index({.col = col, .row = 0})];
      sum += z;
      second += z * off * off;
    }
  }
  double spreadMm() const { return std::sqrt(second / sum); }
};

TEST(Smoothing, IsHowWideALevelMakesARidgeOnAverageOverItsPlaces) {
  for (const double factor : {2.0, 3.0, 1.5}) {
    constexpr int kCols = 1537, kPlaces = 54;  // All places between the samples of some levels.
    std::vector<Moments> seen;
    DetailLadder ladder;
    for (int i = 0; i < kPlaces; ++i) {
      const DepthMap map = ridge(kCols, kCols / 2 + i, 0.25);
      const Pyramid pyramid = buildPyramid(map, {.factor = factor});
      ladder = detailLadder(map, pyramid);
      seen.resize(pyramid.levels.size());
      for (std::size_t l = 0; l < seen.size(); ++l) {
        seen[l].add(pyramid.levels[l], map.frame.xMm(kCols / 2 + i));
      }
    }
    ASSERT_GE(ladder.levels(), 3) << factor;
    EXPECT_EQ(smoothingMm(ladder, {0}), 0);
    for (int l = 1; l < 3; ++l) {
      EXPECT_NEAR(smoothingMm(ladder, {l}) / seen[static_cast<std::size_t>(l)].spreadMm(), 1, 0.02)
          << factor << ' ' << l;
    }
  }
}

TEST(Smoothing, OfThePapersFactorIsTheClosedForm) {
  // Variance 1 per step in its own spacings: (4^l - 1) / 3 squared spacings of the map.
  const DetailLadder ladder{.left_mm = 0,
                            .bottom_mm = 0,
                            .width_mm = 300,
                            .height_mm = 200,
                            .spacings_mm = {0.25, 0.5, 1, 2},
                            .factor = 2};
  for (int l = 0; l < 4; ++l) {
    EXPECT_NEAR(smoothingMm(ladder, {l}), 0.25 * std::sqrt((std::pow(4, l) - 1) / 3), 1e-12);
  }
}

}  // namespace
}  // namespace relievo
