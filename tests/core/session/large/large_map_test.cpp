// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/large_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/depth/rules/rasterize.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "core/session/large/tiled_surface.h"
#include "core/tiles/tile_raster.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/scan_fixtures.h"
#include "tests/core/session/tiled_fixture.h"

namespace relievo {
namespace {

constexpr double kScale = 1.0 / 512;  // Exact in float and double, as are all sums below.

/// A relief of 2000 x 2000 cells of 1/4 mm with a hole, as stored whole numbers of 1/512 mm.
test::Las bigLas(int points) {
  std::mt19937 random(2000);
  std::uniform_int_distribution<int> place(0, 1999 * 128);
  test::Las las;
  las.scale = {kScale, kScale, kScale};
  // The corners fix the frame.
  las.raw = {{0, 0, 0}, {1999 * 128, 1999 * 128, 0}};
  while (static_cast<int>(las.raw.size()) < points) {
    const int x = place(random);
    const int y = place(random);
    const double u = x * kScale;
    const double v = y * kScale;
    if (std::hypot(u - 300, v - 200) < 20) continue;
    const double z = 10 + 3 * std::sin(u / 17) * std::cos(v / 23);
    las.raw.push_back({x, y, static_cast<int>(std::lround(z / kScale))});
  }
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(las.raw.size());
  return las;
}

void writeLas(const std::filesystem::path& file, const test::Las& las) {
  std::ofstream(file, std::ios::binary) << test::lasFile(las);
}

Scan scanOf(const test::Las& las) {
  Scan scan;
  for (const auto& raw : las.raw) {
    scan.points.push_back({static_cast<float>(raw[0] * kScale), static_cast<float>(raw[1] * kScale),
                           static_cast<float>(raw[2] * kScale)});
  }
  test::finishScan(scan);
  return scan;
}

constexpr std::uint64_t kTinyBudget = 165'000'000;  // 13 MB for 48 MB of points.

std::string bytesOfFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(LargeMap, GivesTheBytesOfTheMapInMemory) {
  const test::TileFolder folder;
  const test::Las las = bigLas(3'000'000);
  writeLas(folder / "scan.las", las);
  const SurfaceOptions options = test::topOptions(PointRule::median);
  const LargeMap large = makeLargeMap(
      folder / "scan.las", options,
      {.file = folder / "map.tif", .memory_bytes = kTinyBudget, .threads = 2, .on_view = {}});
  EXPECT_GT(large.spilled_bytes, 10'000'000U);
  const Surface whole = makeSurface(scanOf(las), options, rasterize);

  ASSERT_EQ(large.frames.size(), whole.pyramid.levels.size());
  EXPECT_EQ(large.frames[0], whole.map.frame);
  EXPECT_EQ(large.view_from_file, whole.view_from_file);
  EXPECT_EQ(large.rule, whole.rule);
  ASSERT_EQ(large.holes.size(), whole.holes.size());
  ASSERT_FALSE(whole.holes.empty());
  EXPECT_EQ(large.holes[0].cells, whole.holes[0].cells);
  EXPECT_EQ(large.shares, originShares(whole.map));
  const TiledMap tiled(folder / "map.tif");
  for (std::size_t l = 0; l < whole.pyramid.levels.size(); ++l) {
    EXPECT_TRUE(std::ranges::equal(tiled.levelMap({static_cast<int>(l)}).heights_mm,
                                   whole.pyramid.levels[l].heights_mm))
        << "level " << l;
  }
  EXPECT_EQ(tiled.levelMap({0}).origins, whole.map.origins);
}

/// Rules that weigh points by their place. A tile keeps places as floats, to some 1/30 000 of a
/// cell; the whole map has them from the file. So weights differ that much, and heights by less
/// than a thousandth of a millimetre on this relief (docs/adr/0037).
class LargeMapRule : public ::testing::TestWithParam<PointRule> {};

TEST_P(LargeMapRule, GivesTheHeightsOfTheMapInMemory) {
  const test::TileFolder folder;
  const test::Las las = bigLas(1'500'000);
  writeLas(folder / "scan.las", las);
  SurfaceOptions options = test::topOptions(GetParam());
  options.spacing_mm = 0.5;
  const LargeMap large = makeLargeMap(
      folder / "scan.las", options,
      {.file = folder / "map.tif", .memory_bytes = kTinyBudget, .threads = 2, .on_view = {}});
  EXPECT_GT(large.spilled_bytes, 1'000'000U);
  const Surface whole = makeSurface(scanOf(las), options, rasterize);
  const DepthMap tiled = TiledMap(folder / "map.tif").levelMap({0});
  ASSERT_EQ(tiled.heights_mm.size(), whole.map.heights_mm.size());
  std::size_t other_heights = 0;
  float furthest = 0;
  for (std::size_t i = 0; i < tiled.heights_mm.size(); ++i) {
    other_heights += tiled.heights_mm[i] == whole.map.heights_mm[i] ? 0 : 1;
    furthest = std::max(furthest, std::abs(tiled.heights_mm[i] - whole.map.heights_mm[i]));
  }
  EXPECT_TRUE(tiled.origins == whole.map.origins);
  EXPECT_LT(furthest, 1e-3F);
  EXPECT_LT(other_heights, tiled.heights_mm.size() / 10);
}
INSTANTIATE_TEST_SUITE_P(NotMerging, LargeMapRule,
                         ::testing::Values(PointRule::splat, PointRule::quadratic),
                         [](const auto& rule) {
                           return rule.param == PointRule::splat ? "Splat" : "Quadratic";
                         });

std::vector<std::string> textsOf(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(englishText(message));
  return texts;
}

TEST(LargeMap, LosesWhatTheMapInMemoryLosesAndSaysSo) {
  const test::TileFolder folder;
  test::Las las = bigLas(600'000);
  for (std::size_t i = 2; i < las.raw.size(); ++i) {
    if (i % 3 == 0) las.raw[i][2] -= 20'000;      // A back, 39 mm below.
    if (i % 5'000 == 1) las.raw[i][2] += 30'000;  // A outlier.
  }
  writeLas(folder / "scan.las", las);
  SurfaceOptions options = test::topOptions(PointRule::front);
  options.rule.reset();
  options.spacing_mm = 1;
  options.holes = {.rule = HoleRule::interpolate, .max_area_mm2 = 5};  // The hole is larger.
  const LargeMap large = makeLargeMap(
      folder / "scan.las", options,
      {.file = folder / "map.tif", .memory_bytes = kTinyBudget, .threads = 2, .on_view = {}});
  const Surface whole = makeSurface(scanOf(las), options, rasterize);
  EXPECT_EQ(large.rule, whole.rule);
  ASSERT_TRUE(large.losses && whole.losses);
  EXPECT_GT(whole.losses->hidden_share, 0.2);
  EXPECT_GT(whole.losses->outliers, 50U);
  EXPECT_EQ(large.losses->hidden_share, whole.losses->hidden_share);
  EXPECT_EQ(large.losses->undercut_share, whole.losses->undercut_share);
  EXPECT_EQ(large.losses->steep_share, whole.losses->steep_share);
  EXPECT_EQ(large.losses->outliers, whole.losses->outliers);
  EXPECT_EQ(textsOf(large.not_done), textsOf(whole.not_done));
  EXPECT_FALSE(whole.not_done.empty());
  for (const std::string& message : textsOf(whole.messages)) {
    EXPECT_THAT(textsOf(large.messages), ::testing::Contains(message));
  }
  options.rule = PointRule::mean;  // Points merged as they come: only those in front come.
  const LargeMap merged = makeLargeMap(
      folder / "scan.las", options,
      {.file = folder / "merged.tif", .memory_bytes = kTinyBudget, .threads = 2, .on_view = {}});
  ASSERT_TRUE(merged.losses);
  EXPECT_NEAR(merged.losses->hidden_share, 1.0 / 3, 0.01);
  // But for bays at the border, where chance leaves the back open.
  const std::vector<float> merged_mm = TiledMap(folder / "merged.tif").levelMap({0}).heights_mm;
  const auto deep = std::count_if(merged_mm.begin(), merged_mm.end(),
                                  [&](float z) { return z < merged.heights.max_mm - 20; });
  EXPECT_LT(static_cast<double>(deep), 0.002 * static_cast<double>(merged_mm.size()));
}

TEST(LargeMap, GivesTheSameFilesForEveryBudgetAndNumberOfThreads) {
  const test::TileFolder folder;
  writeLas(folder / "scan.las", bigLas(2'500'000));
  const SurfaceOptions options = test::topOptions(PointRule::mean);
  for (const auto& [name, budget, threads] :
       {std::tuple{"a.tif", kTinyBudget, 1}, std::tuple{"b.tif", std::uint64_t{900'000'000}, 2}}) {
    makeLargeMap(
        folder / "scan.las", options,
        {.file = folder / name, .memory_bytes = budget, .threads = threads, .on_view = {}});
  }
  for (const char* end : {".tif", ".origin.tif", ".L1.tif", ".L3.tif", ".L3.origin.tif"}) {
    EXPECT_EQ(bytesOfFile(folder / (std::string("a") + end)),
              bytesOfFile(folder / (std::string("b") + end)))
        << end;
  }
}

TEST(LargeMap, GivesTheBytesOfTheLasForALazOfTheSamePoints) {
  const test::TileFolder folder;
  const test::Las las = bigLas(60'000);
  test::Laz laz;
  for (const auto& point : las.raw) {
    std::string record;
    for (const std::int32_t stored : point) record += test::bytesOf(stored);
    laz.records.push_back(record + std::string(8, '\x11'));
  }
  laz.scale = kScale;
  laz.chunk_points = 5000;
  writeLas(folder / "plain.las", las);
  std::ofstream(folder / "packed.laz", std::ios::binary) << test::lazFile(laz).bytes;
  SurfaceOptions options = test::topOptions(PointRule::mean);
  options.spacing_mm = 2;
  for (const char* const name : {"plain.las", "packed.laz"}) {
    makeLargeMap(folder / name, options,
                 {.file = folder / (std::string(name) + ".tif"),
                  .memory_bytes = 400'000'000,
                  .threads = 3,
                  .on_view = {}});
  }
  const std::string bytes = bytesOfFile(folder / "plain.las.tif");
  EXPECT_GT(bytes.size(), 10'000U);
  EXPECT_TRUE(bytes == bytesOfFile(folder / "packed.laz.tif"));
}

TEST(LargeMap, TakesRastersWithHoles) {
  const test::TileFolder folder;
  DepthMap map;
  map.frame = {.size = {.cols = 1300, .rows = 1100},
               .spacing_mm = 0.5,
               .first_x_mm = 0.25,
               .first_y_mm = 0.25};
  for (int row = 0; row < map.frame.size.rows; ++row) {
    for (int col = 0; col < map.frame.size.cols; ++col) {
      const bool hole = std::hypot(col - 600, row - 500) < 60;
      map.heights_mm.push_back(hole ? 0 : 3 + std::sin(static_cast<float>(col) / 30));
      map.origins.push_back(hole ? CellStatus::base_plane : CellStatus::measured);
    }
  }
  writeMap(folder / "own.tif", map, {.view_from_file = {}});
  const LargeMap large =
      makeLargeMap(folder / "own.tif", {}, {.file = folder / "out.tif", .on_view = {}});
  const Pyramid pyramid = buildPyramid(map);
  const TiledMap tiled(folder / "out.tif");
  ASSERT_EQ(large.frames.size(), pyramid.levels.size());
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    EXPECT_TRUE(std::ranges::equal(tiled.levelMap({static_cast<int>(l)}).heights_mm,
                                   pyramid.levels[l].heights_mm));
  }
  EXPECT_EQ(tiled.levelMap({0}).origins, map.origins);
}

TEST(LargeMap, LaysMembranesAsTheMapInMemoryDoesAndCountsTheirMemory) {
  const test::TileFolder folder;
  const test::Las las = bigLas(3'000'000);  // Its hole has 20 000 cells.
  writeLas(folder / "scan.las", las);
  SurfaceOptions options = test::topOptions(PointRule::median);
  options.holes = {.rule = HoleRule::membrane, .max_area_mm2 = 1300};
  const Surface whole = makeSurface(scanOf(las), options, rasterize);
  ASSERT_EQ(whole.holes.size(), 1U);
  ASSERT_TRUE(whole.holes[0].filled);
  LargeMapOptions large{
      .file = folder / "map.tif", .memory_bytes = kTinyBudget, .threads = 2, .on_view = {}};
  EXPECT_THROW(makeLargeMap(folder / "scan.las", options, large), ArgumentError);
  large.memory_bytes += 50'000'000;
  const LargeMap made = makeLargeMap(folder / "scan.las", options, large);
  EXPECT_TRUE(made.holes.at(0).filled);
  const TiledMap tiled(folder / "map.tif");
  EXPECT_TRUE(tiled.levelMap({0}).heights_mm == whole.map.heights_mm);
  EXPECT_TRUE(tiled.levelMap({0}).origins == whole.map.origins);
}

TEST(LargeMap, TakesARasterThatIsLargerThanItsBudgetToTheSameBytes) {
  const test::TileFolder folder;
  constexpr int kSide = 6000;  // 144 MB of floats; a GeoTIFF of them in memory took 180 MB.
  const GridFrame frame{
      .size = {.cols = kSide, .rows = kSide}, .spacing_mm = 2, .first_x_mm = 1, .first_y_mm = 1};
  {
    TileRasterWriter writer(folder / "dem.tif", frame, {.nan_is_nodata = true});
    std::vector<float> row(kSide);
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const bool hole = std::hypot(i - 2000, j - 3500) < 150;
        row[static_cast<std::size_t>(i)] =
            hole ? std::nanf("") : 250 + 3 * std::sin(static_cast<float>(i + 2 * j) / 90);
      }
      const void* const bands[] = {row.data()};
      writer.add(bands);
    }
    writer.close({}, nullptr);
    writer.commit();
  }
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  const LargeMap large = makeLargeMap(
      folder / "dem.tif", options,
      {.file = folder / "map.tif", .memory_bytes = 250'000'000, .threads = 1, .on_view = {}});
  const Surface whole = makeSurface(importRaster(folder / "dem.tif"), options);
  EXPECT_EQ(large.view_from_file, whole.view_from_file);
  ASSERT_EQ(large.holes.size(), 1U);
  EXPECT_EQ(large.holes[0].cells, whole.holes.at(0).cells);
  const TiledMap tiled(folder / "map.tif");
  EXPECT_TRUE(tiled.levelMap({0}).heights_mm == whole.map.heights_mm);
  EXPECT_TRUE(tiled.levelMap({0}).origins == whole.map.origins);
  EXPECT_TRUE(
      std::ranges::equal(tiled.levelMap({3}).heights_mm, whole.pyramid.levels[3].heights_mm));
}

TEST(LargeMap, ShowsASampleFirst) {
  const test::TileFolder folder;
  writeLas(folder / "scan.las", bigLas(1'000'000));
  std::vector<GridSize> views;
  const SurfaceOptions options = test::topOptions(PointRule::median);
  const LargeMap large = makeLargeMap(
      folder / "scan.las", options,
      {.file = folder / "map.tif",
       .memory_bytes = 600'000'000,
       .on_view = [&](const Surface& view) {
         views.push_back(view.map.frame.size);
         EXPECT_NEAR(view.map.widthMm(), 500, 3);
         EXPECT_NEAR(heightRange(view.map).max_mm - heightRange(view.map).min_mm, 6, 1.5);
       }});
  ASSERT_EQ(views.size(), 2U);
  EXPECT_GT(views[1].cols, views[0].cols);
  EXPECT_GT(large.first_view_s, 0);
}

TEST(LargeMap, RefusesABudgetThatIsTooSmallBeforeTheWork) {
  const test::TileFolder folder;
  writeLas(folder / "scan.las", bigLas(10'000));
  try {
    makeLargeMap(folder / "scan.las", test::topOptions(PointRule::median),
                 {.file = folder / "map.tif", .memory_bytes = 50'000'000, .on_view = {}});
    FAIL() << "was accepted";
  } catch (const ArgumentError& error) {
    EXPECT_EQ(error.code, "E102");
    EXPECT_NE(std::string(error.what()).find("50 MB"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "map.tif"));
}

/// The most memory that this process had, in bytes; 0 if the system does not say.
std::uint64_t peakBytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Makes the map in a process of its own, whose peak is that of the map alone.
void expectWithin(std::uint64_t budget, const test::Las& las, const std::filesystem::path& file) {
  const char* const given = std::getenv("RELIEVO_TEST_DENSE_SCAN");
  if (given == nullptr) {
    writeLas(file, las);
    const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = "RELIEVO_TEST_DENSE_SCAN='" + file.string() + "' '" + self +
                                "' --gtest_filter=*." + info.name();
    EXPECT_EQ(std::system(command.c_str()), 0);
    return;
  }
  makeLargeMap(
      given, test::topOptions(PointRule::median),
      {.file = std::string(given) + ".tif", .memory_bytes = budget, .threads = 2, .on_view = {}});
  EXPECT_GT(peakBytes(), 0U);
  EXPECT_LE(peakBytes(), budget);
  std::printf("peak: %.0f of %.0f MB\n", 1e-6 * static_cast<double>(peakBytes()),
              1e-6 * static_cast<double>(budget));
}

/// A ball of 500 x 500 cells, as evenly as rows of a spiral give it.
test::Las ball(int points) {
  test::Las las;
  las.scale = {kScale, kScale, kScale};
  constexpr double kGoldenTurn = 2.399963229728653;
  for (int i = 0; i < points; ++i) {
    const double z = 1 - 2 * (i + 0.5) / points, r = std::sqrt(1 - z * z), turn = kGoldenTurn * i;
    const auto stored = [](double unit) {
      return static_cast<std::int32_t>(std::lround(62.5 * unit / kScale));
    };
    las.raw.push_back({stored(r * std::cos(turn)), stored(r * std::sin(turn)), stored(z)});
  }
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(points);
  return las;
}

bool isChild() {
  return std::getenv("RELIEVO_TEST_DENSE_SCAN") != nullptr;
}

/// The surface in front takes some 50 MB of what is allowed.
TEST(LargeMap, StaysWithinItsBudgetWhereThereIsABack) {
  const test::TileFolder folder;
  expectWithin(330'000'000, isChild() ? test::Las{} : ball(4'000'000), folder / "scan.las");
}

/// Many points in few tiles, which are cut: as they were, three rows of tiles and what is made of
/// them took 640 MB.
test::Las dense(int points) {
  test::Las las = bigLas(points);
  for (auto& raw : las.raw) raw = {raw[0] / 4, raw[1] / 4, raw[2]};  // 500 x 500 cells.
  return las;
}

TEST(LargeMap, StaysWithinItsBudgetWherePointsLieDense) {
  const test::TileFolder folder;
  expectWithin(230'000'000, isChild() ? test::Las{} : dense(6'000'000), folder / "scan.las");
}

TEST(LargeMap, GivesTheSameFilesWherePointsLieDense) {
  const test::TileFolder folder;
  writeLas(folder / "scan.las", dense(3'000'000));
  for (const PointRule rule : {PointRule::median, PointRule::quadratic}) {
    for (const auto& [name, budget] :
         {std::pair{"a.tif", std::uint64_t{200'000'000}}, {"b.tif", 2'000'000'000}}) {
      makeLargeMap(folder / "scan.las", test::topOptions(rule),
                   {.file = folder / name, .memory_bytes = budget, .threads = 2, .on_view = {}});
    }
    EXPECT_TRUE(bytesOfFile(folder / "a.tif") == bytesOfFile(folder / "b.tif"));
    EXPECT_GT(bytesOfFile(folder / "a.tif").size(), 1'000'000U);
  }
}

/// A row of cells cannot be cut.
TEST(LargeMap, RefusesABudgetThatARowOfPointsExceeds) {
  const test::TileFolder folder;
  test::Las las = bigLas(3'000'000);
  for (std::size_t i = 2; i < las.raw.size(); ++i) las.raw[i][1] = 1000 * 128;
  writeLas(folder / "scan.las", las);
  try {
    makeLargeMap(
        folder / "scan.las", test::topOptions(PointRule::median),
        {.file = folder / "b.tif", .memory_bytes = 170'000'000, .threads = 2, .on_view = {}});
    FAIL() << "was accepted";
  } catch (const ArgumentError& error) {
    EXPECT_EQ(error.code, "E102");
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "b.tif"));
}
#endif

TEST(LargeMap, LeavesNothingWhenCancelled) {
  const test::TileFolder folder;
  writeLas(folder / "scan.las", bigLas(500'000));
  for (const std::string_view step :
       {"Sorting points into tiles", "Filling gaps", "Writing levels"}) {
    std::stop_source stop;
    const Task task{.stop = stop.get_token(), .progress = [&](std::string_view now, double) {
                      if (now == step) stop.request_stop();
                    }};
    EXPECT_THROW(makeLargeMap(folder / "scan.las", test::topOptions(PointRule::median),
                              {.file = folder / "map.tif", .on_view = {}}, {}, task),
                 Cancelled)
        << step;
    const auto files = std::filesystem::directory_iterator(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << step;
  }
}

TEST(TiledSurface, HasTheWindowsAndASmallMapForTheWhole) {
  const test::TileFolder folder;
  writeLas(folder / "scan.las", bigLas(600'000));
  makeLargeMap(folder / "scan.las", test::topOptions(PointRule::median),
               {.file = folder / "map.tif", .on_view = {}});
  const Surface surface = openTiledSurface(folder / "map.tif");
  EXPECT_EQ(surface.map.frame.size.cols, 1000);
  EXPECT_EQ(surface.ladder.levels(), 5);
  const Region region{.x_mm = 100, .y_mm = 120, .side_mm = 50, .level = {0}};
  EXPECT_EQ(windowOf(surface, region).heights_mm,
            TiledMap(folder / "map.tif").window(region).heights_mm);
}

}  // namespace
}  // namespace relievo
