// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

namespace relievo {

/// Whether a program that ended unexpectedly is started again: at once, but not without end. Time
/// is an argument, in seconds from anywhere. [one thread]
class RestartRule {
 public:
  static constexpr int kMostEnds = 5;          ///< Within ...
  static constexpr double kWithinS = 10 * 60;  ///< ... this time: it is given up.
  static constexpr double kPauseS = 1;         ///< Before it is started again.

  /// It has ended. @return false: it is given up
  bool ended(double now_s) {
    ends_.push_back(now_s);
    while (now_s - ends_.front() > kWithinS) ends_.pop_front();
    return static_cast<int>(ends_.size()) < kMostEnds;
  }
  int recentEnds() const { return static_cast<int>(ends_.size()); }

 private:
  std::deque<double> ends_;
};

}  // namespace relievo
