// SPDX-License-Identifier: BSD-3-Clause
// Walls, ridges, grooves, pits and fins, one cell wide, against an independent solver in the plane.
#include <gtest/gtest.h>

#include "haptics/proxy/proxy.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/proxy/profiles.h"

namespace relievo {
namespace {

using test::passesFin;

TEST(SharpScenes, AgreeWithTheIndependentSolver) {
  for (const SurfaceKind kind : {SurfaceKind::bilinear, SurfaceKind::gated}) {
    for (const test::Profile& scene : test::sharpProfiles()) {
      const test::Agreement found = test::compareWithTruth(scene, kind, 12000);
      EXPECT_GT(found.ticks, 3000) << scene.name;
      EXPECT_EQ(found.events, 0) << scene.name;
      EXPECT_LE(found.bad, scene.bad_share * found.ticks) << scene.name << " of " << found.ticks;
      EXPECT_LT(found.farthest_mm, 1e-4) << scene.name << ": mm from the truth where they agree";
    }
  }
}

TEST(SharpScenes, TheSplineAloneDoesNotAgree) {
  // What the gate is for; also shows that the test above can fail.
  const test::Agreement found =
      test::compareWithTruth(test::sharpProfiles()[3], SurfaceKind::spline, 6000);
  EXPECT_GT(found.bad, 0.1 * found.ticks) << "pit";
  EXPECT_GT(found.events, 0);
}

TEST(SharpScenes, RandomTownsAndRampsHaveNoEvents) {
  int bad = 0, ticks = 0;
  for (int seed = 0; seed < 12; ++seed) {
    const test::Profile scene = test::randomProfile(seed);
    const test::Agreement found = test::compareWithTruth(scene, SurfaceKind::gated, 3000);
    EXPECT_EQ(found.events, 0) << "seed " << seed;
    bad += found.bad;
    ticks += found.ticks;
  }
  EXPECT_GT(ticks, 10000);
  EXPECT_LE(bad, 0.001 * ticks);
}

TEST(SharpScenes, AThinFinIsNeverPassedAtAnySpeed) {
  for (const double base_mm : {0.03, 0.0625, 0.125, 0.25, 1.0}) {
    for (const double speed_mm_per_s : {20.0, 100.0, 500.0, 2000.0, 10000.0}) {
      for (const SurfaceKind surface :
           {SurfaceKind::bilinear, SurfaceKind::gated, SurfaceKind::spline}) {
        EXPECT_FALSE(passesFin(base_mm, speed_mm_per_s, ProxyKind::converged, surface))
            << base_mm << " mm at " << speed_mm_per_s << " mm/s";
      }
    }
  }
}

TEST(SharpScenes, ThePapersEquationPassesAThinFin) {
  // What the converged solver is for; also shows that the test above can fail.
  int passes = 0;
  for (const double speed_mm_per_s : {20.0, 100.0, 500.0, 2000.0, 10000.0}) {
    passes += passesFin(0.03, speed_mm_per_s, ProxyKind::equation) ? 1 : 0;
  }
  EXPECT_GT(passes, 0);
}

}  // namespace
}  // namespace relievo
