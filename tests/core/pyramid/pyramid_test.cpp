// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <random>

namespace relievo {
namespace {

DepthMap mapOf(int cols, int rows, double spacing) {
  DepthMap map;
  map.frame = {.size = {.cols = cols, .rows = rows},
               .spacing_mm = spacing,
               .first_x_mm = 0.5 * spacing,
               .first_y_mm = 0.5 * spacing};
  map.heights_mm.assign(map.frame.size.count(), 0);
  map.origins.assign(map.frame.size.count(), Origin::measured);
  return map;
}

DepthMap randomMap(int cols, int rows, unsigned seed) {
  DepthMap map = mapOf(cols, rows, 0.25);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> uniform(0, 30);
  for (float& z : map.heights_mm) z = uniform(random);
  return map;
}

TEST(Pyramid, EqualsOpenCvPyrDownAtEveryLevelAndSize) {
  for (const auto& [cols, rows] : {std::pair{1200, 800}, {801, 603}, {1024, 201}, {403, 5}}) {
    const DepthMap map = randomMap(cols, rows, 11);
    const Pyramid pyramid = buildPyramid(map);
    cv::Mat expected(rows, cols, CV_32F, const_cast<float*>(map.heights_mm.data()));
    for (std::size_t l = 1; l < pyramid.levels.size(); ++l) {
      cv::Mat next;
      cv::pyrDown(expected, next);
      expected = next;
      const PyramidLevel& level = pyramid.levels[l];
      ASSERT_EQ(level.frame.size.cols, expected.cols);
      ASSERT_EQ(level.frame.size.rows, expected.rows);
      for (int row = 0; row < expected.rows; ++row) {
        for (int col = 0; col < expected.cols; ++col) {
          const float ours = level.heights_mm[level.frame.size.index({.col = col, .row = row})];
          const float theirs = expected.at<float>(row, col);
          ASSERT_NEAR(ours, theirs, 1e-6F * 30) << l << ' ' << col << ' ' << row;
        }
      }
    }
  }
}

TEST(Pyramid, FollowsThePapersEquationWithItsIndices) {
  // g_l(i, j) = sum_{m,n=-2}^{2} w(m, n) g_{l-1}(2i + m, 2j + n), inside the map.
  const DepthMap map = randomMap(300, 260, 5);
  const Pyramid pyramid = buildPyramid(map);
  const double w[5] = {1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16};
  const PyramidLevel& coarse = pyramid.levels[1];
  for (const auto& [i, j] : {std::pair{1, 1}, {70, 60}, {148, 128}}) {
    double expected = 0;
    for (int m = -2; m <= 2; ++m) {
      for (int n = -2; n <= 2; ++n) {
        expected += w[m + 2] * w[n + 2] *
                    static_cast<double>(map.heightMm({.col = 2 * i + m, .row = 2 * j + n}));
      }
    }
    EXPECT_NEAR(coarse.heights_mm[coarse.frame.size.index({.col = i, .row = j})], expected, 1e-5);
  }
}

TEST(Pyramid, AConstantStaysThatConstantInMillimetres) {
  DepthMap map = mapOf(900, 700, 0.1);
  std::fill(map.heights_mm.begin(), map.heights_mm.end(), 12.5F);
  for (const PyramidLevel& level : buildPyramid(map).levels) {
    for (const float z : level.heights_mm) ASSERT_FLOAT_EQ(z, 12.5F);
  }
}

TEST(Pyramid, AnImpulseGivesTheKernel) {
  DepthMap map = mapOf(301, 301, 1);
  map.heights_mm[map.frame.size.index({.col = 150, .row = 150})] = 256;
  const PyramidLevel level = buildPyramid(map).levels[1];
  EXPECT_FLOAT_EQ(level.heights_mm[level.frame.size.index({.col = 75, .row = 75})], 36);
  EXPECT_FLOAT_EQ(level.heights_mm[level.frame.size.index({.col = 74, .row = 75})], 6);
  EXPECT_FLOAT_EQ(level.heights_mm[level.frame.size.index({.col = 76, .row = 76})], 1);
}

TEST(Pyramid, NodesLieAtFirstPlusIMlSpacing) {
  const DepthMap map = randomMap(1200, 800, 3);
  const Pyramid pyramid = buildPyramid(map);
  ASSERT_EQ(pyramid.levels.size(), 4U);
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    const GridFrame& frame = pyramid.levels[l].frame;
    EXPECT_DOUBLE_EQ(frame.spacing_mm, 0.25 * static_cast<double>(1U << l));
    EXPECT_DOUBLE_EQ(frame.first_x_mm, 0.125);
  }
  EXPECT_EQ(pyramid.levels[3].frame.size, (GridSize{.cols = 150, .rows = 100}));
}

TEST(Pyramid, SmoothingLowersVarianceAndStopsAt200) {
  const Pyramid pyramid = buildPyramid(randomMap(1601, 900, 9));
  double last = 1e300;
  for (const PyramidLevel& level : pyramid.levels) {
    double sum = 0;
    double squares = 0;
    for (const float z : level.heights_mm) {
      sum += static_cast<double>(z);
      squares += static_cast<double>(z) * static_cast<double>(z);
    }
    const auto n = static_cast<double>(level.heights_mm.size());
    const double variance = squares / n - (sum / n) * (sum / n);
    EXPECT_LT(variance, last);
    last = variance;
  }
  const GridSize coarsest = pyramid.levels.back().frame.size;
  EXPECT_LE(coarsest.cols, 200);
  EXPECT_LE(coarsest.rows, 200);
  const GridSize before = pyramid.levels[pyramid.levels.size() - 2].frame.size;
  EXPECT_GT(std::max(before.cols, before.rows), 200);
}

TEST(Pyramid, TheShareOfMeasuredCellsIsCarriedThroughTheSameKernel) {
  DepthMap map = mapOf(400, 400, 1);
  for (int row = 0; row < 400; ++row) {
    for (int col = 200; col < 400; ++col) {
      map.origins[map.frame.size.index({.col = col, .row = row})] = Origin::base_plane;
    }
  }
  const PyramidLevel level = buildPyramid(map).levels[1];
  const auto share = [&](int col) {
    return level.measured[level.frame.size.index({.col = col, .row = 50})];
  };
  EXPECT_FLOAT_EQ(share(20), 1);
  EXPECT_FLOAT_EQ(share(180), 0);
  EXPECT_FLOAT_EQ(share(100), 5.0F / 16);  // Cells 198 and 199 of 198..202.
}

}  // namespace
}  // namespace relievo
