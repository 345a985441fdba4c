// SPDX-License-Identifier: BSD-3-Clause
// Force and proxy on relief that is known in closed form, beside bars for the smooth surfaces.
#include <gtest/gtest.h>

#include <random>

#include "tests/haptics/proxy/measure.h"

namespace relievo {
namespace {

using test::Accuracy;
using test::Relief;

struct Bar {
  double amplitude_mm, length_mm;
  double angle_deg, position_um, step_ratio;
};
// 20, 8 and 4 samples per wave; the last two steps are what the curvature of an interpolating cubic
// spline gives at a top: 5 % too much at 8 samples.
constexpr std::array<Bar, 4> kBars{{{2, 40, 0.001, 0.05, 1.001},
                                    {1, 10, 0.03, 1, 1.02},
                                    {0.25, 4, 0.4, 8, 1.07},
                                    {0.05, 2, 0.8, 15, 1.4}}};

TEST(SmoothRelief, ForceAndProxyAreTheClosedFormsOnTheSplineWithAndWithoutCreases) {
  for (const Bar& bar : kBars) {
    const Relief relief = test::waves(bar.amplitude_mm, bar.length_mm);
    for (const SurfaceKind kind : {SurfaceKind::crease_aware, SurfaceKind::spline}) {
      const auto space = test::spaceOf(relief, 100, kind);
      const Accuracy a = test::slideOver(*space, relief, {}, {});
      EXPECT_LE(a.angle_max, bar.angle_deg) << relief.name;
      EXPECT_LE(a.position_max_um, bar.position_um) << relief.name;
      EXPECT_LE(a.step, bar.step_ratio * a.true_step) << relief.name;
      EXPECT_EQ(a.bad_percent, 0);
    }
  }
}

TEST(SmoothRelief, BilinearFacetsAreFarFromTheClosedForm) {
  // Shows that the test above can fail, and why the spline is the default.
  const Relief relief = test::waves(1, 10);
  const auto space = test::spaceOf(relief, 100, SurfaceKind::bilinear);
  const Accuracy a = test::slideOver(*space, relief, {}, {});
  EXPECT_GT(a.angle_max, 5);
  EXPECT_GT(a.step, 4 * a.true_step);
}

TEST(SmoothRelief, AcrossTheGateForceStepsNoMoreThanTruth) {
  for (const double length_mm : {10.0, 20.0}) {
    const auto ratio = [&](SurfaceKind kind) {
      return test::stepsAcrossCreases(1, length_mm, kind).ratio();
    };
    EXPECT_LE(ratio(SurfaceKind::crease_aware), 1.02) << length_mm;
    EXPECT_GT(ratio(SurfaceKind::bilinear), 5);
    EXPECT_GT(ratio(SurfaceKind::spline), 5) << "it rings beside the block";
  }
}

TEST(SmoothRelief, SpeedAndDepthChangeNothing) {
  const Relief relief = test::waves(2, 40), tilt = test::plane(0.577, 0);
  const auto space = test::spaceOf(relief, 100, SurfaceKind::crease_aware);
  for (const double speed : {70.0, 500.0, 2000.0}) {
    const Accuracy a =
        test::slideOver(*space, relief, {.speed_mm_per_s = speed, .ticks = 3000}, {});
    EXPECT_LE(a.angle_max, 0.001) << speed;
  }
  const auto tilted = test::spaceOf(tilt, 100, SurfaceKind::crease_aware);
  for (const double depth : {1.0, 5.0, 25.0}) {
    const Accuracy a = test::slideOver(
        *tilted, tilt, {.depth_mm = depth, .speed_mm_per_s = 73, .ticks = 3000}, {});
    EXPECT_LE(a.position_max_um, 0.1) << depth;
  }
}

TEST(SmoothRelief, TheForceIsNormalToTheSurfaceAtTheProxy) {
  const auto space = test::spaceOf(
      80,
      [](double x, double y) {
        return 1.5 * std::sin(0.5 * x) + 1.2 * std::cos(0.43 * y + 0.2 * x) +
               0.3 * std::sin(1.7 * x + y);
      },
      1, {}, SurfaceKind::crease_aware);
  ProxyState state;
  std::vector<double> angles;
  double deepest = -1;
  for (int n = 0; n < 40000; ++n) {
    const double x = 99.5 + 90 * std::sin(0.0021 * n), y = 99.5 + 90 * std::sin(0.0017 * n + 0.4);
    const double surface = surfaceHeight(*space, x, y);
    const GridPoint hip{x, y, surface + (n == 0 ? 1 : -2.5 * (1 + std::sin(0.01 * n)))};
    state = n == 0 ? proxyPlace(*space, hip) : proxyTick(*space, state, hip, {});
    const GridPoint p = state.position, force = p - hip;
    deepest = std::max(deepest, space->cell_mm * (surfaceHeight(*space, p.x, p.y) - p.z));
    if (state.contact && norm(force) * space->cell_mm > 0.05) {
      angles.push_back(test::angleDegrees(force, proxyNormal(*space, state)));
    }
  }
  EXPECT_GT(angles.size(), 20000U);
  EXPECT_LE(deepest, 1e-6) << "mm below the surface";
  EXPECT_LE(test::quantile(angles, 0.999), 1e-4);
  EXPECT_LE(test::quantile(angles, 1), 0.01);
}

TEST(SmoothRelief, AClosedPathWithoutFrictionGivesNoWork) {
  const Relief relief = test::waves(1, 10);
  for (const SurfaceKind kind :
       {SurfaceKind::crease_aware, SurfaceKind::spline, SurfaceKind::bilinear}) {
    const auto space = test::spaceOf(relief, 100, kind);
    const test::Work work = test::workPerCycle(*space, relief, {});
    EXPECT_GT(work.gross_mj, 1) << "the hand did press";
    EXPECT_LE(work.net_mj, 2e-4 * work.gross_mj) << "on the hand";
  }
}

TEST(SmoothRelief, RandomReliefWithNoiseAndWallsIsTouchedFromOutsideOnly) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto space = test::spaceOf(
      80,
      [&](double x, double y) {
        const double block = static_cast<int>(x / 8) % 3 == 0 ? 3 : 0;
        return std::sin(0.6 * x) + std::cos(0.5 * y) + 0.2 * unit(random) + block;
      },
      1, {}, SurfaceKind::crease_aware);
  GridPoint hip{100, 100, 30};
  ProxyState state = proxyPlace(*space, hip);
  int contacts = 0;
  for (int n = 0; n < 60000; ++n) {
    if (n % 50 == 0) hip = {100 + 90 * unit(random), 100 + 90 * unit(random), 12 * unit(random)};
    hip = hip + GridPoint{unit(random), unit(random), unit(random)};
    state = proxyTick(*space, state, hip, {});
    const GridPoint p = state.position;
    ASSERT_TRUE(isFinite(p)) << n;
    ASSERT_LE(space->cell_mm * (surfaceHeight(*space, p.x, p.y) - p.z), 1e-6) << n;
    contacts += state.contact ? 1 : 0;
  }
  EXPECT_GT(contacts, 20000);
}

}  // namespace
}  // namespace relievo
