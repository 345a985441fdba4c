// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/ready_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <random>
#include <vector>

#include "core/tiles/tiled_map.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/session/tiled_fixture.h"

namespace relievo {
namespace {

using testing::ElementsAre;

constexpr double kScale = 1.0 / 512;
constexpr double kSideMm = 500;

double heightMm(double x, double y) {
  return 10 + 3 * std::sin(x / 17) * std::cos(y / 23);
}

/// The corners fix the frame, and lie lowest: at 0 mm.
test::Las relief(int points) {
  std::mt19937 random(2026);
  const int side = static_cast<int>(kSideMm / kScale);
  std::uniform_int_distribution<int> place(0, side);
  test::Las las;
  las.scale = {kScale, kScale, kScale};
  las.raw = {{0, 0, 0}, {side, side, 0}};
  while (static_cast<int>(las.raw.size()) < points) {
    const int x = place(random), y = place(random);
    const double z = heightMm(x * kScale, y * kScale);
    las.raw.push_back({x, y, static_cast<int>(std::lround(z / kScale))});
  }
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(las.raw.size());
  return las;
}

/// Cells of some rows that are not outside, and the furthest of their heights from the relief.
struct Look {
  int cells = 0;
  double furthest_mm = 0;
};
Look lookAt(const DepthMap& map, int first_row, int end_row) {
  constexpr int kAside = 2;  // The corners are none of the relief.
  Look look;
  for (int row = std::max(first_row, kAside); row < std::min(end_row, map.frame.size.rows - kAside);
       ++row) {
    for (int col = kAside; col < map.frame.size.cols - kAside; ++col) {
      if (map.origin({col, row}) == CellStatus::outside) continue;
      ++look.cells;
      const double off = static_cast<double>(map.heightMm({col, row})) -
                         heightMm(map.frame.xMm(col), map.frame.yMm(row));
      look.furthest_mm = std::max(look.furthest_mm, std::abs(off));
    }
  }
  return look;
}

TEST(ReadyRows, GoUpWithTheHeightsAndStandInASample) {
  const test::TileFolder folder;
  std::ofstream(folder / "scan.las", std::ios::binary) << test::lasFile(relief(2'500'000));
  SurfaceOptions options = test::topOptions(PointRule::median);
  options.spacing_mm = 0.5;
  std::vector<ReadyMap> told;
  makeLargeMap(folder / "scan.las", options,
               {.file = folder / "map.tif",
                .memory_bytes = 400'000'000,
                .threads = 2,
                .on_view = [](const Surface&) {},
                .on_ready = [&](const ReadyMap& ready) { told.push_back(ready); },
                .ready_every_s = 0});

  const DepthMap whole = TiledMap(folder / "map.tif").levelMap({0});
  ASSERT_EQ(told.size(), 4U);
  for (std::size_t i = 0; i < told.size(); ++i) {
    const ReadyMap& ready = told[i];
    const GridSize size = ready.map.frame.size;
    EXPECT_EQ(ready.whole.rows, whole.frame.size.rows);
    EXPECT_EQ(ready.rows, std::min<int>(256 * (static_cast<int>(i) + 1), whole.frame.size.rows));
    EXPECT_LE(std::max(size.cols, size.rows), 800);
    const int finished = (ready.rows + 1) / 2;  // Every other row is shown.
    const Look below = lookAt(ready.map, 0, finished);
    EXPECT_GT(below.cells, 0.8 * finished * size.cols) << "a twelfth of the cells has no point";
    EXPECT_LT(below.furthest_mm, 0.15);
    const Look above = lookAt(ready.map, finished, size.rows);
    EXPECT_GE(above.cells, 0.99 * (size.rows - finished - 2) * (size.cols - 4));
    EXPECT_LT(above.furthest_mm, 1) << "a sample's cells are larger";
  }

  const DepthMap& last = told.back().map;
  std::optional<float> base_mm;
  for (int row = 0; row < last.frame.size.rows; ++row) {
    for (int col = 0; col < last.frame.size.cols; ++col) {
      if (last.origin({col, row}) != CellStatus::measured) continue;
      const Cell same{2 * col, 2 * row};
      if (whole.origin(same) != CellStatus::measured) continue;
      const float base = last.heightMm({col, row}) - whole.heightMm(same);
      if (!base_mm) base_mm = base;
      ASSERT_NEAR(base, *base_mm, 1e-4) << col << ", " << row;
    }
  }
}

TEST(ReadyRows, NobodyIsToldWithoutFirstViews) {
  const test::TileFolder folder;
  std::ofstream(folder / "scan.las", std::ios::binary) << test::lasFile(relief(50'000));
  int times = 0;
  SurfaceOptions options = test::topOptions(PointRule::median);
  options.spacing_mm = 5;
  makeLargeMap(folder / "scan.las", options,
               {.file = folder / "map.tif",
                .on_view = {},
                .on_ready = [&](const ReadyMap&) { ++times; },
                .ready_every_s = 0});
  EXPECT_EQ(times, 0);
}

/// A map of 2 x 2 cells of 2 mm, 1 2 / 3 4, seen with its corner at (10, 20).
Surface sample() {
  Surface surface;
  surface.map.frame = {.size = {2, 2}, .spacing_mm = 2, .first_x_mm = 1, .first_y_mm = 1};
  surface.map.heights_mm = {1, 2, 3, 4};
  surface.map.origins.assign(4, CellStatus::measured);
  surface.view_from_file.m[3] = -10;
  surface.view_from_file.m[7] = -20;
  surface.view_from_file.m[11] = -5;
  return surface;
}

TEST(ReadyRows, ASampleIsLaidWhereItWasSeen) {
  ViewFromFile view;
  view.m[3] = -12;  // The whole begins 2 mm further right.
  view.m[7] = -20;
  ReadyRows rows({.size = {4, 4}, .spacing_mm = 1, .first_x_mm = 0.5, .first_y_mm = 0.5}, 4);
  rows.beginWith(sample(), view, 3);
  // Above the lowest place, which lies at 3 mm: a height of 1 mm over a base at 5 mm is 3 mm.
  EXPECT_THAT(rows.now().map.heights_mm,
              ElementsAre(4, 4, 4, 4, 4, 4, 4, 4, 6, 6, 6, 6, 6, 6, 6, 6));
  DepthRows ready;
  ready.rows = 1;
  ready.front = {7, NAN, 8, 9};
  rows.add(ready);
  EXPECT_EQ(rows.now().rows, 1);
  EXPECT_EQ(rows.now().map.heightMm({0, 0}), 7);
  EXPECT_EQ(rows.now().map.origin({1, 0}), CellStatus::outside);
  EXPECT_EQ(rows.now().map.heightMm({0, 1}), 4) << "still the sample";
}

TEST(ReadyRows, ASampleSeenFromElsewhereIsPassedOver) {
  ViewFromFile from_below;
  from_below.m[5] = from_below.m[10] = -1;
  ReadyRows rows({.size = {5, 3}, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0}, 2);
  rows.beginWith(sample(), from_below, 0);
  EXPECT_EQ(rows.now().map.frame.size, (GridSize{2, 1})) << "every third cell";
  EXPECT_THAT(rows.now().map.origins, ElementsAre(CellStatus::outside, CellStatus::outside));
}

}  // namespace
}  // namespace relievo
