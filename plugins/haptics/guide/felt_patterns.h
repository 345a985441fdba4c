// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "haptics/loop/haptic_core.h"
#include "plugins/haptics/touch_parts.h"

namespace relievo {

/// Says by taps to the hand what others see and hear: that forces are there or something was found,
/// that ground was not measured, that the window ends. On and off for menu and panel, and what is
/// said of it. [GUI thread]
class FeltPatterns : public QObject {
  Q_OBJECT
 public:
  explicit FeltPatterns(TouchParts& parts);

  void addTo(HapticOptions& options) const { options.taps = taps_; }
  /// Once a frame, with the newest sample.
  void follow(const HapticSample& sample);
  /// Something that no sample tells.
  void feel(FeltPattern pattern);
  /// The action as the settings are.
  void showSettings();

 Q_SIGNALS:
  void changed();  ///< addTo() adds another one now.

 private:
  void setOn(bool on);

  TouchParts& parts_;
  TapOptions taps_;
  QElapsedTimer since_;  // The last one.
  bool is_filled_ = false, is_at_edge_ = false, is_on_ = false;
};

}  // namespace relievo
