// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace relievo::haply {

/// Which questions are without an answer, and when that is silence: after 5 ms zero is sent, at
/// 20 ms the forces are off, at 500 ms the session is given up. No clock of its own. [device
/// thread]
class Questions {
 public:
  static constexpr std::array<std::int64_t, 3> kSilenceNs{5'000'000, 20'000'000, 500'000'000};
  static constexpr std::int64_t kStallNs = kSilenceNs[1];

  void restart(std::int64_t now_ns) {
    asked_ns_ = now_ns;
    under_way_ = step_ = 0;
  }
  /// One goes out, and silence begins now.
  void ask(std::int64_t now_ns) {
    asked_ns_ = now_ns;
    step_ = 0;
    ++under_way_;
  }
  /// A message goes with it that is answered, too.
  void add() { ++under_way_; }
  void answer() { under_way_ = std::max(0, under_way_ - 1); }
  /// The measure against silence that is due, from 0.
  int nextMeasure() { return step_++; }

  int underWay() const { return under_way_; }
  std::int64_t askedNs() const { return asked_ns_; }
  /// When the next measure is due.
  std::int64_t silentAt() const { return asked_ns_ + kSilenceNs[static_cast<std::size_t>(step_)]; }

 private:
  std::int64_t asked_ns_ = 0;
  int under_way_ = 0;  // Without an answer.
  int step_ = 0;       // How far the measures have gone.
};

}  // namespace relievo::haply
