// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>

#include "haptics/device/device.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Cuts the force when the loop alone stalls: a thread that looks at the loop's heartbeat
/// when it would be too old, and every 2 ms while there is none or it is. While the whole computer
/// stands still nobody can send anything; then the loop's own first force is zero.
class Watchdog {
 public:
  static constexpr std::int64_t kLookNs = 2'000'000;
  /// A heartbeat older than this is a stall: with one look it is recognised within 20 ms.
  static constexpr std::int64_t kStallNs = 16'000'000;

  /// kLookNs before the next look, after one at `now_ns` that saw this heartbeat (0: none). Before
  /// a heartbeat can be too old there is nothing to see, and a newer one moves the look on. A look
  /// that came late says nothing about the loop; the next one follows at once, because a sleep
  /// before it could be late again.
  static constexpr std::int64_t lookAfter(std::int64_t now_ns, bool came_late,
                                          std::int64_t beat_ns) noexcept {
    if (came_late) return now_ns - kLookNs;
    return beat_ns == 0 ? now_ns : std::max(now_ns, beat_ns + kStallNs + 1 - kLookNs);
  }

  /// @param fifo_priority  the loop's, or 0: its own is one above, so that a loop that spins cannot
  ///                       keep it from running; a refusal is the loop's to tell
  Watchdog(Device& device, int fifo_priority);
  ~Watchdog();  ///< Joins; its thread may sleep for kStallNs.
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// [haptic loop] Once per tick, before the hand is read.
  /// @return the force was cut since the last beat
  bool beat(std::int64_t now_ns) RELIEVO_REALTIME;
  /// [haptic loop] No more beats are to come.
  void rest() RELIEVO_REALTIME { beat_ns_.store(0, std::memory_order_release); }
  std::uint64_t cuts() const RELIEVO_REALTIME { return cuts_.load(std::memory_order_relaxed); }

 private:
  void watch(int fifo_priority);

  Device& device_;
  std::atomic<bool> stopping_{false};
  std::atomic<std::int64_t> beat_ns_{0};  // 0: nothing to watch.
  std::atomic<bool> cut_{false};          // Since the last beat.
  std::atomic<std::uint64_t> cuts_{0};
  std::thread thread_;
};

}  // namespace relievo
