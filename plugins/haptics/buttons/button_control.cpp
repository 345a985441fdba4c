// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/buttons/button_control.h"

#include <optional>
#include <QAction>
#include <QApplication>
#include <QSignalBlocker>

namespace relievo {

ButtonControl::ButtonControl(TouchParts& parts, HandDevice& device, ButtonSettings& settings)
    : parts_(parts),
      device_(device),
      settings_(settings),
      buttons_(makeDeviceButtons(parts.host, parts.rumbler)),
      panel_(new ButtonsPanel) {
  parts_.host.controls.addPanel(tr("Buttons"), panel_);
  showSettings();
  connectButtons();
  connectActions();
}

void ButtonControl::connectButtons() {
  connect(buttons_.get(), &DeviceButtons::handPushed, this, [this](const DeviceMm& by) {
    if (device_.session() && parts_.host.view.shownWindow()) device_.session()->pushHand(by);
  });
  connect(buttons_.get(), &DeviceButtons::ticked, qApp, &QApplication::beep);
  connect(buttons_.get(), &DeviceButtons::detentChanged, this, [this] {
    const bool moving = buttons_->moving();
    parts_.actions.move_mode->setChecked(moving);
    parts_.actions.move_back->setEnabled(moving);
    if (device_.session()) device_.session()->setMoving(moving);
    Q_EMIT changed();
  });
  connect(buttons_.get(), &DeviceButtons::letGo, this, &ButtonControl::letGo);
  connect(buttons_.get(), &DeviceButtons::taught, this, &ButtonControl::taught);
  connect(panel_, &ButtonsPanel::settingsChanged, this, [this] {
    const bool rumbled = settings_.rumble;
    settings_ = panel_->settings();
    showSettings();
    if (rumbled != settings_.rumble) sayRumble();
    Q_EMIT changed();
  });
}

void ButtonControl::connectActions() {
  const TouchActions& actions = parts_.actions;
  connect(actions.rumble, &QAction::toggled, this, [this](bool on) {
    settings_.rumble = on;
    showSettings();
    sayRumble();
  });
  connect(actions.use_mouse, &QAction::triggered, this, [this] { device_.choose(kMouseDevice); });
  connect(actions.move_mode, &QAction::triggered, this, [this] {
    buttons_->toggleMoving();
    parts_.actions.move_mode->setChecked(buttons_->moving());
  });
  connect(actions.move_back, &QAction::triggered, this, [this] { buttons_->cancelMoving(); });
  connect(actions.where_am_i, &QAction::triggered, this, [this] { whereAmI(false); });
  connect(actions.where_am_i_long, &QAction::triggered, this, [this] { whereAmI(true); });
  connect(actions.say_detail, &QAction::triggered, this, [this] { buttons_->sayDetail(); });
  connect(actions.button_help, &QAction::triggered, this, [this] { buttons_->sayHelp(); });
}

void ButtonControl::whereAmI(bool in_full) {
  if (taught_) return Q_EMIT taskAsked();
  buttons_->whereAmI(in_full);
}

void ButtonControl::setTaught(bool taught) {
  taught_ = taught;
  buttons_->setTaught(taught);
}

void ButtonControl::showSettings() {
  if (panel_) panel_->setSettings(settings_);
  buttons_->setSettings(settings_);
  parts_.rumbler->setOn(settings_.rumble);
  const QSignalBlocker blocker(parts_.actions.rumble);
  parts_.actions.rumble->setChecked(settings_.rumble);
}

void ButtonControl::sayRumble() {
  parts_.host.messages.announce(
      settings_.rumble ? tr("Gamepads rumble at contact and edge. It is a cue, no force.")
                       : tr("Gamepads do not rumble."));
}

void ButtonControl::addTo(HapticOptions& options) const {
  options.detent = buttons_->detent();
  constexpr std::uint32_t kAnyButton = 0b1111;
  if (settings_.one_button) options.stop.buttons = kAnyButton;
}

void ButtonControl::follow(const HapticSample& sample) {
  while (const std::optional<ButtonEvent> event = device_.session()->takeButton()) {
    buttons_->press(event->button, event->down, 1e-9 * static_cast<double>(event->time_ns));
  }
  buttons_->frame(sample, 1e-9 * static_cast<double>(monotonicNs()));
}

}  // namespace relievo
