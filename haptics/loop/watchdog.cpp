// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/watchdog.h"

#include <algorithm>

#include "haptics/rt/realtime_thread.h"

namespace relievo {

Watchdog::Watchdog(Device& device, int fifo_priority)
    : device_(device), thread_([this, fifo_priority] { watch(fifo_priority); }) {}

Watchdog::~Watchdog() {
  stopping_.store(true, std::memory_order_release);
  thread_.join();
}

bool Watchdog::beat(std::int64_t now_ns) RELIEVO_REALTIME {
  beat_ns_.store(now_ns, std::memory_order_release);
  return cut_.exchange(false, std::memory_order_acq_rel);
}

void Watchdog::watch(int fifo_priority) {
  [[maybe_unused]] const RealtimeGrant grant =
      requestRealtime(fifo_priority > 0 ? fifo_priority + 1 : 0, {});
  std::int64_t cut_at = 0;  // The heartbeat that a cut was made for: one cut per stall.
  std::int64_t look_ns = monotonicNs();
  while (!stopping_.load(std::memory_order_acquire)) {
    look_ns += kLookNs;
    sleepUntil(look_ns);
    const std::int64_t now_ns = monotonicNs();
    const std::int64_t beat_ns = beat_ns_.load(std::memory_order_acquire);
    // A look that comes late itself says nothing about the loop: it gets one look's time to beat.
    const bool awake = now_ns - look_ns < kLookNs;
    if (awake && beat_ns != 0 && beat_ns != cut_at && now_ns - beat_ns > kStallNs) {
      cut_at = beat_ns;
      // Told first: whatever the device then does, the loop starts from zero.
      cut_.store(true, std::memory_order_release);
      cuts_.fetch_add(1, std::memory_order_relaxed);
      device_.cutForce();
    }
    look_ns = lookAfter(now_ns, !awake, beat_ns);
  }
}

}  // namespace relievo
