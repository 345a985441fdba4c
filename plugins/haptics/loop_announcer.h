// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "haptics/loop/haptic_core.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/touch_parts.h"

namespace relievo {

/// Says what has changed in the running loop: faults, stops, edges, waiting, softening. All calls:
/// GUI thread.
class LoopAnnouncer : public QObject {
  Q_OBJECT
 public:
  LoopAnnouncer(TouchParts& parts, HandDevice& device) : parts_(parts), device_(device) {}

  /// Once a frame, with the newest sample.
  void follow(const HapticSample& sample);
  /// What the device reported last.
  DeviceFault fault() const { return fault_; }
  /// Another device is in the hand.
  void forgetFault() { fault_ = DeviceFault::none; }

 Q_SIGNALS:
  void forcesEnd(relievo::SaidBecause why);  ///< They are to be switched off.
  void faultTold(const QString& sentence);

 private:
  void announce(const QString& text, SaidBecause why = SaidBecause::noticed);
  void dropForces() { Q_EMIT forcesEnd(SaidBecause::noticed); }
  void watchSurface();
  void watchFault(const HapticSample& sample);
  void watchStop(const HapticSample& sample);
  void watchEdge(const HapticSample& sample);
  void watchWaiting(const HapticSample& sample);
  void watchSoftening(const HapticSample& sample);
  void watchRate(const HapticSample& sample);

  TouchParts& parts_;
  HandDevice& device_;
  DeviceFault fault_ = DeviceFault::none;
  int softened_ = 0;
  int frames_waiting_ = 0;  // That the forces have waited for a clear hand.
  bool at_edge_ = false;    // Said.
  bool slow_ = false;       // Likewise, since forces were switched on.
};

}  // namespace relievo
