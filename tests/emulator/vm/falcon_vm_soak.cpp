// SPDX-License-Identifier: BSD-3-Clause
// The force loop with the emulated Falcon on a kernel with vhci_hcd for a long time, as root:
// tests/emulator/vm/vm.sh BUILD soak MINUTES runs it in a virtual machine. There is no window: a
// thread does what it does to the loop, with new surfaces, settings and presses. Writes a page.
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>

#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/surface_preset.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/plugged.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/realtime/falcon_wire.h"

namespace {

using namespace relievo;  // NOLINT(google-build-using-namespace): a program of one file.
using emulator::SharedFalcon;

struct Deeds {
  int surfaces = 0, settings = 0, presses = 0, forces_off = 0;
};

std::unique_ptr<HapticSpace> relief(std::uint64_t id, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double wave = 2 + 10 * unit(random), high = 0.5 + 3 * unit(random),
               wall = 20 + 40 * unit(random);
  return test::spaceOf(
      80,
      [=](double x, double y) {
        return high * std::sin(x / wave) * std::cos(y / wave) + (x > wall ? 2.0 : 0.0);
      },
      id, {}, SurfaceKind::crease_aware);
}

/// What window and hand do, a step of a fifth of a second.
class Script {
 public:
  Script(HapticLoop& loop, SharedFalcon& falcon) : loop_(loop), falcon_(falcon) { setOptions(); }

  void step() {
    loop_.sayAlive();
    const unsigned n = step_++;
    // The hand goes about over the surface and presses into it, for a second in three it lifts off.
    const double away = n % 15 < 5 ? 30.0 : -10.0;
    if (n % 15 == 5) ++deeds_.presses;
    const double turn = 0.13 * n;
    falcon_.with([&](auto& f) {
      f.body.pullToward({22 * std::cos(turn), 18 * std::sin(1.3 * turn), 125 + away});
    });
    if (n % 11 == 3) {
      loop_.spaces().write(*relief(++id_, random_));
      ++deeds_.surfaces;
    }
    if (n % 17 == 9) {
      ++deeds_.settings;
      setOptions();
    }
    if (n % 150 == 149) {
      ++deeds_.forces_off;
      setOptions(false);
    }
    if (n % 150 == 5) setOptions();
  }
  const Deeds& deeds() const { return deeds_; }

 private:
  void setOptions(bool forces_on = true) {
    HapticOptions options;
    setFeel(options, kSurfacePresets[deeds_.settings % kSurfacePresets.size()].feel);
    options.force.forces_on = forces_on;
    options.force.strength = 0.5 + 0.5 * (deeds_.settings % 2);
    loop_.options().write(options);
  }
  HapticLoop& loop_;
  SharedFalcon& falcon_;
  std::mt19937 random_{14};
  std::uint64_t id_ = 1;
  unsigned step_ = 0;
  Deeds deeds_;
};

template <std::size_t kEdges, std::size_t kBins>
void printBins(const char* what, const std::array<std::int64_t, kEdges>& edges,
               const std::array<std::uint64_t, kBins>& bins) {
  std::printf("   \n| %s | times |\n| --- | ---: |\n", what);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (i < edges.size()) {
      std::printf("| up to %g ms | %llu |\n", 1e-6 * static_cast<double>(edges[i]),
                  static_cast<unsigned long long>(bins[i]));
    } else {
      std::printf("| longer | %llu |\n", static_cast<unsigned long long>(bins[i]));
    }
  }
}

void printPage(const LoopStats& stats, const test::FalconWire& wire, const Deeds& deeds,
               double minutes) {
  const ForceAudit& audit = stats.audit;
  const auto row = [](const char* what, double value) {
    std::printf("| %s | %.10g |\n", what, value);
  };
  std::printf("   \n| minutes | %.1f |\n| --- | ---: |\n", minutes);
  row("ticks", static_cast<double>(stats.ticks));
  row("ticks whose inputs demand zero", static_cast<double>(audit.zero_demanded));
  row("of these, with a force", static_cast<double>(audit.zero_violations));
  row("forces above the limit or not finite", static_cast<double>(audit.limit_violations));
  row("changes above the slew limit", static_cast<double>(audit.step_violations));
  row("largest force, N", audit.largest_n);
  row("largest change in a tick, N", audit.largest_step_n);
  row("late ticks (more than half a period)", static_cast<double>(stats.late_ticks));
  row("pauses over 20 ms, force from zero", static_cast<double>(stats.pauses));
  row("cuts by the watchdog", static_cast<double>(stats.watchdog_cuts));
  row("longest time between ticks, ms", stats.worst_period_ms);
  row("new surfaces", deeds.surfaces);
  row("new settings", deeds.settings);
  row("presses", deeds.presses);
  row("forces switched off", deeds.forces_off);
  row("commands that reached the Falcon", static_cast<double>(wire.commands()));
  row("of these, unreadable", static_cast<double>(wire.badCommands()));
  row("of these, with a force", static_cast<double>(wire.pushing()));
  row("largest force at the grip, N", wire.largestN());
  row("longest time between two commands, ms", wire.longestMs());
  row("times that the force went out in a touch and came back within a second",
      static_cast<double>(wire.forceGaps().size()));
  printBins("wake-up delay", LoopStats::kDelayEdgesNs, stats.delays);
  printBins("from command to command", test::FalconWire::kEdgesNs, wire.gaps());
  std::printf("   \n| force out at | for | commands of zero |\n| ---: | ---: | ---: |\n");
  for (const test::FalconWire::ForceGap& gap : wire.forceGaps()) {
    std::printf("| %.1f s | %.0f ms | %llu |\n", gap.at_s, gap.ms,
                static_cast<unsigned long long>(gap.commands));
  }
  std::fflush(stdout);
}

/// @return  no force went beyond its bounds
bool soak(double minutes) {
  const auto falcon = std::make_shared<SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  falcon->with([](auto& f) { f.body.pullToward({0, 0, 158}); });
  const emulator::Plugged plugged(falcon);
  std::this_thread::sleep_for(std::chrono::seconds(2));  // The kernel looks at its new device.
  auto device = std::make_unique<falcon::FalconDevice>(std::make_unique<falcon::UsbBus>(),
                                                       [] { return test::madeImage(); });
  HapticLoop loop(std::move(device));
  std::mt19937 random(41);
  loop.spaces().write(*relief(1, random));
  Script script(loop, *falcon);
  test::FalconWire wire(falcon);
  loop.start();
  const std::int64_t began = monotonicNs();
  const auto passed = [began] { return 1e-9 * static_cast<double>(monotonicNs() - began) / 60; };
  for (int told = 0; passed() < minutes;) {
    script.step();
    wire.take();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    if (static_cast<int>(passed()) == told) continue;
    told = static_cast<int>(passed());
    loop.stats().update();
    std::printf("   minute %d: %llu ticks, %llu commands with a force, violations %llu\n", told,
                static_cast<unsigned long long>(loop.stats().front().ticks),
                static_cast<unsigned long long>(wire.pushing()),
                static_cast<unsigned long long>(loop.stats().front().audit.violations()));
    std::fflush(stdout);
  }
  loop.stop();
  wire.take();
  loop.stats().update();
  const LoopStats stats = loop.stats().front();
  printPage(stats, wire, script.deeds(), minutes);
  if (wire.pushing() == 0) throw std::runtime_error("no force has reached the Falcon");
  return stats.audit.violations() == 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (!soak(argc > 1 ? std::atof(argv[1]) : 1))
      throw std::runtime_error("a force beyond its bounds");
  } catch (const std::exception& error) {
    std::printf("VM FAILED: %s\n", error.what());
    return 1;
  }
  std::printf("VM PASSED\n");
  return 0;
}
