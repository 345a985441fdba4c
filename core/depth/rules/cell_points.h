// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/depth_request.h"

namespace relievo {

/// A point in its cell: its place from the cell's sample, in cells, each in [-0.5, 0.5], and its
/// view z in mm.
struct PlacedPoint {
  float du, dv, z;  // Without initial values: millions are made only to be overwritten.
};

/// The points of some rows of the grid, sorted by cell; within a cell in the file's order.
struct RowPoints {
  int first_row = 0, end_row = 0, cols = 0;
  std::vector<std::uint32_t> starts;  ///< Per cell of these rows its first point, and the end.
  std::vector<PlacedPoint> points;

  std::size_t cell(int col, int row) const noexcept {
    return static_cast<std::size_t>(row - first_row) * static_cast<std::size_t>(cols) +
           static_cast<std::size_t>(col);
  }
  /// Points of the cells first_col ... end_col - 1 of a row.
  std::span<const PlacedPoint> of(int first_col, int end_col, int row) const noexcept {
    const std::size_t first = starts[cell(first_col, row)];
    const std::size_t end = starts[cell(end_col - 1, row) + 1];
    return {points.data() + first, end - first};
  }
  std::size_t count(int first_col, int end_col, int row) const noexcept {
    return starts[cell(end_col - 1, row) + 1] - starts[cell(first_col, row)];
  }
};

struct RowRange {
  int first = 0, end = 0;
};

/// The points in some rows of a request's grid: read once, then handed out a few rows at a time, so
/// that what is worked on fits into the cache. Keeps 16 bytes a point. The order of the points and
/// so every result is the same for any number of threads.
class CellPoints {
 public:
  /// @param ranges  rows that will be asked for
  /// @param used_up  others, whose memory is taken over; null: none [worker] @throw Cancelled
  CellPoints(const DepthRequest& request, std::span<const RowRange> ranges, const Task& task,
             CellPoints* used_up = nullptr);

  /// Rows [first_row, end_row), clamped to the grid; `out` is overwritten, its memory reused.
  /// [any thread]
  void rows(int first_row, int end_row, RowPoints& out) const;

  std::size_t count() const noexcept { return count_; }

 private:
  struct Record {
    std::uint32_t cell;  ///< Within its bucket of rows.
    PlacedPoint point;
  };
  struct Block;
  class Part;
  /// Memory for records, used from its beginning.
  struct Room {
    std::unique_ptr<Record[]> records;
    std::size_t capacity = 0;
  };
  using Run = std::span<const Record>;

  GridSize size_;
  std::vector<std::vector<Run>> buckets_;  ///< Of rows: their records, in the file's order.
  std::vector<std::vector<Room>> rooms_;   ///< Of each thread that filled them.
  std::size_t count_ = 0;
};

}  // namespace relievo
