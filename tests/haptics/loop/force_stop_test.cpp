// SPDX-License-Identifier: BSD-3-Clause
// The stop that needs no window: a held button, and a window that says nothing.
#include "haptics/loop/force_stop.h"

#include <gtest/gtest.h>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::uint32_t kCentre = 1U << 2U, kPlus = 1U;

ForceOptions on() {
  ForceOptions options;
  options.forces_on = true;
  options.strength = 0.6;
  return options;
}

/// Ticks from `from_ms` on until the forces are off; -1: they never are.
int msUntilOff(ForceStop& stop, const ForceStopOptions& options, std::uint32_t buttons,
               int from_ms) {
  for (int ms = 0; ms < 5000; ++ms) {
    if (!stop.applied(on(), options, buttons, (from_ms + ms) * kMs).forces_on) return ms;
  }
  return -1;
}

TEST(ForceStop, ACentreHeldForOneAndAHalfSecondsStopsAndLatches) {
  ForceStop stop;
  EXPECT_EQ(msUntilOff(stop, {}, 0, 0), -1);
  EXPECT_EQ(msUntilOff(stop, {}, kPlus, 10'000), -1) << "another button";
  EXPECT_TRUE(stop.applied(on(), {}, kCentre, 20'000 * kMs).forces_on);
  EXPECT_TRUE(stop.applied(on(), {}, 0, 21'499 * kMs).forces_on) << "let go in time";
  EXPECT_EQ(msUntilOff(stop, {}, kCentre, 30'000), 1500);
  EXPECT_EQ(stop.reason(), StopReason::held);
  EXPECT_EQ(msUntilOff(stop, {}, 0, 40'000), 0) << "released, it stays";
  ForceOptions off = on();
  off.forces_on = false;
  stop.applied(off, {}, 0, 50'000 * kMs);
  EXPECT_EQ(stop.reason(), StopReason::none);
  EXPECT_EQ(msUntilOff(stop, {}, 0, 60'000), -1) << "asked for anew";
}

TEST(ForceStop, ThePressThatSwitchesForcesOnDoesNotStopThem) {
  ForceStop stop;
  ForceOptions off = on();
  off.forces_on = false;
  for (int ms = 0; ms < 1500; ++ms) stop.applied(off, {}, kCentre, ms * kMs);
  EXPECT_EQ(msUntilOff(stop, {}, kCentre, 1500), -1);
  stop.applied(on(), {}, 0, 7000 * kMs);
  EXPECT_EQ(msUntilOff(stop, {}, kCentre, 8000), 1500);
}

TEST(ForceStop, WithOneButtonAnyOfThemStops) {
  ForceStop stop;
  ForceStopOptions any;
  any.buttons = 0b1111;
  EXPECT_EQ(msUntilOff(stop, any, kPlus, 0), 1500);
}

TEST(ForceStop, ForASilentWindowForcesFadeOutAndStayOffThoughItComesBack) {
  ForceStop stop;
  ForceStopOptions silent;
  silent.window_silent = true;
  double before = on().strength;
  for (int ms = 0; ms < 500; ++ms) {
    // It says something after 100 ms; what has begun goes on.
    const ForceOptions now =
        stop.applied(on(), ms < 100 ? silent : ForceStopOptions{}, 0, ms * kMs);
    ASSERT_TRUE(now.forces_on) << ms;
    ASSERT_LE(now.strength, before);
    ASSERT_GT(now.strength, before - 0.002);
    before = now.strength;
  }
  EXPECT_EQ(msUntilOff(stop, {}, 0, 500), 0);
  EXPECT_EQ(stop.reason(), StopReason::window_silent);
}

/// A hand that presses, through the whole core.
TEST(ForceStop, EndsTheForceOfAPressingHandInTheTickOrWithinItsSlew) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  for (const bool held : {true, false}) {
    HapticOptions options;
    options.force = on();
    HapticCore core;
    DeviceN before;
    int zero_ms = -1;
    for (int ms = 0; ms < 8000; ++ms) {
      DeviceReading reading;
      reading.time_ns = ms * kMs;
      reading.position = {0, 0, ms < 2000 ? 5.0 : -5.0};
      reading.buttons = held && ms >= 4000 ? kCentre : 0;
      options.stop.window_silent = !held && ms >= 4000;
      const HapticSample s = core.tick(*space, options, reading, reading.time_ns);
      if (ms == 4000) {
        EXPECT_NEAR(norm(s.force), 2.4, 1e-9);
      }
      // Off is off at once; a fade is no jump.
      if (!held) {
        ASSERT_LE(norm(s.force - before), 0.2 + 1e-9);
      }
      if (ms > 4000 && zero_ms < 0 && s.force == DeviceN{}) zero_ms = ms;
      before = s.force;
    }
    EXPECT_EQ(zero_ms, held ? 5500 : 4500);
    EXPECT_EQ(before, DeviceN{});
    EXPECT_EQ(core.audit().violations(), 0U);
  }
}

}  // namespace
}  // namespace relievo
