// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/carry.h"

#include <gtest/gtest.h>

#include <cmath>

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

const Region kMiddle{.x_mm = 100, .y_mm = 60, .side_mm = 80, .level = {2}};

TEST(Zoomed, KeepsThePlaceWhereItIsInTheWindow) {
  const Region next = zoomed(ladderOfF(), kMiddle, {.nearer = 2, .x_mm = 120, .y_mm = 120});
  EXPECT_DOUBLE_EQ(next.side_mm, 40);
  EXPECT_DOUBLE_EQ((120 - next.x_mm) / next.side_mm, (120 - kMiddle.x_mm) / kMiddle.side_mm);
  EXPECT_DOUBLE_EQ((120 - next.y_mm) / next.side_mm, (120 - kMiddle.y_mm) / kMiddle.side_mm);
  EXPECT_EQ(next.level, defaultLevel(ladderOfF(), 40));
}

TEST(Zoomed, EndsAtTheWholeObjectAndAtEightCells) {
  const DetailLadder ladder = ladderOfF();
  EXPECT_EQ(zoomed(ladder, kMiddle, {.nearer = 0.01, .x_mm = 120, .y_mm = 120}),
            wholeRegion(ladder));
  EXPECT_DOUBLE_EQ(zoomed(ladder, kMiddle, {.nearer = 1e6, .x_mm = 120, .y_mm = 120}).side_mm, 2);
  const Region tiny{.x_mm = 100, .y_mm = 60, .side_mm = 1, .level = {0}};
  EXPECT_DOUBLE_EQ(zoomed(ladder, tiny, {.nearer = 2, .x_mm = 100, .y_mm = 60}).side_mm, 1)
      << "a window that is smaller already does not grow";
}

TEST(Carried, TheReliefGoesWithThePushAndTheWindowTheOtherWay) {
  const Region next = carried(ladderOfF(), kMiddle, {.right = 0.25, .up = -0.5});
  EXPECT_EQ(next, (Region{.x_mm = 80, .y_mm = 100, .side_mm = 80, .level = {2}}));
}

TEST(Carried, StaysOnTheMap) {
  const DetailLadder ladder = ladderOfF();
  const Region next = carried(ladder, kMiddle, {.right = 100, .up = 100});
  EXPECT_TRUE(onMap(ladder, next));
  EXPECT_EQ(carried(ladder, next, {.right = 100, .up = 100}), next) << "no further";
}

TEST(Carried, ManySmallStepsAreOneLargeOne) {
  const DetailLadder ladder = ladderOfF();
  Region small = kMiddle;
  for (int i = 0; i < 100; ++i) small = carried(ladder, small, {.nearer = std::pow(2, 0.01)});
  const Region large = carried(ladder, kMiddle, {.nearer = 2});
  EXPECT_NEAR(small.side_mm, large.side_mm, 1e-9);
  EXPECT_NEAR(small.centreX(), large.centreX(), 1e-9);
  EXPECT_NEAR(small.centreY(), large.centreY(), 1e-9);
  EXPECT_EQ(small.level, large.level);
}

TEST(Carried, AtRestNothingChangesNotEvenAChosenLevel) {
  EXPECT_NE(defaultLevel(ladderOfF(), kMiddle.side_mm), kMiddle.level) << "it was chosen";
  EXPECT_EQ(carried(ladderOfF(), kMiddle, {}), kMiddle);
}

}  // namespace
}  // namespace relievo
