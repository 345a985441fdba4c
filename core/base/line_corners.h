// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/vec3.h"

namespace relievo {

/// Distance of a point from the stretch between two others.
template <class Tag>
double distanceFromStretch(Vec3<Tag> p, Vec3<Tag> from, Vec3<Tag> to) {
  const Vec3<Tag> way = to - from;
  const double square = dot(way, way);
  const double part = square > 0 ? std::clamp(dot(p - from, way) / square, 0.0, 1.0) : 0;
  return norm(p - (from + part * way));
}

/// Which points of a line keep its shape: none of those that are left out is farther than
/// `tolerance` from the line through the others (Douglas and Peucker 1973).
/// @param line  finite points; of a closed one the last is not the first again
/// @return indices, ascending, with the first point and, of an open line, the last
template <class Tag>
std::vector<std::size_t> lineCorners(std::span<const Vec3<Tag>> line, bool closed,
                                     double tolerance) {
  const std::size_t count = line.size();
  if (count < 3) {
    std::vector<std::size_t> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = i;
    return all;
  }
  const auto at = [&](std::size_t i) { return line[i % count]; };
  std::vector<bool> kept(count + 1, false);
  std::vector<std::pair<std::size_t, std::size_t>> left;
  kept[0] = true;
  if (closed) {
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (norm(line[i] - line[0]) > norm(line[farthest] - line[0])) farthest = i;
    }
    kept[farthest] = true;
    left = {{0, farthest}, {farthest, count}};
  } else {
    kept[count - 1] = true;
    left = {{0, count - 1}};
  }
  while (!left.empty()) {
    const auto [first, last] = left.back();
    left.pop_back();
    std::size_t worst = first;
    double off = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distanceFromStretch(at(i), at(first), at(last));
      if (distance > off) {
        off = distance;
        worst = i;
      }
    }
    if (worst == first) continue;
    kept[worst] = true;
    left.emplace_back(first, worst);
    left.emplace_back(worst, last);
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < count; ++i) {
    if (kept[i]) corners.push_back(i);
  }
  return corners;
}

}  // namespace relievo
