// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

using test::latticeMesh;
using test::latticeScan;

double determinant(const Rotation& r) {
  return r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) +
         r[2] * (r[3] * r[7] - r[4] * r[6]);
}

/// Exchanges file axes: the scan as if it had been stored with another axis up.
Scan turned(Scan scan, int x_from, int y_from, int z_from, float z_sign) {
  for (auto& p : scan.points) {
    const auto q = p;
    p = {q[static_cast<std::size_t>(x_from)], q[static_cast<std::size_t>(y_from)],
         z_sign * q[static_cast<std::size_t>(z_from)]};
  }
  test::finishScan(scan);
  return scan;
}

double relief(double x, double y) {
  return 2 * std::sin(x / 3) * std::cos(y / 4);
}

TEST(StandardRotation, AllSixAreRotations) {
  for (const char* name : {"top", "bottom", "front", "back", "left", "right"}) {
    const auto rotation = standardRotation(name);
    ASSERT_TRUE(rotation) << name;
    EXPECT_DOUBLE_EQ(determinant(*rotation), 1) << name;
  }
  EXPECT_FALSE(standardRotation("sideways"));
}

TEST(StandardRotation, FrontShowsXRightAndZUpSeenFromMinusY) {
  const Rotation front = *standardRotation("front");
  EXPECT_EQ(front, (Rotation{1, 0, 0, 0, 0, 1, 0, -1, 0}));
}

TEST(AutomaticRotation, AReliefLyingFlatIsSeenFromAbove) {
  EXPECT_EQ(automaticRotation(latticeScan(80, 60, 0.5, relief)).name, "top");
}

TEST(AutomaticRotation, AReliefStandingUprightIsSeenFaceOn) {
  // z of the relief stored as file y, its y as file z: seen along y.
  const Scan upright = turned(latticeScan(80, 60, 0.5, relief), 0, 2, 1, 1);
  const std::string name = automaticRotation(upright).name;
  EXPECT_TRUE(name == "front" || name == "back") << name;
}

TEST(AutomaticRotation, AMeshIsSeenFromTheSideItsTrianglesFace) {
  Scan mesh = latticeMesh(40, 40, 0.5, relief);
  EXPECT_EQ(automaticRotation(mesh).name, "top");
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(automaticRotation(mesh).name, "bottom");
}

TEST(AutomaticRotation, ADepthCameraFrameIsSeenFromTheCamera) {
  // The camera stands at the origin and looks along +z: the surface lies at z about 1.
  Scan frame =
      latticeScan(80, 60, 0.01, [](double x, double y) { return 1 + 0.1 * std::sin(9 * x) * y; });
  for (auto& p : frame.points) p = {p[0] - 0.4F, p[1] - 0.3F, p[2]};
  test::finishScan(frame);
  EXPECT_EQ(automaticRotation(frame).name, "bottom");
}

TEST(AutomaticRotation, FiguresThatStandOffTheGroundAreSeenFromTheirSide) {
  // A ground and a sheet 8 mm above its middle: from below the sheet is hidden.
  Scan scan = latticeScan(80, 80, 0.5, [](double, double) { return 0.0; });
  const Scan sheet = latticeScan(60, 60, 0.5, [](double, double) { return 8.0; });
  for (auto p : sheet.points) scan.points.push_back({p[0] + 5, p[1] + 5, -p[2]});
  for (auto& p : scan.points) p[2] = -p[2];
  test::finishScan(scan);
  EXPECT_EQ(automaticRotation(scan).name, "top");
}

TEST(RotatedBounds, ScalesToMillimetresAndKeepsTheOrigin) {
  Scan scan = latticeScan(3, 3, 1, [](double, double) { return 0.0; });
  scan.origin = {1000, 2000, 30};
  const RotatedBounds box = rotatedBounds(scan, *standardRotation("top"), 1000);
  EXPECT_DOUBLE_EQ(box.min.x, 1'000'000);
  EXPECT_DOUBLE_EQ(box.max.y, 2'002'000);
  EXPECT_DOUBLE_EQ(box.max.z, 30'000);
}

}  // namespace
}  // namespace relievo
