// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/message/message.h"
#include "haptics/device/falcon/falcon_device.h"

namespace relievo::falcon {

/// Finds how many motor counts one newton millimetre really takes: the Falcon holds its grip in
/// place, without and then with a known weight on it. What it must push more is the weight.
/// Plays the loop's part, as SelfTest does. The hand must be off the grip.
class Calibration {
 public:
  enum class Phase : std::uint8_t { hold_empty, hang_weight, hold_weight, done, failed };

  /// @param weight_g  20 to 300
  /// @throw ArgumentError
  Calibration(FalconDevice& device, double counts_per_n_mm, double weight_g);
  bool step(std::int64_t now_ns);               ///< @return false: done or failed
  void weightHangs() { weight_hangs_ = true; }  ///< The person says so.
  Phase phase() const { return phase_; }
  Message prompt() const;
  /// Counts per N mm, once done.
  std::optional<double> result() const { return result_; }
  /// What the empty grip weighs in that place, N, once done: what its holding took.
  double gripWeightN() const { return grip_weight_n_; }

 private:
  DeviceN holdingForce(const DeviceReading& reading, double dt_s);
  void begin(Phase phase, std::int64_t now_ns);
  void follow(std::int64_t now_ns, double dt_s);
  bool settled(std::int64_t now_ns);
  void fail(Message why);

  FalconDevice& device_;
  double counts_per_n_mm_, weight_n_;
  Phase phase_ = Phase::hold_empty;
  bool weight_hangs_ = false;
  std::int64_t last_ns_ = 0, phase_ns_ = 0, disturbed_ns_ = 0;
  std::uint64_t interrupted_ = 0;
  double undisturbed_s_ = 0;
  std::optional<DeviceMm> place_;
  DeviceMm last_position_;
  DeviceN integral_, force_;
  double mean_up_n_ = 0, drift_n_ = 0, empty_n_ = 0;
  std::optional<double> result_;
  double grip_weight_n_ = 0;
  std::optional<Message> why_;  ///< It failed.
};

}  // namespace relievo::falcon
