// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/touch_marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
namespace {

double distance(PlaceMm a, PlaceMm b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// Of `p` from the segment a b.
double offLine(PlaceMm p, PlaceMm a, PlaceMm b) {
  const double length = distance(a, b);
  if (length == 0) return distance(p, a);
  const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / (length * length);
  const double t = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

/// The places of a way that keep all others within `off_mm` of the line through them (Douglas and
/// Peucker 1973), both ends included.
std::vector<PlaceMm> thinned(const std::vector<TouchSample>& way, double off_mm) {
  std::vector<bool> kept(way.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, way.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = off_mm;
    std::size_t farthest = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = offLine(way[i].proxy, way[first].proxy, way[last].proxy);
      if (off > most) {
        most = off;
        farthest = i;
      }
    }
    if (farthest == 0) continue;
    kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<PlaceMm> places;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (kept[i]) places.push_back(way[i].proxy);
  }
  return places;
}

}  // namespace

std::optional<TouchMark> TouchMarks::follow(const TouchSample& sample, double cell_mm) {
  if (sample.touching) {
    cell_mm_ = way_.empty() ? cell_mm : std::min(cell_mm_, cell_mm);
    way_.push_back(sample);
    return std::nullopt;
  }
  if (way_.empty()) return std::nullopt;
  const std::vector<TouchSample> way = std::exchange(way_, {});
  const bool slipped = std::any_of(way.begin(), way.end(), [&](const TouchSample& s) {
    return distance(s.proxy, way.front().proxy) > kTapCells * cell_mm_;
  });
  if (slipped) return TouchMark{thinned(way, 0.5 * cell_mm_), true};
  const auto hardest = std::max_element(
      way.begin(), way.end(),
      [](const TouchSample& a, const TouchSample& b) { return a.force_n < b.force_n; });
  return TouchMark{{hardest->proxy}, false};
}

}  // namespace relievo
