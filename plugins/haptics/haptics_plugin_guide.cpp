// SPDX-License-Identifier: BSD-3-Clause
// The plugin's part in leading the hand, and in the introduction to touch.
#include <QAction>
#include <QFileDialog>
#include <QSignalBlocker>

#include "haptics/rt/realtime_thread.h"
#include "plugins/haptics/haptics_plugin.h"

namespace relievo {

namespace {
double nowS() {
  return 1e-9 * static_cast<double>(monotonicNs());
}
}  // namespace

void HapticsPlugin::connectGuide() {
  connect(guide_.get(), &TouchGuide::changed, this, [this] {
    {
      const QSignalBlocker blocker(actions_.guide);
      actions_.guide->setChecked(guide_->isOn());
    }
    buttons_->setLed(guide_->isOn());
    applySettings();
  });
  connect(buttons_.get(), &DeviceButtons::letGo, this, [this] { guide_->letGo(); });
  connect(actions_.guide, &QAction::triggered, this, [this] {
    if (session_) guide_->toggle(*session_, forces_asked_);
  });
  connect(actions_.guide_along, &QAction::triggered, this, &HapticsPlugin::chooseWay);
}

void HapticsPlugin::chooseWay() {
  const QString file = QFileDialog::getOpenFileName(
      panel_ ? panel_->window() : nullptr, tr("Guide along a recording"),
      host_->recordings.recordingFolder(), tr("Recordings and strokes (*.csv *.h5 *.hdf5)"));
  if (!file.isEmpty() && session_) guide_->along(file, *session_, forces_asked_);
}

void HapticsPlugin::connectTraining() {
  connect(training_.get(), &TouchTraining::changed, this, &HapticsPlugin::showTraining);
  connect(actions_.training, &QAction::triggered, this, &HapticsPlugin::setTraining);
  connect(actions_.next_shape, &QAction::triggered, this, [this] { training_->skip(nowS()); });
  connect(buttons_.get(), &DeviceButtons::taught, this, [this](quint8 button) {
    if (button == ButtonCommands::kForward) training_->skip(nowS());
    if (button == ButtonCommands::kCentre) training_->repeat();
  });
}

void HapticsPlugin::setTraining(bool on) {
  if (!session_ || on == training_->isOn()) return;
  if (!on) return training_->stop();
  if (session_->recorder().running()) {
    host_->messages.announce(
        tr("A recording is running. The introduction lays shapes under the hand that are not of "
           "this relief. End the recording first."));
    return showTraining();
  }
  guide_->drop();
  buttons_->cancelMoving();
  training_->begin(!forces_asked_, nowS());
  if (!forces_asked_) setForces(true);
}

void HapticsPlugin::showTraining() {
  const bool on = training_->isOn();
  {
    const QSignalBlocker blocker(actions_.training);
    actions_.training->setChecked(on);
  }
  actions_.next_shape->setEnabled(on);
  actions_.guide->setEnabled(!on);
  actions_.guide_along->setEnabled(!on);
  actions_.move_mode->setEnabled(!on);
  buttons_->setTaught(on);
  shown_ = {};
  if (on) {
    surface_ = SurfaceKind::gated;
    given_window_ = training_->window()->id;
    session_->show(*training_->window(), surface_);
  } else if (const auto window = host_->view.shownWindow()) {
    showWindow(*window);
  } else {
    setForces(false);  // There is no relief.
  }
}

}  // namespace relievo
