// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/fill/fill.h"

namespace relievo {

/// The 4-connected areas of empty cells of a mask that comes row by row, lowest first, kept as runs
/// of cells: labels of all cells would not fit into memory.
class EmptyRuns {
 public:
  explicit EmptyRuns(GridSize size) : size_(size) {}

  /// The next rows of the mask, 0 where empty. After the last one call `join`.
  /// @param packed  as packedRows gives them
  void addRows(std::string_view packed);
  void join();

  /// A run of empty cells of one row, and the number of its area.
  struct Run {
    int first_col = 0, end_col = 0;
    std::uint32_t area = 0;
  };
  std::span<const Run> row(int row) const noexcept;

  /// Enclosed areas as holes, largest first, and per area the index of its hole, -1 if it touches
  /// the border of the grid.
  struct Enclosed {
    std::vector<Hole> holes;
    std::vector<std::ptrdiff_t> hole_of_area;
  };
  Enclosed enclosed(const GridFrame& frame) const;
  /// Cells of all areas.
  std::size_t emptyCells() const noexcept { return empty_cells_; }

  std::size_t bytes() const noexcept {
    return runs_.capacity() * sizeof(Run) + parents_.capacity() * sizeof(std::uint32_t);
  }

 private:
  void addRow(const std::vector<std::uint64_t>& words);
  std::uint32_t rootOf(std::uint32_t run);
  void unite(std::uint32_t a, std::uint32_t b);

  GridSize size_;
  std::vector<Run> runs_;
  std::vector<std::size_t> row_starts_{0};
  std::vector<std::uint32_t> parents_;  ///< Of runs; the smaller number is the parent.
  std::uint32_t areas_ = 0;
  std::size_t empty_cells_ = 0;
};

}  // namespace relievo
