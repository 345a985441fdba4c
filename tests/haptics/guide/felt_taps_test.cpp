// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/guide/felt_taps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include "haptics/device/virtual_hand.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using Law = TapLaw;

GuideInput handAt(double z_mm) {
  return {.hand = {0, 0, z_mm}, .velocity = {}, .forces_on = true, .rise = 1};
}

TEST(FeltTaps, AreHalfSinesOutwardAsManyAsThePatternHas) {
  for (const FeltPattern pattern :
       {FeltPattern::yes, FeltPattern::not_measured, FeltPattern::edge}) {
    TapState state;
    const int count = static_cast<int>(pattern);
    for (int tick = 0; tick < 700; ++tick) {
      const TapStep step = tapped({.id = 1, .pattern = pattern}, handAt(0), state);
      const double t_s = 0.001 * (tick % 150);
      const bool is_tap = tick / 150 < count && t_s < 0.03 - 1e-9;
      const double expected = is_tap ? 0.4 * std::sin(std::numbers::pi * t_s / 0.03) : 0;
      ASSERT_NEAR(step.force.z, expected, 1e-9) << count << " taps, tick " << tick;
      ASSERT_EQ(step.force.x, 0);
      ASSERT_EQ(step.force.y, 0);
      state = step.state;
    }
    EXPECT_EQ(state.left, 0) << "once";
  }
}

TEST(FeltTaps, WhatTheyGiveIsWhatTheyDidToTheHand) {
  TapState state;
  double z_mm = 3, work_mj = 0, given_mj = 0;
  for (int tick = 0; tick < 500; ++tick) {
    z_mm += 0.02 * std::sin(0.05 * tick);
    const TapStep step = tapped({.id = 1, .pattern = FeltPattern::edge}, handAt(z_mm), state);
    const double next_mm = z_mm + 0.02 * std::sin(0.05 * (tick + 1));
    work_mj += step.force.z * (next_mm - z_mm);
    given_mj += step.given_mj;
    state = step.state;
  }
  EXPECT_NEAR(given_mj, work_mj, 1e-9) << "nothing stands in it at the end";
  EXPECT_NE(work_mj, 0);
}

TEST(FeltTaps, NoneWithoutForcesAndThoseThatWaitTooLongAreForgotten) {
  const TapOptions options{.id = 1, .pattern = FeltPattern::edge};
  const auto taps_after = [&](int ticks, void (*change)(GuideInput&)) {
    TapState state;
    int felt = 0;
    for (int tick = 0; tick < 3000; ++tick) {
      GuideInput input = handAt(0);
      if (tick < ticks) change(input);
      const TapStep step = tapped(options, input, state);
      if (tick < ticks) {
        EXPECT_EQ(step.force, DeviceN{});
      }
      felt += step.force.z > 0 && state.force_n == 0 ? 1 : 0;
      state = step.state;
    }
    return felt;
  };
  EXPECT_EQ(taps_after(10, [](GuideInput& in) { in.forces_on = false; }), 0);
  EXPECT_EQ(taps_after(900, [](GuideInput& in) { in.rise = 0; }), 3) << "it waits for forces";
  EXPECT_EQ(taps_after(1100, [](GuideInput& in) { in.rise = 0; }), 0);
  EXPECT_EQ(taps_after(900, [](GuideInput& in) { in.in_detent = true; }), 3);
}

TEST(FeltTaps, ANewPatternCutsTheOldOneOff) {
  TapState state;
  double given_mj = 0, work_mj = 0, z_mm = 0;
  int felt = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    const TapOptions options{.id = tick < 160 ? 1U : 2U,
                             .pattern = tick < 160 ? FeltPattern::edge : FeltPattern::yes};
    const TapStep step = tapped(options, handAt(z_mm), state);
    felt += step.force.z > 0 && state.force_n == 0 ? 1 : 0;
    work_mj += 0.01 * step.force.z;
    z_mm += 0.01;
    given_mj += step.given_mj;
    state = step.state;
  }
  EXPECT_EQ(felt, 3) << "two of the old one";
  EXPECT_NEAR(given_mj, work_mj, 1e-9);
}

/// Through the whole chain: a hand that rests on a plane.
TEST(FeltTaps, ArriveAsTheyAreWhateverTheStrengthAndBreakNoLimit) {
  const auto space = test::spaceOf(80, [](double, double) { return 0; });
  for (const HandImpedance& kind : kHandPresets) {
    for (const double strength : {0.2, 1.0}) {
      VirtualHand hand({.hand = kind});
      HapticOptions options;
      options.force.forces_on = true;
      options.force.strength = strength;
      options = withinDevice(options, hand.info());
      hand.open();
      hand.placeAt({0, 0, 8});
      HapticCore core;
      double before_n = 0, most_n = 0, way_mm = 0, from_mm = 0;
      for (int i = 0; i < 6000; ++i) {
        const std::int64_t now = 1'000'000LL * (i + 1);
        if (i == 1000) hand.moveTo({0, 0, -6});
        if (i == 5000) {
          options.taps = {.id = 7, .pattern = FeltPattern::edge};
          from_mm = hand.position().z;
        }
        const HapticSample sample = core.tick(*space, options, hand.read(now), now);
        hand.send(sample.force, now);
        if (i == 4999) before_n = sample.force.z;
        if (i < 5000) continue;
        most_n = std::max(most_n, sample.force.z - before_n);
        way_mm = std::max(way_mm, hand.position().z - from_mm);
        ASSERT_EQ(sample.softened, 0) << kind.name;
      }
      EXPECT_GT(before_n, 0.05) << "it touches";
      EXPECT_LE(most_n, 0.5) << kind.name << ": 0.4 N, and what a hand that comes back presses";
      EXPECT_GT(most_n, 0.2) << kind.name << ": the surface is left by the way that the hand gives";
      EXPECT_LT(way_mm, 3) << kind.name;
      EXPECT_EQ(core.audit().violations(), 0U) << kind.name << " at " << strength;
      std::cout << kind.name << " at strength " << strength << ": " << most_n
                << " N more, the hand " << way_mm << " mm out\n";
    }
  }
}

TEST(FeltTaps, AHandWithoutForcesFeelsNothing) {
  const auto space = test::spaceOf(80, [](double, double) { return 0; });
  HapticOptions options;
  options.taps = {.id = 7, .pattern = FeltPattern::edge};
  HapticCore core;
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t now = 1'000'000LL * (i + 1);
    options.force.forces_on = i >= 500;  // By then it is forgotten.
    const HapticSample sample =
        core.tick(*space, options, {.position = {0, 0, 8}, .time_ns = now}, now);
    ASSERT_EQ(sample.force, DeviceN{}) << i;
  }
}

}  // namespace
}  // namespace relievo
