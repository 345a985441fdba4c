// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/piece.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

constexpr int kParts = 4;

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
      for (int k = from; k < to; ++k) ++counts_[static_cast<std::size_t>(k / kParts)];
    }
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
double stretch(const DepthMap& map, Cell at) {
  const auto slope = [&](int dc, int dr) {
    const Cell before{.col = at.col - dc, .row = at.row - dr};
    const Cell after{.col = at.col + dc, .row = at.row + dr};
    const auto usable = [&](Cell c) {
      return map.frame.size.contains(c) && map.origin(c) != Origin::outside;
    };
    const Cell from = usable(before) ? before : at;
    const Cell to = usable(after) ? after : at;
    const int steps = (to == at ? 0 : 1) + (from == at ? 0 : 1);
    if (steps == 0) return 0.0;
    return static_cast<double>(map.heightMm(to) - map.heightMm(from)) /
           (steps * map.frame.spacing_mm);
  };
  return std::sqrt(1 + std::pow(slope(1, 0), 2) + std::pow(slope(0, 1), 2));
}

}  // namespace

Piece pieceOf(const DepthMap& map, const std::vector<PlaceMm>& outline, double plane_mm) {
  Piece piece;
  const double s = map.frame.spacing_mm;
  const double cell_mm2 = s * s;
  double cells = 0;
  double unmeasured = 0;
  RowCounts row_counts(map.frame, outline);
  for (int row = 0; row < map.frame.size.rows; ++row) {
    const std::vector<int>& counts = row_counts.of(row);
    for (int col = 0; col < map.frame.size.cols; ++col) {
      const Cell cell{.col = col, .row = row};
      const int points = counts[static_cast<std::size_t>(col)];
      if (points == 0 || map.origin(cell) == Origin::outside) continue;
      const double part = static_cast<double>(points) / (kParts * kParts);
      const double above = std::max(0.0, static_cast<double>(map.heightMm(cell)) - plane_mm);
      const double stretched = stretch(map, cell);
      cells += part;
      if (map.origin(cell) != Origin::measured) unmeasured += part;
      piece.area_mm2 += part * cell_mm2;
      piece.surface_mm2 += part * cell_mm2 * stretched;
      piece.volume_mm3 += part * cell_mm2 * above;
      if (part < 1) {  // On the outline, which may lie half a cell to either side.
        piece.area_off_mm2 += 0.5 * cell_mm2;
        piece.surface_off_mm2 += 0.5 * cell_mm2 * stretched;
        piece.volume_off_mm3 += 0.5 * cell_mm2 * above;
      }
    }
  }
  piece.not_measured = cells > 0 ? unmeasured / cells : 0;
  return piece;
}

}  // namespace relievo
