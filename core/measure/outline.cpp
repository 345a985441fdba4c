// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/base/failure.h"
#include "core/measure/area_result.h"
#include "core/measure/measure.h"

namespace relievo {
namespace {

/// Twice the area of the triangle a b c; above 0 if it turns left.
double turn(PlaceMm a, PlaceMm b, PlaceMm c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Do two sides cross within both? Those that only touch do not: no area changes its side there.
bool cross(PlaceMm a, PlaceMm b, PlaceMm c, PlaceMm d) {
  const auto apart = [](double u, double v) { return (u > 0 && v < 0) || (u < 0 && v > 0); };
  return apart(turn(a, b, c), turn(a, b, d)) && apart(turn(c, d, a), turn(c, d, b));
}

bool crossesItself(const std::vector<PlaceMm>& places) {
  const std::size_t count = places.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (cross(places[i], places[i + 1], places[j], places[(j + 1) % count])) return true;
    }
  }
  return false;
}

}  // namespace

bool lastSideCrosses(const std::vector<PlaceMm>& places) {
  for (std::size_t i = 0; i + 3 < places.size(); ++i) {
    if (cross(places[i], places[i + 1], places[places.size() - 2], places.back())) return true;
  }
  return false;
}

std::optional<Message> outlineRefusal(const std::vector<PlaceMm>& places) {
  if (places.size() < 3) return std::nullopt;
  if (crossesItself(places)) {
    return said<MessageId::outline_crosses_itself>();
  }
  double twice_area = 0;
  double longest = 0;
  for (const PlaceMm& p : places)
    longest = std::max(longest, std::hypot(p.x - places[0].x, p.y - places[0].y));
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    twice_area += turn(places[0], places[i], places[i + 1]);
  }
  // On one line but for rounding.
  if (std::abs(twice_area) <= 1e-9 * longest * longest) {
    return said<MessageId::outline_is_a_line>();
  }
  return std::nullopt;
}

std::string outlineProblem(const std::vector<PlaceMm>& places) {
  const std::optional<Message> refusal = outlineRefusal(places);
  return refusal ? englishText(*refusal) : std::string();
}

}  // namespace relievo
