// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace relievo {

class Exchange;

/// A low quantile of values that come in pieces: only the lowest are kept. With linear
/// interpolation between order statistics, position q (n - 1), as in fillDepths.
class LowestValues {
 public:
  /// @param count  of values that are not NaN, known beforehand @param q  [0, 1]; memory grows with
  ///               q count
  /// @throw ArgumentError  count is 0
  LowestValues(std::size_t count, double q);

  /// NaN are left out.
  void add(const std::vector<float>& values);

  /// After all `count` values were added, each by one of the processes.
  double quantile(Exchange& processes);

 private:
  void prune();
  float kth(std::size_t k, Exchange& processes) const;

  double position_ = 0;
  std::size_t kept_ = 0;  ///< As many of the lowest are needed.
  float limit_;           ///< Nothing above it is needed.
  std::vector<float> lowest_;
};

}  // namespace relievo
