// SPDX-License-Identifier: BSD-3-Clause
// Paths: corners, lengths and speeds of lines that are known, and of the ways of hands.
#include "haptics/guide/guide_path.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "tests/haptics/guide/led_hand.h"

namespace relievo {
namespace {

std::uint32_t pausesOf(const GuidePath& path) {
  std::uint32_t pauses = 0;
  for (std::uint32_t i = 0; i < path.count; ++i) pauses += path.points[i].pause_s > 0 ? 1 : 0;
  return pauses;
}

TEST(GuidePath, ASquareHasFourCornersAndACircleNone) {
  const GuidePath square = guidePath(test::square(50), true);
  EXPECT_EQ(square.count, 4U);
  EXPECT_EQ(pausesOf(square), 4U);
  EXPECT_DOUBLE_EQ(square.lengthMm(), 200);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(square.to_stop_mm[i], 50);
    EXPECT_DOUBLE_EQ(square.points[i].speed_mm_per_s, 200 / kLeastRoundS);
  }
  const GuidePath circle = guidePath(test::circle(16), true);
  EXPECT_EQ(pausesOf(circle), 0U);
  EXPECT_GT(circle.to_stop_mm[0], 1000) << "it never stops";
  EXPECT_EQ(pausesOf(guidePath(test::star(), true)), 10U);
}

TEST(GuidePath, ACornerThatIsRoundedOffIsOne) {
  std::vector<DeviceMm> line;  // A quarter of a circle, 1 mm, between two sides of 20 mm.
  line.push_back({0, 20, 0});
  for (int i = 0; i <= 10; ++i) {
    const double a = std::numbers::pi * (1 + i / 20.0);
    line.push_back({1 + std::cos(a), 1 + std::sin(a), 0});
  }
  line.push_back({20, 0, 0});
  EXPECT_EQ(pausesOf(guidePath(line, false)), 1U);
}

TEST(GuidePath, ALongPathIsLedAtFortyAndAShortOneTakesSixSeconds) {
  EXPECT_DOUBLE_EQ(guidePath(test::square(75), true).points[0].speed_mm_per_s, kGuideMmPerS);
  EXPECT_DOUBLE_EQ(guidePath(test::square(6), true).points[0].speed_mm_per_s, 4);
}

TEST(GuidePath, IsThinnedOutUntilItFits) {
  const GuidePath path = guidePath(test::circle(30, 20000), true);
  EXPECT_LE(path.count, GuidePath::kMostPoints);
  EXPECT_GT(path.count, 50U);
  EXPECT_NEAR(path.lengthMm(), 2 * std::numbers::pi * 30, 0.5);
}

TEST(GuidePath, RefusesWhatIsNoWay) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<DeviceMm> one{{1, 2, 3}, {1, 2, 3}}, two{{0, 0, 0}, {5, 0, 0}};
  const std::vector<DeviceMm> no_number{{0, 0, 0}, {nan, 0, 0}, {5, 5, 0}};
  EXPECT_THROW(guidePath({}, false), ArgumentError);
  EXPECT_THROW(guidePath(one, false), ArgumentError);
  EXPECT_THROW(guidePath(two, true), ArgumentError);
  EXPECT_NO_THROW(guidePath(two, false));
  EXPECT_THROW(guidePath(no_number, false), ArgumentError);
  EXPECT_THROW(guideAlong(std::vector<TimedPlace>{{0, {}}, {0, {5, 0, 0}}}), ArgumentError);
  EXPECT_THROW(guideAlong(std::vector<TimedPlace>{{0, {}}}), ArgumentError);
  EXPECT_THROW(guideAlong(std::vector<TimedPlace>{{0, {}}, {nan, {5, 0, 0}}}), ArgumentError);
}

TEST(GuidePath, AStrokeKeepsItsSpeedsAndItsRests) {
  std::vector<TimedPlace> way;  // 40 mm at 20 mm/s, a rest of 1 s, 40 mm at 400, 4 mm at 4 mm/s.
  for (int i = 0; i <= 2000; ++i) way.push_back({0.001 * i, {0.02 * i, 0, 0}});
  for (int i = 1; i <= 1000; ++i) way.push_back({2 + 0.001 * i, {40, 0, 0}});
  for (int i = 1; i <= 100; ++i) way.push_back({3 + 0.001 * i, {40, 0.4 * i, 0}});
  const GuidePath path = guideAlong(way);
  ASSERT_EQ(path.count, 3U);
  EXPECT_FALSE(path.closed);
  EXPECT_NEAR(path.points[0].speed_mm_per_s, 20, 0.1);
  EXPECT_EQ(path.points[0].pause_s, 0);
  EXPECT_NEAR(path.points[1].pause_s, 1, 0.01);
  EXPECT_DOUBLE_EQ(path.points[1].speed_mm_per_s, kFastestStrokeMmPerS);
  EXPECT_NEAR(path.lengthMm(), 80, 0.1);
  EXPECT_NEAR(path.to_stop_mm[0], 40, 0.1);
}

TEST(GuidePath, SlowIsNoRest) {
  // 4 mm/s, sampled often and seldom; led at the slowest speed, without a pause.
  std::vector<TimedPlace> often;
  for (int i = 0; i <= 4000; ++i) often.push_back({0.001 * i, {0.004 * i, 0, 0}});
  const std::vector<TimedPlace> seldom{{0, {}}, {4, {16, 0, 0}}, {5, {16, 0, 0}}, {8, {16, 20, 0}}};
  EXPECT_EQ(pausesOf(guideAlong(often)), 0U);
  EXPECT_EQ(guideAlong(often).count, 2U);
  const GuidePath path = guideAlong(seldom);
  EXPECT_EQ(pausesOf(path), 1U);
  EXPECT_DOUBLE_EQ(path.points[1].pause_s, 1);
}

TEST(GuidePath, AStrokeIsPlayedBackAtItsOwnSpeed) {
  std::vector<TimedPlace> way;
  for (int i = 0; i <= 2000; ++i) {
    const double a = std::numbers::pi * i / 2000;
    way.push_back({0.001 * i, {20 * std::cos(a), 20 * std::sin(a), 0}});  // 31 mm/s.
  }
  test::LedHand hand({.hand = kHandPresets[1]}, guideAlong(way), 0.2);
  const test::Led led = hand.run({20, -6, 0}, 60);
  EXPECT_EQ(led.end, GuideEnd::arrived);
  EXPECT_LE(led.rms_mm, 2);
  EXPECT_EQ(led.audit.violations(), 0U);
  EXPECT_LT(norm(hand.hand().position() - DeviceMm{-20, 0, 0}), 2.5) << "it ends where it ended";
}

TEST(GuidePath, OneThatWasReadIsCheckedAndCompleted) {
  const GuidePath made = guidePath(test::star(), true);
  GuidePath read = made;
  read.at_mm = {};
  read.to_stop_mm = {};
  ASSERT_TRUE(completePath(read));
  EXPECT_EQ(read.at_mm, made.at_mm);
  EXPECT_EQ(read.to_stop_mm, made.to_stop_mm);
  const auto refused = [&](const auto& change) {
    GuidePath path = made;
    change(path);
    return !completePath(path);
  };
  EXPECT_TRUE(refused([](GuidePath& p) { p.count = 2; }));
  EXPECT_TRUE(refused([](GuidePath& p) { p.count = GuidePath::kMostPoints + 1; }));
  EXPECT_TRUE(refused([](GuidePath& p) { p.rounds = 0; }));
  EXPECT_TRUE(refused([](GuidePath& p) { p.points[3].place.x = 1e7; }));
  EXPECT_TRUE(refused([](GuidePath& p) { p.points[3].speed_mm_per_s = 0; }));
  EXPECT_TRUE(refused([](GuidePath& p) { p.points[3].pause_s = -1; }));
  EXPECT_TRUE(refused([](GuidePath& p) {
    for (std::uint32_t i = 0; i < p.count; ++i) p.points[i].place = {};
  }));
}

}  // namespace
}  // namespace relievo
