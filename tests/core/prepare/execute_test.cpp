// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/execute.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/message/catalogue.h"
#include "core/prepare/off_surface.h"
#include "core/prepare/thin.h"
#include "tests/core/prepare/made_clouds.h"

namespace relievo {
namespace {

using Numbers = std::vector<std::uint32_t>;

PrepareAnswer run(const std::vector<PrepareScan>& scans, const std::vector<Step>& steps,
                  const AlignFunction& align = {}) {
  return execute({.steps = steps, .scans = scans}, align, {});
}

Numbers keptBy(const PrepareScan& scan, const Step& step) {
  return test::numbersOf(run({scan}, {step}).steps.at(0).kept);
}

/// Nine points of a square at z = 0, and one high above.
const std::vector<Point3f> kSquare{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                   {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}, {1, 1, 50}};

TEST(CropBox, KeepsWhatLiesInItWithItsEdges) {
  const PrepareScan scan = test::scanOf(kSquare);
  EXPECT_EQ(keptBy(scan, CropBox{.min = {0, 0, 0}, .max = {1, 1, 1}}), (Numbers{0, 1, 3, 4}));
  EXPECT_EQ(keptBy(scan, CropBox{.min = {0, 0, 0}, .max = {2, 2, 1}, .keep_inside = false}),
            (Numbers{9}));
}

TEST(CropBox, AlongItsAxesIsTheTurnedBox) {
  // From the front: x, z, -y.
  const CropBox box{.min = {0, 0, -1}, .max = {1, 1, 0}, .axes = *standardRotation("front")};
  EXPECT_EQ(keptBy(test::scanOf(kSquare), box), (Numbers{0, 1, 3, 4}));
}

TEST(CropBox, TellsPointsOfAMapApartThatFloatsCannot) {
  PrepareScan scan = test::scanOf(kSquare);
  scan.origin = {5e8, 54e8, 0};
  const CropBox box{.min = {5e8 + 0.5, 54e8 + 0.5, -1}, .max = {5e8 + 2, 54e8 + 2, 1}};
  EXPECT_EQ(keptBy(scan, box), (Numbers{4, 5, 7, 8}));
}

TEST(CropOutline, KeepsWhatIsSeenWithinIt) {
  const CropOutline triangle{.view = kFileAxes,
                             .outline = {{-0.5, -0.5}, {2.6, -0.5}, {-0.5, 2.6}}};
  // However deep: the point high above lies within as well.
  EXPECT_EQ(keptBy(test::scanOf(kSquare), triangle), (Numbers{0, 1, 2, 3, 4, 6, 9}));
  CropOutline outside = triangle;
  outside.keep_inside = false;
  EXPECT_EQ(keptBy(test::scanOf(kSquare), outside), (Numbers{5, 7, 8}));
}

TEST(CropOutline, IsNotConvexIfItIsDrawnSo) {
  const CropOutline u{.view = kFileAxes,
                      .outline = {{-0.5, -0.5},
                                  {2.5, -0.5},
                                  {2.5, 2.5},
                                  {1.5, 2.5},
                                  {1.5, 0.5},
                                  {0.5, 0.5},
                                  {0.5, 2.5},
                                  {-0.5, 2.5}}};
  EXPECT_EQ(keptBy(test::scanOf(kSquare), u), (Numbers{0, 1, 2, 3, 5, 6, 8}));
}

TEST(Classes, KeepWhatIsNamedAndNoNoise) {
  const std::vector<std::uint8_t> classes{2, 2, 6, 7, 18, 1, 0, 2, 9, 7};
  PrepareScan scan = test::scanOf(kSquare);
  scan.classes = classes;
  EXPECT_EQ(keptBy(scan, Classes{}), (Numbers{0, 1, 2, 5, 6, 7, 8}));
  EXPECT_EQ(keptBy(scan, Classes{.keep_noise = true}).size(), 10U);
  EXPECT_EQ(keptBy(scan, Classes{.keep = {2, 7}}), (Numbers{0, 1, 3, 7, 9}));
}

TEST(Returns, AreCountedFromBothEndsOfAPulse) {
  const auto packed = [](unsigned number, unsigned of) {
    return static_cast<std::uint8_t>(number | of << 4U);
  };
  const std::vector<std::uint8_t> returns{packed(1, 1), packed(1, 3),  packed(2, 3), packed(3, 3),
                                          packed(1, 2), packed(2, 2),  packed(0, 0), packed(15, 15),
                                          packed(1, 1), packed(14, 15)};
  PrepareScan scan = test::scanOf(kSquare);
  scan.returns = returns;
  EXPECT_EQ(keptBy(scan, Returns{ReturnChoice::first}), (Numbers{0, 1, 4, 6, 8}));
  EXPECT_EQ(keptBy(scan, Returns{ReturnChoice::last}), (Numbers{0, 3, 5, 6, 7, 8}));
  EXPECT_EQ(keptBy(scan, Returns{ReturnChoice::single}), (Numbers{0, 6, 8}));
}

TEST(Returns, OfAScanWithoutThemAreNotDoneInSilence) {
  const PrepareAnswer answer = run({test::scanOf(kSquare)}, {Returns{}});
  EXPECT_FALSE(answer.steps[0].done);
  EXPECT_NE(englishText(answer.steps[0].notes).find("no pulses with several returns"),
            std::string::npos);
  EXPECT_EQ(answer.steps[0].after, 10U);
}

TEST(Classes, OfAScanWithoutThemAreNotDoneInSilence) {
  const PrepareAnswer answer = run({test::scanOf(kSquare)}, {Classes{.keep = {2}}});
  EXPECT_FALSE(answer.steps[0].done);
  EXPECT_NE(englishText(answer.steps[0].notes).find("states no classes"), std::string::npos);
  EXPECT_EQ(answer.steps[0].after, 10U);
}

TEST(Intensities, AreMeantAsTheyWereStored) {
  const std::vector<std::uint16_t> stored{0,     6554,  13107, 19661, 26214,
                                          32768, 39321, 45875, 58982, 65535};
  PrepareScan scan = test::scanOf(kSquare);
  scan.intensities = stored;
  scan.intensity = IntensityRange{-1, 1};
  EXPECT_EQ(keptBy(scan, Intensities{.low = -0.5, .high = 0.1}), (Numbers{3, 4, 5}));
}

TEST(Duplicates, LeaveTheFirstOfEveryPlace) {
  const std::vector<Point3f> points{{0, 0, 0}, {1, 0, 0}, {-0.0F, 0, -0.0F}, {1, 0, 0}, {1, 0, 1}};
  EXPECT_EQ(keptBy(test::scanOf(points), Duplicates{}), (Numbers{0, 1, 4}));
}

TEST(Outliers, PlantedHighAboveAreFound) {
  std::vector<Point3f> points = test::reliefWithOutliers(5000, 0, 1);
  points[1234] = {50, 50, 60};
  const Numbers kept = keptBy(test::scanOf(points), Outliers{});
  EXPECT_FALSE(std::binary_search(kept.begin(), kept.end(), 1234U));
}

TEST(Lonely, WithoutARadiusMeansFourSpacings) {
  std::vector<Point3f> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back({0.5F * static_cast<float>(i % 20), 0.5F * static_cast<float>(i / 20), 0});
  }
  points.push_back({4, 4, 1.9F});  // Within four spacings of several.
  points.push_back({4, 4, 2.1F});  // Of the one before only.
  const Numbers kept = keptBy(test::scanOf(points), Lonely{});
  EXPECT_EQ(kept.size(), 401U);
  EXPECT_EQ(kept.back(), 400U);
}

TEST(Lonely, TakesItsRadiusInMillimetres) {
  PrepareScan scan = test::scanOf(kSquare);
  scan.mm_per_unit = 1000;
  EXPECT_EQ(keptBy(scan, Lonely{.radius_mm = 1100, .neighbours = 3}), (Numbers{1, 3, 4, 5, 7}));
  EXPECT_EQ(keptBy(scan, Lonely{.radius_mm = 1.1, .neighbours = 1}), Numbers{});
}

TEST(Sparse, LeavesOutWhatIsThinBesideWhatIsDense) {
  // A lattice of 0.1, another of 1 far from it, and three points above the dense one.
  std::vector<Point3f> points;
  for (int i = 0; i < 900; ++i) {
    points.push_back({0.1F * static_cast<float>(i % 30), 0.1F * static_cast<float>(i / 30), 0});
  }
  for (int i = 0; i < 100; ++i) {
    points.push_back({100 + static_cast<float>(i % 10), static_cast<float>(i / 10), 0});
  }
  for (int i = 0; i < 3; ++i) points.push_back({1, 1, 1 + 0.3F * static_cast<float>(i)});
  const Numbers kept = keptBy(test::scanOf(points), Sparse{});
  EXPECT_EQ(kept.size(), 1000U);
  EXPECT_EQ(kept.back(), 999U);
  // Of the whole only the thin part is far from its neighbours.
  const Numbers outliers = keptBy(test::scanOf(points), Outliers{});
  EXPECT_FALSE(std::binary_search(outliers.begin(), outliers.end(), 950U));
}

/// A wave of 100 x 100 points with 0.02 of noise, and every hundredth a stray 0.6 above it.
std::vector<Point3f> waveWithNearStrays() {
  std::vector<Point3f> points;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> share(-1, 1);
  for (int i = 0; i < 10'000; ++i) {
    const float x = static_cast<float>(i % 100) + 0.3F * share(random);
    const float y = static_cast<float>(i / 100) + 0.3F * share(random);
    const float z = 3 * std::sin(0.1F * x) + 0.02F * share(random);
    points.push_back({x, y, i % 1000 == 500 ? z + 0.6F : z});
  }
  return points;
}

TEST(Sparse, LeavesOutWhatLiesOffTheSurfaceIfItIsAsked) {
  const std::vector<Point3f> points = waveWithNearStrays();
  EXPECT_EQ(keptBy(test::scanOf(points), Sparse{}).size(), 10'000U);
  const Numbers kept = keptBy(test::scanOf(points), Sparse{.off_surface = 4});
  for (std::uint32_t stray = 500; stray < 10'000; stray += 1000) {
    EXPECT_FALSE(std::binary_search(kept.begin(), kept.end(), stray)) << stray;
  }
  EXPECT_GE(kept.size(), 9982U);  // And at most 0.18 % in all.
}

TEST(Sparse, ASurfaceThatIsRoughAllOverKeepsNearlyAllItsPoints) {
  std::vector<Point3f> points;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> share(0, 1);
  for (int i = 0; i < 10'000; ++i) {
    const bool is_leaf = share(random) < 0.2F;
    points.push_back({static_cast<float>(i % 100), static_cast<float>(i / 100),
                      is_leaf ? 2 * share(random) : 0});
  }
  const std::size_t thin = keptBy(test::scanOf(points), Sparse{}).size();
  const std::size_t both = keptBy(test::scanOf(points), Sparse{.off_surface = 4}).size();
  EXPECT_LT(both, thin);
  EXPECT_GE(static_cast<double>(both), (1 - kMostOffSurface) * static_cast<double>(thin) - 1);
}

TEST(Thin, KeepsThePointNearestTheMiddleOfEveryCube) {
  const std::vector<Point3f> points = test::reliefWithOutliers(30000, 0.01, 7);
  const double side = 1.5;
  const Numbers kept = thinned(points, {}, side, {});
  std::map<std::array<int, 3>, std::pair<double, std::uint32_t>> best;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::array<int, 3> cube{};
    double off = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = static_cast<double>(points[i][axis]) / side;
      cube[axis] = static_cast<int>(std::floor(place));
      off += std::pow(place - cube[axis] - 0.5, 2);
    }
    const auto [known, is_new] = best.try_emplace(cube, off, i);
    if (!is_new && off < known->second.first - 1e-7) known->second = {off, i};
  }
  std::set<std::uint32_t> expected;
  for (const auto& [cube, point] : best) expected.insert(point.second);
  EXPECT_EQ(kept, Numbers(expected.begin(), expected.end()));
}

TEST(Thin, RefusesCubesThatCannotBeCounted) {
  const std::vector<Point3f> points{{0, 0, 0}, {1000, 0, 0}};
  EXPECT_EQ(thinned(points, {}, 1e-3, {}).size(), 2U);
  EXPECT_THROW(thinned(points, {}, 1e-4, {}), ArgumentError);
  EXPECT_THROW(thinned(points, {1e30, 0, 0}, 1e-4, {}), ArgumentError);
}

/// A bump of 20 x 20 units on a plate of 60 x 60 that is tilted.
std::vector<Point3f> bumpOnAPlate(bool upside_down) {
  std::vector<Point3f> points;
  for (int j = 0; j < 120; ++j) {
    for (int i = 0; i < 120; ++i) {
      const double x = 0.5 * i;
      const double y = 0.5 * j;
      const double r = std::hypot(x - 30, y - 30);
      double z = 0.3 * x - 0.2 * y;
      if (r < 10) z += (upside_down ? -1 : 1) * (2 + std::sqrt(100 - r * r));
      points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    }
  }
  return points;
}

TEST(Base, ThatIsCroppedLeavesTheObject) {
  const std::vector<Point3f> points = bumpOnAPlate(false);
  const PrepareAnswer answer =
      run({test::scanOf(points)}, {Base{.lay = false, .distance_mm = 0.5}});
  const Numbers kept = test::numbersOf(answer.steps[0].kept);
  std::size_t on_bump = 0;
  for (const Point3f& p : points) on_bump += std::hypot(p[0] - 30, p[1] - 30) < 10 ? 1 : 0;
  EXPECT_EQ(kept.size(), on_bump);
  EXPECT_NE(englishText(answer.steps[0].notes).find("One plane holds 91"), std::string::npos)
      << englishText(answer.steps[0].notes);
}

TEST(Base, ThatIsLaidFlatHasTheObjectAboveIt) {
  for (const bool upside_down : {false, true}) {
    const std::vector<Point3f> points = bumpOnAPlate(upside_down);
    const PrepareAnswer answer =
        run({test::scanOf(points)}, {Base{.lay = true, .distance_mm = 0.5}});
    EXPECT_EQ(answer.steps[0].after, points.size());
    ASSERT_TRUE(isRigid(answer.poses[0]));
    const auto laid = [&](std::size_t i) {
      return answer.poses[0]({static_cast<double>(points[i][0]), static_cast<double>(points[i][1]),
                              static_cast<double>(points[i][2])});
    };
    const double plate = laid(0).z;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool bump = std::hypot(points[i][0] - 30, points[i][1] - 30) < 10;
      if (bump) {
        EXPECT_GT(laid(i).z, plate + 1.5);
      } else {
        EXPECT_NEAR(laid(i).z, plate, 2e-3);
      }
    }
  }
}

TEST(Base, IsTheSameForTheSameSeed) {
  const std::vector<Point3f> points = test::reliefWithOutliers(20000, 0.05, 9);
  for (const std::uint32_t seed : {1U, 2U, 99U}) {
    const Base step{.lay = true, .distance_mm = 0.1, .seed = seed};
    EXPECT_EQ(run({test::scanOf(points)}, {step}).poses, run({test::scanOf(points)}, {step}).poses);
  }
}

TEST(Normals, PointAwayFromTheMiddleOfASphere) {
  std::vector<Point3f> points;
  for (int i = 0; i < 4000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 4000;
    const double turn = 2.399963 * i;
    const double r = std::sqrt(1 - z * z);
    points.push_back({static_cast<float>(10 * r * std::cos(turn)),
                      static_cast<float>(10 * r * std::sin(turn)), static_cast<float>(10 * z)});
  }
  const PrepareAnswer answer = run({test::scanOf(points)}, {Normals{}});
  ASSERT_EQ(answer.normals.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    float along = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      along += answer.normals[i][axis] * points[i][axis] / 10;
    }
    EXPECT_GT(along, 0.995F) << i;
  }
}

TEST(Normals, GoWithTheirPointsAndTurnWithThem) {
  const std::vector<Point3f> points = bumpOnAPlate(false);
  const PrepareAnswer answer =
      run({test::scanOf(points)}, {Normals{}, CropBox{.min = {0, 0, -100}, .max = {10, 10, 100}},
                                   Base{.lay = true, .distance_mm = 0.5}});
  ASSERT_EQ(answer.normals.size(), answer.steps.back().after);
  for (const Point3f& n : answer.normals) EXPECT_NEAR(std::abs(n[2]), 1, 1e-5);
}

TEST(Normals, OfALineAreNone) {
  std::vector<Point3f> points;
  for (int i = 0; i < 50; ++i) points.push_back({static_cast<float>(i), 0, 0});
  const PrepareAnswer answer = run({test::scanOf(points)}, {Normals{}});
  for (const Point3f& n : answer.normals) EXPECT_EQ(n, Point3f{});
  EXPECT_NE(englishText(answer.steps[0].notes).find("50 points have no normal"), std::string::npos);
}

/// Turned by a quarter about z and moved by whole units: no coordinate is rounded.
std::vector<Point3f> quarterTurned(const std::vector<Point3f>& points) {
  std::vector<Point3f> turned;
  for (const Point3f& p : points) turned.push_back({-p[1], p[0], p[2]});
  return turned;
}

TEST(Steps, CommuteWithARigidMotion) {
  std::vector<Point3f> points = test::reliefWithOutliers(20000, 0.02, 11);
  points = test::withDuplicates(points, 0.05, 12);
  const std::vector<Point3f> turned = quarterTurned(points);
  PrepareScan moved = test::scanOf(turned);
  moved.origin = {1000, -500, 64};
  const std::vector<std::pair<Step, Step>> steps{
      {CropBox{.min = {10, 20, -1}, .max = {60, 70, 9}},
       CropBox{.min = {1000 - 70, -490, 63}, .max = {1000 - 20, -440, 73}}},
      {CropOutline{.outline = {{10, 20}, {60, 20}, {35, 70}}},
       CropOutline{.outline = {{980, -490}, {980, -440}, {930, -465}}}},
      {Duplicates{}, Duplicates{}},
      {Lonely{.radius_mm = 0.9, .neighbours = 3}, Lonely{.radius_mm = 0.9, .neighbours = 3}},
      {Lonely{}, Lonely{}},
      {Outliers{}, Outliers{}},
      {Sparse{}, Sparse{}}};
  for (const auto& [step, step_of_moved] : steps) {
    // Sums of squares along other axes round in another order: a few points on the edge may differ.
    const Numbers a = keptBy(test::scanOf(points), step);
    const Numbers b = keptBy(moved, step_of_moved);
    Numbers different;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                  std::back_inserter(different));
    EXPECT_LE(different.size(), 2U) << kindOf(step);
    EXPECT_LT(a.size(), points.size()) << kindOf(step) << " removes nothing";
    EXPECT_GT(a.size(), points.size() / 10) << kindOf(step) << " removes nearly all";
  }
  // Thinning by a motion along its cubes.
  PrepareScan shifted = test::scanOf(points);
  shifted.origin = {1024, -512, 64};
  EXPECT_EQ(keptBy(shifted, Thin{.spacing_mm = 0.5}),
            keptBy(test::scanOf(points), Thin{.spacing_mm = 0.5}));
}

TEST(Steps, SeeEveryScanAloneUntilTheyAreAligned) {
  const std::vector<Point3f> left{{0, 0, 0}, {1, 0, 0}, {0.25F, 0, 0}};
  const std::vector<Point3f> right{{0, 0, 0}, {2, 0, 0}};
  const std::vector<PrepareScan> scans{test::scanOf(left), test::scanOf(right)};
  EXPECT_EQ(run(scans, {Duplicates{}}).steps[0].after, 5U);
  EXPECT_EQ(run(scans, {Align{}, Duplicates{}}).steps[1].after, 4U);
  EXPECT_EQ(run(scans, {Align{}, Thin{.spacing_mm = 0.5}}).steps[1].after, 3U);
  // Poses that were found before are used: right starts where left ends.
  Align found;
  found.poses = {Pose{}, Pose{{1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
  const PrepareAnswer moved = run(scans, {found, Duplicates{}});
  EXPECT_EQ(test::numbersOf(moved.steps[1].kept), (Numbers{0, 1, 2, 4}));
  EXPECT_EQ(moved.poses, found.poses);
  EXPECT_THROW(run({scans[0]}, {found}), ArgumentError);
}

TEST(Steps, GiveAlignWhatIsLeftAndLeaveOutWhatDoesNotHold) {
  const std::vector<Point3f> left{{0, 0, 0}, {1, 0, 0}, {9, 0, 0}};
  const std::vector<Point3f> right{{0, 0, 0}, {2, 0, 0}};
  const std::vector<PrepareScan> scans{test::scanOf(left), test::scanOf(right)};
  const AlignFunction align = [](const Align& step, std::span<const AlignScan> given, const Task&) {
    EXPECT_EQ(step.seed, 5U);
    EXPECT_EQ(given[0].points.size(), 2U);
    AlignAnswer answer;
    answer.scans.resize(2);
    answer.scans[1].holds = false;
    answer.scans[1].words = {said<MessageId::quoted>("It slides.")};
    return answer;
  };
  const PrepareAnswer answer = run(scans,
                                   {CropBox{.min = {-1, -1, -1}, .max = {5, 5, 5}},
                                    Align{.method = AlignMethod::automatic, .seed = 5}},
                                   align);
  EXPECT_EQ(test::numbersOf(answer.steps[1].kept), (Numbers{0, 1}));
  EXPECT_FALSE(answer.steps[1].done);
  EXPECT_EQ(englishText(answer.steps[1].notes), "made.ply was left out: It slides.");
  EXPECT_FALSE(run(scans, {Align{.method = AlignMethod::automatic}}).steps[0].done);
}

}  // namespace
}  // namespace relievo
