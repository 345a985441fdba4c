// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/hand_device.h"

#include <optional>
#include <utility>

#include "core/base/failure.h"
#include "haptics/device/falcon/presence.h"
#include "haptics/device/haply/device_search.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/rt/realtime_thread.h"
#include "plugins/haptics/buttons/rumble_sink.h"
#include "plugins/haptics/device/device_setup_dialog.h"
#include "plugins/haptics/device/haply_setup_dialog.h"
#include "ui/message/message_text.h"

namespace relievo {

namespace {
constexpr int kReadoutsPerLook = 16;  // About two seconds.

/// The plug tells when it is there; that it is free, or allowed, tells nobody.
bool onlyThePlugHelps(const Error& error) {
  const auto* of_falcon = dynamic_cast<const falcon::OpeningError*>(&error);
  return of_falcon == nullptr || falcon::onlyThePlugHelps(of_falcon->presence());
}
}  // namespace

HandDevice::HandDevice(TouchParts& parts) : parts_(parts) {
  connect(&plugin_devices_, &PluginDevices::found, this,
          [this](const std::vector<PluginDevice>& devices) {
            if (parts_.panel) parts_.panel->setPluginDevices(devices);
          });
}

HandDevice::~HandDevice() = default;

void HandDevice::open() {
  Q_EMIT leaving();
  session_.reset();  // One program at a time can hold a device.
  opening_.reset();
  news_ = {};
  haply_told_.clear();
  events_.reset();
  fallback_.clear();
  readouts_until_look_ = 0;
  opened_ = parts_.settings.device;
  try {
    if (isPluginDevice(opened_)) return beginOpening();
    session_ = std::make_unique<LoopSession>(opened_, rumbleSink(parts_.rumbler));
  } catch (const DeviceError& error) {
    return openMouse(error, onlyThePlugHelps(error));
  } catch (const Error& error) {  // A setting of the environment that names no place, say.
    return openMouse(error, true);
  }
  const auto choice = falcon::falconChoice(opened_);
  if (!choice || !choice->any()) return;
  // The only one: from now on it is the one that is meant and remembered.
  parts_.requested = parts_.settings.device = opened_ = session_->loop().device().id;
  if (!parts_.panel) return;
  parts_.panel->listDevices();
  parts_.showSettings();
}

/// In the place of a device that could not be opened.
void HandDevice::openMouse(const Error& error, bool only_the_plug_helps) {
  if (parts_.settings.device == kMouseDevice)
    throw;  // Within a handler: the error that was caught.
  showStandIn(messageOf(error), only_the_plug_helps);
  parts_.settings.device = opened_ = kMouseDevice;
  session_ = std::make_unique<LoopSession>(kMouseDevice, rumbleSink(parts_.rumbler));
  parts_.showSettings();
}

/// Of a plug-in's device; the mouse takes its place meanwhile.
void HandDevice::beginOpening() {
  opening_ = std::make_unique<DeviceOpening>(opened_);
  session_ = std::make_unique<LoopSession>(kMouseDevice, rumbleSink(parts_.rumbler));
  fallback_ =
      tr("The device %1 is being opened. The mouse is the hand meanwhile.").arg(opening_->name());
  parts_.host.messages.announce(fallback_);
}

void HandDevice::watchOpening() {
  if (!opening_ || !opening_->isDone()) return;
  const std::unique_ptr<DeviceOpening> done = std::move(opening_);
  Q_EMIT forcesEnd(SaidBecause::noticed);
  Q_EMIT leaving();
  try {
    auto device = done->take();
    session_.reset();
    session_ =
        std::make_unique<LoopSession>(std::move(device), opened_, rumbleSink(parts_.rumbler));
    fallback_.clear();
    parts_.host.messages.announce(tr("Device: %1.").arg(done->name()), SaidBecause::noticed);
  } catch (const Error& error) {
    showStandIn(messageOf(error), true);
  }
  if (!session_ || !fallback_.isEmpty()) {
    parts_.settings.device = opened_ = kMouseDevice;
    if (!session_)
      session_ = std::make_unique<LoopSession>(kMouseDevice, rumbleSink(parts_.rumbler));
    parts_.showSettings();
  }
  Q_EMIT changed();
}

void HandDevice::change() {
  Q_EMIT forcesEnd(SaidBecause::asked);
  open();
  Q_EMIT changed();
  if (opened_ != parts_.requested || opening_) return;  // What is, has been said.
  const QString name = QString::fromStdString(session_->loop().device().name);
  parts_.host.messages.announce(tr("Device: %1.").arg(name));
}

void HandDevice::openAnew() {
  if (isReplaced()) return choose(parts_.requested);
  change();
}

TouchDevice HandDevice::stateOf(DeviceFault fault) const {
  if (isReplaced()) return TouchDevice::gone;
  if (opening_ || fault == DeviceFault::not_ready) return TouchDevice::preparing;
  return fault == DeviceFault::none ? TouchDevice::ready : TouchDevice::gone;
}

void HandDevice::useSettings() {
  if (session_ && parts_.settings.device != opened_) change();
}

void HandDevice::choose(const std::string& id) {
  parts_.requested = parts_.settings.device = id;
  parts_.showSettings();
  useSettings();
}

void HandDevice::startWatchingPlugs() {
  plugs_ = std::make_unique<falcon::PlugWatch>();
}

void HandDevice::stopLooking() {
  opening_.reset();
  plugs_.reset();
  plugin_devices_.disconnect(this);
  delete setup_;  // Zero force, joins.
}

void HandDevice::showStandIn(const Message& message, bool only_the_plug_helps) {
  const bool may_be_free = falcon::falconChoice(parts_.requested) && !only_the_plug_helps;
  readouts_until_look_ = may_be_free ? kReadoutsPerLook : 0;
  const QString text = tr("%1 The mouse is the hand now.").arg(screenText(message));
  if (text == fallback_) return;
  fallback_ = text;
  parts_.host.messages.announce(tr("%1 The mouse is the hand now.").arg(spokenMessage(message)),
                                SaidBecause::noticed);
}

void HandDevice::report(LoopReport& report) {
  const DeviceInfo& device = session_->loop().device();
  report.device = QString::fromStdString(device.name);
  announceState(report);
  report.actuated = device.max_force_n > 0;
  report.fallback = fallback_;
  report.heat = heatText();
}

void HandDevice::announceState(LoopReport& report) {
  if (const haply::LinkStatus* of_haply = session_->haplyStatus()) {
    const Message message = haply::describe(*of_haply);
    report.device = spokenMessage(message);
    if (of_haply->state != haply::LinkState::ready) report.not_ready = screenText(message);
    const bool is_news = of_haply->state != haply::LinkState::checking &&
                         std::exchange(haply_told_, report.device) != report.device;
    if (is_news) parts_.host.messages.announce(report.device, SaidBecause::noticed);
    announceEvents(*of_haply);
    return;
  }
  const falcon::LinkStatus* status = session_->falconStatus();
  if (status == nullptr) return;
  report.device = spokenMessage(falcon::describe(*status));
  if (status->state != falcon::LinkState::ready) report.not_ready = windowText(*status);
  for (const QString& words : news_.take(*status)) {
    parts_.host.messages.announce(words, SaidBecause::noticed);
  }
}

/// Batteries, brakes, trembling: what its states do not tell. That this device is plugged in or
/// gone, they do.
void HandDevice::announceEvents(const haply::LinkStatus& status) {
  if (!events_) events_ = std::make_unique<haply::EventChannel>(haply::serviceAddress());
  const std::int64_t now_ns = monotonicNs();
  for (const haply::ServiceEvent& event : events_->poll(now_ns)) {
    const bool is_plug =
        event.kind == haply::EventKind::connected || event.kind == haply::EventKind::disconnected;
    // While it is gone its state has no id.
    const bool is_own = event.device.empty() || status.id.empty() || event.device == status.id;
    if ((is_plug && is_own) || !event_news_.isNews(event, now_ns)) continue;
    parts_.host.messages.say({haply::describe(event)}, SaidBecause::noticed);
  }
}

QString HandDevice::heatText() const {
  const auto heat = session_->foreign() == nullptr ? std::nullopt : session_->foreign()->heat();
  constexpr double kWorthSaying = 0.5;
  if (!heat || heat->used < kWorthSaying) return {};
  return tr("Motors: %1 % of what they can take for good; forces stay below %2 N.")
      .arg(100 * heat->used, 0, 'f', 0)
      .arg(heat->allowed_n, 0, 'f', 1);
}

/// For a Falcon that was there and could not be opened.
void HandDevice::lookAgain() {
  try {
    falcon::UsbBus bus(falcon::falconChoice(parts_.requested).value_or(falcon::FalconChoice{}));
    const falcon::Opening opening = bus.open();
    if (opening.presence != falcon::Presence::present) {
      showStandIn(falcon::describe(opening), falcon::onlyThePlugHelps(opening.presence));
      return;
    }
  } catch (const DeviceError&) {
    readouts_until_look_ = kReadoutsPerLook;
    return;  // What stands there is still true.
  }
  choose(parts_.requested);
}

void HandDevice::watchPlugs() {
  // Who lets go of it, and who gives access to it, tells nobody.
  if (readouts_until_look_ > 0 && !setup_ && --readouts_until_look_ == 0) lookAgain();
  if (!plugs_ || !plugs_->changed()) return;
  if (parts_.panel) parts_.panel->listDevices();
  if (setup_ || opened_.starts_with("falcon")) return;  // They wait for it themselves.
  const bool here = !falcon::seenFalcons().empty();
  if (here && falcon::falconChoice(parts_.requested)) {
    lookAgain();
  } else if (here) {
    parts_.host.messages.announce(
        tr("A Falcon was plugged in. Choose it in the panel Touch to use it."),
        SaidBecause::noticed);
  }
}

/// The Falcon is what most have who ask; a service of Haply's that runs, and no Falcon, means the
/// other. Each assistant leads to the other one.
HandDevice::Kind HandDevice::kindToSetUp() const {
  if (haply::chosenBy(parts_.requested)) return Kind::haply;
  if (falcon::falconChoice(parts_.requested) || !haply::isServiceThere()) return Kind::falcon;
  return falcon::seenFalcons().empty() ? Kind::haply : Kind::falcon;
}

void HandDevice::setUp() {
  if (setup_) {
    setup_->raise();
    setup_->activateWindow();
    return;
  }
  beginSetUp(kindToSetUp());
}

void HandDevice::beginSetUp(Kind kind) {
  const std::string before = parts_.requested;
  Q_EMIT forcesEnd(SaidBecause::asked);
  if (falcon::falconChoice(opened_) || haply::chosenBy(opened_)) {  // The dialog holds it now.
    parts_.settings.device = kMouseDevice;
    change();
  }
  QWidget* const window = parts_.panel ? parts_.panel->window() : nullptr;
  try {
    if (kind == Kind::haply) {
      setup_ = makeHaplySetup(haply::chosenBy(before).value_or(std::string()), window);
    } else {
      setup_ =
          makeDeviceSetup(falcon::falconChoice(before).value_or(falcon::FalconChoice{}), window);
    }
  } catch (const Error& error) {  // No USB on this computer, or a setting that names no place.
    parts_.host.messages.showError(messageText(messageOf(error)), {});
    choose(before);
    return;
  }
  connect(setup_, &SetUpDialog::said, this,
          [this](const QString& text) { parts_.host.messages.announce(text); });
  connect(
      setup_, &SetUpDialog::otherAsked, this,
      [this, kind] {
        setup_->disconnect(this);
        delete setup_;  // It lets go of its device.
        beginSetUp(kind == Kind::haply ? Kind::falcon : Kind::haply);
      },
      Qt::QueuedConnection);
  connect(setup_, &QDialog::finished, this, [this, before](int result) {
    if (!session_) return;
    const bool used = result == QDialog::Accepted && setup_;
    choose(used ? setup_->deviceId() : before);
  });
  setup_->show();
}

void HandDevice::endSetUpBeforeSleep() {
  if (setup_) setup_->endBeforeSleep();
}

}  // namespace relievo
