// SPDX-License-Identifier: BSD-3-Clause
// What every link shares: which orders are shown, how force comes back, and what the loop is told.
#include "haptics/device/link/force_ramp.h"

#include <gtest/gtest.h>

#include <limits>

namespace relievo {
namespace {

constexpr std::int64_t kMs = 1'000'000, kNow = 5000 * kMs;
constexpr std::uint32_t kCuts = 2, kEpoch = 7;

ForceCommand order(DeviceN force, std::int64_t time_ns = kNow) {
  return {force, time_ns, kEpoch, kCuts};
}
std::optional<DeviceN> shown(const ForceCommand& order, ForceRamp ramp = ForceRamp{}) {
  return ramp.shown(order, kCuts, kEpoch, kNow);
}

TEST(ForceRamp, ShowsAFreshOrderAsItIs) {
  const auto force = shown(order({1, -2, 0.5}));
  ASSERT_TRUE(force);
  EXPECT_EQ(force->x, 1);
  EXPECT_EQ(force->y, -2);
  EXPECT_EQ(force->z, 0.5);
}

TEST(ForceRamp, KeepsItsDirectionAndTheLargestForce) {
  const auto force = shown(order({30, 40, 0}));
  ASSERT_TRUE(force);
  EXPECT_NEAR(norm(*force), 5, 1e-12);
  EXPECT_NEAR(force->x / force->y, 0.75, 1e-12);
}

TEST(ForceRamp, ShowsNothingOfAnOrderThatIsOldOrOfAnotherTime) {
  EXPECT_TRUE(shown(order({0, 0, 1}, kNow - 20 * kMs)));
  EXPECT_FALSE(shown(order({0, 0, 1}, kNow - 20 * kMs - 1))) << "the loop hangs";
  EXPECT_FALSE(shown(order({0, 0, 1}, 0))) << "nothing was ordered yet";
  ForceCommand cut = order({0, 0, 1});
  cut.cuts = kCuts - 1;
  EXPECT_FALSE(shown(cut)) << "begun before the watchdog cut";
  ForceCommand early = order({0, 0, 1});
  early.epoch = kEpoch - 1;
  EXPECT_FALSE(shown(early)) << "made before the interruption";
}

TEST(ForceRamp, ShowsNothingOfWhatIsNoNumber) {
  EXPECT_FALSE(shown(order({std::numeric_limits<double>::quiet_NaN(), 0, 1})));
  EXPECT_FALSE(shown(order({0, std::numeric_limits<double>::infinity(), 0})));
}

TEST(ForceRamp, RisesFromZeroAfterItWasShut) {
  ForceRamp ramp;
  ramp.shut(kNow);
  EXPECT_EQ(norm(*shown(order({0, 0, 4}), ramp)), 0);
  for (int ms = 0; ms < 200; ++ms) {
    const std::int64_t now = kNow + ms * kMs;
    const auto force = ramp.shown(order({0, 0, 4}, now), kCuts, kEpoch, now);
    ASSERT_TRUE(force);
    EXPECT_NEAR(norm(*force), std::min(4.0, 0.05 * ms), 1e-9) << ms;
  }
}

TEST(ForceRamp, AnOrderThatIsNotShownShutsItAndZeroDoesNot) {
  ForceRamp ramp;
  EXPECT_EQ(norm(*ramp.shown(order({}), kCuts, kEpoch, kNow)), 0);
  EXPECT_EQ(norm(*ramp.shown(order({0, 0, 3}), kCuts, kEpoch, kNow)), 3);
  EXPECT_FALSE(ramp.shown(order({0, 0, 3}, kNow - 30 * kMs), kCuts, kEpoch, kNow));
  EXPECT_EQ(norm(*ramp.shown(order({0, 0, 3}), kCuts, kEpoch, kNow)), 0);
}

TEST(LoopEnd, OrdersCarryTheEpochAndTheCutsOfTheReadingBefore) {
  LoopEnd end;
  LinkReading link;
  link.epoch = 3;
  end.take(9, link);
  const ForceCommand ordered = end.order({1, 2, 3}, kNow);
  EXPECT_EQ(ordered.epoch, 3U);
  EXPECT_EQ(ordered.cuts, 9U);
  EXPECT_EQ(ordered.time_ns, kNow);
  EXPECT_EQ(ordered.force.z, 3);
}

TEST(LoopEnd, AnInterruptionThatIsOverIsToldOnce) {
  LoopEnd end;
  LinkReading link;
  link.fault = DeviceFault::none;
  EXPECT_EQ(end.take(0, link).fault, DeviceFault::none);
  link.interrupt(DeviceFault::timeout, kNow);
  link.fault = DeviceFault::none;
  EXPECT_EQ(end.take(0, link).fault, DeviceFault::timeout);
  EXPECT_EQ(end.take(0, link).fault, DeviceFault::none);
  EXPECT_EQ(end.order({}, kNow).epoch, 1U);
}

}  // namespace
}  // namespace relievo
