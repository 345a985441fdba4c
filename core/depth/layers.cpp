// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace relievo {
namespace {

constexpr double kPointsOfSquare = 8;
constexpr std::size_t kFewestPoints = 5;  // Of a square that says anything.
constexpr double kGap = 0.7;    // Sides of a square between the groups; noise and slopes make less.
constexpr double kUpright = 6;  // Sides of a square that its points rise: a wall seen edge-on.

/// Do the points of a square, rising in z, fall into two groups over the same ground?
bool isLayered(const std::vector<ViewMm>& square, double side) {
  std::size_t split = 0;
  double gap = kGap * side;
  for (std::size_t i = 1; i < square.size(); ++i) {
    if (square[i].z - square[i - 1].z <= gap) continue;
    gap = square[i].z - square[i - 1].z;
    split = i;
  }
  if (split == 0) return false;
  // Side by side, a line between the groups' middles parts them.
  std::array<double, 4> middles{};
  for (std::size_t i = 0; i < square.size(); ++i) {
    const std::size_t group = i < split ? 0 : 2;
    const auto members = static_cast<double>(i < split ? split : square.size() - split);
    middles[group] += square[i].x / members;
    middles[group + 1] += square[i].y / members;
  }
  const double x = middles[2] - middles[0];
  const double y = middles[3] - middles[1];
  double last_below = -std::numeric_limits<double>::infinity();
  double first_above = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < square.size(); ++i) {
    const double along = square[i].x * x + square[i].y * y;
    if (i < split) {
      last_below = std::max(last_below, along);
    } else {
      first_above = std::min(first_above, along);
    }
  }
  return first_above <= last_below;
}

}  // namespace

bool liesInLayers(const std::vector<ViewMm>& points) {
  const LayerShares shares = layerShares(points);
  return shares.layered >= kLayered || shares.layered + shares.upright >= kMostlyUpright;
}

LayerShares layerShares(const std::vector<ViewMm>& points) {
  if (points.size() < kFewestPoints) return {};
  ViewMm low = points[0];
  ViewMm high = points[0];
  for (const ViewMm& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
  }
  const double longer = std::max(high.x - low.x, high.y - low.y);
  if (!(longer > 0)) return {};
  // The covered area is not known yet: squares of a quarter of the points' mean area, then larger
  // ones until those that are hit hold enough.
  double side = longer * std::sqrt(kPointsOfSquare / static_cast<double>(points.size())) / 2;
  struct Placed {
    std::uint64_t square;
    ViewMm point;
  };
  std::vector<Placed> placed(points.size());
  for (int attempt = 0; attempt < 4; ++attempt) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto col = static_cast<std::uint64_t>((points[i].x - low.x) / side);
      const auto row = static_cast<std::uint64_t>((points[i].y - low.y) / side);
      placed[i] = {.square = row << 32U | col, .point = points[i]};
    }
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
      return a.square != b.square ? a.square < b.square : a.point.z < b.point.z;
    });
    std::size_t squares = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      squares += i == 0 || placed[i].square != placed[i - 1].square ? 1 : 0;
    }
    if (static_cast<double>(placed.size()) >= kPointsOfSquare * static_cast<double>(squares)) break;
    side *= 1.5;
  }
  std::size_t layered = 0;
  std::size_t upright = 0;
  std::size_t judged = 0;
  std::vector<ViewMm> square;
  for (std::size_t i = 0; i < placed.size();) {
    square.clear();
    const std::uint64_t number = placed[i].square;
    for (; i < placed.size() && placed[i].square == number; ++i) square.push_back(placed[i].point);
    if (square.size() < kFewestPoints) continue;
    judged += square.size();
    if (isLayered(square, side)) {
      layered += square.size();
    } else if (square.back().z - square.front().z > kUpright * side) {
      upright += square.size();
    }
  }
  const auto all = static_cast<double>(std::max<std::size_t>(judged, 1));
  return {.layered = static_cast<double>(layered) / all,
          .upright = static_cast<double>(upright) / all};
}

}  // namespace relievo
