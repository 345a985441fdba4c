// SPDX-License-Identifier: BSD-3-Clause
// Whatever is set while the hand presses, the force follows as slowly as it may.
#include "haptics/loop/settings_blend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/loop/haptic_core.h"
#include "haptics/loop/surface_preset.h"
#include "haptics/proxy/texture.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr double kMostStepN = 0.005;

HapticOptions withFeel(const SurfaceFeel& feel, double strength) {
  HapticOptions options;
  setFeel(options, feel);
  options.force.strength = strength;
  options.force.forces_on = true;
  options.force.oscillation.on = false;
  return options;
}

/// Presses on hills that are nowhere measured, with texture, at full rise.
class Pressed : public ::testing::Test {
 protected:
  Pressed() {
    RegionWindow window = test::windowOf(
        80, [](double x, double y) { return 1.5 * std::sin(0.35 * x) * std::cos(0.3 * y); });
    window.origins.assign(kWindowCount, CellStatus::interpolated);
    fill(*space_, window, {1, 3}, SurfaceKind::crease_aware);
    std::vector<float> finer(4 * kWindowCount);
    for (std::size_t i = 0; i < finer.size(); ++i) {
      finer[i] = static_cast<float>(0.01 * std::sin(0.7 * static_cast<double>(i)));
    }
    fillTexture(*space_, finer);
  }
  HapticSample tick(const HapticOptions& options, DeviceMm hand) {
    DeviceReading reading;
    reading.position = hand;
    reading.time_ns = now_ns_ += 1'000'000;
    return core_.tick(*space_, options, reading, reading.time_ns);
  }
  HapticSample press(const HapticOptions& options) {
    for (int i = 0; i < 1200; ++i) tick(options, {kPlace.x, kPlace.y, 12});
    HapticSample last;
    for (int i = 0; i < 2000; ++i) {
      last = tick(options, {kPlace.x, kPlace.y, std::max(kPlace.z, 12 - 0.02 * i)});
    }
    return last;
  }

  static constexpr DeviceMm kPlace{3, -4, -2.5};
  std::unique_ptr<HapticSpace> space_ = std::make_unique<HapticSpace>();
  HapticCore core_;
  std::int64_t now_ns_ = 0;
};

TEST_F(Pressed, EveryPresetAndEverySettingComesGradually) {
  std::vector<HapticOptions> all;
  for (const char* id : {"smooth", "soft_stone", "bronze", "exact", "soft_stone"}) {
    all.push_back(withFeel(surfacePreset(id)->feel, 0.6));
  }
  for (const double strength : {0.1, 1.0}) {
    all.push_back(withFeel(surfacePreset("bronze")->feel, strength));
  }
  SurfaceFeel feel = surfacePreset("smooth")->feel;
  for (const double k : {1.5, 0.05, 0.8}) {
    feel.stiffness_by_detail = false;
    feel.stiffness_n_per_mm = k;
    all.push_back(withFeel(feel, 1));
  }
  feel.fields = {.softest_part = 0.25, .texture_mm = 0.1};
  all.push_back(withFeel(feel, 1));
  DeviceN last = press(all.front()).force;
  for (std::size_t i = 1; i < all.size(); ++i) {
    double moved = 0;
    const DeviceN before = last;
    for (int n = 0; n < 4000; ++n) {
      const DeviceN now = tick(all[i], kPlace).force;
      ASSERT_LE(norm(now - last), kMostStepN) << "change " << i << ", tick " << n;
      last = now;
      moved = std::max(moved, norm(now - before));
    }
    if (i != 3 && i != 4) {
      EXPECT_GT(moved, 2 * kMostStepN) << "change " << i << " is felt";
    }
  }
  EXPECT_EQ(core_.audit().violations(), 0U);
}

TEST_F(Pressed, WhatHasComeIsWhatWasAskedFor) {
  const HapticOptions soft = withFeel(surfacePreset("smooth")->feel, 0.3);
  const HapticOptions firm = withFeel(surfacePreset("exact")->feel, 1);
  press(soft);
  HapticSample changed;
  for (int n = 0; n < 3000; ++n) changed = tick(firm, kPlace);
  EXPECT_EQ(changed.stiffness_n_per_mm, 0.8);
  EXPECT_NEAR(norm(changed.force), 0.8 * norm(changed.proxy - changed.hip), 1e-9);
}

/// Each setting alone, by what it can do to the force of a hand 3 mm deep at 20 mm/s.
TEST(SettingsBlend, EachSettingGoesOnlySoFarInATickAsItsForceMay) {
  const FeltNow now{.depth_mm = 3, .speed_mm_per_s = 20, .rise = 1};
  const FeltSettings from{.strength = 1, .fields = {.softest_part = 1}};
  const double pressed_n = 0.8 * 3;
  const auto step = [&](FeltSettings to) {
    SettingsBlend blend;
    blend.toward(from, now, false);
    return blend.toward(to, now, false);
  };
  FeltSettings to = from;
  to.static_friction = to.dynamic_friction = 0.6;
  EXPECT_LE(step(to).static_friction * pressed_n, SettingsBlend::kMostStepN + 1e-12);
  to = from;
  to.fields.softest_part = 0.25;
  EXPECT_LE((1 - step(to).fields.softest_part) * pressed_n, SettingsBlend::kMostStepN + 1e-12);
  to = from;
  to.damping_n_s_per_mm = 0.002;
  EXPECT_LE(step(to).damping_n_s_per_mm * 20, SettingsBlend::kMostStepN + 1e-12);
  to = from;
  to.strength = 0.5;
  EXPECT_LE((1 - step(to).strength) * pressed_n, SettingsBlend::kMostStepN + 1e-12);
  to = from;
  to.stiffness_n_per_mm = {0.3, 0.3, 0.3, 0.3};
  EXPECT_LE((0.8 - step(to).stiffness_n_per_mm[0]) * 3, SettingsBlend::kMostStepN + 1e-12);
}

TEST_F(Pressed, AFreeHandAndStrengthZeroDoNotWait) {
  const HapticOptions weak = withFeel(surfacePreset("exact")->feel, 0.2);
  press(weak);
  HapticOptions off = weak;
  off.force.strength = 0;
  EXPECT_EQ(tick(off, kPlace).force, DeviceN{});
  SettingsBlend blend;
  const FeltNow free{.rise = 1};
  FeltSettings settings;
  blend.toward(settings, free, false);
  settings.stiffness_n_per_mm = {0.1, 0.1, 0.1, 0.1};
  settings.strength = 1;
  EXPECT_EQ(blend.toward(settings, free, false), settings);
  settings.fields.magnet_n = 1;
  EXPECT_NEAR(blend.toward(settings, free, false).fields.magnet_n, SettingsBlend::kMostStepN, 1e-9);
  const FeltNow off_now{.depth_mm = 3, .rise = 0};
  EXPECT_EQ(blend.toward(settings, off_now, false), settings) << "nothing is felt";
}

}  // namespace
}  // namespace relievo
