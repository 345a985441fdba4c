// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/row_splats.h"

#include <algorithm>
#include <cmath>

namespace relievo {

void RowSplats::compute(const RowPoints& rows, int first_row, int end_row) {
  const int first = std::max(first_row - 1, rows.first_row);
  const int end = std::min(end_row + 1, rows.end_row);
  first_row_ = first_row - 2;
  stride_ = static_cast<std::size_t>(rows.cols) + 2;
  sums_.assign(static_cast<std::size_t>(end_row + 2 - first_row_) * stride_, {});
  // Cell after cell and row after row, so that a sample's points come in the same order whichever
  // rows are asked for together.
  for (int row = first; row < end; ++row) {
    for (int col = 0; col < rows.cols; ++col) {
      Sum* const here = &sums_[index(col, row)];
      for (const PlacedPoint& p : rows.of(col, col + 1, row)) {
        const double u = std::abs(static_cast<double>(p.du));
        const double v = std::abs(static_cast<double>(p.dv));
        const auto z = static_cast<double>(p.z);
        Sum* const beside = p.du < 0 ? here - 1 : here + 1;
        const std::ptrdiff_t across =
            p.dv < 0 ? -static_cast<std::ptrdiff_t>(stride_) : static_cast<std::ptrdiff_t>(stride_);
        const auto add = [z](Sum& sum, double weight) {
          sum.weights += weight;
          sum.heights += weight * z;
        };
        add(*here, (1 - u) * (1 - v));
        add(*beside, u * (1 - v));
        add(here[across], (1 - u) * v);
        add(beside[across], u * v);
      }
    }
  }
}

}  // namespace relievo
