// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/link/force_ramp.h"

#include <algorithm>

namespace relievo {

std::optional<DeviceN> ForceRamp::shown(const ForceCommand& order, std::uint32_t cuts,
                                        std::uint32_t epoch, std::int64_t now_ns) RELIEVO_REALTIME {
  // An order is made before it is seen; its clock is the same.
  constexpr std::int64_t kAheadNs = 5'000'000;
  const bool fresh = order.cuts == cuts && order.epoch == epoch && order.time_ns != 0 &&
                     order.time_ns <= now_ns + kAheadNs &&
                     order.time_ns >= now_ns - rules_.stale_order_ns;
  if (!fresh || !isFinite(order.force)) {
    shut(now_ns);
    return std::nullopt;
  }
  const double asked_n = norm(order.force);
  if (asked_n == 0) return DeviceN{};
  constexpr std::int64_t kRiseNs = 200'000'000;
  double allowed_n = rules_.max_force_n;
  if (now_ns - shut_ns_ < kRiseNs) {
    const double since_s = 1e-9 * static_cast<double>(now_ns - shut_ns_);
    allowed_n = std::min(allowed_n, rules_.rise_n_per_s * since_s);
  }
  return std::min(1.0, allowed_n / asked_n) * order.force;
}

}  // namespace relievo
