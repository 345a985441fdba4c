// SPDX-License-Identifier: BSD-3-Clause
// Walls, ridges, grooves, pits and fins, one cell wide, against an independent solver in the plane.
#include <gtest/gtest.h>

#include <random>

#include "haptics/proxy/proxy.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/proxy/profiles.h"

namespace relievo {
namespace {

using test::passesFin;

TEST(SharpScenes, AgreeWithTheIndependentSolver) {
  for (const SurfaceKind kind : {SurfaceKind::bilinear, SurfaceKind::crease_aware}) {
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
  // What breaking at creases is for; also shows that the test above can fail.
  const test::Agreement found =
      test::compareWithTruth(test::sharpProfiles()[3], SurfaceKind::spline, 6000);
  EXPECT_GT(found.bad, 0.1 * found.ticks) << "pit";
  EXPECT_GT(found.events, 0);
}

TEST(SharpScenes, RandomTownsAndRampsHaveNoEvents) {
  int bad = 0, ticks = 0;
  for (int seed = 0; seed < 12; ++seed) {
    const test::Profile scene = test::randomProfile(seed);
    const test::Agreement found = test::compareWithTruth(scene, SurfaceKind::crease_aware, 3000);
    EXPECT_EQ(found.events, 0) << "seed " << seed;
    bad += found.bad;
    ticks += found.ticks;
  }
  EXPECT_GT(ticks, 10000);
  EXPECT_LE(bad, 0.001 * ticks);
}

TEST(SharpScenes, FaintEdgesBetweenOthersAreEdges) {
  // Bends of 0.28, 0.19 and 0.02 with one straight cell to the next crease.
  for (const int seed : {61, 80, 100, 102, 136}) {
    const test::Agreement found =
        test::compareWithTruth(test::randomProfile(seed), SurfaceKind::crease_aware, 5000);
    EXPECT_EQ(found.events, 0) << "seed " << seed;
    EXPECT_EQ(found.bad, 0) << "seed " << seed;
  }
}

TEST(SharpScenes, AThinFinIsNeverPassedAtAnySpeed) {
  for (const double base_mm : {0.03, 0.0625, 0.125, 0.25, 1.0}) {
    for (const double speed_mm_per_s : {20.0, 100.0, 500.0, 2000.0, 10000.0}) {
      for (const SurfaceKind surface :
           {SurfaceKind::bilinear, SurfaceKind::crease_aware, SurfaceKind::spline}) {
        EXPECT_FALSE(passesFin(base_mm, speed_mm_per_s, ProxyKind::converged, surface))
            << base_mm << " mm at " << speed_mm_per_s << " mm/s";
      }
    }
  }
}

/// Waves with blocks, pits, a fin and spikes on them.
double town(double x, double y) {
  const int col = static_cast<int>(x / 7), row = static_cast<int>(y / 6),
            kind = (5 * col + row) % 9;
  double z = 1.5 * std::sin(0.5 * x) + 1.2 * std::cos(0.43 * y + 0.2 * x);
  if (kind % 3 == 0) z += 3;
  if (kind == 4) z -= 4;
  if (std::abs(y - 40.2) < 0.3) z += 6;
  if (kind == 2 && std::abs(x - 7 * col - 3) < 0.25 && std::abs(y - 6 * row - 3) < 0.25) z += 4;
  return z;
}

TEST(SharpScenes, AJumpingHandEndsWhereOneEndsThatGoesThere) {
  const auto space = test::spaceOf(80, town, 1, {}, SurfaceKind::crease_aware);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> turn(-3.14, 3.14), deep(-14, 3);
  GridPoint hand{100, 100, 30};
  ProxyState state = proxyPlace(*space, hand);
  int jumps = 0, elsewhere = 0;
  for (int i = 0; i < 3000; ++i) {
    const double way = turn(random), far = 10 + 14 * (i % 7);
    GridPoint to = hand + GridPoint{far * std::cos(way), far * std::sin(way), 0};
    to = {std::clamp(to.x, 5.0, 194.0), std::clamp(to.y, 5.0, 194.0), deep(random)};
    if (i % 5 == 4) to = {100, 100, 30};  // Lets go.
    const ProxyState jumped = proxyTick(*space, state, to, {});
    const int steps = static_cast<int>(std::ceil(norm(to - hand) / 0.1));
    for (int k = 1; k <= steps; ++k) {
      const double part = static_cast<double>(k) / steps;
      state = proxyTick(*space, state, hand + part * (to - hand), {});
    }
    const bool same =
        norm(jumped.position - state.position) < 0.01 && jumped.contact == state.contact;
    elsewhere += same ? 0 : 1;
    ++jumps;
    hand = to;
  }
  // Beside a ridge both are right. Steps of two cells everywhere make 0.33 %, of ten 1.3 %.
  EXPECT_LE(elsewhere, 0.003 * jumps);
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
