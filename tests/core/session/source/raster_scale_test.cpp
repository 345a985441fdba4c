// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/source/raster_scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "core/provenance/parameters_json.h"
#include "core/session/large/large_map.h"
#include "core/session/map_facts.h"
#include "core/session/surface.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using testing::HasSubstr;

constexpr int kCols = 40, kRows = 30;

/// 100 ... 60 100: the value grows by 2000 with every row from the top.
int valueAt(int /*col*/, int row) {
  return 100 + 2000 * row + (row == kRows - 1 ? 2000 : 0);
}

/// A picture of heights as programs write it: 16 bits of grey, no georeference.
std::filesystem::path greyTiff(const test::TemporaryFolder& folder) {
  std::string bytes("II*\0\0\0\0\0", 8);
  const auto put = [&](std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<char>(value >> (8 * i)));
  };
  for (int row = 0; row < kRows; ++row) {
    for (int col = 0; col < kCols; ++col) put(static_cast<std::uint32_t>(valueAt(col, row)), 2);
  }
  const auto directory = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(bytes.data() + 4, &directory, 4);
  const std::array<std::array<std::uint32_t, 3>, 8> entries{{{256, 3, kCols},
                                                             {257, 3, kRows},
                                                             {258, 3, 16},
                                                             {259, 3, 1},
                                                             {262, 3, 1},
                                                             {273, 4, 8},
                                                             {278, 3, kRows},
                                                             {279, 4, 2 * kCols * kRows}}};
  put(entries.size(), 2);
  for (const auto& [tag, type, value] : entries) {
    put(tag, 2);
    put(type, 2);
    put(1, 4);
    put(value, 4);
  }
  put(0, 4);
  return folder.write("grey.tif", bytes);
}

std::string allOf(const std::vector<Message>& sentences) {
  std::string all;
  for (const Message& s : sentences) all += englishText(s) + "\n";
  return all;
}

class RasterScaleTest : public ::testing::Test {
 protected:
  Surface surface(const RasterScale& said = {}) const {
    SurfaceOptions options = options_;
    options.raster = said;
    return makeSurface(importRaster(file_), options);
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = greyTiff(folder_);
  SurfaceOptions options_;
};

TEST_F(RasterScaleTest, APictureThatWouldBeHigherThanLongIsATenthAsHighAndSaysSo) {
  const Surface s = surface();
  ASSERT_TRUE(s.raster_scale.has_value());
  EXPECT_FALSE(s.raster_scale->is_placed);
  EXPECT_EQ(s.raster_scale->height_source, UnitSource::guessed);
  // 39 mm long, 60 000 steps: 0.000065 would be a tenth, one digit of it is left.
  EXPECT_NEAR(s.raster_scale->height_mm, 6e-5, 1e-12);
  EXPECT_NEAR(heightRange(s.map).max_mm, 3.6, 1e-4);
  EXPECT_EQ(s.map.frame.spacing_mm, 1);
  EXPECT_THAT(allOf(s.messages), HasSubstr("a guess"));
  EXPECT_THAT(allOf(s.messages), HasSubstr("--height-scale"));
  EXPECT_THAT(allOf(s.messages), testing::Not(HasSubstr("one file unit was taken as 1 mm")))
      << "one sentence says it all";
}

TEST_F(RasterScaleTest, WhatIsSaidIsUsedAndNothingIsGuessedThen) {
  const Surface s = surface({.pixel_mm = 0.25, .height_mm = 0.001, .zero = {}});
  EXPECT_EQ(s.map.frame.spacing_mm, 0.25);
  EXPECT_NEAR(heightRange(s.map).max_mm, 60, 1e-3);
  EXPECT_EQ(heightRange(s.map).min_mm, 0);
  EXPECT_FALSE(s.raster_scale->isOpen());
  EXPECT_THAT(allOf(s.messages), testing::Not(HasSubstr("guess")));
  // The file's lowest row lies in view y = 0.125 mm with the value 60 100.
  const ViewMm low = s.view_from_file({0.5, 0.5, 60'100});
  EXPECT_NEAR(low.x, 0.125, 1e-9);
  EXPECT_NEAR(low.y, 0.125, 1e-9);
  EXPECT_NEAR(low.z, 60, 1e-6);
  const double off = mapCells(s).part({}, {.cols = 1, .rows = 1}).heightErrorMm({});
  EXPECT_NEAR(off, 0.0005, 1e-9) << "half a step of the file's numbers";
}

TEST_F(RasterScaleTest, AUnitThatSomebodyGivesEndsTheGuess) {
  options_.unit = LengthUnit::mm;
  EXPECT_EQ(heightRange(surface().map).max_mm, 60'000);
  options_.unit_source = UnitSource::remembered;  // Said of another file in the same folder.
  EXPECT_NEAR(heightRange(surface().map).max_mm, 3.6, 1e-4);
}

TEST_F(RasterScaleTest, APictureOfDistancesLiesTheOtherWayRound) {
  const Surface s = surface({.pixel_mm = 1, .height_mm = -0.001, .zero = {}});
  EXPECT_NEAR(heightRange(s.map).max_mm, 60, 1e-3);
  EXPECT_EQ(heightRange(s.map).min_mm, 0);
  const GridSize size = s.map.frame.size;
  EXPECT_EQ(s.map.heights_mm[size.index({.col = 0, .row = 0})], 0) << "60 100 is farthest away";
  EXPECT_NEAR(s.map.heights_mm[size.index({.col = 0, .row = kRows - 1})], 60, 1e-3);
}

TEST_F(RasterScaleTest, TheBasePlaneIsAtTheValueThatIsSaidAndLowerOnesLieBelow) {
  const Surface s = surface({.pixel_mm = 1, .height_mm = 0.001, .zero = 20'100});
  EXPECT_NEAR(heightRange(s.map).min_mm, -20, 1e-3);
  EXPECT_NEAR(heightRange(s.map).max_mm, 40, 1e-3);
  EXPECT_NEAR(s.view_from_file({0.5, 0.5, 20'100}).z, 0, 1e-6);
}

TEST_F(RasterScaleTest, AMapByTilesIsThatOfTheMapInMemory) {
  const LargeMapOptions large{.file = folder_.path() / "map.tif", .on_view = {}};
  for (const RasterScale& said :
       {RasterScale{}, RasterScale{.pixel_mm = 0.5, .height_mm = -0.002, .zero = 1000}}) {
    options_.raster = said;
    const LargeMap map = makeLargeMap(file_, options_, large);
    const Surface s = surface(said);
    EXPECT_EQ(map.view_from_file, s.view_from_file);
    EXPECT_EQ(map.heights.min_mm, heightRange(s.map).min_mm);
    EXPECT_EQ(map.heights.max_mm, heightRange(s.map).max_mm);
    EXPECT_EQ(map.frames.front().spacing_mm, s.map.frame.spacing_mm);
    EXPECT_EQ(allOf(map.messages), allOf(s.messages));
  }
}

TEST_F(RasterScaleTest, ARasterThatIsPlacedKeepsItsHeightsHoweverHigh) {
  RasterMap raster = importRaster(file_);
  raster.is_placed = true;
  const Surface s = makeSurface(raster, options_);
  EXPECT_EQ(heightRange(s.map).max_mm, 60'000);
  EXPECT_FALSE(s.raster_scale->isOpen());
}

TEST_F(RasterScaleTest, SizesThatAreNoneAreRefused) {
  EXPECT_THROW(surface({.pixel_mm = 0, .height_mm = 1, .zero = {}}), ArgumentError);
  EXPECT_THROW(surface({.pixel_mm = 1, .height_mm = 0, .zero = {}}), ArgumentError);
}

TEST_F(RasterScaleTest, StaysInAProjectAndWhatNobodySaidIsNotSaidThere) {
  options_.raster = {.pixel_mm = 0.1, .height_mm = -0.25, .zero = 7};
  EXPECT_EQ(optionsFrom(jsonOf(options_)).raster, options_.raster);
  EXPECT_TRUE(jsonOf(SurfaceOptions{}).at("raster_scale").is_null());
  Json older = jsonOf(SurfaceOptions{});
  older.erase("raster_scale");
  EXPECT_EQ(optionsFrom(older).raster, RasterScale{});
}

}  // namespace
}  // namespace relievo
