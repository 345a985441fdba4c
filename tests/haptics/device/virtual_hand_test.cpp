// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/virtual_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "haptics/device_catalog.h"

namespace relievo {
namespace {

constexpr std::int64_t kTickNs = 1'000'000;

/// A mass in free space: no hand, no friction, no rounding, no delay.
VirtualHandOptions bareMass() {
  VirtualHandOptions options;
  options.hand = {"none", 0, 0, 0};
  options.device_mass_kg = 0.2;
  options.device_damping_n_s_per_mm = 0;
  options.coulomb_n = 0;
  options.position_step_mm = 0;
  options.delay_ticks = 0;
  return options;
}

/// Positions over some ticks under a constant force; the hand starts at 0 and is meant to be there.
std::vector<DeviceMm> pushed(const VirtualHandOptions& options, DeviceN force, int ticks) {
  VirtualHand hand(options);
  hand.open();
  std::vector<DeviceMm> way;
  for (int i = 1; i <= ticks; ++i) way.push_back(hand.exchange(force, i * kTickNs).position);
  return way;
}

TEST(VirtualHand, AFreeMassFollowsNewtonsLaw) {
  // x = F t^2 / 2m = 0.5 N / 0.4 kg * (0.1 s)^2 = 12.5 mm; 101 readings, the first at t = 0.
  const auto way = pushed(bareMass(), {0.5, 0, 0}, 101);
  EXPECT_NEAR(way.back().x, 12.5, 0.01);
  EXPECT_EQ(way.back().y, 0);
}

TEST(VirtualHand, SettlesWhereHandAndForceBalance) {
  VirtualHandOptions options;
  options.hand = {"test", 0.05, 0.5, 0.005};
  options.coulomb_n = 0;
  options.position_step_mm = 0;
  const auto way = pushed(options, {0, 0, 1}, 3000);
  EXPECT_NEAR(way.back().z, 2, 1e-6) << "1 N against 0.5 N/mm";
}

TEST(VirtualHand, DryFrictionHoldsAgainstASmallForceAndTakesAwayALargerOne) {
  VirtualHandOptions options = bareMass();
  options.coulomb_n = 0.2;
  EXPECT_EQ(pushed(options, {0.19, 0, 0}, 500).back(), DeviceMm{});
  const double with = pushed(options, {0.5, 0, 0}, 101).back().x;
  EXPECT_NEAR(with, 12.5 * 0.3 / 0.5, 0.01);
}

TEST(VirtualHand, DampingNeverGivesEnergy) {
  VirtualHandOptions options = bareMass();
  options.device_damping_n_s_per_mm = 0.5;  // Far beyond what an explicit step could stand.
  VirtualHand hand(options);
  hand.open();
  for (int i = 1; i <= 50; ++i) hand.exchange({4, 0, 0}, i * kTickNs);
  double speed = norm(hand.velocity());
  EXPECT_NEAR(speed, 8, 0.01) << "F / b";
  for (int i = 51; i <= 100; ++i) {
    hand.exchange({}, i * kTickNs);
    EXPECT_LE(norm(hand.velocity()), speed);
    speed = norm(hand.velocity());
  }
}

TEST(VirtualHand, ReportsWholeEncoderCounts) {
  VirtualHandOptions options = bareMass();
  options.position_step_mm = 0.0635;
  bool moved = false;
  for (const DeviceMm p : pushed(options, {0.3, -0.1, 0.02}, 300)) {
    for (const double x : {p.x, p.y, p.z}) {
      EXPECT_NEAR(x / 0.0635, std::round(x / 0.0635), 1e-9);
      moved = moved || x != 0;
    }
  }
  EXPECT_TRUE(moved);
}

TEST(VirtualHand, FeelsAForceAfterItsDelay) {
  for (const int delay : {0, 1, 2}) {
    VirtualHandOptions options = bareMass();
    options.delay_ticks = delay;
    const auto way = pushed(options, {1, 0, 0}, 6);
    for (int i = 0; i < 6; ++i) {
      // Reading 0 is the start; the force handed over with it acts until reading 1.
      EXPECT_EQ(way[static_cast<std::size_t>(i)].x > 0, i > delay) << delay << " " << i;
    }
    EXPECT_EQ(VirtualHand(options).info().force_delay_ticks, delay);
  }
}

TEST(VirtualHand, ItsMotorsSaturateAndIgnoreWhatIsNoNumber) {
  const auto strong = pushed(bareMass(), {0, 80, 0}, 20),
             at_most = pushed(bareMass(), {0, 8, 0}, 20);
  EXPECT_EQ(strong.back(), at_most.back());
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pushed(bareMass(), {kNan, 0, 0}, 20).back(), DeviceMm{});
}

TEST(VirtualHand, TheSameTimesAndForcesGiveTheSameBits) {
  VirtualHand a, b;
  a.open();
  b.open();
  for (int i = 1; i <= 2000; ++i) {
    const DeviceMm aim{0.01 * i, std::sin(0.01 * i), -3};
    a.moveTo(aim);
    b.moveTo(aim);
    const DeviceN force{std::sin(0.3 * i), 0.2, 1};
    const auto x = a.exchange(force, i * kTickNs), y = b.exchange(force, i * kTickNs);
    ASSERT_EQ(x.position, y.position) << i;
    ASSERT_EQ(a.position(), b.position()) << i;
  }
}

TEST(VirtualHand, FollowsItsAimAndJumpsOnlyWhenPlaced) {
  VirtualHand hand;
  hand.open();
  hand.placeAt({10, 0, 0});
  EXPECT_NEAR(hand.exchange({}, kTickNs).position.x, 10, 0.04);
  hand.moveTo({20, 0, 0});
  EXPECT_LT(hand.exchange({}, 2 * kTickNs).position.x, 10.1) << "a mass does not jump";
  double x = 0;
  for (int i = 3; i < 4000; ++i) x = hand.exchange({}, i * kTickNs).position.x;
  EXPECT_NEAR(x, 20, 0.1 / 0.2 + 0.04) << "within what dry friction holds";
  hand.placeAt({-5, 0, 0});
  EXPECT_NEAR(hand.exchange({}, 4001 * kTickNs).position.x, -5, 0.04);
  EXPECT_EQ(hand.velocity(), DeviceMmPerS{});
}

TEST(VirtualHand, PassesOnAnAimThatIsNoNumberAndRecovers) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  VirtualHand hand;
  hand.open();
  hand.moveTo({1, kNan, 0});
  EXPECT_FALSE(isFinite(hand.exchange({}, kTickNs).position));
  hand.moveTo({1, 2, 0});
  for (int i = 2; i < 100; ++i) EXPECT_TRUE(isFinite(hand.exchange({}, i * kTickNs).position));
}

TEST(VirtualHand, AWatchdogsCutEndsTheForceUntilTheNextExchange) {
  VirtualHandOptions options = bareMass();
  VirtualHand cut(options), held(options);
  for (VirtualHand* hand : {&cut, &held}) {
    hand->open();
    hand->exchange({2, 0, 0}, kTickNs);
  }
  cut.cutForce();  // At the monotonic clock's time, long after this tick.
  cut.exchange({}, 2 * kTickNs);
  held.exchange({}, 2 * kTickNs);
  EXPECT_EQ(cut.position(), held.position()) << "until then the force held";
  options.delay_ticks = 2;
  VirtualHand late(options);
  late.open();
  late.exchange({2, 0, 0}, kTickNs);
  late.cutForce();
  for (int i = 2; i < 8; ++i) late.exchange({}, i * kTickNs);
  EXPECT_EQ(late.position(), DeviceMm{}) << "nor does a force still arrive that was under way";
}

TEST(VirtualHand, SimulatesALateTickAtOnceAndALongPauseInPart) {
  VirtualHand hand(bareMass());
  hand.open();
  hand.exchange({0.5, 0, 0}, kTickNs);
  EXPECT_NEAR(hand.exchange({0.5, 0, 0}, 101 * kTickNs).position.x, 12.5, 0.01);
  const double reach = hand.exchange({}, 3'600'000'000'000).position.x;
  EXPECT_LT(reach, 12.5 + 250 * 0.25 + 1000 * 0.25) << "an hour asleep does not fling it away";
}

TEST(VirtualHand, RefusesImpossibleOptions) {
  VirtualHandOptions options;
  options.device_mass_kg = 0;
  EXPECT_THROW(VirtualHand{options}, ArgumentError);
  options = {};
  options.delay_ticks = 3;
  EXPECT_THROW(VirtualHand{options}, ArgumentError);
  options = {};
  options.coulomb_n = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(VirtualHand{options}, ArgumentError);
  EXPECT_THROW(virtualHandNamed("iron"), DeviceError);
}

TEST(DeviceCatalog, NamesTheMouseAndEveryGripOfTheVirtualHand) {
  std::vector<std::string> ids;
  for (const DeviceDriver& driver : deviceCatalog()) {
    for (const std::string& id : driver.scan()) {
      ids.push_back(id);
      if (driver.kind == "mouse" || driver.kind == "virtual") {
        EXPECT_EQ(driver.make(id)->info().id, id);
      }
    }
  }
  for (const char* id : {"mouse", "virtual:light", "virtual:relaxed", "virtual:firm"}) {
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
  }
  EXPECT_EQ(makeDevice("virtual")->info().id, "virtual:relaxed") << "the usual grip";
  EXPECT_THROW(makeDevice("virtual:iron"), DeviceError);
  EXPECT_THROW(makeDevice("loom"), DeviceError);
}

}  // namespace
}  // namespace relievo
