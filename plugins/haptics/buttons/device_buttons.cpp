// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/buttons/device_buttons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/failure.h"
#include "core/exhibit/visit.h"
#include "core/message/catalogue.h"
#include "core/region/hand.h"
#include "haptics/rt/realtime_thread.h"
#include "ui/message/message_text.h"

namespace relievo {

namespace {
constexpr double kRescanSeconds = 1;
// At full deflection of the cap: of the hand, or of the view.
constexpr double kFullPushMmPerS = 60, kFullTurnDegPerS = 60;
constexpr double kFullPushSidesPerS = 0.6, kFullPushTimesNearerPerS = 2.5;
}  // namespace

DeviceButtons::DeviceButtons(Host& host, std::unique_ptr<hid::HidDevices> hid,
                             std::shared_ptr<pad::Rumbler> rumbler)
    : host_(host), hid_(std::move(hid)), pads_(std::move(rumbler)) {}

void DeviceButtons::press(std::uint8_t button, bool down, double time_s) {
  if (down) host_.messages.hush();
  const std::uint32_t bit = button < 32 ? std::uint32_t{1} << button : 0;
  const bool is_taught = taught_ && !settings_.one_button;  // One button scans.
  if (down && (led_ || is_taught)) {
    let_go_ |= bit;
    led_ ? Q_EMIT letGo() : Q_EMIT taught(button);
    return;
  }
  if (!down && (let_go_ & bit) != 0) {
    let_go_ &= ~bit;
    return;
  }
  commands_.press(button, down, time_s);
}

void DeviceButtons::forgetPresses() {
  commands_.forgetPresses();
  let_go_ = 0;
}

void DeviceButtons::tellPlugs(const std::vector<std::string>& arrived,
                              const std::vector<std::string>& left) {
  for (const std::string& name : arrived) {
    host_.messages.announce(tr("%1 connected.").arg(QString::fromStdString(name)),
                            SaidBecause::noticed);
  }
  for (const std::string& name : left) {
    host_.messages.announce(tr("%1 disconnected.").arg(QString::fromStdString(name)),
                            SaidBecause::noticed);
  }
}

void DeviceButtons::readPads(double now_s) {
  pad::PadNews news;
  pads_.poll(news);
  tellPlugs(news.arrived, news.left);
  for (const pad::PadEdge& edge : news.edges) press(edge.button, edge.down, now_s);
}

bool DeviceButtons::areThere() const {
  return (hid_ && !hid_->names().empty()) || !pads_.seen().empty();
}

void DeviceButtons::readHid(double now_s) {
  if (now_s - scanned_s_ > kRescanSeconds) {
    scanned_s_ = now_s;
    if (hid_) hid_->look();
    pads_.look();
  }
  readPads(now_s);
  if (!hid_) return;
  hid::HidEvents news;
  hid_->poll(news, now_s);
  tellPlugs(news.arrived, news.left);
  for (const std::string& name : news.forbidden) {
    host_.messages.announce(
        tr("%1 is plugged in but this account may not use it. Install the rule that "
           "'relievo devices rule' prints, once, then replug.")
            .arg(QString::fromStdString(name)),
        SaidBecause::noticed);
  }
  for (const hid::ButtonEdge& edge : news.edges) press(edge.button, edge.down, now_s);
  const double dt_s = std::clamp(now_s - polled_s_, 0.0, 0.1);
  polled_s_ = now_s;
  pushCap(news.motion, dt_s);
}

void DeviceButtons::pushCap(const hid::CapMotion& motion, double dt_s) {
  if (settings_.space_mouse == SpaceMouseMoves::view) {
    pushView(motion, dt_s);
    return;
  }
  // A cap that is pushed is always tilted a little, too: its turns do nothing to the view that the
  // hand is seen in, and the hand has none.
  const double mm = kFullPushMmPerS * dt_s;
  const DeviceMm by{mm * motion.right, mm * motion.up, mm * motion.toward};
  if (by != DeviceMm{}) Q_EMIT handPushed(by);
}

/// The relief does what the cap does, or the scan in 3-D, which alone has a third angle.
void DeviceButtons::pushView(const hid::CapMotion& motion, double dt_s) {
  const double deg = kFullTurnDegPerS * dt_s;
  if (motion.about_right != 0 || motion.about_up != 0 || motion.about_toward != 0) {
    host_.view.turnView(-deg * motion.about_up, deg * motion.about_right,
                        deg * motion.about_toward);
  }
  const double sides = kFullPushSidesPerS * dt_s;
  if (motion.right != 0 || motion.up != 0 || motion.toward != 0) {
    host_.view.pushView({.right = sides * motion.right,
                         .up = sides * motion.up,
                         .nearer = std::pow(kFullPushTimesNearerPerS, motion.toward * dt_s)});
  }
}

void DeviceButtons::setSettings(const ButtonSettings& settings) {
  settings_ = settings;
  commands_.setOptions({.one_button = settings.one_button, .scan_s = settings.scan_s});
}

void DeviceButtons::frame(const HapticSample& sample, double now_s) {
  sample_ = sample;
  commands_.setForcesOn(sample.engaged != EngagePhase::off);
  commands_.setVoice(host_.messages.hasVoice());
  if (settings_.one_button) {
    commands_.setChoosing(taught_ || host_.controls.run(QString::fromLatin1(kButtonFirst)));
  }
  readHid(now_s);
  if (detent_.on && !host_.view.shownWindow()) cancelMoving();
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

/// Who has other use for the buttons now, as an exhibit's list of objects has, is asked first.
bool DeviceButtons::takenByWindow(ButtonCommand command) {
  const std::string_view name = commandName(command);
  // Stopping is never another's, and the end of Move mode is the buttons' own.
  if (command == ButtonCommand::confirm_move || command == ButtonCommand::cancel_move ||
      command == ButtonCommand::stop_forces) {
    return false;
  }
  const QString asked = QString::fromLatin1(kButtonFirst) +
                        QString::fromLatin1(name.data(), static_cast<int>(name.size()));
  if (!host_.controls.run(asked)) return false;
  if (command == ButtonCommand::begin_move) commands_.cancelMoving();
  return true;
}

/// In the introduction, of who has one button: the task again, the next one, or no more.
bool DeviceButtons::carryOutTaught(ButtonCommand command) {
  switch (command) {
    case ButtonCommand::take:
      Q_EMIT taught(ButtonCommands::kCentre);
      return true;
    case ButtonCommand::next:
      Q_EMIT taught(ButtonCommands::kForward);
      return true;
    case ButtonCommand::back:
      host_.controls.run(QStringLiteral("touchIntroduction"));
      return true;
    default:
      return false;
  }
}

void DeviceButtons::carryOut(ButtonCommand command) {
  if (taught_ && carryOutTaught(command)) return;
  if (takenByWindow(command)) return;
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
  if (!detent_.on) return;
  MoveDetent detent = detent_;
  detent.blocked = host_.view.edges();
  setDetent(detent);
}

bool DeviceButtons::carryOutMove(ButtonCommand command) {
  switch (command) {
    case ButtonCommand::begin_move: {
      const std::shared_ptr<const RegionWindow> window = host_.view.shownWindow();
      if (!window) {
        commands_.cancelMoving();
        host_.messages.say({said<MessageId::place_nothing_open>()});
        return true;
      }
      moved_from_ = window->region;
      setDetent({.on = true, .centre = sample_.hip, .blocked = host_.view.edges()});
      host_.messages.announce(
          tr("Move mode. Push the grip to a side; Forward when you are there."));
      return true;
    }
    case ButtonCommand::confirm_move:
      setDetent({});
      saySituation(said<MessageId::place_moved>());
      return true;
    case ButtonCommand::cancel_move:
      if (!detent_.on) return true;  // It never began.
      setDetent({});
      host_.view.showRegion(moved_from_);
      saySituation(said<MessageId::place_moved_back>());
      return true;
    default:
      return false;
  }
}

void DeviceButtons::setDetent(const MoveDetent& detent) {
  if (detent == detent_) return;
  detent_ = detent;
  Q_EMIT detentChanged();
}

void DeviceButtons::whereAmI(bool in_full) {
  if (!host_.view.shownWindow()) {
    host_.messages.say({said<MessageId::place_nothing_open>()});
    return;
  }
  const HandPlace place = handPlace();
  host_.messages.say(in_full ? longWords(place) : shortWords(place));
}

void DeviceButtons::sayDetail() {
  host_.messages.say(host_.view.shownWindow()
                         ? detailWords(handPlace())
                         : std::vector<Message>{said<MessageId::place_nothing_open>()});
}

void DeviceButtons::saySituation(const Message& after) {
  std::vector<Message> words{after};
  if (host_.view.shownWindow()) words.push_back(detailWords(handPlace()).front());
  host_.messages.say(words);
}

void DeviceButtons::sayHelp() {
  commands_.setVoice(host_.messages.hasVoice());
  host_.messages.say(commands_.help(1e-9 * static_cast<double>(monotonicNs())));
}

void DeviceButtons::toggleMoving() {
  commands_.toggleMoving();
  takeOutcomes(1e-9 * static_cast<double>(monotonicNs()));
}

void DeviceButtons::cancelMoving() {
  commands_.cancelMoving();
  takeOutcomes(1e-9 * static_cast<double>(monotonicNs()));
}

HandPlace DeviceButtons::handPlace() const {
  const std::shared_ptr<const RegionWindow> window = host_.view.shownWindow();
  HandPlace place;
  place.touching = sample_.contact;
  place.at = sample_.contact ? sample_.proxy_view : sample_.hip_view;
  place.origin = sample_.origin;
  const ObjectPlace object = host_.view.placeAt(place.at.x, place.at.y);
  place.object = {object.left_mm, object.bottom_mm, object.width_mm, object.height_mm};
  place.name = object.name.toStdString();
  place.spacing_mm = object.spacing_mm;
  place.detail = window->levels - window->region.level.value;
  place.details = window->levels;
  place.side_mm = window->region.side_mm;
  place.object_mm_per_hand_mm = handMapping(*window).objectMmPerHandMm();
  // The window's heights have its gain.
  place.at.z /= window->gain;
  return place;
}

std::unique_ptr<DeviceButtons> makeDeviceButtons(Host& host,
                                                 std::shared_ptr<pad::Rumbler> rumbler) {
  std::unique_ptr<hid::HidDevices> hid;
  try {
    hid = std::make_unique<hid::HidDevices>();
  } catch (const DeviceError& error) {
    host.messages.announce(messageText(messageOf(error)));
  }
  return std::make_unique<DeviceButtons>(host, std::move(hid), std::move(rumbler));
}

}  // namespace relievo
