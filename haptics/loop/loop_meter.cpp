// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/loop_meter.h"

#include <algorithm>

namespace relievo {

namespace {
template <std::size_t Edges>
void count(std::array<std::uint64_t, Edges + 1>& bins, const std::array<std::int64_t, Edges>& edges,
           std::int64_t ns) RELIEVO_REALTIME {
  std::size_t bin = 0;
  while (bin < Edges && ns > edges[bin]) ++bin;
  ++bins[bin];
}
}  // namespace

bool LoopMeter::wake(std::int64_t deadline_ns, std::int64_t now_ns, std::int64_t period_ns,
                     bool at_rest) RELIEVO_REALTIME {
  const std::int64_t delay = now_ns - deadline_ns;
  count(stats_.delays, LoopStats::kDelayEdgesNs, delay);
  ++stats_.ticks;
  const bool late = delay > period_ns / 2;
  if (late) ++stats_.late_ticks;
  stats_.at_rest = at_rest;
  if (stats_.ticks > 1 && !at_rest) {
    stats_.worst_period_ms =
        std::max(stats_.worst_period_ms, 1e-6 * static_cast<double>(now_ns - last_ns_));
  }
  last_ns_ = now_ns;
  constexpr std::uint64_t kTicksPerRate = 256;
  if (at_rest) {
    mark_ns_ = now_ns;
    ticks_since_mark_ = 0;
  } else if (++ticks_since_mark_ >= kTicksPerRate && now_ns > mark_ns_) {
    stats_.rate_hz =
        1e9 * static_cast<double>(ticks_since_mark_) / static_cast<double>(now_ns - mark_ns_);
    mark_ns_ = now_ns;
    ticks_since_mark_ = 0;
  }
  return late;
}

void LoopMeter::computed(std::int64_t tick_ns) RELIEVO_REALTIME {
  const double us = 1e-3 * static_cast<double>(tick_ns);
  stats_.mean_tick_us += (us - stats_.mean_tick_us) / static_cast<double>(stats_.ticks);
  stats_.worst_tick_us = std::max(stats_.worst_tick_us, us);
  count(stats_.work, LoopStats::kWorkEdgesNs, tick_ns);
}

void LoopMeter::faulted(std::uint64_t so_far) RELIEVO_REALTIME {
  // What came before the first tick's end is the thread's start.
  if (stats_.ticks > 1 && so_far != faults_before_) {
    stats_.page_faults += so_far - faults_before_;
    ++stats_.faulty_ticks;
  }
  faults_before_ = so_far;
}

void LoopMeter::note(const ForceAudit& audit, std::uint64_t watchdog_cuts) RELIEVO_REALTIME {
  stats_.audit = audit;
  stats_.watchdog_cuts = watchdog_cuts;
}

}  // namespace relievo
