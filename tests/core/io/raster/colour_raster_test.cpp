// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/colour_raster.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "core/base/error.h"
#include "core/io/import.h"
#include "core/io/raster/raster_rows.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;

class ColourFiles : public ::testing::Test {
 protected:
  ColourFiles() {
    const GridSize size{.cols = 301, .rows = 270};  // More than a tile, and not a multiple.
    map_.frame = {.size = size, .spacing_mm = 0.25, .first_x_mm = 1.0 / 3, .first_y_mm = 0.125};
    std::mt19937 random(4);
    const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
    for (std::size_t i = 0; i < size.count(); ++i) {
      map_.origins.push_back(static_cast<CellStatus>(i % kOriginCount));
      const bool hole = map_.origins.back() == CellStatus::base_plane ||
                        map_.origins.back() == CellStatus::outside;
      map_.heights_mm.push_back(hole ? 0.F : static_cast<float>(i % 97) / 7);
      const std::uint8_t alpha = hole ? 0 : i % 3 == 0 ? kBetweenAlpha : kStoredAlpha;
      colours_.colours.push_back(hole ? Rgba{} : Rgba{byte(), byte(), byte(), alpha});
      colours_.intensities.push_back(hole ? GreyAlpha{} : GreyAlpha{byte(), alpha});
    }
  }
  void write(const GridColours& colours) const {
    writeMapWithColours(file(), map_, colours, {.view_from_file = {}});
  }
  std::filesystem::path file() const { return folder_.path() / "site.tif"; }

  TemporaryFolder folder_;
  DepthMap map_;
  GridColours colours_;
};

TEST_F(ColourFiles, ComeBackWithTheirMapToTheByte) {
  write(colours_);
  const RasterMap read = importRaster(file());
  EXPECT_EQ(read.colours.colours, colours_.colours);
  EXPECT_EQ(read.colours.intensities, colours_.intensities);
  EXPECT_TRUE(read.info.warnings.empty()) << englishText(read.info.warnings);
}

TEST_F(ColourFiles, AreWhatOtherProgramsTakeForAPictureAtTheMapsPlace) {
  write(colours_);
  GDALAllRegister();
  auto* const dataset =
      static_cast<GDALDataset*>(GDALOpen(colourFileOf(file()).c_str(), GA_ReadOnly));
  ASSERT_NE(dataset, nullptr);
  EXPECT_EQ(dataset->GetRasterCount(), 4);
  const std::array<GDALColorInterp, 4> bands{GCI_RedBand, GCI_GreenBand, GCI_BlueBand,
                                             GCI_AlphaBand};
  for (int band = 1; band <= 4; ++band) {
    EXPECT_EQ(dataset->GetRasterBand(band)->GetColorInterpretation(),
              bands[static_cast<std::size_t>(band - 1)]);
    EXPECT_EQ(dataset->GetRasterBand(band)->GetRasterDataType(), GDT_Byte);
  }
  EXPECT_STREQ(dataset->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE");
  EXPECT_STREQ(dataset->GetMetadataItem("PREDICTOR", "IMAGE_STRUCTURE"), "2");
  int cols = 0;
  int rows = 0;
  dataset->GetRasterBand(1)->GetBlockSize(&cols, &rows);
  EXPECT_EQ(cols, 256);
  std::array<double, 6> place{};
  dataset->GetGeoTransform(place.data());
  auto* const heights = static_cast<GDALDataset*>(GDALOpen(file().c_str(), GA_ReadOnly));
  std::array<double, 6> of_map{};
  heights->GetGeoTransform(of_map.data());
  EXPECT_EQ(place, of_map);
  std::array<std::uint8_t, 4> top_left{};
  EXPECT_EQ(dataset->RasterIO(GF_Read, 0, 0, 1, 1, top_left.data(), 1, 1, GDT_Byte, 4, nullptr, 4,
                              4, 1, nullptr),
            CE_None);
  EXPECT_EQ(top_left, colours_.colours[map_.frame.size.index({.col = 0, .row = 269})]);
  GDALClose(heights);
  GDALClose(dataset);
}

TEST_F(ColourFiles, OfAnotherMapAreLeftAsideWithAWord) {
  write(colours_);
  map_.heights_mm[0] += 1;
  writeMap(file(), map_, {.view_from_file = {}});  // Without its colours.
  const RasterMap read = importRaster(file());
  EXPECT_TRUE(read.colours.empty());
  ASSERT_EQ(read.info.warnings.size(), 2U);
  EXPECT_THAT(englishText(read.info.warnings[0]),
              HasSubstr("site.colour.tif belongs to another map"));
  EXPECT_THAT(englishText(read.info.warnings[1]),
              HasSubstr("site.intensity.tif belongs to another map"));
}

/// What a program leaves that is killed between two files: each is whole, and they are of two sets.
TEST_F(ColourFiles, OfTheSameHeightsInOtherColoursAreLeftAsideWithAWord) {
  write(colours_);
  const auto before = folder_.path() / "before.tif";
  std::filesystem::copy_file(colourFileOf(file()), before);
  for (Rgba& colour : colours_.colours) colour[0] = static_cast<std::uint8_t>(colour[0] / 2);
  write(colours_);
  std::filesystem::rename(before, colourFileOf(file()));
  const RasterMap read = importRaster(file());
  EXPECT_TRUE(read.colours.colours.empty());
  EXPECT_EQ(read.colours.intensities, colours_.intensities);
  ASSERT_EQ(read.info.warnings.size(), 1U);
  EXPECT_THAT(englishText(read.info.warnings[0]),
              HasSubstr("site.colour.tif belongs to another map"));
}

TEST_F(ColourFiles, AreTheSameBytesWhenWrittenAgain) {
  const auto bytes = [this] {
    std::string all;
    for (const auto& one : {file(), colourFileOf(file()), intensityFileOf(file())}) {
      std::ifstream in(one, std::ios::binary);
      all.append(std::istreambuf_iterator<char>(in), {});
    }
    return all;
  };
  write(colours_);
  const std::string first = bytes();
  write(colours_);
  EXPECT_TRUE(bytes() == first);
}

TEST_F(ColourFiles, ThatCannotBeReadAreLeftAsideWithAWord) {
  write(colours_);
  folder_.write("site.colour.tif", "II*");
  const RasterMap read = importRaster(file());
  EXPECT_TRUE(read.colours.colours.empty());
  EXPECT_EQ(read.colours.intensities, colours_.intensities);
  ASSERT_EQ(read.info.warnings.size(), 1U);
  EXPECT_THAT(englishText(read.info.warnings[0]), HasSubstr("site.colour.tif cannot be read"));
}

TEST_F(ColourFiles, OfAnOlderMapGoAndFilesOfOthersStay) {
  write(colours_);
  write({});
  EXPECT_FALSE(std::filesystem::exists(colourFileOf(file())));
  EXPECT_FALSE(std::filesystem::exists(intensityFileOf(file())));
  folder_.write("site.colour.tif", "somebody's notes");
  write({});
  EXPECT_TRUE(std::filesystem::exists(colourFileOf(file())));
  EXPECT_THROW(writeColours(file(), map_, colours_, ""), WriteError);
  EXPECT_TRUE(std::filesystem::exists(colourFileOf(file())));
}

TEST_F(ColourFiles, AreNoMapsThemselves) {
  write(colours_);
  const auto refusal = [](const auto& read) {
    try {
      read();
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const auto& companion : {colourFileOf(file()), intensityFileOf(file())}) {
    EXPECT_THAT(refusal([&] { importRaster(companion); }), HasSubstr("Open the map beside it."));
    EXPECT_THAT(refusal([&] { importRasterRows(companion, folder_.path()); }),
                HasSubstr("Open the map beside it."));
  }
}

TEST(HeightsChecksum, TellsHeightsApartAndNotWhatIsNoHeight) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 3> one{1, 0, nan};
  const std::array<float, 3> same{1, -0.0F, -nan};
  const std::array<float, 3> other{1, nan, 0};
  EXPECT_EQ(heightsChecksum(one), heightsChecksum(same));
  EXPECT_NE(heightsChecksum(one), heightsChecksum(other));
}

}  // namespace
}  // namespace relievo
