// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/band_fill.h"

#include <gtest/gtest.h>

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

void expectSameAsWholeMap(const Case& c) {
  const test::TileFolder folder;
  const GridFrame frame{.size = c.size, .spacing_mm = 0.5, .first_x_mm = 0.25, .first_y_mm = 0.25};
  const FrontDepths depths = gappyDepths(c.size, c.hit_share, 7);
  const FillSource source{.has_sampling_gaps = c.has_sampling_gaps};
  const FilledMap whole = fillDepths(depths, frame, source, c.holes);
  const BandFill bands(
      {.front = rowsOf(depths, c.size), .between = {}}, frame, source, c.holes,
      {.memory_bytes = c.memory_bytes, .spill_folder = folder.path(), .threads = c.threads}, {});

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
      [&](int row, const float* heights, const Origin* origins) {
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
  expectSameAsWholeMap(
      {.size = {500, 700}, .hit_share = 0.4, .holes = {}, .memory_bytes = 300'000});
}

TEST(BandFill, GivesTheSameBytesForEveryNumberOfThreads) {
  for (const int threads : {1, 3}) {
    expectSameAsWholeMap({.size = {300, 800}, .hit_share = 0.4, .holes = {}, .threads = threads});
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
