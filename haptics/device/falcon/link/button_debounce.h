// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace relievo::falcon {

inline constexpr std::uint32_t kAllButtons = 0b1111;

/// Buttons out of what single answers say of them: one that bounces is pressed once. [link]
class ButtonDebounce {
 public:
  std::uint32_t down() const { return down_; }

  /// Of one answer. @return those that are down
  std::uint32_t take(std::uint8_t raw) {
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      const std::uint32_t bit = 1U << i;
      const bool held_over = (held_over_ & bit) != 0;
      const bool differs = held_over ? (raw & bit) == 0 : (raw & bit) != (down_ & bit);
      answers_[i] = differs ? static_cast<std::uint8_t>(answers_[i] + 1) : 0;
      if (answers_[i] < kSure) continue;
      (held_over ? held_over_ : down_) ^= bit;
      answers_[i] = 0;
    }
    return down_;
  }
  /// Answers were missed: it is counted anew. What is down stays: a release is only what was read
  /// as one.
  void interrupt() { answers_ = {}; }
  /// After more than a short interruption nobody knows what was done with them meanwhile: none is
  /// down, and one that is held now counts only after it was let go.
  void forget() {
    down_ = 0;
    held_over_ = kAllButtons;
    answers_ = {};
  }

 private:
  static constexpr int kSure = 3;  // In a row.

  std::uint32_t down_ = 0, held_over_ = kAllButtons;
  std::array<std::uint8_t, 4> answers_{};  // In a row, that differ from what is known.
};

}  // namespace relievo::falcon
