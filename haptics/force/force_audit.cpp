// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/force_audit.h"

#include <algorithm>

namespace relievo {

ForceAudit audited(ForceAudit audit, const ForceBounds& bounds, DeviceN before,
                   DeviceN sent) RELIEVO_REALTIME {
  constexpr double kRounding = 1e-9;
  ++audit.ticks;
  const double size = norm(sent), step = norm(sent - before);
  if (bounds.zero) {
    ++audit.zero_demanded;
    if (!(sent == DeviceN{})) ++audit.zero_violations;
  }
  // Written so that what is no number counts.
  if (!(size <= bounds.most_n + kRounding)) ++audit.limit_violations;
  if (sent == DeviceN{}) return audit;
  audit.largest_n = std::max(audit.largest_n, size);
  audit.largest_step_n = std::max(audit.largest_step_n, step);
  // A cap that came down takes hold at once.
  const bool at_cap = size >= bounds.most_n - kRounding;
  if (!(step <= bounds.most_step_n + kRounding) && !at_cap) ++audit.step_violations;
  return audit;
}

}  // namespace relievo
