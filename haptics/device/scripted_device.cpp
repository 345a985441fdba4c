// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/scripted_device.h"

#include <utility>

#include "core/base/failure.h"

namespace relievo {

ScriptedDevice::ScriptedDevice(std::vector<DeviceReading> readings, double max_force_n)
    : readings_(std::move(readings)) {
  if (readings_.empty()) throw failure<MessageId::script_without_readings>();
  info_.id = "scripted";
  info_.name = "scripted stroke";
  info_.max_force_n = max_force_n;
  info_.simulated = true;
}

DeviceReading ScriptedDevice::read(std::int64_t now_ns) RELIEVO_REALTIME {
  DeviceReading reading = readings_[next_];
  if (next_ + 1 < readings_.size()) ++next_;
  reading.time_ns = now_ns - reading.time_ns;
  return reading;
}

}  // namespace relievo
