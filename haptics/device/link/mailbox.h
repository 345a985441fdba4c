// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "core/base/vec3.h"
#include "haptics/device/device.h"
#include "haptics/rt/realtime.h"
#include "haptics/rt/triple_buffer.h"

namespace relievo {

/// What a device's link, which runs in a thread or a process of its own, tells the loop.
/// [link writes, haptic loop reads]
struct LinkReading {
  DeviceMm position;
  std::uint32_t buttons = 0;
  std::int64_t time_ns = 0;
  /// Grows with every interruption. A force that was made from a reading of an earlier epoch is
  /// not shown any more.
  std::uint32_t epoch = 0;
  std::uint32_t told = 0;  ///< Grows with those that the loop is told.
  DeviceFault fault = DeviceFault::not_ready;
  DeviceFault interruption = DeviceFault::none;  ///< The last one that it is told.

  /// From now on there is this fault, and the loop is told so, however soon it is over.
  void interrupt(DeviceFault why, std::int64_t now_ns) RELIEVO_REALTIME {
    ++epoch;
    ++told;
    interruption = fault = why;
    time_ns = now_ns;
  }
};
static_assert(std::is_trivially_copyable_v<LinkReading>);

/// What the loop tells the link. [haptic loop writes, link reads]
struct ForceCommand {
  DeviceN force;
  std::int64_t time_ns = 0;  ///< 0: nothing was ordered yet.
  std::uint32_t epoch = 0;   ///< Of the reading that it was made from.
  std::uint32_t cuts = 0;    ///< The watchdog's cuts before that reading was taken.
};
static_assert(std::is_trivially_copyable_v<ForceCommand>);

/// Everything that passes between the loop, a link in a thread of this process, and the device's
/// owner. A link in another process has a page of its own that holds the same.
template <class Wish, class Status>
struct LinkMailbox {
  TripleBuffer<LinkReading> readings;
  TripleBuffer<ForceCommand> orders;
  TripleBuffer<Wish> commands;  ///< [owner writes, link reads]
  TripleBuffer<Status> status;  ///< [link writes, owner reads]
  /// The watchdog's so far: an order that was begun before the last one is not shown. Nobody clears
  /// it, so that no order slips in between. [watchdog writes]
  std::atomic<std::uint32_t> cuts{0};
};

/// The loop's end of a link: makes readings for the loop of what the link tells, and orders of what
/// the loop wants felt. [haptic loop]
class LoopEnd {
 public:
  /// Of the newest reading. An interruption that was over before this tick is told all the same:
  /// the force was off.
  /// @param cuts  the watchdog's, looked at before the reading was
  DeviceReading take(std::uint32_t cuts, const LinkReading& newest) RELIEVO_REALTIME {
    cuts_ = cuts;
    epoch_ = newest.epoch;
    DeviceReading reading{newest.position, newest.buttons, newest.time_ns, newest.fault};
    if (newest.told != told_) {
      told_ = newest.told;
      if (reading.fault == DeviceFault::none) reading.fault = newest.interruption;
    }
    return reading;
  }
  /// Of a force that was made from the reading taken last.
  ForceCommand order(DeviceN force, std::int64_t now_ns) const RELIEVO_REALTIME {
    return {force, now_ns, epoch_, cuts_};
  }

 private:
  std::uint32_t cuts_ = 0, epoch_ = 0, told_ = 0;
};

}  // namespace relievo
