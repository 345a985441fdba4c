// SPDX-License-Identifier: BSD-3-Clause
// What motors can show for a moment, and what for good.
#include "haptics/device/link/heat_budget.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// Pushes for so long at 1 kHz. @return what is shown at the end, N
double pushFor(HeatBudget& heat, double newton, double seconds, std::int64_t& now_ns) {
  double shown_n = 0;
  for (int i = 0; i < static_cast<int>(1000 * seconds); ++i) {
    now_ns += kMs;
    shown_n = norm(heat.shown({0, 0, newton}, now_ns));
  }
  return shown_n;
}

TEST(HeatBudget, AMomentIsShownInFullAndForGoodTheContinuousForce) {
  HeatBudget heat({.max_force_n = 6, .continuous_force_n = 2});
  std::int64_t now_ns = kMs;
  EXPECT_EQ(pushFor(heat, 6, 0.5, now_ns), 6);
  EXPECT_LT(pushFor(heat, 6, 5, now_ns), 6);
  EXPECT_NEAR(pushFor(heat, 6, 600, now_ns), 2, 0.05);
  EXPECT_LE(heat.used(), 1);
}

TEST(HeatBudget, TheContinuousForceIsNeverTakenAway) {
  HeatBudget heat({.max_force_n = 6, .continuous_force_n = 2});
  std::int64_t now_ns = kMs;
  EXPECT_EQ(pushFor(heat, 2, 600, now_ns), 2);
}

TEST(HeatBudget, RestCools) {
  HeatBudget heat({.max_force_n = 6, .continuous_force_n = 2});
  std::int64_t now_ns = kMs;
  pushFor(heat, 6, 60, now_ns);
  EXPECT_LT(heat.allowedN(), 3);
  pushFor(heat, 0, 60, now_ns);
  EXPECT_EQ(heat.allowedN(), 6);
}

TEST(HeatBudget, AThermometerSaysMoreThanTheForcesDo) {
  HeatBudget heat({.max_force_n = 6, .continuous_force_n = 2});
  heat.measured(0.4);
  EXPECT_EQ(heat.allowedN(), 6);
  heat.measured(0.75);
  EXPECT_EQ(heat.allowedN(), 4);
  heat.measured(3);
  EXPECT_EQ(heat.allowedN(), 2);
  heat.measured(-1);
  EXPECT_EQ(heat.allowedN(), 6);
}

TEST(HeatBudget, AClockThatStoodStillOrJumpedChangesNothingMuch) {
  HeatBudget heat({.max_force_n = 6, .continuous_force_n = 2});
  heat.shown({6, 0, 0}, 1000 * kMs);
  heat.shown({6, 0, 0}, 900 * kMs);
  EXPECT_EQ(heat.used(), 0);
  heat.shown({6, 0, 0}, 1'000'000'000 * kMs);  // After a sleep of days it counts as a second.
  EXPECT_LT(heat.used(), 0.5);
}

TEST(HeatBudget, WithoutMotorsNothingIsShown) {
  HeatBudget heat;
  EXPECT_EQ(norm(heat.shown({1, 0, 0}, kMs)), 0);
  HeatBudget weak({.max_force_n = 1, .continuous_force_n = 9});
  EXPECT_EQ(norm(weak.shown({2, 0, 0}, kMs)), 1);
}

}  // namespace
}  // namespace relievo
