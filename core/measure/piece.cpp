// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/piece.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

constexpr int kParts = 4;

bool isInside(const std::vector<PlaceMm>& outline, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const PlaceMm a = outline[i];
    const PlaceMm b = outline[j];
    if ((a.y > y) == (b.y > y)) continue;
    if (x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

double sharePart(const std::vector<PlaceMm>& outline, double x, double y, double spacing) {
  int inside = 0;
  for (int i = 0; i < kParts; ++i) {
    for (int j = 0; j < kParts; ++j) {
      const double dx = (i + 0.5) / kParts - 0.5;
      const double dy = (j + 0.5) / kParts - 0.5;
      if (isInside(outline, x + dx * spacing, y + dy * spacing)) ++inside;
    }
  }
  return static_cast<double>(inside) / (kParts * kParts);
}

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
  for (int row = 0; row < map.frame.size.rows; ++row) {
    for (int col = 0; col < map.frame.size.cols; ++col) {
      const Cell cell{.col = col, .row = row};
      if (map.origin(cell) == Origin::outside) continue;
      const double part = sharePart(outline, map.frame.xMm(col), map.frame.yMm(row), s);
      if (part == 0) continue;
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
