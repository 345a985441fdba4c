// SPDX-License-Identifier: BSD-3-Clause
// For the first session with a real Falcon (test_plan.md): which way each encoder counts, and what
// each motor does alone.
// falcon_arms SECONDS: 100 counts to one motor after the other, 150 ms each; then the encoders,
// four times a second for SECONDS, while a person moves the grip.
#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/kinematics.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/realtime_thread.h"

namespace {

using namespace relievo;
using falcon::kArms;

constexpr std::int64_t kMs = 1'000'000;
constexpr double kCounts = 100;
constexpr int kPulseMs = 150, kRestMs = 400, kMostWaitMs = 60'000;
constexpr std::array<const char*, kArms> kNames{"top", "right", "left"};

/// One exchange a millisecond.
class Session {
 public:
  explicit Session(falcon::FalconDevice& device) : device_(device), deadline_(monotonicNs()) {}
  bool exchange(DeviceN force) {
    // Never faster: a pulse that makes up for what was missed would be none.
    sleepUntil(deadline_ = std::max(deadline_ + kMs, monotonicNs()));
    return device_.exchange(force, monotonicNs()).fault == DeviceFault::none;
  }
  bool rest(int ms) {
    bool whole = true;
    for (int i = 0; i < ms; ++i) whole = exchange({}) && whole;
    return whole;
  }
  bool becomesReady() {
    for (int i = 0; i < kMostWaitMs; ++i) {
      if (exchange({})) return true;
    }
    return false;
  }
  const falcon::LinkStatus& status() { return device_.status(); }

 private:
  falcon::FalconDevice& device_;
  std::int64_t deadline_;
};

/// The force that takes so many counts of one motor and none of the others: F = H^T tau.
DeviceN forceOfMotor(std::size_t motor, const falcon::LinkStatus& status, double counts_per_n_mm) {
  const falcon::Angles angles = falcon::anglesFromEncoders(status.encoders);
  const auto grip = falcon::gripFromAngles(angles);
  const auto jacobian = grip ? falcon::angleJacobian(*grip, angles) : std::nullopt;
  if (!jacobian) return {};
  const auto& row = (*jacobian)[motor];
  const double torque_n_mm = kCounts / counts_per_n_mm;
  return {torque_n_mm * row[0], torque_n_mm * row[1], torque_n_mm * row[2]};
}

/// @return false: it was interrupted
bool pulse(Session& session, std::size_t motor, double counts_per_n_mm) {
  if (!session.becomesReady() || !session.rest(kRestMs)) return false;
  const auto before = session.status().encoders;
  const DeviceN force = forceOfMotor(motor, session.status(), counts_per_n_mm);
  bool whole = true;
  for (int i = 0; i < kPulseMs; ++i) whole = session.exchange(force) && whole;
  if (!whole) return false;
  const auto after = session.status().encoders;
  std::printf("%s motor, %.0f counts for %d ms: top %+d, right %+d, left %+d\n", kNames[motor],
              kCounts, kPulseMs, after[0] - before[0], after[1] - before[1], after[2] - before[2]);
  return true;
}

int run(double seconds) {
  const falcon::FalconSettings settings = falcon::readSettings(falcon::settingsFile());
  falcon::FalconDevice device(std::make_unique<falcon::UsbBus>(), falcon::storedFirmwareSource(),
                              settings);
  device.open();
  Session session(device);
  std::puts("Home the Falcon, then leave the grip alone.");
  for (std::size_t motor = 0; motor < kArms; ++motor) {
    constexpr int kMostTries = 20;
    int tries = 0;
    while (!pulse(session, motor, settings.counts_per_n_mm)) {
      if (++tries == kMostTries) throw DeviceError("It was interrupted again and again.");
    }
  }
  for (int quarter = 0; quarter < 4 * seconds; ++quarter) {
    session.rest(250);
    const falcon::LinkStatus& status = session.status();
    std::printf("encoders: top %d, right %d, left %d; hand %.1f %.1f %.1f mm\n", status.encoders[0],
                status.encoders[1], status.encoders[2], status.position.x, status.position.y,
                status.position.z);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc > 1 ? std::stod(argv[1]) : 10);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 6;
  }
}
