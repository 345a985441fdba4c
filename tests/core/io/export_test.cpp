// SPDX-License-Identifier: BSD-3-Clause
// Every export is opened again, by our readers or by the library that its users have, and holds
// the same heights at the same places.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "core/base/error.h"
#include "core/io/export/export_grid.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

/// 7 x 5 samples: a slope, one hole on the base plane, one cell outside, one below the plane.
DepthMap smallMap() {
  DepthMap map{.frame = {.size = {7, 5}, .spacing_mm = 0.1, .first_x_mm = 0.05, .first_y_mm = 0.05},
               .heights_mm = {},
               .origins = std::vector<CellStatus>(35, CellStatus::measured)};
  for (int i = 0; i < 35; ++i) map.heights_mm.push_back(0.3F * static_cast<float>(i) + 1 / 3.0F);
  map.origins[16] = CellStatus::base_plane;
  map.heights_mm[16] = 0;
  map.origins[34] = CellStatus::outside;
  map.heights_mm[34] = 0;
  map.heights_mm[3] = -0.7F;
  map.heights_mm[4] = 2;  // A whole number among the others.
  return map;
}

class Export : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const ExportGrid& grid) const {
    std::filesystem::path file = folder_.path() / name;
    exportGrid(file, grid, *exportFormatOf(file));
    return file;
  }
  static void expectSame(const RasterMap& raster, const ExportGrid& grid) {
    ASSERT_EQ(raster.size, grid.size);
    EXPECT_NEAR(raster.pixel, grid.spacing, 1e-12 * grid.spacing);
    EXPECT_NEAR(raster.first.x, grid.first_x, 1e-12 * std::abs(grid.first_x));
    EXPECT_NEAR(raster.first.y, grid.first_y, 1e-12 * std::abs(grid.first_y));
    for (std::size_t i = 0; i < grid.heights.size(); ++i) {
      ASSERT_EQ(raster.valid[i], grid.holds(i)) << i;
      if (grid.holds(i)) {
        ASSERT_EQ(raster.values[i], grid.heights[i]) << i;
      }
    }
  }
  test::TemporaryFolder folder_;
};

TEST_F(Export, GeoTiffHoldsTheHeightsAndAMaskBand) {
  const ExportGrid grid = viewGrid(smallMap());
  const auto file = write("map.tif", grid);
  expectSame(importRaster(file), grid);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".msk"));
  auto* const dataset = GDALDataset::Open(file.c_str(), GDAL_OF_RASTER);
  ASSERT_NE(dataset, nullptr);
  EXPECT_EQ(dataset->GetRasterBand(1)->GetRasterDataType(), GDT_Float32);
  std::vector<std::uint8_t> mask(35);
  GDALRasterBand* const band = dataset->GetRasterBand(1)->GetMaskBand();
  EXPECT_EQ(band->RasterIO(GF_Read, 0, 0, 7, 5, mask.data(), 7, 5, GDT_Byte, 0, 0, nullptr),
            CE_None);
  EXPECT_EQ(mask[6], 0);  // The last cell of the top row, which a file has first.
  EXPECT_EQ(std::count(mask.begin(), mask.end(), 255), 34);
  GDALClose(dataset);
}

TEST_F(Export, AsciiGridHoldsTheSameFloats) {
  ExportGrid grid = viewGrid(smallMap());
  grid.first_x = 512022.46875;
  grid.first_y = 5403117.5;
  grid.heights[0] = 2;  // GDAL decides by the first cells whether numbers are whole.
  expectSame(importRaster(write("map.asc", grid)), grid);
}

TEST_F(Export, VtiOpensInVtk) {
  const ExportGrid grid = viewGrid(smallMap());
  const vtkNew<vtkXMLImageDataReader> reader;
  const auto file = write("map.vti", grid);
  ASSERT_TRUE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 7);
  EXPECT_EQ(image->GetDimensions()[1], 5);
  EXPECT_EQ(image->GetOrigin()[0], 0.05);
  EXPECT_EQ(image->GetSpacing()[1], 0.1);
  auto* const heights = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("height"));
  auto* const origins = image->GetPointData()->GetArray("origin");
  ASSERT_NE(heights, nullptr);
  ASSERT_NE(origins, nullptr);
  for (int i = 0; i < 35; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(origins->GetTuple1(i), static_cast<double>(grid.origins[at]));
    if (grid.holds(at)) {
      EXPECT_EQ(heights->GetValue(i), grid.heights[at]);
    } else {
      EXPECT_TRUE(std::isnan(heights->GetValue(i)));
    }
  }
}

TEST_F(Export, PlyAndXyzHoldEveryCellThatHasAHeight) {
  const ExportGrid grid = viewGrid(smallMap());
  const Scan mesh = importScan(write("map.ply", grid));
  EXPECT_EQ(mesh.info.unit, LengthUnit::mm);
  EXPECT_EQ(mesh.triangles.size(), 2U * (6 * 4 - 1));
  const Scan cloud = importScan(write("map.xyz", grid));
  for (const Scan& scan : {mesh, cloud}) {
    ASSERT_EQ(scan.points.size(), 34U);
    for (std::size_t i = 0; i < 34; ++i) {  // The missing cell is the last one.
      const auto col = static_cast<double>(i % 7);
      const auto row = static_cast<double>(i / 7);
      EXPECT_NEAR(scan.point(i).x, 0.05 + 0.1 * col, 1e-6);
      EXPECT_NEAR(scan.point(i).y, 0.05 + 0.1 * row, 1e-6);
      EXPECT_EQ(scan.points[i][2], grid.heights[i]);
    }
  }
}

TEST_F(Export, StlIsAClosedPlateOfTheRightVolume) {
  const ExportGrid grid = viewGrid(smallMap());
  const auto file = folder_.path() / "plate.stl";
  exportGrid(file, grid, ExportFormat::stl, {.plate_mm = 2});
  const Scan solid = importScan(file);
  using Corner = std::array<float, 3>;
  std::map<std::pair<Corner, Corner>, int> edges;
  double volume = 0;
  std::map<std::pair<float, float>, float> highest;
  for (const auto& t : solid.triangles) {
    std::array<std::array<double, 3>, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& from = solid.points[t[i]];
      ++edges[{from, solid.points[t[(i + 1) % 3]]}];
      for (std::size_t axis = 0; axis < 3; ++axis) p[i][axis] = static_cast<double>(from[axis]);
      const auto [place, first] = highest.try_emplace({from[0], from[1]}, from[2]);
      if (!first) place->second = std::max(place->second, from[2]);
    }
    volume += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
               p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
              6;
  }
  for (const auto& [edge, times] : edges) {
    EXPECT_EQ(times, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  // Below every cell two triangles: the mean height above the bottom at -0.7 - 2.
  double expected = 0;
  for (int row = 0; row < 4; ++row) {
    for (int col = 0; col < 6; ++col) {
      const auto z = [&](int c, int r) {
        return static_cast<double>(grid.heights[grid.size.index({c, r})]) + 2.7;
      };
      const double a = z(col, row);
      const double b = z(col + 1, row);
      const double c = z(col + 1, row + 1);
      const double d = z(col, row + 1);
      expected += 0.01 / 6 * ((a + b + c) + (a + c + d));
    }
  }
  EXPECT_NEAR(volume, expected, 1e-5 * expected);
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const auto x = static_cast<float>(static_cast<double>(i % 7) * 0.1);
    const auto y = static_cast<float>(static_cast<double>(i / 7) * 0.1);
    EXPECT_EQ(highest.at({x, y}), grid.heights[i]);
  }
}

TEST_F(Export, AnElevationModelGoesBackWhereItCameFrom) {
  RasterMap raster;
  raster.size = {3, 2};
  raster.pixel = 0.5;
  raster.first = {512022.1, 5403117.3, 0};
  raster.projection = R"(LOCAL_CS["site",UNIT["metre",1]])";
  raster.info.unit = LengthUnit::m;
  raster.values = {250.1F, 250.2F, 250.3F, 251, 0, 252.7F};
  raster.valid = {true, true, true, true, false, true};
  DepthMap map{.frame = {.size = {3, 2}, .spacing_mm = 500, .first_x_mm = 250, .first_y_mm = 250},
               .heights_mm = {0, 100, 200, 900, 450, 2600},
               .origins = std::vector<CellStatus>(6, CellStatus::measured)};
  map.origins[4] = CellStatus::interpolated;
  ViewFromFile view;
  view.m = {1000, 0, 0,    250 - 512022100.0, 0, 1000, 0, 250 - 5403117300.0,
            0,    0, 1000, -250100,           0, 0,    0, 1};
  const auto grid = fileGrid(map, view, LengthUnit::m, &raster);
  ASSERT_TRUE(grid.has_value());
  EXPECT_EQ(grid->heights[5], 252.7F);
  EXPECT_NEAR(grid->heights[4], 250.55, 1e-4);
  for (const char* name : {"dem.tif", "dem.asc"}) {
    SCOPED_TRACE(name);
    const RasterMap back = importRaster(write(name, *grid));
    expectSame(back, *grid);
    EXPECT_EQ(back.info.unit, LengthUnit::m);
  }
  // Without the raster the place comes from the view, to its rounding.
  EXPECT_NEAR(fileGrid(map, view, LengthUnit::m)->first_x, 512022.1, 1e-9 * 512022);
  view.m[0] = 0;
  view.m[1] = 1000;
  EXPECT_FALSE(fileGrid(map, view, LengthUnit::m).has_value());
}

TEST_F(Export, StatesTheSystemOfAFileOfPointsIfItIsInTheGridsUnit) {
  const auto stating = [](const std::string& stated, LengthUnit unit) {
    ExportGrid grid;
    grid.unit = name(unit);
    stateSystem(grid, stated, unit);
    return grid;
  };
  const ExportGrid utm = stating("EPSG:26910", LengthUnit::m);
  EXPECT_NE(utm.projection.find("UTM zone 10N"), std::string::npos);
  EXPECT_TRUE(utm.left_out.empty());
  // Its own text, as LAS files have it, says the same.
  EXPECT_EQ(stating(utm.projection, LengthUnit::m).projection, utm.projection);
  const ExportGrid both = stating("EPSG:26910+5703", LengthUnit::m);
  EXPECT_NE(both.projection.find("NAVD88"), std::string::npos);
  // Heights in feet over metres: only what is true of the grid.
  const ExportGrid mixed = stating("EPSG:26910+6360", LengthUnit::m);
  EXPECT_EQ(mixed.projection.find("NAVD88"), std::string::npos);
  EXPECT_NE(mixed.projection.find("UTM zone 10N"), std::string::npos);
  EXPECT_EQ(mixed.left_out.size(), 1U);
  for (const std::string& stated : {std::string("EPSG:26910"), std::string("EPSG:4326"),
                                    std::string("GeoTIFF 1024=1"), std::string("/etc/hostname")}) {
    SCOPED_TRACE(stated);
    const ExportGrid without = stating(stated, LengthUnit::ft);
    EXPECT_TRUE(without.projection.empty());
    EXPECT_EQ(without.left_out.size(), 1U);
  }
  EXPECT_TRUE(stating("", LengthUnit::m).left_out.empty());
}

/// A raster of metres whose heights are in feet above a datum, as another program writes it.
std::filesystem::path heightsInFeet(const std::filesystem::path& file, int vertical_epsg,
                                    const char* unit_of_band) {
  GDALAllRegister();
  auto* const made = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(file.c_str(), 3, 2, 1,
                                                                              GDT_Float64, nullptr);
  std::array<double, 6> place{500000, 0.5, 0, 4100000, 0, -0.5};
  made->SetGeoTransform(place.data());
  OGRSpatialReference flat, all;
  flat.importFromEPSG(26910);  // NAD83, UTM zone 10 N, metres.
  if (vertical_epsg != 0) {
    OGRSpatialReference vertical;
    vertical.importFromEPSG(vertical_epsg);
    all.SetCompoundCS("NAD83 / UTM zone 10N + height (ftUS)", &flat, &vertical);
  }
  made->SetSpatialRef(vertical_epsg != 0 ? &all : &flat);
  if (unit_of_band != nullptr) made->GetRasterBand(1)->SetUnitType(unit_of_band);
  std::vector<double> feet{100, 110, 120, 130, 140, 150};
  EXPECT_EQ(made->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 3, 2, feet.data(), 3, 2, GDT_Float64,
                                             0, 0, nullptr),
            CE_None);
  GDALClose(made);
  return file;
}

/// What was converted must not say its old unit: read again, a height is where it was.
TEST_F(Export, HeightsThatWereConvertedSayTheUnitTheyAreIn) {
  struct Case {
    int vertical;  ///< 6360: NAVD88 height in US survey feet.
    const char* unit;
  };
  for (const Case& c : {Case{6360, nullptr}, Case{0, "ft"}}) {
    SCOPED_TRACE(c.vertical);
    const auto file = heightsInFeet(folder_.path() / "feet.tif", c.vertical, c.unit);
    const RasterMap raster = importRaster(file);
    const double metres = c.vertical != 0 ? 1200.0 / 3937 : 0.3048;
    EXPECT_EQ(raster.info.unit, LengthUnit::m);
    ASSERT_NEAR(static_cast<double>(raster.values[0]), 130 * metres, 1e-5);
    DepthMap map{
        .frame = {.size = raster.size, .spacing_mm = 500, .first_x_mm = 250, .first_y_mm = 250},
        .heights_mm = std::vector<float>(6, 0),
        .origins = std::vector<CellStatus>(6, CellStatus::measured)};
    ViewFromFile view;
    view.m = {1000, 0, 0, 0, 0, 1000, 0, 0, 0, 0, 1000, 0, 0, 0, 0, 1};
    const auto grid = fileGrid(map, view, LengthUnit::m, &raster);
    ASSERT_TRUE(grid);
    EXPECT_TRUE(grid->left_out.empty());
    for (const char* const name : {"back.tif", "back.asc"}) {
      SCOPED_TRACE(name);
      const RasterMap back = importRaster(write(name, *grid));
      expectSame(back, *grid);  // Not converted once more.
      EXPECT_EQ(back.info.unit, LengthUnit::m);
    }
    const OGRSpatialReference said(grid->projection.c_str());
    EXPECT_EQ(said.IsCompound() != 0, c.vertical != 0);
    if (c.vertical == 0) continue;
    EXPECT_NE(grid->projection.find("North American Vertical Datum 1988"), std::string::npos)
        << grid->projection;
    EXPECT_EQ(grid->projection.find("ftUS"), std::string::npos) << grid->projection;
    EXPECT_NEAR(said.GetTargetLinearUnits("VERT_CS", nullptr), 1, 1e-12);
    EXPECT_NEAR(said.GetLinearUnits(nullptr), 1, 1e-12);
  }
}

TEST_F(Export, AReferenceSystemThatDoesNotAgreeWithTheUnitIsLeftOutWithAWord) {
  const RasterMap raster = importRaster(heightsInFeet(folder_.path() / "feet.tif", 6360, nullptr));
  const DepthMap map{
      .frame = {.size = raster.size, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0},
      .heights_mm = std::vector<float>(6, 0),
      .origins = std::vector<CellStatus>(6, CellStatus::measured)};
  const auto grid = fileGrid(map, {}, LengthUnit::mm, &raster);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->projection, "");
  ASSERT_EQ(grid->left_out.size(), 1U);
  EXPECT_NE(grid->left_out[0].find("reference system was left out"), std::string::npos);
}

/// The unit of a map in view millimetres can be seen by every program that asks for it.
TEST_F(Export, AMapInViewMillimetresSaysSo) {
  const auto file = folder_.path() / "map.tif";
  writeMap(file, smallMap(), {});
  const auto grid_file = write("grid.tif", viewGrid(smallMap()));
  for (const auto& name : {file, grid_file}) {
    auto* const dataset = GDALDataset::Open(name.c_str(), GDAL_OF_RASTER);
    ASSERT_NE(dataset, nullptr);
    const OGRSpatialReference* const system = dataset->GetSpatialRef();
    ASSERT_NE(system, nullptr) << name;
    EXPECT_NE(system->IsLocal(), 0);
    EXPECT_NEAR(system->GetLinearUnits(nullptr), 0.001, 1e-15);
    GDALClose(dataset);
  }
  EXPECT_EQ(importRaster(grid_file).info.unit, LengthUnit::mm);
}

/// Enclosed cells without a height lie on the base plane for the hand; in the file's coordinates
/// that would be terrain which nobody measured.
TEST_F(Export, HolesAreNoTerrainInTheFilesCoordinates) {
  DepthMap map = smallMap();
  ASSERT_EQ(map.origins[16], CellStatus::base_plane);
  ViewFromFile view;
  view.m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -500, 0, 0, 0, 1};
  const auto grid = fileGrid(map, view, LengthUnit::mm);
  ASSERT_TRUE(grid);
  EXPECT_FALSE(grid->holds(16));
  EXPECT_TRUE(grid->holds(15));
  EXPECT_TRUE(viewGrid(map).holds(16)) << "in the view it rests on the plane";
  ASSERT_EQ(grid->left_out.size(), 1U);
  EXPECT_NE(grid->left_out[0].find("1 cell without a height"), std::string::npos);
  const RasterMap back = importRaster(write("map.tif", *grid));
  EXPECT_FALSE(back.valid[16]);
  EXPECT_EQ(back.info.finite_points, 33U);
}

TEST_F(Export, PlyHasOneTypeOfNumbersForAllThreeCoordinates) {
  ExportGrid grid = viewGrid(smallMap());
  const auto header = [&] {
    std::stringstream text;
    text << std::ifstream(write("map.ply", grid)).rdbuf();
    return text.str().substr(0, text.str().find("end_header"));
  };
  EXPECT_NE(header().find("property float x\nproperty float y\nproperty float z"),
            std::string::npos);
  grid.first_x = 512022.46875;  // A float has steps of 0.03 there, the samples are 0.1 apart.
  EXPECT_NE(header().find("property double x\nproperty double y\nproperty double z"),
            std::string::npos);
  const Scan far = importScan(folder_.path() / "map.ply");
  EXPECT_NEAR(far.point(1).x, 512022.56875, 1e-6);
  EXPECT_EQ(far.points[1][2], grid.heights[1]);
}

TEST_F(Export, CloudGeoTiffHasOverviewsAndKeepsUnitAndSystem) {
  // A thousand cells across: one overview at least.
  ExportGrid grid;
  grid.size = {1100, 700};
  grid.spacing = 0.5;
  grid.first_x = 500000.25;
  grid.first_y = 4100000.25;
  grid.unit = "m";
  OGRSpatialReference utm;
  utm.importFromEPSG(32632);
  char* text = nullptr;
  utm.exportToWkt(&text);
  grid.projection = text;
  CPLFree(text);
  grid.state = "{\"where\":\"from\"}";
  for (int i = 0; i < 1100 * 700; ++i) {
    grid.heights.push_back(static_cast<float>(i % 1100) * 0.01F);
  }
  grid.origins.assign(grid.heights.size(), CellStatus::measured);
  for (std::size_t i = 0; i < 5000; ++i) grid.origins[i] = CellStatus::outside;
  const auto file = folder_.path() / "cog.tif";
  exportGrid(file, grid, ExportFormat::cloud_geotiff);
  const RasterMap back = importRaster(file);
  expectSame(back, grid);
  EXPECT_EQ(back.info.unit, LengthUnit::m);
  EXPECT_EQ(rasterState(file), grid.state);
  EXPECT_LT(std::filesystem::file_size(file), 1100U * 700 * 4);
  auto* const dataset = GDALDataset::Open(file.c_str(), GDAL_OF_RASTER);
  ASSERT_NE(dataset, nullptr);
  EXPECT_STREQ(dataset->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG");
  EXPECT_GE(dataset->GetRasterBand(1)->GetOverviewCount(), 1);
  EXPECT_STREQ(dataset->GetRasterBand(1)->GetUnitType(), "m");
  EXPECT_STREQ(dataset->GetSpatialRef()->GetAuthorityCode(nullptr), "32632");
  GDALClose(dataset);
  // Nothing else is left beside it.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
  // In view millimetres.
  exportGrid(file, viewGrid(smallMap()), ExportFormat::cloud_geotiff);
  EXPECT_EQ(importRaster(file).info.unit, LengthUnit::mm);
  expectSame(importRaster(file), viewGrid(smallMap()));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(exportGrid(folder_.path() / "no.tif", grid, ExportFormat::cloud_geotiff, {},
                          {.stop = stop.get_token(), .progress = {}}),
               Cancelled);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "no.tif"));
}

/// One number of a part of a GLB's JSON.
double numberAfter(const std::string& json, const std::string& words) {
  const std::size_t at = json.find(words);
  return at == std::string::npos ? -1 : std::strtod(json.c_str() + at + words.size(), nullptr);
}

template <class T>
std::vector<T> itemsAt(const std::string& bytes, std::size_t at, std::size_t count) {
  std::vector<T> items(count);
  std::memcpy(items.data(), bytes.data() + at, count * sizeof(T));
  return items;
}

TEST_F(Export, GltfIsAMeshInMetresWithNormalsAndColours) {
  ExportGrid grid = viewGrid(smallMap());
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    grid.heights[i] = 0.05F * static_cast<float>(i % 7);  // A slope of 1 : 2 along x.
    grid.colours.push_back({255, 128, 0, static_cast<std::uint8_t>(i)});
  }
  const auto file = write("map.glb", grid);
  std::stringstream stream;
  stream << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string bytes = stream.str();
  const auto head = itemsAt<std::uint32_t>(bytes, 0, 5);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(head[1], 2U);
  EXPECT_EQ(head[2], bytes.size());
  ASSERT_EQ(head[3] % 4, 0U);
  const std::string json = bytes.substr(20, head[3]);
  const std::size_t binary = 20 + head[3] + 8;
  EXPECT_EQ(itemsAt<std::uint32_t>(bytes, binary - 8, 1)[0], bytes.size() - binary);
  EXPECT_EQ(numberAfter(json, R"("buffers":[{"byteLength":)"), bytes.size() - binary);
  EXPECT_NE(json.find(R"("COLOR_0":2)"), std::string::npos);
  constexpr std::size_t kVertices = 34;
  const std::size_t triangles = 2U * (6 * 4 - 1);
  ASSERT_EQ(bytes.size() - binary, kVertices * (12 + 12 + 8) + triangles * 12);
  const auto places = itemsAt<std::array<float, 3>>(bytes, binary, kVertices);
  const auto normals = itemsAt<std::array<float, 3>>(bytes, binary + 12 * kVertices, kVertices);
  const auto colours =
      itemsAt<std::array<std::uint16_t, 4>>(bytes, binary + 24 * kVertices, kVertices);
  const auto corners = itemsAt<std::uint32_t>(bytes, binary + 32 * kVertices, 3 * triangles);
  EXPECT_NEAR(places[1][0] - places[0][0], 1e-4, 1e-9) << "metres";
  EXPECT_NEAR(places[7][1] - places[0][1], 1e-4, 1e-9) << "y is up";
  EXPECT_NEAR(places[1][2] - places[0][2], 5e-5, 1e-9) << "heights towards the viewer";
  EXPECT_NEAR(places[0][0] + places[6][0], 0, 1e-9) << "about the middle";
  for (const auto& n : normals) {
    EXPECT_NEAR(n[0], -1 / std::sqrt(5.0), 1e-3);
    EXPECT_NEAR(n[1], 0, 1e-3);
    EXPECT_NEAR(n[2], 2 / std::sqrt(5.0), 1e-3);
  }
  // Linear light: half of sRGB is about a fifth.
  EXPECT_EQ(colours[5], (std::array<std::uint16_t, 4>{65535, 14146, 0, 65535}));
  EXPECT_TRUE(std::all_of(corners.begin(), corners.end(), [](auto c) { return c < kVertices; }));
  EXPECT_NEAR(numberAfter(json, R"("type":"VEC3","min":[)"), places[0][0], 1e-12);

  // In a file's coordinates the map lies, and its middle is told.
  grid.is_view = false;
  grid.unit = "m";
  grid.first_x = 500000;
  grid.colours.clear();
  std::stringstream lying;
  lying << std::ifstream(write("map.glb", grid), std::ios::binary).rdbuf();
  const std::string other = lying.str();
  const std::size_t at = 28 + itemsAt<std::uint32_t>(other, 12, 1)[0];
  const auto flat = itemsAt<std::array<float, 3>>(other, at, kVertices);
  EXPECT_NEAR(flat[7][2] - flat[0][2], -0.1, 1e-6) << "north is away from the viewer";
  EXPECT_NEAR(flat[1][1] - flat[0][1], 0.05, 1e-6) << "heights are up";
  EXPECT_EQ(other.find("COLOR_0"), std::string::npos);
  EXPECT_NEAR(numberAfter(other, R"("middle":[)"), 500000.3, 1e-6);
}

TEST_F(Export, ColoursGoIntoPly) {
  ExportGrid grid = viewGrid(smallMap());
  grid.colours.assign(grid.heights.size(), {10, 20, 30, 255});
  std::stringstream text;
  text << std::ifstream(write("map.ply", grid), std::ios::binary).rdbuf();
  EXPECT_NE(text.str().find("property uchar red\nproperty uchar green\nproperty uchar blue\n"
                            "property uchar alpha\n"),
            std::string::npos);
  EXPECT_EQ(importScan(folder_.path() / "map.ply").points.size(), 34U);
  grid.colours.resize(3);
  EXPECT_THROW(write("map.ply", grid), ArgumentError);
}

TEST_F(Export, WhatCannotBeWrittenLeavesWhatWasThere) {
  const auto file = folder_.write("map.xyz", "older");
  DepthMap nothing = smallMap();
  nothing.origins.assign(35, CellStatus::outside);
  EXPECT_THROW(exportGrid(file, viewGrid(nothing), ExportFormat::xyz), ArgumentError);
  EXPECT_THROW(
      exportGrid(folder_.path() / "no" / "map.vti", viewGrid(smallMap()), ExportFormat::vti),
      WriteError);
  EXPECT_THROW(exportGrid(file, viewGrid(smallMap()), ExportFormat::stl, {.plate_mm = 0}),
               ArgumentError);
  std::stringstream content;
  content << std::ifstream(file).rdbuf();
  EXPECT_EQ(content.str(), "older");
  EXPECT_FALSE(exportFormatOf("map.docx").has_value());
  EXPECT_EQ(exportFormatOf("MAP.TIFF"), ExportFormat::geotiff);
}

}  // namespace
}  // namespace relievo
