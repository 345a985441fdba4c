// SPDX-License-Identifier: BSD-3-Clause
// The surface between the samples: smooth where the samples are, straight and broken at walls.
#include "haptics/space/surface_fit.h"

#include <gtest/gtest.h>

#include <random>

#include "haptics/proxy/surface.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using test::spaceOf;

constexpr std::array<SurfaceKind, 3> kKinds{SurfaceKind::crease_aware, SurfaceKind::spline,
                                            SurfaceKind::bilinear};

double waves(double x, double y) {
  return 1.3 * std::sin(0.7 * x + 0.2) * std::cos(0.5 * y) + 0.02 * x * y;
}
/// Walls, a pit, a fin, a spike and waves.
double town(double x, double y) {
  const double walls = (x > 30 && x < 50 && y > 20 && y < 60) ? 6 : 0;
  const double pit = (x - 60) * (x - 60) + (y - 30) * (y - 30) < 40 ? -5 : 0;
  const double fin = std::abs(y - 70.2) < 0.3 ? 8 : 0;
  const double spike = std::abs(x - 10.2) < 0.2 && std::abs(y - 10.2) < 0.2 ? 4 : 0;
  return waves(x, y) + walls + pit + fin + spike;
}

TEST(Surface, GoesThroughEverySample) {
  for (const SurfaceKind kind : kKinds) {
    const auto space = spaceOf(80, town, 1, {}, kind);
    for (int row = 0; row < kWindowSamples; ++row) {
      for (int col = 0; col < kWindowSamples; ++col) {
        ASSERT_NEAR(surfaceHeight(*space, col, row), space->gridHeight(col, row), 1e-12);
      }
    }
  }
}

TEST(Surface, HasNoGapBetweenCells) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0, 1);
  std::uniform_int_distribution<int> cell(0, kLastCell - 2);
  for (const SurfaceKind kind : kKinds) {
    const auto space = spaceOf(80, town, 1, {}, kind);
    for (int i = 0; i < 20000; ++i) {
      const int col = cell(random), row = cell(random);
      const double y = row + part(random), x = col + part(random);
      EXPECT_NEAR(bicubicPatch(*space, col, row).height(col + 1, y),
                  bicubicPatch(*space, col + 1, row).height(col + 1, y), 1e-9);
      EXPECT_NEAR(bicubicPatch(*space, col, row).height(x, row + 1),
                  bicubicPatch(*space, col, row + 1).height(x, row + 1), 1e-9);
    }
  }
}

TEST(Surface, HasDerivativesThatAreItsDifferences) {
  const auto space = spaceOf(80, town, 1, {}, SurfaceKind::crease_aware);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(1, 198);
  constexpr double kStep = 1e-4;
  for (int i = 0; i < 5000; ++i) {
    const double x = place(random), y = place(random);
    const BicubicPatch p = bicubicPatch(*space, cellOf(x, 0), cellOf(y, 0));
    const Jet jet = p.jet(x, y);
    const auto f = [&](double dx, double dy) { return p.height(x + dx * kStep, y + dy * kStep); };
    EXPECT_NEAR(jet.f, f(0, 0), 1e-12);
    EXPECT_NEAR(jet.fx, (f(1, 0) - f(-1, 0)) / (2 * kStep), 1e-5);
    EXPECT_NEAR(jet.fy, (f(0, 1) - f(0, -1)) / (2 * kStep), 1e-5);
    EXPECT_NEAR(jet.fxx, (f(1, 0) - 2 * f(0, 0) + f(-1, 0)) / (kStep * kStep), 1e-4);
    EXPECT_NEAR(jet.fyy, (f(0, 1) - 2 * f(0, 0) + f(0, -1)) / (kStep * kStep), 1e-4);
    EXPECT_NEAR(jet.fxy, (f(1, 1) - f(1, -1) - f(-1, 1) + f(-1, -1)) / (4 * kStep * kStep), 1e-4);
  }
}

/// Largest jump of slope and of curvature from cell to cell.
std::pair<double, double> jumps(const HapticSpace& space) {
  double slope = 0, curvature = 0;
  for (int row = 1; row < kLastCell - 1; ++row) {
    for (int col = 1; col < kLastCell - 1; ++col) {
      const Jet a = bicubicPatch(space, col, row).jet(col + 1, row + 0.4);
      const Jet b = bicubicPatch(space, col + 1, row).jet(col + 1, row + 0.4);
      slope = std::max(slope, std::hypot(a.fx - b.fx, a.fy - b.fy));
      curvature = std::max({curvature, std::abs(a.fxx - b.fxx), std::abs(a.fxy - b.fxy)});
    }
  }
  return {slope, curvature};
}

TEST(Surface, IsTwiceContinuousOnSmoothReliefWithAndWithoutCreases) {
  const auto spline = spaceOf(80, waves, 1, {}, SurfaceKind::spline);
  const auto aware = spaceOf(80, waves, 1, {}, SurfaceKind::crease_aware);
  const auto [slope, curvature] = jumps(*aware);
  EXPECT_LT(slope, 1e-6) << "slopes are kept as floats";
  EXPECT_LT(curvature, 1e-5);
  for (std::size_t i = 0; i < kWindowCount; ++i) {
    ASSERT_EQ(aware->marks[i], spline->marks[i]) << "nothing is broken";
    ASSERT_EQ(aware->samples[i].slope_x, spline->samples[i].slope_x);
    ASSERT_EQ(aware->samples[i].twist, spline->samples[i].twist);
  }
  const auto bilinear = spaceOf(80, waves, 1, {}, SurfaceKind::bilinear);
  EXPECT_GT(jumps(*bilinear).first, 0.05);
}

TEST(Surface, ReproducesCubicsToTheBorder) {
  const auto cubic = [](double x, double y) {
    return 1e-4 * x * x * x - 0.003 * x * y + 2e-5 * y * y * y + 0.02 * x * x;
  };
  const auto space = spaceOf(40, cubic, 1, {}, SurfaceKind::spline);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.1, 39.9);
  for (int i = 0; i < 2000; ++i) {
    const double x = place(random), y = place(random);
    const GridPoint g = space->gridFromView({x, y, 0});
    const double height = space->viewFromGrid({g.x, g.y, surfaceHeight(*space, g.x, g.y)}).z;
    EXPECT_NEAR(height, cubic(std::clamp(x, 0.1, 39.9), y), 2e-5) << x << ", " << y;
  }
}

TEST(Surface, IsBilinearAtAWallAndNeverRingsBesideIt) {
  for (const bool across : {false, true}) {
    const auto wall = [=](double x, double y) { return (across ? y : x) > 40 ? 5.0 : 0.0; };
    const auto aware = spaceOf(80, wall, 1, {}, SurfaceKind::crease_aware);
    const auto bilinear = spaceOf(80, wall, 1, {}, SurfaceKind::bilinear);
    const auto spline = spaceOf(80, wall, 1, {}, SurfaceKind::spline);
    double ringing = 0;
    for (int i = 0; i < 4000; ++i) {
      const double a = 90 + 0.005 * i, b = 50.37;
      const double x = across ? b : a, y = across ? a : b;
      const double truth = surfaceHeight(*bilinear, x, y);
      ASSERT_NEAR(surfaceHeight(*aware, x, y), truth, 1e-12);
      ringing = std::max(ringing, std::abs(surfaceHeight(*spline, x, y) - truth));
    }
    EXPECT_GT(ringing, 0.5) << "what breaking at creases is for";
  }
}

TEST(Surface, StaysSmoothBesideAWall) {
  // Waves of 20 samples with a wall through them: one cell beside it the surface is the waves'.
  const auto relief = [](double x, double y) {
    return 0.6 * std::sin(0.785398 * x) * std::cos(0.785398 * y);
  };
  const auto walled = [&](double x, double y) { return relief(x, y) + (x > 40 ? 5 : 0); };
  const auto aware = spaceOf(80, walled, 1, {}, SurfaceKind::crease_aware);
  const auto bilinear = spaceOf(80, walled, 1, {}, SurfaceKind::bilinear);
  double worst = 0, worst_bilinear = 0;
  for (int i = 0; i < 3000; ++i) {
    const double x = 36 + 3.3 * i / 3000.0, y = 20 + 0.013 * i;
    const GridPoint g = aware->gridFromView({x, y, 0});
    const double k = 0.785398;
    const double fx = 0.6 * k * std::cos(k * x) * std::cos(k * y);
    const double fy = -0.6 * k * std::sin(k * x) * std::sin(k * y);
    const Jet jet = surfaceJet(*aware, g.x, g.y), flat = surfaceJet(*bilinear, g.x, g.y);
    worst = std::max(worst, std::hypot(jet.fx - fx, jet.fy - fy));
    worst_bilinear = std::max(worst_bilinear, std::hypot(flat.fx - fx, flat.fy - fy));
  }
  EXPECT_LT(worst, 0.006);
  EXPECT_GT(worst_bilinear, 0.05);
}

TEST(Surface, NoPointIsAboveTheTopOfItsCellOrBlock) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> part(0, 1);
  for (const SurfaceKind kind : kKinds) {
    const auto space = spaceOf(80, town, 1, {}, kind);
    for (int row = 0; row < kLastCell; ++row) {
      for (int col = 0; col < kLastCell; ++col) {
        const float top = space->cell_tops[HapticSpace::index(col, row)];
        for (int i = 0; i < 4; ++i) {
          ASSERT_LE(surfaceHeight(*space, col + part(random), row + part(random)), top);
        }
        for (std::size_t level = 0; level < 3; ++level) {
          ASSERT_LE(top, space->block_tops.at(level, col, row));
        }
      }
    }
  }
}

}  // namespace
}  // namespace relievo
