// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/error.h"
#include "core/measure/measure.h"
#include "tests/core/measure/made_map.h"

namespace relievo {
namespace {

using test::mapOf;

double cone(double x, double y) {
  return std::max(0.0, 30 - std::hypot(x - 50, y - 50));
}

double hemisphere(double x, double y) {
  const double d = std::hypot(x - 50, y - 50);
  return d < 25 ? std::sqrt(25 * 25 - d * d) : 0;
}

TEST(Section, AContourOfAConeIsACircle) {
  const auto curves = section(mapOf(cone), {.normal = {0, 0, 1}, .offset_mm = 10});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  for (const ViewMm& p : curves[0].points) {
    EXPECT_NEAR(std::hypot(p.x - 50, p.y - 50), 20, 0.005);
    EXPECT_NEAR(p.z, 10, 1e-5);
  }
  EXPECT_NEAR(curves[0].length_mm, 2 * std::numbers::pi * 20, 0.02);
}

TEST(Section, TheNormalsLengthDoesNotMatter) {
  const DepthMap map = mapOf(cone);
  const auto one = section(map, {.normal = {0, 0, 1}, .offset_mm = 10});
  const auto seven = section(map, {.normal = {0, 0, 7}, .offset_mm = 10});
  ASSERT_EQ(seven.size(), 1U);
  EXPECT_EQ(one[0].points, seven[0].points);
}

TEST(Section, AnUprightPlaneThroughAHemisphereIsHalfACircle) {
  const auto curves = section(mapOf(hemisphere), {.normal = {1, 0, 0}, .offset_mm = 50.1});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  for (const ViewMm& p : curves[0].points) {
    EXPECT_NEAR(p.x, 50.1, 1e-9);
    if (std::abs(p.y - 50) < 24) {
      EXPECT_NEAR(p.z, hemisphere(p.x, p.y), 0.05);
    }
  }
  // Half a circle, and the flat parts beside it up to the outermost samples.
  EXPECT_NEAR(curves[0].length_mm, std::numbers::pi * 25 + (99.5 - 50), 0.5);
}

TEST(Section, AnObliquePlaneCutsARampInAStraightLine) {
  const DepthMap map = mapOf([](double x, double) { return 0.5 * x; });
  const auto curves = section(map, {.normal = {0, 1, 1}, .offset_mm = 40 / std::sqrt(2.0)});
  ASSERT_EQ(curves.size(), 1U);
  for (const ViewMm& p : curves[0].points) EXPECT_NEAR(p.y + p.z, 40, 1e-4);
  const ViewMm a = curves[0].points.front();
  const ViewMm b = curves[0].points.back();
  EXPECT_NEAR(curves[0].length_mm, norm(b - a), 1e-4);
}

TEST(Section, TwoHillsGiveTwoCurvesAndASaddleIsCutOnce) {
  const DepthMap hills = mapOf([](double x, double y) {
    const auto hill = [&](double at) {
      return std::exp(-((x - at) * (x - at) + (y - 50) * (y - 50)) / 100);
    };
    return 10 * hill(25) + 5 * hill(75);
  });
  const auto curves = section(hills, {.normal = {0, 0, 1}, .offset_mm = 3});
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_GT(curves[0].length_mm, curves[1].length_mm);
  for (const SectionCurve& curve : curves) EXPECT_TRUE(curve.closed);
  // Every point of a checkerboard's contour belongs to one curve only.
  const DepthMap board = mapOf([](double x, double y) {
    return std::sin(x * std::numbers::pi) * std::sin(y * std::numbers::pi);
  });
  std::size_t points = 0;
  for (const SectionCurve& curve : section(board, {.normal = {0, 0, 1}, .offset_mm = 0.1})) {
    points += curve.points.size();
  }
  std::size_t cut = 0;
  const auto above = [&](int col, int row) {
    return board.heightMm({.col = col, .row = row}) >= 0.1F;
  };
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 200; ++col) {
      if (col < 199 && above(col, row) != above(col + 1, row)) ++cut;
      if (row < 199 && above(col, row) != above(col, row + 1)) ++cut;
    }
  }
  EXPECT_EQ(points, cut) << "one point on each line between samples that is cut";
}

TEST(Section, CellsOutsideAreLeftOutAndGapsAreTold) {
  DepthMap map = mapOf(cone);
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 200; ++col) {
      const std::size_t i = map.frame.size.index({.col = col, .row = row});
      if (col < 100) map.origins[i] = CellStatus::outside;
      if (row < 100 && col >= 100) map.origins[i] = CellStatus::interpolated;
    }
  }
  const auto curves = section(map, {.normal = {0, 0, 1}, .offset_mm = 10});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_NEAR(curves[0].length_mm, std::numbers::pi * 20, 0.6);
  EXPECT_NEAR(curves[0].not_measured, 0.5, 0.02);
}

TEST(Section, APlaneThroughPlacesHoldsThem) {
  const ViewMm a{10, 20, 3}, b{40, 60, 7}, c{80, 30, 1};
  const auto off = [](const PlaneMm& plane, const ViewMm& p) {
    return dot(plane.normal, p) - plane.offset_mm;
  };
  const PlaneMm level = planeThrough({a});
  EXPECT_EQ(level.normal, (ViewMm{0, 0, 1}));
  EXPECT_EQ(level.offset_mm, 3);
  const PlaneMm upright = planeThrough({a, b});
  EXPECT_EQ(upright.normal.z, 0);
  const PlaneMm through = planeThrough({a, b, c});
  for (const PlaneMm& plane : {upright, through}) {
    EXPECT_NEAR(norm(plane.normal), 1, 1e-12);
    for (const ViewMm& p : {a, b}) EXPECT_NEAR(off(plane, p), 0, 1e-9);
  }
  EXPECT_NEAR(off(through, c), 0, 1e-9);
  EXPECT_THROW(planeThrough({a, a}), ArgumentError);
  EXPECT_THROW(planeThrough({a, {10, 20, 9}}), ArgumentError) << "one above the other";
  EXPECT_THROW(planeThrough({a, b, 0.5 * (a + b)}), ArgumentError) << "on one line";
}

TEST(Section, AsAMeasurementItReadsWhatTheCutHas) {
  const Measurement m{.kind = MeasureKind::section, .plane_mm = 10};
  const Reading r = read(mapOf(cone), m);
  const auto curves = section(mapOf(cone), planeOf(m));
  ASSERT_EQ(r.curves.size(), 1U);
  EXPECT_EQ(r.curves[0].points, curves[0].points);
  EXPECT_EQ(r.quantities[0].value, curves[0].length_mm);
  EXPECT_EQ(r.quantities[0].uncertainty, curves[0].length_off_mm);
  EXPECT_THROW(read(mapOf(cone), {.kind = MeasureKind::section, .plane_mm = 99}), ArgumentError);
}

TEST(Section, APlaneWithoutDirectionIsRefusedAndOneThatMissesIsEmpty) {
  const DepthMap map = mapOf(cone);
  EXPECT_THROW(section(map, {.normal = {0, 0, 0}, .offset_mm = 1}), ArgumentError);
  EXPECT_THROW(section(map, {.normal = {0, 0, 1}, .offset_mm = std::nan("")}), ArgumentError);
  EXPECT_TRUE(section(map, {.normal = {0, 0, 1}, .offset_mm = 99}).empty());
}

}  // namespace
}  // namespace relievo
