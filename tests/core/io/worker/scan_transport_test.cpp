// SPDX-License-Identifier: BSD-3-Clause
// What passes between import worker and parent, and what the parent does not believe.
#include "core/io/worker/scan_transport.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include "core/file/owned_fd.h"

namespace relievo {
namespace {

Scan wholeScan() {
  Scan scan;
  scan.info.format = "test";
  scan.info.reader = "PCL 1.13.0";
  scan.info.reference_system = "EPSG:26910";
  scan.info.points = 4;
  scan.info.finite_points = 3;
  scan.info.withheld = 1;
  scan.info.bounds = FileBounds{{0, 0, 0}, {1, 1, 1}};
  scan.info.colour = ColourFact{.source = "rgb", .bits = 16, .points = 2};
  scan.info.intensity = IntensityRange{-1, 5};
  scan.info.parts = {{.name = "a", .points = 2, .viewpoint = FilePoint{1, 2, 3}},
                     {.name = "b", .points = 2, .viewpoint = std::nullopt}};
  scan.points = {{0, 0, 0}, {1, 0, 1}, {0, 1, 0}};
  scan.triangles = {{0, 1, 2}, {2, 1, 0}};
  scan.colours = {{1, 2, 3, 255}, {4, 5, 6, 255}, {}};
  scan.intensities = {0, 9, 65535};
  scan.classes = {2, 6, 2};
  scan.returns = {0x11, 0x21, 0x22};
  scan.parts = {0, 1, 1};
  scan.texture_corners = {{{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 0}, {1, 0}, {0, 1}}}};
  scan.texture_of = {1, kNoTexture};
  scan.textures = {{.cols = 1, .rows = 1, .texels = {{9, 9, 9, 255}}},
                   {.cols = 2, .rows = 1, .texels = {{1, 1, 1, 255}, {2, 2, 2, 255}}}};
  return scan;
}

WorkerAnswer passed(const Scan& scan) {
  const OwnedFd memory(::memfd_create("relievo-test", MFD_CLOEXEC));
  sendAnswer(memory.get(), scan);
  return receiveAnswer(memory.get(), {});
}

TEST(ScanTransport, EverythingArrivesAsItWas) {
  const Scan sent = wholeScan();
  const WorkerAnswer answer = passed(sent);
  const Scan* const got = std::get_if<Scan>(&answer);
  ASSERT_NE(got, nullptr);
  EXPECT_EQ(got->points, sent.points);
  EXPECT_EQ(got->triangles, sent.triangles);
  EXPECT_EQ(got->colours, sent.colours);
  EXPECT_EQ(got->intensities, sent.intensities);
  EXPECT_EQ(got->classes, sent.classes);
  EXPECT_EQ(got->returns, sent.returns);
  EXPECT_EQ(got->parts, sent.parts);
  EXPECT_EQ(got->texture_corners, sent.texture_corners);
  EXPECT_EQ(got->texture_of, sent.texture_of);
  ASSERT_EQ(got->textures.size(), 2U);
  EXPECT_EQ(got->textures[1].cols, 2U);
  EXPECT_EQ(got->textures[1].texels, sent.textures[1].texels);
  EXPECT_EQ(got->info.reader, "PCL 1.13.0");
  EXPECT_EQ(got->info.reference_system, "EPSG:26910");
  EXPECT_EQ(got->info.withheld, 1U);
  EXPECT_EQ(got->info.colour->source, "rgb");
  EXPECT_EQ(got->info.colour->bits, 16);
  EXPECT_EQ(got->info.intensity->low, -1);
  ASSERT_EQ(got->info.parts.size(), 2U);
  EXPECT_EQ(got->info.parts[0].viewpoint, (FilePoint{1, 2, 3}));
  EXPECT_EQ(got->info.parts[1].name, "b");
}

TEST(ScanTransport, AnswersThatDoNotHoldTogetherAreNotBelieved) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void(Scan&)>>> cases{
      {"a colour too few", [](Scan& s) { s.colours.pop_back(); }},
      {"an intensity too many", [](Scan& s) { s.intensities.push_back(1); }},
      {"a class too few", [](Scan& s) { s.classes.pop_back(); }},
      {"a return too many", [](Scan& s) { s.returns.push_back(0x11); }},
      {"a part too few", [](Scan& s) { s.parts.pop_back(); }},
      {"a part that is not there", [](Scan& s) { s.parts[2] = 2; }},
      {"colours of nothing", [](Scan& s) { s.info.colour.reset(); }},
      {"12 bits", [](Scan& s) { s.info.colour->bits = 12; }},
      {"intensities without a range", [](Scan& s) { s.info.intensity.reset(); }},
      {"a range without intensities", [](Scan& s) { s.intensities.clear(); }},
      {"an empty range",
       [](Scan& s) {
         s.info.intensity = IntensityRange{3, 3};
       }},
      {"a range of no number",
       [nan](Scan& s) {
         s.info.intensity = IntensityRange{static_cast<double>(nan), 3};
       }},
      {"a viewpoint nowhere",
       [nan](Scan& s) {
         s.info.parts[0].viewpoint = FilePoint{static_cast<double>(nan), 0, 0};
       }},
      {"too many parts", [](Scan& s) { s.info.parts.resize(257); }},
      {"a texture too few", [](Scan& s) { s.texture_of.pop_back(); }},
      {"a texture that is not there", [](Scan& s) { s.texture_of[1] = 2; }},
      {"a corner too few", [](Scan& s) { s.texture_corners.pop_back(); }},
      {"a corner nowhere", [nan](Scan& s) { s.texture_corners[0][1][0] = nan; }},
      {"texels too few", [](Scan& s) { s.textures[1].texels.pop_back(); }},
      {"texels too many", [](Scan& s) { s.textures[0].texels.push_back({}); }},
      {"a picture without a side", [](Scan& s) { s.textures[0].cols = 0; }},
      {"a picture too wide", [](Scan& s) { s.textures[0].cols = 16385; }},
      {"a point nowhere", [nan](Scan& s) { s.points[0][2] = nan; }}};
  for (const auto& [what, spoil] : cases) {
    Scan scan = wholeScan();
    spoil(scan);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(passed(scan))) << what;
  }
}

/// Points alone, more than are read at once.
Scan plainScan() {
  Scan scan;
  scan.info.format = "test";
  for (int i = 0; i < 50'000; ++i) scan.points.push_back({static_cast<float>(i), 1, 2});
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.bounds = FileBounds{{0, 1, 2}, {49'999, 1, 2}};
  return scan;
}

Scan withoutPoints(Scan scan) {
  scan.points.clear();
  return scan;
}

TEST(ScanTransport, PointsCanBeTakenWhileOthersAreStillMissing) {
  const Scan sent = plainScan();
  const OwnedFd memory(::memfd_create("relievo-test", MFD_CLOEXEC));
  PointsAhead ahead(memory.get());
  std::vector<std::uint64_t> told;
  PointsAnswer answer(memory.get(), [&](std::uint64_t ready) {
    told.push_back(ready);
    if (told.size() < 3) ahead.take(ready, {});
  });
  answer.expect(60'000);  // A file may promise more than it holds.
  const std::span<const std::array<float, 3>> points(sent.points);
  answer.take(points.subspan(0, 20'000));
  answer.take(points.subspan(20'000, 20'001));
  answer.take(points.subspan(40'001));
  answer.finish(withoutPoints(sent));
  EXPECT_EQ(told, (std::vector<std::uint64_t>{20'000, 40'001, 50'000}));
  const WorkerAnswer got = receiveAnswer(memory.get(), {}, std::move(ahead));
  ASSERT_TRUE(std::holds_alternative<Scan>(got));
  EXPECT_EQ(std::get<Scan>(got).points, sent.points);
  EXPECT_EQ(std::get<Scan>(got).info.finite_points, 50'000U);
}

TEST(ScanTransport, WhatIsSaidToBeReadyIsNotBelieved) {
  const Scan sent = plainScan();
  const OwnedFd memory(::memfd_create("relievo-test", MFD_CLOEXEC));
  sendAnswer(memory.get(), sent);
  for (const std::uint64_t ready : {std::uint64_t{70'000}, ~std::uint64_t{0}}) {
    PointsAhead ahead(memory.get());
    ahead.take(30'000, {});
    ahead.take(ready, {});
    const WorkerAnswer got = receiveAnswer(memory.get(), {}, std::move(ahead));
    ASSERT_TRUE(std::holds_alternative<Scan>(got));
    EXPECT_EQ(std::get<Scan>(got).points, sent.points);
  }
}

TEST(ScanTransport, PointsTakenAheadMustBeFiniteAndOfThatScan) {
  Scan bad = plainScan();
  bad.points[20'000][1] = std::numeric_limits<float>::infinity();
  const OwnedFd memory(::memfd_create("relievo-test", MFD_CLOEXEC));
  sendAnswer(memory.get(), bad);
  PointsAhead ahead(memory.get());
  ahead.take(50'000, {});
  EXPECT_TRUE(
      std::holds_alternative<std::monostate>(receiveAnswer(memory.get(), {}, std::move(ahead))));

  // More than the answer then holds: they were another one's.
  sendAnswer(memory.get(), plainScan());
  PointsAhead more(memory.get());
  more.take(50'000, {});
  Scan fewer = plainScan();
  fewer.points.assign(10, {7, 7, 7});
  fewer.info.points = fewer.info.finite_points = 10;
  sendAnswer(memory.get(), fewer);
  const WorkerAnswer got = receiveAnswer(memory.get(), {}, std::move(more));
  ASSERT_TRUE(std::holds_alternative<Scan>(got));
  EXPECT_EQ(std::get<Scan>(got).points, fewer.points);
}

TEST(ScanTransport, ARefusalAfterPointsIsARefusal) {
  const OwnedFd memory(::memfd_create("relievo-test", MFD_CLOEXEC));
  PointsAhead ahead(memory.get());
  PointsAnswer answer(memory.get(), [&](std::uint64_t ready) { ahead.take(ready, {}); });
  answer.expect(50'000);
  answer.take(plainScan().points);
  sendAnswer(memory.get(), WorkerRefusal{"Cannot read it.", ""});
  const WorkerAnswer got = receiveAnswer(memory.get(), {}, std::move(ahead));
  ASSERT_TRUE(std::holds_alternative<WorkerRefusal>(got));
  EXPECT_EQ(std::get<WorkerRefusal>(got).message, "Cannot read it.");
}

TEST(ScanTransport, DamagedBytesNeverHarmTheParent) {
  const OwnedFd memory(::memfd_create("relievo-test", MFD_CLOEXEC));
  sendAnswer(memory.get(), wholeScan());
  const auto size = static_cast<std::size_t>(::lseek(memory.get(), 0, SEEK_END));
  std::string good(size, '\0');
  ASSERT_EQ(::pread(memory.get(), good.data(), size, 0), static_cast<ssize_t>(size));
  std::mt19937_64 random(5);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = good;
    for (int change = 0; change < 1 + i % 5; ++change) {
      bytes[random() % size] = static_cast<char>(random());
    }
    if (i % 3 == 0) bytes.resize(random() % size);
    const OwnedFd file(::memfd_create("relievo-test", MFD_CLOEXEC));
    ASSERT_EQ(::pwrite(file.get(), bytes.data(), bytes.size(), 0),
              static_cast<ssize_t>(bytes.size()));
    const WorkerAnswer answer = receiveAnswer(file.get(), {});
    if (const auto* scan = std::get_if<Scan>(&answer)) {
      EXPECT_EQ(scan->points.size(), scan->info.finite_points);
      EXPECT_TRUE(scan->colours.empty() || scan->colours.size() == scan->points.size());
    }
  }
}

}  // namespace
}  // namespace relievo
