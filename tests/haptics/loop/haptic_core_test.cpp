// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/haptic_core.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/region/hand.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using test::belowMm;
using test::spaceOf;

class Core : public ::testing::Test {
 protected:
  HapticSample tick(DeviceMm hand, DeviceFault fault = DeviceFault::none) {
    now_ns_ += 1'000'000;
    DeviceReading reading;
    reading.position = hand;
    reading.time_ns = now_ns_;
    reading.fault = fault;
    return core_.tick(*space_, options_, reading, now_ns_);
  }
  void switchOn() {
    options_.force.forces_on = true;
    options_.force.strength = 1;
    for (int i = 0; i < 1100; ++i) tick({0, 0, 20});
    ASSERT_EQ(tick({0, 0, 20}).engaged, EngagePhase::on);
  }
  HapticSample pressFor(int ticks, double z) {
    HapticSample sample;
    for (int i = 0; i < ticks; ++i) sample = tick({0, 0, z});
    return sample;
  }

  std::unique_ptr<HapticSpace> space_ = spaceOf(
      80, [](double, double) { return 0.0; }, 7);
  HapticOptions options_;
  HapticCore core_;
  std::int64_t now_ns_ = 0;
};

TEST_F(Core, TakesTheStiffnessThatTheDetailSuggests) {
  switchOn();
  space_->detail = 3;
  const HapticSample sample = pressFor(100, -2);
  EXPECT_EQ(sample.stiffness_n_per_mm, 0.6);
  EXPECT_NEAR(sample.force.z, 1.2, 1e-9);
  options_.stiffness_by_detail = false;
  options_.force.stiffness_n_per_mm = 0.25;
  EXPECT_NEAR(pressFor(400, -2).force.z, 0.5, 1e-9) << "gradually";
}

TEST_F(Core, LatchesAFaultUntilForcesWereSwitchedOff) {
  switchOn();
  EXPECT_GT(pressFor(100, -2).force.z, 1);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  HapticSample sample = tick({0, kNan, -2});
  EXPECT_EQ(sample.fault, DeviceFault::not_finite);
  EXPECT_EQ(sample.force, DeviceN{});
  EXPECT_TRUE(isFinite(sample.hip) && isFinite(sample.proxy));
  sample = pressFor(2000, 20);
  EXPECT_EQ(sample.fault, DeviceFault::not_finite) << "latched";
  EXPECT_EQ(sample.engaged, EngagePhase::off);
  options_.force.forces_on = false;
  EXPECT_EQ(tick({0, 0, 20}).fault, DeviceFault::none);
  switchOn();
  EXPECT_GT(pressFor(100, -2).force.z, 1);
}

TEST_F(Core, TakesAnyBrokenHandForAFault) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const DeviceMm hand :
       {DeviceMm{kInfinity, 0, 0}, DeviceMm{0, -kInfinity, 0}, DeviceMm{0, 0, 1e300}}) {
    const HapticSample sample = tick(hand);
    EXPECT_EQ(sample.fault, DeviceFault::not_finite);
    EXPECT_TRUE(isFinite(sample.proxy) && isFinite(sample.normal));
    EXPECT_EQ(sample.force, DeviceN{});
  }
  EXPECT_EQ(tick({0, 0, 1}, DeviceFault::disconnected).fault, DeviceFault::disconnected);
}

TEST_F(Core, ANewWindowKeepsTheHandAndFadesTheForceIn) {
  switchOn();
  const HapticSample before = pressFor(100, -2);
  EXPECT_NEAR(before.force.z, 1.6, 1e-9);
  // Both windows are level, so that each has its mid height at the hand's zero; a higher one is
  // made by moving it.
  space_ = spaceOf(
      80, [](double, double) { return 0.0; }, 8);
  space_->device_translation.z = 5;
  HapticSample sample = tick({0, 0, -2});
  EXPECT_EQ(sample.hip, before.hip);
  EXPECT_TRUE(sample.contact);
  EXPECT_NEAR(sample.proxy.z, 5, 1e-9) << "on the new surface, not below it";
  EXPECT_EQ(sample.engaged, EngagePhase::rising);
  double last = norm(sample.force);
  EXPECT_LE(last, 1.6) << "no kick";
  for (int i = 0; i < 1500; ++i) {
    sample = tick({0, 0, -2});
    const double now = norm(sample.force);
    EXPECT_LE(std::abs(now - last), 0.2 + 1e-9);
    last = now;
  }
  EXPECT_NEAR(last, 0.8 * 7, 1e-9);
}

TEST_F(Core, StartsFromZeroAfterAPauseAndSolvesTheMissedWay) {
  switchOn();
  EXPECT_GT(pressFor(100, -2).force.z, 1);
  EXPECT_FALSE(core_.pausedUntil(now_ns_ + HapticCore::kPauseNs));
  now_ns_ += 60'000'000;
  EXPECT_TRUE(core_.pausedUntil(now_ns_ + 1'000'000));
  HapticSample sample = tick({0, 0, -6});
  EXPECT_TRUE(sample.resumed);
  EXPECT_EQ(sample.force, DeviceN{});
  EXPECT_NEAR(sample.proxy.z, 0, 1e-9) << "still on the surface";
  DeviceN last;
  for (int i = 0; i < 1500; ++i) {
    sample = tick({0, 0, -6});
    EXPECT_FALSE(sample.resumed);
    EXPECT_LE(norm(sample.force - last), (i < 900 ? 0.02 : 0.2) + 1e-9) << i;
    last = sample.force;
  }
  EXPECT_NEAR(last.z, 4.8, 1e-9);
  EXPECT_EQ(core_.audit().violations(), 0U);
}

TEST_F(Core, ALateTickDoesNotJump) {
  switchOn();
  const HapticSample before = pressFor(100, -0.5);
  now_ns_ += 15'000'000;  // Late, but not a pause.
  const HapticSample after = tick({0, 0, -6});
  EXPECT_FALSE(after.resumed);
  EXPECT_LE(norm(after.force - before.force), 0.2 + 1e-9);
}

TEST_F(Core, OldPositionsLetTheForceFallFasterThanItMayRiseAndTheAuditKnows) {
  switchOn();
  options_.force.limit_n = 5;
  pressFor(100, -8);
  const std::int64_t last_place_ns = now_ns_;
  double before_n = 0, largest_fall_n = 0;
  for (int age_ms = 0; age_ms < 30; ++age_ms) {
    DeviceReading reading;
    reading.position = {0, 0, -8};
    reading.time_ns = last_place_ns;
    const double n = norm(core_.tick(*space_, options_, reading, now_ns_).force);
    EXPECT_EQ(n == 5, age_ms <= 10) << age_ms;
    EXPECT_EQ(n == 0, age_ms >= 20) << age_ms;
    if (age_ms > 0) largest_fall_n = std::max(largest_fall_n, before_n - n);
    before_n = n;
    now_ns_ += 1'000'000;
  }
  EXPECT_NEAR(largest_fall_n, 0.5, 1e-9) << "more than the 0.2 N by which it may rise";
  EXPECT_EQ(core_.audit().violations(), 0U);
  EXPECT_EQ(core_.audit().fast_falls, 9U) << "and the last one is to zero";
  for (int i = 0; i < 100; ++i) tick({0, 0, -8});
  EXPECT_EQ(core_.audit().violations(), 0U) << "and rises slowly";
}

TEST_F(Core, SendsZeroInEveryTickWhoseInputsDemandIt) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  int demanded = 0;
  for (int i = 0; i < 60'000; ++i) {
    const double what = unit(random);
    options_.force.forces_on = options_.force.forces_on ? what > 0.0003 : what < 0.05;
    options_.force.strength = unit(random) < 0.001 ? 0 : 1;
    now_ns_ += unit(random) < 0.0002 ? 70'000'000 : 0;
    const double old_ns = unit(random) < 0.001 ? 25e6 : 0;
    DeviceReading reading;
    reading.position = {20 * unit(random), 0,
                        unit(random) < 0.01 ? -8. : (i % 4000 < 1500 ? 5 : -3)};
    if (unit(random) < 0.0001) reading.position.x = kNan;
    now_ns_ += 1'000'000;
    reading.time_ns = now_ns_ - static_cast<std::int64_t>(old_ns);
    const bool paused = core_.pausedUntil(now_ns_);
    const HapticSample s = core_.tick(*space_, options_, reading, now_ns_);
    const bool zero = paused || !options_.force.forces_on || s.fault != DeviceFault::none ||
                      options_.force.strength == 0 || old_ns > 20e6;
    if (zero) {
      ++demanded;
      EXPECT_EQ(s.force, DeviceN{}) << i;
    }
  }
  EXPECT_GT(demanded, 100);
  EXPECT_GE(core_.audit().zero_demanded, static_cast<std::uint64_t>(demanded));
  EXPECT_GT(core_.audit().largest_n, 1) << "and between them it pushed";
  EXPECT_EQ(core_.audit().violations(), 0U);
}

TEST_F(Core, CountsTicksAndNamesTheWindow) {
  space_->origins.fill(static_cast<std::uint8_t>(CellStatus::interpolated));
  EXPECT_EQ(tick({0, 0, 3}).tick, 0U);
  const HapticSample sample = tick({0, 0, -3});
  EXPECT_EQ(sample.tick, 1U);
  EXPECT_EQ(sample.window_id, 7U);
  EXPECT_EQ(sample.origin, CellStatus::interpolated);
  EXPECT_EQ(sample.hip_view, (ViewMm{40, 40, -3}));
}

TEST_F(Core, StaysWithinItsLimitsForAHundredThousandWildTicks) {
  std::mt19937 random(77);
  std::uniform_real_distribution<double> unit(-1, 1);
  space_ = spaceOf(
      80, [&](double x, double) { return 5 * unit(random) + (x > 40 ? 9 : 0); }, 9);
  options_.force.forces_on = true;
  DeviceMm hand{0, 0, 30};
  DeviceN last;
  for (int i = 0; i < 100'000; ++i) {
    if (i % 50 == 0) hand = {60 * unit(random), 60 * unit(random), 40 * unit(random)};
    hand = hand + DeviceMm{unit(random), unit(random), unit(random)};
    const HapticSample s = tick(hand);
    ASSERT_TRUE(isFinite(s.force) && isFinite(s.proxy)) << i;
    EXPECT_LE(norm(s.force), 6 + 1e-9) << i;
    EXPECT_LE(norm(s.force - last), 0.2 + 1e-9) << i;
    EXPECT_LE(belowMm(*space_, s.proxy_view), 1e-6) << i;
    last = s.force;
  }
}

/// One count of a coarse encoder in the first tick is no hand of 63 mm/s.
TEST(CoreSpeed, TheFirstStepsOfAHandAreTooCoarseForASpeed) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = 0.1;
  options.force.damping_n_s_per_mm = 0.002;
  const double plane_mm = space->deviceFromView({40, 40, 0}).z;
  HapticCore core(ForceChain::bare);
  for (int ms = 0; ms < 20; ++ms) {
    DeviceReading reading;
    reading.time_ns = ms * 1'000'000LL;
    reading.position = {0, 0, plane_mm - 1 - 0.0635 * std::min(ms, 3)};
    const HapticSample s = core.tick(*space, options, reading, reading.time_ns);
    const double damped_n = s.force.z - 0.1 * (s.proxy.z - s.hip.z);
    EXPECT_LE(damped_n, 0.002 * 1000 * 3 * 0.0635 / 8 + 1e-9) << ms;
  }
}

/// A device at its own pace: now and then the loop gets a reading twice and then misses one.
TEST(CoreSpeed, IsTakenOverTheReadingsOwnTimes) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = 0.1;
  options.force.damping_n_s_per_mm = 0.002;
  constexpr double kMmPerMs = 0.05;
  const double plane_mm = space->deviceFromView({40, 40, 0}).z;
  HapticCore core(ForceChain::bare);
  double least = 1, most = 0;
  for (int ms = 0; ms < 400; ++ms) {
    const int sampled = ms - (ms % 10 == 3 ? 1 : 0);
    DeviceReading reading;
    reading.time_ns = sampled * 1'000'000LL;
    reading.position = {0, 0, plane_mm + 5 - kMmPerMs * sampled};
    const HapticSample s = core.tick(*space, options, reading, ms * 1'000'000LL);
    if (ms < 150) continue;
    const double damped_n = s.force.z - 0.1 * (s.proxy.z - s.hip.z);
    least = std::min(least, damped_n);
    most = std::max(most, damped_n);
  }
  const double expected_n = 0.002 * 1000 * kMmPerMs;
  EXPECT_NEAR(least, expected_n, 0.01 * expected_n);
  EXPECT_NEAR(most, expected_n, 0.01 * expected_n);
}

class HoveringHand : public Core {
 protected:
  HoveringHand() {
    // A wall across the middle, 20 mm high and 4 mm thick.
    space_ = spaceOf(
        80, [](double x, double) { return std::abs(x - 40) < 2 ? 20.0 : 0.0; }, 7);
  }
  DeviceMm over(double x, double above_mm) const {
    const GridPoint g = space_->gridFromView({x, 40, 0});
    DeviceMm p = space_->deviceFromGrid({g.x, g.y, surfaceHeight(*space_, g.x, g.y)});
    p.z += above_mm;
    return p;
  }
  DeviceReading readingAt(DeviceMm hand, bool hovers) {
    DeviceReading reading;
    reading.position = hand;
    reading.buttons = hovers ? kHoverBit : 0;
    reading.time_ns = now_ns_ += 1'000'000;
    return reading;
  }
  HapticSample carry(DeviceMm hand, bool hovers = true) {
    readings_.push_back(readingAt(hand, hovers));
    return core_.tick(*space_, options_, readings_.back(), now_ns_);
  }

  std::vector<DeviceReading> readings_;
};

TEST_F(HoveringHand, IsCarriedOverAWallThatHoldsAPressedOne) {
  carry(over(20, 0.5));
  const HapticSample there = carry(over(60, 0.5));
  EXPECT_FALSE(there.contact);
  EXPECT_EQ(there.proxy, there.hip);
  carry(over(20, 0.5));
  carry(over(20, -1), false);
  EXPECT_LT(carry(over(60, -1), false).proxy_view.x, 38.5) << "what is pressed does not go through";
}

TEST_F(HoveringHand, IsNeverBelowTheSurfaceAndTouchesWhereItIsPutDown) {
  for (const double x : {10.0, 39.0, 41.0, 70.0}) {
    const HapticSample lifted = carry(over(x, -15));
    EXPECT_FALSE(lifted.contact) << x;
    EXPECT_NEAR(norm(lifted.hip - over(x, kHoverMm)), 0, 1e-9) << x;
    const HapticSample pressed = carry(over(x, -1), false);
    EXPECT_TRUE(pressed.contact) << x;
    EXPECT_NEAR(pressed.proxy_view.x, x, 0.5) << x;
  }
}

TEST_F(HoveringHand, AWayThroughTheAirIsNoSpeedOfPressingIn) {
  options_.force.transient.contact_n = 2;
  options_.force.damping_n_s_per_mm = 0.002;
  switchOn();
  carry(over(5, 0.5));
  carry(over(75, 0.1));
  const HapticSample landed = carry(over(75, -0.05), false);
  EXPECT_TRUE(landed.contact);
  EXPECT_LT(landed.f_cmd_n, 0.8 * 0.05 + 0.1) << "0.15 mm in a tick, not 70 mm";
}

TEST_F(HoveringHand, AReplayOfWhatWasFeltIsTheSameToTheLastBit) {
  options_.force.forces_on = true;
  std::vector<HapticSample> felt;
  for (int i = 0; i < 4000; ++i) {
    const double x = 40 + 38 * std::sin(0.11 * i);
    felt.push_back(carry(over(x, 4 * std::cos(0.37 * i)), i % 50 < 40));
  }
  // As a recording says it: the hand that was used, its buttons and its time.
  HapticCore again;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    DeviceReading reading = readings_[i];
    reading.position = felt[i].hip;
    const HapticSample sample = again.tick(*space_, options_, reading, reading.time_ns);
    ASSERT_EQ(sample.hip, felt[i].hip) << i;
    ASSERT_EQ(sample.proxy, felt[i].proxy) << i;
    ASSERT_EQ(sample.force, felt[i].force) << i;
  }
}

}  // namespace
}  // namespace relievo
