// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/fill/fill.h"

namespace relievo {

/// The 4-connected areas of empty cells of a mask that comes row by row, lowest first, kept as runs
/// of cells: emptyAreas of core/depth for maps whose labels would not fit into memory.
class EmptyRuns {
 public:
  explicit EmptyRuns(GridSize size) : size_(size) {}

  /// The next row of the mask, 0 where empty. After the last one call `join`.
  void addRow(const std::uint8_t* mask);
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

  std::size_t bytes() const noexcept {
    return runs_.capacity() * sizeof(Run) + parents_.capacity() * sizeof(std::uint32_t);
  }

 private:
  std::uint32_t rootOf(std::uint32_t run);
  void unite(std::uint32_t a, std::uint32_t b);

  GridSize size_;
  std::vector<Run> runs_;
  std::vector<std::size_t> row_starts_{0};
  std::vector<std::uint32_t> parents_;  ///< Of runs; the smaller number is the parent.
  std::uint32_t areas_ = 0;
};

}  // namespace relievo
