// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "plugins/haptics/buttons/button_control.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/guide/marker_pull.h"
#include "plugins/haptics/guide/touch_guide.h"
#include "plugins/haptics/recording/recording_control.h"
#include "plugins/haptics/touch_parts.h"
#include "plugins/haptics/touched_surface.h"
#include "plugins/haptics/training/touch_training.h"

namespace relievo {

/// Leads the hand, pulls it back to markers, and introduces it to touch: joins these to menu, keys,
/// buttons and the surface under the hand. All calls: GUI thread.
class GuideControl : public QObject {
  Q_OBJECT
 public:
  GuideControl(TouchParts& parts, HandDevice& device, RecordingControl& recording,
               TouchedSurface& surface, ButtonControl& buttons);
  ~GuideControl() override;

  /// Which path the loop is to lead along, and which marker pulls.
  void addTo(HapticOptions& options) const {
    options.guide = guide_.options();
    options.beacon = marker_.options();
  }
  /// Once a frame, with the newest sample, after the buttons were looked at.
  void follow(const HapticSample& sample);
  /// All off without a word: forces or the device go, which is said already.
  void end();
  /// What is under the hand is a shape of the introduction, not what the host shows.
  bool isTraining() const { return training_.isOn(); }
  /// Starts or ends a recording; says why not while the introduction runs.
  void setRecording(bool on);

 Q_SIGNALS:
  void found();               ///< What a task of the introduction was about.
  void changed();             ///< addTo() adds something else now.
  void forcesAsked(bool on);  ///< They are to be switched.

 private:
  void connectGuide();
  void connectTraining();
  void chooseWay();  // That the hand is to be led along.
  void setTraining(bool on);
  void showTraining();  // What it laid under the hand, or the relief again.

  TouchParts& parts_;
  HandDevice& device_;
  RecordingControl& recording_;
  TouchedSurface& surface_;
  ButtonControl& buttons_;
  TouchGuide guide_;
  MarkerPull marker_;
  TouchTraining training_;
};

}  // namespace relievo
