// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/vec3.h"
#include "haptics/device/link/mailbox.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Limits that hold whatever the loop asks for.
struct ForceRules {
  double max_force_n = 5;
  double rise_n_per_s = 50;                  ///< During the first 200 ms after every interruption.
  std::int64_t stale_order_ns = 20'000'000;  ///< An older force counts as zero: the loop hangs.
};

/// The link's last word on every force: which orders are shown, and how strongly. [link]
class ForceRamp {
 public:
  explicit ForceRamp(const ForceRules& rules = {}) : rules_(rules) {}

  /// The force was off, or may not be trusted: it rises anew, from zero, from now on.
  void shut(std::int64_t now_ns) RELIEVO_REALTIME { shut_ns_ = now_ns; }

  /// What of an order is shown now: at most the largest force, and while it rises less.
  /// @param cuts, epoch  as they are now
  /// @return nothing: the order is stale, was made before an interruption or a cut, or is no
  /// number; then it is shut
  std::optional<DeviceN> shown(const ForceCommand& order, std::uint32_t cuts, std::uint32_t epoch,
                               std::int64_t now_ns) RELIEVO_REALTIME;

 private:
  ForceRules rules_;
  std::int64_t shut_ns_ = 0;
};

}  // namespace relievo
