// SPDX-License-Identifier: BSD-3-Clause
// How the device stands: the same relief, pressed another way.
#include "haptics/space/grip_position.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr std::array<GripPosition, 4> kAll{GripPosition::upright, GripPosition::flat,
                                           GripPosition::left, GripPosition::right};

/// A device that a person holds, as long as it takes, where the test says.
class HeldDevice : public Device {
 public:
  HeldDevice() {
    info_.id = "held";
    info_.name = "held device";
    info_.max_force_n = 5;
    info_.workspace.half_extent = {40, 30, 20};
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  void open() override {}
  void close() noexcept override {}
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override {
    return {{x.load(), y.load(), z.load()}, 0, now_ns, DeviceFault::none};
  }
  void send(DeviceN force, std::int64_t) RELIEVO_REALTIME override {
    sent_x = force.x;
    sent_y = force.y;
    sent_z = force.z;
  }
  void hold(DeviceMm p) {
    x = p.x;
    y = p.y;
    z = p.z;
  }
  std::atomic<double> x = 0, y = 0, z = 0, sent_x = 0, sent_y = 0, sent_z = 0;

 private:
  DeviceInfo info_;
};

TEST(GripPosition, EachIsATurnThatComesBackAndKeepsHands) {
  const DeviceMm a{1, 2, 3}, b{-4, 5, 7};
  for (const GripPosition grip : kAll) {
    EXPECT_EQ(deviceFromHand(grip, handFromDevice(grip, a)), a) << name(grip);
    EXPECT_EQ(handFromDevice(grip, deviceFromHand(grip, a)), a) << name(grip);
    const DeviceMm x = handFromDevice(grip, DeviceMm{1, 0, 0}),
                   y = handFromDevice(grip, DeviceMm{0, 1, 0}),
                   z = handFromDevice(grip, DeviceMm{0, 0, 1});
    const DeviceMm cross{x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
    EXPECT_EQ(cross, z) << name(grip) << ": a turn, and no mirror";
    EXPECT_EQ(dot(handFromDevice(grip, a), handFromDevice(grip, b)), dot(a, b));
    EXPECT_EQ(gripPosition(name(grip)), grip);
  }
  EXPECT_FALSE(gripPosition("sideways").has_value());
}

TEST(GripPosition, PressingIsAwayFromThePersonOrDownOrBeforeADeviceAtTheSide) {
  // Where the device's grip goes, in its own axes, while the hand presses into the relief.
  const DeviceMm into{0, 0, -1};
  EXPECT_EQ(deviceFromHand(GripPosition::upright, into), (DeviceMm{0, 0, -1})) << "away";
  EXPECT_EQ(deviceFromHand(GripPosition::flat, into), (DeviceMm{0, -1, 0})) << "down";
  // A device at the right looks to the left: away from the person is to its left.
  EXPECT_EQ(deviceFromHand(GripPosition::right, into), (DeviceMm{-1, 0, 0}));
  EXPECT_EQ(deviceFromHand(GripPosition::left, into), (DeviceMm{1, 0, 0}));
}

TEST(GripPosition, ReachAndLiftTurnWithItAndAMouseHasNone) {
  const HeldDevice held;
  DeviceInfo device = held.info();
  device.grip_weight_n = 0.5;
  HapticOptions options;
  options.grip = GripPosition::flat;
  HapticOptions now = withinDevice(options, device);
  EXPECT_EQ(now.workspace.half_extent, (DeviceMm{40, 20, 30}));
  EXPECT_EQ(liftOf(now.force, 1), (DeviceN{0, 0, 0.5})) << "up is out of a relief that lies";
  options.grip = GripPosition::left;
  now = withinDevice(options, device);
  EXPECT_EQ(now.workspace.half_extent, (DeviceMm{20, 30, 40}));
  EXPECT_EQ(liftOf(now.force, 1), (DeviceN{0, 0.5, 0}));
  device.simulated = true;
  EXPECT_EQ(withinDevice(options, device).grip, GripPosition::upright);
  device.simulated = false;
  device.max_force_n = 0;
  EXPECT_EQ(withinDevice(options, device).grip, GripPosition::upright);
}

/// Takes samples until one satisfies something.
template <class Holds>
bool becomes(HapticLoop& loop, const Holds& holds) {
  constexpr std::int64_t kLimitNs = 60'000'000'000;
  HapticSample sample;
  for (const std::int64_t give_up = monotonicNs() + kLimitNs; monotonicNs() < give_up;) {
    loop.sayAlive();
    if (!loop.samples().pop(sample)) {
      std::this_thread::yield();
      continue;
    }
    if (holds(sample)) return true;
  }
  return false;
}

TEST(GripPosition, TheLoopTurnsPlacesAndForcesForTheDeviceItHas) {
  for (const GripPosition grip : kAll) {
    SCOPED_TRACE(name(grip));
    auto held = std::make_unique<HeldDevice>();
    HeldDevice& device = *held;
    device.hold(deviceFromHand(grip, DeviceMm{0, 0, 10}));
    HapticLoop loop(std::move(held));
    loop.spaces().write(*test::spaceOf(80, [](double, double) { return 0.0; }));
    HapticOptions options;
    options.grip = grip;
    options.force.forces_on = true;
    options.force.strength = 1;
    options.bound_by_rate = false;
    loop.options().write(options);
    loop.start();
    ASSERT_TRUE(becomes(loop, [](const HapticSample& s) { return s.engaged == EngagePhase::on; }));
    device.hold(deviceFromHand(grip, DeviceMm{0, 0, -2}));
    HapticSample felt;
    ASSERT_TRUE(becomes(loop, [&felt](const HapticSample& s) {
      felt = s;
      return s.contact && s.force.z > 1;
    }));
    EXPECT_EQ(felt.hip, (DeviceMm{0, 0, -2})) << "as the hand has it";
    const DeviceN sent = handFromDevice(
        grip, DeviceN{device.sent_x.load(), device.sent_y.load(), device.sent_z.load()});
    EXPECT_GT(sent.z, 1) << "out of the relief";
    EXPECT_NEAR(sent.x, 0, 1e-9);
    EXPECT_NEAR(sent.y, 0, 1e-9);
    loop.stop();
  }
}

TEST(GripPosition, AnotherOneUnderAHandThatPressesBeginsWithoutForce) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  const HeldDevice held;
  HapticOptions options = withinDevice({}, held.info());
  options.force.forces_on = true;
  HapticCore core;
  std::int64_t now_ns = 0;
  HapticSample last;
  const auto tick = [&](DeviceMm hand) {
    now_ns += 1'000'000;
    return last = core.tick(*space, options, {hand, 0, now_ns, {}}, now_ns);
  };
  for (int i = 0; i < 1500; ++i) tick({0, 0, 10});
  for (int i = 0; i < 500; ++i) tick({0, 0, -2});
  ASSERT_GT(last.force.z, 0.5);
  // The same hand elsewhere, deep in the relief.
  options.grip = GripPosition::flat;
  tick({0, 10, -5});
  EXPECT_EQ(last.force, DeviceN{});
  for (int i = 0; i < 300; ++i) EXPECT_EQ(tick({0, 10, -5}).force, DeviceN{}) << i;
  EXPECT_EQ(last.engaged, EngagePhase::waiting) << "until it is clear";
  for (int i = 0; i < 1500; ++i) tick({0, 10, 10});
  EXPECT_EQ(last.engaged, EngagePhase::on);
  EXPECT_EQ(core.audit().violations(), 0U);
}

}  // namespace
}  // namespace relievo
