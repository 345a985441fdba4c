// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/export_map.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "core/session/large/crop_level.h"
#include "core/session/large/tiled_surface.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

class ExportMap : public ::testing::Test {
 protected:
  static Surface domeFrom(const char* view) {
    SurfaceOptions options;
    options.view = ViewChoice{.name = view, .rotation = {}};
    options.unit = LengthUnit::cm;
    options.cells = 450;
    return makeSurface(
        test::latticeMesh(120, 100, 1, [](double x, double y) { return 0.01 * x * y; }), options,
        rasterize);
  }
  static std::string bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  test::TemporaryFolder folder_;
};

TEST_F(ExportMap, WritesTheWholeMapALevelOrAWindow) {
  const Surface surface = domeFrom("top");
  ASSERT_GE(surface.pyramid.levels.size(), 2U);
  MapExport choice{.format = ExportFormat::ascii_grid};
  EXPECT_EQ(exportedSize(surface, choice), surface.map.frame.size);
  EXPECT_EQ(exportMap(folder_.path() / "a.asc", surface, choice, nullptr).size,
            surface.map.frame.size);
  choice.part = ExportPart::level;
  choice.region.level = {1};
  EXPECT_EQ(exportedSize(surface, choice), surface.pyramid.levels[1].frame.size);
  const ExportedMap level = exportMap(folder_.path() / "b.asc", surface, choice, nullptr);
  EXPECT_EQ(level.size, surface.pyramid.levels[1].frame.size);
  EXPECT_EQ(level.spacing, surface.pyramid.levels[1].frame.spacing_mm);
  const RasterMap back = importRaster(folder_.path() / "b.asc");
  const DepthMap cut = cropLevel(surface, {1});
  ASSERT_EQ(back.values.size(), cut.heights_mm.size());
  for (std::size_t i = 0; i < back.values.size(); ++i) {
    ASSERT_EQ(back.valid[i], cut.origins[i] != CellStatus::outside) << i;
    if (back.valid[i]) {
      ASSERT_EQ(back.values[i], cut.heights_mm[i]) << i;
    }
  }
  choice.part = ExportPart::window;
  choice.region = wholeRegion(surface.ladder);
  choice.region.side_mm /= 4;
  EXPECT_EQ(exportMap(folder_.path() / "c.asc", surface, choice, nullptr).size,
            (GridSize{200, 200}));
  EXPECT_EQ(importRaster(folder_.path() / "c.asc").size, (GridSize{200, 200}));
}

TEST_F(ExportMap, FileCoordinatesNeedAViewFromTheTop) {
  MapExport choice{.format = ExportFormat::xyz, .in_file_frame = true};
  const ExportedMap written = exportMap(folder_.path() / "a.xyz", domeFrom("top"), choice, nullptr);
  EXPECT_EQ(written.unit, "cm");
  EXPECT_NEAR(importScan(folder_.path() / "a.xyz").info.bounds->max.x, 119, 1e-3);
  EXPECT_THROW(exportMap(folder_.path() / "b.xyz", domeFrom("front"), choice, nullptr),
               ArgumentError);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "b.xyz"));
}

TEST_F(ExportMap, WhatAFileOfPointsSaysOfItsSystemIsStatedOrSaidToBeLeftOut) {
  Surface surface = domeFrom("top");
  surface.info.reference_system = "EPSG:26910";  // Metres.
  const MapExport choice{.format = ExportFormat::geotiff, .in_file_frame = true};
  EXPECT_EQ(exportedGrid(surface, choice, nullptr).left_out.size(), 1U);
  surface.info.reference_system = R"(LOCAL_CS["bench",UNIT["centimetre",0.01]])";
  const ExportGrid local = exportedGrid(surface, choice, nullptr);
  EXPECT_EQ(local.left_out.size(), 1U);  // No system of the earth.
  surface.info.reference_system.clear();
  EXPECT_TRUE(exportedGrid(surface, choice, nullptr).left_out.empty());
}

TEST_F(ExportMap, TheWholeMapAsGeoTiffIsOneThatOpensAsItIs) {
  const Surface surface = domeFrom("front");
  exportMap(folder_.path() / "map.tif", surface, {.state = "state"}, nullptr);
  const RasterMap back = importRaster(folder_.path() / "map.tif");
  EXPECT_TRUE(back.is_own_map);
  EXPECT_EQ(back.origins, surface.map.origins);
  EXPECT_EQ(rasterState(folder_.path() / "map.tif"), "state");
  exportMap(folder_.path() / "cog.tif", surface,
            {.format = ExportFormat::cloud_geotiff, .state = "state"}, nullptr);
  EXPECT_EQ(importRaster(folder_.path() / "cog.tif").info.unit, LengthUnit::mm);
  EXPECT_EQ(rasterState(folder_.path() / "cog.tif"), "state");
}

/// A part of a raster keeps its reference system.
TEST_F(ExportMap, ALevelOfARasterKeepsItsSystem) {
  RasterMap raster;
  raster.size = {450, 300};
  raster.pixel = 0.5;
  raster.first = {1000, 2000, 0};
  raster.projection = R"(LOCAL_CS["site",UNIT["metre",1]])";
  raster.info.unit = LengthUnit::m;
  raster.info.file = "site.tif";
  for (int i = 0; i < 450 * 300; ++i) raster.values.push_back(static_cast<float>(i % 450));
  raster.valid.assign(raster.values.size(), true);
  const Surface surface = makeSurface(raster, {});
  MapExport choice{.part = ExportPart::level, .region = {}, .in_file_frame = true};
  choice.region.level = {1};
  const ExportGrid grid = exportedGrid(surface, choice, &raster);
  EXPECT_EQ(grid.projection, raster.projection);
  EXPECT_EQ(grid.spacing, 1);
  EXPECT_NEAR(grid.first_x, 1000, 1e-9);
  EXPECT_EQ(grid.unit, "m");
  EXPECT_TRUE(grid.left_out.empty());
  choice.part = ExportPart::map;
  EXPECT_EQ(exportedGrid(surface, choice, &raster).heights, raster.values) << "to the bit";
}

}  // namespace
}  // namespace relievo
