// SPDX-License-Identifier: BSD-3-Clause
// From the moment at which the Falcon takes a place to the moment at which the force that was made
// from it reaches the Falcon. The loop as it is, and one that sends the force of the tick before,
// in one run; the emulated Falcon has the clock, and both of the loop's threads are real.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "haptics/device/falcon/falcon_device.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/emulator/in_process.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

/// Shows a force one tick late, as a loop that talks to the device once per tick does.
class LateDevice : public falcon::FalconDevice {
 public:
  using FalconDevice::FalconDevice;
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override {
    const DeviceReading reading = FalconDevice::read(now_ns);
    FalconDevice::send(waiting_, now_ns);
    return reading;
  }
  void send(DeviceN force, std::int64_t /*now_ns*/) RELIEVO_REALTIME override { waiting_ = force; }

 private:
  DeviceN waiting_;
};

struct Latency {
  double median_ms = 0, most_of_1000_ms = 0;
  std::size_t commands = 0;
};

/// The grip is carried down and up below a flat surface; how hard a command pushes tells which
/// place it was made from.
template <class Falcon>
Latency measured(int seconds) {
  constexpr double kNominalGain = 10;  // Also the emulated motors'.
  constexpr double kNPerMm = 0.5, kSlopeMmPerS = 40, kTopMm = -1, kWayMm = 4;
  const auto emulated = std::make_shared<emulator::SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  const auto clock = std::make_shared<emulator::TestClock>(emulator::TestClock::Kind::real);
  falcon::FalconSettings settings;
  settings.counts_per_n_mm = kNominalGain;
  auto device = std::make_unique<Falcon>(
      std::make_unique<emulator::InProcessBus>(emulated, clock),
      [] { return std::vector<std::uint8_t>(); }, settings);
  device->openWhenPlugged();
  const auto space = test::spaceOf(80, [](double, double) { return 0.0; });
  const double plane_mm = space->deviceFromView({40, 40, 0}).z;
  const auto placeAt = [plane_mm](double t_s) {
    const double phase = t_s * kSlopeMmPerS / kWayMm;
    const double part = std::abs(phase - 2 * std::floor(phase / 2 + 0.5));  // 0 .. 1 .. 0
    return plane_mm + kTopMm - kWayMm * part;
  };
  HapticLoop loop(std::move(device), {.settling_exchanges = 2000});
  HapticOptions options;
  options.force.forces_on = true;
  options.force.strength = 1;
  options.force.rise_s = 0.05;
  options.force.passivity.on = options.force.oscillation.on = false;
  options.stiffness_by_detail = false;
  options.force.stiffness_n_per_mm = kNPerMm;
  const auto carry = [&](double z) {
    emulated->with([z](auto& f) { f.body.hold({0, 0, falcon::kCentre.z + z}); });
  };
  carry(plane_mm + 2);
  loop.spaces().write(*space);
  loop.options().write(options);
  loop.start();
  sleepUntil(monotonicNs() + 600'000'000);
  emulated->with([](auto& f) { f.forgetCommands(); });
  struct Place {
    std::int64_t time_ns;
    double z;
  };
  std::vector<Place> places;
  const std::int64_t start_ns = monotonicNs();
  for (std::int64_t now = start_ns; now < start_ns + seconds * 1'000'000'000LL;) {
    const double z = placeAt(1e-9 * static_cast<double>(now - start_ns));
    carry(z);
    places.push_back({monotonicNs(), z});
    sleepUntil(now += 100'000);
  }
  const auto commands = emulated->with([](auto& f) { return f.commands(); });
  loop.stop();
  // A command's force says how deep the hand was; the last time before it at which it was so deep
  // on the way of that direction is when the place was taken.
  std::vector<double> latencies;
  std::size_t at = 0;
  for (const emulator::SeenCommand& command : commands) {
    if (command.neutral() || command.time_ns < start_ns + 300'000'000) continue;
    emulator::FalconBody body;
    while (at + 1 < places.size() && places[at + 1].time_ns <= command.time_ns) ++at;
    body.hold({0, 0, falcon::kCentre.z + places[at].z});
    body.drive(command.motors);
    const double depth_mm = body.force()[2] / kNPerMm;
    // Only where the way goes one way for long enough.
    std::size_t back = at;
    while (back > 0 && std::abs(plane_mm - places[back].z - depth_mm) > 0.03 && at - back < 100) {
      --back;
    }
    if (at - back < 100) {
      latencies.push_back(1e-6 * static_cast<double>(command.time_ns - places[back].time_ns));
    }
  }
  if (latencies.empty()) return {};
  std::sort(latencies.begin(), latencies.end());
  return {latencies[latencies.size() / 2], latencies[latencies.size() * 999 / 1000],
          latencies.size()};
}
}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  const int seconds = argc > 1 ? std::atoi(argv[1]) : 5;
  const auto print = [](const char* name, const relievo::Latency& l) {
    std::printf("%-34s median %.2f ms, 99.9 %% %.2f ms, %zu commands\n", name, l.median_ms,
                l.most_of_1000_ms, l.commands);
  };
  const relievo::Latency late = relievo::measured<relievo::LateDevice>(seconds);
  const relievo::Latency now = relievo::measured<relievo::falcon::FalconDevice>(seconds);
  print("sent with the next reading", late);
  print("read, compute, send", now);
  std::printf("ratio of medians %.2f\n", now.median_ms / late.median_ms);
  return 0;
}
