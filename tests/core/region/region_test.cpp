// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/region.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "core/region/edges.h"
#include "core/region/window.h"

namespace relievo {
namespace {

/// The acceptance relief's map: 1200 x 800 samples of 0.25 mm, four levels.
DetailLadder ladderOfF() {
  return {.left_mm = 0,
          .bottom_mm = 0,
          .width_mm = 300,
          .height_mm = 200,
          .spacings_mm = {0.25, 0.5, 1, 2},
          .factor = 2};
}

TEST(DetailLadder, HasTheDocumentedStepsForTheAcceptanceRelief) {
  const DetailLadder ladder = ladderOfF();
  EXPECT_DOUBLE_EQ(ladder.sideMm(1), 300);
  EXPECT_DOUBLE_EQ(ladder.sideMm(2), 200);
  EXPECT_DOUBLE_EQ(ladder.sideMm(3), 100);
  EXPECT_DOUBLE_EQ(ladder.sideMm(4), 50);
  EXPECT_EQ(ladder.detailOf({0}), 4);
  EXPECT_EQ(ladder.detailOf({3}), 1);
}

TEST(Region, WholeIsASquareAboutTheMapAtTheCoarsestLevel) {
  const Region whole = wholeRegion(ladderOfF());
  EXPECT_EQ(whole, (Region{.x_mm = 0, .y_mm = -50, .side_mm = 300, .level = {3}}));
}

TEST(Region, FinerAndCoarserStepThroughTheDetailsAndStopAtTheEnds) {
  const DetailLadder ladder = ladderOfF();
  const StepAbout about{.x_mm = 120, .y_mm = 90};
  Region region = wholeRegion(ladder);
  for (const double side : {200.0, 100.0, 50.0}) {
    const auto next = finer(ladder, region, about);
    ASSERT_TRUE(next);
    EXPECT_DOUBLE_EQ(next->side_mm, side);
    region = *next;
  }
  EXPECT_EQ(region.level.value, 0);
  EXPECT_FALSE(finer(ladder, region, about));
  for (const double side : {100.0, 200.0, 300.0}) {
    const auto next = coarser(ladder, region, about);
    ASSERT_TRUE(next);
    EXPECT_DOUBLE_EQ(next->side_mm, side);
    region = *next;
  }
  EXPECT_EQ(region, wholeRegion(ladder));
  EXPECT_FALSE(coarser(ladder, region, about));
}

TEST(Region, ADrawnRegionGoesToTheNextDetailSmallerOrLarger) {
  const DetailLadder ladder = ladderOfF();
  const Region drawn =
      regionFromRect(ladder, {.x_mm = 10, .y_mm = 20, .width_mm = 70, .height_mm = 30});
  EXPECT_DOUBLE_EQ(drawn.side_mm, 70);
  EXPECT_DOUBLE_EQ(drawn.centreX(), 45);
  EXPECT_DOUBLE_EQ(drawn.centreY(), 35);
  const StepAbout centre{.x_mm = drawn.centreX(), .y_mm = drawn.centreY()};
  EXPECT_DOUBLE_EQ(finer(ladder, drawn, centre)->side_mm, 50);
  EXPECT_DOUBLE_EQ(coarser(ladder, drawn, centre)->side_mm, 100);
}

TEST(Region, InContactTheTouchedPointKeepsItsPlaceUnderTheHand) {
  const DetailLadder ladder = ladderOfF();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 200);
  for (int i = 0; i < 100; ++i) {
    const StepAbout about{.x_mm = uniform(random), .y_mm = uniform(random), .touching = true};
    const Region from{.x_mm = 20, .y_mm = 10, .side_mm = 200, .level = {2}};
    const Region to = *finer(ladder, from, about);
    EXPECT_NEAR((about.x_mm - to.x_mm) / to.side_mm, (about.x_mm - from.x_mm) / from.side_mm,
                1e-12);
    EXPECT_NEAR((about.y_mm - to.y_mm) / to.side_mm, (about.y_mm - from.y_mm) / from.side_mm,
                1e-12);
  }
}

TEST(Region, OtherwiseTheWindowIsCentredOnTheProbeAndKeptOnTheMap) {
  const DetailLadder ladder = ladderOfF();
  const Region whole = wholeRegion(ladder);
  const Region inner = *finer(ladder, whole, {.x_mm = 150, .y_mm = 100});
  EXPECT_DOUBLE_EQ(inner.centreX(), 150);
  const Region corner = *finer(ladder, inner, {.x_mm = 5, .y_mm = 195});
  EXPECT_EQ(corner, (Region{.x_mm = 0, .y_mm = 100, .side_mm = 100, .level = {1}}));
}

TEST(Region, RandomWalksNeverLeaveTheMap) {
  const DetailLadder ladder = ladderOfF();
  std::mt19937_64 random(77);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Region region = wholeRegion(ladder);
  for (int i = 0; i < 2000; ++i) {
    const StepAbout about{.x_mm = 150 + 200 * uniform(random), .y_mm = 100 + 150 * uniform(random)};
    const double dice = uniform(random);
    std::optional<Region> next;
    if (dice < -0.5) {
      next = finer(ladder, region, about);
    } else if (dice < 0) {
      next = coarser(ladder, region, about);
    } else {
      next = moved(ladder, region, uniform(random), uniform(random));
    }
    if (!next) continue;
    region = *next;
    if (region.side_mm <= 200) {
      ASSERT_GE(region.x_mm, -1e-9);
      ASSERT_GE(region.y_mm, -1e-9);
      ASSERT_LE(region.x_mm + region.side_mm, 300 + 1e-9);
      ASSERT_LE(region.y_mm + region.side_mm, 200 + 1e-9);
    }
  }
}

TEST(Region, MovesByPartsOfItsSideAndNotBeyondTheEdge) {
  const DetailLadder ladder = ladderOfF();
  const Region from{.x_mm = 0, .y_mm = 0, .side_mm = 100, .level = {1}};
  EXPECT_DOUBLE_EQ(moved(ladder, from, 0.25, 0)->x_mm, 25);
  EXPECT_FALSE(moved(ladder, from, -0.25, 0));
}

TEST(Region, TheDefaultLevelIsTheFinestThatDoesNotAlias) {
  const DetailLadder ladder = ladderOfF();
  EXPECT_EQ(defaultLevel(ladder, 300).value, 3);
  EXPECT_EQ(defaultLevel(ladder, 200).value, 2);
  EXPECT_EQ(defaultLevel(ladder, 100).value, 1);
  EXPECT_EQ(defaultLevel(ladder, 71).value, 1);
  EXPECT_EQ(defaultLevel(ladder, 70).value, 0);
  EXPECT_EQ(defaultLevel(ladder, 1).value, 0);
  EXPECT_EQ(defaultLevel(ladder, 5000).value, 3);
}

TEST(Region, RefusesWhatIsNoRegion) {
  const DetailLadder ladder = ladderOfF();
  EXPECT_THROW(regionFromRect(ladder, {.x_mm = 0, .y_mm = 0, .width_mm = 0, .height_mm = 5}),
               ArgumentError);
  EXPECT_THROW(regionFromRect(ladder, {.x_mm = NAN, .y_mm = 0, .width_mm = 5, .height_mm = 5}),
               ArgumentError);
  EXPECT_THROW(
      regionFromRect(ladder, {.x_mm = 0, .y_mm = 0, .width_mm = 5, .height_mm = 5}, Level{4}),
      ArgumentError);
}

TEST(Region, EdgesAreWhereNoStepIsLeft) {
  const DetailLadder ladder = ladderOfF();
  EXPECT_EQ(edgesOf(ladder, wholeRegion(ladder)), 15);
  EXPECT_EQ(edgesOf(ladder, {.x_mm = 100, .y_mm = 80, .side_mm = 50, .level = {0}}), 0);
  EXPECT_EQ(edgesOf(ladder, {.x_mm = 0, .y_mm = 80, .side_mm = 50, .level = {0}}), 1);
  EXPECT_EQ(edgesOf(ladder, {.x_mm = 250, .y_mm = 150, .side_mm = 50, .level = {0}}), 2 + 8);
  EXPECT_EQ(edgesOf(ladder, {.x_mm = 100, .y_mm = 0, .side_mm = 50, .level = {0}}), 4);
}

TEST(Region, AnotherLevelKeepsTheSquare) {
  const DetailLadder ladder = ladderOfF();
  const Region from{.x_mm = 1, .y_mm = 2, .side_mm = 100, .level = {1}};
  EXPECT_EQ(atLevel(ladder, from, {3}),
            (Region{.x_mm = 1, .y_mm = 2, .side_mm = 100, .level = {3}}));
  EXPECT_FALSE(atLevel(ladder, from, {1}));
  EXPECT_FALSE(atLevel(ladder, from, {4}));
}

}  // namespace
}  // namespace relievo
