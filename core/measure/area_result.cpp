// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/area_result.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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

struct Slope {
  double dx = 0, dy = 0;  ///< Height by length.
  double bend = 0;        ///< How far the slopes to either side differ from their mean.
};

/// By central differences.
Slope slopeAt(const MapPart& map, Cell at) {
  double bend = 0;
  const auto slope = [&](int dc, int dr) {
    const Cell before{.col = at.col - dc, .row = at.row - dr};
    const Cell after{.col = at.col + dc, .row = at.row + dr};
    const auto usable = [&](Cell c) {
      return map.frame().size.contains(c) && map.origin(c) != CellStatus::outside;
    };
    const Cell from = usable(before) ? before : at;
    const Cell to = usable(after) ? after : at;
    const int steps = (to == at ? 0 : 1) + (from == at ? 0 : 1);
    if (steps == 0) return 0.0;
    if (steps == 2) {
      const auto z = [&](Cell c) { return static_cast<double>(map.heightMm(c)); };
      bend = std::hypot(bend, (z(to) - 2 * z(at) + z(from)) / (2 * map.frame().spacing_mm));
    }
    return static_cast<double>(map.heightMm(to) - map.heightMm(from)) /
           (steps * map.frame().spacing_mm);
  };
  const double dx = slope(1, 0);
  const double dy = slope(0, 1);
  return {dx, dy, bend};
}

/// Area of the surface over area in the view.
double stretch(double slope) {
  return std::hypot(1, slope);
}

/// Parts of a line inside one cell.
struct CellLength {
  Cell cell;
  double mm = 0;
};

/// How much of an outline runs through which cells, by rows.
class OutlineLengths {
 public:
  OutlineLengths(const GridFrame& frame, const std::vector<PlaceMm>& outline) : frame_(frame) {
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      addLine(inCells(outline[j]), inCells(outline[i]));
    }
    std::sort(lengths_.begin(), lengths_.end(), [](const CellLength& a, const CellLength& b) {
      return std::pair(a.cell.row, a.cell.col) < std::pair(b.cell.row, b.cell.col);
    });
  }

  /// Of each cell of one row. Rows come lowest first.
  const std::vector<double>& of(int row) {
    row_mm_.assign(static_cast<std::size_t>(frame_.size.cols), 0.0);
    for (; next_ < lengths_.size() && lengths_[next_].cell.row <= row; ++next_) {
      const CellLength& l = lengths_[next_];
      if (l.cell.row == row) row_mm_[static_cast<std::size_t>(l.cell.col)] += l.mm;
    }
    return row_mm_;
  }

 private:
  /// Cell (col, row) reaches from (col, row) to (col + 1, row + 1).
  PlaceMm inCells(PlaceMm p) const {
    return {(p.x - frame_.first_x_mm) / frame_.spacing_mm + 0.5,
            (p.y - frame_.first_y_mm) / frame_.spacing_mm + 0.5};
  }

  /// The part of a line within the map, in shares of it; from > to if there is none.
  std::pair<double, double> withinMap(PlaceMm a, PlaceMm b) const {
    double from = 0;
    double to = 1;
    const auto clip = [&](double at, double end, double size) {
      if (at == end) {
        if (at < 0 || at > size) from = 2;
        return;
      }
      const double low = -at / (end - at);
      const double high = (size - at) / (end - at);
      from = std::max(from, std::min(low, high));
      to = std::min(to, std::max(low, high));
    };
    clip(a.x, b.x, frame_.size.cols);
    clip(a.y, b.y, frame_.size.rows);
    return {from, to};
  }

  void addLine(PlaceMm a, PlaceMm b) {
    const auto [from, to] = withinMap(a, b);
    if (!(from < to)) return;
    cuts_ = {from, to};
    const auto cut_at_borders = [&, from = from, to = to](double at, double end) {
      if (at == end) return;
      const double first = at + from * (end - at);
      const double last = at + to * (end - at);
      for (double line = std::ceil(std::min(first, last)); line < std::max(first, last); ++line) {
        cuts_.push_back((line - at) / (end - at));
      }
    };
    cut_at_borders(a.x, b.x);
    cut_at_borders(a.y, b.y);
    std::sort(cuts_.begin(), cuts_.end());
    const double length = std::hypot(b.x - a.x, b.y - a.y) * frame_.spacing_mm;
    for (std::size_t i = 1; i < cuts_.size(); ++i) {
      const double middle = 0.5 * (cuts_[i] + cuts_[i - 1]);
      // Along the map's own edge the cell within.
      const Cell cell{std::clamp(static_cast<int>(std::floor(a.x + middle * (b.x - a.x))), 0,
                                 frame_.size.cols - 1),
                      std::clamp(static_cast<int>(std::floor(a.y + middle * (b.y - a.y))), 0,
                                 frame_.size.rows - 1)};
      lengths_.push_back({cell, (cuts_[i] - cuts_[i - 1]) * length});
    }
  }

  const GridFrame& frame_;
  std::vector<CellLength> lengths_;
  std::vector<double> row_mm_, cuts_;
  std::size_t next_ = 0;
};

/// Sides of a cell at which the object ends.
int openSides(const MapPart& map, Cell cell) {
  int sides = 0;
  for (const auto& [dc, dr] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const Cell beside{.col = cell.col + dc, .row = cell.row + dr};
    if (!map.frame().size.contains(beside) || map.origin(beside) == CellStatus::outside) ++sides;
  }
  return sides;
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
      : s_(frame.spacing_mm), cell_mm2_(frame.spacing_mm * frame.spacing_mm), plane_mm_(plane_mm) {}

  /// @param points  of the cell's, inside the outline  @param outline_mm  of it in the cell
  void add(const MapPart& map, Cell cell, int points, double outline_mm) {
    if ((points == 0 && outline_mm == 0) || map.origin(cell) == CellStatus::outside) return;
    const Slope at = slopeAt(map, cell);
    const double slope = std::hypot(at.dx, at.dy);
    if (points > 0) {
      addInside(map, cell, static_cast<double>(points) / (kParts * kParts), slope, at.bend);
    }
    const double edge_mm = std::max(outline_mm, points == 0 ? 0 : openSides(map, cell) * s_);
    if (edge_mm > 0) addEdge(edge_mm, highestAround(map, cell), stretch(slope));
  }
  AreaResult piece() const {
    AreaResult piece = piece_;
    piece.not_measured = cells_ > 0 ? unmeasured_ / cells_ : 0;
    // The band all along, half a cell wide, is longer outside than the outline (Steiner's formula).
    const double corners_mm2 = has_edge_ ? std::numbers::pi / 4 * cell_mm2_ : 0;
    piece.area_off_mm2 += corners_mm2;
    piece.surface_off_mm2 += corners_mm2 * steepest_;
    piece.volume_off_mm3 += corners_mm2 * highest_mm_;
    return piece;
  }

 private:
  double above(double height_mm) const { return std::max(0.0, height_mm - plane_mm_); }

  void addInside(const MapPart& map, Cell cell, double part, double slope, double bend) {
    cells_ += part;
    if (map.origin(cell) != CellStatus::measured) unmeasured_ += part;
    const double mm2 = part * cell_mm2_;
    const auto height = static_cast<double>(map.heightMm(cell));
    const double error = map.heightErrorMm(cell);
    piece_.area_mm2 += mm2;
    piece_.surface_mm2 += mm2 * stretch(slope);
    piece_.volume_mm3 += mm2 * above(height);
    piece_.volume_off_mm3 += mm2 * (above(height + error) - above(height));
    // Two heights a cell to either side, both off: a slope off by error / s along x and along y.
    piece_.surface_off_mm2 +=
        mm2 * (stretch(slope + std::numbers::sqrt2 * error / s_) - stretch(slope));
    // What of the slope one side does not share may be a wall, with flatter ground beside it.
    const double wall = bend > 2 * error / s_ ? std::min(bend, slope) : 0;
    piece_.surface_off_mm2 += mm2 * (stretch(slope - wall) + wall - stretch(slope));
  }

  /// The edge may lie half a cell to either side.
  void addEdge(double length_mm, double highest_mm, double stretched) {
    has_edge_ = true;
    steepest_ = std::max(steepest_, stretched);
    highest_mm_ = std::max(highest_mm_, above(highest_mm));
    const double band_mm2 = 0.5 * s_ * length_mm;
    piece_.area_off_mm2 += band_mm2;
    piece_.surface_off_mm2 += band_mm2 * stretched;
    piece_.volume_off_mm3 += band_mm2 * above(highest_mm);
  }

  /// Of the 3 x 3 cells, with what they may be off: half a cell on may be the next one.
  static double highestAround(const MapPart& map, Cell at) {
    double highest = -std::numeric_limits<double>::infinity();
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        const Cell cell{.col = at.col + dc, .row = at.row + dr};
        if (!map.frame().size.contains(cell) || map.origin(cell) == CellStatus::outside) continue;
        highest =
            std::max(highest, static_cast<double>(map.heightMm(cell)) + map.heightErrorMm(cell));
      }
    }
    return highest;
  }

  double s_, cell_mm2_, plane_mm_;
  double cells_ = 0, unmeasured_ = 0;
  bool has_edge_ = false;
  double steepest_ = 0, highest_mm_ = 0;  ///< On the edge: stretch, and above the plane.
  AreaResult piece_;
};

}  // namespace

AreaResult areaResultOf(const MapCells& map, const std::vector<PlaceMm>& outline, double plane_mm) {
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
  OutlineLengths row_lengths(f, outline);
  for (int row = bottom; row <= top; row += kRowsAtOnce) {
    const int end = std::min(row + kRowsAtOnce, top + 1);
    const Cell first{.col = std::max(left - 1, 0), .row = std::max(row - 1, 0)};
    const MapPart part = map.part(first, {.cols = std::min(right + 2, f.size.cols) - first.col,
                                          .rows = std::min(end + 1, f.size.rows) - first.row});
    for (int r = row; r < end; ++r) {
      const std::vector<int>& counts = row_counts.of(r);
      const std::vector<double>& lengths_mm = row_lengths.of(r);
      for (int col = left; col <= right; ++col) {
        const auto i = static_cast<std::size_t>(col);
        sums.add(part, {.col = col, .row = r}, counts[i], lengths_mm[i]);
      }
    }
  }
  return sums.piece();
}

}  // namespace relievo
