// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/host/device_round.h"

#include <array>
#include <cmath>

#include "haptics/device/foreign/host/loaded_plugin.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::foreign {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::uint32_t kAllButtons = 0b1111;

DeviceFault faultOf(relievo_status status) RELIEVO_REALTIME {
  switch (status) {
    case RELIEVO_TIMEOUT:
      return DeviceFault::timeout;
    case RELIEVO_DISCONNECTED:
      return DeviceFault::disconnected;
    case RELIEVO_OVERHEATED:
      return DeviceFault::overheated;
    case RELIEVO_NOT_READY:
    case RELIEVO_FORCE_OFF:
      return DeviceFault::not_ready;
    default:
      return DeviceFault::protocol;
  }
}

/// It answers, though it shows no force.
bool answers(relievo_status status) RELIEVO_REALTIME {
  return status == RELIEVO_NOT_READY || status == RELIEVO_FORCE_OFF || status == RELIEVO_OVERHEATED;
}
}  // namespace

void DeviceRound::go(std::int64_t now_ns, bool zero) RELIEVO_REALTIME {
  page_.order.read(order_);
  const bool may_push = !zero && reading_.fault == DeviceFault::none;
  DeviceN force;
  if (may_push) {
    const std::uint32_t cuts = page_.cuts.load(std::memory_order_acquire);
    force = ramp_.shown(order_, cuts, reading_.epoch, now_ns).value_or(DeviceN{});
  } else {
    ramp_.shut(now_ns);
  }
  if (gone_) return;
  force = heat_.shown(force, now_ns);
  page_.heat.write({heat_.used(), heat_.allowedN()});
  const std::array<double, 3> force_n{force.x, force.y, force.z};
  relievo_sample sample{};
  sample.struct_size = sizeof(sample);
  step_since_ns_.store(now_ns, std::memory_order_release);
  const relievo_status status = called(relievo_status{RELIEVO_INTERNAL}, device_.step, device_.self,
                                       force_n.data(), now_ns, &sample);
  step_since_ns_.store(0, std::memory_order_release);
  take(status, sample, monotonicNs());
  page_.reading.write(reading_);
}

void DeviceRound::take(relievo_status status, const relievo_sample& sample,
                       std::int64_t now_ns) RELIEVO_REALTIME {
  if (status == RELIEVO_NO_NEWS) return;
  if (status < 0) {
    gone_ = status == RELIEVO_DISCONNECTED;
    // A button that is held is how a hand asks for its force back.
    if (answers(status)) takeButtons(sample.buttons);
    return fail(faultOf(status), now_ns);
  }
  if (!believed(sample, now_ns)) return fail(DeviceFault::protocol, now_ns);
  takeButtons(sample.buttons);
  heat_.measured(sample.hottest_motor);
  if (isTooHot(sample.hottest_motor)) return fail(DeviceFault::overheated, now_ns);
  reading_.position = {sample.position_mm[0], sample.position_mm[1], sample.position_mm[2]};
  reading_.time_ns = sample.time_ns;
  reading_.fault = DeviceFault::none;
}

/// One that is down when the device is opened was pressed before: it counts once it was let go.
void DeviceRound::takeButtons(std::uint32_t buttons) RELIEVO_REALTIME {
  held_over_ &= buttons;
  reading_.buttons = buttons & ~held_over_ & kAllButtons;
}

void DeviceRound::fail(DeviceFault fault, std::int64_t now_ns) RELIEVO_REALTIME {
  ramp_.shut(now_ns);
  if (reading_.fault != fault) reading_.interrupt(fault, now_ns);
}

void DeviceRound::wasCut(std::int64_t now_ns) RELIEVO_REALTIME {
  ramp_.shut(now_ns);
  // What the step said itself is worth more than that it took long.
  if (reading_.fault == DeviceFault::none) reading_.interrupt(DeviceFault::timeout, now_ns);
}

/// From its limit until it is clearly below it.
bool DeviceRound::isTooHot(double hottest) const RELIEVO_REALTIME {
  constexpr double kCooled = 0.9;
  return hottest >= (reading_.fault == DeviceFault::overheated ? kCooled : 1.0);
}

/// A number, within twice the reach, measured lately and not in the future.
bool DeviceRound::believed(const relievo_sample& sample,
                           std::int64_t now_ns) const RELIEVO_REALTIME {
  constexpr std::int64_t kMostAgeNs = 20 * kMs;
  for (std::size_t i = 0; i < 3; ++i) {
    const double place = sample.position_mm[i];
    if (!std::isfinite(place) || std::abs(place) > 2 * limits_.half_extent_mm[i]) return false;
  }
  return std::isfinite(sample.hottest_motor) && sample.time_ns <= now_ns &&
         sample.time_ns >= now_ns - kMostAgeNs;
}

}  // namespace relievo::foreign
