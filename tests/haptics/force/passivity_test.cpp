// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/passivity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/haptics/closed_loop.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr double kWindowS = 0.008, kTickS = 0.001;

TEST(Passivity, SeesTheLeakOfAHeldForceExactly) {
  // A spring of 0.8 N/mm pressed 2 mm in and let out again at 0.1 mm per tick. The force is held
  // for a tick after it was computed, so that the way out gives back more than the way in took.
  PassivityOptions options;
  options.reserve_mj = 100;
  PassivityState state;
  double gave_mj = 0, depth = 0;
  std::vector<double> forces{0};
  for (int i = 0; i <= 44; ++i) {
    const double step = i < 20 ? 0.1 : i < 40 ? -0.1 : 0;
    const double moved = i == 0 ? 0 : step;
    depth = std::max(0.0, depth + moved);
    gave_mj += forces[forces.size() - 1] * -moved;  // Up is out of the surface.
    state = observe(options, {0, 0, -moved}, 0.5 * 0.8 * depth * depth, state);
    forces.push_back(0.8 * depth);
    state = sentOut(state, {0, 0, 0.8 * depth});
  }
  EXPECT_GT(gave_mj, 0) << "a held force is active";
  EXPECT_NEAR(state.margin_mj, -gave_mj - state.stored_mj, 1e-12);
}

TEST(Passivity, TakesAsMuchAsIsOwedAndNeverMore) {
  PassivityOptions options;
  PassivityState state;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 10'000; ++i) {
    state.margin_mj = unit(random);
    const DeviceMm v{300 * unit(random), 300 * unit(random), 300 * unit(random)};
    const DeviceN f = passivityForce(options, state, v, kWindowS, kTickS);
    const double power = f.x * v.x + f.y * v.y + f.z * v.z;  // mW, given to the hand.
    EXPECT_LE(power, 0) << "never injects";
    EXPECT_LE(-power * kTickS, std::max(0.0, -state.margin_mj) * (1 + 1e-12)) << "nor overpays";
    EXPECT_LE(norm(f), options.most_damping_n_s_per_mm * norm(v) * (1 + 1e-12));
    if (state.margin_mj >= 0) {
      EXPECT_EQ(f, DeviceN{});
    }
  }
}

TEST(Passivity, CarriesTheDebtWhileTheHandMovesLessThanACount) {
  PassivityOptions options;
  options.position_step_mm = 0.0635;
  PassivityState state;
  state.margin_mj = -0.5;
  const double one_count = 0.0635 / kWindowS;
  EXPECT_EQ(passivityForce(options, state, {0.9 * one_count, 0, 0}, kWindowS, kTickS), DeviceN{});
  EXPECT_LT(passivityForce(options, state, {1.1 * one_count, 0, 0}, kWindowS, kTickS).x, 0);
  EXPECT_EQ(observe(options, {}, 0, state).margin_mj, -0.5) << "and it is still owed";
}

TEST(Passivity, ForgivesAndForgetsWithinBounds) {
  PassivityOptions options;
  PassivityState state;
  state = sentOut(sentOut(sentOut({}, {0, 0, 5}), {0, 0, 5}), {0, 0, 5});
  state.started = true;
  EXPECT_EQ(observe(options, {0, 0, 100}, 0, state).margin_mj, -options.most_debt_mj);
  EXPECT_EQ(observe(options, {0, 0, -100}, 0, state).margin_mj, options.reserve_mj);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(observe(options, {0, 0, kNan}, kNan, state).margin_mj, 0);
  state.margin_mj = -2;
  EXPECT_EQ(rebased(state).margin_mj, 0);
}

TEST(Passivity, ASpringStoresItsEnergyUpToTheCap) {
  EXPECT_DOUBLE_EQ(springEnergyMj(0.5, 4, 6), 4);
  EXPECT_DOUBLE_EQ(springEnergyMj(0.5, 12, 6), 36);
  EXPECT_DOUBLE_EQ(springEnergyMj(0.5, 14, 6), 36 + 12) << "beyond, a constant force";
  EXPECT_EQ(springEnergyMj(0, 4, 6), 0);
  EXPECT_EQ(springEnergyMj(0.5, 4, 0), 0);
}

/// Presses the virtual hand into a flat surface and holds it there.
/// @return how much the force still swings in the last second, N
double swingOnAFlat(const char* grip, double k, bool passivity) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = k;
  options.force.strength = 1;
  options.force.passivity.on = passivity;
  options.force.oscillation.on = false;
  const VirtualHandOptions hand = virtualHandNamed(grip);
  test::ClosedLoop loop(*space, hand, options);
  loop.switchOn({0, 0, 5});
  const DeviceMm aim{0, 0, -2 / hand.hand.stiffness_n_per_mm};  // About 2 N of push.
  test::Swing swing;
  for (int i = 0; i < 3000; ++i) {
    if (i == 2000) swing.restart();
    swing.add(loop.tick(aim).force.z);
  }
  return swing.peakToPeak();
}

TEST(Passivity, KeepsAHandStableThatOscillatesWithoutIt) {
  EXPECT_GT(swingOnAFlat("light", 1.2, false), 1) << "unstable without";
  EXPECT_LT(swingOnAFlat("light", 1.2, true), 0.01) << "stable with";
  EXPECT_GT(swingOnAFlat("relaxed", 1.5, false), 1);
  EXPECT_LT(swingOnAFlat("relaxed", 1.5, true), 0.01);
}

TEST(Passivity, DoesNotTouchAForceThatOwesNothing) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.strength = 1;
  test::ClosedLoop loop(*space, virtualHandNamed("relaxed"), options);
  loop.switchOn({0, 0, 5});
  HapticSample sample;
  for (int i = 0; i < 3000; ++i) sample = loop.tick({0, 0, -10});
  EXPECT_TRUE(sample.contact);
  EXPECT_EQ(sample.damped_n, 0);
  EXPECT_NEAR(sample.force.z, 0.5 * norm(sample.proxy - sample.hip), 1e-12);
}

}  // namespace
}  // namespace relievo
