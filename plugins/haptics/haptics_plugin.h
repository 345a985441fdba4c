// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>

#include "haptics/rt/sleep_watch.h"
#include "plugins/api/plugin.h"
#include "plugins/haptics/buttons/button_control.h"
#include "plugins/haptics/device/force_return.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/frame_pace.h"
#include "plugins/haptics/guide/felt_patterns.h"
#include "plugins/haptics/guide/guide_control.h"
#include "plugins/haptics/loop_announcer.h"
#include "plugins/haptics/loop_session.h"
#include "plugins/haptics/recording/recording_control.h"
#include "plugins/haptics/sound/sound_control.h"
#include "plugins/haptics/touch_parts.h"
#include "plugins/haptics/touched_surface.h"

namespace relievo {

/// Joins the force loop to the application: switches the forces, and joins the parts that care for
/// the device, the surface, recordings and buttons while it is attached.
class HapticsPlugin : public QObject, public Plugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID RELIEVO_PLUGIN_IID FILE "haptics_plugin.json")
  Q_INTERFACES(relievo::Plugin)

 public:
  ~HapticsPlugin() override;
  void attach(Host& host) override;
  void detach() noexcept override;
  QByteArray saveState() const override;
  void restoreState(const QByteArray& state) override;

  /// Of the running loop; what the panel shows. Precondition: attached.
  const LoopStats& loopStats() { return session()->stats(); }
  const RealtimeGrant& realtime() { return session()->loop().realtime(); }

 private:
  /// Null: nothing is attached, or no loop could be started.
  LoopSession* session() const { return device_ ? device_->session() : nullptr; }
  void connectParts();
  void connectActions();
  void connectPanel();
  void setForces(bool on);
  void endForces(SaidBecause why);
  /// Of a device that took it away: opens it, and asks for forces once it is open.
  void takeForceBack();
  void watchReturn();
  void dropForces(SaidBecause why);  // Not by the person, whose wish may wait for an opening.
  void changeStrength(int percent);
  void nextStrengthPreset();
  void nextGripPosition();
  void tellGripPosition();
  void takePanelSettings();
  void takeDevice();  // Another one, with a session of its own.
  void applySettings();
  void frame();  // 60 times a second, less often at rest.
  bool mayChange() const;
  bool showProbe(const HapticSample& sample);  // Whether it shows another one.
  /// About 60 times a second, at rest 4 times; the host hears of it twice a second.
  void slowReadouts(bool with_status = true);
  void tellStatus(const LoopReport& report);
  void watchSleep(const HapticSample& sample);

  TouchSettings settings_;
  ButtonSettings button_settings_;
  std::string requested_device_ = kMouseDevice;  // The mouse takes the place of one not there.
  // While attached, each made from those before it.
  std::unique_ptr<TouchParts> parts_;
  std::unique_ptr<HandDevice> device_;
  std::unique_ptr<ForceReturn> return_;
  std::unique_ptr<RecordingControl> recording_;
  std::unique_ptr<TouchedSurface> surface_;
  std::unique_ptr<LoopAnnouncer> announcer_;
  std::unique_ptr<ButtonControl> buttons_;
  std::unique_ptr<GuideControl> guide_;
  std::unique_ptr<SoundControl> sound_;
  std::unique_ptr<FeltPatterns> felt_;
  std::unique_ptr<SleepWatch> sleep_;
  FramePace pace_;
  bool wants_forces_ = false;  // Of the device that is being opened.
  SaidBecause forces_because_ = SaidBecause::asked;
  Probe shown_;  // Last given to the host; window_id 0: none yet.
  int frames_ = 0;
  int frames_at_zero_ = -1;  // Since sleep was announced; -1: it was not.
};

}  // namespace relievo
