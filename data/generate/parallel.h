// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace relievo::samples {

/// Calls `work(i)` for 0 <= i < count on all cores. Each call may write to its own place only.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
  const std::size_t parts = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> threads;
  for (std::size_t part = 0; part < parts; ++part) {
    threads.emplace_back([=, &work] {
      for (std::size_t i = count * part / parts; i < count * (part + 1) / parts; ++i) work(i);
    });
  }
}

}  // namespace relievo::samples
