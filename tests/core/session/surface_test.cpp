// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stop_token>

#include "core/depth/rules/point_rule.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/raster/raster.h"
#include "core/region/window.h"
#include "data/generate/relief_f.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

Scan scanOfF() {
  const samples::Cloud cloud = samples::makeReliefF();
  Scan scan;
  for (const auto& p : cloud.points) {
    scan.points.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  test::finishScan(scan);
  return scan;
}

class ReliefF : public testing::Test {
 protected:
  static void SetUpTestSuite() { surface = new Surface(makeSurface(scanOfF(), {}, rasterize)); }
  static void TearDownTestSuite() {
    delete surface;
    surface = nullptr;
  }
  static inline Surface* surface = nullptr;
};

TEST_F(ReliefF, OpensWithItsOwnGridSeenFromTheTop) {
  EXPECT_EQ(surface->view_name, "top");
  EXPECT_EQ(surface->map.frame.size, (GridSize{.cols = 1200, .rows = 800}));
  EXPECT_DOUBLE_EQ(surface->map.frame.spacing_mm, 0.25);
  EXPECT_EQ(surface->ladder.levels(), 4);
  EXPECT_EQ(surface->unit_source, UnitSource::assumed);
  EXPECT_FALSE(surface->messages.empty());
}

TEST_F(ReliefF, EveryMeasuredHeightIsTheClosedForm) {
  const GridFrame& frame = surface->map.frame;
  double worst = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const Cell cell{.col = col, .row = row};
      const double x = frame.xMm(col);
      const double y = frame.yMm(row);
      const CellStatus expected = samples::isOutside(x, y) ? CellStatus::outside
                                  : samples::isHole(x, y)  ? CellStatus::base_plane
                                                           : CellStatus::measured;
      ASSERT_EQ(surface->map.origin(cell), expected) << x << ' ' << y;
      const double truth = expected == CellStatus::measured ? samples::reliefFHeightMm(x, y) : 0;
      worst = std::max(worst, std::abs(static_cast<double>(surface->map.heightMm(cell)) - truth));
    }
  }
  EXPECT_LT(worst, 5e-6);
}

TEST_F(ReliefF, ItsThreeHolesHaveTheirAreasAndTheCornerIsNone) {
  ASSERT_EQ(surface->holes.size(), 3U);
  EXPECT_NEAR(surface->holes[0].area_mm2, samples::reliefFHoleAreaMm2(1), 0.02 * 314);
  EXPECT_NEAR(surface->holes[1].area_mm2, samples::reliefFHoleAreaMm2(2), 0.02 * 36);
  EXPECT_NEAR(surface->holes[2].area_mm2, samples::reliefFHoleAreaMm2(3), 0.3);
  const auto shares = originShares(surface->map);
  EXPECT_NEAR(shares[static_cast<std::size_t>(CellStatus::outside)], 400.0 / 60000, 1e-9);
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
}

TEST_F(ReliefF, ViewFromFileMapsTheFilesPointsOntoTheMap) {
  const ViewMm cap_top = surface->view_from_file({90, 100, 30});
  EXPECT_NEAR(cap_top.x, 90, 1e-9);
  EXPECT_NEAR(cap_top.y, 100, 1e-9);
  EXPECT_NEAR(cap_top.z, 30, 1e-6);
}

TEST_F(ReliefF, DetailFourShowsTheGratingWithTheScaleOfTheTable) {
  const Region drawn =
      regionFromRect(surface->ladder, {.x_mm = 215, .y_mm = 125, .width_mm = 50, .height_mm = 50});
  EXPECT_EQ(surface->ladder.detailOf(drawn.level), 4);
  const RegionWindow window = sampleWindow(surface->map, surface->pyramid, drawn);
  EXPECT_DOUBLE_EQ(handMapping(window).objectMmPerHandMm(), 0.625);
  EXPECT_NEAR(window.max_mm, 5.6, 0.01);
}

TEST(MakeSurface, GivenCellsPutTheFirstAndLastSampleOnTheBox) {
  const Scan mesh = test::latticeMesh(11, 6, 1, [](double x, double y) { return 0.1 * x + y; });
  SurfaceOptions options;
  options.cells = 41;
  options.unit = LengthUnit::cm;
  options.view = ViewChoice{.name = "top", .rotation = std::nullopt};
  const Surface surface = makeSurface(mesh, options, rasterize);
  EXPECT_EQ(surface.map.frame.size, (GridSize{.cols = 41, .rows = 21}));
  EXPECT_DOUBLE_EQ(surface.map.frame.spacing_mm, 2.5);
  const ViewMm corner = surface.view_from_file({0, 0, 0});
  EXPECT_DOUBLE_EQ(corner.x, 1.25);
  EXPECT_DOUBLE_EQ(corner.y, 1.25);
  const auto shares = originShares(surface.map);
  EXPECT_DOUBLE_EQ(shares[0], 1) << "every sample of a full plane is measured, its edges too";
}

TEST(MakeSurface, HeightsAreTrueMillimetresFromEveryStandardView) {
  // A slab 30 x 20 x 4: seen from any side, its depth is the extent along the view.
  Scan slab;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 200'000; ++i) {
    slab.points.push_back({30 * uniform(random), 20 * uniform(random), 4 * uniform(random)});
  }
  test::finishScan(slab);
  for (const auto& [name, width, height] :
       {std::tuple{"top", 30.0, 20.0}, {"front", 30.0, 4.0}, {"left", 20.0, 4.0}}) {
    SurfaceOptions options;
    options.view = ViewChoice{.name = name, .rotation = std::nullopt};
    options.cells = 61;
    const Surface surface = makeSurface(slab, options, rasterize);
    EXPECT_NEAR(surface.map.widthMm() - surface.map.frame.spacing_mm, width, 0.01) << name;
    EXPECT_NEAR(surface.map.heightExtentMm(), height + surface.map.frame.spacing_mm,
                0.51 * surface.map.frame.spacing_mm)
        << name;
  }
}

TEST(MakeSurface, RefusesContradictionsAndCloudsWithoutExtent) {
  const Scan mesh = test::latticeMesh(3, 3, 1, [](double, double) { return 0.0; });
  SurfaceOptions both;
  both.cells = 10;
  both.spacing_mm = 1;
  EXPECT_THROW(makeSurface(mesh, both, rasterize), ArgumentError);
  SurfaceOptions sideways;
  sideways.view = ViewChoice{.name = "sideways", .rotation = std::nullopt};
  EXPECT_THROW(makeSurface(mesh, sideways, rasterize), ArgumentError);
  SurfaceOptions huge;
  huge.spacing_mm = 1e-9;
  EXPECT_THROW(makeSurface(mesh, huge, rasterize), ArgumentError);
  Scan point;
  point.points.push_back({1, 2, 3});
  test::finishScan(point);
  EXPECT_THROW(makeSurface(point, {}, rasterize), FileError);
}

TEST(MakeSurface, AForeignRastersLowestCellLiesOnTheBasePlane) {
  RasterMap raster;
  raster.size = {.cols = 3, .rows = 2};
  raster.values = {105, 101, 102, 103, 0, 104};
  raster.valid = {true, true, true, true, false, true};
  raster.pixel = 0.5;
  raster.first = {1000, 2000, 0};
  SurfaceOptions options;
  options.unit = LengthUnit::m;
  const Surface surface = makeSurface(raster, options);
  EXPECT_EQ(surface.map.heights_mm, (std::vector<float>{4000, 0, 1000, 2000, 0, 3000}));
  EXPECT_EQ(surface.map.origins[4], CellStatus::outside) << "nodata at the border is outside";
  EXPECT_DOUBLE_EQ(surface.map.frame.spacing_mm, 500);
  const ViewMm sample = surface.view_from_file({1000.5, 2000.5, 104});
  EXPECT_NEAR(sample.x, 750, 1e-6);
  EXPECT_NEAR(sample.z, 3000, 1e-6);
}

TEST(MakeSurface, AnOwnMapIsTakenAsItIs) {
  RasterMap raster;
  raster.size = {.cols = 2, .rows = 2};
  raster.values = {-1, 2, 3, 4};
  raster.valid = {true, true, true, false};
  raster.pixel = 0.25;
  raster.first = {0.125, 0.125, 0};
  raster.is_own_map = true;
  raster.origins = {CellStatus::measured, CellStatus::base_plane, CellStatus::interpolated,
                    CellStatus::outside};
  raster.view_from_file = ViewFromFile{};
  const Surface surface = makeSurface(raster, {});
  EXPECT_EQ(surface.map.heights_mm, (std::vector<float>{-1, 2, 3, 0}));
  EXPECT_EQ(surface.map.origins, raster.origins);
  EXPECT_EQ(surface.unit_source, UnitSource::file);
}

TEST(MakeSurface, SaysThatARuleForOneLayerMixesTheFrontWithTheBack) {
  const Scan one = test::latticeScan(60, 60, 1, [](double x, double) { return 20 + x / 10; });
  Scan two = one;
  // Behind a strip only: where much lies behind, the front alone counts, and nothing mixes.
  const Scan back = test::latticeScan(60, 2, 1, [](double, double) { return 0; });
  two.points.insert(two.points.end(), back.points.begin(), back.points.end());
  test::finishScan(two);
  const auto warned = [](const Scan& scan, std::optional<PointRule> rule) {
    SurfaceOptions options;
    options.view = ViewChoice{.name = "top", .rotation = {}};
    options.cells = 40;
    options.rule = rule;
    const std::vector<Message> said = makeSurface(scan, options, rasterize).messages;
    return englishText(said).find("makes one height of them") != std::string::npos;
  };
  for (const PointRule rule :
       {PointRule::splat, PointRule::quadratic, PointRule::mean, PointRule::median}) {
    EXPECT_TRUE(warned(two, rule)) << describe(rule);
    EXPECT_FALSE(warned(one, rule)) << describe(rule);
  }
  Scan sheets = one;
  const Scan whole_back = test::latticeScan(60, 60, 1, [](double, double) { return 0; });
  sheets.points.insert(sheets.points.end(), whole_back.points.begin(), whole_back.points.end());
  test::finishScan(sheets);
  EXPECT_FALSE(warned(sheets, PointRule::mean));
  EXPECT_FALSE(warned(two, PointRule::top_mean));
  EXPECT_FALSE(warned(two, PointRule::front));
  EXPECT_FALSE(warned(two, std::nullopt));
}

/// Points on a line, whatever line: two samples each way, which can be drawn, written and read
/// back.
TEST(MakeSurface, PointsOnALineGiveAMapThatCanBeDrawnAndReadBack) {
  const test::TemporaryFolder folder;
  for (const int axis : {0, 1}) {
    for (const bool single : {false, true}) {
      Scan scan;
      for (int i = 0; i < (single ? 2 : 500); ++i) {
        const auto along = static_cast<float>(i);
        scan.points.push_back(axis == 0 ? std::array{along, 3.0F, 0.01F * along}
                                        : std::array{3.0F, along, 0.01F * along});
      }
      test::finishScan(scan);
      SurfaceOptions options;
      options.view = ViewChoice{.name = "top", .rotation = {}};
      const Surface surface = makeSurface(scan, options, rasterize);
      const GridSize size = surface.map.frame.size;
      EXPECT_GE(size.cols, 2);
      EXPECT_GE(size.rows, 2);
      EXPECT_EQ(std::min(size.cols, size.rows), 2);
      EXPECT_NE(englishText(surface.messages).find("lie on one line of cells"), std::string::npos);
      writeMap(folder.path() / "map.tif", surface.map, {.view_from_file = surface.view_from_file});
      const RasterMap back = readRaster(folder.path() / "map.tif");
      EXPECT_EQ(back.size, size);
      EXPECT_EQ(makeSurface(back, {}).map.heights_mm, surface.map.heights_mm);
    }
  }
  // Cells much larger than the object.
  SurfaceOptions coarse;
  coarse.spacing_mm = 1000;
  const Scan square = test::latticeScan(5, 5, 1, [](double, double) { return 1; });
  EXPECT_EQ(makeSurface(square, coarse, rasterize).map.frame.size, (GridSize{2, 2}));
}

TEST(MakeSurface, StopsAtWhicheverStepItIsAskedTo) {
  const Scan scan = scanOfF();
  SurfaceOptions options;
  options.cells = 400;
  int reports = 0;
  makeSurface(scan, options, rasterize, {.stop = {}, .progress = [&](auto, double) { ++reports; }});
  ASSERT_GE(reports, 3);  // Depth map, filling, pyramid.
  for (int asked = 0; asked < reports; ++asked) {
    std::stop_source stop;
    int now = 0;
    const Task task{.stop = stop.get_token(), .progress = [&](auto, double) {
                      if (now++ == asked) stop.request_stop();
                    }};
    EXPECT_THROW(makeSurface(scan, options, rasterize, task), Cancelled) << asked;
    EXPECT_EQ(now, asked + 1) << "went on to another step";
  }
}

}  // namespace
}  // namespace relievo
