// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/carry.h"

#include <algorithm>

namespace relievo {

Region zoomed(const DetailLadder& ladder, const Region& from, const Zoom& zoom) {
  const double least = std::min(kLeastWindowCells * ladder.spacings_mm.front(), from.side_mm);
  const double side = std::max(from.side_mm / zoom.nearer, least);
  if (side >= ladder.sideMm(1)) return wholeRegion(ladder);
  const double keep = side / from.side_mm;
  const Region wanted =
      regionFromRect(ladder, {zoom.x_mm - (zoom.x_mm - from.x_mm) * keep,
                              zoom.y_mm - (zoom.y_mm - from.y_mm) * keep, side, side});
  return moved(ladder, wanted, 0, 0).value_or(wanted);
}

Region carried(const DetailLadder& ladder, const Region& from, const Carry& by) {
  const Region to = moved(ladder, from, -by.right, -by.up).value_or(from);
  if (by.nearer == 1) return to;
  return zoomed(ladder, to, {.nearer = by.nearer, .x_mm = to.centreX(), .y_mm = to.centreY()});
}

}  // namespace relievo
