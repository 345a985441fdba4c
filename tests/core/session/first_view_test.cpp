// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/first_view.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/session/large/large_map.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

constexpr int kSide = 600;

test::Las plate() {
  test::Las las;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) las.raw.push_back({x, y, x / 30 % 2});
  }
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(las.raw.size());
  return las;
}

std::vector<FirstView> viewsOf(const std::filesystem::path& file, std::uint64_t least_points,
                               const Task& task = {}) {
  std::vector<FirstView> views;
  const FirstViewOptions options{
      .least_points = least_points,
      .on_view = [&](const FirstView& view) { views.push_back(view); },
  };
  makeFirstViews(file, {}, {}, options, task);
  return views;
}

TEST(FirstView, OfALargeCloudShowsAllOfItFromSomeOfItsPoints) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("cloud.las", test::lasFile(plate()));
  const auto views = viewsOf(file, 100'000);
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].all, std::uint64_t{kSide} * kSide);
  EXPECT_LT(views[0].used, views[0].all);
  EXPECT_GT(views[0].used, 200'000U);
  EXPECT_NEAR(views[0].surface.map.widthMm(), (kSide - 1) * 0.25, 2);
  EXPECT_NEAR(views[0].surface.map.heightExtentMm(), (kSide - 1) * 0.25, 2);
}

TEST(FirstView, OfAMapByTilesIsACoarseLevel) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("cloud.las", test::lasFile(plate()));
  SurfaceOptions options;
  options.cells = 1100;
  const LargeMap map =
      makeLargeMap(file, options, {.file = folder.path() / "map.tif", .on_view = {}});
  const auto views = viewsOf(map.file, 1);
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].all, map.frames.front().size.count());
  EXPECT_EQ(views[0].used, map.frames[1].size.count());
}

TEST(FirstView, IsNotMadeOfWhatIsReadSoonerOrCannotBeReadInParts) {
  const test::TemporaryFolder folder;
  const auto cloud = folder.write("cloud.las", test::lasFile(plate()));
  EXPECT_TRUE(viewsOf(cloud, kSide * kSide + 1).empty());
  EXPECT_TRUE(viewsOf(folder.write("points.xyz", test::textRows(20)), 1).empty());
  const auto mesh = folder.write(
      "mesh.ply", test::plyHeader("binary_little_endian", "5", "float", test::kPlyFaces) +
                      test::binaryRows<float>(5) + test::plyTriangles({0, 1, 2, 2, 3, 4}));
  EXPECT_TRUE(viewsOf(mesh, 1).empty());
}

/// The same plate, packed.
test::Laz packedPlate(int format) {
  test::Laz laz;
  laz.how.format = format;
  const test::Las plain = plate();
  for (const auto& point : plain.raw) {
    std::string record;
    for (const std::int32_t stored : point) record += test::bytesOf(stored);
    record.resize(format == 6 ? 30 : 20, '\0');
    record[14] = '\x11';
    laz.records.push_back(record);
  }
  laz.scale = plain.scale[0];
  return laz;
}

TEST(FirstView, OfALazFileIsTheBeginningOfEachChunk) {
  const test::TemporaryFolder folder;
  test::Laz laz = packedPlate(0);
  laz.chunk_points = 1000;
  const auto views = viewsOf(folder.write("cloud.laz", test::lazFile(laz).bytes), 1);
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].all, laz.records.size());
  EXPECT_EQ(views[0].used, 360U * (250'000 / 360));
  EXPECT_NEAR(views[0].surface.map.widthMm(), (kSide - 1) * 0.25, 2);
}

TEST(FirstView, OfACopcFileIsItsCoarsestLevels) {
  const test::TemporaryFolder folder;
  test::Laz laz = packedPlate(6);
  const test::Records fine = laz.records;
  test::Records coarse;
  for (std::size_t i = 0; i < fine.size(); i += 7) coarse.push_back(fine[i]);
  laz.records = coarse;
  laz.records.insert(laz.records.end(), fine.begin(), fine.end());
  laz.chunks = {coarse.size(), fine.size()};
  laz.levels = {0, 1};
  laz.chunk_points = ~std::uint32_t{0};
  const auto views = viewsOf(folder.write("cloud.copc.laz", test::lazFile(laz).bytes), 1);
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].used, coarse.size());
  EXPECT_EQ(views[0].all, laz.records.size());
  EXPECT_FALSE(views[0].surface.map.heights_mm.empty());
}

TEST(FirstView, LeavesFaultsForTheReaderToSay) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(viewsOf(folder.path() / "absent.las", 1).empty());
  test::Las cut = plate();
  cut.promised = cut.legacy_promised = 2 * cut.legacy_promised;
  EXPECT_TRUE(viewsOf(folder.write("cut.las", test::lasFile(cut)), 1).empty());
}

TEST(FirstView, StopsWhenAsked) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("cloud.las", test::lasFile(plate()));
  std::stop_source stop;
  stop.request_stop();
  Task task;
  task.stop = stop.get_token();
  EXPECT_THROW(viewsOf(file, 1, task), Cancelled);
}

}  // namespace
}  // namespace relievo
