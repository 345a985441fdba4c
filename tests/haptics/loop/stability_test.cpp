// SPDX-License-Identifier: BSD-3-Clause
// The defaults against the stability map of docs/dev/stability.md.
#include "tests/haptics/stability.h"

#include <gtest/gtest.h>

#include "haptics/loop/surface_preset.h"

namespace relievo {
namespace {

TEST(Stability, TheDefaultOfEveryLevelIsStableForEveryGripWithAMargin) {
  for (const test::StabilityScene& scene : test::stabilityScenes()) {
    for (int detail = 1; detail <= 4; ++detail) {
      if (scene.detail != 0 && scene.detail != detail) continue;
      for (const HandImpedance& grip : kHandPresets) {
        for (const double push : {0.5, 4.0}) {
          const double k = stiffnessForDetail(detail);
          EXPECT_LT(test::swingAtRest(*scene.space, grip, {k, push, -20.3, true}), test::kStillN)
              << scene.name << " of Detail " << detail << ", " << grip.name << " grip";
          EXPECT_LT(test::swingAtRest(*scene.space, grip, {k / 0.75, push, -20.3, true}),
                    test::kStillN)
              << "margin: " << scene.name << " of Detail " << detail << ", " << grip.name;
        }
      }
    }
  }
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
  EXPECT_GT(test::swingAtRest(*scenes[0].space, light, {1, 2, -20.3, false}), 1) << "unstable";
  EXPECT_LT(test::swingAtRest(*scenes[0].space, light, {1, 2, -20.3, true}), test::kStillN);
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
