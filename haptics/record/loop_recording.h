// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "haptics/loop/haptic_core.h"
#include "haptics/record/sample_log.h"

namespace relievo {

/// A running loop's samples from its first tick on, up to a number of them, in a log that can be
/// replayed however the loop or the program ended: what the rows do not tell - a fault that the
/// device reported, forces that went off as the loop left, a start from zero after a cut - is kept
/// as a line with its row. An error is kept for whoever joins the drain.
class LoopRecording {
 public:
  /// @param most  samples; then it is done()
  LoopRecording(SampleLog& log, std::uint64_t most) : log_(log), left_(most) {}

  void take(std::span<const HapticSample> batch);  ///< [drain thread] the sink
  /// [any thread] All samples are there, or no more can be written.
  bool done() const { return done_.load(std::memory_order_acquire); }

  // [drain joined]
  const std::string& error() const { return error_; }  ///< Empty: all is written.
  /// Of the device at the end: from there on there was no force.
  DeviceFault fault() const { return before_ ? before_->fault : DeviceFault::none; }
  int gaps() const { return gaps_; }  ///< Places where samples were dropped.

 private:
  SampleLog& log_;
  std::uint64_t left_;
  std::optional<HapticSample> before_;
  std::int64_t start_ns_ = 0;
  std::string error_;
  int gaps_ = 0;
  std::atomic<bool> done_{false};
};

}  // namespace relievo
