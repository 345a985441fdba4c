// SPDX-License-Identifier: BSD-3-Clause
#include "core/describe/named_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {

std::string nameAt(const std::vector<NamedRegion>& places, const RectMm& object, const ViewMm& at,
                   double reach_mm) {
  const double largest_mm = 0.5 * std::max(object.width_mm, object.height_mm);
  double nearest_mm = std::numeric_limits<double>::infinity();
  std::string name;
  for (const NamedRegion& place : places) {
    const Region& r = place.region;
    const double away_mm = std::hypot(at.x - r.centreX(), at.y - r.centreY());
    const double radius_mm =
        r.side_mm > largest_mm ? reach_mm : std::max(0.5 * r.side_mm, reach_mm);
    if (away_mm > radius_mm || away_mm >= nearest_mm) continue;
    nearest_mm = away_mm;
    name = place.name;
  }
  return name;
}

}  // namespace relievo
