// SPDX-License-Identifier: BSD-3-Clause
// The true value lies within what is said, and what is said is never nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "core/base/error.h"
#include "core/measure/measure.h"
#include "tests/core/measure/made_map.h"

namespace relievo {
namespace {

using test::mapOf;
constexpr double kCell = 0.5;

std::vector<PlaceMm> square(double from, double to) {
  return {{from, from}, {to, from}, {to, to}, {from, to}};
}

std::vector<Quantity> area(const MapCells& map, std::vector<PlaceMm> places, double plane_mm = 0) {
  return read(map, {.kind = MeasureKind::area, .places = std::move(places), .plane_mm = plane_mm})
      .quantities;
}

void expectWithin(const Quantity& q, double truth) {
  EXPECT_GT(q.uncertainty, 0) << q.title;
  EXPECT_LE(std::abs(q.value - truth), q.uncertainty) << q.title << " reads " << q.value;
}

double block(double x, double y) {
  return std::abs(x - 50) < 25 && std::abs(y - 50) < 25 ? 5 : 0;
}

/// A map whose heights are means of points with noise, as a cloud gives it.
struct NoisyMap {
  NoisyMap(const std::function<double(double, double)>& z, double noise_mm, unsigned points)
      : map(mapOf(z)) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, noise_mm);
    for (float& height : map.heights_mm) {
      double sum = 0;
      double squares = 0;
      for (unsigned i = 0; i < points; ++i) {
        const double off = noise(random);
        sum += off;
        squares += off * off;
      }
      const double mean = sum / points;
      height += static_cast<float>(mean);
      quality.counts.push_back(points);
      quality.spreads_mm.push_back(
          static_cast<float>(std::sqrt(std::max(0.0, squares / points - mean * mean))));
    }
  }
  MapCells cells() const { return {map, {.step_mm = 0, .quality = &quality}}; }

  DepthMap map;
  QualityMap quality;
};

TEST(Uncertainty, OfAnAreaIsHalfACellAlongItsOutlineAlsoOnTheCellsBorders) {
  const double corners = std::numbers::pi / 4 * kCell * kCell;
  for (const double off : {0.0, 0.1, 0.25}) {  // 0: the outline runs between cells.
    const auto q = area(mapOf(block), square(25 + off, 75 - off));
    const double side = 50 - 2 * off;
    EXPECT_NEAR(q[0].uncertainty, 4 * side * kCell / 2 + corners, 1e-6) << off;
    expectWithin(q[0], side * side);
    expectWithin(q[1], side * side * 5);
    EXPECT_NEAR(q[1].uncertainty, 5 * q[0].uncertainty, 0.1) << "a band of the block's height";
  }
}

TEST(Uncertainty, OfAnOutlineIsThatOfATruePieceHalfACellLargerAllRound) {
  const auto read_at = area(mapOf(block), square(30, 70));
  for (const double off : {-kCell / 2, kCell / 2}) {
    const double side = 40 + 2 * off;
    EXPECT_LE(std::abs(read_at[0].value - side * side), read_at[0].uncertainty + 0.06)
        << "corners of a square reach a little farther than half a cell";
  }
}

TEST(Uncertainty, OfAnAreaThatEndsWithTheObjectIsHalfACellAlongItsEdge) {
  DepthMap map = mapOf(block);
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 100; ++col) {
      map.origins[map.frame.size.index({.col = col, .row = row})] = CellStatus::outside;
    }
  }
  const auto q = area(map, square(-20, 120));
  EXPECT_NEAR(q[0].value, 5000, 1e-6);
  EXPECT_NEAR(q[0].uncertainty, (100 + 100 + 50 + 50) * kCell / 2, 1) << "the outline is far away";
}

TEST(Uncertainty, OfHeightsStoredInStepsIsHalfAStep) {
  // 5.3 mm, stored as 5.
  const DepthMap map = mapOf([](double x, double y) { return std::round(block(x, y) * 5.3 / 5); });
  const MapCells cells(map, {.step_mm = 1});
  const Reading point = read(cells, {.kind = MeasureKind::point, .places = {{50, 50}}});
  expectWithin(point.quantities[0], 5.3);
  EXPECT_NEAR(point.quantities[0].uncertainty, 0.5, 1e-9);
  const auto q = area(cells, square(30, 70));
  expectWithin(q[1], 1600 * 5.3);
  const Reading flat = read(map, {.kind = MeasureKind::point, .places = {{50, 50}}});
  EXPECT_GT(flat.quantities[0].uncertainty, 0) << "even exact steps are in single precision";
  EXPECT_LT(flat.quantities[0].uncertainty, 1e-4);
}

/// What stands before the gap is 10 mm higher than what stands behind it; in between a ramp was
/// made.
DepthMap filledStep(int first_col, int cols) {
  DepthMap map = mapOf([](double, double) { return 0; });
  for (int row = 0; row < map.frame.size.rows; ++row) {
    for (int col = 0; col < map.frame.size.cols; ++col) {
      const std::size_t i = map.frame.size.index({.col = col, .row = row});
      const double along = (col - first_col + 1.0) / (cols + 1);
      map.heights_mm[i] = static_cast<float>(10 * std::clamp(1 - along, 0.0, 1.0));
      if (col >= first_col && col < first_col + cols) map.origins[i] = CellStatus::interpolated;
    }
  }
  return map;
}

TEST(Uncertainty, OfAnInterpolatedHeightReachesToTheRimOfItsGap) {
  for (const int cols : {1, 5, 20, 100}) {
    const DepthMap map = filledStep(40, cols);
    for (const int col : {40, 40 + cols / 2, 40 + cols - 1}) {
      const PlaceMm place{.x = map.frame.xMm(col), .y = 50};
      const Reading reading = read(map, {.kind = MeasureKind::point, .places = {place}});
      // The truth may be a step anywhere between.
      expectWithin(reading.quantities[0], 10);
      expectWithin(reading.quantities[0], 0);
      EXPECT_LT(reading.quantities[0].uncertainty, 16) << "and says no more than it needs";
    }
    const Measurement beside{.kind = MeasureKind::point, .places = {{.x = 5, .y = 50}}};
    EXPECT_LT(read(map, beside).quantities[0].uncertainty, 1e-4) << "a measured cell is not meant";
  }
}

TEST(Uncertainty, OfAGapThatEndsWithTheObjectIsThatOfTheRimThereIs) {
  DepthMap map = filledStep(40, 20);
  for (int row = 0; row < map.frame.size.rows; ++row) {
    for (int col = 60; col < map.frame.size.cols; ++col) {
      map.origins[map.frame.size.index({.col = col, .row = row})] = CellStatus::outside;
    }
  }
  const PlaceMm place{.x = map.frame.xMm(50), .y = 50};
  const Reading reading = read(map, {.kind = MeasureKind::point, .places = {place}});
  expectWithin(reading.quantities[0], 10);
}

TEST(Uncertainty, OfTheMeanOfManyPointsIsTwiceItsStandardError) {
  const DepthMap map = mapOf(block);
  const QualityMap quality{.counts = std::vector<std::uint32_t>(map.frame.size.count(), 16),
                           .spreads_mm = std::vector<float>(map.frame.size.count(), 0.25F)};
  const Measurement middle{.kind = MeasureKind::point, .places = {{50, 50}}};
  const auto off = [&](const HeightErrors& errors) {
    return read(MapCells(map, errors), middle).quantities[0].uncertainty;
  };
  EXPECT_NEAR(off({.quality = &quality}), 2 * 0.25 / 4, 1e-4);
  EXPECT_NEAR(off({.quality = &quality, .of_one_point = true}), 2 * 0.25, 1e-4);
  EXPECT_NEAR(off({.step_mm = 0.2, .quality = &quality}), 0.1 + 2 * 0.25 / 4, 1e-4);
}

TEST(Uncertainty, HoldsTheTruthOfANoisyBlockAndRamp) {
  const NoisyMap noisy(block, 0.05, 6);
  const auto q = area(noisy.cells(), square(30, 70));
  expectWithin(q[0], 1600);
  expectWithin(q[1], 8000);
  expectWithin(q[2], 1600);
  const NoisyMap ramp([](double x, double) { return 0.5 * x; }, 0.05, 6);
  int within = 0;
  for (int i = 0; i < 400; ++i) {
    const double x = 10 + 0.2 * i;
    const Reading r =
        read(ramp.cells(), {.kind = MeasureKind::depth, .places = {{x, 20}, {x, 80}}});
    if (std::abs(r.quantities[0].value) <= r.quantities[0].uncertainty) ++within;
  }
  EXPECT_GE(within, 396) << "of 400";
  const Reading profile =
      read(ramp.cells(), {.kind = MeasureKind::profile, .places = {{10, 50.25}, {90, 50.25}}});
  expectWithin(profile.quantities[0], 80);
  expectWithin(profile.quantities[1], 40);
  expectWithin(profile.quantities[2], std::hypot(80, 40));
}

TEST(Uncertainty, OfASectionHoldsTheTruthOfACone) {
  const auto cone = [](double x, double y) { return 30 - std::hypot(x - 50, y - 50); };
  const NoisyMap noisy(cone, 0.02, 4);
  const Measurement contour{.kind = MeasureKind::section, .plane_mm = 10};
  expectWithin(read(noisy.cells(), contour).quantities[0], 2 * std::numbers::pi * 20);
  const Reading exact = read(mapOf(cone), contour);
  expectWithin(exact.quantities[0], 2 * std::numbers::pi * 20);
  EXPECT_NEAR(exact.quantities[0].uncertainty, std::numbers::pi * kCell, 0.01);
  const Measurement upright{.kind = MeasureKind::section, .plane_mm = 50, .normal = {0, 1, 0}};
  expectWithin(read(noisy.cells(), upright).quantities[0], 99.5 * std::numbers::sqrt2);
}

// A wall inside a cell is drawn as a slope, which is shorter.
TEST(Uncertainty, HoldsTheTruthAcrossWalls) {
  const DepthMap map = mapOf(block);
  for (const double phase : {0.0, 0.1, 0.25}) {
    const Reading path =
        read(map, {.kind = MeasureKind::profile, .places = {{10 + phase, 50}, {90 + phase, 50}}});
    expectWithin(path.quantities[2], 80 + 2 * 5);
    EXPECT_LT(path.quantities[2].uncertainty, 2.5) << phase;
  }
  expectWithin(
      read(map, {.kind = MeasureKind::section, .plane_mm = 50, .normal = {1, 0, 0}}).quantities[0],
      100 + 2 * 5);
  const auto q = area(map, square(10, 90));
  expectWithin(q[1], 2500 * 5);
  expectWithin(q[2], 6400 + 4 * 50 * 5);
  EXPECT_LT(q[2].uncertainty, 350);
}

TEST(Uncertainty, AnOutlineThatIsNoPieceIsRefused) {
  const DepthMap map = mapOf(block);
  EXPECT_THROW(area(map, {{10, 10}, {50, 50}, {90, 90}}), ArgumentError) << "on one line";
  EXPECT_THROW(area(map, {{10, 10}, {50, 50}, {50, 10}, {10, 50}}), ArgumentError) << "a bow tie";
  // Without a like area on either side, and crossed by the side back to the first corner.
  for (const auto& tie :
       std::vector<std::vector<PlaceMm>>{{{10, 10}, {50, 50}, {50, 10}, {10, 50}},
                                         {{10, 10}, {50, 50}, {50, 10}, {10, 80}},
                                         {{10, 10}, {10, 80}, {50, 10}, {50, 50}}}) {
    EXPECT_TRUE(outlineProblem(tie).starts_with("The outline crosses itself")) << tie[3].y;
  }
  EXPECT_TRUE(lastSideCrosses({{10, 10}, {50, 50}, {50, 10}, {10, 50}}));
  EXPECT_FALSE(lastSideCrosses({{10, 10}, {50, 10}, {50, 50}, {10, 50}}));
  // A notch, an edge walked twice and a corner that touches a side are pieces.
  EXPECT_EQ(outlineProblem({{10, 10}, {50, 10}, {50, 50}, {30, 20}, {10, 50}}), "");
  EXPECT_EQ(outlineProblem({{10, 10}, {50, 10}, {50, 50}, {30, 10}, {10, 50}}), "");
}

}  // namespace
}  // namespace relievo
