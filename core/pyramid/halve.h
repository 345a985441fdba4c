// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/grid.h"
#include "core/base/large_array.h"
#include "core/base/origin.h"
#include "core/base/task.h"

namespace relievo {

using FiveRows = std::array<const float*, 5>;
using TwoRows = std::array<const float*, 2>;

/// One row of the step below: from the finer rows 2j - 2 ... 2j + 2, mirrored at the border.
class RowHalver {
 public:
  explicit RowHalver(int cols);
  /// @param next  the two rows beyond them, if they are needed next; any rows do
  /// @param out  (cols + 1) / 2 values. One thread at a time
  void operator()(const FiveRows& rows, const TwoRows& next, float* out);

 private:
  int cols_;
  std::vector<float> padded_, even_, odd_;
};

/// The same step for the share of measured cells, from the origins of the finest level: whole
/// numbers up to 256 at a quarter of the bytes, so exactly what `halved` makes of 0 and 1. [worker]
/// @throw Cancelled
LargeArray<float> halvedShares(std::span<const CellStatus> origins, GridSize size,
                               GridSize out_size, int threads, const Task& task);

/// One step of the pyramid for M = 2 in single precision, at memory speed: the paper's equation
///   g_l(i, j) = sum_m sum_n w(m, n) g_{l-1}(2i + m, 2j + n)
/// with w = (1 4 6 4 1)/16 each way. The same bytes for every number of threads and processor.
/// @param out_size  half of `size`, rounded up @param threads  0: as many as pay [worker]
/// @throw Cancelled
LargeArray<float> halved(std::span<const float> in, GridSize size, GridSize out_size, int threads,
                         const Task& task);

}  // namespace relievo
