// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: the same bits in every build.
#include "core/pyramid/row_reducer.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

#include "core/pyramid/halve.h"
#include "core/pyramid/kernel.h"

namespace relievo {

struct RowReducer::Impl {
  Impl(GridSize size, double factor_m)
      : fine(size),
        coarse{.cols = reducedCount(size.cols, factor_m),
               .rows = reducedCount(size.rows, factor_m)},
        factor(factor_m) {
    if (factor == 2) {
      halving.emplace(fine.cols);
      return;
    }
    rows = tapsOfAxis(fine.rows, factor);
    cols = tapsOfAxis(fine.cols, factor);
    before = -cols.front().first;
    const Taps& end = cols.back();
    after = std::max(0, end.first + static_cast<int>(end.weights.size()) - fine.cols);
    padded.resize(static_cast<std::size_t>(before) + static_cast<std::size_t>(fine.cols) +
                  static_cast<std::size_t>(after));
  }

  Taps tapsOfRow(int row) const {
    return factor == 2 ? tapsAt(2.0 * row, factor) : rows[static_cast<std::size_t>(row)];
  }

  void sumRows(const Taps& taps, const RowAt& row_at, double* sum) const {
    std::fill(sum, sum + fine.cols, 0.0);
    for (std::size_t k = 0; k < taps.weights.size(); ++k) {
      const float* from = row_at(mirrored(taps.first + static_cast<int>(k), fine.rows));
      const double weight = taps.weights[k];
      for (int i = 0; i < fine.cols; ++i) sum[i] += weight * static_cast<double>(from[i]);
    }
  }

  /// The kernel is separable: first down the columns, whole rows at a time, then along the one row
  /// that is left.
  void reduceByGaussian(int row, const RowAt& row_at, float* out) {
    double* sum = padded.data() + before;
    sumRows(rows[static_cast<std::size_t>(row)], row_at, sum);
    for (int i = 1; i <= before; ++i) sum[-i] = sum[mirrored(-i, fine.cols)];
    for (int i = fine.cols; i < fine.cols + after; ++i) sum[i] = sum[mirrored(i, fine.cols)];
    for (int i = 0; i < coarse.cols; ++i) {
      const Taps& at = cols[static_cast<std::size_t>(i)];
      out[i] = static_cast<float>(
          std::inner_product(at.weights.begin(), at.weights.end(), sum + at.first, 0.0));
    }
  }

  GridSize fine, coarse;
  double factor;
  std::optional<RowHalver> halving;  ///< For M = 2.
  std::vector<Taps> rows, cols;      ///< For other M.
  int before = 0, after = 0;
  std::vector<double> padded;
};

RowReducer::RowReducer(GridSize fine, double factor)
    : impl_(std::make_unique<Impl>(fine, factor)) {}
RowReducer::~RowReducer() = default;

GridSize RowReducer::coarseSize() const noexcept {
  return impl_->coarse;
}

int RowReducer::mostRows() const {
  int most = 1;
  for (int row = 0; row < coarseSize().rows; ++row) {
    const Rows rows = rowsFor(row);
    most = std::max(most, rows.end - rows.first);
  }
  return most;
}

RowReducer::Rows RowReducer::rowsFor(int row) const {
  const Taps taps = impl_->tapsOfRow(row);
  const int rows = impl_->fine.rows;
  Rows needed{.first = rows, .end = 0};
  for (int k = 0; k < static_cast<int>(taps.weights.size()); ++k) {
    const int from = mirrored(taps.first + k, rows);
    needed.first = std::min(needed.first, from);
    needed.end = std::max(needed.end, from + 1);
  }
  return needed;
}

void RowReducer::reduce(int row, const RowAt& row_at, float* out) {
  if (impl_->halving) {
    FiveRows rows{};
    for (int n = 0; n < 5; ++n) {
      rows[static_cast<std::size_t>(n)] = row_at(mirrored(2 * row - 2 + n, impl_->fine.rows));
    }
    (*impl_->halving)(rows, {rows[3], rows[4]}, out);
  } else {
    impl_->reduceByGaussian(row, row_at, out);
  }
}

}  // namespace relievo
