// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/page_end.h"

#include <algorithm>
#include <cmath>

namespace relievo::foreign {

namespace {
constexpr std::uint32_t kAllButtons = 0b1111;

/// A spring of this device stays passive: K <= b / (T/2 + delay), with the damping of a hand.
double passiveStiffness(const ForeignLimits& limits) {
  constexpr double kDampingNsPerMm = 0.0015, kTickS = 0.001, kOrderWaitsS = 0.001;
  const double delay_s = kOrderWaitsS + 1e-3 * limits.force_delay_ms;
  return kDampingNsPerMm / (kTickS / 2 + delay_s);
}
}  // namespace

bool PageEnd::believes(const LinkReading& told) const RELIEVO_REALTIME {
  return isFinite(told.position) && std::abs(told.position.x) <= 2 * reach_.x &&
         std::abs(told.position.y) <= 2 * reach_.y && std::abs(told.position.z) <= 2 * reach_.z &&
         told.fault <= DeviceFault::not_ready && told.interruption <= DeviceFault::not_ready;
}

DeviceReading PageEnd::read(const DevicePage& page, std::int64_t now_ns) RELIEVO_REALTIME {
  const std::uint32_t cuts = page.cuts.load(std::memory_order_acquire);  // First: see LoopEnd.
  LinkReading told;
  if (page.reading.read(told)) {
    if (believes(told)) {
      newest_ = told;
    } else {
      newest_.fault = DeviceFault::protocol;
    }
  }
  DeviceReading reading = loop_end_.take(cuts, newest_);
  reading.buttons &= kAllButtons;
  // It was measured before this tick, or between its begin and now.
  reading.time_ns = std::min(reading.time_ns, now_ns);
  if (reading.fault == DeviceFault::none && reading.time_ns < now_ns - stale_place_ns_) {
    reading.fault = DeviceFault::timeout;
  }
  return reading;
}

void takeLimits(const ForeignLimits& limits, DeviceInfo& info) {
  constexpr double kUnknownStiffness = 0.4;
  const double stated =
      limits.max_stiffness_n_per_mm > 0 ? limits.max_stiffness_n_per_mm : kUnknownStiffness;
  info.workspace.half_extent = {limits.half_extent_mm[0], limits.half_extent_mm[1],
                                limits.half_extent_mm[2]};
  info.max_force_n = rulesOf(limits).max_force_n;
  info.max_stiffness_n_per_mm =
      limits.force_delay_ms > 1 ? std::min(stated, passiveStiffness(limits)) : stated;
  // As the Falcon's, until somebody has measured another.
  info.max_damping_n_s_per_mm = 0.006;
  info.max_slew_n_per_s = 200;
  info.position_step_mm = limits.position_step_mm;
  info.force_delay_ticks = 2;  // Up to one until the host takes it, one until the motors show it.
  info.rate_hz = limits.rate_hz;
}

std::optional<HeatReport> heatOf(const DevicePage& page, double most_n) {
  HeatReport told;
  if (!page.heat.read(told)) return std::nullopt;
  if (!std::isfinite(told.used) || !std::isfinite(told.allowed_n)) return std::nullopt;
  return HeatReport{std::clamp(told.used, 0.0, 1.0), std::clamp(told.allowed_n, 0.0, most_n)};
}

}  // namespace relievo::foreign
