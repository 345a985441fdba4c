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
  wanted_.hovering = false;
  targets_.write(wanted_);
}

void MouseDevice::placeAt(DeviceMm target) RELIEVO_REALTIME {
  ++wanted_.jumps;
  moveTo(target);
}

void MouseDevice::hoverAt(DeviceMm target) RELIEVO_REALTIME {
  ++wanted_.hovers;
  wanted_.position = wanted_.hover = target;
  wanted_.hovering = true;
  targets_.write(wanted_);
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
  if (target.hovers != hovers_ || target.hovering) {
    // Also where it is put down already: it touches from that place on.
    hovers_ = target.hovers;
    jumps_ = target.jumps;
    position_ = target.hover;
    return {position_, target.buttons | kHoverBit, now_ns, DeviceFault::none};
  }
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
