// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/stereo_panel.h"

#include <algorithm>
#include <cmath>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/relief/eye_angle.h"
#include "ui/frame/side_panels.h"
#include "ui/language/core_text.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr double kScreenDistanceMm = 600;
constexpr int kMeterSteps = 100;  // Of a degree.

/// Two letters on black, each in the light that one filter lets through.
class GlassesPicture : public QWidget {
 public:
  explicit GlassesPicture(bool swapped) : swapped_(swapped) {
    setMinimumSize(360, 180);
    setAccessibleName(GlassesDialog::tr("Test picture"));
    setAccessibleDescription(
        GlassesDialog::tr("Left an L for the left eye alone, right an R for the right eye alone"));
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    QFont font = painter.font();
    font.setPixelSize(std::max(24, height() * 2 / 3));
    font.setBold(true);
    painter.setFont(font);
    const QColor red(255, 0, 0), cyan(0, 255, 255);
    const QRect left(0, 0, width() / 2, height());
    const QRect right(width() / 2, 0, width() - width() / 2, height());
    painter.setPen(swapped_ ? cyan : red);
    painter.drawText(left, Qt::AlignCenter, GlassesDialog::tr("L", "left eye"));
    painter.setPen(swapped_ ? red : cyan);
    painter.drawText(right, Qt::AlignCenter, GlassesDialog::tr("R", "right eye"));
  }

 private:
  bool swapped_;
};

}  // namespace

StereoPanel::StereoPanel(QWidget* parent)
    : QWidget(parent),
      on_(new QCheckBox(tr("Show in &stereo"))),
      automatic_(new QCheckBox(tr("At mi&d height"))),
      swap_(new QCheckBox(tr("S&wap eyes"))),
      comfort_(new QCheckBox(tr("&Keep comfortable"))),
      depth_(new QCheckBox(tr("Automatic dept&h"))),
      kind_(new QComboBox),
      angle_(new QDoubleSpinBox),
      plane_(new QDoubleSpinBox),
      meter_(new QProgressBar) {
  setObjectName(QStringLiteral("stereo_panel"));
  setProperty(SidePanels::kFoldedAtFirst, true);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(6, 0, 0, 6);
  layout->setVerticalSpacing(5);
  layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
  on_->setObjectName(QStringLiteral("stereo_on"));
  on_->setAccessibleName(tr("Show in stereo"));
  on_->setToolTip(tr("For red and cyan glasses, or for a screen for two eyes (Ctrl+3)"));
  kind_->setObjectName(QStringLiteral("stereo_kind"));
  kind_->setAccessibleName(tr("Kind of stereo"));
  kind_->setToolTip(
      tr("Grey: no colour fights with the glasses. Half colour: some colour. Dubois: least ghosts "
         "by the filters of common glasses. The others are for screens that show each eye its own "
         "half or rows; F11 gives them the whole screen"));
  kind_->addItems({tr("Grey"), tr("Half colour"), tr("Dubois"), tr("Side by side"),
                   tr("Over and under"), tr("Interlaced")});
  const StereoOptions first;
  angle_->setObjectName(QStringLiteral("eye_angle"));
  angle_->setAccessibleName(tr("Eye separation"));
  angle_->setToolTip(
      tr("Angle between the two eyes' directions; more gives more depth. A value of "
         "your own ends the automatic depth"));
  angle_->setDecimals(2);
  angle_->setRange(kLeastEyeAngleDeg, kMostEyeAngleDeg);
  angle_->setSingleStep(0.5);
  angle_->setSuffix(QStringLiteral("\u00b0"));
  angle_->setValue(first.eye_angle_deg);
  automatic_->setObjectName(QStringLiteral("zero_plane_auto"));
  automatic_->setAccessibleName(tr("Zero plane at mid height"));
  automatic_->setToolTip(tr("The screen lies halfway between the lowest and the highest point"));
  automatic_->setChecked(true);
  plane_->setObjectName(QStringLiteral("zero_plane"));
  plane_->setAccessibleName(tr("Zero plane"));
  plane_->setToolTip(tr("Height that appears in the plane of the screen"));
  plane_->setSuffix(QStringLiteral(" mm"));
  plane_->setEnabled(false);
  swap_->setObjectName(QStringLiteral("stereo_swap"));
  swap_->setAccessibleName(tr("Swap eyes"));
  swap_->setToolTip(tr("For glasses whose red filter is at the right eye"));
  depth_->setObjectName(QStringLiteral("stereo_automatic"));
  depth_->setAccessibleName(tr("Automatic depth"));
  depth_->setToolTip(
      tr("The eye separation with which the heights that are shown fill the comfortable depth"));
  depth_->setChecked(true);
  comfort_->setObjectName(QStringLiteral("stereo_comfort"));
  comfort_->setAccessibleName(tr("Keep comfortable"));
  comfort_->setToolTip(
      tr("Less eye separation where the two pictures would lie farther apart than the eyes like"));
  meter_->setObjectName(QStringLiteral("parallax_meter"));
  meter_->setAccessibleName(tr("Parallax"));
  meter_->setToolTip(
      tr("How far apart the eyes see the farthest point, at 60 cm from the screen; above 1 degree "
         "many people see double"));
  meter_->setRange(0, static_cast<int>(kComfortDeg * kMeterSteps));
  auto* glasses = new QPushButton(tr("Test &glasses\u2026"));
  glasses->setObjectName(QStringLiteral("test_glasses"));
  glasses->setAccessibleName(tr("Test glasses"));
  glasses->setToolTip(tr("A picture that says whether the filters are at the right eyes"));
  layout->addRow(on_);
  layout->addRow(tr("K&ind"), kind_);
  layout->addRow(depth_);
  layout->addRow(tr("Eye sepa&ration"), angle_);
  layout->addRow(comfort_);
  layout->addRow(tr("Parallax"), meter_);
  layout->addRow(tr("Zero &plane"), automatic_);
  layout->addRow(QString(), plane_);
  layout->addRow(swap_);
  layout->addRow(glasses);
  wanted_.automatic_depth = true;
  const auto take = [this](auto* control, auto signal, void (*part)(StereoPanel&)) {
    connect(control, signal, this, [this, part] {
      part(*this);
      tell();
    });
  };
  const auto mode = [](StereoPanel& p) {
    p.wanted_.mode =
        p.on_->isChecked() ? static_cast<StereoMode>(1 + p.kind_->currentIndex()) : StereoMode::off;
  };
  const auto plane = [](StereoPanel& p) {
    p.wanted_.zero_plane_mm.reset();
    if (!p.automatic_->isChecked()) p.wanted_.zero_plane_mm = p.plane_->value();
  };
  const auto spun = QOverload<double>::of(&QDoubleSpinBox::valueChanged);
  take(on_, &QCheckBox::toggled, mode);
  take(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), mode);
  take(automatic_, &QCheckBox::toggled, plane);
  take(plane_, spun, plane);
  take(swap_, &QCheckBox::toggled,
       [](StereoPanel& p) { p.wanted_.swap_eyes = p.swap_->isChecked(); });
  take(comfort_, &QCheckBox::toggled, [](StereoPanel&) {});
  take(depth_, &QCheckBox::toggled, [](StereoPanel& p) {
    p.wanted_.automatic_depth = p.depth_->isChecked();
    p.wanted_.eye_angle_deg = p.angle_->value();
  });
  take(angle_, spun, [](StereoPanel& p) {
    p.wanted_.automatic_depth = false;
    p.wanted_.eye_angle_deg = p.angle_->value();
    const QSignalBlocker once(p.depth_);
    p.depth_->setChecked(false);
  });
  connect(glasses, &QPushButton::clicked, this, [this] {
    auto* dialog = new GlassesDialog(swap_->isChecked(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  });
  showMeter();
}

void StereoPanel::tell() {
  plane_->setEnabled(!automatic_->isChecked());
  showMeter();
  Q_EMIT changed(options());
}

double StereoPanel::farthestMm(const Shown& shown) const {
  const double zero = wanted_.zero_plane_mm.value_or(0.5 * (shown.low_mm + shown.high_mm));
  return std::max(std::abs(shown.high_mm - zero), std::abs(shown.low_mm - zero));
}

double StereoPanel::drawnDeg(const Shown& shown) const {
  const double farthest = farthestMm(shown);
  if (wanted_.automatic_depth) {
    return automaticEyeAngle(farthest, shown.screen_per_mm, kScreenDistanceMm);
  }
  if (!comfort_->isChecked()) return wanted_.eye_angle_deg;
  return comfortableEyeAngle(farthest, shown.screen_per_mm, wanted_.eye_angle_deg,
                             kScreenDistanceMm);
}

void StereoPanel::showMeter() {
  const double angle = drawnDeg(shown_);
  if (depth_->isChecked()) {  // A value of one's own begins where the automatic one is.
    const QSignalBlocker quiet(angle_);
    angle_->setValue(angle);
  }
  comfort_->setEnabled(!depth_->isChecked());
  const double degrees =
      on_->isChecked()
          ? parallax(farthestMm(shown_), angle, shown_.screen_per_mm, kScreenDistanceMm).visual_deg
          : 0;
  meter_->setValue(
      std::min(static_cast<int>(std::lround(degrees * kMeterSteps)), meter_->maximum()));
  meter_->setFormat(
      degrees > kComfortDeg + 0.005
          ? tr("%1\u00b0, above %2\u00b0").arg(numberText(degrees, 1), numberText(kComfortDeg, 1))
          : tr("%1\u00b0 of %2\u00b0").arg(numberText(degrees, 1), numberText(kComfortDeg, 1)));
  if (on_->isChecked() && depth_->isChecked()) {
    meter_->setFormat(tr("%1, automatic").arg(meter_->format()));
  }
  meter_->setAccessibleDescription(meter_->format());
}

StereoOptions StereoPanel::options() const {
  return optionsFor(shown_);
}

StereoOptions StereoPanel::optionsFor(const Shown& shown) const {
  StereoOptions o = wanted_;
  o.eye_angle_deg = std::max(drawnDeg(shown), kLeastEyeAngleDeg);
  return o;
}

std::optional<double> StereoPanel::chosenAngleDeg() const {
  if (wanted_.automatic_depth || options().eye_angle_deg == wanted_.eye_angle_deg) {
    return std::nullopt;
  }
  return wanted_.eye_angle_deg;
}

void StereoPanel::setKind(StereoMode kind) {
  const QSignalBlocker quiet(kind_);
  kind_->setCurrentIndex(std::max(0, static_cast<int>(kind) - 1));
}

void StereoPanel::setComfort(bool keep) {
  comfort_->setChecked(keep);
}

void StereoPanel::setAutomaticDepth(bool on) {
  depth_->setChecked(on);
}

void StereoPanel::setOn(bool on) {
  on_->setChecked(on);
}

void StereoPanel::show(const StereoOptions& options, const std::optional<double>& chosen_deg) {
  wanted_ = options;
  wanted_.eye_angle_deg = chosen_deg.value_or(options.eye_angle_deg);
  showControls();
}

void StereoPanel::showControls() {
  const QSignalBlocker on(on_), automatic(automatic_), swap(swap_), depth(depth_), angle(angle_),
      plane(plane_);
  automatic_->setChecked(!wanted_.zero_plane_mm.has_value());
  if (wanted_.zero_plane_mm) plane_->setValue(*wanted_.zero_plane_mm);
  plane_->setEnabled(wanted_.zero_plane_mm.has_value());
  angle_->setValue(wanted_.eye_angle_deg);
  depth_->setChecked(wanted_.automatic_depth);
  swap_->setChecked(wanted_.swap_eyes);
  if (wanted_.mode != StereoMode::off) setKind(wanted_.mode);
  on_->setChecked(wanted_.mode != StereoMode::off);
  showMeter();
}

void StereoPanel::setHeights(double low_mm, double high_mm) {
  const QSignalBlocker quiet(plane_);
  const double range = high_mm - low_mm;
  plane_->setRange(low_mm - range, high_mm + range);
  plane_->setSingleStep(range > 0 ? range / 20 : 1);
  if (automatic_->isChecked()) plane_->setValue(0.5 * (low_mm + high_mm));
}

void StereoPanel::setShown(const Shown& shown) {
  const double before = drawnDeg(shown_);
  shown_ = shown;
  showMeter();
  const bool wanted = on_->isChecked() || depth_->isChecked();
  if (wanted && drawnDeg(shown_) != before) Q_EMIT drawnChanged();
}

GlassesDialog::GlassesDialog(bool swapped, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("glasses_dialog"));
  setWindowTitle(tr("Test glasses"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(new GlassesPicture(swapped), 1);
  auto* hint = new QLabel(tr(
      "Put the glasses on and close your right eye: you should see only the L, bright on black. "
      "With the left eye closed only the R. If it is the other way round, turn on \"Swap eyes\". "
      "What shines through faintly is a ghost; Dubois has the least."));
  hint->setWordWrap(true);
  column->addWidget(hint);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  nameButtons(*buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  resize(420, 340);
}

}  // namespace relievo
