// SPDX-License-Identifier: BSD-3-Clause
// Numbers as one says them, and the nine places of an object.
#include "core/describe/sayable.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo {
namespace {

using enum SayableNumber::Nearness;

std::string length(double mm) {
  return englishText(sayableLength(mm));
}

TEST(Sayable, NumbersAreExactNearlyOrALittleOver) {
  const auto is = [](double value, double said, SayableNumber::Nearness nearness) {
    const SayableNumber number = sayableNumber(value);
    return std::abs(number.value - said) < 1e-9 && number.nearness == nearness;
  };
  EXPECT_TRUE(is(3.75, 4, nearly)) << "the script's own example";
  EXPECT_TRUE(is(30, 30, exact));
  EXPECT_TRUE(is(30.5, 30, exact)) << "within 2 %";
  EXPECT_TRUE(is(31.5, 30, over));
  EXPECT_TRUE(is(28.5, 30, nearly));
  EXPECT_TRUE(is(22.2, 22, exact)) << "20 and 25 are too far";
  EXPECT_TRUE(is(2.5, 2.5, exact));
  EXPECT_TRUE(is(0.27, 0.27, exact));
  EXPECT_TRUE(is(310, 300, over));
  EXPECT_TRUE(is(0, 0, exact));
}

TEST(Sayable, IsNeverFurtherOffThanItSays) {
  for (double value = 0.01; value < 5000; value *= 1.003) {
    const SayableNumber number = sayableNumber(value);
    const double off = value / number.value - 1;
    EXPECT_LE(std::abs(off), number.nearness == exact ? 0.055 : 0.08 + 1e-9) << value;
    EXPECT_TRUE(number.nearness != nearly || off < 0) << value;
    EXPECT_TRUE(number.nearness != over || off > 0) << value;
  }
}

TEST(Sayable, LengthsHaveTheUnitThatOneSays) {
  EXPECT_EQ(length(300), "30 centimetres");
  EXPECT_EQ(length(37.5), "nearly 4 centimetres");
  EXPECT_EQ(length(10), "1 centimetre");
  EXPECT_EQ(length(5), "5 millimetres");
  EXPECT_EQ(length(2.5), "2.5 millimetres");
  EXPECT_EQ(length(-5), "5 millimetres");
  EXPECT_EQ(length(0), "0 millimetres");
  EXPECT_EQ(length(990), "1 metre");
  EXPECT_EQ(length(31500), "a little over 30 metres");
}

TEST(Sayable, SharesArePartsOrPercent) {
  const auto share = [](double value) { return englishText(sayableShare(value)); };
  EXPECT_EQ(share(1.0 / 6), "about a sixth");
  EXPECT_EQ(share(0.51), "about a half");
  EXPECT_EQ(share(0.34), "about a third");
  EXPECT_EQ(share(0.42), "42 percent");
  EXPECT_EQ(share(0.03), "3 percent");
  EXPECT_EQ(share(1), "100 percent");
}

TEST(Ninths, AreTheObjectsOwnWhereverItLies) {
  const RectMm object{-30, 60, 90, 30};
  EXPECT_EQ(ninthOf(object, -29, 89), Ninth::top_left);
  EXPECT_EQ(ninthOf(object, 15, 75), Ninth::middle);
  EXPECT_EQ(ninthOf(object, 59, 61), Ninth::bottom_right);
  EXPECT_EQ(ninthOf(object, -1, 75), Ninth::middle_left) << "a millimetre before the line";
  EXPECT_EQ(ninthOf(object, 1, 75), Ninth::middle) << "and one behind it";
  EXPECT_EQ(ninthOf(object, 500, 500), Ninth::top_right) << "the nearest";
  EXPECT_EQ(englishText(messageOf(Ninth::middle_left)), "middle left");
}

}  // namespace
}  // namespace relievo
