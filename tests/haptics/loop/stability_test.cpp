// SPDX-License-Identifier: BSD-3-Clause
// The defaults against the stability map of docs/dev/stability.md.
#include "tests/haptics/stability.h"

#include <gtest/gtest.h>

#include "haptics/device_catalog.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/stable_stiffness.h"
#include "haptics/loop/surface_preset.h"

namespace relievo {
namespace {

/// On the virtual hand, and with the delay and the counts that the Falcon's driver declares.
TEST(Stability, TheDefaultOfEveryLevelIsStableForEveryGripAndDeviceWithAMargin) {
  for (const test::StabilityScene& scene : test::stabilityScenes()) {
    for (int detail = 1; detail <= 4; ++detail) {
      if (scene.detail != 0 && scene.detail != detail) continue;
      for (const HandImpedance& grip : kHandPresets) {
        for (const VirtualHandOptions& device : {VirtualHandOptions{}, test::likeTheFalcon()}) {
          for (const double push : {0.5, 4.0}) {
            for (const double margin : {1.0, 0.75}) {
              const double k = stiffnessForDetail(detail, VirtualHand(device).info()) / margin;
              const test::StabilityTry what{k, push, -20.3, true, {}, 0, device};
              EXPECT_LT(test::swingAtRest(*scene.space, grip, what), test::kStillN)
                  << scene.name << " of Detail " << detail << ", " << grip.name << " grip, delay "
                  << device.delay_ticks << ", at " << margin;
            }
          }
        }
      }
    }
  }
}

/// A device that is worse than those of the map in each respect has defaults of its own.
TEST(Stability, OnASlowerLaterAndCoarserDeviceTheDefaultsAreSofterAndHaveTheMarginAsWell) {
  struct Worse {
    const char* name;
    double rate_hz;
    int delay_ticks;
    double position_step_mm;
  };
  for (const Worse& worse :
       {Worse{"half the rate", 500, 1, 0.048}, Worse{"half the rate and later", 500, 2, 0.048},
        Worse{"coarse", 1000, 1, 0.25}}) {
    DeviceInfo info;
    info.max_force_n = 5;
    info.rate_hz = worse.rate_hz;
    info.force_delay_ticks = worse.delay_ticks;
    info.position_step_mm = worse.position_step_mm;
    VirtualHandOptions like;
    like.delay_ticks = worse.delay_ticks;
    like.position_step_mm = worse.position_step_mm;
    for (const int detail : {1, 2}) {
      const double k = stiffnessForDetail(detail, info);
      EXPECT_LT(k, stiffnessForDetail(detail)) << worse.name;
      EXPECT_GT(k, 0.05) << worse.name;
      EXPECT_EQ(withinDevice(HapticOptions{}, info).detail_stiffness[0], k) << "the loop's own";
      for (const test::StabilityScene& scene : test::stabilityScenes()) {
        if (scene.detail != 0 && scene.detail != detail) continue;
        for (const HandImpedance& grip : kHandPresets) {
          const test::StabilityTry what{k / kStabilityMargin, 2, -20.3, true, {}, 0, like,
                                        worse.rate_hz};
          EXPECT_LT(test::swingAtRest(*scene.space, grip, what), test::kStillN)
              << worse.name << ", " << scene.name << " of Detail " << detail << ", " << grip.name;
        }
      }
    }
  }
}

/// What the driver tells the passivity stage is what the map was made for.
TEST(Stability, TheFalconsMapHasTheDelayAndTheCountThatItsDriverDeclares) {
  const DeviceInfo declared = makeDevice("falcon")->info();
  const VirtualHandOptions like = test::likeTheFalcon();
  EXPECT_EQ(declared.force_delay_ticks, like.delay_ticks);
  EXPECT_EQ(declared.position_step_mm, like.position_step_mm);
}

TEST(Stability, WhereTextureIsFeltTheDefaultNeedsNoPassivityStage) {
  for (const test::StabilityScene& scene : test::stabilityScenes()) {
    if (scene.detail < 3) continue;
    const double k = stiffnessForDetail(scene.detail);
    for (const HandImpedance& grip : kHandPresets) {
      EXPECT_LT(test::swingAtRest(*scene.space, grip, {k, 2, -20.3, false}), test::kStillN)
          << scene.detail << ", " << grip.name;
    }
  }
}

TEST(Stability, ACellOfTheMapNeedsTheStage) {
  const auto scenes = test::stabilityScenes();
  const HandImpedance& light = kHandPresets[0];
  EXPECT_GT(test::swingAtRest(*scenes[0].space, light, {1.2, 2, -20.3, false}), 1) << "unstable";
  EXPECT_LT(test::swingAtRest(*scenes[0].space, light, {1.2, 2, -20.3, true}), test::kStillN);
}

TEST(Stability, EverySurfacePresetIsStableForEveryGrip) {
  for (const SurfacePreset& preset : kSurfacePresets) {
    const SurfaceFeel& feel = preset.feel;
    if (feel.stiffness_by_detail) continue;  // As the default of the level.
    // Eq. (2) never rests nearer than its step: what the hand feels swings by that step's force.
    const bool steps = feel.proxy != ProxyKind::converged;
    const double step_n = steps ? feel.stiffness_n_per_mm * ProxyOptions{}.step_mm : 0;
    for (const test::StabilityScene& scene : test::stabilityScenes()) {
      for (const HandImpedance& grip : kHandPresets) {
        for (const double push : {0.5, 4.0}) {
          EXPECT_LT(test::swingAtRest(*scene.space, grip,
                                      {feel.stiffness_n_per_mm, push, -20.3, true,
                                       proxyOptions(feel), feel.damping_n_s_per_mm}),
                    test::kStillN + step_n)
              << preset.id << ": " << scene.name << " of Detail " << scene.detail << ", "
              << grip.name << " grip, " << push << " N";
        }
      }
    }
  }
}

}  // namespace
}  // namespace relievo
