// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

#include "haptics/device/foreign/device_page.h"
#include "haptics/device/foreign/relievo_device.h"
#include "haptics/device/link/force_ramp.h"
#include "haptics/device/link/heat_budget.h"
#include "haptics/device/link/mailbox.h"

namespace relievo::foreign {

/// One round of a driven device: an order in, a checked force to the plug-in, a checked place out.
/// No clock and no thread of its own. [device thread of the host]
class DeviceRound {
 public:
  /// @param step_since_ns  gets when the step that runs began; 0: none runs. Whoever looks at it
  /// from another thread may do so after this is gone.
  DeviceRound(relievo_device& device, DevicePage& page, const ForeignLimits& limits,
              std::atomic<std::int64_t>& step_since_ns)
      : device_(device),
        page_(page),
        limits_(limits),
        ramp_(rulesOf(limits)),
        heat_(heatRulesOf(limits)),
        step_since_ns_(step_since_ns) {}

  /// @param zero  relievo is gone or lets go: zero force
  void go(std::int64_t now_ns, bool zero) RELIEVO_REALTIME;
  /// The guard cut the force while a step was overdue: what is known is old.
  void wasCut(std::int64_t now_ns) RELIEVO_REALTIME;
  /// The device is gone for good: it is not asked any more.
  bool gone() const RELIEVO_REALTIME { return gone_; }

 private:
  void take(relievo_status status, const relievo_sample& sample,
            std::int64_t now_ns) RELIEVO_REALTIME;
  void takeButtons(std::uint32_t buttons) RELIEVO_REALTIME;
  void fail(DeviceFault fault, std::int64_t now_ns) RELIEVO_REALTIME;
  bool isTooHot(double hottest) const RELIEVO_REALTIME;
  bool believed(const relievo_sample& sample, std::int64_t now_ns) const RELIEVO_REALTIME;

  relievo_device& device_;
  DevicePage& page_;
  ForeignLimits limits_;
  ForceRamp ramp_;
  HeatBudget heat_;
  ForceCommand order_;
  LinkReading reading_;
  std::uint32_t held_over_ = ~0U;  // Buttons that were not seen let go yet.
  std::atomic<std::int64_t>& step_since_ns_;
  bool gone_ = false;
};

}  // namespace relievo::foreign
