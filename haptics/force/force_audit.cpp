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

ForceAudit auditedGuide(ForceAudit audit, const GuideBounds& bounds, DeviceN sent,
                        double fed_mw) RELIEVO_REALTIME {
  constexpr double kRounding = 1e-9;
  ++audit.guided_ticks;
  const double size = norm(sent);
  // Written so that what is no number counts.
  const bool holds = size <= bounds.most_n + kRounding && fed_mw <= bounds.most_mw + kRounding;
  if (!holds) ++audit.guide_violations;
  audit.largest_guide_n = std::max(audit.largest_guide_n, size);
  audit.largest_fed_mw = std::max(audit.largest_fed_mw, fed_mw);
  return audit;
}

}  // namespace relievo
