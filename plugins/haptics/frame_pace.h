// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>

namespace relievo {

/// How often the plugin looks at its loop: 60 times a second, and 8 times while there is nothing to
/// see. [GUI thread]
class FramePace {
 public:
  static constexpr int kFrameMs = 16;
  static constexpr int kFramesAtRest = 8;  ///< One look at rest takes the place of so many.
  static constexpr int kFramesUntilRest = 60;

  QTimer& timer() noexcept { return timer_; }
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
    if (!isAtRest() && ++quiet_frames_ >= kFramesUntilRest) timer_.start(kFrameMs * kFramesAtRest);
  }
  /// Somebody has done something.
  void wake() {
    if (isAtRest()) timer_.start(kFrameMs);
    quiet_frames_ = 0;
  }

 private:
  QTimer timer_;
  int quiet_frames_ = 0;
};

}  // namespace relievo
