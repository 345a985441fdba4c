// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/base/grid.h"

namespace relievo {
namespace {

constexpr double kPointsOfSquare = 8;
constexpr double kManyPoints = 4 * kPointsOfSquare;
constexpr int kMostSmaller = 5;
constexpr std::size_t kFewestPoints = 5;  // Of a square that says anything.
constexpr double kGap = 0.7;  // Sides of a square between the groups; noise and slopes make less.
constexpr int kFewestAround = 2;  // Of the squares around one, to say anything of it.
constexpr double kUpright = 6;    // Sides of a square that its points rise: a wall seen edge-on.

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

/// Which points each square of a grid holds.
class Squares {
 public:
  Squares(const std::vector<ViewMm>& points, const ViewMm& low, double side) {
    std::vector<std::array<std::uint32_t, 2>> places;
    places.reserve(points.size());
    std::uint32_t cols = 1;
    std::uint32_t rows = 1;
    for (const ViewMm& p : points) {
      const auto col = static_cast<std::uint32_t>((p.x - low.x) / side);
      const auto row = static_cast<std::uint32_t>((p.y - low.y) / side);
      cols = std::max(cols, col + 1);
      rows = std::max(rows, row + 1);
      places.push_back({col, row});
    }
    size_ = {.cols = static_cast<int>(cols), .rows = static_cast<int>(rows)};
    held_.assign(size_.count(), 0);
    squares_.reserve(points.size());
    for (const auto& [col, row] : places) {
      squares_.push_back(row * cols + col);
      ++held_[squares_.back()];
    }
  }

  GridSize size() const { return size_; }
  std::size_t count() const { return held_.size(); }
  std::size_t held(std::size_t square) const { return held_[square]; }
  std::size_t hit() const {
    return held_.size() -
           static_cast<std::size_t>(std::count(held_.begin(), held_.end(), std::uint32_t{0}));
  }
  /// The points' numbers, square after square.
  std::vector<std::uint32_t> pointsInOrder() const {
    std::vector<std::uint32_t> starts(held_.size());
    std::exclusive_scan(held_.begin(), held_.end(), starts.begin(), std::uint32_t{0});
    std::vector<std::uint32_t> order(squares_.size());
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      order[starts[squares_[i]]++] = static_cast<std::uint32_t>(i);
    }
    return order;
  }

 private:
  GridSize size_;
  std::vector<std::uint32_t> held_;     // Points in each square.
  std::vector<std::uint32_t> squares_;  // Of each point.
};

enum class Kind : std::uint8_t { unjudged, other, layered };

/// Are half of the squares around one, of those that say anything, layered, too? Chance and edges
/// make single ones, or lines of them.
bool isInPatch(const std::vector<Kind>& kinds, GridSize size, Cell square) {
  int judged = 0;
  int layered = 0;
  for (int row = square.row - 1; row <= square.row + 1; ++row) {
    for (int col = square.col - 1; col <= square.col + 1; ++col) {
      const Cell near{.col = col, .row = row};
      if (near == square || !size.contains(near)) continue;
      const Kind kind = kinds[size.index(near)];
      judged += kind != Kind::unjudged ? 1 : 0;
      layered += kind == Kind::layered ? 1 : 0;
    }
  }
  return judged >= kFewestAround && 2 * layered >= judged;
}

}  // namespace

bool liesInLayers(const std::vector<ViewMm>& points) {
  const LayerShares shares = layerShares(points);
  return shares.layered >= kLayered || shares.layered + shares.upright >= kMostlyUpright ||
         shares.in_patches >= kInPatches;
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
  // ones until those that are hit hold enough, or, where an object covers little of its box,
  // smaller ones: a blade seen edge-on would lie in squares wider than itself.
  double side = longer * std::sqrt(kPointsOfSquare / static_cast<double>(points.size())) / 2;
  constexpr int kMostAttempts = 4;
  Squares squares(points, low, side);
  const auto mean = [&] {
    return static_cast<double>(points.size()) / static_cast<double>(squares.hit());
  };
  for (int attempt = 1; mean() > kManyPoints && attempt < kMostSmaller; ++attempt) {
    side /= 1.5;
    squares = Squares(points, low, side);
  }
  for (int attempt = 1; mean() < kPointsOfSquare; ++attempt) {
    side *= 1.5;
    if (attempt == kMostAttempts) break;
    squares = Squares(points, low, side);
  }
  std::size_t upright = 0;
  std::size_t judged = 0;
  std::vector<Kind> kinds(squares.count(), Kind::unjudged);
  std::vector<ViewMm> square;
  const std::vector<std::uint32_t> in_order = squares.pointsInOrder();
  std::size_t begin = 0;
  for (std::size_t number = 0; number < squares.count(); ++number) {
    const std::size_t end = begin + squares.held(number);
    square.clear();
    for (std::size_t i = begin; i < end; ++i) square.push_back(points[in_order[i]]);
    begin = end;
    if (square.size() < kFewestPoints) continue;
    std::sort(square.begin(), square.end(),
              [](const ViewMm& a, const ViewMm& b) { return a.z < b.z; });
    judged += square.size();
    kinds[number] = Kind::other;
    if (isLayered(square, side)) {
      kinds[number] = Kind::layered;
    } else if (square.back().z - square.front().z > kUpright * side) {
      upright += square.size();
    }
  }
  std::size_t layered = 0;
  std::size_t in_patches = 0;
  const GridSize size = squares.size();
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const Cell at{.col = col, .row = row};
      const std::size_t number = size.index(at);
      if (kinds[number] != Kind::layered) continue;
      layered += squares.held(number);
      if (isInPatch(kinds, size, at)) in_patches += squares.held(number);
    }
  }
  const auto all = static_cast<double>(std::max<std::size_t>(judged, 1));
  return {.layered = static_cast<double>(layered) / all,
          .upright = static_cast<double>(upright) / all,
          .in_patches = static_cast<double>(in_patches) / all};
}

}  // namespace relievo
