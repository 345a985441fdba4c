// SPDX-License-Identifier: BSD-3-Clause
// What sysfs says of input devices, and which button of a pad is which.
#include "haptics/device/pad/pad_bits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace relievo::pad {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// As Linux 6.1 has them on a computer with words of 64 bits.
constexpr const char* kXboxKeys = "7cdb000000000000 0 0 0 0\n";
constexpr const char* kXboxEffects = "107030000 0\n";
constexpr const char* kKeyboard =
    "1000000000007 ff9f207ac14057ff febeffdfffefffff fffffffffffffffe\n";
constexpr const char* kMouse = "ff0000 0 0 0 0\n";

class PadBits : public testing::Test {
 protected:
  void SetUp() override {
    if (sizeof(long) != 8) GTEST_SKIP() << "the texts are of a computer with other words";
  }
};

TEST_F(PadBits, AreReadLowestFirst) {
  EXPECT_THAT(bitsOf("8000000000000001"), ElementsAre(0, 63));
  EXPECT_THAT(bitsOf("3 0\n"), ElementsAre(64, 65));
  EXPECT_THAT(bitsOf("0\n"), IsEmpty());
  EXPECT_THAT(bitsOf(""), IsEmpty());
  EXPECT_THAT(bitsOf("zz 1"), ElementsAre(0)) << "what is no number counts as nothing";
}

TEST_F(PadBits, OfATextWithTooManyTheLowestAreRead) {
  const auto zeros = [](int words) {
    std::string text;
    for (int i = 0; i < words; ++i) text += " 0";
    return text;
  };
  EXPECT_THAT(bitsOf("8000000000000000" + zeros(14) + " 1"), ElementsAre(0, 1023));
  EXPECT_THAT(bitsOf("1" + zeros(15) + " 1\n"), ElementsAre(0)) << "the other one is number 1024";
  EXPECT_THAT(bitsOf("ff 1" + zeros(13) + " 1 3\n"), ElementsAre(0, 1, 64, 960));
}

TEST_F(PadBits, AnXboxPadPressesAndRumbles) {
  const PadFacts facts = factsOf(kXboxKeys, kXboxEffects);
  EXPECT_TRUE(facts.isPad());
  EXPECT_TRUE(facts.can_rumble);
  // A, B, X, Y: its first four; C, which it has not, stands between B and X.
  EXPECT_EQ(falconButton(facts, 0x130), 0);
  EXPECT_EQ(falconButton(facts, 0x131), 1);
  EXPECT_EQ(falconButton(facts, 0x132), -1);
  EXPECT_EQ(falconButton(facts, 0x133), 2);
  EXPECT_EQ(falconButton(facts, 0x134), 3);
  EXPECT_EQ(falconButton(facts, 0x13b), -1) << "the fifth and all after it";
  EXPECT_FALSE(factsOf(kXboxKeys, "0\n").can_rumble);
}

TEST_F(PadBits, KeyboardsAndMiceAreNoPads) {
  EXPECT_FALSE(factsOf(kKeyboard, "0").isPad());
  EXPECT_FALSE(factsOf(kMouse, "0").isPad());
  // A mouse that claims to have a joystick's buttons, too.
  EXPECT_FALSE(factsOf("ffff00ff0000 0 0 0 0", "0").isPad());
}

TEST_F(PadBits, AButtonThatIsAloneIsCentre) {
  const PadFacts one = factsOf("100000000 0 0 0 0", "0");  // BTN_TRIGGER
  EXPECT_THAT(one.keys, ElementsAre(0x120));
  EXPECT_EQ(falconButton(one, 0x120), 2);
}

TEST_F(PadBits, WhateverTheTextItEnds) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 400);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (int n = length(random); n > 0; --n) text += static_cast<char>(byte(random));
    for (const int bit : bitsOf(text)) {
      EXPECT_GE(bit, 0);
      EXPECT_LT(bit, 1024);
    }
  }
}

}  // namespace
}  // namespace relievo::pad
