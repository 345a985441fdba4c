// SPDX-License-Identifier: BSD-3-Clause
// Parts of objects whose truth is known are laid on each other again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <stop_token>

#include "core/io/read_scan.h"
#include "core/message/message.h"
#include "core/prepare/align/align_picks.h"
#include "core/prepare/align/align_scans.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/prepare/align_bound.h"
#include "tests/core/prepare/align_objects.h"

namespace relievo::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kMostDegrees = 0.05;
constexpr double kMostSpacings = 0.5;

/// The reference, and a part three times as coarse that stands elsewhere.
std::vector<Part> twoHalves(const MadeObject& object, double deg, double common = 0.4,
                            FilePoint origin = {}) {
  const Pose away = motion(deg, {0.3, 0.8, -0.5}, {40 + origin.x, origin.y - 25, 60 + origin.z});
  return {makePart(object, {half(object, true, common), 24000, 0.05, {}, {}, 11}),
          makePart(object, {half(object, false, common), 8000, 0.05, away, origin, 22})};
}

std::vector<AlignScan> scansOf(const std::vector<Part>& parts) {
  std::vector<AlignScan> scans;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    scans.push_back(parts[i].scan("part " + std::to_string(i + 1)));
  }
  return scans;
}

Align byPicks(const MadeObject& object, const std::vector<Part>& parts) {
  Align how{.method = AlignMethod::points};
  for (std::uint32_t s = 1; s < parts.size(); ++s) {
    for (const PickedPair& pair : picksOn(parts[s], parts[0], s, 0.01 * object.diagonal, s)) {
      how.pairs.push_back(pair);
    }
  }
  return how;
}

Align automatically(std::uint32_t seed = 1) {
  return {.method = AlignMethod::automatic, .seed = seed};
}

void expectRight(const AlignAnswer& answer, const std::vector<Part>& parts) {
  ASSERT_EQ(answer.scans.size(), parts.size());
  EXPECT_EQ(answer.scans[0].pose, Pose{});
  for (std::size_t s = 1; s < parts.size(); ++s) {
    SCOPED_TRACE("part " + std::to_string(s + 1) + ": " + englishText(answer.scans[s].words));
    const double spacing = std::max(medianSpacing(parts[0]), medianSpacing(parts[s]));
    const PoseError error = errorOf(answer.scans[s].pose, parts[s], parts[0]);
    EXPECT_TRUE(answer.scans[s].holds);
    EXPECT_TRUE(isRigid(answer.scans[s].pose));
    EXPECT_LE(error.deg, kMostDegrees);
    EXPECT_LE(error.mm, kMostSpacings * spacing);
  }
}

/// Greatest difference of two poses where an object of 200 mm stands.
double apart(const Pose& a, const Pose& b) {
  double most = 0;
  for (const double x : {-100.0, 100.0}) {
    for (const double y : {-100.0, 100.0}) {
      for (const double z : {-100.0, 100.0}) {
        most = std::max(most, norm(a({x, y, z}) - b({x, y, z})));
      }
    }
  }
  return most;
}

Pose product(const Pose& a, const Pose& b) {
  Pose p;
  const FilePoint shift = a(b(FilePoint{}));
  const std::array<FilePoint, 3> axes{a(b(FilePoint{1, 0, 0})) - shift,
                                      a(b(FilePoint{0, 1, 0})) - shift,
                                      a(b(FilePoint{0, 0, 1})) - shift};
  for (std::size_t j = 0; j < 3; ++j) {
    p.m[j] = axes[j].x;
    p.m[4 + j] = axes[j].y;
    p.m[8 + j] = axes[j].z;
  }
  p.m[3] = shift.x;
  p.m[7] = shift.y;
  p.m[11] = shift.z;
  return p;
}

TEST(Align, TwoPartsFromThreeRoughPicksLieWhereTheyBelong) {
  const MadeObject object = gargoyle();
  const std::vector<Part> parts = twoHalves(object, 60);
  const AlignAnswer answer = alignScans(byPicks(object, parts), scansOf(parts), {});
  expectRight(answer, parts);
  EXPECT_THAT(englishText(answer.scans[1].words), HasSubstr("in common"));
  // A half that has 40 % of the length in common has less of its surface there.
  EXPECT_GT(answer.scans[1].share, 0.3);
  EXPECT_LT(answer.scans[1].share, 0.8);
  EXPECT_GT(answer.scans[1].rms_mm, 0.03);
  EXPECT_LT(answer.scans[1].uncertainty_mm, 0.2);
}

TEST(Align, TwoPartsAreFoundAutomaticallyFromSixtyDegreesAway) {
  const std::vector<Part> parts = twoHalves(gargoyle(), 60, 0.6);
  expectRight(alignScans(automatically(), scansOf(parts), {}), parts);
}

TEST(Align, SeedsChangeNothingThatIsAccepted) {
  const std::vector<Part> parts = twoHalves(gargoyle(), 60, 0.6);
  const AlignAnswer one = alignScans(automatically(1), scansOf(parts), {});
  const AlignAnswer same = alignScans(automatically(1), scansOf(parts), {});
  const AlignAnswer other = alignScans(automatically(2), scansOf(parts), {});
  EXPECT_EQ(one.scans[1].pose, same.scans[1].pose) << "the same seed, other numbers";
  EXPECT_LE(errorOf(one.scans[1].pose, parts[1], parts[0]).deg, kMostDegrees);
  EXPECT_LE(errorOf(other.scans[1].pose, parts[1], parts[0]).deg, kMostDegrees);
}

TEST(Align, IdentityStaysIdentity) {
  const MadeObject object = gargoyle();
  const Part part = makePart(object, {{}, 8000, 0.05, {}, {}, 3});
  const std::vector<AlignScan> scans{part.scan("one"), part.scan("the same")};
  const AlignAnswer answer = alignScans({.method = AlignMethod::stored}, scans, {});
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(answer.scans[1].pose.m[i], Pose{}.m[i], 1e-6);
  }
  EXPECT_GT(answer.scans[1].tight_share, 0.99);
}

TEST(Align, SwappingTheScansInvertsThePose) {
  const MadeObject object = gargoyle();
  const std::vector<Part> parts{
      makePart(object, {half(object, true), 12000, 0.05, {}, {}, 5}),
      makePart(object, {half(object, false), 8000, 0.05, motion(4, {1, 2, 3}, {2, -3, 1}), {}, 6})};
  std::vector<AlignScan> scans = scansOf(parts);
  const Pose forth = alignScans({.method = AlignMethod::stored}, scans, {}).scans[1].pose;
  std::swap(scans[0], scans[1]);
  const Pose back = alignScans({.method = AlignMethod::stored}, scans, {}).scans[1].pose;
  EXPECT_LE(apart(product(forth, back), Pose{}), 0.05);
}

TEST(Align, ProjectedCoordinatesLoseNothing) {
  const MadeObject object = gargoyle();
  const FilePoint site{512345.25, 5412345.5, 310.125};
  const std::vector<Part> parts = twoHalves(object, 40, 0.4, site);
  expectRight(alignScans(byPicks(object, parts), scansOf(parts), {}), parts);
}

TEST(Align, APlateIsRefusedAutomaticallyAndStaysWherePicksPutIt) {
  const MadeObject plate = relief(0);
  const std::vector<Part> parts = twoHalves(plate, 60, 0.6);
  const AlignAnswer found = alignScans(automatically(), scansOf(parts), {});
  EXPECT_FALSE(found.scans[1].holds);
  EXPECT_THAT(englishText(found.scans[1].words), HasSubstr("nothing in its shape"));

  const Align picks = byPicks(plate, parts);
  const AlignAnswer placed = alignScans(picks, scansOf(parts), {});
  const AlignVerdict& verdict = placed.scans[1];
  EXPECT_TRUE(verdict.holds);
  EXPECT_THAT(englishText(verdict.words), HasSubstr("placed by hand"));
  EXPECT_LT(verdict.stability, 1e-4);
  // It lies in the other's plane, and has not slid away in it.
  const PoseError error = errorOf(verdict.pose, parts[1], parts[0]);
  EXPECT_LT(error.mm, 0.01 * plate.diagonal);
  const FilePoint up = verdict.pose(parts[1].object_from_part.inverseOfSimilarity()({50, 40, 0}));
  EXPECT_NEAR(up.z, 0, 0.02);
}

TEST(Align, AReliefHoldsAsFarAsItsHeightSays) {
  const MadeObject object = relief(3);
  const std::vector<Part> parts = twoHalves(object, 60, 0.6);
  const AlignAnswer answer = alignScans(byPicks(object, parts), scansOf(parts), {});
  expectRight(answer, parts);
  const MadeObject low = relief(1);
  const std::vector<Part> low_parts = twoHalves(low, 60, 0.6);
  const AlignVerdict verdict = alignScans(byPicks(low, low_parts), scansOf(low_parts), {}).scans[1];
  EXPECT_TRUE(verdict.holds);
  EXPECT_LT(verdict.stability, answer.scans[1].stability);
  EXPECT_GT(verdict.uncertainty_mm, answer.scans[1].uncertainty_mm);
  EXPECT_LE(errorOf(verdict.pose, low_parts[1], low_parts[0]).mm, 2 * verdict.uncertainty_mm);
}

TEST(Align, AWeakReliefLiesAsNearAsItsNoiseAllows) {
  const MadeObject object = relief(1);
  const std::vector<Part> parts{
      makePart(object, {half(object, true, 0.6), 60'000, 0.05, {}, {}, 11}),
      makePart(object,
               {half(object, false, 0.6), 20'000, 0.05, motion(60, {0.4, 0.5, 0.5}, {}), {}, 21})};
  const AlignAnswer answer = alignScans(byPicks(object, parts), scansOf(parts), {});
  ASSERT_TRUE(answer.scans[1].holds) << englishText(answer.scans[1].words);
  EXPECT_THAT(englishText(answer.scans[1].words), HasSubstr("Weak"));
  const PoseError bound = poseBound(object, parts[1], parts[0], 0.05);
  EXPECT_GT(bound.deg, 0.01);
  const PoseError error = errorOf(answer.scans[1].pose, parts[1], parts[0]);
  EXPECT_LT(error.deg, 2.5 * bound.deg);
  EXPECT_LT(error.mm, 2.5 * bound.mm);
}

TEST(Align, AnotherObjectIsRefused) {
  const MadeObject body = gargoyle();
  const Part one = makePart(body, {half(body, true, 0.4), 12000, 0.05, {}, {}, 7});
  const Part other = makePart(relief(12), {{}, 8000, 0.05, {}, {}, 8});
  const std::vector<AlignScan> scans{one.scan("bust"), other.scan("panel")};
  const AlignVerdict verdict = alignScans(automatically(), scans, {}).scans[1];
  EXPECT_FALSE(verdict.holds) << englishText(verdict.words);
  EXPECT_THAT(englishText(verdict.words), HasSubstr("Not aligned"));
}

/// Four quarters of an object, each moved elsewhere; every second one has half the points.
std::vector<Part> fourQuarters(const MadeObject& object, std::size_t points, std::uint64_t seed) {
  std::vector<Part> parts;
  for (int n = 0; n < 4; ++n) {
    const Pose away = n == 0 ? Pose{} : motion(25.0 * n, {1, 0.5, 0.2 * n}, {30.0 * n, 10, -20});
    parts.push_back(makePart(object, {quarter(object, n),
                                      n % 2 == 0 ? points : points / 2,
                                      0.05,
                                      away,
                                      {},
                                      seed + static_cast<std::uint64_t>(n)}));
  }
  return parts;
}

TEST(Align, FourPartsCloseTheirLoop) {
  const MadeObject object = gargoyle();
  const std::vector<Part> parts = fourQuarters(object, 16000, 30);
  const AlignAnswer answer = alignScans(byPicks(object, parts), scansOf(parts), {});
  expectRight(answer, parts);
  ASSERT_EQ(answer.loops.size(), 1U);
  EXPECT_EQ(answer.loops[0].scans.size(), 4U);
  EXPECT_LT(answer.loops[0].mm, 0.3);
  EXPECT_THAT(englishText(answer.scans[2].words), Not(HasSubstr("lies elsewhere")));
}

TEST(Align, FourPartsOfASlenderFigureLieAsNearAsAllTheirPointsTell) {
  const MadeObject object = column();
  const std::vector<Part> parts = fourQuarters(object, 20000, 20);
  const AlignAnswer answer = alignScans(byPicks(object, parts), scansOf(parts), {});
  for (std::size_t s = 1; s < parts.size(); ++s) {
    ASSERT_TRUE(answer.scans[s].holds) << englishText(answer.scans[s].words);
    EXPECT_LT(answer.scans[s].stability, 0.03);
    // At 2.5 spacings the worst of them is turned by 0.0496.
    EXPECT_LT(errorOf(answer.scans[s].pose, parts[s], parts[0]).deg, 0.035);
  }
}

TEST(Align, CancelEndsIt) {
  const MadeObject object = gargoyle();
  const std::vector<Part> parts = twoHalves(object, 60);
  std::stop_source stop;
  Task task;
  task.stop = stop.get_token();
  task.progress = [&](std::string_view step, double) {
    if (step == "Laying the scans on each other") stop.request_stop();
  };
  EXPECT_THROW(static_cast<void>(alignScans(byPicks(object, parts), scansOf(parts), task)),
               Cancelled);
}

std::string refusalOf(const Align& how, const std::vector<AlignScan>& scans) {
  try {
    static_cast<void>(alignScans(how, scans, {}));
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

TEST(Align, WhatCannotBeAlignedIsSaid) {
  const MadeObject object = gargoyle();
  const Part part = makePart(object, {{}, 2000, 0.05, {}, {}, 3});
  const Part small = makePart(object, {{}, 99, 0.05, {}, {}, 3});
  Part heap = part;
  for (auto& p : heap.points) p = heap.points[0];
  EXPECT_THAT(refusalOf(automatically(), {part.scan("one")}), HasSubstr("two scans or more"));
  EXPECT_THAT(refusalOf(automatically(), {part.scan("one"), small.scan("shard")}),
              HasSubstr("shard: 99 different points"));
  EXPECT_THAT(refusalOf(automatically(), {part.scan("one"), heap.scan("heap")}),
              HasSubstr("heap: 1 different point;"));
  AlignScan inches = part.scan("inches");
  inches.mm_per_unit = 25.4;
  EXPECT_THAT(refusalOf(automatically(), {part.scan("one"), inches}),
              HasSubstr("inches has another unit"));
  Align how{.method = AlignMethod::points};
  EXPECT_THAT(refusalOf(how, {part.scan("one"), part.scan("two")}),
              HasSubstr("two: 0 picked pairs"));
  how.pairs = {{.scan = 0, .point = {}, .reference = {}}};
  EXPECT_THAT(refusalOf(how, {part.scan("one"), part.scan("two")}),
              HasSubstr("names scan 1, which is the reference"));
  how.pairs = {{.scan = 2, .point = {}, .reference = {}}};
  EXPECT_THAT(refusalOf(how, {part.scan("one"), part.scan("two")}), HasSubstr("names scan 3"));
}

std::vector<PickedPair> pairs(const std::vector<FilePoint>& scan,
                              const std::vector<FilePoint>& reference) {
  std::vector<PickedPair> picks;
  for (std::size_t i = 0; i < scan.size(); ++i) picks.push_back({1, scan[i], reference[i]});
  return picks;
}

std::string pickRefusal(const std::vector<PickedPair>& picks) {
  try {
    static_cast<void>(align::fitPicks(picks, "left.ply"));
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

TEST(AlignPicks, ThreePairsSayThePoseExactly) {
  const Pose truth = motion(77, {1, -2, 0.5}, {510000, 5400000, 20});
  const std::vector<FilePoint> scan{{0, 0, 0}, {90, 5, 2}, {10, 70, -8}};
  std::vector<FilePoint> reference;
  for (const FilePoint& p : scan) reference.push_back(truth(p));
  const align::PickedFit fit = align::fitPicks(pairs(scan, reference), "left.ply");
  EXPECT_LT(norm(fit.pose({50, 50, 50}) - truth({50, 50, 50})), 1e-6);
  EXPECT_LT(fit.error, 1e-6);
  EXPECT_TRUE(isRigid(fit.pose));
}

TEST(AlignPicks, ThePairThatWasPickedWrongHasTheLargestError) {
  const Pose truth = motion(77, {1, -2, 0.5}, {510000, 5400000, 20});
  const std::vector<FilePoint> scan{{0, 0, 0}, {90, 5, 2}, {10, 70, -8}, {80, 75, 20}, {40, 30, 9}};
  std::vector<FilePoint> reference;
  for (const FilePoint& p : scan) reference.push_back(truth(p));
  for (const double error : align::fitPicks(pairs(scan, reference), "left.ply").errors) {
    EXPECT_LT(error, 1e-6);
  }
  reference[3] = reference[3] + FilePoint{0, 0, 6};
  const align::PickedFit fit = align::fitPicks(pairs(scan, reference), "left.ply");
  ASSERT_EQ(fit.errors.size(), 5U);
  const auto worst = std::max_element(fit.errors.begin(), fit.errors.end());
  EXPECT_EQ(worst - fit.errors.begin(), 3);
  EXPECT_GT(*worst, 1.5);
  EXPECT_LT(*worst, 6) << "the others give way";
  double squares = 0;
  for (const double error : fit.errors) squares += error * error;
  EXPECT_NEAR(fit.error, std::sqrt(squares / 5), 1e-12);
}

TEST(AlignPicks, NearlyInOneLineIsRefusedAndNeverAMirror) {
  const std::vector<FilePoint> line{{0, 0, 0}, {50, 0, 0}, {100, 0, 0}};
  EXPECT_THAT(pickRefusal(pairs(line, line)), HasSubstr("nearly in one line"));
  // 4 degrees at one corner, then 6.
  const std::vector<FilePoint> flat{{0, 0, 0}, {100, 0, 0}, {50, 3.49, 0}};
  EXPECT_THAT(pickRefusal(pairs(flat, flat)), HasSubstr("nearly in one line"));
  const std::vector<FilePoint> wide{{0, 0, 0}, {100, 0, 0}, {50, 5.26, 0}};
  EXPECT_EQ(pickRefusal(pairs(wide, wide)), "");
  const std::vector<FilePoint> one{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}};
  EXPECT_THAT(pickRefusal(pairs(one, one)), HasSubstr("nearly in one line"));
  // Four places and their mirror image: the nearest turn comes back, or a refusal; no mirror.
  const std::vector<FilePoint> body{{0, 0, 0}, {60, 0, 0}, {0, 60, 0}, {0, 0, 60}};
  std::vector<FilePoint> mirror = body;
  for (FilePoint& p : mirror) p.z = -p.z;
  EXPECT_TRUE(isRigid(align::fitPicks(pairs(body, mirror), "left.ply").pose));
}

TEST(AlignPicks, ScansOfDifferentSizeAreRefused) {
  const std::vector<FilePoint> scan{{0, 0, 0}, {90, 5, 2}, {10, 70, -8}};
  std::vector<FilePoint> metres;
  for (const FilePoint& p : scan) metres.push_back(0.001 * p);
  EXPECT_THAT(pickRefusal(pairs(scan, metres)), HasSubstr("in the same unit"));
  EXPECT_THAT(pickRefusal({}), HasSubstr("three or more"));
}

// Also what finds a ladder of distances without its last step: 0.064 to 0.072 degrees are left.
TEST(AlignShared, RealObjectsInTwoParts) {
  const std::filesystem::path folder = sharedData();
  if (folder.empty()) GTEST_SKIP() << "The shared scans are not there.";
  for (const char* name :
       {"obj/stanford-bunny.obj", "obj/armadillo.obj", "obj/demosthenes-low-res.obj"}) {
    SCOPED_TRACE(name);
    const MadeObject object = meshObject(readScanHere(folder / name, {}, {}, {}), name);
    const std::vector<Part> parts = twoHalves(object, 60);
    expectRight(alignScans(byPicks(object, parts), scansOf(parts), {}), parts);
  }
}

}  // namespace
}  // namespace relievo::test
