// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/piece.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
namespace {

constexpr int kParts = 4;
constexpr int kRowsAtOnce = 32;  // Some 30 ms on the largest maps: often enough to cancel.

/// Of each cell of one row: how many of its 4 x 4 points lie inside the outline, even-odd. Found
/// from where the outline crosses each line of points, so that long outlines cost little.
class RowCounts {
 public:
  RowCounts(const GridFrame& frame, const std::vector<PlaceMm>& outline)
      : frame_(frame), outline_(outline), counts_(static_cast<std::size_t>(frame.size.cols)) {}

  const std::vector<int>& of(int row) {
    std::fill(counts_.begin(), counts_.end(), 0);
    for (int j = 0; j < kParts; ++j) {
      addLine(frame_.yMm(row) + ((j + 0.5) / kParts - 0.5) * frame_.spacing_mm);
    }
    return counts_;
  }

 private:
  void addLine(double y) {
    crossings_.clear();
    for (std::size_t i = 0, j = outline_.size() - 1; i < outline_.size(); j = i++) {
      const PlaceMm a = outline_[i];
      const PlaceMm b = outline_[j];
      if ((a.y > y) != (b.y > y)) {
        crossings_.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      // Point k lies at left + (k + 0.5) part; those in [from, to) count.
      const int from = firstAtOrAfter(crossings_[i]);
      const int to = firstAtOrAfter(crossings_[i + 1]);
      if (from < to) addPoints(from, to);
    }
  }

  /// Points from ... to - 1 of one line, at least one.
  void addPoints(int from, int to) {
    const auto first = static_cast<std::size_t>(from / kParts);
    const auto last = static_cast<std::size_t>((to - 1) / kParts);
    if (first == last) {
      counts_[first] += to - from;
      return;
    }
    counts_[first] += kParts - from % kParts;
    for (std::size_t cell = first + 1; cell < last; ++cell) counts_[cell] += kParts;
    counts_[last] += (to - 1) % kParts + 1;
  }

  int firstAtOrAfter(double x) const {
    const double left = frame_.first_x_mm - 0.5 * frame_.spacing_mm;
    const double point = std::ceil((x - left) / frame_.spacing_mm * kParts - 0.5);
    return static_cast<int>(std::clamp(point, 0.0, static_cast<double>(kParts) * frame_.size.cols));
  }

  const GridFrame& frame_;
  const std::vector<PlaceMm>& outline_;
  std::vector<int> counts_;
  std::vector<double> crossings_;
};

/// Area of the surface over area in the view, from central differences.
double stretch(const MapPart& map, Cell at) {
  const auto slope = [&](int dc, int dr) {
    const Cell before{.col = at.col - dc, .row = at.row - dr};
    const Cell after{.col = at.col + dc, .row = at.row + dr};
    const auto usable = [&](Cell c) {
      return map.frame().size.contains(c) && map.origin(c) != Origin::outside;
    };
    const Cell from = usable(before) ? before : at;
    const Cell to = usable(after) ? after : at;
    const int steps = (to == at ? 0 : 1) + (from == at ? 0 : 1);
    if (steps == 0) return 0.0;
    return static_cast<double>(map.heightMm(to) - map.heightMm(from)) /
           (steps * map.frame().spacing_mm);
  };
  return std::sqrt(1 + std::pow(slope(1, 0), 2) + std::pow(slope(0, 1), 2));
}

/// First and last cell along one axis that an outline can touch; first > last if there is none.
std::pair<int, int> cellsAlong(double low, double high, double first_mm, double spacing_mm,
                               int count) {
  const auto cell = [&](double mm) {
    return std::clamp((mm - first_mm) / spacing_mm, -2.0, count + 1.0);
  };
  const int from = static_cast<int>(std::floor(cell(low))) - 1;
  const int to = static_cast<int>(std::ceil(cell(high))) + 1;
  return {std::max(from, 0), std::min(to, count - 1)};
}

/// What the cells add up to.
class Sums {
 public:
  explicit Sums(const GridFrame& frame, double plane_mm)
      : cell_mm2_(frame.spacing_mm * frame.spacing_mm), plane_mm_(plane_mm) {}

  void add(const MapPart& map, Cell cell, int points) {
    if (points == 0 || map.origin(cell) == Origin::outside) return;
    const double part = static_cast<double>(points) / (kParts * kParts);
    const double above = std::max(0.0, static_cast<double>(map.heightMm(cell)) - plane_mm_);
    const double stretched = stretch(map, cell);
    cells_ += part;
    if (map.origin(cell) != Origin::measured) unmeasured_ += part;
    piece_.area_mm2 += part * cell_mm2_;
    piece_.surface_mm2 += part * cell_mm2_ * stretched;
    piece_.volume_mm3 += part * cell_mm2_ * above;
    if (part < 1) {  // On the outline, which may lie half a cell to either side.
      piece_.area_off_mm2 += 0.5 * cell_mm2_;
      piece_.surface_off_mm2 += 0.5 * cell_mm2_ * stretched;
      piece_.volume_off_mm3 += 0.5 * cell_mm2_ * above;
    }
  }
  Piece piece() const {
    Piece piece = piece_;
    piece.not_measured = cells_ > 0 ? unmeasured_ / cells_ : 0;
    return piece;
  }

 private:
  double cell_mm2_, plane_mm_;
  double cells_ = 0, unmeasured_ = 0;
  Piece piece_;
};

}  // namespace

Piece pieceOf(const MapCells& map, const std::vector<PlaceMm>& outline, double plane_mm) {
  const GridFrame& f = map.frame();
  Sums sums(f, plane_mm);
  const bool finite = std::all_of(outline.begin(), outline.end(), [](const PlaceMm& p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
  });
  if (outline.empty() || !finite) return sums.piece();
  const auto [leftmost, rightmost] = std::minmax_element(
      outline.begin(), outline.end(), [](PlaceMm a, PlaceMm b) { return a.x < b.x; });
  const auto [lowest, highest] = std::minmax_element(
      outline.begin(), outline.end(), [](PlaceMm a, PlaceMm b) { return a.y < b.y; });
  const auto [left, right] =
      cellsAlong(leftmost->x, rightmost->x, f.first_x_mm, f.spacing_mm, f.size.cols);
  const auto [bottom, top] =
      cellsAlong(lowest->y, highest->y, f.first_y_mm, f.spacing_mm, f.size.rows);
  if (left > right) return sums.piece();
  RowCounts row_counts(f, outline);
  for (int row = bottom; row <= top; row += kRowsAtOnce) {
    const int end = std::min(row + kRowsAtOnce, top + 1);
    const Cell first{.col = std::max(left - 1, 0), .row = std::max(row - 1, 0)};
    const MapPart part = map.part(first, {.cols = std::min(right + 2, f.size.cols) - first.col,
                                          .rows = std::min(end + 1, f.size.rows) - first.row});
    for (int r = row; r < end; ++r) {
      const std::vector<int>& counts = row_counts.of(r);
      for (int col = left; col <= right; ++col) {
        sums.add(part, {.col = col, .row = r}, counts[static_cast<std::size_t>(col)]);
      }
    }
  }
  return sums.piece();
}

}  // namespace relievo
