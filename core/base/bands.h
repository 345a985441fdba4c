// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "core/base/grid.h"

namespace relievo {

/// Threads that pay for work on `cells` cells: one below about 1000^2, where starting another
/// costs more than it saves. @param wanted  0: as many as pay; else exactly these
int threadsFor(std::size_t cells, int wanted);

/// Calls work(first, end) for `threads` bands of 0 ... rows - 1, one of them on this thread, and
/// waits for all. What `work` throws on any thread is thrown here.
void parallelFor(int rows, int threads, const std::function<void(int first, int end)>& work);

}  // namespace relievo
