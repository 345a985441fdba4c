// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>
#include <QPointer>
#include <string>

#include "haptics/device/falcon/usb_bus.h"
#include "haptics/device/haply/event_channel.h"
#include "plugins/api/host.h"
#include "plugins/haptics/device/falcon_status_announcer.h"
#include "plugins/haptics/device/plugin_devices.h"
#include "plugins/haptics/device/set_up_dialog.h"
#include "plugins/haptics/loop_session.h"
#include "plugins/haptics/panel/loop_health.h"
#include "plugins/haptics/touch_parts.h"

namespace relievo {

inline constexpr const char* kMouseDevice = "mouse";  ///< Its id; it is always there.

/// The device in the hand: opens the one that was asked for, lets the mouse take its place where
/// it cannot be opened, looks for it again, and says how it is. Owns the running loop. All calls:
/// GUI thread.
class HandDevice : public QObject {
  Q_OBJECT
 public:
  explicit HandDevice(TouchParts& parts);
  ~HandDevice() override;  ///< Zero force; all threads are joined.

  /// The device of the settings; the mouse if that fails. @throw Error  nor could the mouse
  void open();
  /// From now on a plug that is pulled or put in is noticed.
  void startWatchingPlugs();
  /// Closes the assistant and gives up what is being opened. The loop goes on.
  void stopLooking();

  /// The running loop; null: none could be started.
  LoopSession* session() const { return session_.get(); }
  /// Id of the session's device.
  const std::string& opened() const { return opened_; }

  /// What the person asks for from now on.
  void choose(const std::string& id);
  /// Opens the device of the settings, if another one is open.
  void useSettings();
  /// Opens the device of the settings anew.
  void change();
  /// Opens the one that the person asked for anew, also where the mouse has taken its place.
  void openAnew();
  bool isOpening() const { return opening_ != nullptr; }
  /// The mouse is the hand, because the one that was asked for could not be opened.
  bool isReplaced() const { return !opening_ && !setup_ && !fallback_.isEmpty(); }
  /// Of the device that was asked for. @param fault  that it reports now
  TouchDevice stateOf(DeviceFault fault) const;

  /// Adds to a report what the device says of itself, and announces what is new of it.
  void report(LoopReport& report);
  /// Takes over a device that was being opened, once it is open. A few times a second.
  void watchOpening();
  /// Likewise, a device that was plugged in, or is free now.
  void watchPlugs();
  void lookForPlugins() { plugin_devices_.look(); }

  /// Opens the assistant for the device that was chosen, else for one that can be set up here, or
  /// shows the one that is open.
  void setUp();
  /// The computer is about to sleep: nothing of the assistant keeps a force.
  void endSetUpBeforeSleep();

 Q_SIGNALS:
  void forcesEnd(relievo::SaidBecause why);  ///< Nobody may be pushed by what comes next.
  void leaving();                            ///< The session ends: recording, moving of the window.
  void changed();                            ///< Another session runs; it knows no settings yet.

 private:
  void openMouse(const Error& error, bool only_the_plug_helps);
  void beginOpening();
  void lookAgain();
  enum class Kind : std::uint8_t { falcon, haply };
  Kind kindToSetUp() const;
  void beginSetUp(Kind kind);
  void showStandIn(const Message& message, bool only_the_plug_helps);
  void announceState(LoopReport& report);
  void announceEvents(const haply::LinkStatus& status);
  QString heatText() const;

  TouchParts& parts_;
  std::unique_ptr<LoopSession> session_;
  std::string opened_;                      // Id of the session's device.
  std::unique_ptr<DeviceOpening> opening_;  // Null: none is being opened.
  PluginDevices plugin_devices_;
  QPointer<SetUpDialog> setup_;
  FalconStatusAnnouncer news_;
  QString haply_told_;                           // Of a device of Haply, last.
  std::unique_ptr<haply::EventChannel> events_;  // Of its service, while it is the hand.
  haply::EventNews event_news_;
  QString fallback_;             // Why the mouse is the hand; on the screen.
  int readouts_until_look_ = 0;  // For the one that was asked for; 0: a plug event will tell.
  std::unique_ptr<falcon::PlugWatch> plugs_;
};

}  // namespace relievo
