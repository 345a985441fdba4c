// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace relievo::emulator {

using Triple = std::array<double, 3>;

/// The mechanics of a Falcon and the hand that holds its grip. Its geometry is written down a
/// second time, in angles and by finite differences, so that it can disagree with the driver's.
/// Lengths mm from the centre of the base, forces N, time s.
class FalconBody {
 public:
  /// The hand holds the grip exactly here.
  void hold(const Triple& place);
  /// The hand carries the grip there as fast as a hand can and then holds it; as hold() while an
  /// arm is not homed.
  void carry(const Triple& place);
  /// The hand pulls the grip toward a place like a spring and lets itself be pushed.
  void pullToward(const Triple& place);
  /// The motors' counts from now on.
  void drive(const std::array<int, 3>& counts) { counts_ = counts; }
  void advance(double seconds);

  const Triple& grip() const { return grip_; }
  Triple force() const;  ///< Of the motors on the hand.
  /// As the encoders count: 16 bits that begin anywhere until an arm is homed.
  std::array<int, 3> encoders() const;
  int homed() const { return homed_; }
  /// As after switching on: no arm knows its zero. Or only these, bit i: arm i.
  void forgetHoming(int arms = 7);
  /// Every arm knows its zero, as when another program has used it before.
  void beHomed() { homed_ = 7; }

  /// Nobody holds the grip; a weight hangs on it, N.
  void letGo(double weight_n);

  double counts_per_n_mm = 10;  ///< The motors' truth; what the driver believes is its setting.

  /// Motor angles in degrees of a place; nothing: the arms do not reach it.
  static std::optional<Triple> anglesDeg(const Triple& place);

 private:
  void moveTo(const Triple& place);
  void carryOn(double seconds);

  Triple grip_{0, 0, 110}, velocity_{}, wanted_{0, 0, 110};
  bool held_ = true, let_go_ = false, carried_ = false;
  double weight_n_ = 0;
  std::array<int, 3> counts_{};
  std::array<bool, 3> was_out_{};
  int homed_ = 0;
};

}  // namespace relievo::emulator
