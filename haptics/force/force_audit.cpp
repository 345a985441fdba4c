// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/force_audit.h"

#include <algorithm>

namespace relievo {

ForceAudit audited(ForceAudit audit, const ForceBounds& bounds, DeviceN before,
                   DeviceN sent) RELIEVO_REALTIME {
  constexpr double kRounding = 1e-9;
  ++audit.ticks;
  const double size = norm(sent), last = norm(before);
  const DeviceN from = last > bounds.most_n ? (bounds.most_n / last) * before : before;
  const double step = norm(sent - from);
  if (bounds.zero) {
    ++audit.zero_demanded;
    if (!(sent == DeviceN{})) ++audit.zero_violations;
  }
  // Written so that what is no number counts.
  if (!(size <= bounds.most_n + kRounding)) ++audit.limit_violations;
  if (sent == DeviceN{}) return audit;
  audit.largest_n = std::max(audit.largest_n, size);
  audit.largest_step_n = std::max(audit.largest_step_n, step);
  if (!(step <= bounds.most_step_n + kRounding)) {
    ++audit.step_violations;
  } else if (norm(sent - before) > bounds.most_step_n + kRounding) {
    ++audit.fast_falls;
  }
  return audit;
}

}  // namespace relievo
