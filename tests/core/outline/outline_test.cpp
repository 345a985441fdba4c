// SPDX-License-Identifier: BSD-3-Clause
// Outlines of areas whose edges are known: circle, square, ring, the dome of relief F; and none
// where an edge was not seen all round.
#include "core/outline/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/base/line_corners.h"
#include "core/outline/level_lines.h"
#include "core/outline/two_groups.h"
#include "data/generate/relief_f.h"

namespace relievo {
namespace {

using Heights = std::function<double(double x, double y)>;
using Origins = std::function<CellStatus(double x, double y)>;
constexpr std::uint8_t kAllEdges = 15;
constexpr double kSideMm = 80, kCellMm = kSideMm / kWindowSamples, kToleranceMm = 0.3;

RegionWindow windowOf(const Heights& height, const Origins& origin = {}, double side_mm = kSideMm,
                      double x_mm = 0, double y_mm = 0) {
  RegionWindow window;
  window.region = {x_mm, y_mm, side_mm, {}};
  for (std::size_t i = 0; i < kWindowCount; ++i) {
    const double x = x_mm + (static_cast<double>(i % kWindowSamples) + 0.5) * window.spacingMm();
    const double y = y_mm + (static_cast<double>(i / kWindowSamples) + 0.5) * window.spacingMm();
    window.origins.push_back(origin ? origin(x, y) : CellStatus::measured);
    window.heights_mm.push_back(
        window.origins.back() == CellStatus::outside ? 0 : static_cast<float>(height(x, y)));
  }
  return window;
}

/// A rise of 8 mm over 4 mm of way, where `inside_mm`, the distance within the edge, is 0.
double rise(double inside_mm) {
  return 4 + 4 * std::tanh(inside_mm);
}

/// Largest distance of a closed line's points, corners and between, from a curve.
double farthest(const Outline& outline, const std::function<double(ViewMm)>& distance) {
  double most = 0;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const ViewMm a = outline.corners[i], b = outline.corners[(i + 1) % outline.corners.size()];
    for (int k = 0; k < 10; ++k) most = std::max(most, std::abs(distance(a + 0.1 * k * (b - a))));
  }
  return most;
}

/// x (counter-clockwise: > 0) of the area that a line encloses, mm2.
double areaOf(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const ViewMm a = outline.corners[i], b = outline.corners[(i + 1) % outline.corners.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

TEST(Outline, ACircleComesBackAsThatCircle) {
  const auto inside = [](double x, double y) { return 16 - std::hypot(x - 36, y - 44); };
  const auto outlines = raisedOutlines(
      windowOf([&](double x, double y) { return rise(inside(x, y)); }), kToleranceMm);
  ASSERT_EQ(outlines.size(), 1U);
  const Outline& circle = outlines[0];
  EXPECT_EQ(circle.of, OutlineOf::raised);
  EXPECT_LT(farthest(circle, [&](ViewMm p) { return inside(p.x, p.y); }), kToleranceMm + kCellMm);
  EXPECT_NEAR(circle.lengthMm(), 2 * std::numbers::pi * 16, 1.5);
  EXPECT_NEAR(circle.share, std::numbers::pi * 16 * 16 / (kSideMm * kSideMm), 0.005);
  EXPECT_GT(areaOf(circle), 0) << "what is higher lies left";
  EXPECT_LT(circle.corners.size(), 60U) << "simplified";
  for (const ViewMm& p : circle.corners) EXPECT_NEAR(p.z, rise(inside(p.x, p.y)), 0.1);
}

TEST(Outline, ASquareHasItsFourCorners) {
  const auto inside = [](double x, double y) {
    return 20 - std::max(std::abs(x - 40), std::abs(y - 40));
  };
  const auto outlines = raisedOutlines(
      windowOf([&](double x, double y) { return rise(2 * inside(x, y)); }), kToleranceMm);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_LT(farthest(outlines[0], [&](ViewMm p) { return inside(p.x, p.y); }),
            kToleranceMm + kCellMm);
  EXPECT_NEAR(outlines[0].lengthMm(), 160, 3);
  EXPECT_LE(outlines[0].corners.size(), 12U);
  for (const double x : {20.0, 60.0}) {
    for (const double y : {20.0, 60.0}) {
      double nearest = 1e9;
      for (const ViewMm& p : outlines[0].corners) {
        nearest = std::min(nearest, std::hypot(p.x - x, p.y - y));
      }
      EXPECT_LT(nearest, 1.2) << x << ", " << y;
    }
  }
}

TEST(Outline, ARingHasAnOuterAndAnInnerEdge) {
  const auto outlines = raisedOutlines(windowOf([](double x, double y) {
                                         const double r = std::hypot(x - 40, y - 40);
                                         return rise(6 - std::abs(r - 20));
                                       }),
                                       kToleranceMm);
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_EQ(outlines[0].of, OutlineOf::raised);
  EXPECT_NEAR(outlines[0].lengthMm(), 2 * std::numbers::pi * 26, 2);
  EXPECT_EQ(outlines[1].of, OutlineOf::sunk);
  EXPECT_NEAR(outlines[1].lengthMm(), 2 * std::numbers::pi * 14, 2);
  EXPECT_EQ(nearestOutline(outlines, 40, 40), &outlines[1]);
  EXPECT_EQ(nearestOutline(outlines, 79, 40), &outlines[0]);
}

TEST(Outline, TheDomeOfReliefFIsLedAroundNearItsFoot) {
  // Its whole window: 300 mm wide, what is beyond the plate is outside.
  const auto window = windowOf(
      samples::reliefFHeightMm,
      [](double x, double y) {
        if (samples::isOutside(x, y)) return CellStatus::outside;
        return samples::isHole(x, y) ? CellStatus::base_plane : CellStatus::measured;
      },
      300, 0, -50);
  const samples::Disc dome = samples::kReliefFCap;
  const auto away = [&](ViewMm p) { return std::hypot(p.x - dome.x_mm, p.y - dome.y_mm); };
  const Outline* of_dome = nullptr;
  const auto outlines = raisedOutlines(window, 1.1);  // 0.3 mm of hand.
  for (const Outline& outline : outlines) {
    if (away(outline.corners[0]) < dome.radius_mm + 5) of_dome = &outline;
  }
  ASSERT_NE(of_dome, nullptr);
  // The cap of a sphere is steepest at its foot; where 3 x 3 samples see both, it is less so.
  constexpr double kHigh = samples::kReliefFCapHeightMm, kFoot = samples::kReliefFCap.radius_mm;
  constexpr double kSphere = (kFoot * kFoot + kHigh * kHigh) / (2 * kHigh);
  const double above_centre = kSphere - kHigh + of_dome->level_mm;
  const double at_level = std::sqrt(kSphere * kSphere - above_centre * above_centre);
  EXPECT_GT(at_level, 54) << "of level " << of_dome->level_mm;
  EXPECT_LT(at_level, kFoot);
  for (const ViewMm& p : of_dome->corners) EXPECT_NEAR(away(p), at_level, 1.5);
  std::vector<float> heights = window.heights_mm;
  std::sort(heights.begin(), heights.end());
  EXPECT_LT(of_dome->level_mm, partedInTwo(heights).threshold_mm - 2)
      << "the steepest line and not the threshold";
}

TEST(Outline, TheBorderOfReliefFGoesRoundItsMissingCorner) {
  const auto window = windowOf(
      samples::reliefFHeightMm,
      [](double x, double y) {
        return samples::isOutside(x, y) ? CellStatus::outside : CellStatus::measured;
      },
      300, 0, -50);
  const auto outlines = objectOutlines(window, kAllEdges, 1.1);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(outlines[0].of, OutlineOf::object);
  EXPECT_NEAR(areaOf(outlines[0]), 300 * 200 - 20 * 20, 0.01 * 300 * 200);
  double nearest = 1e9;  // The corner that looks inward, 20 mm from either side.
  for (const ViewMm& p : outlines[0].corners) {
    nearest = std::min(nearest, std::hypot(p.x - 280, p.y - 20));
  }
  EXPECT_LT(nearest, 2.5);
  // A window that ends within the object has no border there.
  EXPECT_TRUE(objectOutlines(window, 0, 1.1).empty());
}

TEST(Outline, AnEdgeThatWasNotSeenAllRoundIsNone) {
  const auto height = [](double x, double y) { return rise(16 - std::hypot(x - 40, y - 40)); };
  const auto gap = [](CellStatus as) {
    return [as](double x, double y) {
      return std::hypot(x - 56, y - 40) < 2 ? as : CellStatus::measured;
    };
  };
  EXPECT_EQ(raisedOutlines(windowOf(height), kToleranceMm).size(), 1U);
  for (const CellStatus origin :
       {CellStatus::interpolated, CellStatus::base_plane, CellStatus::outside}) {
    EXPECT_TRUE(raisedOutlines(windowOf(height, gap(origin)), kToleranceMm).empty());
  }
  EXPECT_EQ(raisedOutlines(windowOf(height, gap(CellStatus::steep)), kToleranceMm).size(), 1U);
  const auto at_border = [](double x, double y) { return rise(16 - std::hypot(x - 10, y - 40)); };
  EXPECT_TRUE(raisedOutlines(windowOf(at_border), kToleranceMm).empty());
}

TEST(Outline, PlanesNoiseAndSmallAreasHaveNone) {
  EXPECT_TRUE(outlinesOf(windowOf([](double, double) { return 3; }), 0, kToleranceMm).empty());
  EXPECT_TRUE(outlinesOf(windowOf([](double x, double) { return x; }), 0, kToleranceMm).empty());
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  EXPECT_TRUE(raisedOutlines(windowOf([&](double, double) { return noise(random); }), kToleranceMm)
                  .empty());
  const auto small = [](double x, double y) { return rise(3 - std::hypot(x - 40, y - 40)); };
  EXPECT_TRUE(raisedOutlines(windowOf(small), kToleranceMm).empty()) << "0.4 % of the window";
  const auto nothing = windowOf([](double, double) { return 0; },
                                [](double, double) { return CellStatus::outside; });
  EXPECT_TRUE(outlinesOf(nothing, kAllEdges, kToleranceMm).empty());
}

TEST(Outline, LinesOfRandomHillsLieOnTheirLevel) {
  int found = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(15, 65), width(5, 12), size(-6, 6);
    std::vector<std::array<double, 4>> hills(4);
    for (auto& hill : hills) hill = {place(random), place(random), width(random), size(random)};
    const RegionWindow window = windowOf([&](double x, double y) {
      double sum = 0;
      for (const auto& [at_x, at_y, wide, high] : hills) {
        const double r = std::hypot(x - at_x, y - at_y) / wide;
        sum += high * std::exp(-r * r);
      }
      return sum;
    });
    for (const Outline& outline : raisedOutlines(window, kToleranceMm)) {
      ++found;
      ASSERT_GE(outline.corners.size(), 3U) << "seed " << seed;
      EXPECT_EQ(areaOf(outline) > 0, outline.of == OutlineOf::raised) << "seed " << seed;
      for (const ViewMm& p : outline.corners) {
        // The mean of 3 x 3 samples differs by what is bent within a cell.
        EXPECT_NEAR(p.z, outline.level_mm, 0.2) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(found, 20);
}

TEST(LevelLines, ASaddleIsPartedAsItsMiddleSays) {
  Samples samples{.cols = 4,
                  .rows = 4,
                  .values = std::vector<double>(16, 0),
                  .has = std::vector<bool>(16, true)};
  samples.values[samples.at(1, 1)] = samples.values[samples.at(2, 2)] = 3;
  EXPECT_EQ(closedLevelLines(samples, 1).size(), 1U) << "the middle is 1.5: they hang together";
  EXPECT_EQ(closedLevelLines(samples, 2).size(), 2U);
}

TEST(LineCorners, AreThoseOfThePolygonAndNoPointIsFarther) {
  std::vector<ViewMm> square;
  for (int i = 0; i < 400; ++i) {
    const double along = i % 100 / 10.0;
    const std::array<ViewMm, 4> side{
        {{along, 0, 0}, {10, along, 0}, {10 - along, 10, 0}, {0, 10 - along, 0}}};
    square.push_back(side[static_cast<std::size_t>(i / 100)]);
  }
  EXPECT_EQ(lineCorners(std::span<const ViewMm>(square), true, 0.1),
            (std::vector<std::size_t>{0, 100, 200, 300}));
  std::mt19937 random(5);
  std::normal_distribution<double> step;
  std::vector<ViewMm> walk(300);
  for (std::size_t i = 1; i < walk.size(); ++i) {
    walk[i] = walk[i - 1] + ViewMm{step(random), step(random), step(random)};
  }
  const auto corners = lineCorners(std::span<const ViewMm>(walk), false, 2.0);
  ASSERT_EQ(corners.front(), 0U);
  ASSERT_EQ(corners.back(), walk.size() - 1);
  EXPECT_LT(corners.size(), walk.size() / 2);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    for (std::size_t i = corners[k]; i <= corners[k + 1]; ++i) {
      EXPECT_LE(distanceFromStretch(walk[i], walk[corners[k]], walk[corners[k + 1]]), 2.0);
    }
  }
}

}  // namespace
}  // namespace relievo
