// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/depth/rules/cell_points.h"

namespace relievo {

/// The local quadratics of `LocalFit` for a piece of a row at once, each over the 5 x 5 cells
/// around: sums of powers in every cell, then down the columns, then along the row, then eight
/// systems of equations side by side. About ten times as fast, but no point is left out and no
/// window shrinks: where `rms_mm` is too large for the noise, or `fitted` is 0, ask `LocalFit`. One
/// per thread.
class RowFits {
 public:
  /// Computes the fits of columns first_col ... end_col - 1 of one row; a few hundred at a time
  /// stay in the cache. The rows must reach `kReach` beyond it or to the grid's border.
  /// @param first  the first row asked for of these `rows` and columns; the others follow in turn
  void compute(const RowPoints& rows, int row, int first_col, int end_col, bool first);

  bool fitted(int col) const noexcept { return fitted_[index(col)] != 0; }
  double heightMm(int col) const noexcept { return heights_mm_[index(col)]; }
  double rmsMm(int col) const noexcept { return rms_mm_[index(col)]; }

  static constexpr int kReach = 2;
  static constexpr std::size_t kSums = 22;  ///< Of u^a v^b (a + b <= 4), z u^a v^b (<= 2), z^2.
  static constexpr double kFewest = 12;     ///< Points of a window.

 private:
  std::size_t index(int col) const noexcept { return static_cast<std::size_t>(col - first_col_); }
  static constexpr int kRows = 2 * kReach + 1;
  /// Of the sums of a row, -kReach or above.
  static std::size_t placeOf(int row) noexcept {
    return static_cast<std::size_t>((row + kRows) % kRows);
  }
  void resize(int cols);
  void sumCells(const RowPoints& rows, int row, int end_col);

  int first_col_ = 0;
  std::size_t stride_ = 0;  ///< Of a plane: the columns and kReach more on both sides, padded.
  std::array<std::vector<double>, kRows> cells_;  ///< Of row r in place r mod kRows: kSums planes,
                                                  ///< u and v from the cell.
  std::vector<double> columns_;  ///< kSums planes: sums down the columns, u from the column's cell.
  std::vector<double> windows_;  ///< kSums planes: sums over the windows, u from the window's cell.
  std::vector<double> heights_mm_, rms_mm_;
  std::vector<double> fitted_;
};

}  // namespace relievo
