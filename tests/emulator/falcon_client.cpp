// SPDX-License-Identifier: BSD-3-Clause
// A program that touches and then ends in one of many ways; see usb_test.
// falcon_client FORCE_N ANSWERS ENDING: asks for FORCE_N outward until a Falcon that is ready has
// answered so often.
#include <sched.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/realtime_thread.h"
#include "haptics/rt/rtkit.h"

namespace {

constexpr int kNoPriority = 77;  // Exit code: the system refuses real-time priority.

/// Calls itself until the stack ends.
int deeper(volatile int* above) {
  std::array<volatile int, 1000> here;  // NOLINT(*-member-init): only its room matters.
  here[0] = *above + 1;
  if (here[0] < 0) return 0;  // Never.
  return deeper(here.data()) + here[0];
}

/// A loop that hangs, with the priority and the limit that RealtimeKit gives.
int spin() {
  sched_param parameters{};
  parameters.sched_priority = 5;
  if (sched_setscheduler(0, SCHED_RR, &parameters) != 0) return kNoPriority;
  if (!relievo::limitRealtimeWork()) return kNoPriority;
  const std::int64_t give_up = relievo::monotonicNs() + 60'000'000'000;
  while (relievo::monotonicNs() < give_up) {
  }
  return 0;
}

int endAs(const std::string& ending) {
  volatile int bottom = 0;
  if (ending == "normal") return 0;
  if (ending == "exit") std::exit(0);  // Without destructors of what lives on the stack.
  if (ending == "abort") std::abort();
  if (ending == "throw") throw relievo::Error("nobody catches this");
  if (ending == "spin") return spin();
  if (ending == "overflow") return deeper(&bottom);
  if (ending == "overflow of a loop") {
    std::thread([&bottom] {
      relievo::requestRealtime(0, {});
      deeper(&bottom);
    }).join();
  }
  std::raise(std::stoi(ending));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 1;
  const double force_n = std::stod(argv[1]);
  const int answers = std::stoi(argv[2]);
  relievo::falcon::FalconDevice device(std::make_unique<relievo::falcon::UsbBus>(),
                                       relievo::falcon::firmwareSource());
  try {
    device.open();
  } catch (const relievo::DeviceError& error) {
    std::cerr << error.what() << '\n';
    return 6;
  }
  constexpr std::int64_t kMs = 1'000'000;
  const std::int64_t give_up = relievo::monotonicNs() + 120'000 * kMs;
  std::int64_t answered_ns = 0;
  for (int ready = 0; ready < answers;) {
    // Never to make up for what was missed: it is answers that count.
    relievo::sleepUntil(relievo::monotonicNs() + kMs);
    const auto reading = device.exchange({0, 0, force_n}, relievo::monotonicNs());
    const bool is_new = std::exchange(answered_ns, reading.time_ns) != reading.time_ns;
    if (is_new && reading.fault == relievo::DeviceFault::none) ++ready;
    if (relievo::monotonicNs() > give_up) return 2;
  }
  return endAs(argv[3]);
}
