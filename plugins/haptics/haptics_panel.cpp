// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/haptics_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "core/base/error.h"
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

QComboBox* choice(const char* object_name, const QString& accessible, const QStringList& items) {
  auto* box = named(new QComboBox, object_name, accessible);
  box->addItems(items);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

constexpr int kOwnValues = static_cast<int>(kSurfacePresets.size());  // Index after the presets.
constexpr double kMmPerM = 1000;

void setTextIfNew(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);  // No repaint, no event, if nothing changed.
}

QString stateText(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  if (!report.not_ready.isEmpty()) return report.not_ready;
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
  buildFeel();
  buildReadouts();
  connectControls();
  auto* column = new QVBoxLayout(this);
  column->addLayout(rows());
  column->addStretch(1);
  setSettings({});
}

QFormLayout* HapticsPanel::rows() {
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
  labelled(tr("Surfa&ce"), preset_, preset_);
  labelled(tr("Sh&ape"), surface_, surface_);
  labelled(tr("Pro&xy"), proxy_, proxy_);
  labelled(tr("Sti&ffness"), stiffness_, stiffness_);
  form->addRow(QString(), by_detail_);
  labelled(tr("Fr&iction"), friction_, friction_);
  labelled(tr("Dam&ping"), damping_, damping_);
  form->addRow(tr("Pressed in"), depth_);
  labelled(tr("&Device"), device_, device_);
  form->addRow(tr("Force loop"), health_);
  form->addRow(QString(), details_);
  return form;
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
  device_ = choice("deviceList", tr("Device"), {});
  device_->setToolTip(
      tr("What the hand holds. A virtual hand is moved by the mouse and pushed by "
         "the force, as a real one is."));
  listDevices();
}

void HapticsPanel::buildFeel() {
  preset_ = choice("surfacePreset", tr("How the surface feels"),
                   {tr("Smooth"), tr("Exact"), tr("As in the paper"), tr("Soft stone"),
                    tr("Bronze"), tr("Own values")});
  preset_->setToolTip(
      tr("Sets shape, proxy, stiffness, friction and damping together. Each can be changed "
         "afterwards."));
  // Shown when no preset fits; nothing to choose.
  qobject_cast<QStandardItemModel*>(preset_->model())->item(kOwnValues)->setEnabled(false);
  surface_ = choice("surfaceKind", tr("Shape of the surface between the samples"),
                    {tr("Smooth with walls"), tr("Smooth everywhere"), tr("Flat facets (exact)")});
  surface_->setToolTip(
      tr("The height samples are exact in each; only what lies between them differs."));
  proxy_ = choice("proxyKind", tr("How the proxy follows the hand"),
                  {tr("Converged (exact)"), tr("As in the paper (eq. 2)"),
                   tr("Successive approximation (paper)")});
  proxy_->setToolTip(tr("The proxy is the point that stays on the surface."));
  friction_ = named(new QDoubleSpinBox, "friction", tr("Friction at rest, 0 to 1"));
  friction_->setRange(0, kMostFrictionAsked);
  friction_->setSingleStep(0.05);
  friction_->setToolTip(
      tr("Force along the surface that holds the hand, as a part of the force against it; three "
         "quarters of it while sliding. The paper's proxies know none."));
  damping_ = named(new QDoubleSpinBox, "damping", tr("Damping in newton seconds per metre"));
  damping_->setRange(0, kMmPerM * kMostDamping);
  damping_->setSingleStep(0.1);
  damping_->setDecimals(1);
  damping_->setSuffix(tr(" N s/m"));
  damping_->setToolTip(tr("Against the speed of pressing in."));
}

void HapticsPanel::connectControls() {
  connect(forces_, &QCheckBox::toggled, this, &HapticsPanel::forcesAsked);
  connect(strength_, &QSlider::valueChanged, this, &HapticsPanel::changed);
  connect(by_detail_, &QCheckBox::toggled, this, &HapticsPanel::changed);
  for (QDoubleSpinBox* box : {stiffness_, friction_, damping_}) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &HapticsPanel::changed);
  }
  for (QComboBox* box : {proxy_, surface_, device_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &HapticsPanel::changed);
  }
  connect(preset_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &HapticsPanel::takePreset);
  connect(details_, &QPushButton::clicked, this, &HapticsPanel::showDetails);
}

void HapticsPanel::listDevices() {
  const QSignalBlocker blocker(device_);
  const QString chosen = device_->currentData().toString();
  device_->clear();
  for (const DeviceDriver& driver : deviceCatalog()) {
    for (const std::string& id : driver.scan()) {
      device_->addItem(QString::fromStdString(driver.make(id)->info().name),
                       QString::fromStdString(id));
    }
  }
  if (!chosen.isEmpty()) chooseDevice(chosen);
}

void HapticsPanel::chooseDevice(const QString& id) {
  if (device_->findData(id) < 0) {
    QString name = id;
    try {
      name = QString::fromStdString(makeDevice(id.toStdString())->info().name);
    } catch (const Error&) {
      // Known to no driver: its id must do.
    }
    device_->addItem(tr("%1 (not here now)").arg(name), id);
  }
  device_->setCurrentIndex(device_->findData(id));
}

void HapticsPanel::buildReadouts() {
  state_ = readout("forceState", tr("State of the forces"));
  depth_ = readout("pressDepth", tr("How far the hand is pressed in"));
  health_ = readout("loopHealth", tr("How the force loop runs"));
  details_ = named(new QPushButton(tr("More a&bout the loop…")), "loopDetailsButton",
                   tr("More about the force loop"));
  details_->setToolTip(tr("Wake-ups and computing times as tables, and what the system granted."));
}

void HapticsPanel::changed() {
  strength_value_->setText(tr("%1 %").arg(strength_->value()));
  stiffness_->setEnabled(!by_detail_->isChecked());
  friction_->setEnabled(proxy_->currentIndex() == static_cast<int>(ProxyKind::converged));
  showPreset();
  Q_EMIT settingsChanged();
}

void HapticsPanel::takePreset(int index) {
  if (index < 0 || index >= kOwnValues) return;
  TouchSettings settings = this->settings();
  settings.feel = kSurfacePresets.at(static_cast<std::size_t>(index)).feel;
  setSettings(settings);
}

void HapticsPanel::showPreset() {
  int index = 0;
  while (index < kOwnValues &&
         !feelsTheSame(feel(), kSurfacePresets.at(static_cast<std::size_t>(index)).feel)) {
    ++index;
  }
  const QSignalBlocker blocker(preset_);
  preset_->setCurrentIndex(index);
}

void HapticsPanel::setSettings(const TouchSettings& settings) {
  {
    const QSignalBlocker a(strength_), b(by_detail_), c(stiffness_), d(proxy_), e(device_),
        f(surface_), g(friction_), h(damping_);
    const SurfaceFeel& feel = settings.feel;
    strength_->setValue(settings.strength_percent);
    by_detail_->setChecked(feel.stiffness_by_detail);
    stiffness_->setValue(feel.stiffness_n_per_mm);
    proxy_->setCurrentIndex(static_cast<int>(feel.proxy));
    surface_->setCurrentIndex(static_cast<int>(feel.surface));
    friction_->setValue(feel.friction);
    damping_->setValue(kMmPerM * feel.damping_n_s_per_mm);
    chooseDevice(QString::fromStdString(settings.device));
  }
  changed();
}

SurfaceFeel HapticsPanel::feel() const {
  SurfaceFeel feel;
  feel.proxy = static_cast<ProxyKind>(proxy_->currentIndex());
  feel.surface = static_cast<SurfaceKind>(surface_->currentIndex());
  feel.stiffness_by_detail = by_detail_->isChecked();
  feel.stiffness_n_per_mm = stiffness_->value();
  feel.friction = friction_->value();
  feel.damping_n_s_per_mm = damping_->value() / kMmPerM;
  return feel;
}

TouchSettings HapticsPanel::settings() const {
  TouchSettings settings;
  settings.strength_percent = strength_->value();
  settings.feel = feel();
  settings.device = device_->currentData().toString().toStdString();
  return settings;
}

void HapticsPanel::showDetails() {
  if (!open_details_) {
    open_details_ = new LoopDetailsDialog(this);
    open_details_->setAttribute(Qt::WA_DeleteOnClose);
  }
  open_details_->show(report_);
  open_details_->show();
  open_details_->raise();
  open_details_->activateWindow();
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
  report_ = report;
  if (open_details_) open_details_->show(report_);
  constexpr int kShowsPerLine = 8;  // Read by speech, too: no oftener than once a second.
  if (health_shows_++ % kShowsPerLine != 0 && report.stats.rate_hz > 0) return;
  const QString health = healthText(report);
  setTextIfNew(health_, health);
  health_->setAccessibleDescription(health);
}

}  // namespace relievo
