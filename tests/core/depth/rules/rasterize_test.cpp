// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/rasterize.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

using test::latticeMesh;
using test::latticeScan;

GridFrame frameOf(int cols, int rows, double spacing) {
  return {.size = {.cols = cols, .rows = rows},
          .spacing_mm = spacing,
          .first_x_mm = 0,
          .first_y_mm = 0};
}

TEST(Rasterize, TiltedPlaneMeshComesBackAsThatPlaneAtEverySample) {
  const auto plane = [](double x, double y) { return 3 + 0.25 * x - 0.5 * y; };
  const Scan mesh = latticeMesh(4, 4, 10, plane);  // 30 x 30, far coarser than the samples.
  const GridFrame frame = frameOf(121, 121, 0.25);
  const FrontDepths depths = rasterize({.scan = mesh, .view_from_file = {}, .frame = frame}).front;
  for (int row = 0; row < 121; ++row) {
    for (int col = 0; col < 121; ++col) {
      const float z = depths[frame.size.index({.col = col, .row = row})];
      ASSERT_NEAR(z, plane(frame.xMm(col), frame.yMm(row)), 1e-5) << col << ' ' << row;
    }
  }
}

TEST(Rasterize, LatticePointsComeBackOneToOne) {
  const auto bump = [](double x, double y) { return std::sin(x) + std::cos(2 * y); };
  const Scan cloud = latticeScan(30, 20, 0.5, bump);
  const GridFrame frame = frameOf(30, 20, 0.5);
  const FrontDepths depths = rasterize({.scan = cloud, .view_from_file = {}, .frame = frame}).front;
  for (std::size_t i = 0; i < depths.size(); ++i) ASSERT_EQ(depths[i], cloud.points[i][2]);
}

TEST(Rasterize, TheFrontMostOfOverlappingSurfacesWins) {
  Scan mesh = latticeMesh(2, 2, 10, [](double, double) { return 1.0; });
  const Scan above = latticeMesh(2, 2, 10, [](double, double) { return 7.0; });
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  // The upper sheet covers x <= 5 only.
  for (auto p : above.points) {
    p[0] *= 0.5F;
    mesh.points.push_back(p);
  }
  for (const auto& t : above.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const GridFrame frame = frameOf(11, 11, 1);
  const FrontDepths depths = rasterize({.scan = mesh, .view_from_file = {}, .frame = frame}).front;
  EXPECT_FLOAT_EQ(depths[frame.size.index({.col = 2, .row = 5})], 7);
  EXPECT_FLOAT_EQ(depths[frame.size.index({.col = 8, .row = 5})], 1);
}

TEST(Rasterize, CellsWithoutSurfaceAreEmptyAndPointsOffTheGridAreIgnored) {
  Scan cloud = latticeScan(2, 1, 1, [](double, double) { return 0.0; });
  cloud.points.push_back({100.0F, 0.0F, 5.0F});
  const GridFrame frame = frameOf(5, 5, 1);
  const FrontDepths depths = rasterize({.scan = cloud, .view_from_file = {}, .frame = frame}).front;
  std::size_t hit = 0;
  for (const float z : depths) hit += std::isnan(z) ? 0 : 1;
  EXPECT_EQ(hit, 2U);
}

TEST(Rasterize, GeoreferencedPointsKeepMillimetres) {
  Scan cloud = latticeScan(50, 50, 0.01, [](double x, double y) { return x * y; });
  cloud.origin = {512022.25, 5403117.5, 226.75};  // Metres.
  ViewFromFile view;
  view.m = {1000, 0, 0, -512022250, 0, 1000, 0, -5403117500, 0, 0, 1000, -226750, 0, 0, 0, 1};
  const GridFrame frame = frameOf(50, 50, 10);
  const FrontDepths depths =
      rasterize({.scan = cloud, .view_from_file = view, .frame = frame}).front;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    ASSERT_NEAR(depths[i], 1000 * static_cast<double>(cloud.points[i][2]), 1e-4);
  }
}

TEST(Rasterize, NeedleTrianglesStayWithinTheirCorners) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> uniform(0, 20);
  Scan mesh;
  for (std::uint32_t i = 0; i < 600; i += 3) {
    const float x = uniform(random);
    const float y = uniform(random);
    mesh.points.push_back({x, y, 0});
    mesh.points.push_back({x + 1e-5F * uniform(random), y + uniform(random), 10});
    mesh.points.push_back({x + 1e-4F, y, 3});
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  test::finishScan(mesh);
  const FrontDepths depths =
      rasterize({.scan = mesh, .view_from_file = {}, .frame = frameOf(81, 81, 0.25)}).front;
  for (const float z : depths) {
    if (std::isnan(z)) continue;
    ASSERT_GE(z, 0);
    ASSERT_LE(z, 10);
  }
}

TEST(Rasterize, StopsWhenAsked) {
  const Scan cloud = latticeScan(10, 10, 1, [](double, double) { return 0.0; });
  std::stop_source stop;
  stop.request_stop();
  const Task task{.stop = stop.get_token(), .progress = {}};
  EXPECT_THROW(rasterize({.scan = cloud, .view_from_file = {}, .frame = frameOf(10, 10, 1)}, task),
               Cancelled);
}

/// A needle just above a row of samples, whose plane would pass far above its corners there.
TEST(Rasterize, ANeedleBesideARowOfSamplesStaysWithinItsCorners) {
  constexpr float kAbove = 5e-10F;
  Scan mesh;
  mesh.points = {{0, kAbove, 0}, {10, kAbove, 10}, {5, kAbove + 1e-11F, 3}};
  mesh.triangles = {{0, 1, 2}};
  test::finishScan(mesh);
  const FrontDepths depths =
      rasterize({.scan = mesh, .view_from_file = {}, .frame = frameOf(11, 3, 1)}).front;
  int hit = 0;
  for (const float z : depths) {
    if (std::isnan(z)) continue;
    ++hit;
    EXPECT_GE(z, 0);
    EXPECT_LE(z, 10);
  }
  EXPECT_EQ(hit, 11);
}

/// Steep is a matter of the slope in millimetres, whatever the distance of the samples.
TEST(Rasterize, AWallIsSteepAtAnySpacing) {
  for (const double spacing : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    for (const double share : {0.8, 1.25}) {
      SCOPED_TRACE(spacing);
      const Scan mesh = test::latticeMesh(
          9, 9, spacing, [share](double x, double) { return share * kSteepRise * x; });
      const CapturedDepths depths =
          rasterize({.scan = mesh, .view_from_file = {}, .frame = frameOf(9, 9, spacing)});
      ASSERT_EQ(depths.steep.size(), 81U);
      for (const std::uint8_t steep : depths.steep) ASSERT_EQ(steep, share > 1 ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace relievo
