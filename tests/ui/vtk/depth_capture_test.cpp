// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/depth_capture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <numbers>
#include <random>

#include "tests/core/scan_fixtures.h"
#include "tests/ui/vtk/depth_comparison.h"

namespace relievo {
namespace {

GridFrame frameOf(int cols, int rows, double spacing) {
  return {.size = {.cols = cols, .rows = rows},
          .spacing_mm = spacing,
          .first_x_mm = 0,
          .first_y_mm = 0};
}

/// A mesh over [0, side]^2 whose inner vertices lie anywhere, without a fold: z = height(x, y) at
/// the vertices.
template <class Height>
Scan scatteredMesh(int per_side, double side, Height&& height) {
  Scan mesh = test::latticeMesh(per_side, per_side, side / (per_side - 1), height);
  std::mt19937 random(7);
  const auto jitter = static_cast<float>(0.2 * side / (per_side - 1));
  std::uniform_real_distribution<float> shift(-jitter, jitter);
  const auto inner = [&](float v) { return v > 0 && v < static_cast<float>(side) - 1e-3F; };
  for (auto& p : mesh.points) {
    if (inner(p[0])) p[0] += shift(random);
    if (inner(p[1])) p[1] += shift(random);
    p[2] = static_cast<float>(height(static_cast<double>(p[0]), static_cast<double>(p[1])));
  }
  return mesh;
}

/// A ball of triangles, poles along x, so that no ring of vertices lies on the grid.
Scan ball(double radius, double cx, double cy, double cz, int rings) {
  Scan mesh;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    const double polar = std::numbers::pi * i / rings;
    for (int j = 0; j < around; ++j) {
      const double turn = 2 * std::numbers::pi * j / around + 0.01;
      mesh.points.push_back({static_cast<float>(cx + radius * std::cos(polar)),
                             static_cast<float>(cy + radius * std::sin(polar) * std::cos(turn)),
                             static_cast<float>(cz + radius * std::sin(polar) * std::sin(turn))});
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      const auto at = [&](int ring, int k) {
        return static_cast<std::uint32_t>(ring * around + k % around);
      };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

void expectEnginesAgree(const DepthRequest& request, double jump_mm, double at_least_compared) {
  expectEnginesAgree(rasterize(request).front, captureDepths(request).front, request.frame.size,
                     jump_mm, at_least_compared);
}

double waves(double x, double y) {
  return 4 * std::sin(0.31 * x) * std::cos(0.23 * y + 0.4) + 6;
}

TEST(DepthCapture, TiltedPlaneComesBackAsThatPlaneAtEverySampleTheRimIncluded) {
  const auto plane = [](double x, double y) { return 3 + 0.25 * x - 0.5 * y; };
  const Scan mesh = test::latticeMesh(4, 4, 10, plane);
  const GridFrame frame = frameOf(121, 121, 0.25);
  const FrontDepths depths =
      captureDepths({.scan = mesh, .view_from_file = {}, .frame = frame}).front;
  for (int row = 0; row < 121; ++row) {
    for (int col = 0; col < 121; ++col) {
      const bool rim = col == 0 || row == 0 || col == 120 || row == 120;
      const float z = depths[frame.size.index({.col = col, .row = row})];
      const double tolerance = rim ? 0.25 / 32 : 2e-5 * 22.5;
      ASSERT_NEAR(z, plane(frame.xMm(col), frame.yMm(row)), tolerance) << col << ' ' << row;
    }
  }
}

/// Each of them lies in one quarter of the ways around its sample, behind an edge that OpenGL
/// leaves out: only a look from that quarter finds it.
TEST(DepthCapture, ACornerOnASampleIsFoundWhicheverWayItsTriangleLies) {
  const GridFrame frame = frameOf(41, 41, 1);
  for (const float right : {1.0F, -1.0F}) {
    for (const float up : {1.0F, -1.0F}) {
      for (const bool steep : {false, true}) {
        Scan mesh;
        const auto add = [&](float along, float across) {
          mesh.points.push_back(
              {20 + right * (steep ? across : along), 20 + up * (steep ? along : across), 5});
        };
        add(0, 0);
        add(10, 2);  // Above the line of samples.
        add(0, 10);  // Along one.
        mesh.triangles.push_back({0, 1, 2});
        mesh.points.push_back({20, 20, 0});  // The box has some depth.
        const FrontDepths depths =
            captureDepths({.scan = mesh, .view_from_file = {}, .frame = frame}).front;
        EXPECT_NEAR(depths[frame.size.index({.col = 20, .row = 20})], 5, 0.01)
            << right << ' ' << up << ' ' << steep;
      }
    }
  }
}

TEST(DepthCapture, APointOnTheGridsRimBelongsToTheOutermostSample) {
  // The rim is half a cell beyond the outermost samples; what lies beyond it is no part of the map.
  const GridFrame frame = frameOf(8, 6, 0.5);
  Scan cloud;
  cloud.points = {{3.75F, 1, 3}, {1, 2.75F, 4}, {-0.25F, 2, 5}, {2, -0.25F, 6},
                  {3.8F, 2, 7},  {2, 2.8F, 8},  {-0.3F, 1, 9},  {1, -0.3F, 10}};
  const FrontDepths depths =
      captureDepths({.scan = cloud, .view_from_file = {}, .frame = frame}).front;
  const auto at = [&](int col, int row) {
    return depths[frame.size.index({.col = col, .row = row})];
  };
  EXPECT_NEAR(at(7, 2), 3, 0.01);
  EXPECT_NEAR(at(2, 5), 4, 0.01);
  EXPECT_NEAR(at(0, 4), 5, 0.01);
  EXPECT_NEAR(at(4, 0), 6, 0.01);
  const auto drawn = std::count_if(depths.begin(), depths.end(), [](float z) { return z == z; });
  EXPECT_EQ(drawn, 4);
}

TEST(DepthCapture, AFineMeshComesBackAsItsClosedForm) {
  const Scan mesh = scatteredMesh(600, 60, waves);
  const GridFrame frame = frameOf(301, 301, 0.2);
  const FrontDepths depths =
      captureDepths({.scan = mesh, .view_from_file = {}, .frame = frame}).front;
  double largest = 0;
  for (int row = 1; row < 300; ++row) {
    for (int col = 1; col < 300; ++col) {
      const auto z = static_cast<double>(depths[frame.size.index({.col = col, .row = row})]);
      largest = std::max(largest, std::abs(z - waves(frame.xMm(col), frame.yMm(row))));
    }
  }
  // Triangles of 0.1 mm sag by h^2/8 times the curvature 4 x 0.31^2: 5e-4 mm, doubled by jitter.
  EXPECT_LT(largest, 2e-3);
}

TEST(DepthCapture, AgreesWithTheCpuEngineOnARelief) {
  const Scan mesh = scatteredMesh(160, 60, waves);
  expectEnginesAgree({.scan = mesh, .view_from_file = {}, .frame = frameOf(400, 400, 60.0 / 399)},
                     1.0, 0.9);
}

TEST(DepthCapture, AgreesWithTheCpuEngineOnABallInFrontOfASheet) {
  Scan mesh = ball(10, 21.3, 20.7, 15, 120);
  const Scan sheet = scatteredMesh(50, 45, waves);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), sheet.points.begin(), sheet.points.end());
  for (const auto& t : sheet.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  expectEnginesAgree({.scan = mesh, .view_from_file = {}, .frame = frameOf(500, 500, 0.1)}, 0.8,
                     0.7);
}

TEST(DepthCapture, SaysHowExactItsFormatIsAndKeepsWithinItOfTheCpuEngine) {
  Scan cloud;
  std::mt19937 random(12);
  std::uniform_real_distribution<float> place(0, 60);
  for (int i = 0; i < 200'000; ++i) cloud.points.push_back({place(random), place(random), 0});
  for (auto& p : cloud.points) {
    p[2] = static_cast<float>(waves(static_cast<double>(p[0]), static_cast<double>(p[1])));
  }
  const Scan mesh = scatteredMesh(160, 60, waves);
  for (const Scan* scan : std::initializer_list<const Scan*>{&cloud, &mesh}) {
    const DepthRequest request{
        .scan = *scan, .view_from_file = {}, .frame = frameOf(400, 400, 60.0 / 399)};
    const CapturedDepths captured = captureDepths(request);
    ASSERT_TRUE(captured.depth_buffer.has_value());
    const DepthBufferFormat& format = *captured.depth_buffer;
    EXPECT_EQ(format.triangles, scan == &mesh);
    EXPECT_GE(format.bits, 16);
    EXPECT_LE(format.bits, 32);
    const auto [low, high] =
        std::minmax_element(scan->points.begin(), scan->points.end(),
                            [](const auto& a, const auto& b) { return a[2] < b[2]; });
    EXPECT_GE(format.near_z_mm, static_cast<double>((*high)[2]));
    EXPECT_LE(format.far_z_mm, static_cast<double>((*low)[2]));
    EXPECT_LT(format.rangeMm(), 1.001 * static_cast<double>((*high)[2] - (*low)[2]));
    if (format.bits == 24 && !format.is_float) {
      EXPECT_DOUBLE_EQ(format.stepMm(), format.rangeMm() / 16'777'215);
    }
    // A jump of 1 mm between samples is a silhouette here; the points' front is not continuous.
    if (scan == &mesh) {
      const Difference d = compare(rasterize(request).front, captured.front, request.frame.size, 1);
      EXPECT_GT(d.compared, 100'000U);
      EXPECT_LE(d.largest_mm, format.accuracyMm());
      continue;
    }
    const FrontDepths exact = rasterize(request).front;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      ASSERT_EQ(std::isnan(exact[i]), std::isnan(captured.front[i]));
      if (std::isnan(exact[i])) continue;
      ++compared;
      ASSERT_LE(std::abs(static_cast<double>(exact[i]) - static_cast<double>(captured.front[i])),
                format.accuracyMm() + 1e-6);  // Depths themselves are stored in single precision.
    }
    EXPECT_GT(compared, 100'000U);
  }
}

TEST(DepthCapture, AgreesWithTheCpuEngineOnAMapLargerThanOneTile) {
  const Scan mesh = scatteredMesh(300, 60, waves);
  expectEnginesAgree(
      {.scan = mesh, .view_from_file = {}, .frame = frameOf(2500, 2300, 60.0 / 2499)}, 1.0, 0.8);
}

TEST(DepthCapture, KeepsMillimetresInUtmCoordinates) {
  Scan mesh = scatteredMesh(160, 60, waves);
  mesh.origin = {512345.25, 5412345.5, 210.75};
  ViewFromFile view;
  view.m = {1000, 0, 0, -512345250.0, 0, 1000, 0, -5412345500.0, 0, 0, 1000, -210750.0, 0, 0, 0, 1};
  expectEnginesAgree(
      {.scan = mesh, .view_from_file = view, .frame = frameOf(400, 400, 60000.0 / 399)}, 1000, 0.9);
}

TEST(DepthCapture, PointsCountForTheirNearestSampleAndTheFrontMostWins) {
  Scan cloud;
  std::mt19937 random(11);
  std::uniform_real_distribution<float> place(-2, 62);
  for (int i = 0; i < 300'000; ++i) {
    const float x = place(random), y = place(random);
    cloud.points.push_back(
        {x, y, static_cast<float>(waves(static_cast<double>(x), static_cast<double>(y)))});
  }
  const GridFrame frame = frameOf(400, 400, 0.15);
  const DepthRequest request{.scan = cloud, .view_from_file = {}, .frame = frame};
  const FrontDepths cpu = rasterize(request).front, gl = captureDepths(request).front;
  std::size_t same = 0, hit = 0;
  double largest = 0;
  for (std::size_t i = 0; i < cpu.size(); ++i) {
    same += std::isnan(cpu[i]) == std::isnan(gl[i]) ? 1U : 0U;
    if (std::isnan(cpu[i]) || std::isnan(gl[i])) continue;
    ++hit;
    largest = std::max(largest, std::abs(static_cast<double>(cpu[i]) - static_cast<double>(gl[i])));
  }
  EXPECT_EQ(same, cpu.size());
  EXPECT_GT(hit, cpu.size() / 2);
  EXPECT_LT(hit, cpu.size());
  EXPECT_LT(largest, 2e-5 * 8);
}

TEST(DepthCapture, CellsWithNothingInFrontAreNotNumbers) {
  const Scan mesh = test::latticeMesh(2, 2, 10, [](double, double) { return 5.0; });
  const GridFrame frame = frameOf(40, 20, 1);
  const FrontDepths depths =
      captureDepths({.scan = mesh, .view_from_file = {}, .frame = frame}).front;
  EXPECT_NEAR(depths[frame.size.index({5, 5})], 5, 1e-5);
  EXPECT_TRUE(std::isnan(depths[frame.size.index({15, 5})]));
  EXPECT_TRUE(std::isnan(depths[frame.size.index({5, 15})]));
}

TEST(DepthCapture, AnEmptyScanGivesNothing) {
  const Scan nothing;
  const FrontDepths depths =
      captureDepths({.scan = nothing, .view_from_file = {}, .frame = frameOf(3, 2, 1)}).front;
  EXPECT_EQ(depths.size(), 6U);
  EXPECT_TRUE(std::all_of(depths.begin(), depths.end(), [](float z) { return std::isnan(z); }));
}

TEST(DepthCapture, RepeatsItselfBitByBit) {
  const Scan mesh = scatteredMesh(100, 60, waves);
  const DepthRequest request{.scan = mesh, .view_from_file = {}, .frame = frameOf(301, 301, 0.2)};
  const FrontDepths once = captureDepths(request).front, again = captureDepths(request).front;
  EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(float)), 0);
}

TEST(DepthCapture, StopsWhenAsked) {
  const Scan mesh = scatteredMesh(400, 60, waves);
  std::stop_source stop;
  Task task;
  task.stop = stop.get_token();
  task.progress = [&](std::string_view, double) { stop.request_stop(); };
  EXPECT_THROW(
      captureDepths({.scan = mesh, .view_from_file = {}, .frame = frameOf(301, 301, 0.2)}, task)
          .front,
      Cancelled);
}

TEST(DepthCapture, WithoutADisplayItSaysSo) {
  const std::string display = std::getenv("DISPLAY") ? std::getenv("DISPLAY") : "";
  unsetenv("DISPLAY");
  const Scan mesh = test::latticeMesh(2, 2, 10, [](double, double) { return 5.0; });
  EXPECT_THROW(
      captureDepths({.scan = mesh, .view_from_file = {}, .frame = frameOf(11, 11, 1)}).front,
      GraphicsError);
  setenv("DISPLAY", display.c_str(), 1);
}

}  // namespace
}  // namespace relievo
