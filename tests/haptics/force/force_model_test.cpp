// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/force_model.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace relievo {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ForceInput pressedIn(double depth_mm) {
  ForceInput input;
  input.contact = depth_mm > 0;
  input.hip = {0, 0, -depth_mm};
  return input;
}

ForceOptions forcesOn() {
  ForceOptions options;
  options.forces_on = true;
  options.strength = 1;
  return options;
}

/// Switched on and risen, hand in free space.
ForceState risen(const ForceOptions& options) {
  ForceState state;
  for (int i = 0; i < 1100; ++i) state = force(options, pressedIn(0), state).state;
  EXPECT_EQ(state.phase, EngagePhase::on);
  return state;
}

TEST(Force, DampingOpposesPressingInAndNeverPullsTheHand) {
  ForceOptions options;
  options.damping_n_s_per_mm = 0.002;
  ForceInput input = pressedIn(1);
  input.normal = {0.6, 0, 0.8};
  input.velocity = {-60, 10, -80};  // 100 mm/s in, 10 mm/s across.
  const DeviceN in = dampingForce(options, input);
  EXPECT_NEAR(norm(in - DeviceN{0.12, 0, 0.16}), 0, 1e-15);
  input.moved = {0.01, 0, 0.01};  // The hand has turned round; the filter has not yet.
  EXPECT_EQ(dampingForce(options, input), DeviceN{});
  input.moved = {};
  input.velocity = {60, 10, 80};
  EXPECT_EQ(dampingForce(options, input), DeviceN{});
  input.velocity = {-60, 10, -80};
  input.contact = false;
  EXPECT_EQ(dampingForce(options, input), DeviceN{});
}

TEST(Force, PullsTheHandTowardTheProxyWithTheStiffness) {
  ForceOptions options;
  options.stiffness_n_per_mm = 0.8;
  ForceInput input;
  input.contact = true;
  input.proxy = {1, 2, 3};
  input.hip = {1.5, 2, 1};
  const DeviceN spring = springForce(options, input);
  EXPECT_DOUBLE_EQ(spring.x, -0.4);
  EXPECT_DOUBLE_EQ(spring.y, 0);
  EXPECT_DOUBLE_EQ(spring.z, 1.6);
  input.contact = false;
  EXPECT_EQ(springForce(options, input), DeviceN{}) << "free space";
}

TEST(Force, IsSofterWhereTheDetailIsFiner) {
  EXPECT_EQ(stiffnessForDetail(1), 0.8);
  EXPECT_EQ(stiffnessForDetail(2), 0.8);
  EXPECT_EQ(stiffnessForDetail(3), 0.6);
  EXPECT_EQ(stiffnessForDetail(4), 0.5);
  EXPECT_EQ(stiffnessForDetail(9), 0.5);
}

TEST(Force, IsTheBareSpringWithoutSafety) {
  const ForceOptions options;
  const ForceResult result = bareForce(options, pressedIn(100), {});
  EXPECT_DOUBLE_EQ(result.force.z, 50);
  EXPECT_DOUBLE_EQ(result.command_n, 50);
  EXPECT_FALSE(result.limited);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(bareForce(options, pressedIn(nan), {}).force, DeviceN{}) << "a number all the same";
}

TEST(Force, StaysOffUntilItIsAskedFor) {
  ForceState state;
  for (int i = 0; i < 3000; ++i) {
    const ForceResult result = force(ForceOptions{}, pressedIn(1), state);
    ASSERT_EQ(result.force, DeviceN{});
    state = result.state;
  }
}

TEST(Force, WaitsForFiveQuietTicksThenRisesForOneSecond) {
  const ForceOptions options = forcesOn();
  ForceState state;
  for (int i = 0; i < 500; ++i) {  // Hand in the surface: 0.5 N.
    const ForceResult result = force(options, pressedIn(1), state);
    ASSERT_EQ(result.force, DeviceN{});
    state = result.state;
  }
  EXPECT_EQ(state.phase, EngagePhase::waiting);
  for (int i = 0; i < 4; ++i) state = force(options, pressedIn(0.1), state).state;
  state = force(options, pressedIn(1), state).state;  // Not in a row.
  for (int i = 0; i < 4; ++i) state = force(options, pressedIn(0.1), state).state;
  EXPECT_EQ(state.phase, EngagePhase::waiting);
  state = force(options, pressedIn(0.1), state).state;
  EXPECT_EQ(state.phase, EngagePhase::rising);
  int ticks = 0;
  while (state.phase == EngagePhase::rising && ticks < 5000) {
    state = force(options, pressedIn(0.1), state).state;
    ++ticks;
  }
  EXPECT_NEAR(ticks, 1000, 2);
}

TEST(Force, RisesByAtMostTwentyNewtonsPerSecondWhileComingOn) {
  const ForceOptions options = forcesOn();
  ForceState state;
  for (int i = 0; i < 505; ++i) state = force(options, pressedIn(0), state).state;
  ASSERT_EQ(state.phase, EngagePhase::rising);
  for (int i = 0; i < 400; ++i) {  // Now a hard press.
    const DeviceN before = state.last;
    const ForceResult result = force(options, pressedIn(12), state);
    EXPECT_LE(norm(result.force) - norm(before), 0.020 + 1e-12);
    state = result.state;
  }
  EXPECT_GT(norm(state.last), 1);
}

TEST(Force, AHandThatLetsGoDuringTheRiseIsLetGoFast) {
  const ForceOptions options = forcesOn();
  ForceState state;
  for (int i = 0; i < 505; ++i) state = force(options, pressedIn(0), state).state;
  for (int i = 0; i < 400; ++i) state = force(options, pressedIn(12), state).state;
  ASSERT_EQ(state.phase, EngagePhase::rising);
  const double pressed_n = norm(state.last);
  ASSERT_GT(pressed_n, 1);
  int ticks = 0;
  for (; norm(state.last) > 0 && ticks < 400; ++ticks) {
    state = force(options, pressedIn(0), state).state;
  }
  EXPECT_LE(ticks, static_cast<int>(pressed_n / 0.2) + 1) << "200 N/s, not 20";
}

TEST(Force, ChangesByAtMostTwoHundredNewtonsPerSecondInContact) {
  const ForceOptions options = forcesOn();
  ForceState state = risen(options);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> depth(-5, 12);
  for (int i = 0; i < 20000; ++i) {
    const DeviceN before = state.last;
    const ForceResult result = force(options, pressedIn(depth(random)), state);
    EXPECT_LE(norm(result.force - before), 0.200 + 1e-12);
    EXPECT_LE(norm(result.force), options.limit_n * (1 + 1e-12));
    state = result.state;
  }
}

TEST(Force, NeverExceedsTheCapAndSaysThatItWasClamped) {
  const ForceOptions options = forcesOn();
  ForceState state = risen(options);
  ForceResult result;
  for (int i = 0; i < 200; ++i) {
    result = force(options, pressedIn(40), state);
    state = result.state;
  }
  EXPECT_NEAR(norm(result.force), 6, 1e-12);
  EXPECT_DOUBLE_EQ(result.command_n, 20) << "before limits";
  EXPECT_TRUE(result.limited);
  result = force(options, pressedIn(11.9), state);
  EXPECT_FALSE(result.limited) << "5.95 N is within all limits";
}

TEST(Force, RunsSlewBeforeCapAndTheFiniteCheckLast) {
  // A cap below the last force takes hold at once although the slew limit would not allow it.
  ForceOptions options = forcesOn();
  ForceState state = risen(options);
  for (int i = 0; i < 100; ++i) state = force(options, pressedIn(10), state).state;
  EXPECT_NEAR(norm(state.last), 5, 1e-9);
  options.limit_n = 2;
  ForceResult result = force(options, pressedIn(10), state);
  EXPECT_NEAR(norm(result.force), 2, 1e-12);
  // A cap that is no number lets nothing through.
  options.limit_n = kNan;
  result = force(options, pressedIn(10), state);
  EXPECT_EQ(result.force, DeviceN{});
  EXPECT_TRUE(result.limited);
}

TEST(Force, FadesWithStalePositionsAndIsZeroAtTwentyMilliseconds) {
  const ForceOptions options = forcesOn();
  ForceState state = risen(options);
  for (int i = 0; i < 100; ++i) state = force(options, pressedIn(10), state).state;
  ForceInput input = pressedIn(10);
  double last = norm(state.last);
  for (int ms = 0; ms <= 30; ++ms) {
    input.age_s = 0.001 * ms;
    const ForceResult result = force(options, input, state);
    state = result.state;
    EXPECT_LE(norm(result.force), last + 1e-12) << ms;
    last = norm(result.force);
    if (ms <= 10) {
      EXPECT_NEAR(last, 5, 1e-9) << ms;
    }
    if (ms >= 20) {
      EXPECT_EQ(last, 0) << ms;
    }
  }
}

TEST(Force, IsZeroAtOnceOnAFaultAndComesOnGentlyAgain) {
  const ForceOptions options = forcesOn();
  ForceState state = risen(options);
  for (int i = 0; i < 100; ++i) state = force(options, pressedIn(10), state).state;
  ForceInput input = pressedIn(10);
  input.fault = true;
  ForceResult result = force(options, input, state);
  EXPECT_EQ(result.force, DeviceN{});
  result = force(options, pressedIn(10), result.state);
  EXPECT_EQ(result.state.phase, EngagePhase::waiting);
  EXPECT_EQ(result.force, DeviceN{});
}

TEST(Force, TurnsWhatIsNoNumberIntoZero) {
  const ForceOptions options = forcesOn();
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    ForceState state = risen(options);
    ForceInput input = pressedIn(1);
    input.proxy.x = bad;
    for (int i = 0; i < 50; ++i) {
      const ForceResult result = force(options, input, state);
      ASSERT_TRUE(isFinite(result.force));
      EXPECT_TRUE(result.limited);
      state = result.state;
    }
    EXPECT_EQ(state.last, DeviceN{});
    EXPECT_TRUE(isFinite(force(options, pressedIn(1), state).force)) << "and recovers";
  }
}

TEST(Force, FadesInAnewOnANewSurface) {
  const ForceOptions options = forcesOn();
  ForceState state = refade(risen(options));
  EXPECT_EQ(state.phase, EngagePhase::rising);
  const ForceResult result = force(options, pressedIn(10), state);
  EXPECT_LT(norm(result.force), 0.021);
  EXPECT_EQ(refade(ForceState{}).phase, EngagePhase::off) << "what is off stays off";
}

}  // namespace
}  // namespace relievo
