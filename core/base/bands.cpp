// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/bands.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

#include "core/base/control_group.h"

namespace relievo {
namespace {

constexpr std::size_t kCellsWorthAThread = 500'000;
constexpr int kMostThatPay = 4;  // Memory is the limit; more threads only take turns at it.

}  // namespace

int threadsFor(std::size_t cells, int wanted) {
  if (wanted > 0) return wanted;
  const auto worth = static_cast<int>(std::min<std::size_t>(cells / kCellsWorthAThread, 64));
  static const int cores = usableCores();
  return std::clamp(worth, 1, std::min(cores, kMostThatPay));
}

void parallelFor(int rows, int threads, const std::function<void(int first, int end)>& work) {
  const auto count = static_cast<std::size_t>(std::clamp(threads, 1, std::max(rows, 1)));
  std::vector<std::exception_ptr> errors(count);
  const auto band = [&](std::size_t k) noexcept {
    const auto edge = [&](std::size_t i) {
      return static_cast<int>(static_cast<std::size_t>(rows) * i / count);
    };
    try {
      work(edge(k), edge(k + 1));
    } catch (...) {
      errors[k] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < count; ++k) others.emplace_back(band, k);
    band(0);
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace relievo
