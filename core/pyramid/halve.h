// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"

namespace relievo {

/// One step of the pyramid for M = 2 in single precision, at memory speed: the paper's equation
///   g_l(i, j) = sum_m sum_n w(m, n) g_{l-1}(2i + m, 2j + n)
/// with w = (1 4 6 4 1)/16 each way. The same bytes for every number of threads and processor.
/// @param out_size  half of `size`, rounded up @param threads  0: as many as pay [worker]
/// @throw Cancelled
std::vector<float> halved(const std::vector<float>& in, GridSize size, GridSize out_size,
                          int threads, const Task& task);

}  // namespace relievo
