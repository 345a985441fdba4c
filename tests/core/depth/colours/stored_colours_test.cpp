// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/stored_colours.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace relievo {
namespace {

/// Cells of every kind: most from the scan, some interpolated, some of coarser levels, some empty.
GridColours someColours(std::size_t cells) {
  std::mt19937 random(44);
  std::uniform_int_distribution<int> byte(0, 255);
  const auto any = [&] { return static_cast<std::uint8_t>(byte(random)); };
  GridColours made;
  for (std::size_t i = 0; i < cells; ++i) {
    std::uint8_t alpha = i % 5 < 3 ? kStoredAlpha : i % 5 == 3 ? kBetweenAlpha : any();
    if (i % 17 == 0) alpha = 0;
    made.colours.push_back(alpha == 0 ? Rgba{} : Rgba{any(), any(), any(), alpha});
    made.intensities.push_back(alpha == 0 && i % 2 == 0
                                   ? GreyAlpha{}
                                   : GreyAlpha{any(), alpha == 0 ? kStoredAlpha : alpha});
  }
  return made;
}

TEST(StoredColours, TakeFourBytesASampleAtMost) {
  constexpr std::size_t kCells = 10'000;
  const GridColours both = someColours(kCells);
  EXPECT_EQ(StoredColours(both).bytes(), 4 * kCells);
  EXPECT_EQ(StoredColours({.colours = both.colours, .intensities = {}}).bytes(), 4 * kCells);
  EXPECT_EQ(StoredColours({.colours = {}, .intensities = both.intensities}).bytes(), 2 * kCells);
  EXPECT_EQ(StoredColours().bytes(), 0U);
}

TEST(StoredColours, OneKindAloneComesBackAsItIs) {
  const GridColours both = someColours(1000);
  const GridColours colours{.colours = both.colours, .intensities = {}};
  EXPECT_EQ(StoredColours(colours).all(), colours);
  EXPECT_TRUE(StoredColours(colours).hasColours());
  EXPECT_FALSE(StoredColours(colours).hasIntensities());
  const GridColours greys{.colours = {}, .intensities = both.intensities};
  EXPECT_EQ(StoredColours(greys).all(), greys);
  EXPECT_FALSE(StoredColours(greys).hasColours());
}

TEST(StoredColours, OfBothTheScansOwnColoursComeBackToTheByte) {
  const GridColours both = someColours(10'000);
  const StoredColours stored(both);
  ASSERT_TRUE(stored.hasColours() && stored.hasIntensities());
  for (std::size_t i = 0; i < both.colours.size(); ++i) {
    const Rgba colour = stored.colour(i);
    const GreyAlpha grey = stored.intensity(i);
    if (both.colours[i][3] == kStoredAlpha) {
      ASSERT_EQ(colour, both.colours[i]);
      ASSERT_EQ(grey[1], kStoredAlpha);
    }
    if (both.colours[i][3] == 0) {
      ASSERT_EQ(colour, Rgba{}) << "a colour from nowhere";
      ASSERT_EQ(grey, both.intensities[i]);
      continue;
    }
    ASSERT_NEAR(colour[3], both.colours[i][3], 48);
    ASSERT_GT(colour[3], 0);
    for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(colour[k], both.colours[i][k], 1);
    ASSERT_NEAR(grey[0], both.intensities[i][0], 1);
  }
}

TEST(StoredColours, WhatIsInterpolatedStaysSo) {
  const auto [colour, grey] = asStored({7, 8, 9, kBetweenAlpha}, {200, kBetweenAlpha});
  EXPECT_EQ(colour[3], kBetweenAlpha);
  EXPECT_EQ(grey[1], kBetweenAlpha);
}

TEST(StoredColours, AColourWithoutAnIntensityIsKept) {
  EXPECT_EQ(asStored({0, 0, 0, 255}, {}).first, (Rgba{0, 0, 0, 255}));
  EXPECT_EQ(asStored({0, 0, 0, 255}, {}).second, GreyAlpha{});
  EXPECT_EQ(asStored({1, 2, 3, kBetweenAlpha}, {}).first, (Rgba{1, 2, 3, kBetweenAlpha}));
}

TEST(StoredColours, PackingAgainChangesNothing) {
  GridColours once = someColours(10'000);
  makeStorable(once);
  EXPECT_EQ(StoredColours(once).all(), once);
  EXPECT_EQ(StoredColours(StoredColours(once).all()), StoredColours(once));
}

TEST(StoredColours, RowsAreThoseOfTheSamples) {
  const StoredColours stored(someColours(100));
  std::vector<Rgba> row(20);
  stored.read(37, row);
  for (std::size_t i = 0; i < row.size(); ++i) EXPECT_EQ(row[i], stored.colour(37 + i));
}

}  // namespace
}  // namespace relievo
