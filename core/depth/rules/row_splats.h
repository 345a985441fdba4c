// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/depth/rules/cell_points.h"

namespace relievo {

/// Means with bilinear weights of the points less than one sample distance away, in x and in y, for
/// some rows of cells at once: every point adds to the four samples around it. One per thread.
class RowSplats {
 public:
  /// Rows first_row ... end_row - 1; `rows` must reach one row beyond or to the grid's border.
  void compute(const RowPoints& rows, int first_row, int end_row);

  /// Nothing where no point is near.
  std::optional<double> at(int col, int row) const noexcept {
    const Sum& sum = sums_[index(col, row)];
    if (!(sum.weights > 0)) return std::nullopt;
    return sum.heights / sum.weights;
  }

 private:
  struct Sum {
    double weights = 0, heights = 0;
  };
  std::size_t index(int col, int row) const noexcept {
    return static_cast<std::size_t>(row - first_row_) * stride_ + static_cast<std::size_t>(col + 1);
  }

  int first_row_ = 0;       ///< One before those asked for: points add to both sides unasked.
  std::size_t stride_ = 0;  ///< The columns and one more on both sides.
  std::vector<Sum> sums_;
};

}  // namespace relievo
