// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/colour_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/depth/colours/linear_light.h"

namespace relievo {
namespace {

DepthMap mapOf(int cols, int rows) {
  DepthMap map;
  map.frame = {.size = {.cols = cols, .rows = rows},
               .spacing_mm = 0.5,
               .first_x_mm = 0.25,
               .first_y_mm = 0.25};
  map.heights_mm.assign(map.frame.size.count(), 1);
  map.origins.assign(map.frame.size.count(), CellStatus::measured);
  return map;
}

GridColours checker(GridSize size) {
  GridColours colours;
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const auto value = static_cast<std::uint8_t>((row + col) % 2 == 0 ? 0 : 255);
      colours.colours.push_back({value, value, value, 255});
      colours.intensities.push_back({value, 255});
    }
  }
  return colours;
}

std::vector<GridColours> all(const std::vector<StoredColours>& levels) {
  std::vector<GridColours> loose;
  for (const StoredColours& level : levels) loose.push_back(level.all());
  return loose;
}

TEST(ColourLevels, ACheckerOfSingleCellsIs188AtEveryCoarserLevel) {
  for (const double factor : {2.0, 3.0, 2.6}) {
    const DepthMap map = mapOf(801, 640);
    const Pyramid pyramid = buildPyramid(map, {.factor = factor, .coarsest_samples = 20});
    const auto levels = all(colourLevels(checker(map.frame.size), pyramid, 1));
    ASSERT_EQ(levels.size(), pyramid.levels.size());
    ASSERT_GE(levels.size(), 4U);
    for (std::size_t level = 1; level < levels.size(); ++level) {
      ASSERT_EQ(levels[level].colours.size(), pyramid.levels[level].frame.size.count());
      for (std::size_t i = 0; i < levels[level].colours.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(levels[level].colours[i][k], 188, 1);
        ASSERT_EQ(levels[level].colours[i][3], 255);
        ASSERT_NEAR(levels[level].intensities[i][0], 128, 1);
      }
    }
  }
}

/// By the definition, in double: sum of kernel times light over the cells with colour, divided by
/// the sum of the kernel there.
TEST(ColourLevels, EachIsTheKernelOverTheCellsThatHaveAColour) {
  const DepthMap map = mapOf(41, 33);
  std::mt19937 random(9);
  GridColours finest;
  for (std::size_t i = 0; i < map.frame.size.count(); ++i) {
    const std::uint8_t alpha = random() % 3 == 0 ? 0 : kStoredAlpha;
    finest.colours.push_back({static_cast<std::uint8_t>(random()),
                              static_cast<std::uint8_t>(random()),
                              static_cast<std::uint8_t>(random()), alpha});
  }
  const std::vector<Rgba> fine = finest.colours;
  const Pyramid pyramid = buildPyramid(map, {.coarsest_samples = 30});
  const auto levels = all(colourLevels(std::move(finest), pyramid, 1));
  const GridSize size = map.frame.size;
  const GridSize coarse = pyramid.levels[1].frame.size;
  const std::array<double, 5> kernel{1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16};
  const auto mirrored = [](int i, int n) { return i < 0 ? -i : i >= n ? 2 * n - 2 - i : i; };
  for (int row = 0; row < coarse.rows; ++row) {
    for (int col = 0; col < coarse.cols; ++col) {
      double sum = 0;
      double weights = 0;
      for (int m = -2; m <= 2; ++m) {
        for (int n = -2; n <= 2; ++n) {
          const Rgba& c = fine[size.index(
              {.col = mirrored(2 * col + n, size.cols), .row = mirrored(2 * row + m, size.rows)})];
          if (c[3] == 0) continue;
          const double w =
              kernel[static_cast<std::size_t>(m + 2)] * kernel[static_cast<std::size_t>(n + 2)];
          sum += w * sRgb().light[c[0]];
          weights += w;
        }
      }
      const Rgba made = levels[1].colours[coarse.index({.col = col, .row = row})];
      ASSERT_NEAR(made[3], 255 * weights, 0.51);
      ASSERT_EQ(made[0], sRgb().storedOf(static_cast<float>(sum / weights))) << col << ' ' << row;
    }
  }
}

TEST(ColourLevels, InterpolatedCellsCountOnlyWhereThereIsNothingElse) {
  const DepthMap map = mapOf(64, 64);
  GridColours finest;
  for (int i = 0; i < 64 * 64; ++i) {
    const bool left = i % 64 < 32;
    finest.colours.push_back(left ? Rgba{40, 40, 40, kStoredAlpha}
                                  : Rgba{250, 250, 250, kBetweenAlpha});
  }
  const Pyramid pyramid = buildPyramid(map, {.coarsest_samples = 40});
  const auto levels = all(colourLevels(std::move(finest), pyramid, 1));
  const GridSize size = pyramid.levels[1].frame.size;
  EXPECT_NEAR(levels[1].colours[size.index({.col = 15, .row = 9})][0], 40, 1);
  EXPECT_NEAR(levels[1].colours[size.index({.col = 16, .row = 9})][0], 40, 1);
  EXPECT_NEAR(levels[1].colours[size.index({.col = 25, .row = 9})][0], 250, 1);
}

TEST(ColourLevels, LargeHolesStayWithoutColour) {
  const DepthMap map = mapOf(128, 128);
  GridColours finest = checker(map.frame.size);
  for (int row = 32; row < 96; ++row) {
    for (int col = 32; col < 96; ++col) {
      finest.colours[map.frame.size.index({.col = col, .row = row})] = {};
    }
  }
  const Pyramid pyramid = buildPyramid(map, {.coarsest_samples = 40});
  const auto levels = all(colourLevels(std::move(finest), pyramid, 1));
  const GridSize size = pyramid.levels[2].frame.size;
  EXPECT_EQ(levels[2].colours[size.index({.col = 16, .row = 16})], Rgba{});
  EXPECT_NEAR(levels[2].colours[size.index({.col = 2, .row = 2})][0], 188, 1);
}

TEST(ColourLevels, TheBytesAreTheSameForAnyNumberOfThreadsAndNothingStaysNothing) {
  const DepthMap map = mapOf(300, 211);
  const Pyramid pyramid = buildPyramid(map);
  const auto one = colourLevels(checker(map.frame.size), pyramid, 1);
  EXPECT_EQ(colourLevels(checker(map.frame.size), pyramid, 3), one);
  EXPECT_TRUE(colourLevels({}, pyramid, 1).empty());
}

}  // namespace
}  // namespace relievo
