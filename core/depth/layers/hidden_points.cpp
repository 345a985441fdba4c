// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/hidden_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include "core/base/bands.h"

namespace relievo {
namespace {

constexpr std::size_t kWorkOfCell = 8;  // A cell here is as much work as so many of others.
constexpr float kNone = -std::numeric_limits<float>::infinity();

/// Neighbours above this count as standing in front of a cell of this depth.
float limitAbove(float depth, const GridFrame& frame) {
  return depth + static_cast<float>(kSeeThroughCells * frame.spacing_mm);
}

/// out[i] = the higher of a[i] and b[i].
void takeHigher(const float* a, const float* b, float* out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] = a[i] > b[i] ? a[i] : b[i];
}

/// Highest of every `width` lines of `length` values in turn, in place, by doubling: the first
/// lines - width + 1 lines then hold them.
void highestOfLines(std::vector<float>& values, std::size_t lines, std::size_t length,
                    std::size_t width) {
  std::size_t known = 1;
  while (known < width) {
    const std::size_t more = std::min(known, width - known);
    takeHigher(values.data(), values.data() + more * length, values.data(),
               (lines - more) * length);
    known += more;
  }
}

/// Highest measured depth in the square around every cell of rows first ... end - 1; columns first,
/// then rows.
std::vector<float> highestAround(const FrontDepths& depths, GridSize size, int radius, int first,
                                 int end) {
  const auto r = static_cast<std::size_t>(radius);
  const auto cols = static_cast<std::size_t>(size.cols);
  const auto rows = static_cast<std::size_t>(end - first);
  std::vector<float> padded((rows + 2 * r) * cols, kNone);
  const int from = std::max(first - radius, 0);
  const int to = std::min(end + radius, size.rows);
  std::transform(depths.begin() + static_cast<std::ptrdiff_t>(size.index({.col = 0, .row = from})),
                 depths.begin() + static_cast<std::ptrdiff_t>(size.index({.col = 0, .row = to})),
                 padded.begin() + static_cast<std::ptrdiff_t>(
                                      size.index({.col = 0, .row = from - first + radius})),
                 [](float z) { return std::isnan(z) ? kNone : z; });
  highestOfLines(padded, rows + 2 * r, cols, 2 * r + 1);
  std::vector<float> line(cols + 2 * r);
  for (std::size_t row = 0; row < rows; ++row) {
    std::fill(line.begin(), line.end(), kNone);
    std::copy_n(&padded[row * cols], cols, line.begin() + static_cast<std::ptrdiff_t>(r));
    highestOfLines(line, cols + 2 * r, 1, 2 * r + 1);
    std::copy_n(line.begin(), cols, &padded[row * cols]);
  }
  return padded;
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
constexpr int kClimbSteps = 3;

/// Around one cell, as far as is looked: which cells could hold no front.
class GapWindow {
 public:
  GapWindow(const FrontDepths& depths, const GridFrame& frame, Cell cell)
      : depths_(depths),
        frame_(frame),
        middle_(cell),
        limit_(limitAbove(depths[frame.size.index(cell)], frame)) {}

  /// Are there straight ways out of sight with no front on them, in three of eight directions? Most
  /// cells of slopes and beside walls have these, and few others.
  bool isOpen() const {
    int ways = 0;
    for (int down = -1; down <= 1; ++down) {
      for (int right = -1; right <= 1; ++right) {
        if (down == 0 && right == 0) continue;
        int step = 1;
        while (step <= kGapReach &&
               !isFront({.col = middle_.col + step * right, .row = middle_.row + step * down})) {
          ++step;
        }
        ways += step > kGapReach ? 1 : 0;
        if (ways == 3) return true;
      }
    }
    return false;
  }

  /// Does the surface climb from the cell to the front in a few steps without a jump? The low
  /// corner of a steep plane does; the back does not.
  bool climbsToFront() const {
    const float jump = limit_ - depths_[frame_.size.index(middle_)];
    std::vector<Cell> reached{middle_};
    std::size_t first = 0;
    for (int step = 0; step < kClimbSteps; ++step) {
      const std::size_t end = reached.size();
      for (; first < end; ++first) {
        const Cell from = reached[first];
        const float z = depths_[frame_.size.index(from)];
        for (int row = from.row - 1; row <= from.row + 1; ++row) {
          for (int col = from.col - 1; col <= from.col + 1; ++col) {
            const Cell to{.col = col, .row = row};
            if (!frame_.size.contains(to)) continue;
            const float rise = depths_[frame_.size.index(to)] - z;
            if (!(rise > 0 && rise <= jump)) continue;  // Upward only: never back; NaN: no way.
            if (isFront(to)) return true;
            reached.push_back(to);
          }
        }
      }
    }
    return false;
  }

  /// Nothing where too little front is around to tell a gap from a groove.
  std::optional<bool> isGap() const {
    const double free = freeShare();
    if (free >= kMostFree) return std::nullopt;
    // 999 of 1000 cells that chance leaves empty are connected to fewer than these.
    const int enough =
        static_cast<int>(std::ceil(kClusterCells * std::pow(kThreshold - free, kExponent)));
    // A neck of one cell leads from many a gap to what lies beyond the front's edge. It is a groove
    // only if it is itself long enough.
    if (isShutIn(middle_, kNeckShare)) {
      return !isConnectedTo(enough,
                            [this](Cell c) { return !isFront(c) && isShutIn(c, kOpenShare); });
    }
    if (isConnectedTo(enough, [this](Cell c) { return !isFront(c); })) return false;
    const double density = -std::log(std::max(free, 1e-9));
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
};

/// Empties the cells for which `drops` holds, judged by the depths as they are before. Hardly any
/// cell has a neighbour within `radius` that stands before it; only those are looked at closely.
template <class Drops>
std::size_t dropWhere(FrontDepths& depths, const GridFrame& frame, int radius, const Task& task,
                      int threads, Drops&& drops) {
  std::vector<std::size_t> hidden;
  std::mutex joining;
  const int used = threadsFor(kWorkOfCell * depths.size(), threads);
  parallelFor(frame.size.rows, used, [&](int first, int end) {
    const std::vector<float> highest = highestAround(depths, frame.size, radius, first, end);
    const std::size_t offset = frame.size.index({.col = 0, .row = first});
    std::vector<std::size_t> mine;
    for (int row = first; row < end; ++row) {
      if (row % 16 == 0) task.check();
      for (int col = 0; col < frame.size.cols; ++col) {
        const std::size_t i = frame.size.index({.col = col, .row = row});
        if (std::isnan(depths[i]) || highest[i - offset] <= limitAbove(depths[i], frame)) continue;
        if (drops(Cell{.col = col, .row = row})) mine.push_back(i);
      }
    }
    const std::lock_guard lock(joining);
    hidden.insert(hidden.end(), mine.begin(), mine.end());  // Their order does not matter.
  });
  for (const std::size_t i : hidden) depths[i] = std::numeric_limits<float>::quiet_NaN();
  return hidden.size();
}

}  // namespace

std::size_t dropSeenThrough(FrontDepths& depths, const GridFrame& frame, int radius,
                            const Task& task, int threads) {
  std::size_t dropped = 0;
  // Twice: without the first pass's cells the rest stands out better.
  for (int pass = 0; pass < kSeeThroughPasses; ++pass) {
    const std::size_t now =
        dropWhere(depths, frame, std::max(radius, kDensityReach), task, threads, [&](Cell cell) {
          const GapWindow around(depths, frame, cell);
          if (around.isOpen()) return false;
          const std::optional<bool> is_gap = around.isGap();
          const bool dropped_here = is_gap ? *is_gap : isSeenThrough(depths, frame, cell, radius);
          return dropped_here && !around.climbsToFront();
        });
    if (now == 0) break;
    dropped += now;
  }
  return dropped;
}

}  // namespace relievo
