// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "haptics/force/force_audit.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// How evenly the loop runs. Since start(), but for rate_hz and at_rest.
struct LoopStats {
  /// Upper edges of the bins of wake-up delays, in ns.
  static constexpr std::array<std::int64_t, 9> kDelayEdgesNs{
      20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000, 5'000'000, 20'000'000, 100'000'000};
  /// Upper edges of the bins of work times, in ns.
  static constexpr std::array<std::int64_t, 9> kWorkEdgesNs{
      500, 1'000, 2'000, 5'000, 10'000, 20'000, 50'000, 200'000, 1'000'000};

  std::uint64_t ticks = 0;
  std::uint64_t late_ticks = 0;                ///< Woke more than half a period late.
  std::uint64_t pauses = 0;                    ///< Times that the force had to start from zero.
  std::uint64_t watchdog_cuts = 0;             ///< Times that the watchdog sent zero.
  std::uint64_t page_faults = 0;               ///< Of the loop's thread, since its first tick ...
  std::uint64_t faulty_ticks = 0;              ///< ... and in how many ticks they were.
  double rate_hz = 0;                          ///< Over the last quarter second or so, rest apart.
  double mean_tick_us = 0, worst_tick_us = 0;  ///< Time spent computing, without the device.
  double worst_period_ms = 0;                  ///< Longest time from tick to tick, rest apart.
  std::array<std::uint64_t, kDelayEdgesNs.size() + 1> delays{};
  std::array<std::uint64_t, kWorkEdgesNs.size() + 1> work{};
  bool at_rest = false;  ///< Its ticks are kRestPeriodNs apart: HapticLoop::rest().
  ForceAudit audit;
};
static_assert(std::is_trivially_copyable_v<LoopStats>);

/// Counts how evenly the ticks come. [haptic loop]
class LoopMeter {
 public:
  void begin(std::int64_t now_ns) RELIEVO_REALTIME { last_ns_ = mark_ns_ = now_ns; }
  /// @param at_rest  the period before this tick was one of rest: it is no measure of the rate
  /// @return this tick is late
  bool wake(std::int64_t deadline_ns, std::int64_t now_ns, std::int64_t period_ns,
            bool at_rest = false) RELIEVO_REALTIME;
  void computed(std::int64_t tick_ns) RELIEVO_REALTIME;
  void paused() RELIEVO_REALTIME { ++stats_.pauses; }
  /// @param so_far  threadPageFaults() at the end of a tick
  void faulted(std::uint64_t so_far) RELIEVO_REALTIME;
  void note(const ForceAudit& audit, std::uint64_t watchdog_cuts) RELIEVO_REALTIME;
  const LoopStats& stats() const RELIEVO_REALTIME { return stats_; }

 private:
  LoopStats stats_;
  std::int64_t last_ns_ = 0, mark_ns_ = 0;
  std::uint64_t ticks_since_mark_ = 0;
  std::uint64_t faults_before_ = 0;  // Of the thread, up to the end of the last tick.
};

}  // namespace relievo
