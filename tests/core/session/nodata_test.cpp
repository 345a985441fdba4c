// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/nodata.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "core/session/large/large_map.h"
#include "core/session/surface.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

/// 40 x 30 heights of 200 ... 260, every so-manyth of them `missing`.
RasterMap rasterWith(float missing, std::size_t every) {
  RasterMap raster;
  raster.size = {.cols = 40, .rows = 30};
  float low = 1e38F;
  float high = -1e38F;
  for (std::size_t i = 0; i < 1200; ++i) {
    const float z = every > 0 && i % every == 0 ? missing : 200 + static_cast<float>(i % 61);
    raster.values.push_back(z);
    low = std::min(low, z);
    high = std::max(high, z);
  }
  raster.valid.assign(1200, true);
  raster.info.bounds =
      FileBounds{{0, 0, static_cast<double>(low)}, {39, 29, static_cast<double>(high)}};
  return raster;
}

TEST(SuspectHeight, IsOneThatProgramsWriteForNoneFarFromTheOthers) {
  for (const float missing : {-9999.0F, -32768.0F, -32767.0F, -99999.0F, -3.4028235e38F,
                              -3.40282e38F, 1.17549435e-38F, -1e30F, 32767.0F, 1e20F}) {
    const auto suspect = suspectHeight(rasterWith(missing, 7));
    ASSERT_TRUE(suspect.has_value()) << missing;
    EXPECT_FLOAT_EQ(static_cast<float>(suspect->value), missing);
    EXPECT_EQ(suspect->count, 172U);
    EXPECT_EQ(suspect->all, 1200U);
  }
}

TEST(BoundsWithout, IsTheBoxOfTheOtherHeights) {
  const auto box = boundsWithout(rasterWith(-9999, 7), -9999);
  EXPECT_EQ(box, (FileBounds{{0, 0, 200}, {39, 29, 260}}));
  EXPECT_FALSE(boundsWithout(rasterWith(-9999, 1), -9999).has_value());
}

TEST(SuspectHeight, AreNoneOfOrdinaryHeights) {
  EXPECT_FALSE(suspectHeight(rasterWith(0, 0)).has_value());
  EXPECT_FALSE(suspectHeight(rasterWith(-20, 7)).has_value()) << "a pit";
  EXPECT_FALSE(suspectHeight(rasterWith(0, 7)).has_value()) << "the sea";
  EXPECT_FALSE(suspectHeight(rasterWith(-9999, 1200)).has_value()) << "once is a measurement";
  RasterMap deep = rasterWith(-9999, 7);
  for (std::size_t i = 1; i < 1200; i += 7) deep.values[i] = -8000;
  EXPECT_FALSE(suspectHeight(deep).has_value()) << "other heights lie on the way";
}

TEST(SuspectHeight, DoesNotDependOnTheOrderOfCells) {
  RasterMap raster = rasterWith(-9999, 5);
  const auto first = suspectHeight(raster);
  std::mt19937 random(1);
  std::shuffle(raster.values.begin(), raster.values.end(), random);
  EXPECT_EQ(suspectHeight(raster), first);
}

TEST(Nodata, OfARasterIsLeftOutAndAskedAboutTakenOrKept) {
  const RasterMap raster = rasterWith(-9999, 7);
  SurfaceOptions options;
  options.unit = LengthUnit::m;
  const Surface asked = makeSurface(raster, options);
  ASSERT_TRUE(asked.suspect_height.has_value());
  EXPECT_EQ(asked.missing, 172U);
  EXPECT_EQ(heightRange(asked.map).max_mm, 60'000.0F) << "left out though nobody said so";
  EXPECT_NE(std::find_if(asked.messages.begin(), asked.messages.end(),
                         [](const Message& m) {
                           const std::string words = englishText(m);
                           return words.starts_with("172 of 1 200 heights are -9999") &&
                                  words.find("--nodata none") != words.npos;
                         }),
            asked.messages.end());
  options.nodata = NodataChoice{.value = -9999};
  const Surface taken = makeSurface(raster, options);
  EXPECT_EQ(taken.missing, 172U);
  EXPECT_EQ(taken.map.heights_mm, asked.map.heights_mm);
  EXPECT_EQ(heightRange(taken.map).max_mm, 60'000.0F);
  EXPECT_FALSE(taken.suspect_height.has_value());
  options.nodata = NodataChoice{};
  const Surface kept = makeSurface(raster, options);
  EXPECT_EQ(heightRange(kept.map).max_mm, 10'259'000.0F);
  EXPECT_EQ(kept.missing, 0U);
  EXPECT_FALSE(kept.suspect_height.has_value());
}

TEST(Nodata, OfAMapByTilesIsThatOfTheMapInMemory) {
  const test::TemporaryFolder folder;
  std::string text = "ncols 40\nnrows 30\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 1200; ++i) {
    text += (i % 7 == 0 ? "-32768" : std::to_string(200 + i % 61)) + (i % 40 == 39 ? "\n" : " ");
  }
  const auto file = folder.write("grid.asc", text);
  SurfaceOptions options;
  options.unit = LengthUnit::m;
  const LargeMapOptions large{.file = folder.path() / "map.tif", .on_view = {}};
  const LargeMap asked = makeLargeMap(file, options, large);
  EXPECT_NE(std::find_if(asked.messages.begin(), asked.messages.end(),
                         [](const Message& m) {
                           return englishText(m).find("-32768") != std::string::npos;
                         }),
            asked.messages.end());
  EXPECT_EQ(asked.missing, 172U);
  options.nodata = NodataChoice{};
  EXPECT_EQ(makeLargeMap(file, options, large).missing, 0U);
  options.nodata = NodataChoice{.value = -32768};
  const LargeMap map = makeLargeMap(file, options, large);
  const Surface surface = makeSurface(importRaster(file), options);
  EXPECT_EQ(map.missing, 172U);
  EXPECT_EQ(asked.heights.max_mm, map.heights.max_mm);
  EXPECT_EQ(surface.missing, 172U);
  EXPECT_EQ(map.heights.max_mm, heightRange(surface.map).max_mm);
  EXPECT_EQ(map.view_from_file, surface.view_from_file);
}

TEST(Nodata, OfACloudByTilesIsThatOfTheCloudInMemory) {
  const test::TemporaryFolder folder;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  for (int i = 0; i < 4000; ++i) {
    const auto col = static_cast<float>(i % 80);
    const auto row = static_cast<float>(i / 80);
    const std::array<float, 3> point{
        0.5F * col, 0.5F * row, i % 9 == 0 ? -9999 : 20 + std::sin(static_cast<float>(i) / 300)};
    std::array<char, sizeof point> stored{};
    std::memcpy(stored.data(), point.data(), sizeof point);
    bytes.append(stored.data(), stored.size());
  }
  const auto file = folder.write("cloud.ply", bytes);
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{.name = "top", .rotation = {}};
  options.cells = 60;
  const LargeMapOptions large{.file = folder.path() / "map.tif", .on_view = {}};
  const LargeMap map = makeLargeMap(file, options, large);
  const Surface surface = makeSurface(importScan(file), options, rasterize);
  EXPECT_EQ(map.missing, 445U);
  EXPECT_EQ(surface.missing, 445U);
  EXPECT_EQ(map.heights.max_mm, heightRange(surface.map).max_mm);
  EXPECT_LT(map.heights.max_mm, 5) << "left out though nobody said so";
  EXPECT_EQ(map.view_from_file, surface.view_from_file);
}

TEST(Nodata, ThatLeavesNothingIsRefused) {
  RasterMap raster = rasterWith(-9999, 1);
  EXPECT_THROW(takeAsMissing(raster, -9999), FileError);
}

}  // namespace
}  // namespace relievo
