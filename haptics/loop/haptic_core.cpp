// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/haptic_core.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
// A hand a thousand kilometres away is a broken reading, and its square must stay a number.
constexpr double kFarthestHandMm = 1e9;

bool isPlace(DeviceMm p) RELIEVO_REALTIME {
  return isFinite(p) && std::abs(p.x) <= kFarthestHandMm && std::abs(p.y) <= kFarthestHandMm &&
         std::abs(p.z) <= kFarthestHandMm;
}
}  // namespace

void HapticCore::reset() RELIEVO_REALTIME {
  placed_ = false;
  places_seen_ = 0;
  force_ = {};
  fault_ = DeviceFault::none;
}

DeviceFault HapticCore::latch(const HapticOptions& options,
                              const DeviceReading& reading) RELIEVO_REALTIME {
  if (!options.force.forces_on) fault_ = DeviceFault::none;
  if (reading.fault != DeviceFault::none) {
    fault_ = reading.fault;
  } else if (!isPlace(reading.position)) {
    fault_ = DeviceFault::not_finite;
  } else {
    hip_ = reading.position;
  }
  return fault_;
}

void HapticCore::measureSpeed(std::int64_t now_ns, ForceInput& input) RELIEVO_REALTIME {
  if (places_seen_ > 0) {
    const std::uint64_t back = std::min(places_seen_, kSpeedTicks);
    const HandPlace& oldest = places_[(places_seen_ - back) % kSpeedTicks];
    const double seconds = 1e-9 * static_cast<double>(now_ns - oldest.time_ns);
    // Fewer than 8 ticks count as 8: the first steps of a hand are too coarse for a speed.
    const double least = 1e-3 * static_cast<double>(kSpeedTicks);
    input.velocity = (1 / std::max(seconds, least)) * (hip_ - oldest.position);
    input.moved = hip_ - places_[(places_seen_ - 1) % kSpeedTicks].position;
  }
  places_[places_seen_ % kSpeedTicks] = {hip_, now_ns};
  ++places_seen_;
}

void HapticCore::follow(const HapticSpace& space, const HapticOptions& options) RELIEVO_REALTIME {
  const GridPoint hip = space.gridFromDevice(hip_);
  if (placed_ && space.window_id == window_id_) {
    proxy_ = proxyTick(space, proxy_, hip, options.proxy);
    return;
  }
  proxy_ = proxyPlace(space, hip);
  force_ = refade(force_);
  window_id_ = space.window_id;
  placed_ = true;
}

HapticSample HapticCore::describeTick(const HapticSpace& space) const RELIEVO_REALTIME {
  HapticSample sample;
  sample.window_id = space.window_id;
  sample.detail = space.detail;
  sample.hip = hip_;
  sample.hip_view = space.viewFromDevice(hip_);
  sample.contact = proxy_.contact;
  if (proxy_.position == proxy_.hip) {  // Free: the same place, to the last bit.
    sample.proxy = sample.hip;
    sample.proxy_view = sample.hip_view;
  } else {
    sample.proxy_view = space.viewFromGrid(proxy_.position);
    sample.proxy = space.deviceFromView(sample.proxy_view);
  }
  sample.normal = proxyNormal(space, proxy_);
  sample.origin = space.originAt(proxy_.position);
  return sample;
}

HapticSample HapticCore::tick(const HapticSpace& space, const HapticOptions& options,
                              const DeviceReading& reading, std::int64_t now_ns) RELIEVO_REALTIME {
  const DeviceFault fault = latch(options, reading);
  follow(space, options);

  HapticSample sample = describeTick(space);
  sample.tick = tick_++;
  sample.time_ns = now_ns;
  sample.buttons = reading.buttons;
  sample.fault = fault;

  ForceOptions force_options = options.force;
  if (options.stiffness_by_detail) {
    force_options.stiffness_n_per_mm = stiffnessForDetail(space.detail);
  }
  ForceInput input;
  input.proxy = sample.proxy;
  input.hip = sample.hip;
  input.normal = {sample.normal.x, sample.normal.y, sample.normal.z};
  measureSpeed(now_ns, input);
  input.contact = sample.contact;
  input.fault = fault != DeviceFault::none;
  input.age_s = 1e-9 * static_cast<double>(now_ns - reading.time_ns);
  const ForceResult result = force(force_options, input, force_);
  force_ = result.state;
  sample.force = result.force;
  sample.f_cmd_n = result.command_n;
  sample.clamped = result.limited;
  sample.limit_n = result.limit_n;
  sample.stiffness_n_per_mm = force_options.stiffness_n_per_mm;
  sample.engaged = force_.phase;
  return sample;
}

}  // namespace relievo
