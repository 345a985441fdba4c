// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/hand_watch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo {
namespace {

TEST(HandWatch, FiveMillimetresAreAMovementAndTheFirstPlaceIsNone) {
  HandWatch hand;
  EXPECT_FALSE(hand.moved({30, 0, 0}, 0));
  EXPECT_FALSE(hand.moved({34.9, 0, 0}, 1));
  EXPECT_TRUE(hand.moved({35.1, 0, 0}, 2));
  EXPECT_FALSE(hand.moved({35.1, 4, 0}, 3)) << "from where it was said last";
  EXPECT_TRUE(hand.moved({35.1, 0, -5.1}, 4));
}

TEST(HandWatch, AHandThatTremblesRestsAndIsNotStill) {
  HandWatch hand;
  for (int i = 0; i < 300; ++i) hand.moved({0.3 * std::sin(50 * 0.01 * i), 0, 0}, 0.01 * i);
  EXPECT_GT(hand.restsS(3), 2.9);
  EXPECT_LT(hand.stillS(3), 0.5);
}

TEST(HandWatch, WhereNothingIsToldNothingMoved) {
  HandWatch hand;
  EXPECT_EQ(hand.stillS(9), 0) << "of a hand that nobody has seen nothing is known";
  hand.moved({1, 2, 3}, 10);
  EXPECT_DOUBLE_EQ(hand.stillS(12.5), 2.5);
  hand.moved({1, 2.1, 3}, 12.5);
  EXPECT_DOUBLE_EQ(hand.stillS(13), 3);
  hand.moved({1, 9, 3}, 14);
  EXPECT_DOUBLE_EQ(hand.restsS(14.25), 0.25);
}

}  // namespace
}  // namespace relievo
