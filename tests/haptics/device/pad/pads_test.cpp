// SPDX-License-Identifier: BSD-3-Clause
// Gamepads through the real files of the kernel, made by umockdev: buttons, hot plug, rumble.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "haptics/device/pad/pad_devices.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/emulator/mock_pad.h"
#include "tests/emulator/ordinary_account.h"

namespace relievo::pad {
namespace {

using emulator::MockPad;
using emulator::RumbleCall;
using testing::ElementsAre;
using testing::IsEmpty;
using What = RumbleCall::What;

const std::vector<int> kXboxKeys{0x130, 0x131, 0x133, 0x134, 0x136, 0x137, 0x13a, 0x13b};
const MockPad::Kind kXbox{.name = "Xbox pad", .keys = kXboxKeys};

std::vector<std::string> words(const std::vector<PadEdge>& edges) {
  constexpr std::array<const char*, 4> kNames{"plus", "forward", "centre", "minus"};
  std::vector<std::string> words;
  for (const PadEdge& edge : edges) {
    words.push_back(std::string(kNames.at(edge.button)) + (edge.down ? " down" : " up"));
  }
  return words;
}

class Pads : public testing::Test {
 protected:
  PadNews rescanned() {
    PadNews news;
    devices_.rescan(news);
    return news;
  }
  PadNews polled() {
    PadNews news;
    devices_.poll(news);
    return news;
  }
  /// One tick of a hand, and the drain's look after it.
  void touch(const TouchMoment& moment) {
    TouchMoment now = moment;
    now.time_ns = monotonicNs();
    rumbler_->take(std::span(&now, 1), now.time_ns);
  }

  MockPad mock_;
  std::shared_ptr<Rumbler> rumbler_ = std::make_shared<Rumbler>();
  PadDevices devices_{rumbler_};
};

TEST_F(Pads, ButtonsThatHidrawDoesNotShowPress) {
  EXPECT_THAT(rescanned().arrived, IsEmpty());
  const int pad = mock_.plugIn(kXbox);
  EXPECT_THAT(rescanned().arrived, ElementsAre("Xbox pad"));
  EXPECT_THAT(rescanned().arrived, IsEmpty()) << "once";
  for (const int key : {0x130, 0x131, 0x133, 0x134, 0x13a}) {
    mock_.press(pad, key, true);
    mock_.press(pad, key, false);
  }
  EXPECT_THAT(words(polled().edges),
              ElementsAre("plus down", "plus up", "forward down", "forward up", "centre down",
                          "centre up", "minus down", "minus up"));
}

TEST_F(Pads, WhatHidrawShowsIsNotPressedTwiceAndRumblesAllTheSame) {
  const int pad = mock_.plugIn({.name = "DualShock", .keys = kXboxKeys, .has_hidraw = true});
  EXPECT_THAT(rescanned().arrived, ElementsAre("DualShock"));
  mock_.press(pad, 0x130, true);
  EXPECT_THAT(polled().edges, IsEmpty());
  rumbler_->setOn(true);
  touch({.counts = true});
  touch({.counts = true, .contact = true, .force_n = 1});
  EXPECT_EQ(mock_.rumble(pad).size(), 2U);
}

TEST_F(Pads, KeyboardsAndMiceAreLeftAlone) {
  mock_.plugIn({.name = "Keyboard", .keys = {1, 28, 30}});
  mock_.plugIn({.name = "Mouse", .keys = {0x110, 0x111, 0x112}});
  EXPECT_THAT(rescanned().arrived, IsEmpty());
  EXPECT_THAT(devices_.seen(), IsEmpty());
}

TEST_F(Pads, UnpluggingLetsGoOfTheButtonsAndPluggingInWorksAgain) {
  const int pad = mock_.plugIn(kXbox);
  rescanned();
  mock_.press(pad, 0x130, true);
  EXPECT_THAT(words(polled().edges), ElementsAre("plus down"));
  mock_.pullCable(pad);
  PadNews news = polled();
  EXPECT_THAT(words(news.edges), ElementsAre("plus up"));
  EXPECT_THAT(news.left, ElementsAre("Xbox pad"));
  mock_.unplug(pad);
  EXPECT_THAT(rescanned().left, IsEmpty()) << "once";
  const int again = mock_.plugIn(kXbox);
  EXPECT_THAT(rescanned().arrived, ElementsAre("Xbox pad"));
  mock_.press(again, 0x131, true);
  EXPECT_THAT(words(polled().edges), ElementsAre("forward down"));
}

TEST_F(Pads, AfterLostEventsTheButtonsAreAskedFor) {
  const int pad = mock_.plugIn(kXbox);
  rescanned();
  mock_.press(pad, 0x130, true);
  polled();
  mock_.dropEvents(pad, {0x134});
  EXPECT_THAT(words(polled().edges), ElementsAre("plus up", "minus down"));
}

TEST_F(Pads, OneThatMayNotBeOpenedIsTakenWhenItMay) {
  const int pad = mock_.plugIn(kXbox);
  mock_.forbid(pad, true);
  test::asOrdinaryAccount([this] {
    EXPECT_THAT(rescanned().arrived, IsEmpty());
    ASSERT_EQ(devices_.seen().size(), 1U);
    EXPECT_FALSE(devices_.seen()[0].access);
  });
  mock_.forbid(pad, false);
  test::asOrdinaryAccount([this] {
    EXPECT_THAT(rescanned().arrived, ElementsAre("Xbox pad"));
    EXPECT_TRUE(devices_.seen()[0].access);
  });
}

TEST_F(Pads, AContactIsUploadedAndPlayedAtOnceForAShortWhile) {
  const int pad = mock_.plugIn(kXbox);
  rescanned();
  rumbler_->setOn(true);
  touch({.counts = true});
  const std::int64_t contact_ns = monotonicNs();
  touch({.counts = true, .contact = true, .force_n = 2});
  const auto calls = mock_.rumble(pad);
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[0].what, What::upload);
  EXPECT_TRUE(calls[0].is_new);
  EXPECT_EQ(calls[0].strong, 0xffffU);
  EXPECT_EQ(calls[0].weak, 0U);
  EXPECT_LE(calls[0].length_ms, 200);
  EXPECT_EQ(calls[1].what, What::play);
  // A figure for docs/adr/0181, no promise of a busy computer.
  std::printf("upload and play %.2f ms after the contact\n",
              1e-6 * static_cast<double>(calls[1].time_ns - contact_ns));
  touch({.counts = false});
  const auto ended = mock_.rumble(pad);
  ASSERT_EQ(ended.size(), 3U);
  EXPECT_EQ(ended[2].what, What::stop);
  touch({.counts = true, .contact = true, .force_n = 1});
  const auto changed = mock_.rumble(pad);
  ASSERT_EQ(changed.size(), 5U);
  EXPECT_FALSE(changed[3].is_new) << "one effect, changed in its place";
}

TEST_F(Pads, UnpluggingInTheMiddleOfAnEffectIsHarmless) {
  const int pad = mock_.plugIn(kXbox);
  const int other = mock_.plugIn(kXbox);
  rescanned();
  rumbler_->setOn(true);
  touch({.counts = true});
  touch({.counts = true, .contact = true, .force_n = 2});
  mock_.pullCable(pad);
  touch({.counts = false});
  touch({.counts = true, .contact = true, .force_n = 2});
  EXPECT_EQ(mock_.rumble(pad).size(), 2U);
  EXPECT_EQ(mock_.rumble(other).size(), 5U);
  EXPECT_THAT(polled().left, ElementsAre("Xbox pad"));
}

}  // namespace
}  // namespace relievo::pad
