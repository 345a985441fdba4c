// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace relievo {

/// What is remembered of the points of one cell. Adding points and merging states are associative
/// and commutative down to the last bit, the sum being a whole number: any order, any grouping and
/// any number of threads give the same state.
struct CellState {
  static constexpr float kLowest = -std::numeric_limits<float>::infinity();

  float first = kLowest, second = kLowest;  ///< The two highest; second stays lowest for one point.
  std::uint32_t count = 0;
  std::int64_t sum = 0;  ///< Of the heights, in TileStoreOptions::sum_unit_mm.

  void add(float z, std::int64_t units) noexcept {
    second = std::max(second, std::min(first, z));
    first = std::max(first, z);
    sum += units;
    ++count;
  }
  void merge(const CellState& other) noexcept {
    second = std::max({second, other.second, std::min(first, other.first)});
    first = std::max(first, other.first);
    sum += other.sum;
    count += other.count;
  }
};

}  // namespace relievo
