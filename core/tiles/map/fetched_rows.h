// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/grid.h"
#include "core/tiles/tile_cache.h"
#include "core/tiles/tile_layout.h"

namespace relievo {

/// Rows of one band put together from tiles; the tiles of the last row of tiles stay at hand.
template <class Cell>
class FetchedRows {
 public:
  using Fetch = std::function<TileCache::Tile(int tile)>;
  FetchedRows(GridSize size, Fetch fetch) : size_(size), fetch_(std::move(fetch)) {}

  const Cell* operator()(int row, int first_col, int count) {
    const int file_row = size_.rows - 1 - row;
    const int first = first_col / kTileSide;
    const int last = (first_col + count - 1) / kTileSide;
    load(file_row / kTileSide, first, last);
    const auto line = static_cast<std::ptrdiff_t>(file_row % kTileSide) * kTileSide;
    if (first == last) return cells(0) + line + first_col % kTileSide;
    line_.resize(static_cast<std::size_t>(count));
    for (int tile = first; tile <= last; ++tile) {
      const int from = std::max(first_col, tile * kTileSide);
      const int to = std::min(first_col + count, (tile + 1) * kTileSide);
      std::copy_n(cells(tile - first) + line + from % kTileSide, to - from,
                  line_.data() + (from - first_col));
    }
    return line_.data();
  }

 private:
  const Cell* cells(int place) const {
    return reinterpret_cast<const Cell*>(held_[static_cast<std::size_t>(place)]->data());
  }
  void load(int tile_row, int first, int last) {
    if (tile_row == tile_row_ && first == first_ && last == last_) return;
    held_.clear();
    const int across = TileLayout{size_}.across();
    for (int tile = first; tile <= last; ++tile) held_.push_back(fetch_(tile_row * across + tile));
    tile_row_ = tile_row;
    first_ = first;
    last_ = last;
  }

  GridSize size_;
  Fetch fetch_;
  std::vector<TileCache::Tile> held_;
  int tile_row_ = -1, first_ = -1, last_ = -1;
  std::vector<Cell> line_;
};

}  // namespace relievo
