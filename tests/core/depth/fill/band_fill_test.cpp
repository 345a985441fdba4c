// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/band_fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/tiles/job/job_parts.h"
#include "core/tiles/row_store.h"
#include "tests/core/base/thread_exchange.h"
#include "tests/core/depth/fill/whole_fill.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo {
namespace {

using test::gappyDepths;
using test::rowsOf;

struct Case {
  GridSize size;
  double hit_share;
  HoleChoice holes;
  bool has_sampling_gaps = true;
  std::size_t memory_bytes = std::size_t{64} << 20U;
  int threads = 2;
};

GridFrame frameOf(GridSize size) {
  return {.size = size, .spacing_mm = 0.5, .first_x_mm = 0.25, .first_y_mm = 0.25};
}

void expectSame(const Case& c, BandFill& bands, const FilledMap& whole) {
  EXPECT_EQ(bands.baseZMm(), whole.base_z_mm);
  EXPECT_EQ(bands.seenThrough(), whole.seen_through);
  ASSERT_EQ(bands.holes().size(), whole.holes.size());
  for (std::size_t i = 0; i < whole.holes.size(); ++i) {
    EXPECT_EQ(bands.holes()[i].cells, whole.holes[i].cells);
    EXPECT_EQ(bands.holes()[i].area_mm2, whole.holes[i].area_mm2);
    EXPECT_EQ(bands.holes()[i].filled, whole.holes[i].filled);
    EXPECT_NEAR(bands.holes()[i].centre_x_mm, whole.holes[i].centre_x_mm, 1e-6);
    EXPECT_NEAR(bands.holes()[i].centre_y_mm, whole.holes[i].centre_y_mm, 1e-6);
  }
  int rows = 0;
  std::size_t other_heights = 0;
  std::size_t other_origins = 0;
  bands.write(
      [&](int row, const float* heights, const CellStatus* origins) {
        ASSERT_EQ(row, rows++);
        for (int col = 0; col < c.size.cols; ++col) {
          const std::size_t i = c.size.index({.col = col, .row = row});
          other_heights += heights[col] != whole.map.heights_mm[i];
          other_origins += origins[col] != whole.map.origins[i];
        }
      },
      {});
  EXPECT_EQ(rows, c.size.rows);
  EXPECT_EQ(other_heights, 0U);
  EXPECT_EQ(other_origins, 0U);
}

void expectSameAsWholeMap(const Case& c, const FrontDepths& depths) {
  const FillSource source{.has_sampling_gaps = c.has_sampling_gaps};
  const FilledMap whole = test::fillWholeMap(depths, frameOf(c.size), source, c.holes);
  const FilledMap in_memory = fillDepths(depths, frameOf(c.size), source, c.holes);
  EXPECT_TRUE(in_memory.map.heights_mm == whole.map.heights_mm);
  EXPECT_TRUE(in_memory.map.origins == whole.map.origins);
  EXPECT_EQ(in_memory.base_z_mm, whole.base_z_mm);
  EXPECT_EQ(in_memory.seen_through, whole.seen_through);
  EXPECT_EQ(in_memory.holes.size(), whole.holes.size());
  BandFill bands({.front = rowsOf(depths, c.size), .between = {}}, frameOf(c.size), source, c.holes,
                 {.memory_bytes = c.memory_bytes, .threads = c.threads}, {});
  expectSame(c, bands, whole);
}

void expectSameAsWholeMap(const Case& c) {
  expectSameAsWholeMap(c, gappyDepths(c.size, c.hit_share, 7));
}

TEST(BandFill, FillsGapsAcrossABandsBorderAsTheWholeMapDoes) {
  // Rough ground with wide gaps around the border at row 256: what is filled there takes its
  // heights from far beyond, and neighbours limit it.
  const GridSize size{.cols = 400, .rows = 600};
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  FrontDepths depths(size.count());
  for (int row = 0; row < size.rows; ++row) {
    const bool is_near = std::abs(row - 256) < 70;
    for (int col = 0; col < size.cols; ++col) {
      const bool is_gap = unit(random) < (is_near ? 0.97F : 0.5F);
      depths[size.index({.col = col, .row = row})] =
          is_gap ? std::numeric_limits<float>::quiet_NaN() : 100 * unit(random);
    }
  }
  expectSameAsWholeMap({.size = size, .hit_share = 0.5, .holes = {}, .has_sampling_gaps = true},
                       depths);
}

/// What push-pull makes of the rows beside a cut is off where nothing is known above them, and what
/// is limited by those goes on into the band, one row a round. So next to nothing is known just
/// beyond the border at row 256, and ways of single cells lead on into the band below.
TEST(BandFill, WhatIsLimitedByNeighboursBeyondABandsBorderIsThatOfTheWholeMap) {
  const GridSize size{.cols = 6000, .rows = 300};
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0, 1);
  FrontDepths depths(size.count());
  for (int row = 0; row < size.rows; ++row) {
    const int inside = row - 256;
    const bool empty = inside >= -14 && inside < -3;
    const float known = empty ? 0.02F : inside >= -3 && inside < 16 ? 0.3F : 0.04F;
    for (int col = 0; col < size.cols; ++col) {
      depths[size.index({.col = col, .row = row})] =
          unit(random) < known ? 0.1F * unit(random) : std::numeric_limits<float>::quiet_NaN();
    }
  }
  // So low that nothing counts as seen through, and known so rarely that these are gaps, no holes.
  expectSameAsWholeMap({.size = size, .hit_share = 0.5, .holes = {}, .has_sampling_gaps = true},
                       depths);
}

TEST(BandFill, AWallAlongABandsBorderIsSteepOnBothSidesOfIt) {
  // Rises by 20 mm a row of 0.5 mm around the border at row 256, and falls so around 512.
  const GridSize size{.cols = 40, .rows = 700};
  FrontDepths depths(size.count());
  for (int row = 0; row < size.rows; ++row) {
    const int up = std::clamp(row - 253, 0, 6);
    const int down = std::clamp(row - 509, 0, 6);
    for (int col = 0; col < size.cols; ++col) {
      depths[size.index({.col = col, .row = row})] = 20.0F * static_cast<float>(up - down);
    }
  }
  expectSameAsWholeMap({.size = size, .hit_share = 1, .holes = {}, .has_sampling_gaps = false},
                       depths);
  const GridFrame frame{.size = size, .spacing_mm = 0.5, .first_x_mm = 0, .first_y_mm = 0};
  BandFill bands({.front = rowsOf(depths, size), .between = {}}, frame,
                 {.has_sampling_gaps = false}, {},
                 {.memory_bytes = std::size_t{64} << 20U, .threads = 1}, {});
  bands.write(
      [&](int row, const float*, const CellStatus* origins) {
        const bool is_wall = (row > 253 && row < 259) || (row > 509 && row < 515);
        EXPECT_EQ(origins[20], is_wall ? CellStatus::steep : CellStatus::measured) << row;
      },
      {});
}

TEST(BandFill, GivesTheBytesOfTheWholeMap) {
  expectSameAsWholeMap({.size = {700, 900}, .hit_share = 0.3, .holes = {}});
}

TEST(BandFill, GivesTheSameBytesForSizesThatAreNoMultipleOfATile) {
  expectSameAsWholeMap({.size = {333, 517}, .hit_share = 0.5, .holes = {}});
  expectSameAsWholeMap({.size = {61, 1025}, .hit_share = 0.6, .holes = {}});
}

TEST(BandFill, GivesTheSameBytesWhereTheGapsAreWide) {
  expectSameAsWholeMap({.size = {600, 800}, .hit_share = 0.03, .holes = {}});
}

TEST(BandFill, GivesTheSameBytesWhenDepthsDoNotFitIntoMemory) {
  const Case c{.size = {500, 700}, .hit_share = 0.4, .holes = {}, .memory_bytes = 300'000};
  const FrontDepths depths = gappyDepths(c.size, c.hit_share, 7);
  const test::TileFolder folder;
  RowStore spilled(c.size, 0, folder.path());
  spilled.write(0, c.size.rows, depths.data());
  BandFill bands(
      {.front = RowsOf([&](int first, int rows, float* out) { spilled.read(first, rows, out); }),
       .between = {}},
      frameOf(c.size), {}, c.holes, {.memory_bytes = c.memory_bytes, .threads = c.threads}, {});
  expectSame(c, bands, test::fillWholeMap(depths, frameOf(c.size), {}, c.holes));
}

TEST(BandFill, GivesTheSameBytesForMapsOfFewRowsOrColumns) {
  for (const GridSize size : {GridSize{1, 40}, GridSize{40, 1}, GridSize{2, 9}, GridSize{7, 7},
                              GridSize{65, 17}, GridSize{64, 300}, GridSize{63, 5}}) {
    SCOPED_TRACE(std::to_string(size.cols) + " x " + std::to_string(size.rows));
    for (const double hit : {0.3, 0.7, 1.0}) {
      FrontDepths depths = gappyDepths(size, hit, 11);
      depths.back() = 20;  // Something is measured.
      for (const bool gaps : {true, false}) {
        expectSameAsWholeMap({.size = size,
                              .hit_share = hit,
                              .holes = {.rule = HoleRule::interpolate, .max_area_mm2 = 1e6},
                              .has_sampling_gaps = gaps},
                             depths);
      }
    }
  }
}

// Where there is a back, pass after pass looks at neighbours of neighbours: more rows than a low
// band has.
TEST(BandFill, LooksThroughGapsAsTheWholeMapDoesHoweverLowItsBandsAre) {
  const GridSize size{.cols = 600, .rows = 400};
  for (unsigned seed = 1; seed <= 6; ++seed) {
    for (const double hit : {0.03, 0.55, 0.65, 0.75}) {
      SCOPED_TRACE(hit);
      FrontDepths depths = gappyDepths(size, hit, seed);
      std::mt19937 random(seed);
      for (float& depth : depths) {
        if (random() % 12 == 0) depth = -40;
      }
      const FilledMap whole = test::fillWholeMap(depths, frameOf(size), {}, {});
      BandFill bands({.front = rowsOf(depths, size), .between = {}}, frameOf(size), {}, {},
                     {.threads = 2, .rows = 8}, {});
      expectSame({.size = size, .hit_share = hit, .holes = {}}, bands, whole);
    }
  }
}

TEST(BandFill, GivesTheSameBytesForEveryNumberOfThreads) {
  for (const int threads : {1, 3}) {
    expectSameAsWholeMap({.size = {300, 800}, .hit_share = 0.4, .holes = {}, .threads = threads});
  }
}

TEST(BandFill, GivesTheSameBytesForEveryNumberOfProcesses) {
  const Case c{.size = {300, 1500}, .hit_share = 0.4, .holes = {}};
  FrontDepths depths = gappyDepths(c.size, c.hit_share, 7);
  std::mt19937 random(3);
  for (float& depth : depths) {
    if (random() % 40 == 0) depth = -40;  // The back, seen through gaps.
  }
  const FilledMap whole = test::fillWholeMap(depths, frameOf(c.size), {}, c.holes);
  ASSERT_GT(whole.seen_through, 1000U);
  const std::vector<float> points(c.size.count(), 2.0F);
  for (const int ranks : {2, 3, 5}) {
    const test::TileFolder folder;
    test::inThreads(ranks, [&](Exchange& processes) {
      JobFolder job(folder / "job", {}, &processes);
      JobBands kept(job);
      BandFill bands(
          {.front = rowsOf(depths, c.size), .between = {}, .points = rowsOf(points, c.size)},
          frameOf(c.size), {}, c.holes, {.threads = 1, .processes = &processes, .keeper = &kept},
          {});
      EXPECT_EQ(bands.seenThroughPoints(), 2 * whole.seen_through);
      EXPECT_EQ(bands.fillForOthers({}), 0) << "nothing was there before";
      if (processes.isFirst()) expectSame(c, bands, whole);
    });
  }
}

TEST(BandFill, TreatsHolesAsChosen) {
  for (const HoleRule rule : {HoleRule::base, HoleRule::none}) {
    expectSameAsWholeMap({.size = {400, 600}, .hit_share = 0.9, .holes = {.rule = rule}});
  }
  for (const double area : {0.0, 10.0, 1e6}) {
    expectSameAsWholeMap({.size = {400, 600},
                          .hit_share = 0.9,
                          .holes = {.rule = HoleRule::interpolate, .max_area_mm2 = area}});
  }
}

/// A relief with holes of many sizes, some across the border of bands at row 256, one of them
/// large, and gaps between its points.
FrontDepths depthsWithHoles(GridSize size) {
  FrontDepths depths = gappyDepths(size, 0.9, 3);
  std::mt19937 random(17);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int hole = 0; hole < 60; ++hole) {
    const int side = hole == 0 ? 60 : 5 + below(14);
    const Cell lowest{.col = below(size.cols - side),
                      .row = hole % 4 == 0 ? 256 - side / 2 : below(size.rows - side)};
    for (int row = lowest.row; row < lowest.row + side; ++row) {
      for (int col = lowest.col; col < lowest.col + side - row % 3; ++col) {
        depths[size.index({.col = col, .row = row})] = std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  return depths;
}

TEST(BandFill, InterpolatesTheHolesOfARasterThatHasNoGaps) {
  const GridSize size{.cols = 300, .rows = 600};
  FrontDepths depths = gappyDepths(size, 1, 3);
  for (int row = 240; row < 270; ++row) {
    for (int col = 100; col < 160; ++col) {
      depths[size.index({.col = col, .row = row})] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  expectSameAsWholeMap({.size = size,
                        .hit_share = 1,
                        .holes = {.rule = HoleRule::interpolate, .max_area_mm2 = 1e6},
                        .has_sampling_gaps = false},
                       depths);
}

TEST(BandFill, LaysTheMembranesOfTheWholeMap) {
  const GridSize size{.cols = 420, .rows = 600};
  const FrontDepths depths = depthsWithHoles(size);
  for (const double area : {10.0, 200.0, 1e6}) {
    for (const bool gaps : {true, false}) {
      SCOPED_TRACE(area);
      expectSameAsWholeMap({.size = size,
                            .hit_share = 0.9,
                            .holes = {.rule = HoleRule::membrane, .max_area_mm2 = area},
                            .has_sampling_gaps = gaps},
                           depths);
    }
  }
}

TEST(BandFill, LaysTheSameMembranesForEveryNumberOfProcesses) {
  const GridSize size{.cols = 300, .rows = 1100};
  const FrontDepths depths = depthsWithHoles(size);
  const HoleChoice choice{.rule = HoleRule::membrane, .max_area_mm2 = 500};
  const FilledMap whole = test::fillWholeMap(depths, frameOf(size), {}, choice);
  const auto filled = std::count_if(whole.holes.begin(), whole.holes.end(),
                                    [](const Hole& hole) { return hole.filled; });
  ASSERT_GT(filled, 20);
  ASSERT_LT(filled, static_cast<std::ptrdiff_t>(whole.holes.size()));
  for (const int ranks : {2, 3}) {
    const test::TileFolder folder;
    test::inThreads(ranks, [&](Exchange& processes) {
      JobFolder job(folder / "job", {}, &processes);
      JobBands kept(job);
      BandFill bands({.front = rowsOf(depths, size), .between = {}}, frameOf(size), {}, choice,
                     {.threads = 2, .processes = &processes, .keeper = &kept}, {});
      bands.fillForOthers({});
      if (processes.isFirst()) {
        expectSame({.size = size, .hit_share = 0.9, .holes = choice}, bands, whole);
      }
    });
  }
}

TEST(BandFill, GivesTheSameBytesForBandsOfAnyHeight) {
  const GridSize size{.cols = 200, .rows = 500};
  const FrontDepths depths = depthsWithHoles(size);
  const HoleChoice choice{.rule = HoleRule::membrane, .max_area_mm2 = 100};
  const FilledMap whole = test::fillWholeMap(depths, frameOf(size), {}, choice);
  for (const int rows : {8, 72, 504, 1024}) {
    SCOPED_TRACE(rows);
    BandFill bands({.front = GridRows::inMemory(depths, size), .between = {}}, frameOf(size), {},
                   choice, {.threads = 2, .rows = rows}, {});
    expectSame({.size = size, .hit_share = 0.9, .holes = choice}, bands, whole);
  }
}

TEST(BandFill, HeightsBetweenThePointsAndWhatIsSteepAreThoseOfTheWholeMap) {
  const GridSize size{.cols = 333, .rows = 600};
  CapturedDepths depths(gappyDepths(size, 0.5, 5));
  depths.between = gappyDepths(size, 0.97, 6);
  depths.steep.assign(size.count(), 0);
  for (std::size_t i = 0; i < size.count(); i += 3) depths.steep[i] = 1;
  BitRows steep(size);
  steep.setRows(0, depths.steep);
  const FrontDepths front = depths.front;
  const FrontDepths between = depths.between;
  for (const bool known : {true, false}) {
    SCOPED_TRACE(known);
    const FillSource source{.gaps_are_known = known};
    const FilledMap whole = test::fillWholeMap(CapturedDepths(depths), frameOf(size), source, {});
    const FilledMap in_memory = fillDepths(CapturedDepths(depths), frameOf(size), source, {});
    EXPECT_TRUE(in_memory.map.heights_mm == whole.map.heights_mm);
    EXPECT_TRUE(in_memory.map.origins == whole.map.origins);
    BandFill bands(
        {.front = rowsOf(front, size), .between = rowsOf(between, size), .steep = &steep},
        frameOf(size), source, {}, {.threads = 2}, {});
    expectSame({.size = size, .hit_share = 0.5, .holes = {}}, bands, whole);
    EXPECT_GT(std::count(whole.map.origins.begin(), whole.map.origins.end(), CellStatus::steep),
              1000);
  }
}

TEST(BandFill, SaysWhenTheHolesTakeMoreThanTheMemory) {
  const GridSize size{.cols = 420, .rows = 600};
  const FrontDepths depths = depthsWithHoles(size);
  const auto fill = [&](HoleRule rule, std::size_t bytes) {
    BandFill({.front = rowsOf(depths, size), .between = {}}, frameOf(size), {},
             {.rule = rule, .max_area_mm2 = 1e6}, {.memory_bytes = bytes}, {});
  };
  constexpr std::size_t kRuns = 200'000, kRims = 2'000'000;
  EXPECT_NO_THROW(fill(HoleRule::base, kRuns));
  EXPECT_THROW(fill(HoleRule::base, kRuns / 100), ArgumentError);
  EXPECT_THROW(fill(HoleRule::membrane, kRuns), ArgumentError);
  EXPECT_NO_THROW(fill(HoleRule::membrane, kRims));
}

TEST(BandFill, LeavesRastersWithoutSamplingGapsAsTheyAre) {
  expectSameAsWholeMap(
      {.size = {400, 600}, .hit_share = 0.5, .holes = {}, .has_sampling_gaps = false});
}

TEST(BandFill, SaysWhenNoCellWasHit) {
  const GridFrame frame{.size = {300, 300}, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0};
  const FrontDepths nothing(frame.size.count(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW(
      BandFill({.front = rowsOf(nothing, frame.size), .between = {}}, frame, {}, {}, {}, {}),
      ArgumentError);
}

TEST(BandFill, StopsWhenAsked) {
  const GridFrame frame{.size = {300, 600}, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0};
  const FrontDepths depths = gappyDepths(frame.size, 0.5, 1);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(BandFill({.front = rowsOf(depths, frame.size), .between = {}}, frame, {}, {}, {},
                        {.stop = stop.get_token(), .progress = {}}),
               Cancelled);
}

}  // namespace
}  // namespace relievo
