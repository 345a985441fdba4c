// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/guide/beacon_pull.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string_view>

#include "haptics/device/virtual_hand.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using Law = BeaconLaw;
constexpr double kArmS = 0.2;

GuideInput handAt(DeviceMm hand, DeviceMm velocity = {}) {
  return {.hand = hand, .velocity = velocity, .forces_on = true, .rise = 1, .sent_most_n = 2};
}

/// Full weight, by ticks in which the hand stays where it is.
BeaconStep risen(const BeaconOptions& options, DeviceMm hand) {
  BeaconStep step;
  for (int i = 0; i < 2000; ++i) step = pulledBack(options, handAt(hand), step.state);
  return step;
}

TEST(BeaconPull, ForceAndEnergyAreTheClosedForm) {
  const BeaconOptions options{.id = 1, .place = {10, -5, 30}};
  for (const double away : {3.1, 10.0, 19.9, 20.0, 40.0, 80.0}) {
    const DeviceMm hand{10 - 0.6 * away, -5 - 0.8 * away, -20};
    const BeaconStep step = risen(options, hand);
    const double force = std::min(0.05 * away, 1.0);
    const double energy = (away < 20 ? 0.025 * away * away : away - 10) - 0.225;
    ASSERT_TRUE(step.state.pulls) << away;
    EXPECT_NEAR(step.force.x, 0.6 * force, 1e-12) << away;
    EXPECT_NEAR(step.force.y, 0.8 * force, 1e-12) << away;
    EXPECT_EQ(step.force.z, 0) << "the hand's height is its own";
    EXPECT_NEAR(step.energy_mj, energy, 1e-9) << away;
  }
  EXPECT_EQ(risen(options, {12, -5, 0}).state.end, GuideEnd::arrived);
  EXPECT_EQ(risen(options, {12, -5, 0}).force, DeviceN{});
}

TEST(BeaconPull, RisesNoFasterThanInHalfASecondAndFeedsInNoMoreThanIsAllowed) {
  for (const double away : {10.0, 30.0, 90.0}) {
    const BeaconOptions options{.id = 1, .place = {away, 0, 0}};
    BeaconStep step;
    double last = 0;
    int ticks = 0;
    for (; step.state.weight < 1 && ticks < 5000; ++ticks) {
      step = pulledBack(options, handAt({}), step.state);
      EXPECT_LE((step.energy_mj - last) / 0.001, Law::kMostFedMw + 1e-9) << away;
      EXPECT_NEAR(step.given_mj, step.energy_mj - last, 1e-9);
      last = step.energy_mj;
    }
    EXPECT_GE(ticks, 499) << away;
    EXPECT_LE(ticks, 1200) << away;
  }
}

/// A hand that is still, after something happened; and what that ended.
BeaconState endedBy(const std::function<void(BeaconOptions&, GuideInput&, int tick)>& act,
                    int ticks = 12'000) {
  BeaconOptions options{.id = 1, .place = {20, 0, 0}};
  BeaconState state;
  for (int i = 0; i < ticks; ++i) {
    GuideInput input = handAt({});
    act(options, input, i);
    state = pulledBack(options, input, state).state;
  }
  return state;
}

TEST(BeaconPull, EndsByTimeButtonsWishesAndSurfaces) {
  const auto nothing = [](BeaconOptions&, GuideInput&, int) {};
  EXPECT_TRUE(endedBy(nothing, 9'900).pulls);
  EXPECT_EQ(endedBy(nothing).end, GuideEnd::you_lead) << "after ten seconds";
  EXPECT_EQ(endedBy([](auto&, GuideInput& in, int i) { in.buttons = i > 900 ? 2 : 0; }).end,
            GuideEnd::button);
  EXPECT_TRUE(endedBy([](auto&, GuideInput& in, int) { in.buttons = 2; }, 900).pulls)
      << "a button that was held as it began";
  EXPECT_EQ(endedBy([](BeaconOptions& o, auto&, int i) { o.id = i > 900 ? 0 : 1; }).end,
            GuideEnd::asked);
  EXPECT_EQ(endedBy([](auto&, GuideInput& in, int i) { in.scene_id = i > 900 ? 3 : 0; }).end,
            GuideEnd::surface);
  EXPECT_EQ(endedBy([](auto&, GuideInput& in, int i) { in.forces_on = i <= 900; }).end,
            GuideEnd::no_forces);
  const BeaconState ended = endedBy([](BeaconOptions& o, auto&, int i) { o.id = i > 900 ? 0 : 1; });
  EXPECT_EQ(ended.weight, 0);
}

TEST(BeaconPull, WaitsInMoveModeWhoseButtonsAreNotItsOwn) {
  const BeaconState state = endedBy([](auto&, GuideInput& in, int i) {
    in.in_detent = i < 11'500;
    in.buttons = in.in_detent && i % 100 < 50 ? 1 : 0;
  });
  EXPECT_TRUE(state.pulls);
  EXPECT_NEAR(state.since_s, 0.5, 0.002) << "it has pulled since Move mode ended";
}

TEST(BeaconPull, LetsGoOfAHandThatGoesAwayForThreeTenths) {
  const BeaconOptions options{.id = 1, .place = {20, 0, 0}};
  BeaconState state = risen(options, {}).state;
  int ticks = 0;
  while (state.pulls && ticks < 2000) {
    state = pulledBack(options, handAt({}, {-20, 0, 0}), state).state;
    ++ticks;
  }
  EXPECT_EQ(ticks, 300);
  EXPECT_EQ(state.end, GuideEnd::you_lead);
  state = risen(options, {}).state;
  for (int i = 0; i < 1000; ++i) state = pulledBack(options, handAt({}, {0, 90, 0}), state).state;
  EXPECT_TRUE(state.pulls) << "past it is not away from it";
  for (int i = 0; i < 21; ++i) state = pulledBack(options, handAt({}, {300, 0, 0}), state).state;
  EXPECT_FALSE(state.pulls) << "a hand that fast wants to go somewhere";
}

TEST(BeaconPull, ANewOneBeginsOnceEvenWhileAnotherPulls) {
  BeaconOptions options{.id = 1, .place = {20, 0, 0}};
  BeaconState state = risen(options, {}).state;
  options = {.id = 2, .place = {0, 30, 0}};
  state = pulledBack(options, handAt({}), state).state;
  EXPECT_TRUE(state.pulls);
  EXPECT_EQ(state.id, 2U);
  EXPECT_LT(state.weight, 0.01);
  EXPECT_EQ(risen(options, {0, 30, 0}).state.end, GuideEnd::arrived);
  state = pulledBack(options, handAt({0, 30, 0}), state).state;
  state = pulledBack(options, handAt({}), state).state;
  EXPECT_FALSE(state.pulls) << "it has arrived, and does not begin again by itself";
}

struct Pulled {
  double seconds = 0, largest_side_n = 0, fastest_mm_per_s = 0, end_away_mm = 0, deepest_mm = 0;
  GuideEnd end = GuideEnd::none;
  ForceAudit audit;
};

/// A hand that rests on a dome, and an arm that gives way.
Pulled pulledOver(const HandImpedance& hand_kind, DeviceMm start, double strength) {
  const auto space =
      test::spaceOf(80, [](double x, double y) { return 2 * std::exp(-(x * x + y * y) / 900); });
  VirtualHand hand({.hand = hand_kind});
  HapticOptions options;
  options.force.forces_on = true;
  options.force.strength = strength;
  options = withinDevice(options, hand.info());
  hand.open();
  HapticCore core;
  DeviceMm aim{start.x, start.y, 8};
  hand.placeAt(aim);
  Pulled found;
  for (int i = 0; i < 15'000; ++i) {
    const std::int64_t now = 1'000'000LL * (i + 1);
    const DeviceMm at = hand.position();
    if (i == 1000) aim.z = start.z;  // Forces begin above the surface.
    if (i >= 2000) {
      options.beacon = {.id = 4, .place = {-20, -10, 0}};
      aim = aim + (0.001 / kArmS) * (DeviceMm{at.x, at.y, aim.z} - aim);
    }
    if (i > 0) hand.moveTo(aim);
    const HapticSample sample = core.tick(*space, options, hand.read(now), now);
    hand.send(sample.force, now);
    if (i < 2000) continue;
    if (!sample.pulled_back) {
      found.end = sample.beacon_end;
      break;
    }
    found.seconds += 0.001;
    found.largest_side_n =
        std::max(found.largest_side_n, std::hypot(sample.force.x, sample.force.y));
    found.deepest_mm = std::max(found.deepest_mm, norm(sample.proxy - sample.hip));
    const DeviceMmPerS v = hand.velocity();
    found.fastest_mm_per_s = std::max(found.fastest_mm_per_s, std::hypot(v.x, v.y));
  }
  const DeviceMm p = hand.position();
  found.end_away_mm = std::hypot(p.x + 20, p.y + 10);
  found.audit = core.audit();
  return found;
}

TEST(BeaconPull, BringsEveryHandBackOverASurfaceThatItFeels) {
  for (const HandImpedance& hand : kHandPresets) {
    for (const double strength : {0.4, 1.0}) {
      const Pulled found = pulledOver(hand, {25, 15, -1.5}, strength);
      const auto where = ::testing::Message() << hand.name << " at " << strength;
      // A firm grip gives way so slowly that ten seconds bring it most of the way of 51 mm.
      const bool firm = std::string_view(hand.name) == "firm";
      EXPECT_EQ(found.end, firm ? GuideEnd::you_lead : GuideEnd::arrived) << where;
      EXPECT_LT(found.end_away_mm, firm ? 20 : 4) << where;
      EXPECT_LT(found.fastest_mm_per_s, 250) << where;
      EXPECT_GT(found.deepest_mm, 0.05) << "the dome is felt on the way, " << where;
      EXPECT_EQ(found.audit.violations(), 0U) << where;
      std::cout << hand.name << " at strength " << strength << ": " << found.seconds << " s, "
                << found.fastest_mm_per_s << " mm/s, sideways " << found.largest_side_n << " N\n";
    }
  }
}

}  // namespace
}  // namespace relievo
