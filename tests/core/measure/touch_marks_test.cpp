// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/touch_marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/measure/made_map.h"

namespace relievo {
namespace {

constexpr double kCell = 0.5;

/// A contact along places, and the hand in the air after it.
std::optional<TouchMark> markOf(const std::vector<TouchSample>& contact) {
  TouchMarks marks;
  for (const TouchSample& s : contact) EXPECT_FALSE(marks.follow(s, kCell));
  return marks.follow({.proxy = {99, 99}}, kCell);
}

TEST(TouchMarks, ATapIsThePlaceOfTheHardestPress) {
  const auto tap = markOf({{{10, 20}, 0.1, true}, {{10.4, 20}, 0.9, true}, {{11, 21}, 0.2, true}});
  ASSERT_TRUE(tap);
  EXPECT_FALSE(tap->stroke);
  EXPECT_EQ(tap->places, (std::vector<PlaceMm>{{10.4, 20}}));
}

TEST(TouchMarks, InTheAirNothingIsMarkedAndEachContactOnce) {
  TouchMarks marks;
  EXPECT_FALSE(marks.follow({.proxy = {1, 1}}, kCell));
  EXPECT_FALSE(marks.follow({{1, 1}, 0.3, true}, kCell));
  EXPECT_TRUE(marks.follow({.proxy = {1, 1}}, kCell));
  EXPECT_FALSE(marks.follow({.proxy = {1, 1}}, kCell));
  EXPECT_FALSE(marks.follow({{1, 1}, 0.3, true}, kCell));
  marks.forget();
  EXPECT_FALSE(marks.follow({.proxy = {1, 1}}, kCell)) << "what was forgotten ends unmarked";
}

TEST(TouchMarks, AStrokeKeepsItsCornerAndNoMorePlacesThanItNeeds) {
  std::vector<TouchSample> way;
  for (int i = 0; i <= 100; ++i) way.push_back({{0.2 * i, 10 + 0.1 * std::sin(i)}, 0.4, true});
  for (int i = 1; i <= 100; ++i) way.push_back({{20, 10 + 0.2 * i}, 0.4, true});
  const auto stroke = markOf(way);
  ASSERT_TRUE(stroke);
  EXPECT_TRUE(stroke->stroke);
  ASSERT_EQ(stroke->places.size(), 3U);
  EXPECT_NEAR(stroke->places[1].x, 20, 0.5 * kCell);
  EXPECT_NEAR(stroke->places[1].y, 10, 0.5 * kCell);
}

TEST(TouchMarks, AThinnedCircleStaysWithinHalfACellOfItself) {
  std::vector<TouchSample> way;
  for (int i = 0; i <= 720; ++i) {
    const double a = i * std::numbers::pi / 360;
    way.push_back({{50 + 20 * std::cos(a), 50 + 20 * std::sin(a)}, 0.4, true});
  }
  const auto stroke = markOf(way);
  ASSERT_TRUE(stroke && stroke->stroke);
  EXPECT_LT(stroke->places.size(), 80U);
  double length = 0;
  for (std::size_t i = 1; i < stroke->places.size(); ++i) {
    const PlaceMm a = stroke->places[i - 1];
    const PlaceMm b = stroke->places[i];
    length += std::hypot(b.x - a.x, b.y - a.y);
    EXPECT_NEAR(std::hypot((a.x + b.x) / 2 - 50, (a.y + b.y) / 2 - 50), 20, 0.5 * kCell);
  }
  EXPECT_NEAR(length, 2 * std::numbers::pi * 20, 1);
}

TEST(TouchMarks, TwoTapsReadTheStepBetweenThemWithinACell) {
  const DepthMap map = test::mapOf([](double x, double) { return x > 50 ? 5.0 : 0.0; });
  const auto low = markOf({{{48, 30}, 0.5, true}});
  const auto high = markOf({{{52, 30}, 0.5, true}});
  const Reading reading = read(
      map, {.kind = MeasureKind::depth, .places = {low->places.front(), high->places.front()}});
  EXPECT_NEAR(reading.quantities.front().value, 5, kCell);
}

}  // namespace
}  // namespace relievo
