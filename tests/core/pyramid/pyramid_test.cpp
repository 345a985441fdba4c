// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <random>

#include "core/base/error.h"
#include "core/pyramid/kernel.h"

namespace relievo {
namespace {

DepthMap mapOf(int cols, int rows, double spacing) {
  DepthMap map;
  map.frame = {.size = {.cols = cols, .rows = rows},
               .spacing_mm = spacing,
               .first_x_mm = 0.5 * spacing,
               .first_y_mm = 0.5 * spacing};
  map.heights_mm.assign(map.frame.size.count(), 0);
  map.origins.assign(map.frame.size.count(), CellStatus::measured);
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
      map.origins[map.frame.size.index({.col = col, .row = row})] = CellStatus::base_plane;
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

constexpr double kFactors[] = {1.1, std::numbers::sqrt2, 1.5, 1.9, 2, 2.5, 3, 4, 5, 8};

DepthMap mapOfFunction(int cols, int rows, double (*height)(double, double)) {
  DepthMap map = mapOf(cols, rows, 1);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      map.heights_mm[map.frame.size.index({.col = col, .row = row})] =
          static_cast<float>(height(col, row));
    }
  }
  return map;
}

TEST(PyramidOfAnyFactor, AConstantAndItsMeasuredShareStay) {
  DepthMap map = mapOf(533, 420, 0.1);
  std::fill(map.heights_mm.begin(), map.heights_mm.end(), 12.5F);
  for (const double factor : kFactors) {
    for (const PyramidLevel& level : buildPyramid(map, {.factor = factor}).levels) {
      for (const float z : level.heights_mm) ASSERT_FLOAT_EQ(z, 12.5F) << factor;
      for (const float share : level.measured) ASSERT_FLOAT_EQ(share, 1) << factor;
    }
  }
}

TEST(PyramidOfAnyFactor, NodesLieAtFirstPlusIMlSpacingWithinTheMap) {
  for (const double factor : kFactors) {
    const Pyramid pyramid = buildPyramid(randomMap(701, 512, 4), {.factor = factor});
    EXPECT_EQ(pyramid.factor, factor);
    ASSERT_GT(pyramid.levels.size(), 1U);
    const GridFrame& base = pyramid.levels[0].frame;
    for (std::size_t l = 1; l < pyramid.levels.size(); ++l) {
      const GridFrame& fine = pyramid.levels[l - 1].frame;
      const GridFrame& frame = pyramid.levels[l].frame;
      EXPECT_EQ(frame.spacing_mm, base.spacing_mm * std::pow(factor, static_cast<double>(l)));
      EXPECT_EQ(frame.first_x_mm, base.first_x_mm);
      EXPECT_EQ(frame.first_y_mm, base.first_y_mm);
      EXPECT_LE(frame.xMm(frame.size.cols - 1), fine.xMm(fine.size.cols - 1) + 1e-6);
      EXPECT_GT(frame.xMm(frame.size.cols), fine.xMm(fine.size.cols - 1));
      if (factor == std::floor(factor)) {
        EXPECT_EQ(frame.size.rows, std::ceil(fine.size.rows / factor));
      }
    }
  }
}

TEST(PyramidOfAnyFactor, APlaneStaysThatPlaneAtTheNodesAwayFromTheBorder) {
  // Holds only if the kernel is centred on the node's own place between the samples.
  const DepthMap map =
      mapOfFunction(430, 410, [](double x, double y) { return 0.125 * x - 0.25 * y; });
  for (const double factor : kFactors) {
    const PyramidLevel level = buildPyramid(map, {.factor = factor}).levels[1];
    const double tolerance = factor < 1.6 ? 2e-3 : 1e-4;  // Narrow kernels meet few samples.
    for (int row = 20; row < level.frame.size.rows - 20; ++row) {
      for (int col = 20; col < level.frame.size.cols - 20; ++col) {
        ASSERT_NEAR(level.heights_mm[level.frame.size.index({.col = col, .row = row})],
                    factor * (0.125 * col - 0.25 * row), tolerance)
            << factor << ' ' << col << ' ' << row;
      }
    }
  }
}

TEST(PyramidOfAnyFactor, IsTheDoubleSumOverTheMirroredMap) {
  const DepthMap map = randomMap(251, 230, 6);
  for (const double factor : {1.5, 3.0}) {
    const PyramidLevel level = buildPyramid(map, {.factor = factor}).levels[1];
    const double variance = kernelVariance(factor);
    const auto mirror = [](int i, int n) { return i < 0 ? -i : (i >= n ? 2 * (n - 1) - i : i); };
    const Cell last{.col = level.frame.size.cols - 1, .row = level.frame.size.rows - 1};
    for (const Cell node : {Cell{}, {.col = 40, .row = 31}, last}) {
      double sum = 0;
      double weights = 0;
      for (int n = -9; n <= 9; ++n) {
        for (int m = -9; m <= 9; ++m) {
          const int x = static_cast<int>(std::floor(node.col * factor)) + m;
          const int y = static_cast<int>(std::floor(node.row * factor)) + n;
          const double dx = x - node.col * factor;
          const double dy = y - node.row * factor;
          const double w = std::exp(-0.5 * (dx * dx + dy * dy) / variance);
          const Cell cell{.col = mirror(x, 251), .row = mirror(y, 230)};
          sum += w * static_cast<double>(map.heightMm(cell));
          weights += w;
        }
      }
      // The sum here ends elsewhere in the tails than the kernel's five standard deviations.
      EXPECT_NEAR(level.heights_mm[level.frame.size.index(node)], sum / weights, 1e-3);
    }
  }
}

TEST(PyramidOfAnyFactor, LessThanThreeTenthsPassAtTheNewNyquistFrequency) {
  for (const double factor :
       {1.0001, 1.2, std::numbers::sqrt2, 1.5, 1.93, 2.0, 2.01, 3.0, 4.0, 5.0, 6.7, 8.0}) {
    EXPECT_LE(gainAtNyquist(factor), kMostNyquistGain + 1e-12) << factor;
    EXPECT_GT(gainAtNyquist(factor), 0.15) << factor << ": smoother than it need be";
  }
  EXPECT_DOUBLE_EQ(gainAtNyquist(2), 0.25);
}

TEST(PyramidOfAnyFactor, TheVarianceIsThatOfTheLawWhereTheGainAllows) {
  for (const double factor : {1.95, 2.0, 2.5, 3.0, 4.0, 8.0}) {
    EXPECT_DOUBLE_EQ(kernelVariance(factor), (factor * factor - 1) / 3);
  }
  for (const double factor : {1.95, 2.0, 3.0, 4.0, 8.0}) {
    const Taps taps = tapsAt(100, factor);
    double variance = 0;
    for (std::size_t k = 0; k < taps.weights.size(); ++k) {
      const double distance = taps.first + static_cast<double>(k) - 100;
      variance += taps.weights[k] * distance * distance;
    }
    EXPECT_NEAR(variance, (factor * factor - 1) / 3, 2e-3 * variance);
  }
  EXPECT_GT(kernelVariance(std::numbers::sqrt2), 1.0 / 3);
}

TEST(PyramidOfAnyFactor, FourAtOnceIsTwoTwice) {
  const DepthMap map = mapOfFunction(
      801, 801, [](double x, double y) { return 5 * std::sin(x / 9) * std::cos(y / 12); });
  const PyramidLevel once = buildPyramid(map, {.factor = 4}).levels[1];
  const PyramidLevel twice = buildPyramid(map, {.factor = 2}).levels[2];
  ASSERT_EQ(once.frame, twice.frame);
  double least = 0;
  double smoothed = 0;
  for (int row = 5; row < once.frame.size.rows - 5; ++row) {
    for (int col = 5; col < once.frame.size.cols - 5; ++col) {
      const std::size_t i = once.frame.size.index({.col = col, .row = row});
      least = std::max(least, std::abs(static_cast<double>(once.heights_mm[i]) -
                                       static_cast<double>(twice.heights_mm[i])));
      smoothed = std::max(
          smoothed, std::abs(static_cast<double>(once.heights_mm[i]) -
                             static_cast<double>(map.heightMm({.col = 4 * col, .row = 4 * row}))));
    }
  }
  EXPECT_GT(smoothed, 0.1);  // Equal because of equal smoothing, not for want of it.
  EXPECT_LT(least, 0.005);
}

TEST(PyramidOfAnyFactor, AWaveAboveTheNewNyquistFrequencyIsSuppressed) {
  for (const double factor : kFactors) {
    DepthMap map = mapOf(601, 30, 1);
    // A quarter above the new limit, where the fine grid still holds it.
    const double omega = std::min(1.25 * std::numbers::pi / factor, 0.98 * std::numbers::pi);
    for (int row = 0; row < 30; ++row) {
      for (int col = 0; col < 601; ++col) {
        map.heights_mm[map.frame.size.index({.col = col, .row = row})] =
            static_cast<float>(std::cos(omega * col));
      }
    }
    const PyramidLevel level = buildPyramid(map, {.factor = factor}).levels[1];
    const int border = static_cast<int>(20 / factor) + 1;
    for (int col = border; col < level.frame.size.cols - border; ++col) {
      ASSERT_LE(std::abs(level.heights_mm[static_cast<std::size_t>(col)]), 0.33F) << factor;
    }
  }
}

TEST(PyramidOfAnyFactor, GivesTheSameBytesForEveryNumberOfThreads) {
  const DepthMap map = randomMap(1301, 1207, 8);
  for (const double factor : {1.5, 2.0, 3.0}) {
    const Pyramid one = buildPyramid(map, {.factor = factor, .threads = 1});
    for (const int threads : {0, 2, 3}) {
      const Pyramid more = buildPyramid(map, {.factor = factor, .threads = threads});
      ASSERT_EQ(more.levels.size(), one.levels.size());
      for (std::size_t l = 0; l < one.levels.size(); ++l) {
        EXPECT_EQ(more.levels[l].heights_mm, one.levels[l].heights_mm) << factor << ' ' << threads;
        EXPECT_EQ(more.levels[l].measured, one.levels[l].measured) << factor << ' ' << threads;
      }
    }
  }
}

TEST(PyramidOfAnyFactor, StopsWhenAskedOnEveryThread) {
  std::stop_source stop;
  stop.request_stop();
  const Task task{.stop = stop.get_token(), .progress = {}};
  for (const double factor : {2.0, 3.0}) {
    EXPECT_THROW(buildPyramid(mapOf(900, 900, 1), {.factor = factor, .threads = 2}, task),
                 Cancelled);
  }
}

TEST(PyramidOfAnyFactor, RefusesFactorsThatMakeNoPyramid) {
  const DepthMap map = mapOf(300, 300, 1);
  for (const double factor : {-2.0, 0.0, 1.0, 8.001, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(buildPyramid(map, {.factor = factor}), ArgumentError) << factor;
  }
  EXPECT_THROW(buildPyramid(mapOf(3000, 3000, 1), {.factor = 1.0001}), ArgumentError);
}

/// Maps from elsewhere may hold anything where they have no height.
TEST(BuildPyramid, CellsOnTheBasePlaneAndOutsideTakePartAsNought) {
  DepthMap map;
  map.frame = {.size = {.cols = 300, .rows = 250}, .spacing_mm = 1};
  map.heights_mm.assign(map.frame.size.count(), 7.0F);
  map.origins.assign(map.heights_mm.size(), CellStatus::measured);
  DepthMap clean = map;
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (i % 300 < 100) map.origins[i] = clean.origins[i] = CellStatus::base_plane;
    if (i % 300 > 200) map.origins[i] = clean.origins[i] = CellStatus::outside;
    if (map.origins[i] == CellStatus::measured) continue;
    map.heights_mm[i] = 1000;
    clean.heights_mm[i] = 0;
  }
  const Pyramid made = buildPyramid(map);
  const Pyramid expected = buildPyramid(clean);
  ASSERT_GE(made.levels.size(), 2U);
  for (std::size_t l = 0; l < made.levels.size(); ++l) {
    EXPECT_TRUE(std::ranges::equal(made.levels[l].heights_mm, expected.levels[l].heights_mm)) << l;
  }
  EXPECT_EQ(made.levels[0].heights_mm[50], 0);
  EXPECT_EQ(made.levels[0].heights_mm[250], 0);
  EXPECT_EQ(made.levels[0].heights_mm[150], 7);
}

}  // namespace
}  // namespace relievo
