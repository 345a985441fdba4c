// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <memory>

#include "haptics/device/virtual_hand.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_core.h"

namespace relievo::test {

/// Core and virtual hand on a clock of exactly 1 kHz, or slower: the loop without its thread.
class ClosedLoop {
 public:
  ClosedLoop(const HapticSpace& space, const VirtualHandOptions& hand, HapticOptions options,
             std::int64_t period_ns = 1'000'000)
      : space_(space),
        hand_(hand),
        options_(withinDevice(options, hand_.info())),
        period_ns_(period_ns) {
    hand_.open();
  }
  void placeAt(DeviceMm target) { hand_.placeAt(target); }
  /// One tick with the person's aim at `target`.
  HapticSample tick(DeviceMm target) {
    hand_.moveTo(target);
    now_ns_ += period_ns_;
    const HapticSample sample = core_.tick(space_, options_, hand_.read(now_ns_), now_ns_);
    hand_.send(sample.force, now_ns_);
    return sample;
  }
  /// Ticks in free space until forces are fully on.
  void switchOn(DeviceMm clear_of_the_surface) {
    options_.force.forces_on = true;
    placeAt(clear_of_the_surface);
    for (int i = 0; i < 2000; ++i) {
      if (tick(clear_of_the_surface).engaged == EngagePhase::on) return;
    }
  }
  const VirtualHand& hand() const { return hand_; }
  HapticOptions& options() { return options_; }
  void setPeriod(std::int64_t ns) { period_ns_ = ns; }

 private:
  const HapticSpace& space_;
  VirtualHand hand_;
  HapticOptions options_;
  HapticCore core_;
  std::int64_t period_ns_ = 1'000'000;
  std::int64_t now_ns_ = 0;
};

/// How much a signal swings above 20 Hz: largest less smallest of what a slow mean leaves.
class Swing {
 public:
  explicit Swing(double period_s = 1e-3) : rate_(2 * 3.14159265358979323846 * 20 * period_s) {}
  void add(double value) {
    mean_ = started_ ? mean_ + rate_ / (1 + rate_) * (value - mean_) : value;
    started_ = true;
    low_ = std::min(low_, value - mean_);
    high_ = std::max(high_, value - mean_);
  }
  /// Forgets the extremes, not the mean.
  void restart() { low_ = high_ = 0; }
  double peakToPeak() const { return high_ - low_; }

 private:
  double rate_;  // 20 Hz, per sample.
  double mean_ = 0, low_ = 0, high_ = 0;
  bool started_ = false;
};

}  // namespace relievo::test
