// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>
#include <QPointer>

#include "plugins/haptics/buttons/button_settings.h"
#include "plugins/haptics/buttons/buttons_panel.h"
#include "plugins/haptics/buttons/device_buttons.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/touch_parts.h"

namespace relievo {

/// The buttons of the device in the hand and of what lies beside it: their panel, their commands in
/// the menus, Move mode. All calls: GUI thread.
class ButtonControl : public QObject {
  Q_OBJECT
 public:
  /// Adds the panel. @param settings  the plugin's own, which outlive this
  ButtonControl(TouchParts& parts, HandDevice& device, ButtonSettings& settings);

  /// After a change of the settings that the panel did not make.
  void showSettings();
  /// What the loop must know of the buttons.
  void addTo(HapticOptions& options) const;
  /// Takes what was pressed. Once a frame, with the newest sample.
  void follow(const HapticSample& sample);
  /// A SpaceMouse, foot switch or gamepad is there, whose buttons follow() reads.
  bool areThere() const { return buttons_->areThere(); }
  void cancelMoving() { buttons_->cancelMoving(); }
  /// Another device is the hand.
  void forgetPresses() { buttons_->forgetPresses(); }
  /// The hand is being led: a button that goes down is told by letGo(), and does nothing else.
  void setLed(bool led) { buttons_->setLed(led); }
  /// The introduction runs: buttons are told by taught(), and Where am I by taskAsked().
  void setTaught(bool taught);

 Q_SIGNALS:
  void changed();  ///< addTo() adds something else now.
  void letGo();
  void taught(quint8 button);
  void taskAsked();

 private:
  void connectButtons();
  void connectActions();
  void whereAmI(bool in_full);
  void sayRumble();

  TouchParts& parts_;
  HandDevice& device_;
  ButtonSettings& settings_;
  std::unique_ptr<DeviceButtons> buttons_;
  bool taught_ = false;           // The introduction runs.
  QPointer<ButtonsPanel> panel_;  // The host owns it, and may have deleted it.
};

}  // namespace relievo
