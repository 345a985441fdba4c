// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tile_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "core/tiles/points/scatter.h"
#include "core/tiles/tile_rows.h"
#include "tests/core/scan_fixtures.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo {
namespace {

constexpr GridFrame kFrame{
    .size = {700, 600}, .spacing_mm = 0.25, .first_x_mm = 0.125, .first_y_mm = 0.125};

/// Coordinates are multiples of 1/4096 mm, so that float holds them and their sums exactly.
std::vector<FilePoint> randomPoints(std::size_t count) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> x(0, 700 * 1024 - 1);
  std::uniform_int_distribution<int> y(0, 600 * 1024 - 1);
  std::uniform_int_distribution<int> z(0, 20 * 4096);
  std::vector<FilePoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({x(random) / 4096.0, y(random) / 4096.0, z(random) / 4096.0});
  }
  return points;
}

struct How {
  PointRule rule;
  std::size_t memory_bytes = std::size_t{256} << 20U;
  int threads = 2;
  GriddingRoom room = {};
};

struct Gridded {
  FrontDepths depths, between;
  std::vector<float> points;
  std::vector<std::uint8_t> steep;
  HiddenSurface hidden;
  std::size_t outliers = 0;
  std::uint64_t spilled_bytes = 0;
};

Gridded grid(const std::vector<FilePoint>& points, const How& how) {
  const test::TileFolder folder;
  TileStore store(kFrame.size, {.merges = isMergeable(how.rule),
                                .memory_bytes = how.memory_bytes,
                                .spill_folder = folder.path(),
                                .sum_unit_mm = sumUnit(points.size(), 21),
                                .edge_cells = kRuleReach,
                                .threads = how.threads});
  scatterIntoTiles(test::sourceOf(points), {}, kFrame, store, {});
  Gridded result;
  makeDepths(
      store, how.rule, kFrame.spacing_mm,
      [&](const DepthRows& rows) {
        EXPECT_EQ(kFrame.size.index({.col = 0, .row = rows.first_row}), result.depths.size());
        result.depths.insert(result.depths.end(), rows.front.begin(), rows.front.end());
        result.between.insert(result.between.end(), rows.between.begin(), rows.between.end());
        result.points.insert(result.points.end(), rows.points.begin(), rows.points.end());
        result.steep.insert(result.steep.end(), rows.steep.begin(), rows.steep.end());
        result.hidden = result.hidden + rows.hidden.value_or(HiddenSurface{});
        result.outliers += rows.outliers;
      },
      {}, how.room);
  result.spilled_bytes = store.spilledBytes();
  EXPECT_LE(store.residentBytes(), how.memory_bytes);
  return result;
}

void expectSameBytes(const Gridded& a, const Gridded& b) {
  ASSERT_EQ(a.depths.size(), b.depths.size());
  EXPECT_EQ(std::memcmp(a.depths.data(), b.depths.data(), 4 * a.depths.size()), 0);
}

constexpr PointRule kRules[] = {PointRule::front,  PointRule::second,   PointRule::mean,
                                PointRule::median, PointRule::top_mean, PointRule::lowest};

TEST(TileStore, GivesTheSameBytesForEveryOrderBudgetAndNumberOfThreads) {
  std::vector<FilePoint> points = randomPoints(600'000);
  for (const PointRule rule : kRules) {
    SCOPED_TRACE(describe(rule));
    const Gridded all = grid(points, {.rule = rule, .threads = 1});
    EXPECT_EQ(all.spilled_bytes, 0U);
    const Gridded small = grid(points, {.rule = rule, .memory_bytes = 2'000'000, .threads = 3});
    EXPECT_GT(small.spilled_bytes, 1'000'000U);
    expectSameBytes(all, small);
    std::shuffle(points.begin(), points.end(), std::mt19937(3));
    expectSameBytes(all, grid(points, {.rule = rule, .memory_bytes = 3'000'000}));
    std::sort(points.begin(), points.end(),
              [](const FilePoint& a, const FilePoint& b) { return a.y < b.y; });
    expectSameBytes(all, grid(points, {.rule = rule, .memory_bytes = 2'000'000}));
  }
}

TEST(TileStore, GivesTheSameBytesHoweverTilesAreCut) {
  // Layers, walls and outliers, and rules that share sums between rows.
  std::vector<FilePoint> points = randomPoints(350'000);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].z = 5 + 3 * std::sin(points[i].x / 3);  // Sums are rounded.
    if (i % 5 == 0) points[i].z -= 9;
    if (i % 10'000 == 1) points[i].z += 60;
  }
  for (const PointRule rule : {PointRule::median, PointRule::top_mean, PointRule::lowest,
                               PointRule::splat, PointRule::quadratic}) {
    SCOPED_TRACE(describe(rule));
    const Gridded whole = grid(points, {.rule = rule, .threads = 1});
    EXPECT_GT(whole.outliers, 0U);
    EXPECT_TRUE(rule == PointRule::lowest || whole.hidden.hidden > 0);
    // A single row at once takes its time: for one rule that may be cut anywhere, and one that not.
    const bool finest = rule == PointRule::median || rule == PointRule::splat;
    for (const std::size_t at_once : {finest ? std::size_t{1} : 30'000, std::size_t{45'000}}) {
      const Gridded cut = grid(points, {.rule = rule,
                                        .memory_bytes = 4'000'000,
                                        .room = {.workers = 2, .points_at_once = at_once}});
      expectSameBytes(whole, cut);
      ASSERT_EQ(cut.between.size(), whole.between.size());
      const std::size_t between = 4 * whole.between.size();  // NaN is no number's equal.
      EXPECT_EQ(std::memcmp(whole.between.data(), cut.between.data(), between), 0) << at_once;
      EXPECT_EQ(cut.points, whole.points);
      EXPECT_EQ(cut.steep, whole.steep);
      EXPECT_EQ(cut.outliers, whole.outliers);
      EXPECT_EQ(cut.hidden.hidden, whole.hidden.hidden);
      EXPECT_EQ(cut.hidden.all, whole.hidden.all);
      EXPECT_EQ(cut.hidden.cells_in_layers, whole.hidden.cells_in_layers);
    }
  }
}

TEST(TileStore, CutsRowsSoThatNoPartLooksAtMoreThanItMay) {
  std::vector<std::size_t> rows(256, 10);
  rows[100] = 5000;
  EXPECT_EQ(rowsWithin(rows, {.reach = 8}, 10'000).size(), 1U);
  const RowCuts alone{.reach = 8};
  const std::size_t least = leastAtOnce(rows, alone);
  EXPECT_EQ(least, 5000U + 16 * 10);
  for (const std::size_t most : {least, least + 500, std::size_t{200}}) {
    int next = 0;
    for (const RowRange part : rowsWithin(rows, alone, most)) {
      EXPECT_EQ(part.first, next);
      EXPECT_GT(part.end, part.first);
      std::size_t seen = 0;
      for (int r = std::max(part.first - 8, 0); r < std::min(part.end + 8, 256); ++r) {
        seen += rows[static_cast<std::size_t>(r)];
      }
      EXPECT_TRUE(seen <= most || part.end - part.first == 1) << part.first;
      next = part.end;
    }
    EXPECT_EQ(next, 256);
  }
  for (const RowRange part : rowsWithin(rows, {.reach = 8, .step = 64, .first_step = 56}, 0)) {
    EXPECT_TRUE(part.first == 0 || (part.first - 56) % 64 == 0);
    EXPECT_TRUE(part.end == 256 || (part.end - 56) % 64 == 0);
  }
}

TEST(TileStore, MergesFullTilesAndForgetsTheirPoints) {
  // All points in one tile: as points they would take 16 MB.
  std::vector<FilePoint> points = randomPoints(1'000'000);
  for (FilePoint& p : points) p = {p.x / 4, p.y / 4, p.z};
  const How how{.rule = PointRule::mean, .memory_bytes = 6'000'000};
  EXPECT_EQ(grid(points, how).spilled_bytes, 0U);
}

TEST(TileStore, GridsAsTheWholeMapDoes) {
  const std::vector<FilePoint> points = randomPoints(900'000);
  Scan scan;
  for (const FilePoint& p : points) {
    scan.points.push_back(
        {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  for (const PointRule rule : kRules) {
    SCOPED_TRACE(describe(rule));
    const FrontDepths whole =
        scatterPoints({.scan = scan, .view_from_file = {}, .frame = kFrame, .rule = rule}).front;
    const Gridded tiles = grid(points, {.rule = rule});
    ASSERT_EQ(tiles.depths.size(), whole.size());
    std::size_t other = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      other += std::isnan(whole[i]) ? !std::isnan(tiles.depths[i]) : tiles.depths[i] != whole[i];
    }
    EXPECT_EQ(other, 0U);
  }
}

TEST(TileStore, RulesThatLookAroundAreExactAtTheBordersOfTiles) {
  // Sparse, so that local fits look as far as they may: a band of 60 rows on both sides of a border
  // of tiles, where what a tile lacks of its neighbour would show.
  std::vector<FilePoint> points = randomPoints(150'000);
  for (FilePoint& p : points) p.z = std::floor(4096 * (5 + std::sin(p.x) + p.y / 20)) / 4096;
  Scan scan;
  for (const FilePoint& p : points) {
    scan.points.push_back(
        {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  for (const PointRule rule : {PointRule::quadratic, PointRule::splat}) {
    SCOPED_TRACE(describe(rule));
    const CapturedDepths whole =
        scatterPoints({.scan = scan, .view_from_file = {}, .frame = kFrame, .rule = rule});
    const Gridded tiles = grid(points, {.rule = rule});
    ASSERT_EQ(tiles.depths.size(), whole.front.size());
    const auto differs = [](const FrontDepths& a, const FrontDepths& b, std::size_t i) {
      // Sums of another order: some last digits.
      return std::isnan(a[i]) ? !std::isnan(b[i]) : !(std::abs(a[i] - b[i]) < 1e-4F);
    };
    std::size_t other = 0;
    for (std::size_t i = 0; i < whole.front.size(); ++i) {
      other += differs(whole.front, tiles.depths, i) ? 1 : 0;
      if (!whole.between.empty()) other += differs(whole.between, tiles.between, i) ? 1 : 0;
    }
    EXPECT_EQ(other, 0U);
  }
}

TEST(TileStore, ProposesTheRuleOfTheWholeMap) {
  GridFrame one_tile = kFrame;
  one_tile.size = {.cols = 200, .rows = 90};
  for (const GridFrame& frame : {kFrame, one_tile}) {
    for (const std::size_t count : {300'000U, 2'400'000U}) {
      std::vector<FilePoint> points = randomPoints(count);
      for (FilePoint& p : points) p.z = 0.01 * p.z + 0.1 * p.x;
      Scan scan;
      for (const FilePoint& p : points) {
        scan.points.push_back(
            {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
      }
      TileStore store(frame.size, {});
      scatterIntoTiles(test::sourceOf(points), {}, frame, store, {});
      const DepthRequest request{.scan = scan, .view_from_file = {}, .frame = frame};
      const RuleProposal whole = proposeRule(request, Task{});
      const RuleProposal tiles = proposeRule(store, frame.spacing_mm, {});
      EXPECT_EQ(tiles.rule, whole.rule);
      EXPECT_EQ(englishText(tiles.reason), englishText(whole.reason));
      EXPECT_NEAR(pointNoise(store, frame.spacing_mm, {}), pointNoise(request), 1e-5);
    }
  }
}

TEST(TileStore, CannotOverflowItsSums) {
  const std::uint64_t points = 200'000'000;
  const double unit = sumUnit(points, 1e7);
  EXPECT_LT(static_cast<double>(points) * (1e7 / unit + 0.5), 9.2e18);
  EXPECT_LT(unit, 1e-3);
}

TEST(TileStore, SaysWhenTheDiskIsNotThere) {
  TileStore store({.cols = 512, .rows = 512},
                  {.memory_bytes = 100'000, .spill_folder = "/nonexistent", .threads = 1});
  const std::vector<TilePoint> points(20'000);
  EXPECT_THROW(
      {
        for (int i = 0; i < 10; ++i) store.add(points);
      },
      WriteError);
}

}  // namespace
}  // namespace relievo
