// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/turned_region.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

Level nearestLevel(const DetailLadder& ladder, double spacing_mm) {
  const auto distance = [&](double other_mm) { return std::abs(std::log(other_mm / spacing_mm)); };
  const auto nearest =
      std::min_element(ladder.spacings_mm.begin(), ladder.spacings_mm.end(),
                       [&](double a, double b) { return distance(a) < distance(b); });
  return {static_cast<int>(nearest - ladder.spacings_mm.begin())};
}

}  // namespace

Region turnedRegion(const Surface& from, const Region& region, const ViewMm& about,
                    const Surface& to) {
  const Region whole = wholeRegion(to.ladder);
  if (region == wholeRegion(from.ladder) || region.side_mm >= whole.side_mm) return whole;
  const ViewMm now = to.view_from_file(from.view_from_file.inverseOfSimilarity()(about));
  Region turned = region;
  turned.x_mm += now.x - about.x;
  turned.y_mm += now.y - about.y;
  const auto spacing = from.ladder.spacings_mm[static_cast<std::size_t>(region.level.value)];
  turned.level = nearestLevel(to.ladder, spacing);
  return onMap(to.ladder, turned) ? turned : moved(to.ladder, turned, 0, 0).value_or(whole);
}

}  // namespace relievo
