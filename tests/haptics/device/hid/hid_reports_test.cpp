// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/hid/hid_reports.h"

#include <gtest/gtest.h>

#include <array>
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

/// Motion after these reports of a cap that was at rest.
CapMotion after(const std::vector<std::vector<std::uint8_t>>& reports) {
  CapMotion motion;
  for (const std::vector<std::uint8_t>& report : reports) {
    motion = capMotion(report, motion).value_or(motion);
  }
  return motion;
}

TEST(SpaceMouse, PushingTheCapMovesAsTheUserSees) {
  // x +350, y -350, z +175 as the device counts: right, away, down.
  const CapMotion motion = after({{1, 0x5e, 0x01, 0xa2, 0xfe, 0xaf, 0x00}});
  EXPECT_EQ(motion, (CapMotion{.right = 1, .up = -0.5, .toward = -1}));
  EXPECT_EQ(capButtons(std::vector<std::uint8_t>{3, 2, 0}), 2U);
  EXPECT_FALSE(capButtons(std::vector<std::uint8_t>{3}));
}

TEST(SpaceMouse, AWiredOneTellsItsTurnsInAReportOfTheirOwn) {
  // As a SpaceMouse Compact sends them in turn while it is tilted and twisted a little.
  const CapMotion motion =
      after({{2, 0x20, 0x00, 0x00, 0x00, 0x17, 0x00}, {1, 0x12, 0x00, 0x00, 0x00, 0xf8, 0x00}});
  EXPECT_EQ(motion, (CapMotion{.right = 18 / 350.0,
                               .up = -248 / 350.0,
                               .about_right = 32 / 350.0,
                               .about_up = -23 / 350.0}))
      << "its top toward the user, clockwise from above, and pushed down: neither report ends the "
         "other's axes";
  EXPECT_EQ(after({{2, 0, 0, 0x5e, 0x01, 0, 0}}), (CapMotion{.about_toward = 1}))
      << "the device's second axis points toward the user";
  EXPECT_EQ(after({{2, 0x20, 0, 0, 0, 0x17, 0}, {1, 0, 0, 0, 0, 0, 0}, {2, 0, 0, 0, 0, 0, 0}}),
            CapMotion{})
      << "let go of";
}

TEST(SpaceMouse, AWirelessOneTellsAllSixInOneReport) {
  // x, y, z, then the turns about them: 350, -350, 175, 70, 35, -140.
  const std::vector<std::uint8_t> report{1,    0x5e, 0x01, 0xa2, 0xfe, 0xaf, 0x00,
                                         0x46, 0x00, 0x23, 0x00, 0x74, 0xff};
  EXPECT_EQ(after({report}), (CapMotion{.right = 1,
                                        .up = -0.5,
                                        .toward = -1,
                                        .about_right = 0.2,
                                        .about_up = 0.4,
                                        .about_toward = 0.1}));
  std::vector<std::uint8_t> rest(13, 0);
  rest[0] = 1;
  EXPECT_EQ(after({report, rest}), CapMotion{});
}

TEST(SpaceMouse, WhatIsNotWholeInAReportStays) {
  const CapMotion before{.right = 0.5, .about_up = 0.25};
  for (std::size_t size = 0; size <= 13; ++size) {
    for (std::uint8_t id = 0; id < 4; ++id) {
      std::vector<std::uint8_t> report(size, 0);
      if (size > 0) report[0] = id;
      const auto motion = capMotion(report, before);
      const bool is_motion = size >= 7 && (id == 1 || id == 2);
      ASSERT_EQ(motion.has_value(), is_motion) << "report " << int{id} << " of " << size;
      if (!is_motion) continue;
      EXPECT_EQ(motion->right, id == 1 ? 0 : 0.5);
      EXPECT_EQ(motion->about_up, id == 2 || size == 13 ? 0 : 0.25);
    }
  }
}

TEST(SpaceMouse, ACapThatIsNotQuiteCentredIsAtRest) {
  const CapMotion drift{0.04, -0.04, 0.02, -0.02, 0.01, 0.04};
  EXPECT_EQ(beyondRest(drift), CapMotion{});
  EXPECT_EQ(beyondRest({1, -1, 1, -1, 1, -1}), (CapMotion{1, -1, 1, -1, 1, -1}))
      << "full deflection is as much as before";
  const CapMotion little = beyondRest({.right = 0.05, .about_up = -0.05});
  EXPECT_GT(little.right, 0);
  EXPECT_LT(little.right, 0.02) << "it begins without a jump";
  EXPECT_DOUBLE_EQ(little.about_up, -little.right);
}

TEST(SpaceMouse, ACapThatIsHeldStillIsPushedAsLongAsItReports) {
  const std::vector<std::uint8_t> pushed{1, 0x5e, 0x01, 0, 0, 0, 0};
  CapReports cap;
  EXPECT_EQ(cap.motion(0), CapMotion{});
  double now_s = 50;
  for (int i = 0; i < 1000; ++i) {
    now_s += 0.016;
    cap.take(pushed, now_s);
    ASSERT_DOUBLE_EQ(cap.motion(now_s).right, 1) << i;
  }
  EXPECT_DOUBLE_EQ(cap.motion(now_s + 0.9 * CapReports::kLastsS).right, 1);
  EXPECT_EQ(cap.motion(now_s + 1.1 * CapReports::kLastsS), CapMotion{});
  cap.take(std::array<std::uint8_t, 3>{3, 1, 0}, now_s + 1);
  EXPECT_EQ(cap.motion(now_s + 1), CapMotion{}) << "a button tells nothing of the cap";
}

TEST(SpaceMouse, IsKnownByItsIds) {
  EXPECT_TRUE(isSpaceMouse(0x256f, 0xc635)) << "Compact";
  EXPECT_TRUE(isSpaceMouse(0x256f, 0xc62f)) << "Wireless";
  EXPECT_TRUE(isSpaceMouse(0x046d, 0xc626)) << "SpaceNavigator";
  EXPECT_FALSE(isSpaceMouse(0x046d, 0xc52b)) << "a receiver for mice";
}

}  // namespace
}  // namespace relievo::hid
