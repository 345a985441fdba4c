// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/axis.h"

#include <gtest/gtest.h>

#include <clocale>

namespace relievo {
namespace {

TEST(Axis, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(axisFor(0, 1).step, 0.2);
  EXPECT_DOUBLE_EQ(axisFor(0, 0.04).step, 0.01);
  EXPECT_DOUBLE_EQ(axisFor(0, 37, 4).step, 10);
  EXPECT_DOUBLE_EQ(axisFor(0, 21).step, 5);
}

TEST(Axis, RoundEndsAreMultiplesAndHoldTheValues) {
  const Axis axis = axisFor(-0.31, 0.87);
  EXPECT_DOUBLE_EQ(axis.step, 0.5);
  EXPECT_DOUBLE_EQ(axis.low, -0.5);
  EXPECT_DOUBLE_EQ(axis.high, 1.0);
  // 0.6 / 0.2 is 2.9999999999999996 in doubles: no step more for that.
  EXPECT_DOUBLE_EQ(axisFor(0, 0.6, 3).high, 0.6);
}

TEST(Axis, ExactEndsStay) {
  const Axis axis = axisFor(0.13, 7.77, 4, AxisEnds::exact);
  EXPECT_EQ(axis.low, 0.13);
  EXPECT_EQ(axis.high, 7.77);
  EXPECT_DOUBLE_EQ(axis.step, 2);
}

TEST(Axis, AFlatCurveHasRoom) {
  const Axis axis = axisFor(3, 3);
  EXPECT_LT(axis.low, 3);
  EXPECT_GT(axis.high, 3);
}

TEST(Axis, TicksHaveTheDigitsOfTheirStep) {
  EXPECT_EQ(tickText(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(tickText(-1e-17, 0.05), "0.00");
  EXPECT_EQ(tickText(1500, 500), "1500");
}

TEST(Axis, DigitsAreTheSameInEveryLocale) {
  if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no German locale here";
  EXPECT_EQ(fixedDigits(1.25, 2), "1.25");
  std::setlocale(LC_NUMERIC, "C");
}

}  // namespace
}  // namespace relievo
