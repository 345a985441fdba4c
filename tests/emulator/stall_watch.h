// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

namespace relievo::emulator {

/// Sees that the computer was too busy for a device that must be asked a thousand times a second: a
/// thread of its own asks to be woken after each millisecond, and counts when that was late. What a
/// program does after such a stall, as stopping its forces, is right, and a person would try again;
/// what fails without one is the program's fault, and is not tried again.
class StallWatch {
 public:
  /// Falcon and loop take their first measure when an answer is so late.
  static constexpr std::chrono::milliseconds kStall{5};

  StallWatch() : thread_([this](const std::stop_token& stop) { watch(stop); }) {}
  StallWatch(const StallWatch&) = delete;
  StallWatch& operator=(const StallWatch&) = delete;

  /// Tries, and tries again where the computer stalled meanwhile. @param attempt  tells whether it
  /// succeeded. @return whether one of at most `attempts` did
  template <typename Attempt>
  bool repeatAfterStalls(int attempts, Attempt&& attempt) {
    for (int i = 0; i < attempts; ++i) {
      const std::uint64_t before = stalls_;
      if (attempt()) return true;
      if (stalls_ == before) return false;
    }
    return false;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void watch(const std::stop_token& stop) {
    constexpr std::chrono::milliseconds kNap{1};
    while (!stop.stop_requested()) {
      const Clock::time_point slept_at = Clock::now();
      std::this_thread::sleep_for(kNap);
      if (Clock::now() - slept_at - kNap >= kStall) ++stalls_;
    }
  }

  std::atomic<std::uint64_t> stalls_ = 0;
  std::jthread thread_;  ///< Last: it uses what is above it.
};

}  // namespace relievo::emulator
