// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>
#include <QTimer>
#include <string>
#include <vector>

#include "core/describe/hand_place.h"
#include "haptics/commands/button_commands.h"
#include "haptics/device/hid/hid_devices.h"
#include "haptics/device/pad/pad_devices.h"
#include "haptics/loop/haptic_core.h"
#include "plugins/api/plugin.h"
#include "plugins/haptics/buttons/button_settings.h"

namespace relievo {

/// Carries out what the buttons of any device ask for: through the window's commands, each with a
/// sentence for speech. Also reads SpaceMouse, foot switches and gamepads. [GUI thread]
class DeviceButtons : public QObject {
  Q_OBJECT
 public:
  /// @param hid  null: there are no such devices on this system
  /// @param rumbler  gets the motors of gamepads
  DeviceButtons(Host& host, std::unique_ptr<hid::HidDevices> hid,
                std::shared_ptr<pad::Rumbler> rumbler);

  /// An edge of the haptic device's own button.
  void press(std::uint8_t button, bool down, double time_s);
  /// Once a frame.
  void frame(const HapticSample& sample, double now_s);
  void setSettings(const ButtonSettings& settings);
  /// A SpaceMouse, foot switch or gamepad is there, by the last look.
  bool areThere() const;
  /// What the hand feels in Move mode; off outside of it.
  const MoveDetent& detent() const { return detent_; }
  bool moving() const { return detent_.on; }
  /// The hand is being led: a button that goes down lets it go, and does nothing else.
  void setLed(bool led) { led_ = led; }
  /// The introduction runs: buttons that go down are told to it by taught(), and do nothing else;
  /// one that scans offers to go on.
  void setTaught(bool taught) { taught_ = taught; }
  /// Another device is the hand: nobody will tell that a button of the old one went up.
  void forgetPresses();

  // The commands that menus and keys share with the buttons. Each says its result.
  void whereAmI(bool in_full);
  void sayDetail();
  void sayHelp();
  void toggleMoving();
  void cancelMoving();

 Q_SIGNALS:
  /// A SpaceMouse pushes the hand by so much, mm of hand.
  void handPushed(relievo::DeviceMm by);
  /// A button is held long now: for the ear, nothing is done yet.
  void ticked();
  /// A button went down while the hand was led.
  void letGo();
  void taught(quint8 button);
  /// Move mode began, moved or ended: detent() is another one.
  void detentChanged();

 private:
  void readHid(double now_s);
  void readPads(double now_s);
  void tellPlugs(const std::vector<std::string>& arrived, const std::vector<std::string>& left);
  void pushCap(const hid::CapMotion& motion, double dt_s);
  void pushView(const hid::CapMotion& motion, double dt_s);
  void takeOutcomes(double now_s);
  bool takenByWindow(ButtonCommand command);
  void carryOut(ButtonCommand command);
  bool carryOutMove(ButtonCommand command);
  bool carryOutTaught(ButtonCommand command);
  void setDetent(const MoveDetent& detent);
  HandPlace handPlace() const;
  /// Which window is shown, after what led there.
  void saySituation(const Message& after);

  Host& host_;
  ButtonCommands commands_;
  ButtonSettings settings_;
  HapticSample sample_;  // The newest.
  MoveDetent detent_;
  bool led_ = false, taught_ = false;
  std::uint32_t let_go_ = 0;  // Buttons whose press did something of these two; bits.
  Region moved_from_;         // Where Move mode began.
  std::unique_ptr<hid::HidDevices> hid_;
  pad::PadDevices pads_;
  double scanned_s_ = -10, polled_s_ = 0;
};

/// With the HID devices and gamepads of this computer, if it has any such thing.
std::unique_ptr<DeviceButtons> makeDeviceButtons(Host& host, std::shared_ptr<pad::Rumbler> rumbler);

}  // namespace relievo
