// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/haptics_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "haptics/device_catalog.h"

namespace relievo {

namespace {
/// Name for tests and scripts, name for speech.
template <class Widget>
Widget* named(Widget* widget, const char* object_name, const QString& accessible) {
  widget->setObjectName(QString::fromLatin1(object_name));
  widget->setAccessibleName(accessible);
  return widget;
}

QLabel* readout(const char* object_name, const QString& accessible) {
  auto* label = named(new QLabel(QStringLiteral("–")), object_name, accessible);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

void setTextIfNew(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);  // No repaint, no event, if nothing changed.
}

QString stateText(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  if (sample.fault != DeviceFault::none) {
    const std::string_view fault = describe(sample.fault);
    return HapticsPanel::tr("Off: %1. Switch off and on to try again.")
        .arg(QString::fromUtf8(fault.data(), static_cast<int>(fault.size())));
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
  if (sample.softened > 0) {
    return HapticsPanel::tr("On, softened to %1 N/mm against swinging until switched off.")
        .arg(sample.stiffness_n_per_mm, 0, 'f', 2);
  }
  return report.actuated ? HapticsPanel::tr("On.")
                         : HapticsPanel::tr("On: computed and shown; a mouse cannot push back.");
}
}  // namespace

HapticsPanel::HapticsPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hapticsPanel"));
  buildControls();
  buildReadouts();
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  auto* strength_row = new QHBoxLayout;
  strength_row->addWidget(strength_, 1);
  strength_row->addWidget(strength_value_);
  form->addRow(forces_);
  form->addRow(state_);
  const auto labelled = [form](const QString& text, QWidget* buddy, auto* field) {
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    form->addRow(label, field);
  };
  labelled(tr("S&trength"), strength_, strength_row);
  labelled(tr("Sti&ffness"), stiffness_, stiffness_);
  form->addRow(QString(), by_detail_);
  labelled(tr("Pro&xy"), proxy_, proxy_);
  form->addRow(tr("Pressed in"), depth_);
  labelled(tr("&Device"), device_, device_);
  form->addRow(tr("Force loop"), rate_);
  form->addRow(tr("Longest gap"), worst_);
  form->addRow(tr("Late ticks"), late_);
  form->addRow(tr("Real time"), realtime_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addStretch(1);
  setSettings({});
}

void HapticsPanel::buildControls() {
  forces_ = named(new QCheckBox(tr("Forces &on")), "forcesBox", tr("Forces on"));
  forces_->setToolTip(tr("Switch forces on or off (F5). Esc switches them off."));
  strength_ = named(new QSlider(Qt::Horizontal), "strengthSlider", tr("Strength in percent"));
  strength_->setRange(0, 100);
  strength_->setSingleStep(kStrengthStep);
  strength_->setPageStep(2 * kStrengthStep);
  strength_->setToolTip(tr("Multiplies every force. The limit stays."));
  strength_value_ = named(new QLabel, "strengthValue", tr("Strength"));
  strength_value_->setMinimumWidth(
      strength_value_->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
  by_detail_ = named(new QCheckBox(tr("as the &level suggests")), "stiffnessByDetail",
                     tr("Stiffness as the level suggests"));
  by_detail_->setToolTip(tr("0.8 N/mm at Detail 1 and 2, 0.6 at 3, 0.5 at finer ones."));
  stiffness_ = named(new QDoubleSpinBox, "stiffness", tr("Stiffness in newtons per millimetre"));
  stiffness_->setRange(kLeastStiffness, kMostStiffness);
  stiffness_->setSingleStep(0.05);
  stiffness_->setDecimals(2);
  stiffness_->setSuffix(tr(" N/mm"));
  stiffness_->setToolTip(tr("Force per millimetre that the hand is pressed in."));
  proxy_ = named(new QComboBox, "proxyKind", tr("How the proxy follows the hand"));
  proxy_->addItems({tr("Converged (exact)"), tr("As in the paper (eq. 2)"),
                    tr("Successive approximation (paper)")});
  proxy_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  proxy_->setMinimumContentsLength(12);
  proxy_->setToolTip(tr("The proxy is the point that stays on the surface."));

  device_ = named(new QComboBox, "deviceList", tr("Device"));
  device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  device_->setMinimumContentsLength(12);
  device_->setToolTip(
      tr("What the hand holds. A virtual hand is moved by the mouse and pushed by "
         "the force, as a real one is."));
  listDevices();

  connect(forces_, &QCheckBox::toggled, this, &HapticsPanel::forcesAsked);
  connect(strength_, &QSlider::valueChanged, this, &HapticsPanel::changed);
  connect(by_detail_, &QCheckBox::toggled, this, &HapticsPanel::changed);
  connect(stiffness_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          &HapticsPanel::changed);
  for (QComboBox* box : {proxy_, device_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &HapticsPanel::changed);
  }
}

void HapticsPanel::listDevices() {
  for (const DeviceDriver& driver : deviceCatalog()) {
    for (const std::string& id : driver.scan()) {
      device_->addItem(QString::fromStdString(driver.make(id)->info().name),
                       QString::fromStdString(id));
    }
  }
}

void HapticsPanel::buildReadouts() {
  state_ = readout("forceState", tr("State of the forces"));
  depth_ = readout("pressDepth", tr("How far the hand is pressed in"));
  rate_ = readout("loopRate", tr("Rate of the force loop"));
  worst_ = readout("worstPeriod", tr("Longest time between two ticks"));
  late_ = readout("lateTicks", tr("Late ticks"));
  realtime_ = readout("realtimeLine", tr("Real-time priority"));
}

void HapticsPanel::changed() {
  strength_value_->setText(tr("%1 %").arg(strength_->value()));
  stiffness_->setEnabled(!by_detail_->isChecked());
  Q_EMIT settingsChanged();
}

void HapticsPanel::setSettings(const TouchSettings& settings) {
  {
    const QSignalBlocker a(strength_), b(by_detail_), c(stiffness_), d(proxy_), e(device_);
    strength_->setValue(settings.strength_percent);
    by_detail_->setChecked(settings.stiffness_by_detail);
    stiffness_->setValue(settings.stiffness_n_per_mm);
    proxy_->setCurrentIndex(static_cast<int>(settings.proxy));
    const QString device = QString::fromStdString(settings.device);
    if (device_->findData(device) < 0) device_->addItem(device, device);  // Not here now.
    device_->setCurrentIndex(device_->findData(device));
  }
  changed();
}

TouchSettings HapticsPanel::settings() const {
  TouchSettings settings;
  settings.strength_percent = strength_->value();
  settings.stiffness_by_detail = by_detail_->isChecked();
  settings.stiffness_n_per_mm = stiffness_->value();
  settings.proxy = static_cast<ProxyKind>(proxy_->currentIndex());
  settings.device = device_->currentData().toString().toStdString();
  return settings;
}

void HapticsPanel::setForcesAsked(bool on) {
  const QSignalBlocker blocker(forces_);
  forces_->setChecked(on);
}

void HapticsPanel::show(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  setTextIfNew(state_, stateText(report));
  if (by_detail_->isChecked() && sample.stiffness_n_per_mm > 0) {
    const QSignalBlocker blocker(stiffness_);
    stiffness_->setValue(sample.stiffness_n_per_mm);  // Shows what the level suggests.
  }
  setTextIfNew(depth_, sample.contact
                           ? tr("%1 mm of hand").arg(norm(sample.proxy - sample.hip), 0, 'f', 2)
                           : tr("not touching"));
  setTextIfNew(rate_, tr("%1 per second").arg(report.stats.rate_hz, 0, 'f', 0));
  setTextIfNew(worst_, tr("%1 ms").arg(report.stats.worst_period_ms, 0, 'f', 1));
  setTextIfNew(late_, tr("%1 of %2").arg(report.stats.late_ticks).arg(report.stats.ticks));
  setTextIfNew(realtime_, report.realtime.note.empty()
                              ? tr("Real-time priority granted.")
                              : QString::fromStdString(report.realtime.note));
}

}  // namespace relievo
