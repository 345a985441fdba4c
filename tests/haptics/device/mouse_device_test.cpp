// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/mouse_device.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "haptics/device/scripted_device.h"
#include "haptics/device_catalog.h"

namespace relievo {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(MouseDevice, FollowsItsTargetWithoutJumps) {
  MouseDevice mouse;
  mouse.placeAt({0, 0, 0});
  std::int64_t now = 100 * kMs;
  mouse.exchange({}, now);
  mouse.moveTo({16, 0, 0});
  double last = 0;
  for (int i = 1; i <= 100; ++i) {
    now += kMs;
    const double x = mouse.exchange({}, now).position.x;
    EXPECT_GE(x, last);
    EXPECT_LT(x - last, 2.0) << "an eighth of the way in the first tick, less later";
    last = x;
    if (i == 8) {
      EXPECT_NEAR(x, 16 * (1 - std::exp(-1)), 1e-9);
    }
  }
  EXPECT_NEAR(last, 16, 1e-3);
}

TEST(MouseDevice, ArrivesAtTheSamePlaceWhenATickIsLate) {
  MouseDevice even, late;
  for (MouseDevice* mouse : {&even, &late}) {
    mouse->placeAt({});
    mouse->exchange({}, kMs);
    mouse->moveTo({5, -3, 2});
  }
  DeviceReading a;
  for (int i = 2; i <= 21; ++i) a = even.exchange({}, i * kMs);
  const DeviceReading b = late.exchange({}, 21 * kMs);
  EXPECT_NEAR(norm(a.position - b.position), 0, 1e-12);
}

TEST(MouseDevice, IsNeverStaleAndCanBePlaced) {
  MouseDevice mouse;
  mouse.placeAt({1, 2, 3});
  EXPECT_EQ(mouse.exchange({}, kMs).position, (DeviceMm{1, 2, 3}));
  const DeviceReading later = mouse.exchange({}, 5000 * kMs);
  EXPECT_EQ(later.time_ns, 5000 * kMs);
  mouse.placeAt({9, 9, 9});
  mouse.moveTo({10, 9, 9});  // Before the loop has seen the jump.
  EXPECT_GE(mouse.exchange({}, 5001 * kMs).position.x, 9);
  mouse.setButtons(5);
  EXPECT_EQ(mouse.exchange({}, 5002 * kMs).buttons, 5U);
  EXPECT_EQ(mouse.info().max_force_n, 0) << "cannot push back";
}

TEST(MouseDevice, HoversWhereThePointerIsAndIsPutDownFromThere) {
  MouseDevice mouse;
  mouse.hoverAt({1, 2, 3});
  DeviceReading reading = mouse.exchange({}, kMs);
  EXPECT_EQ(reading.position, (DeviceMm{1, 2, 3}));
  EXPECT_EQ(reading.buttons, kHoverBit);
  // Far away, and pressed in before the loop has looked.
  mouse.setButtons(1);
  mouse.hoverAt({60, 2, 3});
  mouse.moveTo({60, 2, -1});
  reading = mouse.exchange({}, 2 * kMs);
  EXPECT_EQ(reading.position, (DeviceMm{60, 2, 3})) << "once where it begins";
  EXPECT_EQ(reading.buttons, 1U | kHoverBit);
  reading = mouse.exchange({}, 3 * kMs);
  EXPECT_EQ(reading.buttons, 1U);
  EXPECT_EQ(reading.position.x, 60);
  EXPECT_LT(reading.position.z, 3);
  mouse.placeAt({0, 0, 0});
  EXPECT_EQ(mouse.exchange({}, 4 * kMs).position, DeviceMm{});
}

TEST(ScriptedDevice, PlaysItsReadingsAndStaysAtTheLast) {
  ScriptedDevice device({{{1, 0, 0}, 0, 0}, {{2, 0, 0}, 1, 5 * kMs}});
  EXPECT_EQ(device.exchange({}, 100 * kMs).position.x, 1);
  const DeviceReading second = device.exchange({0, 0, 2}, 101 * kMs);
  EXPECT_EQ(second.time_ns, 96 * kMs) << "5 ms old";
  EXPECT_EQ(device.exchange({}, 102 * kMs).position.x, 2);
  EXPECT_THROW(ScriptedDevice({}), ArgumentError);
}

TEST(DeviceCatalog, KnowsTheMouse) {
  const std::vector<DeviceDriver> drivers = deviceCatalog();
  ASSERT_FALSE(drivers.empty());
  EXPECT_EQ(drivers[0].scan(), std::vector<std::string>{"mouse"});
  EXPECT_EQ(drivers[0].make("mouse")->info().id, "mouse");
  EXPECT_THROW(drivers[0].make("another"), DeviceError);
}

}  // namespace
}  // namespace relievo
