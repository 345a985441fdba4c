// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/haptics_plugin.h"

#include <algorithm>
#include <array>
#include <QAction>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <utility>

#include "haptics/loop/strength_preset.h"
#include "plugins/haptics/panel/device_rows.h"
#include "plugins/haptics/panel/strength_row.h"

namespace relievo {

HapticsPlugin::~HapticsPlugin() {
  detach();
}

void HapticsPlugin::attach(Host& host) {
  parts_ = std::make_unique<TouchParts>(TouchParts{host, settings_, requested_device_});
  device_ = std::make_unique<HandDevice>(*parts_);
  device_->open();
  return_ = std::make_unique<ForceReturn>(*parts_, *device_);
  parts_->panel = new HapticsPanel;  // The host owns it from addPanel on.
  parts_->showSettings();
  host.controls.addPanel(tr("Touch"), parts_->panel);
  host.controls.addPanel(tr("Touch: advanced"), parts_->panel->advanced());
  parts_->actions = addTouchActions(host);
  recording_ = std::make_unique<RecordingControl>(*parts_, *device_);
  surface_ = std::make_unique<TouchedSurface>(*parts_, *device_, *recording_);
  announcer_ = std::make_unique<LoopAnnouncer>(*parts_, *device_);
  buttons_ = std::make_unique<ButtonControl>(*parts_, *device_, button_settings_);
  guide_ = std::make_unique<GuideControl>(*parts_, *device_, *recording_, *surface_, *buttons_);
  sound_ = std::make_unique<SoundControl>(*parts_, *device_);
  felt_ = std::make_unique<FeltPatterns>(*parts_);
  connectParts();
  connectActions();
  connectPanel();
  applySettings();
  sound_->applySettings(SoundControl::Tell::no);
  surface_->showWindow();
  connect(&pace_.timer(), &QTimer::timeout, this, &HapticsPlugin::frame, Qt::UniqueConnection);
  pace_.onRest([this](bool at_rest) {
    if (session()) session()->setUrgent(!at_rest);
  });
  pace_.start();
  device_->startWatchingPlugs();
  sleep_ = std::make_unique<SleepWatch>();
  slowReadouts();
  surface_->restoreFirmness();
}

void HapticsPlugin::detach() noexcept {
  pace_.stop();
  sleep_.reset();
  if (device_) device_->stopLooking();
  if (recording_) recording_->end();
  felt_.reset();
  sound_.reset();
  guide_.reset();
  buttons_.reset();
  announcer_.reset();
  surface_.reset();
  recording_.reset();
  return_.reset();
  device_.reset();  // Zero force, joins, closes an open recording.
  parts_.reset();
  shown_ = {};
  wants_forces_ = false;
}

void HapticsPlugin::connectParts() {
  connect(device_.get(), &HandDevice::forcesEnd, this, &HapticsPlugin::dropForces);
  connect(device_.get(), &HandDevice::leaving, this, [this] {
    guide_->end();
    buttons_->cancelMoving();
    buttons_->forgetPresses();
    recording_->end();
  });
  connect(device_.get(), &HandDevice::changed, this, &HapticsPlugin::takeDevice);
  connect(surface_.get(), &TouchedSurface::given, this, [this] { shown_ = {}; });
  connect(surface_.get(), &TouchedSurface::laid, sound_.get(), &SoundControl::takeWindow);
  connect(recording_.get(), &RecordingControl::noted, sound_.get(),
          [this] { sound_->strike(sound::Earcon::done); });
  connect(guide_.get(), &GuideControl::found, sound_.get(),
          [this] { sound_->strike(sound::Earcon::done); });
  connect(guide_.get(), &GuideControl::found, felt_.get(),
          [this] { felt_->feel(FeltPattern::yes); });
  connect(felt_.get(), &FeltPatterns::changed, this, &HapticsPlugin::applySettings);
  connect(announcer_.get(), &LoopAnnouncer::forcesEnd, this, &HapticsPlugin::dropForces);
  connect(announcer_.get(), &LoopAnnouncer::faultTold, recording_.get(),
          &RecordingControl::setFault);
  connect(buttons_.get(), &ButtonControl::changed, this, &HapticsPlugin::applySettings);
  connect(guide_.get(), &GuideControl::changed, this, &HapticsPlugin::applySettings);
  connect(guide_.get(), &GuideControl::forcesAsked, this, &HapticsPlugin::setForces);
  connect(&parts_->host.view, &ShownWindow::handMoved, device_.get(), [this] { pace_.wake(); });
  connect(&parts_->host.view, &ShownWindow::windowShown, device_.get(), [this] { pace_.wake(); });
  connect(&parts_->host.view, &ShownWindow::closing, device_.get(), [this] { setForces(false); });
}

void HapticsPlugin::connectActions() {
  const TouchActions& actions = parts_->actions;
  connect(actions.forces, &QAction::toggled, this, &HapticsPlugin::setForces);
  connect(actions.forces_off, &QAction::triggered, this, [this] { setForces(false); });
  connect(actions.take_back, &QAction::triggered, this, &HapticsPlugin::takeForceBack);
  connect(actions.stronger, &QAction::triggered, this, [this] { changeStrength(kStrengthStep); });
  connect(actions.weaker, &QAction::triggered, this, [this] { changeStrength(-kStrengthStep); });
  connect(actions.strength_preset, &QAction::triggered, this, &HapticsPlugin::nextStrengthPreset);
  connect(actions.grip_position, &QAction::triggered, this, &HapticsPlugin::nextGripPosition);
  connect(actions.record, &QAction::toggled, guide_.get(), &GuideControl::setRecording);
  connect(actions.note, &QAction::triggered, recording_.get(), &RecordingControl::askNote);
  connect(actions.setup, &QAction::triggered, device_.get(), &HandDevice::setUp);
}

void HapticsPlugin::connectPanel() {
  const HapticsPanel* const panel = parts_->panel;
  connect(panel, &HapticsPanel::devicesWanted, device_.get(), &HandDevice::lookForPlugins);
  connect(panel, &HapticsPanel::forcesAsked, this, &HapticsPlugin::setForces);
  connect(panel, &HapticsPanel::takeBackAsked, this, &HapticsPlugin::takeForceBack);
  connect(panel, &HapticsPanel::firmnessAsked, surface_.get(), &TouchedSurface::chooseFirmness);
  connect(panel, &HapticsPanel::settingsChanged, device_.get(), [this] { takePanelSettings(); });
}

void HapticsPlugin::takePanelSettings() {
  // What has no control stays.
  TouchSettings settings = parts_->panel->settings();
  settings.window_silence_s = settings_.window_silence_s;
  settings.bound_by_rate = settings_.bound_by_rate;
  settings.limit_n = settings_.limit_n;
  settings.introduction_shapes = settings_.introduction_shapes;
  settings.guide_rounds = settings_.guide_rounds;
  const bool regripped = settings.grip != settings_.grip;
  if (regripped) dropForces(SaidBecause::asked);
  settings_ = settings;
  if (regripped) tellGripPosition();
  if (settings_.device != device_->opened()) requested_device_ = settings_.device;
  device_->useSettings();
  applySettings();
  surface_->applySettings();
  sound_->applySettings(SoundControl::Tell::yes);
  felt_->showSettings();
}

void HapticsPlugin::takeDevice() {
  shown_ = {};
  announcer_->forgetFault();
  return_->forget();
  applySettings();
  surface_->showWindow();
  if (device_->isReplaced()) wants_forces_ = false;
}

void HapticsPlugin::takeForceBack() {
  if (!session() || !return_->isPossible()) return;
  device_->openAnew();
  wants_forces_ = !device_->isReplaced();
  slowReadouts();  // Escape must know at once that there is something to stop.
}

/// The first readings of a device that was just opened say that it is not ready yet.
void HapticsPlugin::watchReturn() {
  if (!wants_forces_ || device_->isOpening()) return;
  const bool is_ready = return_->wasReady();
  if (!is_ready && !return_->mustOpenAnew()) return;
  wants_forces_ = false;
  if (is_ready && !return_->mustOpenAnew()) setForces(true);
}

void HapticsPlugin::dropForces(SaidBecause why) {
  const bool is_waited_for = why == SaidBecause::noticed && wants_forces_;
  endForces(why);
  wants_forces_ = is_waited_for;
}

void HapticsPlugin::setForces(bool on) {
  if (!session()) return;
  if (!on && guide_) guide_->end();
  if (on && !session()->hasWindow()) {
    parts_->host.messages.announce(tr("Nothing to touch yet. Open a scan first."));
    on = false;
  }
  if (!on) wants_forces_ = false;
  if (on && return_->mustOpenAnew()) {
    takeForceBack();
    on = parts_->forces_asked;  // Later: it takes a while to open.
  }
  if (on) session()->retryDevice();
  const bool changed = on != parts_->forces_asked;
  parts_->forces_asked = on;
  {
    const QSignalBlocker blocker(parts_->actions.forces);
    parts_->actions.forces->setChecked(on);
  }
  parts_->actions.forces_off->setEnabled(on || wants_forces_);
  if (parts_->panel) parts_->panel->setForcesAsked(on);
  session()->loop().sayAlive();  // Whoever asks is there, though no frame came for a while.
  applySettings();
  if (!changed) return;
  slowReadouts();  // Escape must know at once that there is something to stop.
  parts_->host.messages.announce(on ? tr("Forces on.") : tr("Forces off."), forces_because_);
}

void HapticsPlugin::endForces(SaidBecause why) {
  const QScopedValueRollback<SaidBecause> because(forces_because_, why);
  setForces(false);
}

void HapticsPlugin::changeStrength(int percent) {
  if (!session()) return;
  settings_.strength_percent = std::clamp(settings_.strength_percent + percent, 0, 100);
  parts_->showSettings();
  applySettings();
  parts_->host.messages.announce(tr("Strength %1 percent.").arg(settings_.strength_percent));
}

void HapticsPlugin::nextStrengthPreset() {
  const auto* const next = std::find_if(
      kStrengthPresets.begin(), kStrengthPresets.end(),
      [this](const StrengthPreset& preset) { return preset.percent > settings_.strength_percent; });
  settings_.strength_percent =
      (next != kStrengthPresets.end() ? *next : kStrengthPresets.front()).percent;
  parts_->showSettings();
  applySettings();
  parts_->host.messages.announce(
      tr("Strength: %1.").arg(strengthPresetText(settings_.strength_percent)));
}

/// The hand is elsewhere on the relief at once: nobody may be pushed by that.
void HapticsPlugin::nextGripPosition() {
  dropForces(SaidBecause::asked);
  const std::size_t next = static_cast<std::size_t>(settings_.grip) + 1;
  settings_.grip = static_cast<GripPosition>(next % kGripPositionNames.size());
  parts_->showSettings();
  applySettings();
  tellGripPosition();
}

void HapticsPlugin::tellGripPosition() {
  const QString position = gripPositionTexts().at(static_cast<int>(settings_.grip));
  parts_->host.messages.announce(tr("Grip position: %1.").arg(position));
}

void HapticsPlugin::applySettings() {
  pace_.wake();
  if (!session()) return;
  HapticOptions options = hapticOptions(settings_, parts_->forces_asked);
  if (buttons_) buttons_->addTo(options);
  if (guide_) guide_->addTo(options);
  if (felt_) felt_->addTo(options);
  session()->setOptions(options);
}

void HapticsPlugin::frame() {
  session()->loop().sayAlive();
  const HapticSample sample = session()->update();
  const bool moved = showProbe(sample);
  const std::vector<ForcePoint> plot = session()->takePlot();
  if (!plot.empty()) {
    parts_->host.touch.plot(plot);
    if (parts_->panel) parts_->panel->plot(plot);
  }
  announcer_->follow(sample);
  return_->follow(sample);
  watchReturn();
  recording_->watch();
  buttons_->follow(sample);
  guide_->follow(sample);
  felt_->follow(sample);
  sound_->watch();
  watchSleep(sample);
  constexpr int kFramesPerReadout = 8, kFramesPerStatus = 32;
  const int before = std::exchange(frames_, frames_ + pace_.framesOfLook());
  pace_.follow(moved || mayChange());
  if (before / kFramesPerReadout == frames_ / kFramesPerReadout) return;
  slowReadouts(before / kFramesPerStatus != frames_ / kFramesPerStatus);
  device_->watchOpening();  // Not within the readouts, which setForces() asks for while it works.
}

/// Without a word to the plugin: by a hand that a person holds, by buttons, or by a worker.
bool HapticsPlugin::mayChange() const {
  return parts_->forces_asked || wants_forces_ || !session()->isSteered() ||
         session()->isPreparing() || recording_->isRunning() || guide_->isTraining() ||
         device_->isOpening() || frames_at_zero_ >= 0 || buttons_->areThere();
}

bool HapticsPlugin::showProbe(const HapticSample& sample) {
  if (!session()->hasWindow() || sample.window_id == 0) return false;
  if (guide_->isTraining()) return false;  // What is shown is not what the hand touches.
  const Probe probe = probeOf(sample);
  if (looksTheSame(probe, shown_)) return false;
  shown_ = probe;
  parts_->host.touch.showProbe(probe);
  return true;
}

void HapticsPlugin::slowReadouts(bool with_status) {
  LoopReport report;
  report.sample = session()->update();
  report.stats = session()->stats();
  report.realtime = session()->loop().realtime();
  device_->report(report);
  report.take_back = return_->remedy();
  parts_->actions.take_back->setEnabled(return_->isPossible());
  parts_->actions.forces_off->setEnabled(parts_->forces_asked || wants_forces_);
  if (parts_->panel) parts_->panel->show(report);
  if (with_status) tellStatus(report);
  device_->watchPlugs();
}

// Its numbers change with every look, and each change is a picture of the window.
void HapticsPlugin::tellStatus(const LoopReport& report) {
  TouchStatus status;
  status.state = device_->stateOf(report.sample.fault);
  status.device = report.device;
  status.rate_hz = report.stats.rate_hz;
  status.worst_period_ms = report.stats.worst_period_ms;
  status.late_ticks = report.stats.late_ticks;
  status.realtime = report.realtime.realtime;
  status.realtime_note = QString::fromStdString(report.realtime.note);
  status.forces_on = parts_->forces_asked || wants_forces_;
  status.recording = session()->recorder().running();
  status.recorded_samples = session()->recorder().samples();
  status.stiffness_n_per_mm = report.sample.stiffness_n_per_mm;
  if (!session()->isSteered() && report.sample.fault == DeviceFault::none) {
    status.grip = report.sample.hip;
  }
  parts_->host.touch.showStatus(status);
}

void HapticsPlugin::watchSleep(const HapticSample& sample) {
  switch (sleep_->poll()) {
    case SleepWatch::News::about_to_sleep:
      endForces(SaidBecause::noticed);
      device_->endSetUpBeforeSleep();
      frames_at_zero_ = 0;
      break;
    case SleepWatch::News::woken:
      frames_at_zero_ = -1;
      parts_->host.messages.announce(
          tr("Forces are off after the sleep. Press F5 to switch them on."), SaidBecause::noticed);
      break;
    case SleepWatch::News::none:
      break;
  }
  if (frames_at_zero_ < 0 || sample.engaged != EngagePhase::off) return;
  // Zero reaches the wire within two ticks, unless the driver is busy asking again.
  constexpr int kFramesUntilSent = 3;
  if (++frames_at_zero_ == kFramesUntilSent) sleep_->letSleep();
}

QByteArray HapticsPlugin::saveState() const {
  TouchSettings kept = settings_;
  kept.device = requested_device_;
  return withButtons(toJson(kept), button_settings_);
}

void HapticsPlugin::restoreState(const QByteArray& state) {
  settings_ = touchSettingsFromJson(state);
  requested_device_ = settings_.device;
  button_settings_ = buttonSettingsFromJson(state);
  if (!session()) return;
  buttons_->showSettings();
  sound_->applySettings(SoundControl::Tell::no);  // Before the panel, which asks.
  felt_->showSettings();
  parts_->showSettings();
  device_->useSettings();
  applySettings();
  surface_->applySettings();
  surface_->restoreFirmness();
}

}  // namespace relievo
