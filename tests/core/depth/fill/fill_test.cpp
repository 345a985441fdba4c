// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/fill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

#include "core/depth/fill/mask.h"

namespace relievo {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

GridFrame squareFrame(int cells, double spacing) {
  return {.size = {.cols = cells, .rows = cells},
          .spacing_mm = spacing,
          .first_x_mm = 0.5 * spacing,
          .first_y_mm = 0.5 * spacing};
}

/// A full grid of heights 10 + x / 10 with a disc and a corner missing.
FrontDepths discMissing(const GridFrame& frame, double cx, double cy, double radius,
                        double corner) {
  FrontDepths depths(frame.size.count());
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const double x = frame.xMm(col);
      const double y = frame.yMm(row);
      const bool missing = std::hypot(x - cx, y - cy) < radius || (x < corner && y < corner);
      depths[frame.size.index({.col = col, .row = row})] =
          missing ? kNothing : static_cast<float>(10 + x / 10);
    }
  }
  return depths;
}

std::size_t countOf(const DepthMap& map, CellStatus origin) {
  return static_cast<std::size_t>(std::count(map.origins.begin(), map.origins.end(), origin));
}

TEST(FillDepths, AHoleRestsOnTheBasePlaneAndIsRememberedWithItsArea) {
  const GridFrame frame = squareFrame(200, 0.5);
  const FrontDepths depths = discMissing(frame, 60, 50, 10, 0);
  const FilledMap filled = fillDepths(depths, frame, {}, {});
  ASSERT_EQ(filled.holes.size(), 1U);
  EXPECT_NEAR(filled.holes[0].area_mm2, M_PI * 100, 0.02 * M_PI * 100);
  EXPECT_NEAR(filled.holes[0].centre_x_mm, 60, 0.25);
  EXPECT_NEAR(filled.holes[0].centre_y_mm, 50, 0.25);
  const Cell middle{.col = 120, .row = 100};
  EXPECT_EQ(filled.map.origin(middle), CellStatus::base_plane);
  EXPECT_EQ(filled.map.heightMm(middle), 0);
  EXPECT_EQ(countOf(filled.map, CellStatus::outside), 0U);
}

TEST(FillDepths, AMissingCornerIsOutsideNotAHole) {
  const GridFrame frame = squareFrame(200, 0.5);
  const FilledMap filled = fillDepths(discMissing(frame, 60, 50, 10, 20), frame, {}, {});
  EXPECT_EQ(filled.holes.size(), 1U);
  EXPECT_EQ(filled.map.origin({.col = 5, .row = 5}), CellStatus::outside);
  EXPECT_EQ(countOf(filled.map, CellStatus::outside), 40U * 40U);
}

TEST(FillDepths, SmallHolesAreInterpolatedOnRequestAndLargeOnesAreNot) {
  const GridFrame frame = squareFrame(200, 0.5);
  const FrontDepths depths = discMissing(frame, 60, 50, 10, 0);
  const HoleChoice small{.rule = HoleRule::interpolate, .max_area_mm2 = 100};
  EXPECT_FALSE(fillDepths(depths, frame, {}, small).holes[0].filled);
  const HoleChoice large{.rule = HoleRule::interpolate, .max_area_mm2 = 400};
  const FilledMap filled = fillDepths(depths, frame, {}, large);
  EXPECT_TRUE(filled.holes[0].filled);
  const Cell middle{.col = 120, .row = 100};
  EXPECT_EQ(filled.map.origin(middle), CellStatus::interpolated);
  // The rim is a plane from 15 to 17 mm; its middle lies at 16.
  EXPECT_NEAR(filled.map.heightMm(middle) + filled.base_z_mm, 16, 0.1);
}

TEST(FillDepths, HolesLeftOpenAreOutside) {
  const GridFrame frame = squareFrame(100, 1);
  const HoleChoice none{.rule = HoleRule::none};
  const FilledMap filled = fillDepths(discMissing(frame, 50, 50, 8, 0), frame, {}, none);
  EXPECT_EQ(filled.map.origin({.col = 50, .row = 50}), CellStatus::outside);
  EXPECT_EQ(countOf(filled.map, CellStatus::base_plane), 0U);
}

TEST(FillDepths, BasePlaneIsTheThousandthQuantileAndOutliersBelowStayNegative) {
  const GridFrame frame = squareFrame(100, 1);
  FrontDepths depths(frame.size.count());
  for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = static_cast<float>(i);
  depths[5000] = -500;
  const FilledMap filled = fillDepths(depths, frame, {.has_sampling_gaps = false}, {});
  // Sorted: -500, 0, 1, 2, ...; position 0.001 * 9999 = 9.999 lies between the values 8 and 9.
  EXPECT_NEAR(filled.base_z_mm, 8.999, 1e-6);
  EXPECT_LT(filled.map.heights_mm[5000], -500);
}

TEST(FillDepths, SamplingGapsOfAScatteredCloudAreFilledAndItsHoleIsKept) {
  // 1.6 points a cell at random leave a fifth of the cells empty; a disc of radius 12 is missing.
  const GridFrame frame = squareFrame(400, 0.25);
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> uniform(0, 100);
  FrontDepths depths(frame.size.count(), kNothing);
  const auto height = [](double x, double y) { return 2 * std::sin(x / 8) * std::cos(y / 9); };
  for (int i = 0; i < 256'000; ++i) {
    const double x = uniform(random);
    const double y = uniform(random);
    if (std::hypot(x - 50, y - 50) < 12) continue;
    const Cell cell{.col = static_cast<int>(x / 0.25), .row = static_cast<int>(y / 0.25)};
    depths[frame.size.index(cell)] =
        static_cast<float>(height(frame.xMm(cell.col), frame.yMm(cell.row)));
  }
  const FilledMap filled = fillDepths(depths, frame, {}, {});
  std::size_t open_gaps = 0;
  std::size_t kept = 0;
  std::size_t hole_cells = 0;
  double worst = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const double x = frame.xMm(col);
      const double y = frame.yMm(row);
      const double distance = std::hypot(x - 50, y - 50);
      const CellStatus origin = filled.map.origin({.col = col, .row = row});
      if (distance < 12) {
        ++hole_cells;
        kept += origin == CellStatus::base_plane ? 1 : 0;
      } else if (distance > 12.5) {
        open_gaps += origin == CellStatus::measured || origin == CellStatus::interpolated ? 0 : 1;
        const auto z = static_cast<double>(filled.map.heightMm({.col = col, .row = row}));
        worst = std::max(worst, std::abs(z + filled.base_z_mm - height(x, y)));
      }
    }
  }
  EXPECT_GE(static_cast<double>(kept), 0.9 * static_cast<double>(hole_cells));
  EXPECT_LE(open_gaps, 16U);  // of 142 000
  EXPECT_LT(worst, 0.15);     // slope 0.25 mm/mm over a gap of a few 0.25 mm cells
}

TEST(FillDepths, PointsOnARegularGridNeedNoGapClosing) {
  BitRows all({.cols = 100, .rows = 100});
  all.setRows(0, Mask(10000, 1));
  EXPECT_EQ(samplingGapRadius(all), 0);
  for (int row = 40; row < 44; ++row) {
    for (int col = 40; col < 44; ++col) all.clear(Cell{.col = col, .row = row});
  }
  EXPECT_EQ(samplingGapRadius(all), 0);
}

TEST(FillDepths, TheBackOfASparseCloudDoesNotShowThroughItsFront) {
  // Two sheets 30 mm apart, a point a cell each: where the front has no point the back appears.
  const GridFrame frame = squareFrame(200, 0.5);
  std::mt19937_64 random(12);
  std::uniform_int_distribution<std::size_t> cell(0, frame.size.count() - 1);
  FrontDepths depths(frame.size.count(), kNothing);
  for (int i = 0; i < 40'000; ++i) depths[cell(random)] = 0;
  for (int i = 0; i < 40'000; ++i) depths[cell(random)] = 30;
  const auto back = std::count(depths.begin(), depths.end(), 0.0F);
  ASSERT_GT(back, 5000);
  const FilledMap filled = fillDepths(depths, frame, {}, {});
  EXPECT_GT(static_cast<double>(filled.seen_through), 0.99 * static_cast<double>(back));
  const auto wrong = std::count_if(filled.map.heights_mm.begin(), filled.map.heights_mm.end(),
                                   [](float z) { return z < -20; });
  EXPECT_LT(wrong, 40);
}

TEST(FillDepths, AStraightWallInASparseCloudKeepsItsFoot) {
  const GridFrame frame = squareFrame(200, 0.5);
  std::mt19937_64 random(13);
  std::uniform_int_distribution<int> along(0, 199);
  FrontDepths depths(frame.size.count(), kNothing);
  for (int i = 0; i < 64'000; ++i) {
    const Cell c{.col = along(random), .row = along(random)};
    depths[frame.size.index(c)] = c.col < 100 ? 0.0F : 30.0F;
  }
  const FilledMap filled = fillDepths(depths, frame, {}, {});
  for (int row = 5; row < 195; ++row) {
    EXPECT_LT(filled.map.heightMm({.col = 97, .row = row}), 1) << row;
    EXPECT_GT(filled.map.heightMm({.col = 102, .row = row}), 25) << row;
  }
}

TEST(FillDepths, AGapBesideAnEdgeTakesItsHeightFromRightBesideIt) {
  // Lone gaps the second cell from a step of 30 mm; averages over blocks of cells would mix its
  // sides.
  const GridFrame frame = squareFrame(200, 0.5);
  FrontDepths depths(frame.size.count());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const std::size_t col = i % 200;
    const std::size_t row = i / 200;
    depths[i] = col < 101 ? 0.0F : 30.0F;
    if (row % 4 == 2 && (col == 99 || col == 102)) depths[i] = kNothing;
    if (row % 7 == 3 && col % 5 == 3 && (col < 90 || col > 110)) depths[i] = kNothing;
  }
  const FilledMap filled = fillDepths(CapturedDepths(depths), frame, {}, {});
  for (int row = 2; row < 200; row += 4) {
    EXPECT_FLOAT_EQ(filled.map.heightMm({.col = 99, .row = row}), 0) << row;
    EXPECT_FLOAT_EQ(filled.map.heightMm({.col = 102, .row = row}), 30) << row;
  }
}

TEST(FillDepths, WhatTheRuleFoundWhereTheBackShowsIsNotTakenForAGapsHeight) {
  const GridFrame frame = squareFrame(60, 0.5);
  CapturedDepths depths(FrontDepths(frame.size.count(), 20.0F));
  for (std::size_t i = 3; i < depths.front.size(); i += 17) depths.front[i] = kNothing;
  const std::size_t back = frame.size.index({.col = 30, .row = 30});
  depths.front[back] = 1;
  depths.between = depths.front;
  const FilledMap filled = fillDepths(std::move(depths), frame, {}, {});
  EXPECT_EQ(filled.seen_through, 1U);
  EXPECT_EQ(filled.map.origins[back], CellStatus::interpolated);
  EXPECT_FLOAT_EQ(filled.map.heights_mm[back], 0);  // The base plane is the front.
}

TEST(FillDepths, NothingHitIsRefused) {
  const GridFrame frame = squareFrame(10, 1);
  EXPECT_THROW(fillDepths(FrontDepths(100, kNothing), frame, {}, {}), ArgumentError);
}

TEST(OriginShares, SumToOne) {
  const GridFrame frame = squareFrame(200, 0.5);
  const FilledMap filled = fillDepths(discMissing(frame, 60, 50, 10, 20), frame, {}, {});
  const auto shares = originShares(filled.map);
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
}

TEST(Closed, ClosesGapsSmallerThanTheSquareAndKeepsLargerOnes) {
  Mask mask(400, 1);
  const GridSize size{.cols = 20, .rows = 20};
  for (int row = 5; row < 7; ++row) {
    for (int col = 5; col < 7; ++col) mask[size.index({.col = col, .row = row})] = 0;
  }
  for (int row = 12; row < 16; ++row) {
    for (int col = 12; col < 16; ++col) mask[size.index({.col = col, .row = row})] = 0;
  }
  const Mask result = closed(mask, size, 1);
  EXPECT_EQ(result[size.index({.col = 5, .row = 5})], 1);
  EXPECT_EQ(result[size.index({.col = 13, .row = 13})], 0);
  EXPECT_EQ(std::count(result.begin(), result.end(), 0), 16);
}

TEST(FillDepths, AMembraneGoesOnThroughAHoleAsTheSurfaceWas) {
  // A cubic is its own thin plate; the hole is given back to rounding.
  const GridFrame frame = squareFrame(80, 0.5);
  const auto height = [](double x, double y) {
    const double u = (x - 20) / 10;
    const double v = (y - 20) / 10;
    return 10 + u * u * u - 2 * u * v * v + 0.5 * v * v + 3 * u;
  };
  FrontDepths depths(frame.size.count());
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 80; ++col) {
      const double x = frame.xMm(col);
      const double y = frame.yMm(row);
      depths[frame.size.index({.col = col, .row = row})] =
          std::hypot(x - 22, y - 18) < 6 ? kNothing : static_cast<float>(height(x, y));
    }
  }
  const HoleChoice membrane{.rule = HoleRule::membrane, .max_area_mm2 = 1e9};
  const FilledMap filled = fillDepths(depths, frame, {}, membrane);
  ASSERT_EQ(filled.holes.size(), 1U);
  EXPECT_TRUE(filled.holes[0].filled);
  double worst = 0;
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 80; ++col) {
      const double truth = height(frame.xMm(col), frame.yMm(row)) - filled.base_z_mm;
      const auto z = static_cast<double>(filled.map.heightMm({.col = col, .row = row}));
      worst = std::max(worst, std::abs(z - truth));
    }
  }
  EXPECT_LT(worst, 1e-4);
  EXPECT_GT(countOf(filled.map, CellStatus::interpolated), 400U);
  EXPECT_FALSE(holesLeft(filled.holes, membrane));
}

TEST(FillDepths, AHoleThatCannotBeFilledIsSaidAndRestsOnTheBasePlane) {
  const GridFrame frame = squareFrame(200, 0.5);
  const FrontDepths depths = discMissing(frame, 60, 50, 10, 0);
  const HoleChoice choice{.rule = HoleRule::membrane, .max_area_mm2 = 100};
  const FilledMap filled = fillDepths(depths, frame, {}, choice);
  EXPECT_EQ(countOf(filled.map, CellStatus::interpolated), 0U);
  const std::optional<Message> left = holesLeft(filled.holes, choice);
  ASSERT_TRUE(left);
  EXPECT_THAT(englishText(*left), testing::StartsWith("0 of 1 holes filled. "));
  EXPECT_FALSE(holesLeft(filled.holes, {})) << "the base plane was asked for";
}

TEST(FillDepths, CellsThatTheSurfaceRunsThroughAreSteepAndKeepTheirHeight) {
  const GridFrame frame = squareFrame(20, 0.5);
  FrontDepths depths(frame.size.count());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const auto col = static_cast<int>(i % 20);
    depths[i] = col < 9 ? 0.0F : col > 11 ? 16.0F : 4.0F * static_cast<float>(col - 8);
  }
  const FilledMap filled = fillDepths(depths, frame, {}, {});
  for (int col = 0; col < 20; ++col) {
    const bool wall = col >= 9 && col <= 11;
    EXPECT_EQ(filled.map.origin({.col = col, .row = 7}),
              wall ? CellStatus::steep : CellStatus::measured)
        << col;
  }
  EXPECT_FLOAT_EQ(filled.map.heightMm({.col = 10, .row = 7}), 8);
}

TEST(FillDepths, WhatTheRuleFoundBetweenThePointsFillsTheGaps) {
  const GridFrame frame = squareFrame(30, 0.5);
  CapturedDepths depths(FrontDepths(frame.size.count(), 1.0F));
  depths.between = depths.front;
  std::mt19937 random(5);
  for (std::size_t i = 0; i < depths.front.size(); ++i) {
    if (random() % 10 < 4) depths.front[i] = kNothing;
  }
  const std::size_t gap = frame.size.index({.col = 10, .row = 10});
  depths.front[gap] = depths.front[gap + 7] = kNothing;
  depths.between[gap] = 1.25F;
  const FilledMap filled = fillDepths(std::move(depths), frame, {}, {});
  EXPECT_EQ(filled.map.origins[gap], CellStatus::interpolated);
  EXPECT_EQ(filled.map.origins[gap + 7], CellStatus::interpolated);
  EXPECT_FLOAT_EQ(filled.map.heights_mm[gap], 0.25F);
}

/// A wall is what rises or falls on both sides of a cell; a step has level ground on one.
TEST(SteepCells, WallsThatRiseOrFallAreSteepAndStepsAreNot) {
  const GridFrame frame{.size = {.cols = 9, .rows = 3}, .spacing_mm = 0.5};
  const auto steep = [&](std::vector<float> line, bool along_rows) {
    GridFrame f = frame;
    if (!along_rows) std::swap(f.size.cols, f.size.rows);
    FrontDepths depths;
    for (std::size_t i = 0; i < f.size.count(); ++i) {
      const std::size_t cols = static_cast<std::size_t>(f.size.cols);
      depths.push_back(line[along_rows ? i % cols : i / cols]);
    }
    Mask cells(f.size.count());
    markSteepCells(depths.data(), f.size, f.spacing_mm, cells);
    std::vector<int> found;
    for (std::size_t k = 0; k < line.size(); ++k) {
      found.push_back(cells[f.size.index(along_rows ? Cell{.col = static_cast<int>(k), .row = 1}
                                                    : Cell{.col = 1, .row = static_cast<int>(k)})]);
    }
    return found;
  };
  const std::vector<int> none(9, 0);
  for (const bool along_rows : {true, false}) {
    SCOPED_TRACE(along_rows);
    EXPECT_EQ(steep({0, 0, 0, 10, 20, 30, 30, 30, 30}, along_rows),
              (std::vector<int>{0, 0, 0, 1, 1, 0, 0, 0, 0}));
    EXPECT_EQ(steep({30, 30, 30, 20, 10, 0, 0, 0, 0}, along_rows),
              (std::vector<int>{0, 0, 0, 1, 1, 0, 0, 0, 0}));
    EXPECT_EQ(steep({30, 30, 30, 30, 0, 0, 0, 0, 0}, along_rows), none) << "a step down";
    EXPECT_EQ(steep({0, 0, 0, 0, 30, 30, 30, 30, 30}, along_rows), none) << "a step up";
    EXPECT_EQ(steep({0, 0, 0, 0, 30, 0, 0, 0, 0}, along_rows), none) << "a ridge";
  }
}

/// Where a square of (2r + 1)^2 cells is empty by chance once in ten thousand.
TEST(SamplingGapRadius, IsTheSmallestThatTheDensityAllows) {
  const GridSize size{.cols = 800, .rows = 800};
  for (int percent = 5; percent < 99; ++percent) {
    const double share = 0.01 * percent;
    const int radius = samplingGapRadius(std::vector<double>(64, share), size);
    const double density = -std::log(1 - share);
    const auto by_chance = [density](int r) { return std::exp(-density * std::pow(2 * r + 1, 2)); };
    EXPECT_LE(by_chance(radius), 1.02e-4) << share;
    if (radius > 0) {
      EXPECT_GT(by_chance(radius - 1), 1e-4) << share;
    }
  }
}

}  // namespace
}  // namespace relievo
