// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/front_surface.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/depth/layers/front_voids.h"
#include "core/depth/layers/layers.h"

namespace relievo {
namespace {

ViewBlocks blocksOf(const std::vector<ViewMm>& points, std::size_t size = 1000) {
  return [&points, size](const auto& take) {
    for (std::size_t first = 0; first < points.size(); first += size) {
      take(std::span(points).subspan(first, std::min(size, points.size() - first)));
    }
  };
}

/// Points scattered over squares of 100 mm at some heights.
std::vector<ViewMm> sheets(std::size_t count, const std::vector<double>& heights, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 100);
  std::vector<ViewMm> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({place(random), place(random), heights[i % heights.size()]});
  }
  return points;
}

constexpr ViewBox kBox{.min = {0, 0, 0}, .max = {100, 100, 60}};

double shareWithin(const std::vector<std::array<float, 3>>& points, float right) {
  std::size_t count = 0;
  for (const auto& p : points) count += p[0] < right ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(points.size());
}

TEST(EvenPoints, AreAllWhereThereAreFewAndTheSameInBlocksOfAnySize) {
  const auto points = sheets(5000, {10, 50}, 1);
  EXPECT_EQ(evenPoints(blocksOf(points), kBox, points.size(), 5000, {}).size(), 5000U);
  const auto few = evenPoints(blocksOf(points), kBox, points.size(), 800, {});
  EXPECT_GT(few.size(), 500U);
  EXPECT_LT(few.size(), 1300U);
  EXPECT_EQ(few, evenPoints(blocksOf(points, 7), kBox, points.size(), 800, {}));
}

TEST(EvenPoints, ThinDenseParts) {
  std::vector<ViewMm> points = sheets(40'000, {10}, 2);
  for (ViewMm& p : points) p.x = 100 * std::pow(p.x / 100, 4);  // Half of them in the first 6 mm.
  const auto even = evenPoints(blocksOf(points), kBox, points.size(), 2000, {});
  EXPECT_LT(shareWithin(even, 6.25F), 0.15);
}

TEST(EvenPoints, AreMeansThatBearLessNoise) {
  std::vector<ViewMm> points = sheets(50'000, {30}, 14);
  std::mt19937 random(14);
  std::normal_distribution<double> noise(0, 0.3);
  for (ViewMm& p : points) p.z += noise(random);
  const auto even = evenPoints(blocksOf(points), kBox, points.size(), 2000, {});
  double squares = 0;
  for (const auto& p : even) squares += std::pow(static_cast<double>(p[2]) - 30, 2);
  // Some 25 points in each, more where a cube's border does not cut the sheet.
  EXPECT_LT(std::sqrt(squares / static_cast<double>(even.size())), 0.1);
}

TEST(EvenPoints, LeaveOutStraysThatThinningWouldMakeMany) {
  std::vector<ViewMm> points = sheets(100'000, {10}, 13);
  std::mt19937 random(13);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 1000; ++i) {
    points.push_back({100 * place(random), 100 * place(random), 12 + 48 * place(random)});
  }
  const auto even = evenPoints(blocksOf(points), kBox, points.size(), 5000, {});
  const auto strays =
      std::count_if(even.begin(), even.end(), [](const auto& p) { return p[2] > 15; });
  EXPECT_GT(even.size(), 3500U);
  EXPECT_LT(strays, 50);
}

TEST(EvenPoints, LeaveOutStraysBesideTheSurface) {
  std::vector<ViewMm> points = sheets(100'000, {10}, 21);
  std::mt19937 random(21);
  std::uniform_real_distribution<double> place(0, 1);
  // Cubes are 1.4 mm wide: the next two to the sheet's, which have company enough.
  for (int i = 0; i < 1000; ++i) {
    points.push_back({100 * place(random), 100 * place(random), 11.5 + 2.5 * place(random)});
  }
  const auto even = evenPoints(blocksOf(points), kBox, points.size(), 5000, {});
  const auto strays =
      std::count_if(even.begin(), even.end(), [](const auto& p) { return p[2] > 11.5F; });
  EXPECT_GT(even.size(), 3500U);
  EXPECT_LT(strays, 100);
}

TEST(FrontSurface, TheNearerOfTwoSheetsHidesTheOther) {
  const auto points = sheets(20'000, {10, 50}, 3);
  const FrontSurface front(blocksOf(points), kBox, points.size(), {});
  std::size_t hidden = 0;
  std::size_t seen = 0;
  for (const ViewMm& p : points) {
    const FrontSurface::Side side = front.sideOf(p);
    if (p.z < 30) {
      hidden += side == FrontSurface::Side::hidden ? 1 : 0;
    } else {
      seen += side == FrontSurface::Side::front ? 1 : 0;
    }
  }
  // At the sheets' own border chance leaves bays, through which the lower one is seen.
  EXPECT_GE(hidden, 9'980U);
  EXPECT_EQ(seen, 10'000U);
  for (double x = 3; x < 97; x += 3.7) {
    for (double y = 3; y < 97; y += 3.1) EXPECT_NEAR(front.depthAt(x, y), 50, 1e-3);
  }
  EXPECT_NEAR(front.coveredMm2(), 10'000, 300);
  EXPECT_TRUE(std::isnan(front.depthAt(-5, 50)));
  EXPECT_EQ(front.sideOf({50, 50, 58}), FrontSurface::Side::stray);
}

/// Points on a plate with a round hole through it or into it, and on the ground below.
std::vector<ViewMm> plateWithHole(double radius, bool has_walls, unsigned seed) {
  std::vector<ViewMm> points = sheets(24'000, {10, 50}, seed);
  std::erase_if(
      points, [&](const ViewMm& p) { return p.z > 30 && std::hypot(p.x - 50, p.y - 50) < radius; });
  if (!has_walls) return points;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const double density = 1.2;  // Points on a square millimetre, as on the plate.
  const auto count = static_cast<int>(density * 2 * 3.14159265 * radius * 40);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * 3.14159265 * unit(random);
    points.push_back(
        {50 + radius * std::cos(angle), 50 + radius * std::sin(angle), 10 + 40 * unit(random)});
  }
  return points;
}

TEST(FrontSurface, AVoidBetweenPointsClosesANarrowHollowWithWallsStays) {
  // The spacing is 0.9 mm: chance leaves such a hole now and then, a drill leaves it with walls.
  const auto by_chance = plateWithHole(1.5, false, 4);
  const FrontSurface closed(blocksOf(by_chance), kBox, by_chance.size(), {});
  EXPECT_NEAR(closed.depthAt(50, 50), 50, 2);
  const auto drilled = plateWithHole(1.5, true, 4);
  const FrontSurface hollow(blocksOf(drilled), kBox, drilled.size(), {});
  EXPECT_LT(hollow.depthAt(50, 50), 48);
}

TEST(FrontSurface, AVoidClosesFromRimToRim) {
  // Less than four spacings across: off its middle one rim is farther than two.
  const auto by_chance = plateWithHole(2.3, false, 17);
  const FrontSurface closed(blocksOf(by_chance), kBox, by_chance.size(), {});
  for (const double off : {-1.5, -1.0, 0.0, 1.0, 1.5}) {
    EXPECT_NEAR(closed.depthAt(50 + off, 50), 50, 1e-3) << off;
    EXPECT_NEAR(closed.depthAt(50, 50 + off), 50, 1e-3) << off;
  }
}

/// Whether a gap of so many pixels in a front 40 mm above its back is closed. A spacing is four
/// pixels.
bool isClosed(int cols, int rows) {
  constexpr GridSize size{.cols = 80, .rows = 80};
  constexpr FrontPiece front{.z = 50, .tolerance = 1.4F, .spacing = 1};
  std::vector<FrontPiece> pieces(size.count(), front);
  for (int row = 20; row < 20 + rows; ++row) {
    for (int col = 20; col < 20 + cols; ++col) pieces[size.index({.col = col, .row = row})].z = 10;
  }
  closeVoids(pieces, size, 0.25, {}, {});
  return std::all_of(pieces.begin(), pieces.end(),
                     [](const FrontPiece& p) { return std::abs(p.z - 50) < 1e-3F; });
}

TEST(FrontSurface, AVoidNarrowerThanASpacingMayBeLonger) {
  EXPECT_TRUE(isClosed(10, 10)) << "less than four spacings from corner to corner";
  EXPECT_FALSE(isClosed(18, 18));
  for (const int wide : {1, 3}) {
    EXPECT_TRUE(isClosed(wide, 18)) << wide;
    EXPECT_TRUE(isClosed(18, wide)) << wide;
    EXPECT_FALSE(isClosed(wide, 26)) << "a slit " << wide;
    EXPECT_FALSE(isClosed(26, wide)) << "a slit " << wide;
  }
  EXPECT_FALSE(isClosed(6, 18)) << "a window";
}

TEST(FrontSurface, LiesInTheMiddleOfNoisyPoints) {
  std::vector<ViewMm> points = sheets(20'000, {10, 50}, 16);
  std::mt19937 random(16);
  std::normal_distribution<double> noise(0, 0.35);  // Of a spacing of 1 mm.
  for (ViewMm& p : points) p.z += noise(random);
  const FrontSurface front(blocksOf(points), kBox, points.size(), {});
  double sum = 0;
  int count = 0;
  for (double x = 5; x < 95; x += 0.7) {
    for (double y = 5; y < 95; y += 0.7, ++count) sum += static_cast<double>(front.depthAt(x, y));
  }
  EXPECT_NEAR(sum / count, 50, 0.1);
}

TEST(FrontSurface, AWideHoleShowsTheGround) {
  const auto points = plateWithHole(8, false, 5);
  const FrontSurface front(blocksOf(points), kBox, points.size(), {});
  EXPECT_NEAR(front.depthAt(50, 50), 10, 1e-3);
  // Discs do not reach over the edge by more than a spacing.
  double reached = 0;
  for (double x = 50; x < 58; x += 0.05) {
    if (front.depthAt(x, 50) < 30) reached = x - 50;
  }
  EXPECT_GT(reached, 8 - 1.2);
}

TEST(FrontSurface, PointsAloneInSpaceHideNothing) {
  auto points = sheets(20'000, {10}, 6);
  points.push_back({50, 50, 40});
  points.push_back({51, 50, 42});
  const FrontSurface front(blocksOf(points), kBox, points.size(), {});
  EXPECT_NEAR(front.depthAt(50, 50), 10, 1e-3);
  EXPECT_EQ(front.sideOf(points[20'000]), FrontSurface::Side::stray);
  EXPECT_EQ(front.sideOf(points[20'001]), FrontSurface::Side::stray);
}

TEST(LayerShares, TellSheetsFromSlopesStepsAndNoise) {
  EXPECT_GT(layerShares(sheets(20'000, {10, 50}, 7)).layered, 0.9);
  EXPECT_TRUE(liesInLayers(sheets(20'000, {10, 12}, 7)));  // Spacing 0.7 mm in each.
  EXPECT_EQ(layerShares(sheets(20'000, {10}, 8)).layered, 0);
  std::vector<ViewMm> slope = sheets(20'000, {0}, 9);
  for (ViewMm& p : slope) p.z = 4 * p.x;
  EXPECT_LT(layerShares(slope).layered, 0.03);
  std::vector<ViewMm> steps = sheets(20'000, {0}, 10);
  for (ViewMm& p : steps) p.z = 30 * std::floor(p.x / 20);
  EXPECT_LT(layerShares(steps).layered, 0.02);
  std::vector<ViewMm> noisy = sheets(20'000, {0}, 11);
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, 0.5);  // Of a spacing of 0.7 mm.
  for (ViewMm& p : noisy) p.z = p.x + noise(random);
  EXPECT_LT(layerShares(noisy).layered, 0.02);
  EXPECT_FALSE(liesInLayers({}));
  EXPECT_FALSE(liesInLayers(std::vector<ViewMm>(100, ViewMm{1, 2, 3})));
}

TEST(LayerShares, ABladeSeenEdgeOnStandsUpright) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<ViewMm> blade;
  for (int i = 0; i < 20'000; ++i) {
    blade.push_back({100 * unit(random), i % 2 == 0 ? 0.0 : 1.0, 30 * unit(random)});
  }
  EXPECT_TRUE(liesInLayers(blade));
}

TEST(FrontSurface, FewPointsOnALineOrASpotAreNoFault) {
  for (const std::vector<ViewMm>& points : {std::vector<ViewMm>{},
                                            {{1, 1, 1}},
                                            {{1, 1, 1}, {2, 1, 1}, {3, 1, 1}, {4, 1, 1}},
                                            std::vector<ViewMm>(50, ViewMm{3, 3, 3})}) {
    const ViewBox box{.min = {0, 0, 0}, .max = {10, 0, 1}};
    const FrontSurface front(blocksOf(points), box, points.size(), {});
    front.sideOf({1, 1, 1});
    front.depthAt(1, 0);
  }
}

}  // namespace
}  // namespace relievo
