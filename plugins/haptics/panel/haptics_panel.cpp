// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/haptics_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "plugins/haptics/panel/device_rows.h"
#include "plugins/haptics/panel/feel_form.h"
#include "plugins/haptics/panel/firmness_row.h"
#include "plugins/haptics/panel/loop_rows.h"
#include "plugins/haptics/panel/panel_widgets.h"
#include "plugins/haptics/panel/sound_rows.h"
#include "plugins/haptics/panel/strength_row.h"
#include "ui/message/message_text.h"

namespace relievo {

namespace {
QString stateText(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  if (!report.not_ready.isEmpty()) return report.not_ready;
  if (sample.fault != DeviceFault::none && !report.take_back.isEmpty()) {
    return HapticsPanel::tr("Off: %1. %2")
        .arg(messageText(messageOf(sample.fault)), report.take_back);
  }
  if (sample.fault != DeviceFault::none) {
    return HapticsPanel::tr("Off: %1. Switch off and on to try again.")
        .arg(messageText(messageOf(sample.fault)));
  }
  switch (sample.engaged) {
    case EngagePhase::off:
      return HapticsPanel::tr("Off. Press F5 to switch forces on.");
    case EngagePhase::waiting:
      return HapticsPanel::tr("Waiting until the hand is clear of the surface.");
    case EngagePhase::rising:
      return HapticsPanel::tr("Coming on.");
    case EngagePhase::on:
      break;
  }
  if (sample.slow.rate_hz > 0) {
    return HapticsPanel::tr(
               "On. E306: Update rate fell to %1 per second (need %2). Stiffness reduced from %3 "
               "to %4 N/m.")
        .arg(sample.slow.rate_hz, 0, 'f', 0)
        .arg(RateWatch::kLeastHz, 0, 'f', 0)
        .arg(kMmPerM * sample.slow.asked_n_per_mm, 0, 'f', 0)
        .arg(kMmPerM * sample.slow.held_n_per_mm, 0, 'f', 0);
  }
  if (sample.softened > 0) {
    return HapticsPanel::tr("On, softened to %1 N/mm against swinging until switched off.")
        .arg(sample.stiffness_n_per_mm, 0, 'f', 2);
  }
  return report.actuated ? HapticsPanel::tr("On.")
                         : HapticsPanel::tr("On: computed and shown; a mouse cannot push back.");
}
}  // namespace

HapticsPanel::HapticsPanel(QWidget* parent)
    : QWidget(parent),
      strength_(new StrengthRow(this)),
      feel_(new FeelForm(this)),
      firmness_(new FirmnessRow(this)),
      device_(new DeviceRows(this)),
      loop_(new LoopRows(this)),
      sound_(new SoundRows(this)) {
  setObjectName(QStringLiteral("hapticsPanel"));
  buildControls();
  connectControls();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 0, 0, 2);
  column->addLayout(rows());
  advanced_ = new QWidget(this);
  advanced_->setObjectName(QStringLiteral("touchAdvanced"));
  advanced_->setProperty("foldedAtFirst", true);  // As the window knows it.
  advanced_->setLayout(advancedRows());
  column->addWidget(advanced_);
  setSettings({});
}

QFormLayout* HapticsPanel::rows() {
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setVerticalSpacing(3);
  auto* first = new QHBoxLayout;
  first->addWidget(forces_);
  first->addWidget(strength_->presets(), 1);
  form->addRow(first);
  form->addRow(state_);
  form->addRow(take_back_);
  form->addRow(change_);
  strength_->addTo(form);
  return form;
}

QFormLayout* HapticsPanel::advancedRows() {
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  feel_->addSurfaceRows(form);
  firmness_->addTo(form);
  feel_->addCueRows(form);
  sound_->addTo(form);
  loop_->addDepth(form);
  device_->addTo(form);
  loop_->addHealth(form);
  return form;
}

void HapticsPanel::buildControls() {
  forces_ = named(new QCheckBox(tr("Forces &on")), "forcesBox", tr("Forces on"));
  forces_->setToolTip(tr("Switch forces on or off (F5). Esc switches them off."));
  state_ = readout("forceState", tr("State of the forces"));
  take_back_ = named(new QPushButton(tr("Take the forces bac&k")), "takeBackButton",
                     tr("Take the forces back"));
  take_back_->setToolTip(
      tr("Opens the device again (Shift+F5). Its forces rise from zero once the hand is clear."));
  take_back_->hide();
  change_ = readout("surfaceChange", tr("A new surface under the hand"));
  change_->hide();
}

void HapticsPanel::connectControls() {
  connect(forces_, &QCheckBox::toggled, this, &HapticsPanel::forcesAsked);
  connect(take_back_, &QPushButton::clicked, this, &HapticsPanel::takeBackAsked);
  connect(strength_, &StrengthRow::changed, this, &HapticsPanel::changed);
  connect(feel_, &FeelForm::changed, this, &HapticsPanel::changed);
  connect(firmness_, &FirmnessRow::asked, this, &HapticsPanel::firmnessAsked);
  connect(device_, &DeviceRows::changed, this, &HapticsPanel::changed);
  connect(sound_, &SoundRows::changed, this, &HapticsPanel::changed);
  connect(device_, &DeviceRows::wanted, this, &HapticsPanel::devicesWanted);
}

void HapticsPanel::changed() {
  Q_EMIT settingsChanged();
}

void HapticsPanel::listDevices() {
  device_->list();
}

void HapticsPanel::setPluginDevices(std::vector<PluginDevice> devices) {
  device_->setPluginDevices(std::move(devices));
}

void HapticsPanel::setSettings(const TouchSettings& settings) {
  strength_->set(settings.strength_percent);
  feel_->setFeel(settings.feel);
  firmness_->setFile(settings.firmness);
  sound_->set(settings);
  device_->set({settings.device, settings.holds_grip, settings.grip});
  changed();
}

TouchSettings HapticsPanel::settings() const {
  TouchSettings settings;
  settings.strength_percent = strength_->percent();
  settings.feel = feel_->feel();
  settings.firmness = firmness_->file();
  settings.sound = sound_->sound();
  settings.felt_patterns = sound_->feltPatterns();
  const DeviceChoice chosen = device_->choice();
  settings.holds_grip = chosen.holds_grip;
  settings.grip = chosen.grip;
  settings.device = chosen.device;
  return settings;
}

void HapticsPanel::setFirmnessUsed(bool used) {
  firmness_->setUsed(used);
}

void HapticsPanel::plot(std::span<const ForcePoint> samples) {
  loop_->plot(samples);
}

void HapticsPanel::setForcesAsked(bool on) {
  const QSignalBlocker blocker(forces_);
  forces_->setChecked(on);
}

void HapticsPanel::show(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  const QString state = stateText(report);
  const QString helps = report.take_back.isEmpty() ? QString() : ' ' + report.take_back;
  setTextIfNew(state_, report.fallback.isEmpty() ? state : report.fallback + helps + '\n' + state);
  take_back_->setVisible(!report.take_back.isEmpty());
  const bool changes = sample.change < 1 && sample.engaged != EngagePhase::off;
  if (changes) {
    const int percent = static_cast<int>(kPercent * sample.change);
    setTextIfNew(change_, tr("The new surface comes under the hand: %1 %.").arg(percent));
  }
  change_->setVisible(changes);
  device_->showHeat(report.heat);
  feel_->setDetail(sample.detail);
  loop_->show(report);
}

}  // namespace relievo
