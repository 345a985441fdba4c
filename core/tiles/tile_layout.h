// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "core/base/grid.h"
#include "core/cloud/scan.h"

namespace relievo {

inline constexpr int kTileSide = 256;  ///< Cells; 256 KiB of heights.

/// A grid cut into tiles of 256 x 256 cells, counted row by row from cell (0, 0); those at the far
/// borders may be smaller.
struct TileLayout {
  GridSize map;

  int across() const noexcept { return (map.cols + kTileSide - 1) / kTileSide; }
  int down() const noexcept { return (map.rows + kTileSide - 1) / kTileSide; }
  int count() const noexcept { return across() * down(); }

  Cell firstCell(int tile) const noexcept {
    return {.col = tile % across() * kTileSide, .row = tile / across() * kTileSide};
  }
  GridSize sizeOf(int tile) const noexcept {
    const Cell first = firstCell(tile);
    return {.cols = std::min(kTileSide, map.cols - first.col),
            .rows = std::min(kTileSide, map.rows - first.row)};
  }
  /// Is a cell of a tile, counted row by row, within so many cells of the tile's edge?
  bool isAtEdge(int tile, int cell, int cells) const noexcept {
    const GridSize size = sizeOf(tile);
    const int col = cell % size.cols, row = cell / size.cols;
    return col < cells || row < cells || col >= size.cols - cells || row >= size.rows - cells;
  }
};

/// A point in its tile: the cell (row by row in sizeOf(tile)), its place from the cell's sample in
/// cells, each in [-0.5, 0.5], and its view z in mm. Finite, and 0 rather than -0: else the order
/// of points would show.
struct CellPoint {
  float z = 0, du = 0, dv = 0;
  std::uint16_t cell = 0;
};

/// What the scan says of a point, likewise.
struct ValuePoint {
  float z = 0;
  Rgba colour{};
  std::uint16_t intensity = 0;
  std::uint16_t cell = 0;
};

/// One order for points that came in any: by cell, then height, then place.
inline bool comesBefore(const CellPoint& a, const CellPoint& b) noexcept {
  return std::tie(a.cell, a.z, a.du, a.dv) < std::tie(b.cell, b.z, b.du, b.dv);
}

/// And which tile that is.
template <class Point>
struct TilePointOf {
  std::uint32_t tile = 0;
  Point point;
};
using TilePoint = TilePointOf<CellPoint>;

}  // namespace relievo
