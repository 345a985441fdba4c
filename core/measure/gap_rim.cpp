// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/gap_rim.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo {
namespace {

constexpr int kFirstReach = 8, kMostReach = 512;  // Cells; most gaps are a few wide.

struct Way {
  int cols = 0, rows = 0;
};
constexpr std::array<Way, 8> kWays{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

bool isRim(CellStatus origin) {
  return origin == CellStatus::measured || origin == CellStatus::steep;
}

/// What the ways of at most `reach` cells met.
struct Rim {
  double most_mm = 0;
  bool ended = true;  ///< Each of them left the gap.
};

Rim rimWithin(const MapPart& part, Cell from, int reach) {
  const auto height = static_cast<double>(part.heightMm(from));
  Rim rim;
  for (const Way& way : kWays) {
    bool left = false;
    for (int i = 1; i <= reach && !left; ++i) {
      const Cell at{.col = from.col + i * way.cols, .row = from.row + i * way.rows};
      left = !part.frame().size.contains(at) || part.origin(at) != CellStatus::interpolated;
      if (!left || !part.frame().size.contains(at) || !isRim(part.origin(at))) continue;
      rim.most_mm =
          std::max(rim.most_mm, std::abs(static_cast<double>(part.heightMm(at)) - height));
    }
    rim.ended = rim.ended && left;
  }
  return rim;
}

MapPart around(const MapCells& map, Cell cell, int reach) {
  const GridSize size = map.frame().size;
  const Cell first{.col = std::max(cell.col - reach, 0), .row = std::max(cell.row - reach, 0)};
  return map.part(first, {.cols = std::min(cell.col + reach + 1, size.cols) - first.col,
                          .rows = std::min(cell.row + reach + 1, size.rows) - first.row});
}

}  // namespace

double gapRimMm(const MapCells& map, Cell cell) {
  if (around(map, cell, 0).origin(cell) != CellStatus::interpolated) return 0;
  Rim rim;
  for (int reach = kFirstReach; reach <= kMostReach; reach *= kFirstReach) {
    rim = rimWithin(around(map, cell, reach), cell, reach);
    if (rim.ended) break;
  }
  return rim.most_mm;
}

}  // namespace relievo
