// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/oscillation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/haptics/closed_loop.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

const double kPi = std::acos(-1.0);

/// How often the watch softened over two seconds of a force and a way of the hand.
int softenings(const std::function<double(double)>& force_z,
               const std::function<double(double)>& hip_x) {
  OscillationState state;
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.001 * i;
    state = watchOscillation({}, {{0, 0, force_z(t)}, {hip_x(t), 0, 0}, false}, state);
  }
  return state.softened;
}

double rest(double /*t*/) {
  return 0;
}

TEST(Oscillation, SoftensWhenAForceKeepsSwingingAtARestingHand) {
  for (const double hertz : {25., 60., 120., 250.}) {
    // Half the amplitude again for what the band's edges take away.
    EXPECT_GT(softenings([&](double t) { return 1 + 0.5 * std::sin(2 * kPi * hertz * t); }, rest),
              0)
        << hertz;
  }
}

TEST(Oscillation, LeavesSmallSlowAndSingleChangesAlone) {
  EXPECT_EQ(softenings([](double t) { return 1 + 0.2 * std::sin(2 * kPi * 60 * t); }, rest), 0);
  EXPECT_EQ(softenings([](double t) { return 2 + 2 * std::sin(2 * kPi * 2 * t); }, rest), 0)
      << "a hand that presses and lets go";
  EXPECT_EQ(softenings([](double t) { return t < 1 ? 0 : std::min(4., 200 * (t - 1)); }, rest), 0)
      << "a landing";
}

TEST(Oscillation, OnlyBlocksInARowCount) {
  // 50 ms of swing, 50 ms of calm, over and over: a texture that a resting finger passes.
  const auto bursts = [](double t) {
    const bool swings = static_cast<int>(t / 0.05) % 2 == 0;
    return 1 + (swings ? 0.6 * std::sin(2 * kPi * 100 * t) : 0);
  };
  EXPECT_EQ(softenings(bursts, rest), 0);
}

TEST(Oscillation, AllowsAMovingHandToFeelTexture) {
  const auto texture = [](double t) { return 1 + 0.5 * std::sin(2 * kPi * 50 * t); };
  EXPECT_EQ(softenings(texture, [](double t) { return 80 * t; }), 0) << "80 mm/s";
  EXPECT_GT(softenings(texture, [](double t) { return 5 * t; }), 0) << "hardly moving";
}

TEST(Oscillation, HalvesDownToItsLeastAndNoFurther) {
  OscillationState state;
  for (int i = 0; i < 5000; ++i) {
    state = watchOscillation({}, {{0, 0, 3 * std::sin(0.3 * i)}, {}, false}, state);
  }
  EXPECT_EQ(state.factor, 0.125);
  EXPECT_EQ(state.softened, 3);
}

TEST(Oscillation, TurnsAnUnstableHandStableAndSaysSo) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = 3;  // As much as it gives, and two ticks late.
  options.force.strength = 1;
  // A firm grip buzzes in the band; a light one is thrown off and comes back, 7 times a second.
  for (const char* grip : {"firm", "light"})
    for (const bool watch : {false, true}) {
      options.force.oscillation.on = watch;
      options.force.passivity.on = grip == std::string_view("light");
      VirtualHandOptions hand = virtualHandNamed(grip);
      hand.delay_ticks = 2;
      test::ClosedLoop loop(*space, hand, options);
      const double push_mm = 2 / virtualHandNamed(grip).hand.stiffness_n_per_mm;
      loop.switchOn({0, 0, 5});
      test::Swing swing;
      HapticSample sample;
      for (int i = 0; i < 4000; ++i) {
        if (i == 3000) swing.restart();
        sample = loop.tick({0, 0, -push_mm});
        swing.add(sample.force.z);
      }
      EXPECT_EQ(sample.softened > 0, watch);
      EXPECT_EQ(swing.peakToPeak() < 0.05, watch) << swing.peakToPeak();
      if (watch) {
        EXPECT_LT(sample.stiffness_n_per_mm, 3);
      }
      loop.options().force.forces_on = false;
      sample = loop.tick({0, 0, 5});
      EXPECT_EQ(sample.softened, 0) << "switched off, it starts anew";
    }
}

}  // namespace
}  // namespace relievo
