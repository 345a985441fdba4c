// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/large_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace relievo {
namespace {

constexpr GridFrame kMap{
    .size = {.cols = 20000, .rows = 20000}, .spacing_mm = 0.1, .first_x_mm = 0, .first_y_mm = 0};

bool fits(std::uint64_t bytes, int threads) {
  LargeMapOptions large;
  large.memory_bytes = bytes;
  large.threads = threads;
  try {
    return planMemory(kMap, large).threads == threads;
  } catch (const ArgumentError& error) {
    EXPECT_EQ(error.code, "E102");
    return false;
  }
}

/// The least that so many threads are let work with.
std::uint64_t leastBytes(int threads) {
  std::uint64_t low = 0, high = std::uint64_t{1} << 40U;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (fits(middle, threads) ? high : low) = middle;
  }
  return high;
}

TEST(LargeMemory, AsManyWorkAsTheBudgetHasRoomFor) {
  const std::uint64_t one = leastBytes(1), two = leastBytes(2), nine = leastBytes(9);
  EXPECT_LT(one, two);
  EXPECT_LT(two, nine);
  LargeMapOptions large;  // Threads are left open.
  large.memory_bytes = one;
  EXPECT_EQ(planMemory(kMap, large).threads, 1);
  large.memory_bytes = one - 1;
  EXPECT_THROW(planMemory(kMap, large), ArgumentError);
  large.memory_bytes = 10 * nine;
  EXPECT_GE(planMemory(kMap, large).threads, 1);
  EXPECT_FALSE(fits(two - 1, 2)) << "who asks for two gets two or is told";
}

TEST(LargeMemory, WhatTheInputHoldsIsOfThoseThatWork) {
  LargeMapOptions large;
  large.memory_bytes = leastBytes(3);
  large.threads = 3;
  int asked = 0;
  const auto held = [&](int threads) {
    asked = threads;
    return std::uint64_t{0};
  };
  EXPECT_EQ(planMemory(kMap, large, held).threads, 3);
  EXPECT_EQ(asked, 3);
  EXPECT_THROW(planMemory(kMap, large, [](int) { return std::uint64_t{1}; }), ArgumentError);
}

TEST(LargeMemory, TilesAreCutBeforeFewerWorkAndFewerWorkBeforeItIsRefused) {
  LargeMapOptions large;
  large.memory_bytes = 2'000'000'000;
  const MemoryPlan plan{.threads = 4, .held_bytes = 0, .gridding_bytes = 2'000'000'000};
  GridFrame frame = kMap;
  frame.size = {.cols = 1024, .rows = 1024};
  const auto worked = [&](std::size_t at_once, std::size_t least) {
    return griddingMemory(plan, frame, large, {.at_once = at_once, .least_at_once = least});
  };
  const GriddingMemory ample = worked(1'000'000, 100'000);
  EXPECT_EQ(ample.room.workers, 4);
  EXPECT_EQ(ample.room.points_at_once, 1'000'000U);
  const GriddingMemory cut = worked(20'000'000, 100'000);
  EXPECT_EQ(cut.room.workers, 4);
  EXPECT_LT(cut.room.points_at_once, 20'000'000U);
  EXPECT_GE(cut.room.points_at_once, 100'000U);
  EXPECT_LT(cut.store_bytes, ample.store_bytes);
  const GriddingMemory fewer = worked(20'000'000, 15'000'000);
  EXPECT_EQ(fewer.room.workers, 2);
  EXPECT_THROW(worked(90'000'000, 90'000'000), ArgumentError);
  EXPECT_THROW(samplingBytes(plan, frame, large, 90'000'000), ArgumentError);
  EXPECT_LT(samplingBytes(plan, frame, large, 10'000'000), plan.gridding_bytes);
}

TEST(LargeMemory, TheDiskHoldsAllLevelsAndWhatWaitsForThem) {
  GridFrame half = kMap;
  half.size = {.cols = 10000, .rows = 10000};
  const std::vector<GridFrame> levels{kMap, half};
  const std::uint64_t cells = 500'000'000;
  EXPECT_EQ(diskBytes(levels, std::nullopt, {}), 5 * cells) << "of a raster";
  EXPECT_EQ(diskBytes(levels, 0, {}), 5 * cells + 4 * kMap.size.count());
  const MemoryPlan plan{.points_bytes = 1'000'000};
  EXPECT_EQ(diskBytes(levels, 1'000'000, plan), diskBytes(levels, 0, plan) + 15'000'000);
  EXPECT_EQ(diskBytes(levels, 1000, plan), diskBytes(levels, 0, plan)) << "they stay in memory";
}

TEST(LargeMemory, ADiskWithoutRoomIsSaidBeforeTheWork) {
  EXPECT_NO_THROW(requireDisk(kMap, "maps", 5'000'000, 5'000'000));
  EXPECT_NO_THROW(requireDisk(kMap, "maps", 5'000'000, std::nullopt)) << "not known";
  try {
    requireDisk(kMap, "maps", 5'000'001, 5'000'000);
    FAIL() << "nothing was refused";
  } catch (const WriteError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("20000 x 20000 cells needs about 6 MB on the disk"
                                                 " of maps while it is made; 5 MB are free"));
  }
}

}  // namespace
}  // namespace relievo
