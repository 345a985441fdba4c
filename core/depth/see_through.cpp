// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/see_through.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace relievo {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();

/// Neighbours above this count as standing in front of a cell of this depth.
float limitAbove(float depth, const GridFrame& frame) {
  return depth + static_cast<float>(kSeeThroughCells * frame.spacing_mm);
}

/// Highest value within `radius` along one line of `count` cells that are `stride` apart.
void highestAlong(const float* in, float* out, std::ptrdiff_t count, std::ptrdiff_t stride,
                  std::ptrdiff_t radius) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    float highest = kNone;
    const std::ptrdiff_t last = std::min(i + radius, count - 1);
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(i - radius, 0); k <= last; ++k) {
      highest = std::max(highest, in[k * stride]);
    }
    out[i * stride] = highest;
  }
}

/// Highest measured depth in the square around every cell; rows first, then columns.
FrontDepths highestAround(const FrontDepths& depths, GridSize size, int radius) {
  FrontDepths known = depths;
  for (float& z : known) z = std::isnan(z) ? kNone : z;
  FrontDepths along_rows(depths.size());
  for (int row = 0; row < size.rows; ++row) {
    const std::size_t start = size.index({.col = 0, .row = row});
    highestAlong(&known[start], &along_rows[start], size.cols, 1, radius);
  }
  for (int col = 0; col < size.cols; ++col) {
    const auto start = static_cast<std::size_t>(col);
    highestAlong(&along_rows[start], &known[start], size.rows, size.cols, radius);
  }
  return known;
}

bool isSeenThrough(const FrontDepths& depths, const GridFrame& frame, Cell cell, int radius) {
  const float limit = limitAbove(depths[frame.size.index(cell)], frame);
  int measured = 0;
  int higher = 0;
  for (int row = std::max(0, cell.row - radius);
       row <= std::min(frame.size.rows - 1, cell.row + radius); ++row) {
    for (int col = std::max(0, cell.col - radius);
         col <= std::min(frame.size.cols - 1, cell.col + radius); ++col) {
      const float z = depths[frame.size.index({.col = col, .row = row})];
      if (std::isnan(z)) continue;
      ++measured;
      higher += z > limit ? 1 : 0;
    }
  }
  return 2 * higher > measured;  // The cell itself is one of the measured and not higher.
}

constexpr int kDensityReach = 8;      // Cells to each side whose density counts.
constexpr double kMostFree = 0.45;    // Share of empty cells.
constexpr double kThreshold = 0.593;  // Of site percolation on the square lattice.
constexpr double kClusterCells = 1.8;
constexpr double kExponent = -43.0 / 18;  // Of the mean cluster size below it.
constexpr double kNeckShare = 0.7;        // Of a groove one cell wide it is 6 of 8, ...
constexpr double kOpenShare = 0.5;        // ... at a straight edge 3 of 8.
constexpr double kChanceOfSquare = 9.2;   // -log of 1e-4, as for sampling gaps.

/// Around one cell, as far as is looked: which cells could hold no front.
class GapWindow {
 public:
  GapWindow(const FrontDepths& depths, const GridFrame& frame, Cell cell)
      : depths_(depths),
        frame_(frame),
        middle_(cell),
        limit_(limitAbove(depths[frame.size.index(cell)], frame)),
        free_(freeShare()) {}

  /// Is there enough front around to tell a gap from a groove?
  bool tells() const { return free_ < kMostFree; }

  bool isGap() const {
    // 999 of 1000 cells that chance leaves empty are connected to fewer than these.
    const int enough =
        static_cast<int>(std::ceil(kClusterCells * std::pow(kThreshold - free_, kExponent)));
    // A neck of one cell leads from many a gap to what lies beyond the front's edge. It is a groove
    // only if it is itself long enough.
    if (isShutIn(middle_, kNeckShare)) {
      return !isConnectedTo(enough,
                            [this](Cell c) { return !isFront(c) && isShutIn(c, kOpenShare); });
    }
    if (isConnectedTo(enough, [this](Cell c) { return !isFront(c); })) return false;
    const double density = -std::log(std::max(free_, 1e-9));
    return !isInSquare(static_cast<int>(std::ceil(std::sqrt(kChanceOfSquare / density))));
  }

 private:
  static constexpr int kSide = 2 * kGapReach + 1;

  bool isFront(Cell c) const {
    return !frame_.size.contains(c) || depths_[frame_.size.index(c)] > limit_;
  }

  /// Is more than this share of the cell's measured neighbours front?
  bool isShutIn(Cell c, double share) const {
    int front = 0;
    int behind = 0;
    for (int row = c.row - 1; row <= c.row + 1; ++row) {
      for (int col = c.col - 1; col <= c.col + 1; ++col) {
        const Cell next{.col = col, .row = row};
        if (next == c || !frame_.size.contains(next)) continue;
        const float z = depths_[frame_.size.index(next)];
        front += z > limit_ ? 1 : 0;
        behind += z <= limit_ ? 1 : 0;
      }
    }
    return front > share * (front + behind);
  }

  /// Share of cells without front in that quarter of the cells around which has most of it: a gap
  /// at an edge of the front is one of the front's.
  double freeShare() const {
    double least = 1;
    for (const int down : {kDensityReach, 0}) {
      for (const int left : {kDensityReach, 0}) {
        least =
            std::min(least, freeShareFrom({.col = middle_.col - left, .row = middle_.row - down}));
      }
    }
    return least;
  }
  double freeShareFrom(Cell lowest) const {
    int cells = 0;
    int front = 0;
    for (int row = std::max(0, lowest.row);
         row <= std::min(frame_.size.rows - 1, lowest.row + kDensityReach); ++row) {
      for (int col = std::max(0, lowest.col);
           col <= std::min(frame_.size.cols - 1, lowest.col + kDensityReach); ++col) {
        ++cells;
        front += isFront({.col = col, .row = row}) ? 1 : 0;
      }
    }
    return 1 - static_cast<double>(front) / cells;
  }

  /// Does the area of such cells that this one is in have so many, or reach out of sight?
  template <class IsPart>
  bool isConnectedTo(int enough, IsPart&& is_part) const {
    std::array<bool, kSide * kSide> seen{};
    std::vector<Cell> found{middle_};
    seen[seen.size() / 2] = true;
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (static_cast<int>(found.size()) >= enough) return true;
      const Cell c = found[k];
      for (const Cell next : {Cell{c.col - 1, c.row}, Cell{c.col + 1, c.row},
                              Cell{c.col, c.row - 1}, Cell{c.col, c.row + 1}}) {
        const int right = next.col - middle_.col + kGapReach;
        const int up = next.row - middle_.row + kGapReach;
        if (right < 0 || up < 0 || right >= kSide || up >= kSide) return true;
        if (!frame_.size.contains(next)) continue;
        bool& was_seen =
            seen[static_cast<std::size_t>(up) * kSide + static_cast<std::size_t>(right)];
        if (was_seen || !is_part(next)) continue;
        was_seen = true;
        found.push_back(next);
      }
    }
    return false;
  }

  /// Is it in a square of side^2 cells without front?
  bool isInSquare(int side) const {
    for (int row = middle_.row - side + 1; row <= middle_.row; ++row) {
      for (int col = middle_.col - side + 1; col <= middle_.col; ++col) {
        if (isFree({.col = col, .row = row}, side)) return true;
      }
    }
    return false;
  }
  bool isFree(Cell lowest, int side) const {
    for (int row = lowest.row; row < lowest.row + side; ++row) {
      for (int col = lowest.col; col < lowest.col + side; ++col) {
        if (isFront({.col = col, .row = row})) return false;
      }
    }
    return true;
  }

  const FrontDepths& depths_;
  const GridFrame& frame_;
  Cell middle_;
  float limit_;
  double free_;
};

/// Empties the cells for which `drops` holds, judged by the depths as they are before. Hardly any
/// cell has a neighbour within `radius` that stands before it; only those are looked at closely.
template <class Drops>
std::size_t dropWhere(FrontDepths& depths, const GridFrame& frame, int radius, const Task& task,
                      Drops&& drops) {
  const FrontDepths highest = highestAround(depths, frame.size, radius);
  std::vector<std::size_t> hidden;
  for (int row = 0; row < frame.size.rows; ++row) {
    if (row % 16 == 0) task.check();
    for (int col = 0; col < frame.size.cols; ++col) {
      const std::size_t i = frame.size.index({.col = col, .row = row});
      if (std::isnan(depths[i]) || highest[i] <= limitAbove(depths[i], frame)) continue;
      if (drops(Cell{.col = col, .row = row})) hidden.push_back(i);
    }
  }
  for (const std::size_t i : hidden) depths[i] = std::numeric_limits<float>::quiet_NaN();
  return hidden.size();
}

}  // namespace

std::size_t dropSeenThrough(FrontDepths& depths, const GridFrame& frame, int radius,
                            const Task& task) {
  std::size_t dropped = 0;
  // Twice: without the first pass's cells the rest stands out better.
  for (int pass = 0; pass < kSeeThroughPasses; ++pass) {
    dropped += dropWhere(depths, frame, std::max(radius, kDensityReach), task, [&](Cell cell) {
      const GapWindow around(depths, frame, cell);
      return around.tells() ? around.isGap() : isSeenThrough(depths, frame, cell, radius);
    });
  }
  return dropped;
}

}  // namespace relievo
