// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/prepare.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/file/owned_fd.h"
#include "core/prepare/execute.h"
#include "core/prepare/transport.h"
#include "tests/core/prepare/made_clouds.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

Scan reliefScan(std::size_t points, const std::string& file, unsigned seed = 1) {
  Scan scan;
  scan.points = test::reliefWithOutliers(points, 0.01, seed);
  test::finishScan(scan);
  scan.info.file = file;
  return scan;
}

/// Every list of a scan, each value telling the point it belongs to.
Scan fullScan() {
  Scan scan = test::latticeMesh(30, 20, 0.5, [](double x, double y) { return 0.1 * x * y; });
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const auto low = static_cast<std::uint8_t>(i % 256);
    scan.colours.push_back({low, static_cast<std::uint8_t>(i / 256), 7, 255});
    scan.intensities.push_back(static_cast<std::uint16_t>(i * 100));
    scan.classes.push_back(static_cast<std::uint8_t>(i % 3));
    scan.returns.push_back(static_cast<std::uint8_t>((1U + i % 7) | 0x70U));
    scan.parts.push_back(static_cast<std::uint8_t>(i % 2));
  }
  scan.info.intensity = IntensityRange{0, 65535};
  scan.info.parts = {{.name = "even", .points = 300, .viewpoint = {}},
                     {.name = "odd", .points = 300, .viewpoint = FilePoint{1, 2, 3}}};
  scan.textures.push_back({.cols = 1, .rows = 1, .texels = {{1, 2, 3, 255}}});
  for (std::size_t t = 0; t < scan.triangles.size(); ++t) {
    const auto u = static_cast<float>(t);
    scan.texture_corners.push_back({{{u, 0}, {u, 1}, {0, u}}});
    scan.texture_of.push_back(t % 5 == 0 ? kNoTexture : 0);
  }
  return scan;
}

Recipe recipeOf(std::vector<Step> steps) {
  return Recipe{.scans = {}, .steps = std::move(steps)};
}

TEST(Prepare, DoesInTheChildWhatItDoesHere) {
  const Scan scan = reliefScan(20000, "relief.ply");
  const std::vector<Step> steps{CropBox{.min = {10, 10, -9}, .max = {90, 90, 99}},
                                Duplicates{},
                                Outliers{},
                                Lonely{},
                                Thin{.spacing_mm = 0.5},
                                Normals{}};
  const Prepared prepared = prepare({&scan}, recipeOf(steps));
  PrepareScan here = test::scanOf(scan.points);
  const PrepareAnswer expected = execute({.steps = steps, .scans = {here}}, {}, {});
  ASSERT_EQ(prepared.answer.steps.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(prepared.answer.steps[i].kept, expected.steps[i].kept) << kindOf(steps[i]);
    EXPECT_LE(prepared.answer.steps[i].after, prepared.answer.steps[i].before);
  }
  EXPECT_EQ(prepared.answer.normals, expected.normals);
  EXPECT_EQ(prepared.answer.pcl, "1.13.0");
  EXPECT_EQ(prepared.answer.flann, "1.9.2");
  EXPECT_TRUE(prepared.notDone().empty());
  // Measured points keep their bytes.
  const auto kept = test::numbersOf(expected.steps.back().kept);
  ASSERT_EQ(prepared.scan.points.size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(std::memcmp(prepared.scan.points[i].data(), scan.points[kept[i]].data(), 12), 0);
  }
}

TEST(Prepare, ColoursIntensitiesClassesPartsAndTrianglesFollowTheirPoints) {
  const Scan scan = fullScan();
  const Scan left = prepare({&scan}, recipeOf({CropBox{.min = {0, 0, -1}, .max = {7.1, 5.2, 99}},
                                               Classes{.keep = {0, 1}}}))
                        .scan;
  const auto number = [&](std::size_t i) {
    return static_cast<std::size_t>(left.colours[i][0]) + 256U * left.colours[i][1];
  };
  ASSERT_FALSE(left.points.empty());
  for (std::size_t i = 0; i < left.points.size(); ++i) {
    const std::size_t n = number(i);
    EXPECT_EQ(left.points[i], scan.points[n]);
    EXPECT_EQ(left.intensities[i], scan.intensities[n]);
    EXPECT_EQ(left.classes[i], scan.classes[n]);
    EXPECT_EQ(left.returns[i], scan.returns[n]);
    EXPECT_EQ(left.parts[i], scan.parts[n]);
    EXPECT_NE(left.classes[i], 2);
  }
  EXPECT_EQ(left.info.parts[0].points + left.info.parts[1].points, left.points.size());
  EXPECT_EQ(left.info.parts[1].viewpoint, (FilePoint{1, 2, 3}));
  // Of the triangles exactly those with three corners left, with their pictures.
  std::size_t next = 0;
  for (std::size_t t = 0; t < scan.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    bool whole = true;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& p = scan.points[scan.triangles[t][c]];
      const auto found = std::find(left.points.begin(), left.points.end(), p);
      whole = whole && found != left.points.end();
      corners[c] = static_cast<std::uint32_t>(found - left.points.begin());
    }
    if (!whole) continue;
    ASSERT_LT(next, left.triangles.size());
    EXPECT_EQ(left.triangles[next], corners);
    EXPECT_EQ(left.texture_of[next], scan.texture_of[t]);
    if (scan.texture_of[t] != kNoTexture) {
      EXPECT_EQ(left.texture_corners[next], scan.texture_corners[t]);
    }
    ++next;
  }
  EXPECT_EQ(next, left.triangles.size());
  EXPECT_EQ(left.info.faces, next);
}

TEST(Prepare, SeveralScansAreJoinedAsStoredAndKeepTheirParts) {
  const Scan left = fullScan();
  Scan right = reliefScan(500, "right.ply");
  right.origin = {3, 0, 0};
  const Prepared joined = prepare({&left, &right}, recipeOf({Align{}}));
  ASSERT_EQ(joined.scan.points.size(), left.points.size() + right.points.size());
  ASSERT_EQ(joined.scan.info.parts.size(), 3U);
  EXPECT_EQ(joined.scan.info.parts[2].name, "right.ply");
  EXPECT_EQ(joined.scan.info.parts[2].points, 500U);
  for (std::size_t i = 0; i < right.points.size(); ++i) {
    const std::size_t at = left.points.size() + i;
    EXPECT_NEAR(joined.scan.point(at).x, right.point(i).x, 1e-5);
    EXPECT_EQ(joined.scan.point(at).z, right.point(i).z);
    EXPECT_EQ(joined.scan.parts[at], 2);
    EXPECT_EQ(joined.scan.colours[at][3], 0) << "a colour that nobody stored";
  }
  // The same without a step for it, and without a child.
  EXPECT_EQ(prepare({&left, &right}, recipeOf({})).scan.points, joined.scan.points);
}

TEST(Prepare, PosesMoveScansInDouble) {
  const Scan scan = reliefScan(1000, "a.ply");
  Scan far = scan;
  far.origin = {500000, 5400000, 100};
  Align found;
  found.poses = {Pose{}, Pose{{0, -1, 0, 5400000, 1, 0, 0, -500000, 0, 0, 1, -100, 0, 0, 0, 1}}};
  const Prepared joined = prepare({&scan, &far}, recipeOf({found}));
  for (std::size_t i = 0; i < 1000; ++i) {
    const FilePoint p = joined.scan.point(1000 + i);
    EXPECT_FLOAT_EQ(static_cast<float>(p.x), -scan.points[i][1]);
    EXPECT_FLOAT_EQ(static_cast<float>(p.y), scan.points[i][0]);
  }
}

TEST(Prepare, RefusesWhatCannotBeDoneInWords) {
  const Scan scan = reliefScan(100, "a.ply");
  Scan metres = scan;
  metres.info.unit = LengthUnit::m;
  EXPECT_THROW(prepare({&scan, &metres}, recipeOf({Align{}})), ArgumentError);
  Recipe given = recipeOf({Align{}});
  given.scans = {{.file = "a", .unit = LengthUnit::m}, {.file = "b", .unit = LengthUnit::m}};
  const Prepared same = prepare({&scan, &metres}, given);
  EXPECT_EQ(same.scan.info.unit, LengthUnit::m);
  EXPECT_THROW(prepare({&scan}, given), ArgumentError);
  EXPECT_THROW(prepare({}, recipeOf({})), ArgumentError);
  EXPECT_THROW(prepare({&scan}, recipeOf({Thin{.spacing_mm = -1}})), ArgumentError);
  EXPECT_THROW(prepare({&scan}, recipeOf({Thin{.spacing_mm = 1e-9}})), ArgumentError);
  EXPECT_THROW(prepare({&scan}, recipeOf({CropBox{.min = {500, 0, 0}, .max = {501, 1, 1}}})),
               ArgumentError);
}

TEST(Prepare, HasALimitOfMemoryAndSaysSo) {
  const Scan scan = reliefScan(400000, "a.ply");
  try {
    prepare({&scan}, recipeOf({Outliers{.neighbours = 500}}), {.max_memory_bytes = 120U << 20U});
    ADD_FAILURE() << "120 MB were enough";
  } catch (const Error& error) {
    const std::string words = error.what();
    EXPECT_TRUE(words.starts_with("The scans cannot be prepared")) << words;
  }
}

/// Processor time of the children that were waited for.
double endedChildrenCpuS() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Of those that run.
double runningChildrenCpuS() {
  double ticks = 0;
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    const std::string number = process.path().filename();
    if (number.find_first_not_of("0123456789") != std::string::npos) continue;
    std::string stat;
    std::getline(std::ifstream(process.path() / "stat"), stat);
    const std::size_t name_end = stat.rfind(')');
    if (name_end == std::string::npos) continue;
    std::istringstream fields(stat.substr(name_end + 1));
    std::string word;
    int parent = 0;
    fields >> word >> parent;
    for (int i = 0; i < 9; ++i) fields >> word;
    double user = 0, system = 0;
    fields >> user >> system;
    if (parent == ::getpid()) ticks += user + system;
  }
  return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

TEST(Prepare, StopsWithinAQuarterOfASecond) {
  const Scan scan = reliefScan(400000, "a.ply");
  const Recipe recipe = recipeOf({Outliers{.neighbours = 500}});
  std::stop_source stop;
  const double before_s = endedChildrenCpuS();
  double asked_s = 0;
  Task task{.stop = stop.get_token(), .progress = {}};
  bool working = false;
  std::chrono::steady_clock::time_point asked;
  task.progress = [&](std::string_view step, double) {
    if (step != "outliers" || working) return;
    working = true;  // The child is at it.
    asked_s = runningChildrenCpuS();
    asked = std::chrono::steady_clock::now();
    stop.request_stop();
  };
  EXPECT_THROW(prepare({&scan}, recipe, {}, task), Cancelled);
  EXPECT_TRUE(working);
  // Of the child's processor time, which a busy machine makes no longer. The bar of 250 ms is for a
  // machine that does nothing else.
  EXPECT_LT(endedChildrenCpuS() - before_s - asked_s, 2);
  // Nor does anybody wait for a child that sleeps.
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::minutes(2));
}

/// A memory file with an answer in it that may be changed.
class AnswerFile {
 public:
  AnswerFile() : file_(::memfd_create("answer", MFD_CLOEXEC)) {}
  int fd() const { return file_.get(); }
  std::string bytes() const {
    std::string all(static_cast<std::size_t>(::lseek(fd(), 0, SEEK_END)), '\0');
    EXPECT_EQ(::pread(fd(), all.data(), all.size(), 0), static_cast<ssize_t>(all.size()));
    return all;
  }
  void set(const std::string& bytes) {
    ASSERT_EQ(::ftruncate(fd(), 0), 0);
    ASSERT_EQ(::pwrite(fd(), bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }

 private:
  OwnedFd file_;
};

bool isTaken(const PrepareAnswer& answer, const PrepareJob& job) {
  const AnswerFile file;
  sendPrepareAnswer(file.fd(), answer);
  return std::holds_alternative<PrepareAnswer>(receivePrepareAnswer(file.fd(), job, {}));
}

TEST(PrepareAnswer, ThatIsNotConsistentIsNoAnswer) {
  const std::vector<Point3f> points = test::reliefWithOutliers(1000, 0.05, 1);
  const PrepareJob job{.steps = {Align{}, Outliers{}, Normals{}}, .scans = {test::scanOf(points)}};
  const PrepareAnswer good = execute(job, {}, {});
  ASSERT_TRUE(isTaken(good, job));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void(PrepareAnswer&)>>> faults{
      {"all points came back", [](auto& a) { a.steps[2].kept = PointBits(1000); }},
      {"a point that came back in place of another",
       [](auto& a) {
         PointBits& kept = a.steps[2].kept;
         std::size_t gone = 0;
         while (kept[gone]) ++gone;
         std::size_t there = 0;
         while (!kept[there]) ++there;
         kept.clear(there);
         kept.words()[gone / 64] |= std::uint64_t{1} << (gone % 64);
       }},
      {"another count", [](auto& a) { ++a.steps[1].after; }},
      {"a count that is none", [](auto& a) { a.steps[1].before = ~std::uint64_t{0}; }},
      {"bits beyond the last point", [](auto& a) { a.steps[0].kept.words().back() = ~0ULL; }},
      {"too few bits", [](auto& a) { a.steps[1].kept.words().pop_back(); }},
      {"a step more", [](auto& a) { a.steps.push_back(a.steps.back()); }},
      {"a step less", [](auto& a) { a.steps.pop_back(); }},
      {"no poses", [](auto& a) { a.poses.clear(); }},
      {"a mirror", [](auto& a) { a.poses[0].m[0] = -1; }},
      {"a scale", [](auto& a) { a.poses[0].m[0] = 1 + 1e-8; }},
      {"a pose of no number", [](auto& a) { a.poses[0].m[3] = kNan; }},
      {"a pose of infinity", [](auto& a) { a.poses[0].m[3] = 1e300; }},
      {"seconds of no number", [](auto& a) { a.steps[0].seconds = kNan; }},
      {"a residual of no number", [](auto& a) { a.align->scans[0].rms_mm = kNan; }},
      {"no verdict", [](auto& a) { a.align->scans.clear(); }},
      {"a loop of other scans",
       [](auto& a) { a.align->loops.push_back({.scans = {7}, .deg = 0, .mm = 0}); }},
      {"normals of some points", [](auto& a) { a.normals.pop_back(); }},
      {"a long normal",
       [](auto& a) {
         a.normals[5] = {3, 0, 0};
       }},
      {"a normal of no number", [](auto& a) { a.normals[5][0] = static_cast<float>(kNan); }}};
  for (const auto& [what, plant] : faults) {
    PrepareAnswer bad = good;
    plant(bad);
    EXPECT_FALSE(isTaken(bad, job)) << what;
  }
}

TEST(PrepareAnswer, OfChangedBytesIsNoneOrStillSound) {
  const std::vector<Point3f> points = test::reliefWithOutliers(300, 0.05, 1);
  const PrepareJob job{.steps = {Align{}, Outliers{}, Normals{}}, .scans = {test::scanOf(points)}};
  AnswerFile file;
  sendPrepareAnswer(file.fd(), execute(job, {}, {}));
  const std::string good = file.bytes();
  for (std::size_t size = 0; size < good.size(); ++size) {
    file.set(good.substr(0, size));
    EXPECT_FALSE(std::holds_alternative<PrepareAnswer>(receivePrepareAnswer(file.fd(), job, {})));
  }
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::string bad = good;
    for (unsigned n = 0; n <= random() % 4; ++n)
      bad[random() % bad.size()] = static_cast<char>(random());
    file.set(bad);
    const auto answer = receivePrepareAnswer(file.fd(), job, {});
    if (const auto* taken = std::get_if<PrepareAnswer>(&answer)) {
      EXPECT_EQ(taken->steps.size(), 3U);
      EXPECT_TRUE(isRigid(taken->poses.at(0)));
      EXPECT_LE(taken->steps[2].kept.count(), 300U);
    }
  }
}

TEST(PrepareJob, ArrivesAsItWasSentAndNotOtherwise) {
  const std::vector<Point3f> points = test::reliefWithOutliers(101, 0.05, 1);
  const std::vector<std::uint8_t> classes(101, 3);
  PrepareScan scan = test::scanOf(points);
  scan.classes = classes;
  const std::vector<std::uint8_t> returns(101, 0x21);
  scan.returns = returns;
  scan.origin = {0.1, 1e6, -3};
  scan.viewpoint = FilePoint{1, 2, 3};
  scan.mm_per_unit = 304.8;
  AnswerFile file;
  sendJob(file.fd(), {.steps = {Thin{.spacing_mm = 0.1}}, .scans = {scan, test::scanOf(points)}},
          {});
  const auto received = receiveJob(file.fd());
  ASSERT_TRUE(received);
  EXPECT_EQ(received->job.steps, (std::vector<Step>{Thin{.spacing_mm = 0.1}}));
  ASSERT_EQ(received->job.scans.size(), 2U);
  const PrepareScan& back = received->job.scans[0];
  EXPECT_TRUE(std::equal(back.points.begin(), back.points.end(), points.begin(), points.end()));
  EXPECT_TRUE(std::equal(back.classes.begin(), back.classes.end(), classes.begin(), classes.end()));
  EXPECT_TRUE(std::equal(back.returns.begin(), back.returns.end(), returns.begin(), returns.end()));
  EXPECT_EQ(back.origin, scan.origin);
  EXPECT_EQ(back.viewpoint, scan.viewpoint);
  EXPECT_EQ(back.mm_per_unit, scan.mm_per_unit);
  const std::string good = file.bytes();
  for (std::size_t size = 0; size < good.size(); size += 7) {
    file.set(good.substr(0, size));
    EXPECT_FALSE(receiveJob(file.fd()));
  }
}

}  // namespace
}  // namespace relievo
