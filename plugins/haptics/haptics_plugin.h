// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/sleep_watch.h"
#include "plugins/api/plugin.h"
#include "plugins/haptics/buttons/buttons_panel.h"
#include "plugins/haptics/buttons/device_buttons.h"
#include "plugins/haptics/device/device_setup_dialog.h"
#include "plugins/haptics/device/falcon_news.h"
#include "plugins/haptics/device/plugin_devices.h"
#include "plugins/haptics/loop_session.h"
#include "plugins/haptics/panel/haptics_panel.h"
#include "plugins/haptics/recording/note_dialog.h"
#include "plugins/haptics/touch_actions.h"
#include "plugins/haptics/touch_settings.h"

namespace relievo {

/// Joins the force loop to the application: panel, menu entries, probe, plots, recording.
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
  const LoopStats& loopStats() { return session_->stats(); }
  const RealtimeGrant& realtime() { return session_->loop().realtime(); }

 private:
  void openDevice();    // As the settings say; the mouse if that fails.
  void changeDevice();  // While attached.
  void beginOpening();  // Of the plug-in's device that is wished; the mouse stands in meanwhile.
  void watchOpening();
  QString heatText() const;
  void chooseDevice(const std::string& id);
  void connectHost();
  void connectControls();
  void connectButtons();
  void showWindow(const RegionWindow& window);
  void setForces(bool on);
  void dropForces();  ///< Nobody asked for it.
  void changeStrength(int percent);
  void setRecording(bool on);
  void applySettings();
  SceneMaps mapsUnder(const RegionWindow& window);
  void takeFiner(quint64 window_id, const std::vector<float>& finer_mm, const QString& problem);
  void askFirmness(const QString& file, bool chosen_now);
  void restoreFirmness();  // What the settings say.
  void takeFirmness(const QString& file, std::shared_ptr<const FirmnessMap> firmness,
                    const QString& problem);
  void setFirmness(std::shared_ptr<const FirmnessMap> firmness);
  void applySurface();  // Another kind of the shown window's, if that was chosen.
  void frame();         // 60 times a second.
  /// About 8 times a second; the host hears of it twice a second.
  void slowReadouts(bool with_status = true);
  void tellStatus(const LoopReport& report);
  void watchSoftening(const HapticSample& sample);
  void watchRate(const HapticSample& sample);
  void watchSurface();
  void watchFault(const HapticSample& sample);
  void watchStop(const HapticSample& sample);
  void watchEdge(const HapticSample& sample);
  void watchWaiting(const HapticSample& sample);
  void watchRecording();
  QString folderOfRecording() const;     ///< Of the running one, or of the next.
  void endRecording();                   // Before its loop goes.
  void askNote();                        // Of the present tick.
  void addNote();                        // As it was written.
  void watchDevice(LoopReport& report);  // Announces its news, and adds them.
  void watchPlugs();
  void lookAgain();  // For a Falcon that was there and could not be opened.
  void showStandIn(const Message& message, bool only_the_plug_helps);
  void watchSleep(const HapticSample& sample);
  void runButtons(const HapticSample& sample);
  void setUpDevice();

  Host* host_ = nullptr;
  std::unique_ptr<LoopSession> session_;
  PluginDevices plugin_devices_;
  std::unique_ptr<DeviceOpening> opening_;  // Null: none is being opened.
  TouchSettings settings_;
  std::unique_ptr<DeviceButtons> buttons_;
  QPointer<DeviceSetupDialog> setup_;
  std::string opened_;          // Id of the session's device.
  std::string wish_ = "mouse";  // Of the person; the mouse stands in for one that is not there.
  FalconNews news_;
  SaidBecause forces_because_ = SaidBecause::asked;
  QString haply_told_;  // Of a device of Haply, last.
  QString stand_in_;    // Why the mouse is the hand and not what was wished; on the screen.
  int readouts_until_look_ = 0;  // For the one that was wished; 0: a plug event will tell.
  std::unique_ptr<falcon::PlugWatch> plugs_;
  std::unique_ptr<SleepWatch> sleep_;
  int frames_at_zero_ = -1;  // Since sleep was announced; -1: it was not.
  TouchActions actions_;
  ButtonSettings button_settings_;
  QPointer<ButtonsPanel> buttons_panel_;
  QPointer<HapticsPanel> panel_;
  QTimer timer_;
  QString recorded_in_;       // The running recording's folder.
  QString recorded_windows_;  // Lines for the running recording's end.
  QPointer<NoteDialog> note_;
  Probe shown_;  // Last given to the host; window_id 0: none yet.
  int frames_ = 0;
  std::uint64_t given_window_ = 0;  // To the session, last.
  int softened_ = 0;
  SurfaceKind surface_ = SurfaceKind::gated;  // Given to the loop last, with the next.
  bool textured_ = false;
  std::vector<float> finer_mm_;  // That came late; of the window below.
  quint64 finer_window_ = 0;
  std::shared_ptr<const FirmnessMap> firmness_;  // Null: the origins say where it is firm.
  bool firmness_fits_ = true;                    // The open map.
  QString firmness_awaited_;                     // Being read.
  bool firmness_chosen_now_ = false;             // Not remembered.
  bool forces_asked_ = false;
  bool at_edge_ = false;    // Said.
  int frames_waiting_ = 0;  // That the forces have waited for a clear hand.
  bool slow_ = false;       // Likewise, since forces were switched on.
  DeviceFault fault_ = DeviceFault::none;
};

}  // namespace relievo
