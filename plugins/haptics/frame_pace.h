// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QTimer>
#include <utility>

namespace relievo {

/// How often the plugin looks at its loop: 60 times a second, and 4 times while there is nothing to
/// see. [GUI thread]
class FramePace {
 public:
  static constexpr int kFrameMs = 16;
  static constexpr int kFramesAtRest = 16;  ///< One look at rest takes the place of so many.
  static constexpr int kFramesUntilRest = 60;

  QTimer& timer() noexcept { return timer_; }
  /// Called whenever rest begins and ends.
  void onRest(std::function<void(bool at_rest)> told) { told_ = std::move(told); }
  void start() {
    quiet_frames_ = 0;
    timer_.start(kFrameMs);
  }
  void stop() { timer_.stop(); }
  bool isAtRest() const { return quiet_frames_ >= kFramesUntilRest; }
  /// How many frames the present look stands for.
  int framesOfLook() const { return isAtRest() ? kFramesAtRest : 1; }
  /// After each look. @param busy  something has changed, or may at any moment without a word
  void follow(bool busy) {
    if (busy) return wake();
    if (isAtRest() || ++quiet_frames_ < kFramesUntilRest) return;
    timer_.start(kFrameMs * kFramesAtRest);
    if (told_) told_(true);
  }
  /// Somebody has done something.
  void wake() {
    if (!isAtRest()) {
      quiet_frames_ = 0;
      return;
    }
    quiet_frames_ = 0;
    timer_.start(kFrameMs);
    if (told_) told_(false);
  }

 private:
  QTimer timer_;
  std::function<void(bool)> told_;
  int quiet_frames_ = 0;
};

}  // namespace relievo
