// SPDX-License-Identifier: BSD-3-Clause
// A simulated hand that gives way is led along a path and stays on it; one that wants something
// else is let go; whatever it does, force and power stay within their limits.
#include "haptics/guide/guide.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/haptics/guide/led_hand.h"

namespace relievo {
namespace {

using test::Led;
using test::LedHand;

constexpr double kArmS = 0.2;       // An arm that gives way.
constexpr double kMostRmsMm = 2;    // From the path.
constexpr double kNoticedS = 0.35;  // Above 1.5 N, until the guide is off.

void expectWithinLimits(const Led& led) {
  EXPECT_EQ(led.audit.violations(), 0U);
  EXPECT_GT(led.audit.guided_ticks, 0U);
  EXPECT_LE(led.largest_n, 2 + 1e-9);
  EXPECT_LE(led.audit.largest_guide_n, 2 + 1e-9);
  EXPECT_LE(led.audit.largest_fed_mw, 80 + 1e-9);
  EXPECT_LE(led.against_s, kNoticedS);
}

struct Shape {
  const char* name;
  std::vector<DeviceMm> corners;
};
std::vector<Shape> shapes() {
  return {{"circle", test::circle(16)}, {"square", test::square(50)}, {"star", test::star()}};
}

TEST(Guide, AHandThatGivesWayIsLedAlongThePath) {
  for (const HandImpedance& grip : kHandPresets) {
    for (const Shape& shape : shapes()) {
      SCOPED_TRACE(std::string(shape.name) + ", " + std::string(grip.name));
      LedHand hand({.hand = grip}, guidePath(shape.corners, true), kArmS);
      const Led led = hand.run(shape.corners[0] + DeviceMm{-4, 3, 2}, 120);
      EXPECT_EQ(led.end, GuideEnd::arrived);
      EXPECT_LE(led.rms_mm, kMostRmsMm);
      EXPECT_LE(led.fastest_mm_per_s, 150);
      expectWithinLimits(led);
      RecordProperty(std::string(shape.name) + "_" + std::string(grip.name),
                     std::to_string(led.rms_mm));
      std::printf("%-7s %-8s rms %.2f mm, worst %.2f mm, %.2f N, %.0f mm/s, %.1f s, %.0f mW\n",
                  shape.name, std::string(grip.name).c_str(), led.rms_mm, led.worst_mm,
                  led.largest_n, led.fastest_mm_per_s, led.seconds, led.audit.largest_fed_mw);
    }
  }
}

TEST(Guide, AnArmThatGivesWaySlowlyIsLedMoreSlowly) {
  LedHand quick({.hand = kHandPresets[1]}, guidePath(test::circle(16), true), kArmS);
  LedHand slow({.hand = kHandPresets[1]}, guidePath(test::circle(16), true), 2 * kArmS);
  const Led led = quick.run({16, 0, 0}, 120), behind = slow.run({16, 0, 0}, 120);
  EXPECT_EQ(behind.end, GuideEnd::arrived);
  EXPECT_LE(behind.rms_mm, kMostRmsMm);
  EXPECT_GT(behind.seconds, led.seconds);
}

TEST(Guide, AHandThatHoldsStillLeads) {
  for (const HandImpedance& grip : kHandPresets) {
    for (const Shape& shape : shapes()) {
      // Held at one place, the light grip (0.05 N/mm) reaches 1.5 N at 30 mm: only there it is no
      // hand that gives way.
      if (grip.name == "light" && std::string_view(shape.name) != "square") continue;
      SCOPED_TRACE(std::string(shape.name) + ", " + std::string(grip.name));
      LedHand hand({.hand = grip}, guidePath(shape.corners, true), kArmS);
      DeviceMm held;
      double stopped_s = -1, off_s = -1;
      hand.each = [&](const HapticSample& sample, double t_s) {
        if (sample.guide == GuidePhase::off && t_s > 1 && off_s < 0) off_s = t_s;
      };
      const Led led = hand.run(shape.corners[0], 60, [&](double t_s, DeviceMm at, DeviceMm aim) {
        if (t_s < 4) return aim + (0.001 / kArmS) * (at - aim);
        if (stopped_s < 0) {
          stopped_s = t_s;
          held = at;
        }
        return held;
      });
      EXPECT_EQ(led.end, GuideEnd::you_lead);
      EXPECT_LE(off_s - stopped_s, 3.5);
      expectWithinLimits(led);
      std::printf("%-7s %-8s lets go %.2f s after it stopped, %.3f s above 1.5 N\n", shape.name,
                  std::string(grip.name).c_str(), off_s - stopped_s, led.against_s);
    }
  }
}

TEST(Guide, AHandThatGoesItsOwnWayLeads) {
  for (const HandImpedance& grip : kHandPresets) {
    SCOPED_TRACE(std::string(grip.name));
    LedHand hand({.hand = grip}, guidePath(test::square(50), true), kArmS);
    const Led led = hand.run({25, 25, 0}, 60, [&](double t_s, DeviceMm at, DeviceMm aim) {
      if (t_s < 4) return aim + (0.001 / kArmS) * (at - aim);
      return aim + DeviceMm{0.02, 0.02, 0};  // Outward, 28 mm/s.
    });
    EXPECT_EQ(led.end, GuideEnd::you_lead);
    expectWithinLimits(led);
  }
}

TEST(Guide, TheForceIsGoneSoonAfterTheHandLeads) {
  LedHand hand({.hand = kHandPresets[2]}, guidePath(test::circle(16), true), kArmS);
  std::vector<double> after;
  double off_s = -1;
  hand.each = [&](const HapticSample& sample, double t_s) {
    if (sample.guide_end == GuideEnd::you_lead && off_s < 0) off_s = t_s;
  };
  hand.run({16, 0, 0}, 60, [&](double, DeviceMm, DeviceMm) { return DeviceMm{16, 0, 0}; });
  ASSERT_GT(off_s, 0);
  // What follows: the hand stays where it is, above the surface.
  hand.each = [&](const HapticSample& sample, double) { after.push_back(norm(sample.force)); };
  hand.run(hand.hand().position() + DeviceMm{0, 0, 5}, 0.1);
  for (std::size_t i = 20; i < after.size(); ++i) EXPECT_EQ(after[i], 0) << i;
}

TEST(Guide, ButtonsFastHandsFaultsAndForcesOffEndIt) {
  const auto endWith = [](const std::function<void(LedHand&, double)>& act) {
    LedHand hand({.hand = kHandPresets[1]}, guidePath(test::square(50), true), kArmS);
    hand.each = [&](const HapticSample&, double t_s) { act(hand, t_s); };
    return hand.run({25, 25, 0}, 20).end;
  };
  const auto after = [](double t_s, double s) { return t_s >= s; };
  EXPECT_EQ(endWith([&](LedHand& h, double t) { h.hand().setButtons(after(t, 3) ? 2 : 0); }),
            GuideEnd::button);
  EXPECT_EQ(endWith([&](LedHand& h, double t) { h.options().force.forces_on = !after(t, 3); }),
            GuideEnd::no_forces);
  EXPECT_EQ(endWith([&](LedHand& h, double t) {
              if (after(t, 3)) h.options().guide.path = 0;
            }),
            GuideEnd::asked);
  EXPECT_EQ(endWith([&](LedHand& h, double t) { h.options().detent.on = after(t, 3); }),
            GuideEnd::asked);
  // A button that was held as it began is no wish against it.
  LedHand held({.hand = kHandPresets[1]}, guidePath(test::square(50), true), kArmS);
  held.hand().setButtons(1);
  EXPECT_EQ(held.run({25, 25, 0}, 60).end, GuideEnd::arrived);
  // Away at 400 mm/s.
  LedHand fast({.hand = kHandPresets[2]}, guidePath(test::square(50), true), kArmS);
  const Led led = fast.run({25, 25, 0}, 20, [](double t_s, DeviceMm at, DeviceMm aim) {
    return t_s < 3 ? aim + (0.001 / kArmS) * (at - aim) : aim + DeviceMm{0, 0, 0.4};
  });
  EXPECT_EQ(led.end, GuideEnd::you_lead);
  EXPECT_LE(led.largest_n, 2 + 1e-9);
}

TEST(Guide, AFaultOfTheDeviceEndsItAtZero) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  GuidePath path = guidePath(test::square(50), true);
  path.id = 7;
  HapticOptions options;
  options.force.forces_on = true;
  options.guide.path = 7;
  HapticCore core;
  HapticSample sample;
  const auto tick = [&](int i, DeviceFault fault) {
    const std::int64_t now = 1'000'000LL * (i + 1);
    sample = core.tick(*space, options, {{25, 20, 0}, 0, now, fault}, now, &path);
  };
  for (int i = 0; i < 2000; ++i) tick(i, DeviceFault::none);
  ASSERT_NE(sample.guide, GuidePhase::off);
  ASSERT_GT(norm(sample.force), 0);
  tick(2000, DeviceFault::disconnected);
  EXPECT_EQ(sample.force, DeviceN{});
  EXPECT_EQ(sample.guide_end, GuideEnd::no_forces);
}

TEST(Guide, AnotherSurfaceEndsItAndARunBeginsOnce) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  const auto other = std::make_unique<HapticSpace>(*space);
  other->scene_id = 5;
  GuidePath path = guidePath(test::square(50), true);
  path.id = 7;
  HapticOptions options;
  options.force.forces_on = true;
  options.guide.path = 7;
  HapticCore core;
  std::int64_t now = 0;
  const auto tick = [&](const HapticSpace& on, const GuidePath* along) {
    now += 1'000'000;
    return core.tick(on, options, {{25, 20, 0}, 0, now, DeviceFault::none}, now, along);
  };
  EXPECT_EQ(tick(*space, nullptr).guide, GuidePhase::off) << "no path is there yet";
  EXPECT_EQ(tick(*space, &path).guide, GuidePhase::approaching);
  EXPECT_EQ(tick(*other, &path).guide_end, GuideEnd::surface);
  EXPECT_EQ(tick(*space, &path).guide, GuidePhase::off) << "it does not begin again by itself";
  options.guide.path = path.id = 8;
  EXPECT_EQ(tick(*space, &path).guide, GuidePhase::approaching);
  EXPECT_EQ(tick(*space, &path).guide_path, 8U);
}

TEST(Guide, StrengthDoesNotChangeHowItLeadsAndZeroIsZero) {
  const auto ledWith = [](double strength) {
    LedHand hand({.hand = kHandPresets[1]}, guidePath(test::square(50), true), kArmS, strength);
    return hand.run({25, 25, 0}, 60);
  };
  const Led weak = ledWith(0.4), full = ledWith(1);
  EXPECT_NEAR(weak.largest_n, full.largest_n, 0.01);
  EXPECT_NEAR(weak.seconds, full.seconds, 0.1);
  LedHand off({.hand = kHandPresets[1]}, guidePath(test::square(50), true), kArmS, 0);
  EXPECT_EQ(off.run({25, 25, 0}, 5).largest_n, 0);
}

TEST(Guide, AtCornersItWaitsAndAllRoundsAreGone) {
  LedHand hand({.hand = kHandPresets[1]}, guidePath(test::square(50), true, 2), kArmS);
  int pauses = 0, paused_ticks = 0;
  GuidePhase before = GuidePhase::off;
  hand.each = [&](const HapticSample& sample, double) {
    const bool pauses_now = sample.guide == GuidePhase::pausing;
    pauses += pauses_now && before != GuidePhase::pausing ? 1 : 0;
    paused_ticks += pauses_now ? 1 : 0;
    before = sample.guide;
  };
  // From the middle of a side: once as the path is joined, then four corners a round.
  EXPECT_EQ(hand.run({25, 0, 0}, 120).end, GuideEnd::arrived);
  EXPECT_EQ(pauses, 1 + 2 * 4);
  EXPECT_NEAR(paused_ticks, pauses * 400, pauses * 2);
}

TEST(Guide, FiftyRandomOutlinesAreFollowedByEveryGrip) {
  double worst_mm = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(8, 36), turn(0, 0.6), rises(-8, 8);
    std::uniform_int_distribution<int> many(4, 12);
    const int count = many(random);
    std::vector<DeviceMm> corners;
    for (int i = 0; i < count; ++i) {
      const double a = 2 * std::numbers::pi * (i + turn(random)) / count, r = radius(random);
      corners.push_back({r * std::cos(a), r * std::sin(a), rises(random)});
    }
    const HandImpedance& grip = kHandPresets.at(seed % kHandPresets.size());
    LedHand hand({.hand = grip}, guidePath(corners, true), kArmS);
    const Led led = hand.run({0, 0, 10}, 200);
    EXPECT_EQ(led.end, GuideEnd::arrived) << grip.name;
    EXPECT_LE(led.rms_mm, kMostRmsMm) << grip.name;
    expectWithinLimits(led);
    worst_mm = std::max(worst_mm, led.rms_mm);
  }
  std::printf("largest rms of 50: %.2f mm\n", worst_mm);
}

TEST(Guide, RandomHandsNeverFeelMoreThanTheLimits) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::normal_distribution<double> step(0, 0.2);
    std::uniform_real_distribution<double> strength(0, 1);
    std::uniform_int_distribution<int> change(0, 999);
    LedHand hand({.hand = kHandPresets.at(seed % 3)}, guidePath(test::star(), true, 3), kArmS,
                 strength(random));
    DeviceMm velocity;
    hand.each = [&](const HapticSample& sample, double) {
      if (change(random) == 0) hand.options().force.forces_on = change(random) > 200;
      if (sample.guide == GuidePhase::off && change(random) < 5) ++hand.options().guide.path;
    };
    for (int part = 0; part < 5; ++part) {
      const Led led = hand.run(
          {20 * step(random), 20 * step(random), 5}, 2, [&](double, DeviceMm, DeviceMm aim) {
            velocity = 0.98 * velocity + DeviceMm{step(random), step(random), step(random)};
            return 0.999 * aim + 0.05 * velocity;
          });
      EXPECT_EQ(led.audit.violations(), 0U);
      EXPECT_LE(led.audit.largest_guide_n, 2 + 1e-9);
    }
  }
}

}  // namespace
}  // namespace relievo
