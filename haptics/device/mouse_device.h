// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/device/device.h"
#include "haptics/rt/triple_buffer.h"

namespace relievo {

/// What a person asks a steered hand for.
struct HandWish {
  DeviceMm position;
  std::uint32_t buttons = 0;
  std::uint32_t jumps = 0;   ///< Counts placeAt: one that is skipped over still jumps.
  DeviceMm hover;            ///< Where it hovered last; the way down begins there.
  std::uint32_t hovers = 0;  ///< Counts hoverAt, likewise.
  bool hovering = false;
};

/// The mouse or the keys as a hand: it follows a target that the GUI sets. Pointer events come at
/// 60 Hz; a first-order follower makes a hand of them that does not jump. A hand at rest is not a
/// stale hand. No actuator: the force goes nowhere.
class MouseDevice : public SteeredDevice {
 public:
  MouseDevice();
  const DeviceInfo& info() const noexcept override { return info_; }
  void open() override {}
  void close() noexcept override {}
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override;
  void send(DeviceN /*force*/, std::int64_t /*now_ns*/) RELIEVO_REALTIME override {}

  void moveTo(DeviceMm target) RELIEVO_REALTIME override;
  void placeAt(DeviceMm target) RELIEVO_REALTIME override;
  void setButtons(std::uint32_t buttons) RELIEVO_REALTIME override;
  /// At once: the pointer is there already.
  void hoverAt(DeviceMm target) RELIEVO_REALTIME override;

  static constexpr double kFollowSeconds = 0.008;  ///< Time constant of the follower.

 private:
  DeviceInfo info_;
  TripleBuffer<HandWish> targets_;
  HandWish wanted_;  // [GUI thread]
  // [haptic loop]
  DeviceMm position_;
  std::uint32_t jumps_ = 0, hovers_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace relievo
