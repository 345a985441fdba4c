// SPDX-License-Identifier: BSD-3-Clause
// Rays onto the surface: against closed forms, against dense sampling, block walk against cell
// walk.
#include "haptics/proxy/first_hit.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "haptics/proxy/crossing.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using test::spaceOf;

double rough(double x, double y) {
  return 3 * std::sin(0.31 * x) * std::cos(0.27 * y) + std::sin(1.9 * x + y) +
         (x > 40 && x < 47 ? 5 : 0);
}

constexpr std::array<SurfaceKind, 3> kKinds{SurfaceKind::crease_aware, SurfaceKind::spline,
                                            SurfaceKind::bilinear};

TEST(FirstHit, MeetsAPlaneWhereThePlaneIs) {
  for (const SurfaceKind kind : kKinds) {
    const auto space = spaceOf(
        200, [](double x, double y) { return 0.25 * x - 0.5 * y; }, 1, {}, kind);
    const auto above = [&](GridPoint p) { return p.z - surfaceHeight(*space, p.x, p.y); };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(2, 197), lift(0.5, 40);
    for (int i = 0; i < 500; ++i) {
      GridPoint from{place(random), place(random), 0}, to{place(random), place(random), 0};
      from.z = surfaceHeight(*space, from.x, from.y) + lift(random);
      to.z = surfaceHeight(*space, to.x, to.y) - lift(random);
      const double part = above(from) / (above(from) - above(to));
      const Hit hit = firstHit(*space, from, to);
      ASSERT_TRUE(hit.found);
      EXPECT_NEAR(norm(hit.point - (from + part * (to - from))), 0, 1e-4);
      EXPECT_NEAR(above(hit.point), 0, 1e-12);
      EXPECT_FALSE(firstHit(*space, from, {to.x, to.y, to.z + 200}).found);
    }
  }
}

TEST(FirstHit, FindsTheFirstPlaceBelowTheSurface) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-20, 220), low(-15, 10), high(16, 40);
  for (const SurfaceKind kind : kKinds) {
    const auto space = spaceOf(80, rough, 1, {}, kind);
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
      const GridPoint from{place(random), place(random), high(random)};
      const GridPoint to{place(random), place(random), low(random)};
      const Hit hit = firstHit(*space, from, to);
      hits += hit.found ? 1 : 0;
      const double length = norm(to - from);
      const double reached = hit.found ? norm(hit.point - from) / length : 1;
      constexpr int kSamples = 3000;
      for (int k = 0; k < kSamples; ++k) {
        const double t = reached * k / kSamples;
        const GridPoint p = from + t * (to - from);
        ASSERT_GE(p.z - surfaceHeight(*space, p.x, p.y), -1e-9) << "before the hit, ray " << i;
      }
      if (!hit.found || reached > 1 - 1e-6) continue;
      const GridPoint behind = from + (reached + 1e-7) * (to - from);
      EXPECT_LT(behind.z, surfaceHeight(*space, behind.x, behind.y) + 1e-9);
    }
    EXPECT_GT(hits, 200);
  }
}

TEST(FirstHit, PassingBlocksChangesNoBit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-5, 205), height(-12, 30);
  std::uniform_int_distribution<int> node(0, 199);
  for (const SurfaceKind kind : kKinds) {
    const auto space = spaceOf(80, rough, 1, {}, kind);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
      GridPoint from{place(random), place(random), 0};
      GridPoint to{place(random), place(random), height(random)};
      if (i % 3 == 0) {  // Through corners of cells, where two lines are crossed at once.
        const int x = node(random), y = node(random), run = node(random) - 100;
        from = {static_cast<double>(x), static_cast<double>(y), 0};
        to = {static_cast<double>(x + run), static_cast<double>(y + run), height(random)};
      }
      from.z = surfaceHeight(*space, from.x, from.y) + std::abs(height(random));
      const Hit slow = firstHit(*space, from, to, RayWalk::cells);
      const Hit fast = firstHit(*space, from, to, RayWalk::blocks);
      ASSERT_EQ(slow.found, fast.found) << i;
      ASSERT_EQ(slow.point, fast.point) << i;
      hits += slow.found ? 1 : 0;
    }
    EXPECT_GT(hits, 5000);
    EXPECT_LT(hits, 19000);
  }
}

TEST(FirstHit, LeavesASurfaceItStartsOn) {
  for (const SurfaceKind kind : kKinds) {
    const auto space = spaceOf(80, rough, 1, {}, kind);
    for (int i = 0; i < 190; ++i) {
      const double x = 3.3 + i, y = 5.1 + 0.9 * i;
      const GridPoint on{x, y, surfaceHeight(*space, x, y)};
      EXPECT_FALSE(firstHit(*space, on, {x, y, on.z + 20}).found);
      const Hit down = firstHit(*space, on, {x, y, on.z - 3});
      ASSERT_TRUE(down.found);
      EXPECT_NEAR(norm(down.point - on), 0, 1e-12);
    }
  }
}

TEST(Crossing, FindsTheFirstOfSeveralRoots) {
  // (s - a)(s - b)(s - c) and higher, falling first at a.
  const auto withRoots = [](std::array<double, 6> roots, double sign) {
    Sextic p{sign, 0, 0, 0, 0, 0, 0};
    for (std::size_t n = 0; n < roots.size(); ++n) {
      for (std::size_t k = n + 1; k > 0; --k) p[k] = p[k - 1] - roots[n] * p[k];
      p[0] *= -roots[n];
    }
    return p;
  };
  EXPECT_NEAR(firstBelowZero(withRoots({0.2, 0.4, 0.6, 0.7, 0.8, 0.9}, 1)), 0.2, 1e-9);
  EXPECT_NEAR(firstBelowZero(withRoots({0.95, 1.2, 2, -1, -2, -3}, -1)), 0.95, 1e-12);
  EXPECT_EQ(firstBelowZero(withRoots({0.5, 0.5, -1, -2, -3, -4}, 1)), kNever) << "touches only";
  EXPECT_EQ(firstBelowZero(withRoots({1.5, 2, 3, 4, 5, 6}, 1)), kNever);
  EXPECT_NEAR(firstBelowZero({0, -1, 0, 0, 0, 0, 0}), 0, 1e-15);
}

}  // namespace
}  // namespace relievo
