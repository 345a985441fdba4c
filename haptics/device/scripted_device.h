// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "haptics/device/device.h"

namespace relievo {

/// Plays a list of readings, one per tick, and stays at the last; for strokes and tests.
/// A reading's time_ns is taken as an offset back from the tick: 0 is fresh, 5'000'000 is 5 ms old.
class ScriptedDevice : public Device {
 public:
  /// @throw ArgumentError  no readings
  explicit ScriptedDevice(std::vector<DeviceReading> readings, double max_force_n = 0);
  const DeviceInfo& info() const noexcept override { return info_; }
  void open() override { next_ = 0; }
  void close() noexcept override {}
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override;
  void send(DeviceN force, std::int64_t /*now_ns*/) RELIEVO_REALTIME override {
    last_force_ = force;
  }

  DeviceN lastForce() const noexcept { return last_force_; }  ///< Shown last. [loop stopped]

 private:
  DeviceInfo info_;
  std::vector<DeviceReading> readings_;
  std::size_t next_ = 0;  // [haptic loop]
  DeviceN last_force_;    // [haptic loop]
};

}  // namespace relievo
