// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

TEST(NamedRotation, TheTwentyFourHaveNamesAndAreRotations) {
  std::vector<Rotation> seen;
  for (const std::string face : {"top", "front", "right", "back", "left", "bottom"}) {
    for (const std::string turn :
         {"", ", turned to the left", ", turned to the right", ", upside down"}) {
      const auto rotation = namedRotation(face + turn);
      ASSERT_TRUE(rotation) << face << turn;
      EXPECT_DOUBLE_EQ(determinant(*rotation), 1) << face << turn;
      EXPECT_EQ(std::find(seen.begin(), seen.end(), *rotation), seen.end()) << face << turn;
      EXPECT_EQ(nameOf(*rotation), face + turn);
      if (turn.empty()) {
        EXPECT_EQ(*rotation, *standardRotation(face));
      }
      seen.push_back(*rotation);
    }
  }
  EXPECT_FALSE(namedRotation("top, turned"));
  EXPECT_FALSE(standardRotation("top, upside down"));
  EXPECT_EQ(nameOf(relievo::turned(*standardRotation("top"), {10, 0, 0})), "free");
  // Turned to the left: what was on the right is now above.
  const Rotation left = *namedRotation("top, turned to the left");
  EXPECT_EQ(left[3], 1);
}

/// A figure on a square base: y up, its broad side to +z, a nose in front.
Scan figureOnABase() {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Scan scan;
  for (int i = 0; i < 30'000; ++i) {
    const float angle = 3.14159265F * uniform(random);
    const float height = 0.5F * (1 + uniform(random));
    const float waist = 1 + 0.2F * std::sin(9 * height);
    scan.points.push_back({8 * waist * std::cos(angle), 4 + 40 * height,
                           4 * waist * std::sin(angle) + (height > 0.8F ? 2.0F : 0.0F)});
    if (i % 3 == 0) scan.points.push_back({12 * uniform(random), 0, 10 * uniform(random)});
    if (i % 5 == 0) scan.points.push_back({12 * uniform(random), 4, 10 * uniform(random)});
  }
  test::finishScan(scan);
  return scan;
}

TEST(AutomaticRotation, AFigureStandsUprightHoweverItsFileLiesIt) {
  const Scan figure = figureOnABase();
  EXPECT_EQ(automaticRotation(figure).name, "top") << "y up, seen from +z";
  for (const std::string face : {"top", "front", "right", "back", "left", "bottom"}) {
    for (const std::string turn :
         {"", ", turned to the left", ", turned to the right", ", upside down"}) {
      const Rotation stored = *namedRotation(face + turn);
      Scan scan = figure;
      for (auto& p : scan.points) {
        const auto q = p;
        for (std::size_t k = 0; k < 3; ++k) {
          p[k] = static_cast<float>(stored[3 * k]) * q[0] +
                 static_cast<float>(stored[3 * k + 1]) * q[1] +
                 static_cast<float>(stored[3 * k + 2]) * q[2];
        }
      }
      test::finishScan(scan);
      const NamedRotation view = automaticRotation(scan);
      EXPECT_FALSE(view.is_weak) << face << turn;
      EXPECT_EQ(nameOf(view.rotation), view.name);
      // Where the figure's own y is in the picture.
      double up = 0;
      double deep = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        up += view.rotation[3 + k] * stored[3 * k + 1];
        deep += view.rotation[6 + k] * stored[3 * k + 1];
      }
      EXPECT_EQ(up, 1) << face << turn << ": " << view.name;
      EXPECT_EQ(deep, 0) << face << turn << ": " << view.name;
    }
  }
}

TEST(AutomaticRotation, AnObjFileHasYUpAndABallMayStandAnyWay) {
  Scan ball;
  for (int i = 0; i < 20'000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 20'000;
    const double angle = 2.399963229728653 * i;
    const double r = std::sqrt(1 - z * z);
    ball.points.push_back({static_cast<float>(r * std::cos(angle)),
                           static_cast<float>(r * std::sin(angle)), static_cast<float>(z)});
  }
  test::finishScan(ball);
  EXPECT_TRUE(automaticRotation(ball).is_weak);
  ball.info.format = "OBJ";
  const NamedRotation view = automaticRotation(ball);
  EXPECT_FALSE(view.is_weak);
  EXPECT_EQ(view.rotation[4], 1) << "+y is up in the picture";
}

TEST(AutomaticRotation, AReliefIsNotTurnedByWhicheverEdgeIsStraight) {
  Scan relief = latticeScan(
      80, 60, 0.5, [](double x, double y) { return 2 * std::sin(x / 3) * std::cos(y / 4); });
  std::erase_if(relief.points, [](const auto& p) { return p[1] < 4 + 3 * std::sin(p[0]); });
  test::finishScan(relief);
  EXPECT_EQ(automaticRotation(relief).name, "top");
}

TEST(AutomaticRotation, SurveysAndCamerasKeepTheirAxes) {
  Scan survey = figureOnABase();
  survey.origin = {512'000, 5'403'000, 200};
  test::finishScan(survey);
  const NamedRotation view = automaticRotation(survey);
  EXPECT_TRUE(standardRotation(view.name)) << view.name;
  EXPECT_FALSE(view.is_weak);
  EXPECT_EQ(chosenRotation(survey, {.name = std::string(kEarlierAutomatic), .rotation = {}}).name,
            view.name);
}

TEST(RotatedBounds, ScalesToMillimetresAndKeepsTheOrigin) {
  Scan scan = latticeScan(3, 3, 1, [](double, double) { return 0.0; });
  scan.origin = {1000, 2000, 30};
  const RotatedBounds box = rotatedBounds(scan, *standardRotation("top"), 1000);
  EXPECT_DOUBLE_EQ(box.min.x, 1'000'000);
  EXPECT_DOUBLE_EQ(box.max.y, 2'002'000);
  EXPECT_DOUBLE_EQ(box.max.z, 30'000);
}

/// A plate of 60 x 20 mm, 2 mm of relief, tilted and turned in space.
Scan tiltedPlate(const Rotation& view_from_file, int outliers) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  Scan scan;
  for (int i = 0; i < 20'000 + outliers; ++i) {
    const double x = 60 * uniform(random);
    const double y = 20 * uniform(random);
    double z = 0.3 * std::sin(x) * std::cos(y);
    if (i >= 20'000) z += 400;
    const Rotation& r = view_from_file;  // Its transpose turns the other way.
    scan.points.push_back({static_cast<float>(r[0] * x + r[3] * y + r[6] * z),
                           static_cast<float>(r[1] * x + r[4] * y + r[7] * z),
                           static_cast<float>(r[2] * x + r[5] * y + r[8] * z)});
  }
  test::finishScan(scan);
  return scan;
}

double cosineOfNormals(const Rotation& a, const Rotation& b) {
  return a[6] * b[6] + a[7] * b[7] + a[8] * b[8];
}

TEST(ChosenRotation, TheBestFitPlaneIsFacedAndOutliersDoNotTiltIt) {
  const Rotation truth = relievo::turned(*standardRotation("top"), {25, -35, 0});
  const Scan scan = tiltedPlate(truth, 40);
  const NamedRotation view = chosenRotation(scan, {.name = "fit", .rotation = {}});
  EXPECT_EQ(view.name, "fit");
  EXPECT_GT(cosineOfNormals(view.rotation, truth), std::cos(0.1 * M_PI / 180));
  EXPECT_NEAR(determinant(view.rotation), 1, 1e-9);
  // Upright: the file's y does not point down in the picture.
  EXPECT_GT(view.rotation[4], 0);
}

TEST(ChosenRotation, ThePrincipalAxesLieAlongTheLongSideAndTheShortOne) {
  const Rotation truth = relievo::turned(*standardRotation("top"), {20, 10, 30});
  const Scan scan = tiltedPlate(truth, 0);
  const NamedRotation view = chosenRotation(scan, {.name = "axes", .rotation = {}});
  EXPECT_GT(cosineOfNormals(view.rotation, truth), std::cos(0.1 * M_PI / 180));
  const double along =
      view.rotation[0] * truth[0] + view.rotation[1] * truth[1] + view.rotation[2] * truth[2];
  EXPECT_GT(std::abs(along), std::cos(1 * M_PI / 180));
  EXPECT_NEAR(determinant(view.rotation), 1, 1e-9);
  EXPECT_FALSE(view.note);
}

TEST(ChosenRotation, ACubesAxesAreSaidToBeUncertain) {
  const Scan cube = test::latticeScan(20, 20, 1, [](double, double) { return 0.0; });
  const NamedRotation view = chosenRotation(cube, {.name = "axes", .rotation = {}});
  EXPECT_TRUE(view.note);
}

TEST(ChosenRotation, TurnsAboutTheViewsOwnAxesInDegrees) {
  const Rotation top = *standardRotation("top");
  // A quarter about x brings what was up toward the viewer.
  const Rotation x = relievo::turned(top, {90, 0, 0});
  EXPECT_NEAR(x[7], 1, 1e-15);
  EXPECT_EQ(relievo::turned(top, {0, 0, 0}), top);
  const Rotation back = relievo::turned(relievo::turned(top, {0, 0, 37}), {0, 0, -37});
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(back[i], top[i], 1e-15);
  const Scan scan = tiltedPlate(top, 0);
  const NamedRotation named =
      chosenRotation(scan, {.name = "front", .rotation = {}, .turn_deg = {0, 12.5, 0}});
  EXPECT_EQ(named.name, "front + 0, 12.5, 0 degrees");
  EXPECT_THROW(chosenRotation(scan, {.name = "top", .rotation = {}, .turn_deg = {NAN, 0, 0}}),
               ArgumentError);
}

TEST(RotatedBounds, AreTheSameForAnyNumberOfPoints) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-10, 10);
  const Rotation top = *standardRotation("top");
  for (std::size_t count = 1; count < 30; ++count) {
    Scan scan;
    FilePoint low{100, 100, 100}, high{-100, -100, -100};
    for (std::size_t i = 0; i < count; ++i) {
      const auto& p = scan.points.emplace_back(
          std::array<float, 3>{place(random), place(random), place(random)});
      low = {std::min<double>(low.x, p[0]), std::min<double>(low.y, p[1]),
             std::min<double>(low.z, p[2])};
      high = {std::max<double>(high.x, p[0]), std::max<double>(high.y, p[1]),
              std::max<double>(high.z, p[2])};
    }
    const RotatedBounds box = rotatedBounds(scan, top, 1);
    EXPECT_EQ(box.min.x, low.x) << count;
    EXPECT_EQ(box.min.z, low.z) << count;
    EXPECT_EQ(box.max.y, high.y) << count;
    EXPECT_EQ(box.max.z, high.z) << count;
  }
}

}  // namespace
}  // namespace relievo
