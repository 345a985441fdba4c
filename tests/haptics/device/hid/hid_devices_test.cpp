// SPDX-License-Identifier: BSD-3-Clause
// Two HID devices through the real hidapi, with hot plug.
#include "haptics/device/hid/hid_devices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/emulator/mock_hid.h"
#include "tests/emulator/ordinary_account.h"

namespace relievo::hid {
namespace {

using emulator::MockHid;
using test::asOrdinaryAccount;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// Multi-axis controller; its contents are known by its ids.
const std::vector<std::uint8_t> kSpaceMouse{0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0x85,
                                            0x01, 0x75, 0x10, 0x95, 0x03, 0x09, 0x30,
                                            0x09, 0x31, 0x09, 0x32, 0x81, 0x06, 0xc0};
/// A joystick by its usage: three buttons, no report id.
const std::vector<std::uint8_t> kFootSwitch{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x05, 0x09,
                                            0x19, 0x01, 0x29, 0x03, 0x75, 0x01, 0x95, 0x03,
                                            0x81, 0x02, 0x95, 0x05, 0x81, 0x03, 0xc0};
const std::vector<std::uint8_t> kMouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x05, 0x09, 0x19, 0x01,
                                       0x29, 0x03, 0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0xc0};

std::vector<std::string> words(const std::vector<ButtonEdge>& edges) {
  constexpr std::array<const char*, 4> kNames{"plus", "forward", "centre", "minus"};
  std::vector<std::string> words;
  words.reserve(edges.size());
  for (const ButtonEdge& edge : edges) {
    words.push_back(std::string(kNames[edge.button]) + (edge.down ? " down" : " up"));
  }
  return words;
}

class HidTest : public ::testing::Test {
 protected:
  HidEvents rescanned() {
    HidEvents news;
    devices_.rescan(news);
    return news;
  }
  HidEvents polled() {
    HidEvents news;
    devices_.poll(news, now_s_);
    return news;
  }
  double now_s_ = 1000;
  MockHid mock_;
  HidDevices devices_;
};

TEST_F(HidTest, TwoDevicesAreFoundAndAMouseIsLeftAlone) {
  EXPECT_THAT(rescanned().arrived, IsEmpty());
  mock_.plugIn(0, 0x256f, 0xc635, "SpaceMouse Compact", kSpaceMouse);
  mock_.plugIn(1, 0x1234, 0x0001, "Foot switch", kFootSwitch);
  mock_.plugIn(2, 0x1234, 0x0002, "Plain mouse", kMouse);
  EXPECT_THAT(rescanned().arrived, UnorderedElementsAre("SpaceMouse Compact", "Foot switch"));
  EXPECT_THAT(rescanned().arrived, IsEmpty()) << "once";
  EXPECT_EQ(devices_.names().size(), 2U);
}

TEST_F(HidTest, LookingIsAnothersWorkAndWhoPollsHearsOfIt) {
  mock_.plugIn(0, 0x256f, 0xc635, "SpaceMouse Compact", kSpaceMouse);
  devices_.look();
  EXPECT_THAT(devices_.names(), IsEmpty()) << "what was found waits for the next poll";
  devices_.look();  // While it looks: nothing.
  HidEvents news;
  while (news.arrived.empty()) {
    devices_.poll(news, now_s_);
    std::this_thread::yield();
  }
  EXPECT_THAT(news.arrived, ElementsAre("SpaceMouse Compact"));
  mock_.send(0, {3, 2, 0});
  EXPECT_THAT(words(polled().edges), ElementsAre("plus down"));
}

TEST_F(HidTest, TheSpaceMouseMovesAndPresses) {
  mock_.plugIn(0, 0x256f, 0xc635, "SpaceMouse Compact", kSpaceMouse);
  rescanned();
  mock_.send(0, {1, 0x5e, 0x01, 0, 0, 0, 0});
  mock_.send(0, {3, 2, 0});
  HidEvents news = polled();
  EXPECT_DOUBLE_EQ(news.motion.right, 1);
  EXPECT_THAT(words(news.edges), ElementsAre("plus down"));
  EXPECT_DOUBLE_EQ(polled().motion.right, 1) << "as long as it is pushed";
  mock_.send(0, {1, 0, 0, 0, 0, 0, 0});
  mock_.send(0, {3, 1, 0});
  news = polled();
  EXPECT_DOUBLE_EQ(news.motion.right, 0);
  EXPECT_THAT(words(news.edges), ElementsAre("plus up", "minus down"));
}

TEST_F(HidTest, AWirelessOneThatIsLostWhileItIsPushedMovesNothingOn) {
  mock_.plugIn(0, 0x256f, 0xc62e, "SpaceMouse Wireless", kSpaceMouse);  // Its receiver stays.
  rescanned();
  mock_.send(0, {1, 0x5e, 0x01, 0, 0, 0, 0, 0x5e, 0x01, 0, 0, 0, 0});
  mock_.send(0, {3, 2, 0});
  EXPECT_DOUBLE_EQ(polled().motion.right, 1);
  now_s_ += CapReports::kLastsS / 2;
  EXPECT_DOUBLE_EQ(polled().motion.right, 1) << "reports may come late";
  now_s_ += CapReports::kLastsS;
  const HidEvents lost = polled();
  EXPECT_EQ(lost.motion, CapMotion{});
  EXPECT_THAT(lost.left, IsEmpty());
  mock_.send(0, {0x17, 90});  // Its battery is no motion.
  EXPECT_EQ(polled().motion, CapMotion{});
  mock_.send(0, {1, 0x5e, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_DOUBLE_EQ(polled().motion.right, 1) << "in reach again";
}

TEST_F(HidTest, AFootSwitchPressesTheFalconsButtons) {
  mock_.plugIn(1, 0x1234, 0x0001, "Foot switch", kFootSwitch);
  rescanned();
  // A press and its release between two polls are two edges.
  for (const int bits : {0b001, 0b000, 0b010, 0b110, 0b000}) {
    mock_.send(1, {static_cast<std::uint8_t>(bits)});
  }
  EXPECT_THAT(words(polled().edges), ElementsAre("plus down", "plus up", "forward down",
                                                 "centre down", "forward up", "centre up"));
}

TEST_F(HidTest, UnpluggingLetsGoOfTheButtonsAndPluggingInWorksAgain) {
  mock_.plugIn(1, 0x1234, 0x0001, "Foot switch", kFootSwitch);
  rescanned();
  mock_.send(1, {0b001});
  polled();
  mock_.unplug(1);
  HidEvents news = rescanned();
  EXPECT_THAT(news.left, ElementsAre("Foot switch"));
  EXPECT_THAT(words(news.edges), ElementsAre("plus up"));
  EXPECT_THAT(devices_.names(), IsEmpty());
  mock_.plugIn(1, 0x1234, 0x0001, "Foot switch", kFootSwitch);
  EXPECT_THAT(rescanned().arrived, ElementsAre("Foot switch"));
  mock_.send(1, {0b100});
  EXPECT_THAT(words(polled().edges), ElementsAre("centre down"));
}

TEST_F(HidTest, OneThatMayNotBeOpenedIsToldOnceAndTakenWhenItMay) {
  mock_.plugIn(0, 0x256f, 0xc635, "SpaceMouse Compact", kSpaceMouse);
  mock_.plugIn(1, 0x1234, 0x0001, "Foot switch", kFootSwitch);
  mock_.plugIn(2, 0x1234, 0x0002, "Plain mouse", kMouse);
  mock_.forbid(1, true);
  mock_.forbid(2, true);
  asOrdinaryAccount([this] {
    HidEvents news = rescanned();
    EXPECT_THAT(news.arrived, ElementsAre("SpaceMouse Compact"));
    EXPECT_THAT(news.forbidden, IsEmpty()) << "access may come a moment after the plug";
    EXPECT_THAT(devices_.forbidden(), ElementsAre("Foot switch")) << "nobody opens a mouse";
    EXPECT_THAT(rescanned().forbidden, ElementsAre("Foot switch"));
    EXPECT_THAT(rescanned().forbidden, IsEmpty()) << "once";
    EXPECT_THAT(devices_.forbidden(), ElementsAre("Foot switch"));
    EXPECT_THAT(devices_.names(), ElementsAre("SpaceMouse Compact"));
  });
  mock_.forbid(1, false);
  asOrdinaryAccount([this] {
    EXPECT_THAT(rescanned().arrived, ElementsAre("Foot switch"));
    EXPECT_THAT(devices_.forbidden(), IsEmpty());
  });
}

TEST_F(HidTest, ThousandsOfReportsKeepTheirBounds) {
  mock_.plugIn(1, 0x1234, 0x0001, "Foot switch", kFootSwitch);
  rescanned();
  int downs = 0;
  for (int i = 0; i < 1000; ++i) {
    mock_.send(1, {0b001});
    mock_.send(1, {0b000});
    for (const ButtonEdge& edge : polled().edges) downs += edge.down ? 1 : 0;
  }
  EXPECT_EQ(downs, 1000);
}

}  // namespace
}  // namespace relievo::hid
