// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device_setup_buttons.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/region/hand.h"

namespace relievo {

namespace {
constexpr double kRescanSeconds = 1;
constexpr double kFullPushMmPerS = 60;  // Of the hand, at full deflection of the cap.

QString text(std::string_view words) {
  return QString::fromUtf8(words.data(), static_cast<int>(words.size()));
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
    hid_->rescan(news);
  }
  hid_->poll(news);
  for (const std::string& name : news.arrived) {
    host_.announce(tr("%1 connected.").arg(QString::fromStdString(name)));
  }
  for (const std::string& name : news.left) {
    host_.announce(tr("%1 disconnected.").arg(QString::fromStdString(name)));
  }
  for (const hid::ButtonEdge& edge : news.edges) commands_.press(edge.button, edge.down, now_s);
  const double dt_s = std::clamp(now_s - polled_s_, 0.0, 0.1);
  polled_s_ = now_s;
  const double mm = kFullPushMmPerS * dt_s;
  const DeviceMm by{mm * news.motion.right, mm * news.motion.up, mm * news.motion.toward};
  if (by != DeviceMm{}) Q_EMIT handPushed(by);
}

void DeviceButtons::frame(const HapticSample& sample, double now_s) {
  readHid(now_s);
  commands_.hand(sample.hip);
  for (const ButtonOutcome& outcome : commands_.take(now_s)) {
    switch (outcome.kind) {
      case ButtonOutcome::Kind::offer:
        host_.announce(tr("%1?").arg(text(commandWords(outcome.command))));
        break;
      case ButtonOutcome::Kind::tick:
        break;  // Heard, not said.
      case ButtonOutcome::Kind::run:
        carryOut(outcome.command, sample);
        break;
    }
  }
}

void DeviceButtons::carryOut(ButtonCommand command, const HapticSample& sample) {
  switch (command) {
    case ButtonCommand::where_am_i:
    case ButtonCommand::where_am_i_long:
      host_.announce(whereAmI(sample, command == ButtonCommand::where_am_i_long));
      return;
    case ButtonCommand::say_detail:
      host_.announce(detailText());
      return;
    case ButtonCommand::help:
      host_.announce(text(commands_.help()));
      return;
    case ButtonCommand::begin_move:
      host_.announce(tr("Move mode. Push the grip to a side; Forward when you are there."));
      return;
    case ButtonCommand::confirm_move:
      host_.announce(tr("Moved. %1").arg(detailText()));
      return;
    default:
      break;
  }
  // The window's own command, as by key or menu; it announces its result.
  if (!host_.run(text(commandName(command)))) {
    host_.announce(tr("%1 is not possible here.").arg(text(commandWords(command))));
  }
}

QString DeviceButtons::whereAmI(const HapticSample& sample, bool in_full) const {
  if (!host_.shownWindow()) return tr("Nothing is open.");
  const ViewMm at = sample.contact ? sample.proxy_view : sample.hip_view;
  QString said = sample.contact ? tr("Touching. ") : tr("In the air. ");
  said += tr("%1 right, %2 up, height %3 millimetres.")
              .arg(at.x, 0, 'f', 0)
              .arg(at.y, 0, 'f', 0)
              .arg(at.z, 0, 'f', 1);
  if (sample.contact && sample.origin != Origin::measured) {
    said += tr(" Not measured here: %1.").arg(text(name(sample.origin)));
  }
  if (in_full) said += QLatin1Char(' ') + detailText();
  return said;
}

QString DeviceButtons::detailText() const {
  const std::shared_ptr<const RegionWindow> window = host_.shownWindow();
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
    host.announce(QString::fromStdString(error.what()));
  }
  return std::make_unique<DeviceButtons>(host, std::move(hid));
}

}  // namespace relievo
