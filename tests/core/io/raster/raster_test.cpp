// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/raster.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <tuple>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"
#include "core/io/raster/raster_rows.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;

DepthMap roughMap(GridSize size) {
  DepthMap map;
  map.frame = {size, 0.1 + 1.0 / 3.0, 1.0 / 7.0, -12.3};
  std::mt19937 random(20);
  std::uniform_real_distribution<float> height(-1.F, 30.F);
  for (std::size_t i = 0; i < size.count(); ++i) {
    map.origins.push_back(static_cast<CellStatus>(i % kOriginCount));
    const bool flat = map.origins.back() == CellStatus::outside;
    map.heights_mm.push_back(flat ? 0.F : height(random));
  }
  return map;
}

ViewFromFile oddView() {
  ViewFromFile view;
  view.m = {0, 1000, 0, -1.0 / 3.0, 0, 0, 1000, 5.4e6 + 0.1, 1000, 0, 0, 1e-17, 0, 0, 0, 1};
  return view;
}

/// A foreign GeoTIFF of doubles, rows from the top.
struct ForeignRaster {
  int cols = 3, rows = 2;
  std::vector<double> cells{1, 2, 3, 4, 5, 6};
  std::array<double, 6> transform{100, 0.5, 0, 200, 0, -0.5};
  int epsg = 0;
  GDALDataType type = GDT_Float64;
  int bands = 1;
  double scale = 1, offset = 0;
  bool nodata = false;
  double nodata_value = -9999;

  std::filesystem::path write(const TemporaryFolder& folder) const {
    GDALAllRegister();
    std::filesystem::path file = folder.path() / "foreign.tif";
    GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), cols, rows, bands, type, nullptr);
    std::array<double, 6> t = transform;
    dataset->SetGeoTransform(t.data());
    if (epsg != 0) {
      OGRSpatialReference srs;
      srs.importFromEPSG(epsg);
      dataset->SetSpatialRef(&srs);
    }
    GDALRasterBand* band = dataset->GetRasterBand(1);
    if (scale != 1) band->SetScale(scale);
    if (offset != 0) band->SetOffset(offset);
    if (nodata) band->SetNoDataValue(nodata_value);
    std::vector<double> copy = cells;
    EXPECT_EQ(band->RasterIO(GF_Write, 0, 0, cols, rows, copy.data(), cols, rows, GDT_Float64, 0, 0,
                             nullptr),
              CE_None);
    GDALClose(dataset);
    return file;
  }
};

std::string refusal(const std::filesystem::path& file) {
  return test::refusalOf([&] { readRaster(file); }).words;
}

TEST(Raster, OwnMapComesBackBitForBit) {
  const TemporaryFolder folder;
  const DepthMap map = roughMap({37, 23});
  const std::filesystem::path file = folder.path() / "map.tif";
  writeMap(file, map, {oddView(), true});
  const RasterMap raster = readRaster(file);

  EXPECT_TRUE(raster.is_own_map);
  EXPECT_EQ(raster.size, map.frame.size);
  EXPECT_EQ(raster.pixel, map.frame.spacing_mm);
  EXPECT_EQ(raster.first.x, map.frame.first_x_mm);
  EXPECT_EQ(raster.first.y, map.frame.first_y_mm);
  ASSERT_TRUE(raster.view_from_file.has_value());
  EXPECT_EQ(*raster.view_from_file, oddView());
  EXPECT_EQ(raster.info.unit, LengthUnit::mm);
  ASSERT_EQ(raster.origins.size(), map.origins.size());
  EXPECT_EQ(raster.origins, map.origins);
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    const bool outside = map.origins[i] == CellStatus::outside;
    ASSERT_EQ(raster.valid[i], !outside) << i;
    if (!outside) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(raster.values[i]),
                std::bit_cast<std::uint32_t>(map.heights_mm[i]))
          << i;
    }
  }
}

TEST(Raster, MapFileIsNorthUpWithSamplesAtCellCentresAndNaNOutside) {
  const TemporaryFolder folder;
  DepthMap map = roughMap({4, 3});
  map.frame = {{4, 3}, 2.0, 10.0, 20.0};
  const std::filesystem::path file = folder.path() / "map.tif";
  writeMap(file, map, {oddView(), true});

  GDALAllRegister();
  auto* dataset = static_cast<GDALDataset*>(GDALOpen(file.c_str(), GA_ReadOnly));
  ASSERT_NE(dataset, nullptr);
  std::array<double, 6> t{};
  ASSERT_EQ(dataset->GetGeoTransform(t.data()), CE_None);
  EXPECT_EQ(t, (std::array<double, 6>{9, 2, 0, 25, 0, -2}));
  EXPECT_EQ(dataset->GetRasterCount(), 1);
  GDALRasterBand* band = dataset->GetRasterBand(1);
  EXPECT_EQ(band->GetRasterDataType(), GDT_Float32);
  EXPECT_TRUE(std::isnan(band->GetNoDataValue()));
  EXPECT_STREQ(dataset->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE");
  EXPECT_STREQ(dataset->GetMetadataItem("PREDICTOR", "IMAGE_STRUCTURE"), "3");
  EXPECT_STREQ(dataset->GetMetadataItem("RELIEVO_UNIT"), "mm");
  EXPECT_STREQ(dataset->GetMetadataItem("RELIEVO_VERSION"), RELIEVO_VERSION_STRING);
  EXPECT_THAT(dataset->GetMetadataItem("RELIEVO_VIEW_FROM_FILE"),
              HasSubstr("-0.3333333333333333 0 0 1000 5400000.1"));
  std::array<float, 4> top{};
  ASSERT_EQ(band->RasterIO(GF_Read, 0, 0, 4, 1, top.data(), 4, 1, GDT_Float32, 0, 0, nullptr),
            CE_None);
  for (int col = 0; col < 4; ++col) {
    const Cell cell{col, 2};
    const float stored = top[static_cast<std::size_t>(col)];
    if (map.origin(cell) == CellStatus::outside) {
      EXPECT_TRUE(std::isnan(stored));
    } else {
      EXPECT_EQ(stored, map.heightMm(cell));
    }
  }
  GDALClose(dataset);
  auto* origins =
      static_cast<GDALDataset*>(GDALOpen((folder.path() / "map.origin.tif").c_str(), GA_ReadOnly));
  ASSERT_NE(origins, nullptr);
  EXPECT_EQ(origins->GetRasterBand(1)->GetRasterDataType(), GDT_Byte);
  GDALClose(origins);
}

TEST(Raster, AnExportedMapHoldsItsMaskForProgramsThatKnowNoNodata) {
  const TemporaryFolder folder;
  const DepthMap map = roughMap({9, 7});
  const std::filesystem::path file = folder.path() / "map.tif";
  writeMap(file, map, {.view_from_file = oddView(), .mask_band = true});
  GDALAllRegister();
  auto* dataset = static_cast<GDALDataset*>(GDALOpen(file.c_str(), GA_ReadOnly));
  ASSERT_NE(dataset, nullptr);
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  EXPECT_EQ(band.GetMaskFlags(), GMF_PER_DATASET);
  std::vector<std::uint8_t> mask(map.origins.size());
  ASSERT_EQ(
      band.GetMaskBand()->RasterIO(GF_Read, 0, 0, 9, 7, mask.data(), 9, 7, GDT_Byte, 0, 0, nullptr),
      CE_None);
  for (int row = 0; row < 7; ++row) {
    for (int col = 0; col < 9; ++col) {
      const std::size_t in_file = map.frame.size.index({col, 6 - row});
      EXPECT_EQ(mask[in_file] != 0, map.origin({col, row}) != CellStatus::outside);
    }
  }
  GDALClose(dataset);
  const RasterMap back = importRaster(file);
  EXPECT_EQ(back.origins, map.origins) << "it is read as every map";
}

TEST(Raster, WritingLeavesTheMapAndItsOriginsAndNothingElse) {
  const TemporaryFolder folder;
  writeMap(folder.path() / "map.tif", roughMap({5, 5}), {oddView(), true});
  writeMap(folder.path() / "map.tif", roughMap({6, 6}), {oddView(), true});
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("map.tif", "map.origin.tif"));
  EXPECT_EQ(readRaster(folder.path() / "map.tif").size, (GridSize{6, 6}));
}

TEST(Raster, WritingWithoutOriginsRemovesTheOriginsOfTheOverwrittenMap) {
  const TemporaryFolder folder;
  writeMap(folder.path() / "map.tif", roughMap({5, 5}), {oddView(), true});
  writeMap(folder.path() / "map.tif", roughMap({5, 5}), {oddView(), false});
  EXPECT_TRUE(readRaster(folder.path() / "map.tif").origins.empty());
}

TEST(Raster, WritingIntoAMissingFolderSaysSoAndLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(writeMap(folder.path() / "absent" / "map.tif", roughMap({5, 5}), {}), WriteError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Raster, OriginsThatDoNotFitTheMapAreLeftAsideWithAWarning) {
  const TemporaryFolder folder;
  writeMap(folder.path() / "a.tif", roughMap({5, 5}), {oddView(), true});
  writeMap(folder.path() / "b.tif", roughMap({6, 6}), {oddView(), true});
  std::filesystem::rename(folder.path() / "b.origin.tif", folder.path() / "a.origin.tif");
  const RasterMap raster = readRaster(folder.path() / "a.tif");
  EXPECT_TRUE(raster.origins.empty());
  ASSERT_EQ(raster.info.warnings.size(), 1U);
  EXPECT_THAT(englishText(raster.info.warnings[0]), HasSubstr("another size"));
}

/// Beside a map of 5 x 5 cells lies another file of origins, whose codes fit its heights.
class OriginsOfAnotherMap : public testing::Test {
 protected:
  OriginsOfAnotherMap() { writeMap(map(), map_, {oddView(), true}); }

  std::filesystem::path map() const { return folder_.path() / "a.tif"; }
  std::filesystem::path origins() const { return folder_.path() / "a.origin.tif"; }
  /// The same heights; what was measured there is interpolated here.
  DepthMap other() const {
    DepthMap other = map_;
    for (CellStatus& origin : other.origins) {
      if (origin == CellStatus::measured) origin = CellStatus::interpolated;
    }
    return other;
  }
  void areLeftAside() {
    const RasterMap raster = readRaster(map());
    EXPECT_TRUE(raster.origins.empty());
    ASSERT_EQ(raster.info.warnings.size(), 1U);
    EXPECT_THAT(englishText(raster.info.warnings[0]),
                HasSubstr("a.origin.tif belongs to another map"));
  }
  /// Takes an entry out of a file, as a build wrote it that did not know it.
  static void forget(const std::filesystem::path& file, const char* fact) {
    GDALAllRegister();
    auto* dataset = static_cast<GDALDataset*>(GDALOpen(file.c_str(), GA_Update));
    ASSERT_NE(dataset, nullptr);
    dataset->SetMetadataItem(fact, nullptr);
    GDALClose(dataset);
  }

  TemporaryFolder folder_;
  DepthMap map_ = roughMap({5, 5});
};

TEST_F(OriginsOfAnotherMap, OfAnotherSetAreLeftAsideWithAWarning) {
  writeMap(folder_.path() / "b.tif", other(), {oddView(), true});
  std::filesystem::rename(folder_.path() / "b.origin.tif", origins());
  areLeftAside();
}

TEST_F(OriginsOfAnotherMap, OfAnotherProgramAreLeftAsideWithAWarning) {
  GDALAllRegister();
  std::filesystem::remove(origins());
  auto* foreign = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(origins().c_str(), 5, 5,
                                                                           1, GDT_Byte, nullptr);
  std::vector<std::uint8_t> codes;
  for (int row = 4; row >= 0; --row) {
    for (int col = 0; col < 5; ++col) {
      codes.push_back(static_cast<std::uint8_t>(map_.origin({.col = col, .row = row})));
    }
  }
  ASSERT_EQ(foreign->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 5, 5, codes.data(), 5, 5, GDT_Byte,
                                                0, 0, nullptr),
            CE_None);
  GDALClose(foreign);
  areLeftAside();
}

TEST_F(OriginsOfAnotherMap, OfAnEarlierBuildAreReadWithAMapOfIt) {
  for (const auto& file : {map(), origins()}) forget(file, kSetFact);
  const RasterMap raster = readRaster(map());
  EXPECT_EQ(raster.origins, map_.origins);
  EXPECT_TRUE(raster.info.warnings.empty());
}

TEST_F(OriginsOfAnotherMap, OfAnEarlierBuildAreNotReadWithANewMap) {
  forget(origins(), kSetFact);
  areLeftAside();
}

TEST_F(OriginsOfAnotherMap, OfAMapThatWasSeenOtherwiseAreLeftAside) {
  DepthMap moved = map_;
  moved.frame.first_x_mm += 1;
  writeMap(folder_.path() / "b.tif", moved, {oddView(), true});
  std::filesystem::rename(folder_.path() / "b.origin.tif", origins());
  for (const auto& file : {map(), origins()}) forget(file, kSetFact);
  areLeftAside();
}

TEST(Raster, ForeignRasterHasItsBoxAtCellCentresAndRowZeroLowest) {
  const TemporaryFolder folder;
  const RasterMap raster = readRaster(ForeignRaster{}.write(folder));
  EXPECT_FALSE(raster.is_own_map);
  EXPECT_EQ(raster.size, (GridSize{3, 2}));
  EXPECT_EQ(raster.pixel, 0.5);
  EXPECT_EQ(raster.values, (std::vector<float>{4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(raster.first, (FilePoint{100.25, 199.25, 0}));
  ASSERT_TRUE(raster.info.bounds.has_value());
  EXPECT_EQ(*raster.info.bounds, (FileBounds{{100.25, 199.25, 1}, {101.25, 199.75, 6}}));
  EXPECT_EQ(raster.info.points, 6U);
  EXPECT_EQ(raster.info.faces, 0U);
  EXPECT_FALSE(raster.info.unit.has_value());
}

TEST(Raster, SouthUpRasterKeepsItsPlace) {
  const TemporaryFolder folder;
  ForeignRaster foreign;
  foreign.transform = {100, 0.5, 0, 199, 0, 0.5};
  const RasterMap raster = readRaster(foreign.write(folder));
  EXPECT_EQ(raster.values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(raster.first, (FilePoint{100.25, 199.25, 0}));
}

TEST(Raster, NodataScaleAndOffsetAreHonoured) {
  const TemporaryFolder folder;
  ForeignRaster foreign;
  foreign.type = GDT_Int16;
  foreign.cells = {1, -9999, 3, 4, 5, 6};
  foreign.nodata = true;
  foreign.scale = 0.1;
  foreign.offset = 100;
  const RasterMap raster = readRaster(foreign.write(folder));
  EXPECT_EQ(raster.info.finite_points, 5U);
  EXPECT_FALSE(raster.valid[4]);
  EXPECT_TRUE(std::isnan(raster.values[4]));
  EXPECT_FLOAT_EQ(raster.values[3], 100.1F);
  EXPECT_NEAR(raster.info.bounds->max.z, 100.6, 1e-5);
  EXPECT_DOUBLE_EQ(raster.info.height_step, 0.1);
  EXPECT_EQ(readRaster(ForeignRaster{}.write(folder)).info.height_step, 0) << "floating point";
}

TEST(Raster, UnitComesFromTheProjection) {
  const TemporaryFolder folder;
  ForeignRaster foreign;
  foreign.epsg = 32632;  // UTM zone 32 N, metres.
  const RasterMap metres = readRaster(foreign.write(folder));
  EXPECT_EQ(metres.info.unit, LengthUnit::m);
  ASSERT_FALSE(metres.info.warnings.empty());
  EXPECT_THAT(englishText(metres.info.warnings[0]), HasSubstr("no unit for its heights"));
  EXPECT_THAT(englishText(metres.info.warnings[0]),
              HasSubstr("to be in the unit of its coordinates."))
      << "which --unit may change";
  foreign.epsg = 2263;  // New York Long Island, US survey feet.
  EXPECT_EQ(readRaster(foreign.write(folder)).info.unit, LengthUnit::us_ft);
}

TEST(Raster, WhatIsNoHeightGridIsRefusedWithASentence) {
  const TemporaryFolder folder;
  ForeignRaster rotated;
  rotated.transform = {0, 1, 0.2, 0, 0.2, -1};
  EXPECT_THAT(refusal(rotated.write(folder)), HasSubstr("rotated"));
  ForeignRaster oblong;
  oblong.transform = {0, 1, 0, 0, 0, -2};
  EXPECT_THAT(refusal(oblong.write(folder)), HasSubstr("not square"));
  ForeignRaster narrow;
  narrow.cols = 1;
  EXPECT_THAT(refusal(narrow.write(folder)), HasSubstr("at least 2 x 2"));
  ForeignRaster degrees;
  degrees.epsg = 4326;
  EXPECT_THAT(refusal(degrees.write(folder)), HasSubstr("degrees"));
  ForeignRaster photo;
  photo.bands = 3;
  photo.type = GDT_Byte;
  EXPECT_THAT(refusal(photo.write(folder)), HasSubstr("colour picture"));
  ForeignRaster empty;
  empty.cells.assign(6, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(refusal(empty.write(folder)), HasSubstr("none of its 6 cells"));
}

TEST(Raster, StripsLargerThanMemoryAreRefusedFromTheHeader) {
  const TemporaryFolder folder;
  GDALAllRegister();
  const auto write = [&](int cols, int rows, int bands, GDALDataType type, const char* options) {
    const std::filesystem::path file = folder.path() / "few_bytes.tif";
    const CPLStringList words(CSLTokenizeString2(options, " ", 0));
    GDALClose(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), cols, rows, bands, type, const_cast<char**>(words.List())));
    return refusal(file);
  };
  const char* const whole = "SPARSE_OK=TRUE COMPRESS=DEFLATE BLOCKYSIZE=15000";
  EXPECT_THAT(write(15000, 15000, 1, GDT_Float64, whole), HasSubstr("holds 1 800 MB"));
  const char* const together = "SPARSE_OK=TRUE COMPRESS=DEFLATE BLOCKYSIZE=2";
  EXPECT_THAT(write(60000, 2, 10000, GDT_Byte, together), HasSubstr("holds 1 200 MB"));
}

TEST(Raster, MoreMetadataThanAnybodyNeedsAreRefusedFromTheHeader) {
  const TemporaryFolder folder;
  GDALAllRegister();
  const auto write = [&](std::size_t bytes, int of_directory) {
    const std::filesystem::path file = folder.path() / "talkative.tif";
    auto* const geotiff = GetGDALDriverManager()->GetDriverByName("GTiff");
    for (int i = 0; i <= of_directory; ++i) {  // The next one is appended.
      const CPLStringList words(i == 0 ? nullptr : CSLAddString(nullptr, "APPEND_SUBDATASET=YES"));
      const std::unique_ptr<GDALDataset> made(
          geotiff->Create(file.c_str(), 3, 3, 1, GDT_Float32, const_cast<char**>(words.List())));
      std::array<double, 6> place{0, 1, 0, 3, 0, -1};
      made->SetGeoTransform(place.data());
      made->GetRasterBand(1)->Fill(i + 1);
      if (i == of_directory) made->SetMetadataItem("long", std::string(bytes, 'x').c_str());
    }
    return file;
  };
  EXPECT_NO_THROW(readRaster(write(1'000'000, 0)));
  EXPECT_THAT(refusal(write(1'100'000, 0)), HasSubstr("bytes of metadata, more than the limit"));
  std::filesystem::remove(folder.path() / "talkative.tif");
  EXPECT_THAT(refusal(write(1'100'000, 1)), HasSubstr("bytes of metadata, more than the limit"));
}

TEST(Raster, AnOriginMaskIsNotTakenForHeights) {
  const TemporaryFolder folder;
  writeMap(folder.path() / "map.tif", roughMap({5, 5}), {oddView(), true});
  EXPECT_THAT(refusal(folder.path() / "map.origin.tif"), HasSubstr("origins"));
}

TEST(Raster, DamagedFilesAreRefusedWithASentence) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path() / "absent.tif"), HasSubstr("no such file"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("folder"));
  EXPECT_THAT(refusal(folder.write("empty.tif", "")), HasSubstr("empty"));
  EXPECT_THAT(refusal(folder.write("noise.tif", "II*\0garbage garbage garbage")),
              HasSubstr("not a readable GeoTIFF"));
  const std::filesystem::path file = folder.path() / "cut.tif";
  writeMap(file, roughMap({200, 200}), {oddView(), true});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_FALSE(refusal(file).empty());
}

TEST(Raster, RowsThatStayInAFileAreThoseInMemory) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "map.tif";
  writeMap(file, roughMap({201, 130}), {oddView(), true});
  for (const bool with_origins : {true, false}) {
    SCOPED_TRACE(with_origins);
    if (!with_origins) folder.write("map.origin.tif", "II*");
    const RasterMap whole = importRaster(file);
    const RasterRows rows = importRasterRows(file, folder.path());
    EXPECT_EQ(englishTexts(rows.head().info.warnings), englishTexts(whole.info.warnings));
    EXPECT_EQ(rows.head().info.bounds, whole.info.bounds);
    EXPECT_EQ(rows.head().info.file, file);
    EXPECT_EQ(rows.head().view_from_file, whole.view_from_file);
    EXPECT_EQ(rows.hasOrigins(), with_origins);
    ASSERT_EQ(whole.origins.size(), with_origins ? whole.values.size() : 0);
    std::vector<float> heights(201UL * 7);
    std::vector<CellStatus> origins(heights.size());
    for (int row = 0; row + 7 <= 130; row += 11) {
      rows.read(row, 7, heights.data(), origins.data());
      for (std::size_t i = 0; i < heights.size(); ++i) {
        const std::size_t cell = static_cast<std::size_t>(row) * 201 + i;
        ASSERT_EQ(!std::isnan(heights[i]), whole.valid[cell]);
        if (whole.valid[cell]) {
          ASSERT_EQ(heights[i], whole.values[cell]);
        }
        if (with_origins) {
          ASSERT_EQ(origins[i], whole.origins[cell]);
        }
      }
    }
  }
  EXPECT_THAT(test::refusalOf([&] { importRasterRows(file, folder.path() / "absent"); }).words,
              HasSubstr("cannot keep heights in"));
  EXPECT_THAT(
      test::refusalOf([&] { importRasterRows(folder.write("a.tif", "II*"), folder.path()); }).words,
      HasSubstr("Cannot read a.tif"));
}

// ---- PNG, plain TIFF, ESRI ASCII grid -------------------------------------------------------

/// Written by way of a TIFF in memory, because GDAL cannot fill a PNG cell by cell.
std::filesystem::path writePicture(const TemporaryFolder& folder, const std::string& name,
                                   const char* driver, GDALDataType type, int bands = 1) {
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  GDALDataset* memory = drivers.GetDriverByName("MEM")->Create("", 3, 2, bands, type, nullptr);
  std::vector<double> cells{0, 10, 20, 30, 40, type == GDT_Byte ? 250.0 : 60000.0};
  for (int band = 1; band <= bands; ++band) {
    EXPECT_EQ(memory->GetRasterBand(band)->RasterIO(GF_Write, 0, 0, 3, 2, cells.data(), 3, 2,
                                                    GDT_Float64, 0, 0, nullptr),
              CE_None);
  }
  std::filesystem::path file = folder.path() / name;
  GDALClose(drivers.GetDriverByName(driver)->CreateCopy(file.c_str(), memory, 0, nullptr, nullptr,
                                                        nullptr));
  GDALClose(memory);
  return file;
}

TEST(Raster, PicturesOfHeightsHaveOneUnitAPixelAndRowZeroLowest) {
  const TemporaryFolder folder;
  const std::vector<std::tuple<std::string, const char*, GDALDataType, std::string>> cases{
      {"a.png", "PNG", GDT_Byte, "PNG Byte"},
      {"b.png", "PNG", GDT_UInt16, "PNG UInt16"},
      {"a.tif", "GTiff", GDT_UInt16, "GeoTIFF UInt16"},
      {"b.tif", "GTiff", GDT_Float32, "GeoTIFF Float32"},
      {"c.tif", "GTiff", GDT_UInt32, "GeoTIFF UInt32"}};
  for (const auto& [name, driver, type, format] : cases) {
    SCOPED_TRACE(name);
    const std::filesystem::path file = writePicture(folder, name, driver, type);
    EXPECT_EQ(inputFacts(file).kind, InputKind::raster);
    const RasterMap raster = readRaster(file);
    EXPECT_EQ(raster.info.format, format);
    EXPECT_EQ(raster.size, (GridSize{3, 2}));
    EXPECT_EQ(raster.pixel, 1);
    EXPECT_EQ(raster.values[0], 30);
    EXPECT_EQ(raster.values[5], 20);
    EXPECT_EQ(raster.info.bounds->max.z, type == GDT_Byte ? 250 : 60000);
    ASSERT_EQ(raster.info.warnings.size(), 1U);
    EXPECT_THAT(englishText(raster.info.warnings[0]), HasSubstr("no georeference"));
  }
  EXPECT_THAT(refusal(writePicture(folder, "photo.png", "PNG", GDT_Byte, 3)),
              HasSubstr("colour picture"));
}

TEST(Raster, AsciiGridsKeepTheirPlaceAndNodata) {
  const TemporaryFolder folder;
  const std::string cells = "NODATA_value -9999\n1.5 2 3\n4 -9999 6\n";
  const std::string head = "3\nNROWS 2\nXLLCORNER 600000\nYLLCORNER 5400000\nCELLSIZE 0.5\n";
  for (const char* const first : {"NCOLS ", "ncols        "}) {
    const auto file = folder.write("grid.asc", std::string(first).append(head).append(cells));
    EXPECT_EQ(inputFacts(file).kind, InputKind::raster);
    const RasterMap raster = readRaster(file);
    EXPECT_EQ(raster.info.format, "ESRI ASCII grid Float32");
    EXPECT_EQ(raster.pixel, 0.5);
    EXPECT_EQ(raster.first, (FilePoint{600000.25, 5400000.25, 0}));
    EXPECT_EQ(raster.info.points, 6U);
    EXPECT_EQ(raster.info.finite_points, 5U);
    EXPECT_EQ(raster.values[0], 4);
    EXPECT_FALSE(raster.valid[1]);
    EXPECT_EQ(raster.values[3], 1.5F);
  }
}

TEST(Raster, DamagedPicturesAndGridsAreRefusedWithASentence) {
  const TemporaryFolder folder;
  const auto grid = [&folder](const std::string& content) {
    return refusal(folder.write("grid.asc", content));
  };
  const std::string place = "xllcorner 0\nyllcorner 0\ncellsize 1\n";
  EXPECT_THAT(grid("ncols 3\n"), HasSubstr("Cannot read grid.asc"));
  EXPECT_THAT(grid("ncols 3\nnrows 2\n" + place + "1 2 3\n"), HasSubstr("Cannot read grid.asc"));
  EXPECT_THAT(grid("ncols 20000\nnrows 20000\n" + place + "1 2 3\n"), HasSubstr("promises"));
  EXPECT_THAT(grid("ncols 99999999999\nnrows 2\n" + place + "1 2 3\n"),
              HasSubstr("Cannot read grid.asc"));
  EXPECT_THAT(grid("ncols -3\nnrows 2\n" + place + "1 2 3\n"), HasSubstr("Cannot read grid.asc"));
  EXPECT_THAT(grid("ncols 3\nnrows 2\n" + place + "1 2 3\n4 5\n"),
              HasSubstr("Cannot read grid.asc"));
  EXPECT_THAT(refusal(folder.write("noise.png", "\x89PNG\r\n\x1a\n garbage")),
              HasSubstr("not a readable PNG"));
  const auto file = writePicture(folder, "cut.png", "PNG", GDT_UInt16);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 20);
  EXPECT_THAT(refusal(file), HasSubstr("Cannot read cut.png"));
}

TEST(Raster, SharedElevationModelOpens) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  const RasterMap raster = readRaster(data / "dem" / "synthetic_dem15_0.50.tif");
  EXPECT_FALSE(raster.is_own_map);
  EXPECT_EQ(raster.pixel, 0.5);
  EXPECT_EQ(raster.info.points, raster.size.count());
  EXPECT_LT(raster.info.bounds->min.z, raster.info.bounds->max.z);
}

}  // namespace
}  // namespace relievo
