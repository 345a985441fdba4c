// SPDX-License-Identifier: BSD-3-Clause
// Whatever is asked for, a device gets no more than its data sheet allows.
#include "haptics/loop/device_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "haptics/device/virtual_hand.h"
#include "haptics/device_catalog.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

DeviceInfo small() {
  DeviceInfo device;
  device.name = "small";
  device.max_force_n = 2;
  device.max_stiffness_n_per_mm = 0.7;
  device.max_damping_n_s_per_mm = 0.001;
  device.max_slew_n_per_s = 50;
  return device;
}

HapticOptions tooMuch() {
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = 1000;
  options.force.damping_n_s_per_mm = 1;
  options.force.contact_slew_n_per_s = 1234;
  options.force.strength = 1;
  options.force.forces_on = true;
  return options;
}

TEST(DeviceLimits, KeepEveryNumberWithinTheDataSheet) {
  HapticOptions options = tooMuch();
  options.detail_stiffness = {9, 0.5, 9, 9};
  const HapticOptions now = withinDevice(options, small());
  EXPECT_EQ(now.force.limit_n, 2);
  EXPECT_EQ(now.force.stiffness_n_per_mm, 0.7);
  EXPECT_EQ(now.detail_stiffness, (DetailStiffness{0.7, 0.5, 0.7, 0.7}));
  EXPECT_EQ(now.force.damping_n_s_per_mm, 0.001);
  EXPECT_EQ(now.force.contact_slew_n_per_s, 50);
  EXPECT_EQ(now.force.engage_slew_n_per_s, 20) << "less than that";
  EXPECT_EQ(limitedText(now, small()), "") << "twice changes nothing";
}

TEST(DeviceLimits, AreSaidInOneSentence) {
  EXPECT_EQ(limitedText(tooMuch(), small()),
            "More was asked for than the device (small) is made for: stiffness 0.7 N/mm instead of "
            "1000, damping 0.001 N s/mm instead of 1, force 2 N instead of 6, change of force 50 "
            "N/s instead of 1234.");
  EXPECT_EQ(limitedText({}, VirtualHand().info()), "");
  EXPECT_EQ(limitedText(tooMuch(), {}), "") << "a device without a data sheet";
}

TEST(DeviceLimits, EveryDeviceThatPushesHasAWholeDataSheet) {
  for (const char* id : {"virtual", "falcon"}) {
    const DeviceInfo device = makeDevice(id)->info();
    EXPECT_GT(device.max_force_n, 0) << id;
    EXPECT_GT(device.max_stiffness_n_per_mm, 0) << id;
    EXPECT_GT(device.max_slew_n_per_s, 0) << id;
    EXPECT_EQ(device.simulated, std::string(id) == "virtual");
  }
}

TEST(DeviceLimits, HoldForTheForceThatIsSent) {
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  const HapticOptions options = withinDevice(tooMuch(), small());
  HapticCore core;
  DeviceN before;
  for (int i = 0; i < 4000; ++i) {
    DeviceReading reading;
    reading.time_ns = i * 1'000'000LL;
    reading.position = {0, 0, i < 2000 ? 5.0 : -5.0};
    const DeviceN now = core.tick(*space, options, reading, reading.time_ns).force;
    ASSERT_LE(norm(now), 2 + 1e-9);
    ASSERT_LE(norm(now - before), 0.05 + 1e-9);
    before = now;
  }
  EXPECT_NEAR(norm(before), 2, 1e-9);
}

/// Force of a hand that has rested at each of these depths under a plane; on the right half of it
/// what was felt is made up.
std::vector<double> restedAt(const HapticSpace& space, const HapticOptions& options, double x_mm,
                             const std::vector<double>& depths_mm) {
  HapticCore core;
  std::vector<double> forces;
  std::int64_t tick = 0;
  double stiffest = 0;
  const auto rest = [&](double z, int ticks) {
    double force = 0;
    for (int i = 0; i < ticks; ++i, ++tick) {
      DeviceReading reading;
      reading.time_ns = tick * 1'000'000;
      reading.position = {x_mm, 0, z};
      const HapticSample sample = core.tick(space, options, reading, reading.time_ns);
      stiffest = std::max(stiffest, sample.stiffness_n_per_mm);
      force = sample.force.z;
    }
    return force;
  };
  rest(5, 2000);
  for (const double depth : depths_mm) forces.push_back(rest(-depth, 1500));
  EXPECT_LE(stiffest, 0.4);
  EXPECT_EQ(core.audit().violations(), 0U);
  EXPECT_EQ(core.audit().ticks, static_cast<std::uint64_t>(tick));
  return forces;
}

TEST(DeviceLimits, ASoftDeviceRendersNothingStiffer) {
  DeviceInfo device;
  device.max_force_n = 3.3;
  device.max_stiffness_n_per_mm = 0.4;
  RegionWindow window = test::windowOf(80, [](double, double) { return 0.0; });
  for (std::size_t i = 0; i < window.origins.size(); ++i) {
    if (i % kWindowSamples >= kWindowSamples / 2) window.origins[i] = CellStatus::base_plane;
  }
  const std::vector<double> depths{0.5, 1, 1.5, 2};
  int pushed = 0;
  for (int detail = 1; detail <= 4; ++detail) {
    const auto space = std::make_unique<HapticSpace>();
    fill(*space, window, {.detail = detail, .levels = 4}, SurfaceKind::crease_aware);
    for (const bool by_detail : {true, false}) {
      for (const double asked : {0.05, 0.4, 0.8, 3.0}) {
        for (const double softest : {1.0, 0.5}) {
          HapticOptions options;
          options.stiffness_by_detail = by_detail;
          options.force.stiffness_n_per_mm = asked;
          if (asked > 0.4) options.detail_stiffness.fill(asked);
          options.force.strength = 1;
          options.force.forces_on = true;
          options.fields = {.softest_part = softest};
          for (const double x_mm : {-15.0, 15.0}) {
            const auto forces = restedAt(*space, withinDevice(options, device), x_mm, depths);
            for (std::size_t i = 0; i < depths.size(); ++i) {
              EXPECT_LE(forces[i], 0.4 * depths[i] + 1e-6) << "asked " << asked;
            }
            for (std::size_t i = 1; i < depths.size(); ++i) {
              EXPECT_LE(forces[i] - forces[i - 1], 0.4 * (depths[i] - depths[i - 1]) + 1e-6);
            }
            pushed += forces.back() > 0.7 ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(pushed, 60) << "it does push";
}

}  // namespace
}  // namespace relievo
