// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/soft_spring.h"

#include <algorithm>

namespace relievo {

SoftSpring yielded(SoftSpring spring, const SoftPull& now) RELIEVO_REALTIME {
  const DeviceMm way = now.hand - spring.last.hand;
  if (spring.watched && norm(way) <= SoftSpring::kMostWayMm) {
    // Per unit of its share: what the hand gets back on this way and what then is still stored,
    // before it and after it, each with its half of the mean force.
    const double had = spring.share * (spring.last.energy_mm2 - 0.5 * dot(spring.last.pull, way));
    const double would_have = now.energy_mm2 + 0.5 * dot(now.pull, way);
    const double paid = would_have > had ? had / would_have : 1;
    const double least = std::min(1.0, now.least_share);
    // Where energy leaves without pay, less may be felt than is there; it cannot be below zero.
    spring.share = would_have > 0 ? std::clamp(paid, least, 1.0) : 1;
  }
  spring.last = now;
  spring.watched = true;
  return spring;
}

}  // namespace relievo
