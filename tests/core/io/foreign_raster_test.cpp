// SPDX-License-Identifier: BSD-3-Clause
// No file that another program may have written is parsed by GDAL in the program itself: only the
// import worker does that. GDAL tells of every dataset that it opens where it is asked to.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/export/export_grid.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/raster_rows.h"
#include "core/io/raster/tiff_head.h"
#include "core/project/embedded_state.h"
#include "core/session/load.h"
#include "core/session/map_facts.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

/// Counts what GDAL opens in this process while it lives.
class OpenedByGdal {
 public:
  OpenedByGdal() {
    CPLSetConfigOption("CPL_DEBUG", "ON");
    CPLSetErrorHandlerEx(&OpenedByGdal::hear, this);
  }
  ~OpenedByGdal() {
    CPLSetErrorHandlerEx(nullptr, nullptr);
    CPLSetConfigOption("CPL_DEBUG", nullptr);
  }
  OpenedByGdal(const OpenedByGdal&) = delete;
  OpenedByGdal& operator=(const OpenedByGdal&) = delete;
  const std::string& words() const { return words_; }

 private:
  static void hear(CPLErr, CPLErrorNum, const char* message) {
    auto* self = static_cast<OpenedByGdal*>(CPLGetErrorHandlerUserData());
    if (std::string_view(message).find("GDALOpen") == std::string_view::npos) return;
    self->words_ += std::string(message) + "\n";
  }
  std::string words_;
};

std::filesystem::path foreignRaster(const std::filesystem::path& file, const char* metadata = "") {
  GDALAllRegister();
  GDALDataset* const made = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      file.c_str(), 40, 30, 1, GDT_Float32, nullptr);
  std::array<double, 6> place{100, 1, 0, 200, 0, -1};
  made->SetGeoTransform(place.data());
  OGRSpatialReference system;
  system.importFromEPSG(32632);
  made->SetSpatialRef(&system);
  if (*metadata != '\0') made->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", metadata);
  std::vector<float> heights(40 * 30);
  for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = static_cast<float>(i % 17);
  EXPECT_EQ(made->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 40, 30, heights.data(), 40, 30,
                                             GDT_Float32, 0, 0, nullptr),
            CE_None);
  GDALClose(made);
  return file;
}

TEST(ForeignRaster, IsOpenedByGdalInTheWorkerOnly) {
  const test::TemporaryFolder folder;
  const auto file = foreignRaster(folder.path() / "site.tif", "words of another program");
  {
    // The judge hears what it is to hear.
    const OpenedByGdal opened;
    GDALClose(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
    ASSERT_NE(opened.words(), "");
  }
  const OpenedByGdal opened;
  EXPECT_EQ(inputFacts(file).kind, InputKind::raster);
  EXPECT_FALSE(TiledMap::isOne(file));
  EXPECT_EQ(rasterState(file), "words of another program");
  EXPECT_FALSE(embeddedProject(file).has_value());
  EXPECT_FALSE(isOwnTiff(file));
  EXPECT_THROW(TiledMap{file}, FileError);
  EXPECT_EQ(importRaster(file).values.size(), 1200U);
  EXPECT_EQ(importRasterRows(file, folder.path()).head().size.cols, 40);
  const Surface surface = loadSurface(file, {}, rasterize, {}, {});
  EXPECT_EQ(surface.map.frame.size.cols, 40);
  EXPECT_THROW(requireOwnOrAbsent(file), WriteError);
  EXPECT_EQ(opened.words(), "");
}

TEST(ForeignRaster, FilesThatClaimToBeOursAreNotOpenedByGdalEither) {
  const test::TemporaryFolder folder;
  const DepthMap map{.frame = {.size = {300, 280}, .spacing_mm = 0.5},
                     .heights_mm = std::vector<float>(300 * 280, 2),
                     .origins = std::vector<CellStatus>(300 * 280, CellStatus::measured)};
  LevelFiles files(folder.path() / "map.tif", map.frame, {});
  for (int row = 0; row < 280; ++row) files.add(&map.heights_mm[0], &map.origins[0]);
  files.finish({}, "state");
  const OpenedByGdal opened;
  EXPECT_TRUE(TiledMap::isOne(folder.path() / "map.tif"));
  EXPECT_EQ(TiledMap(folder.path() / "map.tif").levelMap({0}).heights_mm, map.heights_mm);
  EXPECT_EQ(rasterState(folder.path() / "map.tif"), "state");
  EXPECT_EQ(opened.words(), "");
}

/// What our own parser says, against GDAL.
TEST(TiffHead, SaysWhatGdalSays) {
  const test::TemporaryFolder folder;
  GDALAllRegister();
  for (const char* const layout : {"", "BIGTIFF=YES", "ENDIANNESS=BIG", "TILED=YES"}) {
    SCOPED_TRACE(layout);
    const auto file = folder.path() / "a.tif";
    const char* const options[] = {layout, nullptr};
    GDALDataset* const made = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), 700, 300, 2, GDT_Float32, const_cast<char**>(*layout ? options : nullptr));
    made->SetMetadataItem("RELIEVO_VERSION", "a < b & \"c\"");
    made->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", "first line\nsecond");
    made->GetRasterBand(2)->SetMetadataItem("RELIEVO_OF_A_BAND", "x");
    GDALClose(made);
    const auto head = readTiffHead(file);
    ASSERT_TRUE(head);
    EXPECT_EQ(head->cols, 700U);
    EXPECT_EQ(head->rows, 300U);
    EXPECT_EQ(head->bands, 2U);
    EXPECT_EQ(head->bits, 32U);
    EXPECT_EQ(head->sample_format, 3U);
    EXPECT_EQ(head->little_endian, std::string_view(layout) != "ENDIANNESS=BIG");
    EXPECT_EQ(head->facts.at("RELIEVO_VERSION"), "a < b & \"c\"");
    EXPECT_EQ(head->facts.at("TIFFTAG_IMAGEDESCRIPTION"), "first line\nsecond");
    EXPECT_FALSE(head->facts.contains("RELIEVO_OF_A_BAND"));
    EXPECT_EQ(head->tile_cols, std::string_view(layout) == "TILED=YES" ? 256U : 0U);
  }
}

/// Cut or changed anywhere it is nothing, or something within its bounds, and never a crash.
TEST(TiffHead, DamagedFilesAreNone) {
  const test::TemporaryFolder folder;
  const auto good = foreignRaster(folder.path() / "good.tif", "words");
  std::ifstream in(good, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_FALSE(readTiffHead(folder.write("a.tif", "II*")));
  EXPECT_FALSE(readTiffHead(folder.write("a.tif", "no TIFF at all")));
  EXPECT_FALSE(readTiffHead(folder.write("a.tif", bytes.substr(0, 8))));
  std::uint64_t seed = 12345;
  const auto next = [&seed] {
    return seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
  };
  for (int i = 0; i < 500; ++i) {
    std::string changed = bytes;
    for (int k = 0; k < 3; ++k) {
      const std::size_t most = std::min<std::size_t>(changed.size(), 600);
      const std::size_t at = (next() >> 33U) % most;
      changed[k % 2 == 0 ? at : changed.size() - 1 - at] = static_cast<char>(next() >> 40U);
    }
    changed.resize(changed.size() - (next() >> 33U) % 300);
    const auto head = readTiffHead(folder.write("a.tif", changed));
    if (!head) continue;
    EXPECT_LE(head->tile_offsets.size(), changed.size());
  }
}

}  // namespace
}  // namespace relievo
