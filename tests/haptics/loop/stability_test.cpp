// SPDX-License-Identifier: BSD-3-Clause
// The defaults against the stability map of docs/dev/stability.md.
#include "tests/haptics/stability.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace relievo
