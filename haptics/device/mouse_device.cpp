// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/mouse_device.h"

#include <cmath>

namespace relievo {

MouseDevice::MouseDevice() {
  info_.id = "mouse";
  info_.name = "mouse";
}

void MouseDevice::moveTo(DeviceMm target) RELIEVO_REALTIME {
  wanted_.position = target;
  targets_.write(wanted_);
}

void MouseDevice::placeAt(DeviceMm target) RELIEVO_REALTIME {
  ++wanted_.jumps;
  moveTo(target);
}

void MouseDevice::setButtons(std::uint32_t buttons) RELIEVO_REALTIME {
  wanted_.buttons = buttons;
  targets_.write(wanted_);
}

DeviceReading MouseDevice::read(std::int64_t now_ns) RELIEVO_REALTIME {
  targets_.update();
  const HandWish& target = targets_.front();
  const double dt_s = 1e-9 * static_cast<double>(now_ns - last_ns_);
  last_ns_ = now_ns;
  if (target.jumps != jumps_ || !isFinite(position_) || !isFinite(target.position)) {
    jumps_ = target.jumps;
    position_ = target.position;
  } else if (dt_s > 0) {
    // Exact for any dt, so that a late tick arrives where the on-time ticks would have.
    position_ = position_ - std::expm1(-dt_s / kFollowSeconds) * (target.position - position_);
  }
  return {position_, target.buttons, now_ns, DeviceFault::none};
}

}  // namespace relievo
