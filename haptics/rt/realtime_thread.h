// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "haptics/rt/realtime.h"

namespace relievo {

/// Memory that must not be paged out while the loop runs.
struct MemoryRegion {
  const void* data = nullptr;
  std::size_t bytes = 0;
};

/// What the system granted. A refusal is no error: the loop runs, less evenly, and says so.
struct RealtimeGrant {
  bool realtime = false;           ///< SCHED_FIFO, or SCHED_RR from RealtimeKit.
  bool memory_locked = true;       ///< All regions, the stack and the code of the loop.
  std::uint64_t locked_bytes = 0;  ///< Of them.
  std::string note;                ///< What was refused, why, and what helps; empty: nothing was.
};

/// Asks for what a 1 kHz thread needs, for the calling thread: SCHED_FIFO at `fifo_priority`
/// (0: not asked for), from the system and, if it refuses, from RealtimeKit; timer slack of 1 ns,
/// and locked memory: `lock`, then kStackBytes of its stack, then the libraries that it runs in.
/// Not the whole process: a scan of some gigabytes would be locked with it. What cannot be locked
/// is touched once, so that it is there at first. Never throws for a refusal. [the thread itself,
/// before its loop]
RealtimeGrant requestRealtime(int fifo_priority, std::span<const MemoryRegion> lock);

/// Of a loop's stack that is made present before it runs.
inline constexpr std::size_t kStackBytes = std::size_t{256} << 10U;

/// CLOCK_MONOTONIC.
std::int64_t monotonicNs() RELIEVO_REALTIME;

/// Page faults of the calling thread so far, with and without the disk.
std::uint64_t threadPageFaults() RELIEVO_REALTIME;

/// Sleeps until an absolute time, so that lateness does not add up. Returns at once if it is past.
void sleepUntil(std::int64_t monotonic_ns) RELIEVO_REALTIME;

}  // namespace relievo
