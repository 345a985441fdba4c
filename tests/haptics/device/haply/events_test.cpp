// SPDX-License-Identifier: BSD-3-Clause
// The service's channel of events: what is understood, and that nothing else matters.
#include "haptics/device/haply/events.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "haptics/device/haply/event_channel.h"
#include "haptics/device/haply/haply_device.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/emulator/haply/inverse_service.h"

namespace relievo::haply {
namespace {

using emulator::HaplyFault;
using emulator::HaplyWorld;
using emulator::InverseService;

constexpr std::int64_t kMs = 1'000'000, kMinute = 60'000 * kMs;

std::string eventOf(const std::string& name, const std::string& data) {
  return R"({"name":")" + name + R"(","category":"device","level":"warning","data":)" + data +
         R"(,"message":"words"})";
}

TEST(HaplyEvents, EachIsItsOwnSentence) {
  std::set<std::string> sentences;
  for (const auto& [name, data] : std::vector<std::pair<std::string, std::string>>{
           {"device-connected", R"({"device_id":"049D"})"},
           {"device-disconnected", "{}"},
           {"device-connection-loop", "{}"},
           {"device-battery-low", R"({"level":7})"},
           {"device-sleep", "null"},
           {"device-calibration-failed", "{}"},
           {"device-safety-triggered", R"({"safety_type":"ebrake_triggered"})"},
           {"device-safety-triggered", R"({"safety_type":"ebrake_released"})"},
           {"device-safety-triggered", R"({"safety_type":"stall_detected"})"},
           {"device-safety-triggered", R"({"safety_type":"stability_ceiling"})"}}) {
    const auto event = readEvent(eventOf(name, data));
    ASSERT_TRUE(event) << name << data;
    EXPECT_EQ(static_cast<std::size_t>(event->kind), sentences.size());
    sentences.insert(englishText(describe(*event)));
  }
  EXPECT_EQ(sentences.size(), kEventKinds);
  EXPECT_EQ(readEvent(eventOf("device-connected", R"({"device_id":"049D"})"))->device.view(),
            "049D");
}

TEST(HaplyEvents, WhatIsNotKnownOrDamagedIsNone) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("7"), std::string("{}"),
        eventOf("device-sings", "{}"), eventOf("device-safety-triggered", "{}"),
        eventOf("device-safety-triggered", R"({"safety_type":"hums"})"),
        eventOf("device-safety-triggered", R"({"safety_type":7})"),
        eventOf("device-sleep", "7") + "x", eventOf("device-sleep", "{}").substr(0, 40),
        eventOf("device-sleep", std::string(100, '[')),
        eventOf("device-sleep" + std::string(100, 'x'), "{}")}) {
    EXPECT_FALSE(readEvent(text)) << text;
  }
}

TEST(HaplyEvents, OneThatRepeatsIsNewsAgainAfterTenSeconds) {
  EventNews news;
  const ServiceEvent low{EventKind::battery_low, {}}, sleep{EventKind::sleep, {}};
  EXPECT_TRUE(news.isNews(low, 1000 * kMs));
  EXPECT_FALSE(news.isNews(low, 10'900 * kMs));
  EXPECT_TRUE(news.isNews(sleep, 10'900 * kMs)) << "another one";
  EXPECT_TRUE(news.isNews(low, 11'000 * kMs));
}

class HaplyEventChannel : public testing::Test {
 protected:
  ServiceAddress address() const {
    ServiceAddress address = *addressOf(std::to_string(mock_.port()));
    address.events_port = mock_.eventsPort();
    address.patience_ns = kMinute;
    return address;
  }
  void plant(HaplyFault fault) {
    mock_.with([&](HaplyWorld& world) { world.fault = fault; });
  }
  void tell(const char* name) {
    mock_.with([&](HaplyWorld& world) { world.tellEvent(name); });
  }
  /// Tells it again and again, as a new session hears only what comes after it.
  static bool comes(EventChannel& channel, EventKind kind, const std::function<void()>& tell) {
    const std::int64_t give_up = monotonicNs() + kMinute;
    for (std::int64_t now = monotonicNs(); now < give_up; now = monotonicNs()) {
      tell();
      for (const ServiceEvent& event : channel.poll(now)) {
        if (event.kind == kind) return true;
      }
      sleepUntil(now + 5 * kMs);
    }
    return false;
  }

  InverseService mock_;
};

TEST_F(HaplyEventChannel, TellsWhatComes) {
  EventChannel channel(address());
  EXPECT_TRUE(comes(channel, EventKind::battery_low, [this] { tell("device-battery-low"); }));
  EXPECT_TRUE(channel.isConnected());
  plant(HaplyFault::no_power);
  EXPECT_TRUE(comes(channel, EventKind::brake_pressed, [] {}));
  plant(HaplyFault::none);
  EXPECT_TRUE(comes(channel, EventKind::brake_released, [] {}));
}

TEST_F(HaplyEventChannel, GarbageBeforeAnEventHidesItNot) {
  plant(HaplyFault::events_garbage);
  EventChannel channel(address());
  EXPECT_TRUE(comes(channel, EventKind::sleep, [this] { tell("device-sleep"); }));
}

TEST_F(HaplyEventChannel, OneThatEndsIsBegunAnew) {
  plant(HaplyFault::events_close);
  EventChannel channel(address());
  EXPECT_TRUE(comes(channel, EventKind::sleep, [this] { tell("device-sleep"); }));
  plant(HaplyFault::none);
  EXPECT_TRUE(comes(channel, EventKind::stalled, [this] {
    mock_.with([](HaplyWorld& w) { w.tellEvent("device-safety-triggered", "stall_detected"); });
  }));
}

TEST_F(HaplyEventChannel, WithoutAPortNobodyIsSpokenTo) {
  ServiceAddress none = address();
  none.events_port = 0;
  EventChannel channel(none);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(channel.poll(i * kMinute).empty());
  EXPECT_FALSE(channel.isConnected());
}

/// The channel is for the eyes and ears; forces follow the states.
TEST_F(HaplyEventChannel, OneThatIsRefusedKeepsNoDeviceFromBeingReady) {
  plant(HaplyFault::events_refused);
  EventChannel channel(address());
  HaplyDevice device(inverseService(address()), "049D");
  device.open();
  const std::int64_t give_up = monotonicNs() + kMinute;
  bool ready = false;
  for (std::int64_t now = monotonicNs(); !ready && now < give_up; now = monotonicNs()) {
    EXPECT_TRUE(channel.poll(now).empty());
    device.exchange({}, now);
    ready = device.status().state == LinkState::ready;
    sleepUntil(now + kMs);
  }
  EXPECT_TRUE(ready);
}

}  // namespace
}  // namespace relievo::haply
