// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "core/base/grid.h"

namespace relievo {

/// One step of the pyramid, paper sec. 5, row by row from wherever the finer rows are: a level in
/// memory, or the few rows of a stream. A row has the same bytes whoever asks for it.
class RowReducer {
 public:
  /// The finer row of a number, 0 ... rows - 1; valid until the next call of reduce.
  using RowAt = std::function<const float*(int row)>;

  /// @param factor  the paper's M, in (1, 8]
  RowReducer(GridSize fine, double factor);
  ~RowReducer();
  RowReducer(const RowReducer&) = delete;
  RowReducer& operator=(const RowReducer&) = delete;

  GridSize coarseSize() const noexcept;

  /// The finer rows that coarser row `row` is made of: first ... end - 1.
  struct Rows {
    int first = 0, end = 0;
  };
  Rows rowsFor(int row) const;
  /// The most that any coarser row is made of.
  int mostRows() const;

  /// @param out  coarseSize().cols values. Uses buffers of its own: one thread at a time
  void reduce(int row, const RowAt& row_at, float* out);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
