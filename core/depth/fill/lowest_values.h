// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace relievo {

class Exchange;

/// A low quantile of values that come in pieces: only the lowest are kept. With linear
/// interpolation between order statistics, position q (n - 1).
class LowestValues {
 public:
  /// @param count  of values that are not NaN, known beforehand @param q  [0, 1]; memory grows with
  ///               q count
  /// @throw ArgumentError  count is 0
  LowestValues(std::size_t count, double q);

  /// NaN are left out. [any thread]
  void add(std::span<const float> values);

  /// After all `count` values were added, each by one of the processes. [owner]
  double quantile(Exchange& processes);

 private:
  void prune(std::vector<float>& values) const;
  float kth(std::size_t k, Exchange& processes) const;

  double position_ = 0;
  std::size_t kept_ = 0;      ///< As many of the lowest are needed.
  std::atomic<float> limit_;  ///< Nothing above it is needed.
  std::mutex adds_;           ///< For `lowest_`, in any order: values are counted.
  std::vector<float> lowest_;
};

}  // namespace relievo
