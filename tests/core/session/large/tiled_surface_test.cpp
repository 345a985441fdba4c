// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/tiled_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/measure/measure_text.h"
#include "core/project/caption.h"
#include "core/provenance/provenance.h"
#include "core/session/finer_heights.h"
#include "core/session/large/crop_level.h"
#include "core/session/map_facts.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/session/tiled_fixture.h"

namespace relievo {
namespace {

constexpr GridSize kSize{.cols = 1400, .rows = 900};

bool sameMap(const DepthMap& a, const DepthMap& b) {
  return a.frame == b.frame && a.heights_mm == b.heights_mm && a.origins == b.origins;
}

std::vector<PlaceMm> circle(double x, double y, double radius) {
  std::vector<PlaceMm> places;
  places.reserve(40);
  for (int i = 0; i < 40; ++i) {
    places.push_back(
        {.x = x + radius * std::cos(i * 0.157), .y = y + radius * std::sin(i * 0.157)});
  }
  return places;
}

/// Every kind, across tiles, the hole, the patch and beyond the map's edge.
std::vector<Measurement> someOfEach() {
  using enum MeasureKind;
  return {{.name = "point", .kind = point, .places = {{32.01, 63.97}}},
          {.name = "corner", .kind = point, .places = {{175, 112.5}}},
          {.name = "distance", .kind = distance, .places = {{31.9, 64.1}, {160, 20}}},
          {.name = "depth", .kind = depth, .places = {{87.5, 56.2}, {150, 100}}},
          {.name = "angle", .kind = angle, .places = {{80, 20}, {90, 90}, {150, 30}}},
          {.name = "profile", .kind = profile, .places = {{-3, 4}, {120, 67}, {174, 112}}},
          {.name = "piece", .kind = area, .places = circle(88, 56, 50), .plane_mm = 2.5},
          {.name = "all", .kind = area, .places = {{-9, -9}, {300, -9}, {300, 300}, {-9, 300}}},
          {.name = "beside", .kind = area, .places = {{-9, 4}, {-5, 4}, {-5, 20}}},
          {.name = "cut", .kind = section, .plane_mm = 3.2, .normal = {0.01, 0.02, 1}}};
}

TEST(TiledSurface, HasTheCutsOfTheMapInMemoryAtEveryLevel) {
  for (const double factor : {2.0, 1.5}) {
    SCOPED_TRACE(factor);
    const test::BothWays both(kSize, factor);
    ASSERT_EQ(both.tiled.ladder.levels(), both.whole.ladder.levels());
    for (Level level; level.value < both.tiled.ladder.levels(); ++level.value) {
      SCOPED_TRACE(level.value);
      ASSERT_EQ(levelFrame(both.tiled, level), levelFrame(both.whole, level));
      EXPECT_TRUE(sameMap(cropLevel(both.tiled, level), cropLevel(both.whole, level)));
      const GridSize size = levelFrame(both.tiled, level).size;
      const LevelSamples some{.left = size.cols / 4,
                              .right = 3 * size.cols / 4,
                              .bottom = size.rows / 3,
                              .top = 2 * size.rows / 3};
      EXPECT_TRUE(sameMap(cropLevel(both.tiled, level, some, 1.7),
                          cropLevel(both.whole, level, some, 1.7)));
    }
    EXPECT_THROW(levelFrame(both.tiled, {both.tiled.ladder.levels()}), ArgumentError);
    EXPECT_THROW(levelFrame(both.whole, {-1}), ArgumentError);
  }
}

TEST(TiledSurface, HasTheFinerHeightsOfTheMapInMemory) {
  const test::BothWays both(kSize);
  const Region region{.x_mm = 20, .y_mm = 30, .side_mm = 50, .level = {1}};
  const std::vector<float> heights = finerHeights(both.tiled, region, 2);
  EXPECT_FALSE(heights.empty());
  EXPECT_EQ(heights, finerHeights(both.whole, region, 2));
}

TEST(TiledSurface, IsMeasuredOnItsFinestLevelAsInMemory) {
  const test::BothWays both(kSize);
  ASSERT_NE(both.tiled.map.frame.size, kSize)
      << "what is held must be coarser, or this says nothing";
  const std::string by_tiles = measurementsCsv(mapCells(both.tiled), someOfEach());
  EXPECT_EQ(by_tiles, measurementsCsv(both.whole.map, someOfEach()));
  const Measurement piece = someOfEach()[6];
  EXPECT_NE(read(both.tiled.map, piece).quantities[1].value,
            read(both.whole.map, piece).quantities[1].value);
  for (const Measurement& m : someOfEach()) {
    if (m.kind != MeasureKind::profile) continue;
    EXPECT_EQ(profileCsv(profile(mapCells(both.tiled), m.places)),
              profileCsv(profile(both.whole.map, m.places)));
  }
  const PlaneMm plane{.normal = {0.01, 0.02, 1}, .offset_mm = 3.2};
  const std::string curves = sectionCsv(section(mapCells(both.tiled), plane));
  EXPECT_GT(curves.size(), 100'000U);
  EXPECT_EQ(curves, sectionCsv(section(both.whole.map, plane)));
}

TEST(TiledSurface, ReadsOnlyTheTilesUnderWhatIsMeasured) {
  const test::BothWays both({.cols = 2000, .rows = 2000});
  const Surface tiled = openTiledSurface(both.folder / "map.tif", std::size_t{1} << 20U);
  const std::size_t opened = tiled.tiles->tilesRead();
  read(mapCells(tiled), {.kind = MeasureKind::point, .places = {{120, 130}}});
  EXPECT_GT(tiled.tiles->tilesRead(), opened);
  EXPECT_LE(tiled.tiles->tilesRead() - opened, 8U);
  const std::size_t before = tiled.tiles->tilesRead();
  read(mapCells(tiled),
       {.kind = MeasureKind::area, .places = {{120, 130}, {126, 130}, {126, 136}}});
  EXPECT_LE(tiled.tiles->tilesRead() - before, 8U);
}

TEST(TiledSurface, MeasuringCanBeCancelledAndSaysWhenAFileIsDamaged) {
  const test::BothWays both(kSize);
  std::stop_source stopped;
  stopped.request_stop();
  const Measurement all{.kind = MeasureKind::area,
                        .places = {{-9, -9}, {300, -9}, {300, 300}, {-9, 300}}};
  EXPECT_THROW(read(mapCells(both.tiled, {.stop = stopped.get_token(), .progress = {}}), all),
               Cancelled);
  const auto file = both.folder / "map.tif";
  const Surface opened = openTiledSurface(file, 1);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  EXPECT_THROW(read(mapCells(opened), all), FileError);
}

TEST(TiledSurface, SaysOfTheWholeWhatTheMapInMemorySays) {
  const test::BothWays both(kSize);
  EXPECT_EQ(mapFrame(both.tiled), mapFrame(both.whole));
  EXPECT_EQ(mapFacts(both.tiled).heights.min_mm, mapFacts(both.whole).heights.min_mm);
  EXPECT_EQ(mapFacts(both.tiled).heights.max_mm, mapFacts(both.whole).heights.max_mm);
  EXPECT_EQ(mapFacts(both.tiled).shares, mapFacts(both.whole).shares);
  EXPECT_EQ(madeText(both.tiled), madeText(both.whole));
  Project project;
  project.file = "map.tif";
  project.region = {.x_mm = 20, .y_mm = 30, .side_mm = 25, .level = {0}};
  const auto caption = [&](const Surface& surface) {
    return captionOf(project, surface, windowOf(surface, project.region), {});
  };
  EXPECT_EQ(caption(both.tiled), caption(both.whole));
  EXPECT_NE(caption(both.tiled).find("1400 \u00d7 900 cells"), std::string::npos);
}

}  // namespace
}  // namespace relievo
