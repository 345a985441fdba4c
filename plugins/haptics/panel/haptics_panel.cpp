// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/haptics_panel.h"

#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <utility>

#include "core/base/error.h"
#include "haptics/device_catalog.h"
#include "plugins/haptics/shown_file.h"
#include "ui/message/message_text.h"

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
constexpr double kMmPerM = 1000, kUmPerMm = 1000, kPercent = 100;

struct Box {
  const char* object_name;
  QString accessible, suffix, tip;
  double least, most, step;
  int decimals;
};

QDoubleSpinBox* numberBox(const Box& what) {
  auto* box = named(new QDoubleSpinBox, what.object_name, what.accessible);
  box->setRange(what.least, what.most);
  box->setSingleStep(what.step);
  box->setDecimals(what.decimals);
  box->setSuffix(what.suffix);
  box->setToolTip(what.tip);
  return box;
}

void setTextIfNew(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);  // No repaint, no event, if nothing changed.
}

QString stateText(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  if (!report.not_ready.isEmpty()) return report.not_ready;
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

HapticsPanel::HapticsPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hapticsPanel"));
  buildControls();
  buildFeel();
  buildFields();
  buildReadouts();
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
  auto* strength_row = new QHBoxLayout;
  strength_row->addWidget(strength_, 1);
  strength_row->addWidget(strength_value_);
  form->addRow(forces_);
  form->addRow(state_);
  form->addRow(change_);
  auto* label = new QLabel(tr("St&rength"));
  label->setBuddy(strength_);
  form->addRow(label, strength_row);
  return form;
}

QFormLayout* HapticsPanel::advancedRows() {
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  const auto labelled = [form](const QString& text, QWidget* buddy, QWidget* field) {
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    form->addRow(label, field);
  };
  labelled(tr("S&urface"), preset_, preset_);
  labelled(tr("Sh&ape"), surface_, surface_);
  labelled(tr("Prox&y"), proxy_, proxy_);
  labelled(tr("Stiff&ness"), stiffness_, stiffness_);
  form->addRow(QString(), by_detail_);
  labelled(tr("Fr&iction"), friction_, friction_);
  labelled(tr("Dam&ping"), damping_, damping_);
  labelled(tr("Not measure&d"), soft_, soft_);
  labelled(tr("Stiffness &map"), firmness_choose_, firmness_name_);
  auto* firmness_row = new QHBoxLayout;  // Of its own: beside them a name has no room.
  firmness_row->addWidget(firmness_choose_);
  firmness_row->addWidget(firmness_none_);
  form->addRow(firmness_row);
  labelled(tr("Edge &cue"), tick_, tick_);
  labelled(tr("Te&xture"), texture_, texture_);
  labelled(tr("Co&ntact impulse"), knock_, knock_);
  labelled(tr("Ma&gnet"), magnet_, magnet_);
  form->addRow(tr("Pressed in"), depth_);
  labelled(tr("&Device"), device_, device_);
  form->addRow(tried_);
  form->addRow(heat_);
  form->addRow(QString(), holds_grip_);
  form->addRow(tr("Force loop"), health_);
  form->addRow(QString(), details_);
  form->addRow(QString(), scope_);
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
  by_detail_->setToolTip(
      tr("0.8 N/mm at Detail 1 and 2, 0.6 at 3, 0.5 at finer ones. What is set here is then the "
         "shown level's own."));
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
  device_->installEventFilter(this);
  tried_ = readout("triedOnHardware", tr("Whether somebody has tried such a device"));
  heat_ = readout("motorHeat", tr("How warm the motors are"));
  heat_->hide();
  holds_grip_ = named(new QCheckBox(tr("Hold the grip's weig&ht")), "holdsGrip",
                      tr("Hold the grip's weight"));
  holds_grip_->setToolTip(tr(
      "While forces are on, the device holds its own grip, as heavy as the calibration found it. "
      "Nothing happens where it was not calibrated, or where the device does so by itself."));
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
  friction_ = numberBox(
      {"friction",
       tr("Friction at rest, 0 to 1"),
       {},
       tr("Force along the surface that holds the hand, as a part of the force against it; three "
          "quarters of it while sliding. The paper's proxies know none."),
       0,
       kMostFrictionAsked,
       0.05,
       2});
  damping_ =
      numberBox({"damping", tr("Damping in newton seconds per metre"), tr(" N s/m"),
                 tr("Against the speed of pressing in."), 0, kMmPerM * kMostDamping, 0.1, 1});
}

void HapticsPanel::buildFields() {
  soft_ =
      numberBox({"softPart", tr("Stiffness of ground that was not measured, in percent"), tr(" %"),
                 tr("How stiff filled gaps and the base plane are, as a part of the stiffness of "
                    "measured ground. 100 %: no difference."),
                 kPercent * kLeastSoftPart, kPercent, 5, 0});
  firmness_name_ = readout("firmnessName", tr("What says where the ground is firm"));
  firmness_choose_ = named(new QPushButton(tr("Choose…")), "firmnessChoose",
                           tr("Choose a raster that says where the ground is firm"));
  firmness_choose_->setToolTip(
      tr("A raster over the whole map: 1 where the ground is firm, 0 where it is as soft as set "
         "above. In place of where it was measured."));
  firmness_none_ = named(new QPushButton(tr("No&ne")), "firmnessNone",
                         tr("No raster: firm where it was measured"));
  firmness_none_->setToolTip(tr("The ground is firm where it was measured."));
  tick_ = numberBox({"crossingTick", tr("Edge cue at the border of measured ground, in newtons"),
                     tr(" N"),
                     tr("A faint tick on the way from measured ground to other ground, and "
                        "back. 0: none."),
                     0, kMostCrossingN, 0.02, 2});
  texture_ = numberBox({"texture", tr("Texture of the next finer level, in micrometres of hand"),
                        tr(" µm"),
                        tr("How much of the next finer level is felt, at most, on top of the level "
                           "that is touched. 0: none."),
                        0, kUmPerMm * kMostTextureMm, 5, 0});
  knock_ = numberBox({"contactKnock", tr("Contact impulse, in newtons at most"), tr(" N"),
                      tr("A short knock as hard as the hand comes. 0: none."), 0, kMostContactN,
                      0.05, 2});
  magnet_ =
      numberBox({"magnet", tr("Pull toward the surface, in newtons at most"), tr(" N"),
                 tr("A gentle pull that begins 3 mm above the surface and ends on it. 0: none."), 0,
                 kMostMagnetN, 0.1, 2});
}

void HapticsPanel::connectControls() {
  connect(forces_, &QCheckBox::toggled, this, &HapticsPanel::forcesAsked);
  connect(strength_, &QSlider::valueChanged, this, &HapticsPanel::changed);
  connect(by_detail_, &QCheckBox::toggled, this, &HapticsPanel::changed);
  connect(holds_grip_, &QCheckBox::toggled, this, &HapticsPanel::changed);
  connect(stiffness_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          &HapticsPanel::takeStiffness);
  connect(by_detail_, &QCheckBox::toggled, this, &HapticsPanel::showStiffness);
  for (QDoubleSpinBox* box :
       {stiffness_, friction_, damping_, soft_, tick_, texture_, knock_, magnet_}) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &HapticsPanel::changed);
  }
  for (QComboBox* box : {proxy_, surface_, device_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &HapticsPanel::changed);
  }
  connect(preset_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &HapticsPanel::takePreset);
  connect(firmness_choose_, &QPushButton::clicked, this, &HapticsPanel::askFirmness);
  connect(firmness_none_, &QPushButton::clicked, this, [this] { Q_EMIT firmnessAsked({}); });
  connect(scope_, &QPushButton::clicked, this, &HapticsPanel::showScope);
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
  for (const PluginDevice& device : plugin_devices_) device_->addItem(device.name, device.id);
  if (!chosen.isEmpty()) chooseDevice(chosen);
}

void HapticsPanel::setPluginDevices(std::vector<PluginDevice> devices) {
  plugin_devices_ = std::move(devices);
  listDevices();
}

/// Plug-ins are asked when somebody wants to choose, and not before.
bool HapticsPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool turned_to =
      event->type() == QEvent::FocusIn || event->type() == QEvent::MouseButtonPress;
  if (watched == device_ && turned_to) Q_EMIT devicesWanted();
  return QWidget::eventFilter(watched, event);
}

/// What the catalogue of devices says of the chosen one's kind.
void HapticsPanel::showTried() {
  const std::string id = device_->currentData().toString().toStdString();
  QString text =
      isPluginDevice(id) ? tr("Tried on hardware: ask who made the plug-in.") : QString();
  for (const DeviceDriver& driver : deviceCatalog()) {
    if (driver.tried_on_hardware.empty() || id.substr(0, id.find(':')) != driver.kind) continue;
    text = driver.tried_on_hardware == "never"
               ? tr("Tried on hardware: never.")
               : tr("Tried on hardware: %1.").arg(QString::fromStdString(driver.tried_on_hardware));
  }
  setTextIfNew(tried_, text);
  tried_->setVisible(!text.isEmpty());
}

void HapticsPanel::chooseDevice(const QString& id) {
  if (device_->findData(id) < 0) {
    QString name = id;
    try {
      name = QString::fromStdString(makeDevice(id.toStdString())->info().name);
    } catch (const Error&) {
      // Known to no driver: its id must do.
    }
    // Whether one of a plug-in, or a certain one of Haply's, is here, nobody has asked yet.
    const bool may_be_here =
        isPluginDevice(id.toStdString()) || id.startsWith(QLatin1String("haply:"));
    device_->addItem(may_be_here ? name : tr("%1 (not here now)").arg(name), id);
  }
  device_->setCurrentIndex(device_->findData(id));
  showTried();
}

void HapticsPanel::buildReadouts() {
  state_ = readout("forceState", tr("State of the forces"));
  change_ = readout("surfaceChange", tr("A new surface under the hand"));
  change_->hide();
  depth_ = readout("pressDepth", tr("How far the hand is pressed in"));
  health_ = readout("loopHealth", tr("How the force loop runs"));
  details_ = named(new QPushButton(tr("More a&bout the loop…")), "loopDetailsButton",
                   tr("More about the force loop"));
  scope_ = named(new QPushButton(tr("Plots &with a cursor…")), "scopeButton",
                 tr("Plots of height and force with a cursor"));
  scope_->setToolTip(tr("Pause, zoom, read values, and save as SVG or CSV."));
  details_->setToolTip(tr("Wake-ups and computing times as tables, and what the system granted."));
}

void HapticsPanel::changed() {
  strength_value_->setText(tr("%1 %").arg(strength_->value()));
  friction_->setEnabled(proxy_->currentIndex() == static_cast<int>(ProxyKind::converged));
  showPreset();
  showTried();
  Q_EMIT settingsChanged();
}

std::size_t HapticsPanel::level() const {
  constexpr int kLast = static_cast<int>(std::tuple_size_v<DetailStiffness>);
  return static_cast<std::size_t>(std::clamp<int>(report_.sample.detail, 1, kLast) - 1);
}

void HapticsPanel::takeStiffness(double value) {
  (by_detail_->isChecked() ? detail_stiffness_.at(level()) : fixed_stiffness_) = value;
}

void HapticsPanel::showStiffness() {
  const double k = by_detail_->isChecked() ? detail_stiffness_.at(level()) : fixed_stiffness_;
  const QSignalBlocker blocker(stiffness_);
  stiffness_->setValue(k);
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
        f(surface_), g(friction_), h(damping_), i(soft_), j(tick_), k(texture_), l(knock_),
        m(magnet_), n(holds_grip_);
    holds_grip_->setChecked(settings.holds_grip);
    const SurfaceFeel& feel = settings.feel;
    strength_->setValue(settings.strength_percent);
    by_detail_->setChecked(feel.stiffness_by_detail);
    detail_stiffness_ = feel.detail_stiffness;
    fixed_stiffness_ = feel.stiffness_n_per_mm;
    showStiffness();
    proxy_->setCurrentIndex(static_cast<int>(feel.proxy));
    surface_->setCurrentIndex(static_cast<int>(feel.surface));
    friction_->setValue(feel.friction);
    damping_->setValue(kMmPerM * feel.damping_n_s_per_mm);
    soft_->setValue(kPercent * feel.fields.softest_part);
    tick_->setValue(feel.transient.crossing_n);
    texture_->setValue(kUmPerMm * feel.fields.texture_mm);
    knock_->setValue(feel.transient.contact_n);
    magnet_->setValue(feel.fields.magnet_n);
    magnet_reach_mm_ = feel.fields.magnet_reach_mm;
    chooseDevice(QString::fromStdString(settings.device));
  }
  firmness_ = settings.firmness;
  showFirmness();
  changed();
}

SurfaceFeel HapticsPanel::feel() const {
  SurfaceFeel feel;
  feel.proxy = static_cast<ProxyKind>(proxy_->currentIndex());
  feel.surface = static_cast<SurfaceKind>(surface_->currentIndex());
  feel.stiffness_by_detail = by_detail_->isChecked();
  feel.stiffness_n_per_mm = fixed_stiffness_;
  feel.detail_stiffness = detail_stiffness_;
  feel.friction = friction_->value();
  feel.damping_n_s_per_mm = damping_->value() / kMmPerM;
  feel.fields.softest_part = soft_->value() / kPercent;
  feel.fields.texture_mm = texture_->value() / kUmPerMm;
  feel.fields.magnet_n = magnet_->value();
  feel.fields.magnet_reach_mm = magnet_reach_mm_;
  feel.transient.crossing_n = tick_->value();
  feel.transient.contact_n = knock_->value();
  return feel;
}

TouchSettings HapticsPanel::settings() const {
  TouchSettings settings;
  settings.strength_percent = strength_->value();
  settings.feel = feel();
  settings.firmness = firmness_;
  settings.holds_grip = holds_grip_->isChecked();
  settings.device = device_->currentData().toString().toStdString();
  return settings;
}

void HapticsPanel::askFirmness() {
  auto* dialog = new QFileDialog(this, tr("Stiffness map"),
                                 QFileInfo(QFile::decodeName(firmness_.c_str())).absolutePath(),
                                 tr("Rasters (*.tif *.tiff *.asc *.png);;All files (*)"));
  dialog->setObjectName(QStringLiteral("firmness_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &HapticsPanel::firmnessAsked);
  dialog->open();
}

void HapticsPanel::setFirmnessUsed(bool used) {
  firmness_used_ = used;
  showFirmness();
}

void HapticsPanel::showFirmness() {
  const QString file = QFile::decodeName(firmness_.c_str());
  const QString name = shownFileName(file);
  const QString text = firmness_.empty() ? tr("where it was measured")
                       : firmness_used_  ? name
                                         : tr("%1 (not of this map)").arg(name);
  setTextIfNew(firmness_name_, text);
  firmness_name_->setToolTip(shownFilePath(file).toHtmlEscaped());
  firmness_choose_->setAccessibleDescription(text);
  firmness_none_->setEnabled(!firmness_.empty());
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

void HapticsPanel::showScope() {
  if (!open_scope_) {
    open_scope_ = new ScopeDialog(this);
    open_scope_->setAttribute(Qt::WA_DeleteOnClose);
  }
  open_scope_->show();
  open_scope_->raise();
  open_scope_->activateWindow();
}

void HapticsPanel::plot(std::span<const ForcePoint> samples) {
  if (open_scope_) open_scope_->add(samples);
}

void HapticsPanel::setForcesAsked(bool on) {
  const QSignalBlocker blocker(forces_);
  forces_->setChecked(on);
}

void HapticsPanel::show(const LoopReport& report) {
  const HapticSample& sample = report.sample;
  const QString state = stateText(report);
  setTextIfNew(state_, report.stand_in.isEmpty() ? state : report.stand_in + '\n' + state);
  const bool changes = sample.change < 1 && sample.engaged != EngagePhase::off;
  if (changes) {
    const int percent = static_cast<int>(kPercent * sample.change);
    setTextIfNew(change_, tr("The new surface comes under the hand: %1 %.").arg(percent));
  }
  change_->setVisible(changes);
  setTextIfNew(depth_, sample.contact
                           ? tr("%1 mm of hand").arg(norm(sample.proxy - sample.hip), 0, 'f', 2)
                           : tr("not touching"));
  setTextIfNew(heat_, report.heat);
  heat_->setVisible(!report.heat.isEmpty());
  const bool another_level = report.sample.detail != report_.sample.detail;
  report_ = report;
  if (another_level && by_detail_->isChecked()) showStiffness();
  if (open_details_) open_details_->show(report_);
  // Read by speech, too: no oftener than once a second. Each new text is a picture of the window,
  // and without forces nobody waits for it.
  const int shows_per_line = sample.engaged == EngagePhase::off ? 32 : 8;
  if (health_shows_++ % shows_per_line != 0 && health_rate_hz_ > 0) return;
  health_rate_hz_ = report.stats.rate_hz;
  const QString health = healthText(report);
  setTextIfNew(health_, health);
  health_->setAccessibleDescription(health);
}

}  // namespace relievo
