// SPDX-License-Identifier: BSD-3-Clause
// A hand is believed, however it moves; what no hand can do is not.
#include "haptics/device/falcon/link/pose_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace relievo::falcon {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr double kCountMm = 0.048;

/// Asked for a period before.
PoseGate::When at(std::int64_t came_ns) {
  return {came_ns - kMs, came_ns};
}

double counted(double mm) {
  return kCountMm * std::round(mm / kCountMm);
}

TEST(PoseGate, BelievesAHandThatShakesAndTapsThoughAnswersComeUnevenly) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> late(-0.4e6, 0.4e6);
  PoseGate gate;
  int held = 0;
  for (int ms = 1; ms < 20'000; ++ms) {
    const double t = 1e-3 * ms;
    // Up to 1.5 m/s and 100 m/s^2, and a stop against a wall every second.
    const double x = 25 * std::sin(60 * t), y = std::min(0.0, 30 * std::sin(8 * t));
    held += gate.takes({counted(x), counted(y), counted(10 * t - 100)},
                       at(ms * kMs + static_cast<std::int64_t>(late(random))))
                ? 0
                : 1;
  }
  EXPECT_EQ(held, 0);
}

TEST(PoseGate, HoldsBackWhatARestingHandCannotDoAndBelievesTheNextPlace) {
  PoseGate gate;
  for (int ms = 0; ms < 20; ++ms) ASSERT_TRUE(gate.takes({0, 0, 0}, at(ms * kMs)));
  EXPECT_FALSE(gate.takes({0.7, 0, 0}, at(20 * kMs))) << "fifteen counts";
  EXPECT_FALSE(gate.takes({0, 12, 0}, at(21 * kMs))) << "256 counts";
  EXPECT_EQ(gate.held(), 2);
  EXPECT_TRUE(gate.takes({0.05, 0, 0}, at(22 * kMs)));
  EXPECT_EQ(gate.held(), 0);
}

TEST(PoseGate, NeverBelievesAFarPlaceBeforeTheLineIsAtFault) {
  for (const double far_mm : {7.2, 12.0, -200.0}) {
    PoseGate gate;
    gate.takes({}, at(0));
    gate.takes({}, at(kMs));
    for (int i = 0; i <= PoseGate::kMostHeld; ++i) {
      EXPECT_FALSE(gate.takes({far_mm, 0, 0}, at((2 + i) * kMs))) << i;
    }
  }
}

TEST(PoseGate, ConfirmsASmallTrueJumpWithinMilliseconds) {
  PoseGate gate;
  gate.takes({}, at(0));
  gate.takes({}, at(kMs));
  EXPECT_FALSE(gate.takes({1, 0, 0}, at(2 * kMs)));
  EXPECT_FALSE(gate.takes({1, 0, 0}, at(3 * kMs)));
  EXPECT_TRUE(gate.takes({1, 0, 0}, at(4 * kMs))) << "a hand can go 1 mm in 3 ms";
}

TEST(PoseGate, AnAnswerThatCameLateIsFollowedByAPlaceFarther) {
  PoseGate gate;
  const auto place = [](int ms) { return DeviceMm{1.5 * ms, 0, 0}; };
  for (int ms = 0; ms < 20; ++ms) ASSERT_TRUE(gate.takes(place(ms), at(ms * kMs)));
  // Taken at 20 ms and 8 ms under way; the next one comes at once.
  EXPECT_TRUE(gate.takes(place(20), {19 * kMs, 28 * kMs}));
  EXPECT_TRUE(gate.takes(place(29), at(29 * kMs)));
  EXPECT_TRUE(gate.takes(place(30), at(30 * kMs)));
}

}  // namespace
}  // namespace relievo::falcon
