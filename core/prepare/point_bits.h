// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace relievo {

/// One bit for every point: does it stay? Bits beyond the last point are 0.
class PointBits {
 public:
  PointBits() = default;
  /// All set.
  explicit PointBits(std::size_t points)
      : words_((points + 63) / 64, ~std::uint64_t{0}), points_(points) {
    if (points % 64 != 0) words_.back() = (std::uint64_t{1} << (points % 64)) - 1;
  }

  std::size_t size() const noexcept { return points_; }
  bool operator[](std::size_t point) const noexcept {
    return (words_[point / 64] >> (point % 64) & 1U) != 0;
  }
  void clear(std::size_t point) noexcept {
    words_[point / 64] &= ~(std::uint64_t{1} << (point % 64));
  }
  std::size_t count() const noexcept {
    std::size_t ones = 0;
    for (const std::uint64_t word : words_) ones += static_cast<std::size_t>(std::popcount(word));
    return ones;
  }

  std::vector<std::uint64_t>& words() noexcept { return words_; }
  const std::vector<std::uint64_t>& words() const noexcept { return words_; }
  friend bool operator==(const PointBits&, const PointBits&) = default;

 private:
  std::vector<std::uint64_t> words_;
  std::size_t points_ = 0;
};

}  // namespace relievo
