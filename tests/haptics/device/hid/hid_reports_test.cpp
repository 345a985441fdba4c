// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/hid/hid_reports.h"

#include <gtest/gtest.h>

#include <random>

namespace relievo::hid {
namespace {

/// A gamepad: report 4, two axes of eight bits, then ten buttons and six bits of padding.
const std::vector<std::uint8_t> kGamepad{
    0x05, 0x01, 0x09, 0x05, 0xa1, 0x01, 0x85, 0x04, 0x09, 0x30, 0x09, 0x31, 0x15, 0x00, 0x26,
    0xff, 0x00, 0x75, 0x08, 0x95, 0x02, 0x81, 0x02, 0x05, 0x09, 0x19, 0x01, 0x29, 0x0a, 0x15,
    0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x0a, 0x81, 0x02, 0x95, 0x06, 0x81, 0x03, 0xc0};

TEST(HidDescriptor, ButtonsOfAGamepadAreFound) {
  const std::vector<ButtonField> fields = buttonFields(kGamepad);
  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].report_id, 4);
  EXPECT_EQ(fields[0].first_bit, 16U);
  EXPECT_EQ(fields[0].count, 10U);
  const std::vector<std::uint8_t> report{4, 0x80, 0x80, 0b00001001, 0b10};
  EXPECT_EQ(buttonsOf(report, fields), 0b10'0000'1001U);
  EXPECT_FALSE(buttonsOf(std::vector<std::uint8_t>{5, 0, 0, 1, 0}, fields)) << "another report";
  EXPECT_FALSE(buttonsOf(std::vector<std::uint8_t>{4, 0, 0, 1}, fields)) << "too short";
  EXPECT_FALSE(buttonsOf({}, fields));
}

TEST(HidDescriptor, AFootSwitchWithoutReportIdsIsUnderstood) {
  const std::vector<std::uint8_t> descriptor{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x05, 0x09,
                                             0x19, 0x01, 0x29, 0x03, 0x75, 0x01, 0x95, 0x03,
                                             0x81, 0x02, 0x95, 0x05, 0x81, 0x03, 0xc0};
  EXPECT_EQ(buttonsOf(std::vector<std::uint8_t>{0b110}, buttonFields(descriptor)), 0b110U);
}

TEST(HidDescriptor, RandomBytesAreReadWithoutHarm) {
  std::mt19937 random(20261121);
  for (int i = 0; i < 50'000; ++i) {
    std::vector<std::uint8_t> bytes = kGamepad;
    if (i % 2 == 0) {
      bytes.resize(random() % 200);
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    } else {
      for (int k = 0; k < 3; ++k)
        bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
      bytes.resize(random() % (bytes.size() + 1));
    }
    const std::vector<ButtonField> fields = buttonFields(bytes);
    ASSERT_LE(fields.size(), 64U);
    std::vector<std::uint8_t> report(random() % 65);
    for (std::uint8_t& byte : report) byte = static_cast<std::uint8_t>(random());
    (void)buttonsOf(report, fields);
  }
}

TEST(SpaceMouse, PushingTheCapMovesAsTheUserSees) {
  // x +350, y -350, z +175 as the device counts: right, away, down.
  const std::vector<std::uint8_t> report{1, 0x5e, 0x01, 0xa2, 0xfe, 0xaf, 0x00};
  const auto motion = capMotion(report);
  ASSERT_TRUE(motion);
  EXPECT_DOUBLE_EQ(motion->right, 1);
  EXPECT_DOUBLE_EQ(motion->toward, -1);
  EXPECT_DOUBLE_EQ(motion->up, -0.5);
  EXPECT_TRUE(capMotion(std::vector<std::uint8_t>{1, 0, 0, 0, 0, 0, 0, 9, 9, 9, 9, 9, 9}))
      << "wireless ones append rotations";
  EXPECT_FALSE(capMotion(std::vector<std::uint8_t>{2, 0, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(capMotion(std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(capButtons(std::vector<std::uint8_t>{3, 2, 0}), 2U);
  EXPECT_FALSE(capButtons(std::vector<std::uint8_t>{3}));
}

TEST(SpaceMouse, IsKnownByItsIds) {
  EXPECT_TRUE(isSpaceMouse(0x256f, 0xc635)) << "Compact";
  EXPECT_TRUE(isSpaceMouse(0x256f, 0xc62f)) << "Wireless";
  EXPECT_TRUE(isSpaceMouse(0x046d, 0xc626)) << "SpaceNavigator";
  EXPECT_FALSE(isSpaceMouse(0x046d, 0xc52b)) << "a receiver for mice";
}

}  // namespace
}  // namespace relievo::hid
