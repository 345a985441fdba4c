// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/device.h"

namespace relievo {

std::string_view describe(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::none:
      return "no fault";
    case DeviceFault::timeout:
      return "the device did not answer in time";
    case DeviceFault::disconnected:
      return "the device was unplugged";
    case DeviceFault::protocol:
      return "the device sent something unreadable";
    case DeviceFault::overheated:
      return "the device is too hot";
    case DeviceFault::not_finite:
      return "the device reported an impossible position";
    case DeviceFault::not_ready:
      return "the device is not ready yet";
  }
  return "unknown fault";
}

}  // namespace relievo
