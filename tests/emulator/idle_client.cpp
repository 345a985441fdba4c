// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/idle_client.h"

#include <ctime>

#include <memory>

#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/emulator/made_image.h"

namespace relievo::emulator {

namespace {
constexpr std::int64_t kSecond = 1'000'000'000, kLookNs = kSecond / 60;

double processorSeconds() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}
}  // namespace

std::optional<double> idleProcessorShare(bool open, double seconds) {
  falcon::FalconDevice device(std::make_unique<falcon::UsbBus>(), [] { return test::madeImage(); });
  std::int64_t deadline = monotonicNs();
  if (open) {
    device.open();
    const std::int64_t give_up = deadline + 60 * kSecond;
    while (device.status().state != falcon::LinkState::ready) {
      if (monotonicNs() > give_up) return std::nullopt;
      sleepUntil(deadline += kLookNs);
    }
    sleepUntil(deadline += 3 * kSecond);  // Until it rests.
  }
  const double before = processorSeconds();
  const std::int64_t end = deadline + static_cast<std::int64_t>(seconds * kSecond);
  while (deadline < end) {
    device.status();
    sleepUntil(deadline += kLookNs);
  }
  return (processorSeconds() - before) / seconds;
}

}  // namespace relievo::emulator
