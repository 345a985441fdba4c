// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/guide/guide_control.h"

#include <QAction>
#include <QFileDialog>
#include <QSignalBlocker>

#include "haptics/rt/realtime_thread.h"

namespace relievo {

namespace {
double nowS() {
  return 1e-9 * static_cast<double>(monotonicNs());
}
}  // namespace

GuideControl::GuideControl(TouchParts& parts, HandDevice& device, RecordingControl& recording,
                           TouchedSurface& surface, ButtonControl& buttons)
    : parts_(parts),
      device_(device),
      recording_(recording),
      surface_(surface),
      buttons_(buttons),
      guide_(parts.host),
      marker_(parts.host),
      training_(parts.host) {
  surface_.setTraining(&training_);
  connectGuide();
  connectTraining();
}

GuideControl::~GuideControl() {
  surface_.setTraining(nullptr);
}

void GuideControl::connectGuide() {
  connect(&guide_, &TouchGuide::changed, this, [this] {
    {
      const QSignalBlocker blocker(parts_.actions.guide);
      parts_.actions.guide->setChecked(guide_.isOn());
    }
    buttons_.setLed(guide_.isOn());
    Q_EMIT changed();
  });
  connect(&marker_, &MarkerPull::changed, this, &GuideControl::changed);
  connect(&parts_.host.view, &ShownWindow::wentToMarker, this, [this](double x_mm, double y_mm) {
    if (!training_.isOn()) marker_.goTo(x_mm, y_mm);
  });
  connect(&buttons_, &ButtonControl::letGo, this, [this] { guide_.letGo(); });
  connect(parts_.actions.guide, &QAction::triggered, this, [this] {
    if (device_.session()) {
      guide_.toggle(*device_.session(), parts_.forces_asked, parts_.settings.guide_rounds);
    }
  });
  connect(parts_.actions.guide_along, &QAction::triggered, this, &GuideControl::chooseWay);
}

void GuideControl::chooseWay() {
  const QString file = QFileDialog::getOpenFileName(
      parts_.panel ? parts_.panel->window() : nullptr, tr("Guide along a recording"),
      parts_.host.recordings.recordingFolder(), tr("Recordings and strokes (*.csv *.h5 *.hdf5)"));
  if (!file.isEmpty() && device_.session()) {
    guide_.along(file, *device_.session(), parts_.forces_asked);
  }
}

void GuideControl::connectTraining() {
  connect(&training_, &TouchTraining::found, this, &GuideControl::found);
  connect(&training_, &TouchTraining::changed, this, &GuideControl::showTraining);
  connect(parts_.actions.training, &QAction::triggered, this, &GuideControl::setTraining);
  connect(parts_.actions.next_shape, &QAction::triggered, this, [this] { training_.skip(nowS()); });
  connect(&buttons_, &ButtonControl::taskAsked, this, [this] { training_.repeat(); });
  connect(&buttons_, &ButtonControl::taught, this, [this](quint8 button) {
    if (button == ButtonCommands::kForward) training_.skip(nowS());
    if (button == ButtonCommands::kCentre) training_.repeat();
    if (button == ButtonCommands::kPlus) parts_.host.controls.run(QStringLiteral("louderSpeech"));
    if (button == ButtonCommands::kMinus) parts_.host.controls.run(QStringLiteral("softerSpeech"));
  });
}

void GuideControl::setTraining(bool on) {
  if (!device_.session() || on == training_.isOn()) return;
  if (!on) return training_.stop();
  if (recording_.isRunning()) {
    parts_.host.messages.announce(
        tr("A recording is running. The introduction lays shapes under the hand that are not of "
           "this relief. End the recording first."));
    return showTraining();
  }
  guide_.drop();
  marker_.drop();
  buttons_.cancelMoving();
  const bool were_off = !parts_.forces_asked;
  training_.begin({.shapes = parts_.settings.introduction_shapes, .switches_forces_on = were_off},
                  nowS());
  if (were_off) Q_EMIT forcesAsked(true);
}

void GuideControl::showTraining() {
  const bool on = training_.isOn();
  {
    const QSignalBlocker blocker(parts_.actions.training);
    parts_.actions.training->setChecked(on);
  }
  parts_.actions.next_shape->setEnabled(on);
  parts_.actions.guide->setEnabled(!on);
  parts_.actions.guide_along->setEnabled(!on);
  parts_.actions.move_mode->setEnabled(!on);
  buttons_.setTaught(on);
  if (on) {
    surface_.showTraining();
  } else if (parts_.host.view.shownWindow()) {
    surface_.showWindow();
  } else {
    Q_EMIT forcesAsked(false);  // There is no relief.
  }
}

void GuideControl::follow(const HapticSample& sample) {
  guide_.frame(*device_.session(), sample);
  marker_.frame(*device_.session(), sample, parts_.forces_asked);
  training_.frame(sample, nowS());
}

void GuideControl::end() {
  guide_.drop();
  marker_.drop();
  training_.stop();
}

void GuideControl::setRecording(bool on) {
  if (!on || !training_.isOn()) return recording_.setRecording(on);
  const QSignalBlocker blocker(parts_.actions.record);
  parts_.actions.record->setChecked(false);
  parts_.host.messages.announce(tr("The introduction is not recorded. End it first."));
}

}  // namespace relievo
