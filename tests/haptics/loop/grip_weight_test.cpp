// SPDX-License-Identifier: BSD-3-Clause
// A device that holds its own grip: the force goes the way of every other.
#include <gtest/gtest.h>

#include <limits>

#include "haptics/device/scripted_device.h"
#include "haptics/loop/device_limits.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr double kGripN = 0.8;

DeviceInfo heavyGrip() {
  DeviceInfo device;
  device.max_force_n = 5;
  device.grip_weight_n = kGripN;
  return device;
}

class GripWeightTest : public ::testing::Test {
 protected:
  explicit GripWeightTest() {
    options_.force.forces_on = true;
    options_.force.strength = 0.3;
  }
  HapticSample tick(DeviceMm hand = {0, 0, 20}) {
    now_ns_ += 1'000'000;
    last_ = core_.tick(*space_, withinDevice(options_, device_), {hand, 0, now_ns_, {}}, now_ns_);
    return last_;
  }
  void rise() {
    for (int i = 0; i < 1500; ++i) tick();
  }
  std::unique_ptr<HapticSpace> space_ = test::spaceOf(80, [](double, double) { return 0.0; });
  DeviceInfo device_ = heavyGrip();
  HapticOptions options_;
  HapticCore core_;
  HapticSample last_;
  std::int64_t now_ns_ = 0;
};

TEST_F(GripWeightTest, ItIsHeldUpwardAtEveryStrengthAndRisesWithTheForces) {
  double largest_step_n = 0, before_n = 0;
  for (int i = 0; i < 1500; ++i) {
    const double up_n = tick().force.y;
    largest_step_n = std::max(largest_step_n, std::abs(up_n - before_n));
    before_n = up_n;
  }
  EXPECT_NEAR(last_.force.y, kGripN, 1e-12);
  EXPECT_EQ(last_.force.x, 0);
  EXPECT_EQ(last_.force.z, 0);
  EXPECT_LT(largest_step_n, 0.002) << "N in a tick";
  options_.force.strength = 1;
  for (int i = 0; i < 10; ++i) tick();
  EXPECT_NEAR(last_.force.y, kGripN, 1e-12);
  options_.force.forces_on = false;
  EXPECT_EQ(tick().force, DeviceN{}) << "off is off";
}

TEST_F(GripWeightTest, SwitchedOffItGoesByTheRuleOfEverySetting) {
  rise();
  options_.holds_grip = false;
  double before_n = last_.force.y, largest_step_n = 0;
  for (int i = 0; i < 400; ++i) {
    const double up_n = tick().force.y;
    largest_step_n = std::max(largest_step_n, before_n - up_n);
    before_n = up_n;
  }
  EXPECT_EQ(before_n, 0);
  EXPECT_LE(largest_step_n, 0.005);
  EXPECT_GT(largest_step_n, 0);
}

TEST_F(GripWeightTest, TheLimitHoldsForItAsForEveryForce) {
  options_.force.limit_n = 0.5;
  rise();
  EXPECT_NEAR(norm(last_.force), 0.5, 1e-12);
  EXPECT_EQ(core_.audit().violations(), 0U);
}

TEST_F(GripWeightTest, ADeviceThatHoldsItselfAndAWeightThatIsNoNumberGetNothing) {
  device_.holds_its_grip = true;
  rise();
  EXPECT_EQ(last_.force, DeviceN{});
  device_ = heavyGrip();
  device_.grip_weight_n = std::numeric_limits<double>::quiet_NaN();
  rise();
  EXPECT_EQ(last_.force, DeviceN{});
}

/// What lifts the grip on the way down and lets it down on the way up gains nothing.
TEST_F(GripWeightTest, ItOwesNoEnergyOnAClosedWay) {
  rise();
  double owed_mj = 0;
  for (int i = 0; i < 4000; ++i) {
    const double y = 15 * std::sin(2 * 3.14159265358979 * i / 1000);
    owed_mj = std::min(owed_mj, tick({0, y, 20}).margin_mj);
    EXPECT_EQ(last_.damped_n, 0);
  }
  EXPECT_GT(owed_mj, -1e-6);
}

}  // namespace
}  // namespace relievo
