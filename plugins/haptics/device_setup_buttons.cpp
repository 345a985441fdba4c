// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device_setup_buttons.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/failure.h"
#include "core/base/origin.h"
#include "core/message/catalogue.h"
#include "core/region/hand.h"
#include "haptics/rt/realtime_thread.h"
#include "ui/message/message_text.h"

namespace relievo {

namespace {
constexpr double kRescanSeconds = 1;
// At full deflection of the cap: of the hand, or of the view.
constexpr double kFullPushMmPerS = 60, kFullTurnDegPerS = 60;

Message messageOf(Origin origin) {
  constexpr std::array<MessageId, kOriginCount> kWords{
      MessageId::origin_measured, MessageId::origin_interpolated, MessageId::origin_base_plane,
      MessageId::origin_steep, MessageId::origin_outside};
  return {kWords[static_cast<std::size_t>(origin)], {}};
}
}  // namespace

DeviceButtons::DeviceButtons(Host& host, std::unique_ptr<hid::HidDevices> hid)
    : host_(host), hid_(std::move(hid)) {}

void DeviceButtons::press(std::uint8_t button, bool down, double time_s) {
  commands_.press(button, down, time_s);
}

void DeviceButtons::readHid(double now_s) {
  if (!hid_) return;
  hid::HidNews news;
  if (now_s - scanned_s_ > kRescanSeconds) {
    scanned_s_ = now_s;
    hid_->look();
  }
  hid_->poll(news);
  for (const std::string& name : news.arrived) {
    host_.messages.announce(tr("%1 connected.").arg(QString::fromStdString(name)));
  }
  for (const std::string& name : news.forbidden) {
    host_.messages.announce(
        tr("%1 is plugged in but this account may not use it. Install the rule that "
           "'relievo devices rule' prints, once, then replug.")
            .arg(QString::fromStdString(name)));
  }
  for (const std::string& name : news.left) {
    host_.messages.announce(tr("%1 disconnected.").arg(QString::fromStdString(name)));
  }
  for (const hid::ButtonEdge& edge : news.edges) commands_.press(edge.button, edge.down, now_s);
  const double dt_s = std::clamp(now_s - polled_s_, 0.0, 0.1);
  polled_s_ = now_s;
  pushCap(news.motion, dt_s);
}

void DeviceButtons::pushCap(const hid::CapMotion& motion, double dt_s) {
  if (settings_.space_mouse == SpaceMouseMoves::view) {
    const double deg = kFullTurnDegPerS * dt_s;
    // As the turning commands: the near side goes where the cap goes.
    if (motion.right != 0 || motion.up != 0) {
      host_.view.turnView(-deg * motion.right, -deg * motion.up);
    }
    return;
  }
  const double mm = kFullPushMmPerS * dt_s;
  const DeviceMm by{mm * motion.right, mm * motion.up, mm * motion.toward};
  if (by != DeviceMm{}) Q_EMIT handPushed(by);
}

void DeviceButtons::setSettings(const ButtonSettings& settings) {
  settings_ = settings;
  commands_.setOptions({.one_button = settings.one_button, .scan_s = settings.scan_s});
}

void DeviceButtons::frame(const HapticSample& sample, double now_s) {
  sample_ = sample;
  commands_.setForcesOn(sample.engaged != EngagePhase::off);
  readHid(now_s);
  if (gate_.on && !host_.view.shownWindow()) cancelMoving();
  commands_.hand(sample.hip);
  takeOutcomes(now_s);
}

void DeviceButtons::takeOutcomes(double now_s) {
  for (const ButtonOutcome& outcome : commands_.take(now_s)) {
    switch (outcome.kind) {
      case ButtonOutcome::Kind::offer:
        host_.messages.announce(tr("%1?").arg(messageText(relievo::messageOf(outcome.command))));
        break;
      case ButtonOutcome::Kind::tick:
        Q_EMIT ticked();
        break;
      case ButtonOutcome::Kind::run:
        carryOut(outcome.command);
        break;
    }
  }
}

void DeviceButtons::carryOut(ButtonCommand command) {
  switch (command) {
    case ButtonCommand::where_am_i:
    case ButtonCommand::where_am_i_long:
      whereAmI(command == ButtonCommand::where_am_i_long);
      return;
    case ButtonCommand::say_detail:
      sayDetail();
      return;
    case ButtonCommand::help:
      sayHelp();
      return;
    default:
      break;
  }
  if (carryOutMove(command)) return;
  // The window's own command, as by key or menu; it announces its result.
  const std::string_view name = commandName(command);
  if (!host_.controls.run(QString::fromLatin1(name.data(), static_cast<int>(name.size())))) {
    host_.messages.announce(
        command == ButtonCommand::stop_forces
            ? tr("Forces are off.")
            : tr("%1 is not possible here.").arg(messageText(relievo::messageOf(command))));
  }
  if (!gate_.on) return;
  MoveGate gate = gate_;
  gate.blocked = host_.view.edges();
  setGate(gate);
}

bool DeviceButtons::carryOutMove(ButtonCommand command) {
  switch (command) {
    case ButtonCommand::begin_move: {
      const std::shared_ptr<const RegionWindow> window = host_.view.shownWindow();
      if (!window) {
        commands_.cancelMoving();
        host_.messages.announce(tr("Nothing is open."));
        return true;
      }
      moved_from_ = window->region;
      setGate({.on = true, .centre = sample_.hip, .blocked = host_.view.edges()});
      host_.messages.announce(
          tr("Move mode. Push the grip to a side; Forward when you are there."));
      return true;
    }
    case ButtonCommand::confirm_move:
      setGate({});
      host_.messages.announce(tr("Moved. %1").arg(detailText()));
      return true;
    case ButtonCommand::cancel_move:
      if (!gate_.on) return true;  // It never began.
      setGate({});
      host_.view.showRegion(moved_from_);
      host_.messages.announce(tr("Back at the old window. %1").arg(detailText()));
      return true;
    default:
      return false;
  }
}

void DeviceButtons::setGate(const MoveGate& gate) {
  if (gate == gate_) return;
  gate_ = gate;
  Q_EMIT gateChanged();
}

void DeviceButtons::whereAmI(bool in_full) {
  host_.messages.announce(placeText(in_full));
}

void DeviceButtons::sayDetail() {
  host_.messages.announce(detailText());
}

void DeviceButtons::sayHelp() {
  host_.messages.announce(messageText(commands_.help()));
}

void DeviceButtons::toggleMoving() {
  commands_.toggleMoving();
  takeOutcomes(1e-9 * static_cast<double>(monotonicNs()));
}

void DeviceButtons::cancelMoving() {
  commands_.cancelMoving();
  takeOutcomes(1e-9 * static_cast<double>(monotonicNs()));
}

QString DeviceButtons::placeText(bool in_full) const {
  if (!host_.view.shownWindow()) return tr("Nothing is open.");
  const HapticSample& sample = sample_;
  const ViewMm at = sample.contact ? sample.proxy_view : sample.hip_view;
  QString said = sample.contact ? tr("Touching. ") : tr("In the air. ");
  said += tr("%1 right, %2 up, height %3 millimetres.")
              .arg(at.x, 0, 'f', 0)
              .arg(at.y, 0, 'f', 0)
              .arg(at.z, 0, 'f', 1);
  if (sample.contact && sample.origin != Origin::measured) {
    said += tr(" Not measured here: %1.").arg(messageText(messageOf(sample.origin)));
  }
  if (in_full) said += QLatin1Char(' ') + detailText();
  return said;
}

QString DeviceButtons::detailText() const {
  const std::shared_ptr<const RegionWindow> window = host_.view.shownWindow();
  if (!window) return tr("Nothing is open.");
  return tr("Detail %1 of %2, window %3 millimetres, one millimetre of hand is %4.")
      .arg(window->levels - window->region.level.value)
      .arg(window->levels)
      .arg(window->region.side_mm, 0, 'f', 0)
      .arg(1 / handMapping(*window).device_per_view, 0, 'g', 3);
}

std::unique_ptr<DeviceButtons> makeDeviceButtons(Host& host) {
  std::unique_ptr<hid::HidDevices> hid;
  try {
    hid = std::make_unique<hid::HidDevices>();
  } catch (const DeviceError& error) {
    host.messages.announce(messageText(messageOf(error)));
  }
  return std::make_unique<DeviceButtons>(host, std::move(hid));
}

}  // namespace relievo
