// SPDX-License-Identifier: BSD-3-Clause
// The proxy and its force against a second evaluator in long double, written from the equations and
// sharing nothing with haptics/ (second_evaluator.h), for every kind of surface that it knows.
#include <gtest/gtest.h>

#include <random>

#include "haptics/proxy/surface.h"
#include "tests/haptics/proxy/truth_scenes.h"

namespace relievo {
namespace {

using test::Real;
using test::TruthScene;

TEST(IndependentTruth, TheSurfaceIsThatOfTheEquationsInsideAndBeyondTheWindow) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2, 82);
  for (const TruthScene& scene : test::truthScenes()) {
    const HapticSpace& space = *scene.space;
    Real worst = 0;
    for (int i = 0; i < 5000; ++i) {
      const double x = place(random), y = place(random);
      const GridPoint g = space.gridFromView({x, y, 0});
      const Real ours = static_cast<Real>(space.mid_mm) +
                        static_cast<Real>(space.cell_mm) * surfaceHeight(space, g.x, g.y);
      worst = std::max(worst, std::abs(ours - scene.height(x, y)));
    }
    EXPECT_LE(worst, 1e-6L) << "mm, " << scene.name;
  }
}

TEST(IndependentTruth, ProxyAndForceAreThoseOfTheTrueSurface) {
  for (const TruthScene& scene : test::truthScenes()) {
    const test::TruthFindings found = test::wanderOver(scene, scene.spline ? 20'000 : 60'000);
    EXPECT_GT(found.contacts, found.ticks / 8) << scene.name;
    EXPECT_LE(found.below_mm, 1e-6L) << "mm of view, " << scene.name;
    EXPECT_LE(found.force_off_n, 1e-6L) << "N, " << scene.name;
    EXPECT_GT(found.judged, found.ticks / 80) << scene.name;
    EXPECT_EQ(found.nearer, 0) << "of " << found.judged << ", " << scene.name;
  }
}

}  // namespace
}  // namespace relievo
