// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/error.h"
#include "tests/core/measure/made_map.h"

namespace relievo {
namespace {

using test::mapOf;

double first(const DepthMap& map, MeasureKind kind, std::vector<PlaceMm> places) {
  return read(map, {.name = {}, .kind = kind, .places = std::move(places)})
      .quantities.front()
      .value;
}

double ramp(double x, double /*y*/) {
  return 0.5 * x;
}
double step(double x, double /*y*/) {
  return x > 50 ? 5 : 0;
}
double cone(double x, double y) {
  return std::max(0.0, 30 - std::hypot(x - 50, y - 50));
}

std::vector<PlaceMm> circle(double radius) {
  std::vector<PlaceMm> outline;
  for (int i = 0; i < 360; ++i) {
    const double a = i * std::numbers::pi / 180;
    outline.push_back({.x = 50 + radius * std::cos(a), .y = 50 + radius * std::sin(a)});
  }
  return outline;
}

TEST(Measure, APointOfARampReadsItsHeightAlsoBetweenSamples) {
  EXPECT_NEAR(first(mapOf(ramp), MeasureKind::point, {{30.1, 40.7}}), 15.05, 1e-5);
}

TEST(Measure, ADistanceIsThatOfTheSlopeAndADepthThatOfTheStep) {
  EXPECT_NEAR(first(mapOf(ramp), MeasureKind::distance, {{10, 20}, {50, 20}}), std::hypot(40, 20),
              1e-5);
  EXPECT_NEAR(first(mapOf(step), MeasureKind::depth, {{20, 30}, {80, 30}}), 5, 1e-6);
  EXPECT_NEAR(first(mapOf(step), MeasureKind::depth, {{80, 30}, {20, 30}}), -5, 1e-6);
}

TEST(Measure, AnAngleOverTheTopOfAConeIsItsOpeningAngle) {
  // The sides stand at 45 degrees: the tip is a right angle, cut off by half a sample.
  EXPECT_NEAR(first(mapOf(cone), MeasureKind::angle, {{30, 50}, {50, 50}, {70, 50}}), 90, 1.5);
  EXPECT_NEAR(first(mapOf(ramp), MeasureKind::angle, {{30, 50}, {50, 50}, {50, 70}}), 90, 1e-4);
}

TEST(Measure, AnAreaAndTheVolumeAboveItAreThoseOfTheCone) {
  const DepthMap map = mapOf(cone);
  const Reading r =
      read(map, {.name = {}, .kind = MeasureKind::area, .places = circle(30), .plane_mm = 0});
  ASSERT_EQ(r.quantities.size(), 3U);
  const double area = std::numbers::pi * 30 * 30;
  EXPECT_NEAR(r.quantities[0].value, area, 0.002 * area);
  EXPECT_NEAR(r.quantities[1].value, area * 30 / 3, 0.002 * area * 10);
  EXPECT_NEAR(r.quantities[2].value, area * std::sqrt(2), 0.01 * area * std::sqrt(2));
  for (const Quantity& q : r.quantities) EXPECT_GT(q.uncertainty, 0) << q.title;
  // Above half its height a cone holds an eighth.
  const Reading top =
      read(map, {.name = {}, .kind = MeasureKind::area, .places = circle(30), .plane_mm = 15});
  EXPECT_NEAR(top.quantities[1].value, area * 10 / 8, 0.004 * area * 10 / 8);
}

TEST(Measure, TheVolumeUnderAHemisphereIsTwoThirdsOfItsCylinder) {
  const DepthMap map = mapOf([](double x, double y) {
    const double d = std::hypot(x - 50, y - 50);
    return d < 25 ? std::sqrt(25 * 25 - d * d) : 0;
  });
  const Reading r = read(map, {.name = {}, .kind = MeasureKind::area, .places = circle(40)});
  const double volume = 2.0 / 3 * std::numbers::pi * 25 * 25 * 25;
  EXPECT_NEAR(r.quantities[1].value, volume, 0.002 * volume);
}

TEST(Measure, AProfileFollowsTheStepAndItsBends) {
  const std::vector<ProfileRow> rows = profile(mapOf(step), {{40, 50}, {60, 50}, {60, 60}});
  EXPECT_EQ(rows.size(), 61U);
  EXPECT_EQ(rows.front().along_mm, 0);
  EXPECT_NEAR(rows.back().along_mm, 30, 1e-9);
  EXPECT_NEAR(rows.front().point.at.z, 0, 1e-6);
  EXPECT_NEAR(rows.back().point.at.z, 5, 1e-6);
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_GT(rows[i].along_mm, rows[i - 1].along_mm);
  const Reading r =
      read(mapOf(step),
           {.name = {}, .kind = MeasureKind::profile, .places = {{40, 50}, {60, 50}, {60, 60}}});
  EXPECT_NEAR(r.quantities[0].value, 30, 1e-9);
  EXPECT_NEAR(r.quantities[1].value, 5, 1e-6);
}

/// mapOf() covers 100 x 100 mm; what is beside it is asked for, and is not measured.
TEST(Measure, AProfileBeyondTheMapSaysBothLengths) {
  const DepthMap map = mapOf(ramp);
  for (const double far : {50.0, 1e5, 1e9}) {
    const Reading r =
        read(map, {.kind = MeasureKind::profile, .places = {{-far, -far}, {100 + far, 100 + far}}});
    const double asked = std::sqrt(2.0) * (100 + 2 * far);
    EXPECT_EQ(r.quantities[0].title, "length");
    EXPECT_NEAR(r.quantities[0].value, asked, 1e-9 * asked);
    EXPECT_EQ(r.quantities[3].title, "length on the map");
    EXPECT_NEAR(r.quantities[3].value, std::sqrt(2.0) * 100, 2 * map.frame.spacing_mm);
    EXPECT_NEAR(r.not_measured, 1 - std::sqrt(2.0) * 100 / asked, 0.02);
  }
  EXPECT_THROW(read(map, {.kind = MeasureKind::profile, .places = {{-9, -9}, {-9, 200}}}),
               ArgumentError);
}

/// Out over the border and back again: what lies between is not on the map.
TEST(Measure, AProfileThatLeavesTheMapIsNotJoinedAcrossTheGap) {
  const DepthMap map = mapOf(ramp);
  const std::vector<PlaceMm> places{{90, 20}, {150, 20}, {150, 40}, {90, 40}};
  const Reading r = read(map, {.kind = MeasureKind::profile, .places = places});
  EXPECT_NEAR(r.quantities[0].value, 140, 1e-9);
  EXPECT_NEAR(r.quantities[3].value, 20, 2 * map.frame.spacing_mm);
  int gaps = 0;
  const std::vector<ProfileRow> rows = profile(map, places);
  for (std::size_t i = 1; i < rows.size(); ++i) gaps += rows[i].joined ? 0 : 1;
  EXPECT_EQ(gaps, 1);
  EXPECT_FALSE(rows.front().joined);
}

TEST(Measure, TheTruthLiesWithinTheStatedUncertainty) {
  // Places half a sample off and a slope: the depth difference of a ramp read at wrong places.
  const DepthMap map = mapOf(ramp);
  for (const double off : {-0.25, -0.1, 0.1, 0.25}) {
    const Reading r = read(
        map, {.name = {}, .kind = MeasureKind::depth, .places = {{20 + off, 50}, {60 - off, 50}}});
    const Quantity& q = r.quantities.front();
    EXPECT_LE(std::abs(q.value - 20), q.uncertainty) << off;
    EXPECT_LE(q.uncertainty, 2) << "and says something";
  }
}

TEST(Measure, WhatWasNotMeasuredIsSaid) {
  DepthMap map = mapOf(ramp);
  for (int row = 0; row < 200; ++row) {
    for (int col = 100; col < 200; ++col) {
      map.origins[map.frame.size.index({.col = col, .row = row})] = CellStatus::interpolated;
    }
  }
  EXPECT_EQ(read(map, {.kind = MeasureKind::distance, .places = {{20, 20}, {80, 20}}}).not_measured,
            0.5);
  EXPECT_EQ(read(map, {.kind = MeasureKind::point, .places = {{20, 20}}}).not_measured, 0);
  const Reading area =
      read(map, {.kind = MeasureKind::area, .places = {{25, 25}, {75, 25}, {75, 75}, {25, 75}}});
  EXPECT_NEAR(area.not_measured, 0.5, 1e-9);
  EXPECT_NEAR(area.quantities[0].value, 2500, 1e-6);
}

TEST(Measure, PlacesBesideTheObjectAreRefused) {
  DepthMap map = mapOf(ramp);
  map.origins[map.frame.size.index({.col = 10, .row = 10})] = CellStatus::outside;
  EXPECT_FALSE(surfacePoint(map, {.x = 5.25, .y = 5.25}));
  EXPECT_FALSE(surfacePoint(map, {.x = -1, .y = 5}));
  EXPECT_TRUE(surfacePoint(map, {.x = 0, .y = 100}));
  EXPECT_THROW(read(map, {.kind = MeasureKind::point, .places = {{5.25, 5.25}}}), ArgumentError);
  EXPECT_THROW(read(map, {.kind = MeasureKind::angle, .places = {{1, 1}, {2, 2}}}), ArgumentError);
  EXPECT_THROW(read(map, {.kind = MeasureKind::angle, .places = {{1, 1}, {1, 1}, {2, 2}}}),
               ArgumentError);
}

/// Cells outside the object hold 0, which is no height: beside the outline it must not be mixed in.
TEST(Measure, BesideTheOutlineOnlyTheObjectCounts) {
  DepthMap map = mapOf([](double, double) { return 10; });
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (i % 200 < 100) continue;
    map.heights_mm[i] = 0;
    map.origins[i] = CellStatus::outside;
  }
  // Between the last cell on the object, at 49.75 mm, and the first beyond, at 50.25.
  const auto beside = surfacePoint(map, {49.9, 30});
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->at.z, 10, 1e-6);
  EXPECT_LT(beside->height_uncertainty_mm, 0.01) << "half the range of what is on the object";
}

/// The +- is the sum of what each coordinate's half cell does: errors of neighbouring cells go
/// together, so that they may not be added as squares.
TEST(Measure, UncertaintiesAddUp) {
  const DepthMap flat = mapOf([](double, double) { return 1; });
  const auto off = [&](MeasureKind kind, std::vector<PlaceMm> places) {
    const Reading reading = read(flat, {.kind = kind, .places = std::move(places)});
    return reading.quantities.front().uncertainty;
  };
  const double side = std::hypot(40, 0.25) - 40;
  EXPECT_NEAR(off(MeasureKind::distance, {{30, 50}, {70, 50}}), 2 * 0.25 + 2 * side, 2e-3);
  const double turn = std::atan(0.25 / 20) * 180 / std::numbers::pi;
  EXPECT_NEAR(off(MeasureKind::angle, {{30, 50}, {50, 50}, {50, 70}}), 4 * turn, 0.02);
}

/// Of cells that the outline cuts only the part inside counts, measured or not.
TEST(Measure, CutCellsCountByTheirPart) {
  DepthMap map = mapOf([](double, double) { return 1; });
  for (std::size_t i = 0; i < map.origins.size(); ++i) {
    if (i % 200 == 40) map.origins[i] = CellStatus::interpolated;  // From 20 to 20.5 mm.
  }
  const Reading reading = read(
      map, {.kind = MeasureKind::area, .places = {{10, 10}, {20.25, 10}, {20.25, 20}, {10, 20}}});
  EXPECT_NEAR(reading.quantities.front().value, 10.25 * 10, 1e-6);
  EXPECT_NEAR(reading.not_measured, 0.25 / 10.25, 1e-6);
}

}  // namespace
}  // namespace relievo
