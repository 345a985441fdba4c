// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "haptics/loop/haptic_core.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/touch_parts.h"

namespace relievo {

/// Knows when a device has taken its force away and what brings it back: a host that ended, a cable
/// that was pulled, a brake or limit of the device's own (docs/adr/0213). Switches nothing. All
/// calls: GUI thread.
class ForceReturn {
 public:
  ForceReturn(TouchParts& parts, HandDevice& device) : parts_(parts), device_(device) {}

  /// Once a frame, with the newest sample; says once what helps.
  void follow(const HapticSample& sample);
  /// Another session runs.
  void forget();

  /// The device of a plug-in shows no force until it was opened anew. Not while it starts: it is
  /// not ready by itself then. Nor while its motors cool: what they were used for is still known.
  bool mustOpenAnew() const;
  /// One action can bring the chosen device back.
  bool isPossible() const { return mustOpenAnew() || device_.isReplaced(); }
  /// The device of this session has been without a fault.
  bool wasReady() const { return was_ready_; }
  /// What that action is, in a sentence; empty: there is nothing to bring back.
  QString remedy() const;

 private:
  TouchParts& parts_;
  HandDevice& device_;
  DeviceFault fault_ = DeviceFault::not_ready;
  bool was_ready_ = false;
  bool asked_ = false;     // Forces, at the last frame.
  bool is_taken_ = false;  // They were on when the fault came.
  QString told_;
};

}  // namespace relievo
