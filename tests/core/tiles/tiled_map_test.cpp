// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tiled_map.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <thread>

#include "core/base/error.h"
#include "core/io/raster/raster.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tile_raster.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo {
namespace {

constexpr ViewFromFile kView{{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, -7, 0, 0, 0, 1}};

DepthMap someMap(GridSize size) {
  std::mt19937 random(17);
  std::uniform_real_distribution<float> uniform(0, 0.2F);
  DepthMap map;
  map.frame = {.size = size, .spacing_mm = 0.125, .first_x_mm = 0.0625, .first_y_mm = 0.0625};
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const bool outside = col + row < size.cols / 3;
      const bool hole = std::hypot(col - size.cols / 2, row - size.rows / 2) < 40;
      const float z = 3 + std::sin(static_cast<float>(col) / 40) + uniform(random);
      map.heights_mm.push_back(outside || hole ? 0.0F : z);
      map.origins.push_back(outside ? CellStatus::outside
                            : hole  ? CellStatus::base_plane
                                    : CellStatus::measured);
    }
  }
  return map;
}

void writeLevels(const std::filesystem::path& file, const DepthMap& map, double factor = 2) {
  LevelFiles files(file, map.frame, {.factor = factor});
  for (int row = 0; row < map.frame.size.rows; ++row) {
    const std::size_t start = map.frame.size.index({.col = 0, .row = row});
    files.add(&map.heights_mm[start], &map.origins[start]);
  }
  files.finish(kView);
}

TEST(TiledMap, GivesTheWindowsOfTheMapInMemory) {
  const test::TileFolder folder;
  for (const double factor : {2.0, 3.0, 1.5}) {
    const DepthMap map = someMap({.cols = 900, .rows = 1100});
    const Pyramid pyramid = buildPyramid(map, {.factor = factor});
    writeLevels(folder / "map.tif", map, factor);
    const TiledMap tiled(folder / "map.tif");
    ASSERT_EQ(tiled.frames().size(), pyramid.levels.size());
    EXPECT_EQ(tiled.viewFromFile(), kView);
    const DetailLadder ladder = detailLadder(map, pyramid);
    EXPECT_EQ(tiled.ladder().spacings_mm, ladder.spacings_mm);
    EXPECT_EQ(tiled.ladder().width_mm, ladder.width_mm);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-10, 120);
    std::uniform_real_distribution<double> side(5, 150);
    for (int i = 0; i < 40; ++i) {
      const int level = i % static_cast<int>(pyramid.levels.size());
      const Region region{
          .x_mm = place(random), .y_mm = place(random), .side_mm = side(random), .level = {level}};
      const RegionWindow here = tiled.window(region, 1.5);
      const RegionWindow there = sampleWindow(map, pyramid, region, 1.5);
      ASSERT_EQ(here.heights_mm, there.heights_mm) << i;
      EXPECT_EQ(here.id, there.id);
      EXPECT_EQ(here.levels, there.levels);
      if (level == 0) {
        EXPECT_EQ(here.origins, there.origins);
      }
    }
  }
}

TEST(TiledMap, TouchesOnlyTheTilesUnderTheWindow) {
  const test::TileFolder folder;
  writeLevels(folder / "map.tif", someMap({.cols = 1500, .rows = 1500}));
  const TiledMap tiled(folder / "map.tif");
  EXPECT_EQ(tiled.tilesRead(), 0U);
  const Region region{.x_mm = 40, .y_mm = 40, .side_mm = 25, .level = {0}};
  const RegionWindow first = tiled.window(region);
  const std::size_t read = tiled.tilesRead();
  EXPECT_LE(read, 8U);
  EXPECT_EQ(tiled.window(region).heights_mm, first.heights_mm);
  EXPECT_EQ(tiled.tilesRead(), read);
}

TEST(TiledMap, PrefetchedWindowsReadNothing) {
  const test::TileFolder folder;
  writeLevels(folder / "map.tif", someMap({.cols = 1500, .rows = 1500}));
  const auto tiled = std::make_shared<const TiledMap>(folder / "map.tif");
  TilePrefetcher prefetcher(tiled);
  const Region region{.x_mm = 60, .y_mm = 60, .side_mm = 25, .level = {1}};
  prefetcher.around(region);
  prefetcher.wait();
  const std::size_t read = tiled->tilesRead();
  EXPECT_GT(read, 0U);
  tiled->window(region);
  Region moved = region;
  moved.x_mm += 0.25 * region.side_mm;
  tiled->window(moved);
  tiled->window({.x_mm = region.centreX() - 6.25,
                 .y_mm = region.centreY() - 6.25,
                 .side_mm = 12.5,
                 .level = {0}});
  EXPECT_EQ(tiled->tilesRead(), read);
}

TEST(TiledMap, ServesManyThreadsFromASmallCache) {
  const test::TileFolder folder;
  const DepthMap map = someMap({.cols = 1200, .rows = 1200});
  const Pyramid pyramid = buildPyramid(map);
  writeLevels(folder / "map.tif", map);
  const TiledMap tiled(folder / "map.tif", std::size_t{1} << 20U);
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (unsigned t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        std::mt19937 random(t);
        std::uniform_real_distribution<double> place(0, 120);
        for (int i = 0; i < 20; ++i) {
          const Region region{
              .x_mm = place(random), .y_mm = place(random), .side_mm = 25, .level = {i % 2}};
          wrong += tiled.window(region).heights_mm != sampleWindow(map, pyramid, region).heights_mm;
        }
      });
    }
  }
  EXPECT_EQ(wrong, 0);
}

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

TEST(LevelFiles, StandInTheirPlacesForEveryProgram) {
  GDALAllRegister();
  const test::TileFolder folder;
  const DepthMap map = someMap({.cols = 701, .rows = 1030});
  const Pyramid pyramid = buildPyramid(map);
  writeLevels(folder / "map.tif", map);
  for (int l = 0; l < static_cast<int>(pyramid.levels.size()); ++l) {
    SCOPED_TRACE(l);
    const Dataset dataset(GDALDataset::Open(levelFile(folder / "map.tif", l).c_str()));
    ASSERT_TRUE(dataset);
    const PyramidLevel& level = pyramid.levels[static_cast<std::size_t>(l)];
    const GridSize size = level.frame.size;
    ASSERT_EQ(dataset->GetRasterXSize(), size.cols);
    ASSERT_EQ(dataset->GetRasterYSize(), size.rows);
    std::array<double, 6> g{};
    ASSERT_EQ(dataset->GetGeoTransform(g.data()), CE_None);
    std::size_t other = 0;
    std::size_t misplaced = 0;
    std::size_t masked_wrong = 0;
    std::vector<float> line(static_cast<std::size_t>(size.cols));
    std::vector<std::uint8_t> mask(line.size());
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    for (int file_row = 0; file_row < size.rows; ++file_row) {
      const int row = size.rows - 1 - file_row;
      ASSERT_EQ(band.RasterIO(GF_Read, 0, file_row, size.cols, 1, line.data(), size.cols, 1,
                              GDT_Float32, 0, 0, nullptr),
                CE_None);
      ASSERT_EQ(band.GetMaskBand()->RasterIO(GF_Read, 0, file_row, size.cols, 1, mask.data(),
                                             size.cols, 1, GDT_Byte, 0, 0, nullptr),
                CE_None);
      for (int col = 0; col < size.cols; ++col) {
        const double x = g[0] + (col + 0.5) * g[1];
        const double y = g[3] + (file_row + 0.5) * g[5];
        misplaced += std::abs(x - level.frame.xMm(col)) > 1e-9;
        misplaced += std::abs(y - level.frame.yMm(row)) > 1e-9;
        const int node = 1 << l;
        const bool outside = map.origin({.col = std::min(col * node, map.frame.size.cols - 1),
                                         .row = std::min(row * node, map.frame.size.rows - 1)}) ==
                             CellStatus::outside;
        const auto i = static_cast<std::size_t>(col);
        masked_wrong += outside != (mask[i] == 0);
        if (l == 0 && outside) continue;
        other += line[i] != level.heights_mm[size.index({.col = col, .row = row})];
      }
    }
    EXPECT_EQ(other, 0U);
    EXPECT_EQ(misplaced, 0U);
    EXPECT_EQ(masked_wrong, 0U);
  }
}

TEST(LevelFiles, ReopenAsTheMapTheyAre) {
  const test::TileFolder folder;
  const DepthMap map = someMap({.cols = 530, .rows = 300});
  writeLevels(folder / "map.tif", map);
  const RasterMap read = readRaster(folder / "map.tif");
  EXPECT_TRUE(read.is_own_map);
  EXPECT_EQ(read.view_from_file, kView);
  EXPECT_EQ(read.origins, map.origins);
  std::size_t other = 0;
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (map.origins[i] != CellStatus::outside) other += read.values[i] != map.heights_mm[i];
  }
  EXPECT_EQ(other, 0U);
}

TEST(LevelFiles, LeaveNothingBehindWhenTheyAreNotFinished) {
  const test::TileFolder folder;
  { LevelFiles files(folder / "map.tif", someMap({.cols = 600, .rows = 600}).frame, {}); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LevelFiles, RemoveLevelsThatAnOlderMapHad) {
  const test::TileFolder folder;
  writeLevels(folder / "map.tif", someMap({.cols = 900, .rows = 900}));
  EXPECT_TRUE(std::filesystem::exists(folder / "map.L3.tif"));
  writeLevels(folder / "map.tif", someMap({.cols = 300, .rows = 300}));
  EXPECT_FALSE(std::filesystem::exists(folder / "map.L2.tif"));
  EXPECT_FALSE(std::filesystem::exists(folder / "map.L3.origin.tif"));
  EXPECT_EQ(TiledMap(folder / "map.tif").frames().size(), 2U);
}

std::string textIn(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// map.L1.tif may be anybody's: a project of a neighbour, a picture, a note.
TEST(LevelFiles, NeverReplaceOrRemoveWhatIsNotOurs) {
  const test::TileFolder folder;
  const DepthMap map = someMap({.cols = 300, .rows = 300});  // Two levels.
  for (const char* const name : {"map.L1.tif", "map.origin.tif", "map.L1.origin.tif"}) {
    SCOPED_TRACE(name);
    std::ofstream(folder / name) << "somebody's";
    EXPECT_THROW(writeLevels(folder / "map.tif", map), WriteError);
    EXPECT_EQ(textIn(folder / name), "somebody's");
    EXPECT_FALSE(std::filesystem::exists(folder / "map.tif")) << "nothing is half done";
    std::filesystem::remove(folder / name);
  }
  // Behind the coarsest level lies what could be an older map's, and is not.
  std::ofstream(folder / "map.L2.tif") << "somebody's";
  writeLevels(folder / "map.tif", map);
  EXPECT_EQ(textIn(folder / "map.L2.tif"), "somebody's");
  EXPECT_EQ(TiledMap(folder / "map.tif").frames().size(), 2U);
  // Also a raster that another program wrote.
  std::filesystem::remove(folder / "map.L2.tif");
  Dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create((folder / "map.L2.tif").c_str(),
                                                                   5, 5, 1, GDT_Float32, nullptr))
      .reset();
  writeLevels(folder / "map.tif", map);
  EXPECT_TRUE(std::filesystem::exists(folder / "map.L2.tif"));
}

TEST(TiledMap, KnowsItsOwnFiles) {
  const test::TileFolder folder;
  const DepthMap map = someMap({.cols = 300, .rows = 300});
  writeLevels(folder / "map.tif", map);
  writeMap(folder / "plain.tif", map, {.view_from_file = kView});
  std::ofstream(folder / "text.tif") << "no raster";
  EXPECT_TRUE(TiledMap::isOne(folder / "map.tif"));
  for (const char* name :
       {"map.L1.tif", "map.origin.tif", "plain.tif", "text.tif", "missing.tif"}) {
    EXPECT_FALSE(TiledMap::isOne(folder / name)) << name;
  }
}

class DamagedTiledMap : public testing::Test {
 protected:
  DamagedTiledMap() { writeLevels(folder_ / "map.tif", someMap({.cols = 900, .rows = 700})); }

  void expectRefused(const std::string& words) {
    try {
      const TiledMap tiled(folder_ / "map.tif");
      for (int level = 0; level < static_cast<int>(tiled.frames().size()); ++level) {
        tiled.window({.x_mm = 0, .y_mm = 0, .side_mm = 115, .level = {level}});
      }
      FAIL() << "was accepted";
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  test::TileFolder folder_;
};

TEST_F(DamagedTiledMap, RefusesAMissingLevel) {
  std::filesystem::remove(folder_ / "map.L1.tif");
  expectRefused("map.L1.tif");
}

TEST_F(DamagedTiledMap, RefusesALevelOfAnotherMap) {
  const test::TileFolder other;
  DepthMap map = someMap({.cols = 900, .rows = 700});
  map.heights_mm[1234] += 1;
  writeLevels(other / "map.tif", map);
  std::filesystem::copy_file(other / "map.L1.tif", folder_ / "map.L1.tif",
                             std::filesystem::copy_options::overwrite_existing);
  expectRefused("another map");
}

/// What a program leaves that is killed between two files: each is whole, and they are of two sets.
TEST_F(DamagedTiledMap, RefusesALevelOfTheSameHeightsAndOtherOrigins) {
  const test::TileFolder other;
  DepthMap map = someMap({.cols = 900, .rows = 700});
  for (CellStatus& origin : map.origins) {
    if (origin == CellStatus::base_plane) origin = CellStatus::measured;
  }
  writeLevels(other / "map.tif", map);
  std::filesystem::copy_file(other / "map.L1.origin.tif", folder_ / "map.L1.origin.tif",
                             std::filesystem::copy_options::overwrite_existing);
  expectRefused("another map");
}

TEST(TileRasterWriter, BeginsALargeFileOnADiskThatHasRoomForIt) {
  const test::TileFolder folder;
  const GridFrame frame{
      .size = {.cols = 20'000, .rows = 20'000}, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0};
  const auto bytes = frame.size.count() * sizeof(float);
  if (std::filesystem::space(folder.path()).available < bytes) GTEST_SKIP() << "The disk is full.";
  EXPECT_NO_THROW(TileRasterWriter(folder / "large.tif", frame, {}));
}

TEST(TileRasterWriter, RefusesAFileThatIsLargerThanTheDiskBeforeTheWork) {
  const test::TileFolder folder;
  const GridFrame frame{.size = {.cols = 2'000'000, .rows = 2'000'000},
                        .spacing_mm = 1,
                        .first_x_mm = 0,
                        .first_y_mm = 0};
  try {
    const TileRasterWriter writer(folder / "large.tif", frame, {});
    ADD_FAILURE() << "was begun";
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("it takes 16 000 000 MB"), std::string::npos)
        << error.what();
  }
}

TEST(LevelFiles, AreTheSameBytesWhenWrittenAgain) {
  const test::TileFolder folder;
  writeLevels(folder / "map.tif", someMap({.cols = 300, .rows = 300}));
  const std::string first = textIn(folder / "map.tif") + textIn(folder / "map.L1.origin.tif");
  writeLevels(folder / "map.tif", someMap({.cols = 300, .rows = 300}));
  EXPECT_TRUE(textIn(folder / "map.tif") + textIn(folder / "map.L1.origin.tif") == first);
}

TEST_F(DamagedTiledMap, RefusesACutLevel) {
  const auto bytes = std::filesystem::file_size(folder_ / "map.L1.tif");
  std::filesystem::resize_file(folder_ / "map.L1.tif", bytes / 2);
  expectRefused("map.L1.tif");
}

TEST_F(DamagedTiledMap, RefusesHeightsThatAreNotFinite) {
  std::fstream file(folder_ / "map.L1.tif", std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(300'000);
  const std::vector<char> bad(4096, static_cast<char>(0xff));
  file.write(bad.data(), static_cast<std::streamsize>(bad.size()));
  file.close();
  expectRefused("not finite");
}

TEST_F(DamagedTiledMap, RefusesFilesThatWereCompressed) {
  GDALAllRegister();
  const Dataset from(GDALDataset::Open((folder_ / "map.L1.tif").c_str()));
  const char* options[] = {"COMPRESS=DEFLATE", "TILED=YES", nullptr};
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const Dataset to(driver->CreateCopy((folder_ / "new.tif").c_str(), from.get(), 0,
                                      const_cast<char**>(options), nullptr, nullptr));
  ASSERT_TRUE(to);
  to->FlushCache();
  std::filesystem::rename(folder_ / "new.tif", folder_ / "map.L1.tif");
  expectRefused("compressed");
}

}  // namespace
}  // namespace relievo
