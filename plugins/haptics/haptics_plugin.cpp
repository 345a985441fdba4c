// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/haptics_plugin.h"

#include <algorithm>
#include <array>
#include <optional>
#include <QAction>
#include <QApplication>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <utility>

#include "core/base/failure.h"
#include "core/region/hand.h"
#include "haptics/device/falcon/presence.h"
#include "haptics/record/events.h"
#include "plugins/haptics/recording/recording_file.h"
#include "ui/message/message_text.h"

namespace relievo {

namespace {
constexpr const char* kMouse = "mouse";  // Always there.
constexpr int kReadoutsPerLook = 16;     // About two seconds.

/// The plug tells when it is there; that it is free, or allowed, tells nobody.
bool onlyThePlugHelps(const DeviceError& error) {
  const auto* of_falcon = dynamic_cast<const falcon::OpeningError*>(&error);
  return of_falcon == nullptr || falcon::onlyThePlugHelps(of_falcon->presence());
}
}  // namespace

HapticsPlugin::~HapticsPlugin() {
  detach();
}

void HapticsPlugin::attach(Host& host) {
  host_ = &host;
  openDevice();
  panel_ = new HapticsPanel;  // The host owns it from addPanel on.
  panel_->setSettings(settings_);
  host.controls.addPanel(tr("Touch"), panel_);
  host.controls.addPanel(tr("Touch: advanced"), panel_->advanced());
  actions_ = addTouchActions(host);
  buttons_ = makeDeviceButtons(host);
  buttons_panel_ = new ButtonsPanel;  // The host owns it from addPanel on.
  buttons_panel_->setSettings(button_settings_);
  host.controls.addPanel(tr("Buttons"), buttons_panel_);
  connectButtons();
  connectControls();
  connectHost();
  applySettings();
  if (const auto window = host.view.shownWindow()) showWindow(*window);
  constexpr int kFrameMs = 16;
  connect(&timer_, &QTimer::timeout, this, &HapticsPlugin::frame);
  timer_.start(kFrameMs);
  plugs_ = std::make_unique<falcon::PlugWatch>();
  sleep_ = std::make_unique<SleepWatch>();
  slowReadouts();
  restoreFirmness();
}

void HapticsPlugin::openDevice() {
  endRecording();
  session_.reset();  // One program at a time can hold a device.
  opening_.reset();
  news_ = {};
  haply_told_.clear();
  stand_in_.clear();
  readouts_until_look_ = 0;
  opened_ = settings_.device;
  try {
    if (isPluginDevice(opened_)) return beginOpening();
    session_ = std::make_unique<LoopSession>(settings_.device);
  } catch (const DeviceError& error) {
    if (settings_.device == kMouse) throw;
    showStandIn(messageOf(error), onlyThePlugHelps(error));
    settings_.device = opened_ = kMouse;
    session_ = std::make_unique<LoopSession>(kMouse);
    if (panel_) panel_->setSettings(settings_);
    return;
  } catch (const Error& error) {  // A setting of the environment that names no place, say.
    if (settings_.device == kMouse) throw;
    showStandIn(messageOf(error), true);
    settings_.device = opened_ = kMouse;
    session_ = std::make_unique<LoopSession>(kMouse);
    if (panel_) panel_->setSettings(settings_);
    return;
  }
  const auto choice = falcon::falconChoice(opened_);
  if (!choice || !choice->any()) return;
  // The only one: from now on it is the one that is meant and remembered.
  wish_ = settings_.device = opened_ = session_->loop().device().id;
  if (!panel_) return;
  panel_->listDevices();
  panel_->setSettings(settings_);
}

void HapticsPlugin::beginOpening() {
  opening_ = std::make_unique<DeviceOpening>(opened_);
  session_ = std::make_unique<LoopSession>(kMouse);
  stand_in_ =
      tr("The device %1 is being opened. The mouse is the hand meanwhile.").arg(opening_->name());
  host_->messages.announce(stand_in_);
}

void HapticsPlugin::watchOpening() {
  if (!opening_ || !opening_->isDone()) return;
  const std::unique_ptr<DeviceOpening> done = std::move(opening_);
  dropForces();
  if (buttons_) buttons_->cancelMoving();
  endRecording();
  try {
    auto device = done->take();
    session_.reset();
    session_ = std::make_unique<LoopSession>(std::move(device), opened_);
    stand_in_.clear();
    host_->messages.announce(tr("Device: %1.").arg(done->name()), SaidBecause::noticed);
  } catch (const DeviceError& error) {
    showStandIn(messageOf(error), true);
  } catch (const Error& error) {
    showStandIn(messageOf(error), true);
  }
  if (!session_ || !stand_in_.isEmpty()) {
    settings_.device = opened_ = kMouse;
    if (!session_) session_ = std::make_unique<LoopSession>(kMouse);
    if (panel_) panel_->setSettings(settings_);
  }
  shown_ = {};
  given_window_ = 0;
  fault_ = DeviceFault::none;
  applySettings();
  if (const auto window = host_->view.shownWindow()) showWindow(*window);
}

QString HapticsPlugin::heatText() const {
  const auto heat = session_->foreign() == nullptr ? std::nullopt : session_->foreign()->heat();
  constexpr double kWorthSaying = 0.5;
  if (!heat || heat->used < kWorthSaying) return {};
  return tr("Motors: %1 % of what they can take for good; forces stay below %2 N.")
      .arg(100 * heat->used, 0, 'f', 0)
      .arg(heat->allowed_n, 0, 'f', 1);
}

void HapticsPlugin::showStandIn(const Message& message, bool only_the_plug_helps) {
  readouts_until_look_ = falcon::falconChoice(wish_) && !only_the_plug_helps ? kReadoutsPerLook : 0;
  const QString text = tr("%1 The mouse is the hand now.").arg(screenText(message));
  if (text == stand_in_) return;
  stand_in_ = text;
  host_->messages.announce(tr("%1 The mouse is the hand now.").arg(spokenMessage(message)),
                           SaidBecause::noticed);
}

void HapticsPlugin::changeDevice() {
  setForces(false);
  if (buttons_) buttons_->cancelMoving();
  shown_ = {};
  fault_ = DeviceFault::none;
  openDevice();
  applySettings();
  if (const auto window = host_->view.shownWindow()) showWindow(*window);
  if (opened_ != wish_ || opening_) return;  // What is, has been said.
  const QString name = QString::fromStdString(session_->loop().device().name);
  host_->messages.announce(tr("Device: %1.").arg(name));
}

void HapticsPlugin::chooseDevice(const std::string& id) {
  wish_ = settings_.device = id;
  if (panel_) panel_->setSettings(settings_);
  if (session_ && settings_.device != opened_) changeDevice();
}

void HapticsPlugin::detach() noexcept {
  if (!session_) {  // It was attached and could not go on.
    host_ = nullptr;
    return;
  }
  timer_.stop();
  opening_.reset();
  plugs_.reset();
  sleep_.reset();
  disconnect(&host_->view, nullptr, this, nullptr);
  disconnect(&plugin_devices_, nullptr, this, nullptr);
  delete setup_;  // Zero force, joins.
  endRecording();
  buttons_.reset();
  session_.reset();  // Zero force, joins, closes an open recording.
  forces_asked_ = false;
  firmness_.reset();
  firmness_awaited_.clear();
  finer_window_ = 0;
  shown_ = {};
  given_window_ = 0;
  host_ = nullptr;
}

void HapticsPlugin::connectHost() {
  connect(&host_->view, &ShownWindow::windowShown, this,
          [this](const std::shared_ptr<const RegionWindow>& window) {
            if (window && session_ && window->id != given_window_) showWindow(*window);
          });
  connect(&host_->view, &ShownWindow::handMoved, this, [this](const HandTarget& target) {
    if (!session_) return;
    // It is over what the host shows, whoever heard first of another window.
    const auto window = host_->view.shownWindow();
    if (window && window->id != given_window_) showWindow(*window);
    session_->moveHand(target.position);
  });
  connect(&host_->view, &ShownWindow::finerHeightsRead, this, &HapticsPlugin::takeFiner);
  connect(&host_->view, &ShownWindow::firmnessRead, this, &HapticsPlugin::takeFirmness);
  connect(&host_->view, &ShownWindow::closing, this, [this] { setForces(false); });
}

void HapticsPlugin::connectControls() {
  connect(actions_.forces, &QAction::toggled, this, &HapticsPlugin::setForces);
  connect(actions_.forces_off, &QAction::triggered, this, [this] { setForces(false); });
  connect(actions_.stronger, &QAction::triggered, this, [this] { changeStrength(kStrengthStep); });
  connect(actions_.weaker, &QAction::triggered, this, [this] { changeStrength(-kStrengthStep); });
  connect(actions_.record, &QAction::toggled, this, &HapticsPlugin::setRecording);
  connect(actions_.note, &QAction::triggered, this, &HapticsPlugin::askNote);
  connect(actions_.setup, &QAction::triggered, this, &HapticsPlugin::setUpDevice);
  connect(panel_, &HapticsPanel::devicesWanted, &plugin_devices_, &PluginDevices::look);
  connect(&plugin_devices_, &PluginDevices::found, this,
          [this](const std::vector<PluginDevice>& devices) {
            if (panel_) panel_->setPluginDevices(devices);
          });
  connect(panel_, &HapticsPanel::forcesAsked, this, &HapticsPlugin::setForces);
  connect(panel_, &HapticsPanel::firmnessAsked, this, [this](const QString& file) {
    if (!file.isEmpty()) return askFirmness(file, true);
    firmness_awaited_.clear();
    setFirmness(nullptr);
    host_->messages.announce(tr("The ground is firm where it was measured."));
  });
  connect(panel_, &HapticsPanel::settingsChanged, this, [this] {
    // What has no control stays.
    TouchSettings settings = panel_->settings();
    settings.window_silence_s = settings_.window_silence_s;
    settings.bound_by_rate = settings_.bound_by_rate;
    settings_ = settings;
    if (settings_.device != opened_) {
      wish_ = settings_.device;
      changeDevice();
    }
    applySettings();
    applySurface();
  });
}

void HapticsPlugin::connectButtons() {
  buttons_->setSettings(button_settings_);
  connect(buttons_.get(), &DeviceButtons::handPushed, this, [this](const DeviceMm& by) {
    if (session_ && host_->view.shownWindow()) session_->pushHand(by);
  });
  connect(buttons_.get(), &DeviceButtons::ticked, qApp, &QApplication::beep);
  connect(buttons_.get(), &DeviceButtons::gateChanged, this, [this] {
    const bool moving = buttons_->moving();
    actions_.move_mode->setChecked(moving);
    actions_.move_back->setEnabled(moving);
    if (session_) session_->setMoving(moving);
    applySettings();
  });
  connect(buttons_panel_, &ButtonsPanel::settingsChanged, this, [this] {
    button_settings_ = buttons_panel_->settings();
    buttons_->setSettings(button_settings_);
    applySettings();
  });
  connect(actions_.use_mouse, &QAction::triggered, this, [this] { chooseDevice(kMouse); });
  connect(actions_.move_mode, &QAction::triggered, this, [this] {
    buttons_->toggleMoving();
    actions_.move_mode->setChecked(buttons_->moving());
  });
  connect(actions_.move_back, &QAction::triggered, this, [this] { buttons_->cancelMoving(); });
  connect(actions_.where_am_i, &QAction::triggered, this, [this] { buttons_->whereAmI(false); });
  connect(actions_.where_am_i_long, &QAction::triggered, this,
          [this] { buttons_->whereAmI(true); });
  connect(actions_.say_detail, &QAction::triggered, this, [this] { buttons_->sayDetail(); });
  connect(actions_.button_help, &QAction::triggered, this, [this] { buttons_->sayHelp(); });
}

void HapticsPlugin::setForces(bool on) {
  if (!session_) return;
  if (on && !session_->hasWindow()) {
    host_->messages.announce(tr("Nothing to touch yet. Open a scan first."));
    on = false;
  }
  const foreign::ForeignDevice* const of_plugin = session_->foreign();
  if (on && of_plugin != nullptr && (of_plugin->isLost() || fault_ == DeviceFault::disconnected)) {
    // Its host is no more, or its cable was pulled: it is opened anew, and forces wait for another
    // wish.
    changeDevice();
    on = false;
  }
  if (on) session_->retryDevice();
  const bool changed = on != forces_asked_;
  forces_asked_ = on;
  {
    const QSignalBlocker blocker(actions_.forces);
    actions_.forces->setChecked(on);
  }
  actions_.forces_off->setEnabled(on);
  if (panel_) panel_->setForcesAsked(on);
  session_->loop().sayAlive();  // Whoever asks is there, though no frame came for a while.
  applySettings();
  if (changed) slowReadouts();  // Escape must know at once that there is something to stop.
  if (changed) host_->messages.announce(on ? tr("Forces on.") : tr("Forces off."), forces_because_);
}

void HapticsPlugin::dropForces() {
  const QScopedValueRollback<SaidBecause> because(forces_because_, SaidBecause::noticed);
  setForces(false);
}

void HapticsPlugin::changeStrength(int percent) {
  if (!session_) return;
  settings_.strength_percent = std::clamp(settings_.strength_percent + percent, 0, 100);
  if (panel_) panel_->setSettings(settings_);
  applySettings();
  host_->messages.announce(tr("Strength %1 percent.").arg(settings_.strength_percent));
}

void HapticsPlugin::applySettings() {
  if (!session_) return;
  HapticOptions options = hapticOptions(settings_, forces_asked_);
  if (buttons_) options.gate = buttons_->gate();
  constexpr std::uint32_t kAnyButton = 0b1111;
  if (button_settings_.one_button) options.stop.buttons = kAnyButton;
  session_->setOptions(options);
}

void HapticsPlugin::frame() {
  session_->loop().sayAlive();
  const HapticSample sample = session_->update();
  if (session_->hasWindow() && sample.window_id != 0) {
    const Probe probe = probeOf(sample);
    if (!looksTheSame(probe, shown_)) {
      shown_ = probe;
      host_->touch.showProbe(probe);
    }
  }
  const std::vector<ForcePoint> plot = session_->takePlot();
  if (!plot.empty()) {
    host_->touch.plot(plot);
    if (panel_) panel_->plot(plot);
  }
  watchSurface();
  watchFault(sample);
  watchStop(sample);
  watchEdge(sample);
  watchWaiting(sample);
  watchSoftening(sample);
  watchRate(sample);
  watchRecording();
  runButtons(sample);
  watchSleep(sample);
  constexpr int kFramesPerReadout = 8, kFramesPerStatus = 32;
  ++frames_;
  if (frames_ % kFramesPerReadout != 0) return;
  slowReadouts(frames_ % kFramesPerStatus == 0);
  watchOpening();  // Not within the readouts, which setForces() asks for while it works.
}

void HapticsPlugin::slowReadouts(bool with_status) {
  LoopReport report;
  report.sample = session_->update();
  report.stats = session_->stats();
  report.realtime = session_->loop().realtime();
  const DeviceInfo& device = session_->loop().device();
  report.device = QString::fromStdString(device.name);
  watchDevice(report);
  report.actuated = device.max_force_n > 0;
  report.stand_in = stand_in_;
  report.heat = heatText();
  if (panel_) panel_->show(report);
  if (with_status) tellStatus(report);
  watchPlugs();
}

// Its numbers change with every look, and each change is a picture of the window.
void HapticsPlugin::tellStatus(const LoopReport& report) {
  TouchStatus status;
  status.device = report.device;
  status.rate_hz = report.stats.rate_hz;
  status.worst_period_ms = report.stats.worst_period_ms;
  status.late_ticks = report.stats.late_ticks;
  status.realtime = report.realtime.realtime;
  status.realtime_note = QString::fromStdString(report.realtime.note);
  status.forces_on = forces_asked_;
  status.recording = session_->recorder().running();
  status.recorded_samples = session_->recorder().samples();
  status.stiffness_n_per_mm = report.sample.stiffness_n_per_mm;
  host_->touch.showStatus(status);
}

void HapticsPlugin::watchDevice(LoopReport& report) {
  if (const haply::LinkStatus* of_haply = session_->haplyStatus()) {
    const Message message = haply::describe(*of_haply);
    report.device = spokenMessage(message);
    if (of_haply->state != haply::LinkState::ready) report.not_ready = screenText(message);
    const bool is_news = of_haply->state != haply::LinkState::checking &&
                         std::exchange(haply_told_, report.device) != report.device;
    if (is_news) host_->messages.announce(report.device, SaidBecause::noticed);
    return;
  }
  const falcon::LinkStatus* status = session_->falconStatus();
  if (status == nullptr) return;
  report.device = spokenMessage(falcon::describe(*status));
  if (status->state != falcon::LinkState::ready) report.not_ready = windowText(*status);
  for (const QString& words : news_.take(*status)) {
    host_->messages.announce(words, SaidBecause::noticed);
  }
}

void HapticsPlugin::watchSleep(const HapticSample& sample) {
  switch (sleep_->poll()) {
    case SleepWatch::News::about_to_sleep:
      dropForces();
      if (setup_) setup_->endBeforeSleep();
      frames_at_zero_ = 0;
      break;
    case SleepWatch::News::woken:
      frames_at_zero_ = -1;
      host_->messages.announce(tr("Forces are off after the sleep. Press F5 to switch them on."),
                               SaidBecause::noticed);
      break;
    case SleepWatch::News::none:
      break;
  }
  if (frames_at_zero_ < 0 || sample.engaged != EngagePhase::off) return;
  // Zero reaches the wire within two ticks, unless the driver is busy asking again.
  constexpr int kFramesUntilSent = 3;
  if (++frames_at_zero_ == kFramesUntilSent) sleep_->letSleep();
}

void HapticsPlugin::lookAgain() {
  try {
    falcon::UsbBus bus(falcon::falconChoice(wish_).value_or(falcon::FalconChoice{}));
    const falcon::Opening opening = bus.open();
    if (opening.presence != falcon::Presence::present) {
      showStandIn(falcon::describe(opening), falcon::onlyThePlugHelps(opening.presence));
      return;
    }
  } catch (const DeviceError&) {
    readouts_until_look_ = kReadoutsPerLook;
    return;  // What stands there is still true.
  }
  chooseDevice(wish_);
}

void HapticsPlugin::watchPlugs() {
  // Who lets go of it, and who gives access to it, tells nobody.
  if (readouts_until_look_ > 0 && !setup_ && --readouts_until_look_ == 0) lookAgain();
  if (!plugs_ || !plugs_->changed()) return;
  if (panel_) panel_->listDevices();
  if (setup_ || opened_.starts_with("falcon")) return;  // They wait for it themselves.
  const bool here = !falcon::seenFalcons().empty();
  if (here && falcon::falconChoice(wish_)) {
    lookAgain();
  } else if (here) {
    host_->messages.announce(tr("A Falcon was plugged in. Choose it in the panel Touch to use it."),
                             SaidBecause::noticed);
  }
}

void HapticsPlugin::watchSurface() {
  const std::string problem = session_->takeProblem();
  if (problem.empty()) return;
  dropForces();
  host_->messages.announce(QString::fromStdString(problem), SaidBecause::noticed);
}

void HapticsPlugin::watchFault(const HapticSample& sample) {
  if (sample.fault == fault_) return;
  fault_ = sample.fault;
  if (fault_ == DeviceFault::none) return;
  dropForces();
  host_->messages.announce(tr("Forces off: %1.").arg(messageText(messageOf(fault_))),
                           SaidBecause::noticed);
}

/// The loop has ended the forces already; the window follows.
void HapticsPlugin::watchStop(const HapticSample& sample) {
  if (!forces_asked_ || sample.stopped == StopReason::none) return;
  const bool silent = sample.stopped == StopReason::window_silent;
  dropForces();
  if (silent) {
    host_->messages.announce(
        tr("Forces went off, because the window did not answer for %1 s. Press F5 to "
           "switch them on.")
            .arg(settings_.window_silence_s),
        SaidBecause::noticed);
  }
}

void HapticsPlugin::watchEdge(const HapticSample& sample) {
  const bool at_edge = forces_asked_ && sample.frame != 0;
  if (at_edge && !at_edge_)
    host_->messages.announce(tr("The hand pushes over the edge of the window."),
                             SaidBecause::noticed);
  at_edge_ = at_edge;
}

/// A hand that is clear of the surface waits for a few quiet ticks only.
void HapticsPlugin::watchWaiting(const HapticSample& sample) {
  constexpr int kFramesUntilSaid = 6;  // A tenth of a second.
  if (!forces_asked_ || sample.engaged == EngagePhase::off) {
    frames_waiting_ = 0;
  } else if (sample.engaged != EngagePhase::waiting) {
    if (std::exchange(frames_waiting_, 0) >= kFramesUntilSaid) {
      host_->messages.announce(tr("The hand is clear: forces come on."), SaidBecause::noticed);
    }
  } else if (++frames_waiting_ == kFramesUntilSaid) {
    host_->messages.announce(session_->isSteered()
                                 ? tr("Forces wait: the hand is inside. Let go or press Page Up.")
                                 : tr("Forces wait: the hand is inside. Raise the grip."));
  }
}

void HapticsPlugin::watchSoftening(const HapticSample& sample) {
  const bool again = sample.softened > softened_;
  softened_ = sample.softened;
  if (!again) return;
  host_->messages.announce(tr("Softened to %1 N/mm: hand and surface had begun to swing.")
                               .arg(sample.stiffness_n_per_mm, 0, 'f', 2),
                           SaidBecause::noticed);
}

/// E306, in the words for speech; the panel has the numbers.
void HapticsPlugin::watchRate(const HapticSample& sample) {
  if (sample.engaged == EngagePhase::off) slow_ = false;
  if (sample.slow.rate_hz > 0 && !std::exchange(slow_, true)) {
    host_->messages.announce(tr("Surface made softer to stay steady."), SaidBecause::noticed);
  }
}

void HapticsPlugin::runButtons(const HapticSample& sample) {
  while (const std::optional<ButtonEvent> event = session_->takeButton()) {
    buttons_->press(event->button, event->down, 1e-9 * static_cast<double>(event->time_ns));
  }
  buttons_->frame(sample, 1e-9 * static_cast<double>(monotonicNs()));
}

void HapticsPlugin::setUpDevice() {
  if (setup_) {
    setup_->raise();
    setup_->activateWindow();
    return;
  }
  const std::string before = wish_;
  setForces(false);
  if (opened_.starts_with("falcon")) {  // The dialog holds it now.
    settings_.device = kMouse;
    changeDevice();
  }
  try {
    setup_ = makeDeviceSetup(falcon::falconChoice(before).value_or(falcon::FalconChoice{}),
                             panel_ ? panel_->window() : nullptr);
  } catch (const DeviceError& error) {  // No USB on this computer.
    host_->messages.showError(messageText(messageOf(error)), {});
    chooseDevice(before);
    return;
  }
  connect(setup_, &DeviceSetupDialog::said, this, [this](const QString& text) {
    if (host_ != nullptr) host_->messages.announce(text);
  });
  connect(setup_, &QDialog::finished, this, [this, before](int result) {
    if (!session_) return;
    const bool used = result == QDialog::Accepted && setup_;
    chooseDevice(used ? setup_->deviceId() : before);
  });
  setup_->show();
}

QByteArray HapticsPlugin::saveState() const {
  TouchSettings kept = settings_;
  kept.device = wish_;
  return withButtons(toJson(kept), button_settings_);
}

void HapticsPlugin::restoreState(const QByteArray& state) {
  settings_ = touchSettingsFromJson(state);
  wish_ = settings_.device;
  button_settings_ = buttonSettingsFromJson(state);
  if (buttons_panel_) buttons_panel_->setSettings(button_settings_);
  if (buttons_) buttons_->setSettings(button_settings_);
  if (panel_) panel_->setSettings(settings_);
  if (session_ && settings_.device != opened_) changeDevice();
  applySettings();
  applySurface();
  if (host_ != nullptr) restoreFirmness();
}

}  // namespace relievo
