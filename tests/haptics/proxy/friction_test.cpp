// SPDX-License-Identifier: BSD-3-Clause
// Coulomb friction as a cone on the proxy: holds, slides, loses work, never creeps.
#include <gtest/gtest.h>

#include <random>

#include "tests/haptics/proxy/measure.h"

namespace relievo {
namespace {

constexpr std::array<SurfaceKind, 3> kKinds{SurfaceKind::gated, SurfaceKind::spline,
                                            SurfaceKind::bilinear};

ProxyOptions rubbing(double fixed, double sliding) {
  ProxyOptions options;
  options.static_friction = fixed;
  options.dynamic_friction = sliding;
  return options;
}

std::unique_ptr<HapticSpace> flat(SurfaceKind kind) {
  return test::spaceOf(
      80, [](double, double) { return 0.0; }, 1, {}, kind);
}

TEST(Friction, HoldsWithinTheStaticConeAndSlidesOnTheDynamicOne) {
  for (const SurfaceKind kind : kKinds) {
    const auto space = flat(kind);
    const ProxyOptions options = rubbing(0.5, 0.3);
    ProxyState state = proxyPlace(*space, {100.3, 100.4, 1});
    state = proxyTick(*space, state, {100.3, 100.4, -2}, options);
    ASSERT_TRUE(state.contact);
    const GridPoint start = state.position;
    double held_until = 0;
    for (int n = 1; n <= 400; ++n) {
      const GridPoint hip{100.3 + 0.01 * n, 100.4, -2};
      state = proxyTick(*space, state, hip, options);
      if (state.position == start) {
        held_until = hip.x - start.x;
        continue;
      }
      EXPECT_NEAR(hip.x - state.position.x, 0.3 * 2, 1e-6) << "slides on the dynamic cone";
    }
    EXPECT_NEAR(held_until, 0.5 * 2, 0.011) << "static cone at depth 2";
  }
}

TEST(Friction, DoesNotCreepUnderAHandAtRest) {
  for (const SurfaceKind kind : kKinds) {
    const test::Relief relief = test::waves(1, 10);
    const auto space = test::spaceOf(relief, 100, kind);
    const ProxyOptions options = rubbing(0.2, 0.15);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(20, 180);
    for (int trial = 0; trial < 200; ++trial) {
      const double x = place(random), y = place(random);
      const double surface = surfaceHeight(*space, x, y);
      ProxyState state = proxyPlace(*space, {x, y, surface + 1});
      for (int n = 0; n <= 20; ++n) {  // Comes to rest while it slides.
        state = proxyTick(*space, state, {x + 0.1 * n, y + 0.05 * n, surface - 1.5}, options);
      }
      const GridPoint hip = state.hip, rest = state.position;
      for (int n = 0; n < 300; ++n) state = proxyTick(*space, state, hip, options);
      EXPECT_EQ(state.position, rest) << "trial " << trial;
    }
  }
}

TEST(Friction, OnlyLosesWork) {
  const test::Relief relief = test::waves(1, 10);
  for (const SurfaceKind kind : kKinds) {
    const auto space = test::spaceOf(relief, 100, kind);
    double last = 0;
    for (const double mu : {0.1, 0.3, 0.6}) {
      const test::Work work = test::workPerCycle(*space, relief, rubbing(1.4 * mu, mu));
      EXPECT_LT(work.net_mj, last) << mu;
      EXPECT_LT(work.net_mj, -0.01 * work.gross_mj) << mu;
      last = work.net_mj;
    }
  }
}

TEST(Friction, KeepsTheForceWithinTheConeAndTheProxyOutside) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto space = test::spaceOf(
      80,
      [&](double x, double y) {
        return std::sin(0.6 * x) + std::cos(0.5 * y) + 0.1 * unit(random) + (x > 40 ? 4 : 0);
      },
      1, {}, SurfaceKind::gated);
  const ProxyOptions options = rubbing(0.4, 0.25);
  GridPoint hip{100, 100, 30};
  ProxyState state = proxyPlace(*space, hip);
  int contacts = 0;
  for (int n = 0; n < 30000; ++n) {
    if (n % 200 == 0) hip = {100 + 90 * unit(random), 100 + 90 * unit(random), 12 * unit(random)};
    hip = hip + GridPoint{0.3 * unit(random), 0.3 * unit(random), 0.3 * unit(random)};
    state = proxyTick(*space, state, hip, options);
    const GridPoint p = state.position;
    ASSERT_TRUE(isFinite(p)) << n;
    ASSERT_LE(space->cell_mm * (surfaceHeight(*space, p.x, p.y) - p.z), 1e-6) << n;
    contacts += state.contact ? 1 : 0;
  }
  EXPECT_GT(contacts, 10000);
}

}  // namespace
}  // namespace relievo
