// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/device/device.h"
#include "haptics/device/foreign/device_page.h"
#include "haptics/device/link/mailbox.h"
#include "haptics/rt/realtime.h"

namespace relievo::foreign {

/// relievo's end of the page: whatever the other process writes there, what comes out is a place
/// that the device can have, or a fault. [haptic loop]
class PageEnd {
 public:
  PageEnd() = default;
  /// @param reach  half of the device's box
  /// @param stale_place_ns  an older place is a timeout
  PageEnd(DeviceMm reach, std::int64_t stale_place_ns)
      : reach_(reach), stale_place_ns_(stale_place_ns) {}

  DeviceReading read(const DevicePage& page, std::int64_t now_ns) RELIEVO_REALTIME;
  void send(DevicePage& page, DeviceN force, std::int64_t now_ns) const RELIEVO_REALTIME {
    page.order.write(loop_end_.order(force, now_ns));
  }

 private:
  bool believes(const LinkReading& told) const RELIEVO_REALTIME;

  DeviceMm reach_;
  std::int64_t stale_place_ns_ = 0;
  LoopEnd loop_end_;
  LinkReading newest_;
};

/// What relievo asks of a device with these limits. @pre arePossible(limits)
void takeLimits(const ForeignLimits& limits, DeviceInfo& info);
/// Nothing: the host has told none, or nonsense. @param most_n  the device's largest force
std::optional<HeatReport> heatOf(const DevicePage& page, double most_n);

}  // namespace relievo::foreign
