// SPDX-License-Identifier: BSD-3-Clause
#include "ui/view_panel.h"

#include <array>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include "ui/text.h"

namespace relievo {
namespace {

constexpr std::array<const char*, 6> kViews{"front", "back", "left", "right", "top", "bottom"};

QPushButton* button(const QString& text, const QString& name, const QString& tip) {
  auto* b = new QPushButton(text);
  b->setObjectName(name);
  b->setAccessibleName(QString(text).remove('&'));
  b->setToolTip(tip);
  b->setMinimumWidth(40);
  return b;
}

QSlider* slider(const QString& name, const QString& title, const QString& tip, int low, int high,
                int value) {
  auto* s = new QSlider(Qt::Horizontal);
  s->setObjectName(name);
  s->setAccessibleName(title);
  s->setToolTip(tip);
  s->setRange(low, high);
  s->setPageStep(5);
  s->setValue(value);
  return s;
}

}  // namespace

ViewPanel::ViewPanel(QWidget* parent) : QWidget(parent), now_(new QLabel) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 0, 0, 6);
  layout->setSpacing(5);
  now_->setAccessibleName(tr("Seen from"));
  now_->setObjectName(QStringLiteral("view_now"));
  layout->addWidget(now_, 0, 0, 1, 3);
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    const QString name = QString::fromLatin1(kViews[i]);
    auto* b = button(viewText(name), QLatin1String("view_") + name,
                     tr("Look from this side (Alt+%1)").arg(i + 1));
    connect(b, &QPushButton::clicked, this, [this, name] { Q_EMIT viewChosen(name); });
    layout->addWidget(b, 1 + static_cast<int>(i) / 3, static_cast<int>(i) % 3);
  }
  auto* automatic = button(tr("Automatic"), QStringLiteral("view_auto"),
                           tr("Look from the side that shows most"));
  connect(automatic, &QPushButton::clicked, this,
          [this] { Q_EMIT viewChosen(QStringLiteral("auto")); });
  layout->addWidget(automatic, 3, 0, 1, 3);
  use_ = button(tr("Use this view"), QStringLiteral("use_this_view"),
                tr("Make the depth map from where the turned detail view looks"));
  straighten_ = button(tr("Straighten"), QStringLiteral("straighten"),
                       tr("Look straight down on the relief again"));
  connect(use_, &QPushButton::clicked, this, &ViewPanel::useThisViewAsked);
  connect(straighten_, &QPushButton::clicked, this, &ViewPanel::straightenAsked);
  layout->addWidget(use_, 4, 0, 1, 2);
  layout->addWidget(straighten_, 4, 2);

  light_text_ = new QLabel;
  light_text_->setObjectName(QStringLiteral("light_text"));
  light_text_->setAccessibleName(tr("Light"));
  const LightOptions first;
  azimuth_ = slider(QStringLiteral("light_azimuth"), tr("Direction of the light"),
                    tr("Where the light comes from: 0 is above, clockwise"), 0, 359,
                    static_cast<int>(first.azimuth_deg));
  azimuth_->setPageStep(15);
  elevation_ =
      slider(QStringLiteral("light_elevation"), tr("Height of the light"),
             tr("Low light brings out worn detail"), 5, 90, static_cast<int>(first.elevation_deg));
  layout->addWidget(light_text_, 5, 0, 1, 3);
  layout->addWidget(azimuth_, 6, 0, 1, 3);
  layout->addWidget(elevation_, 7, 0, 1, 3);
  const auto tell = [this] {
    light_text_->setText(
        tr("Light from %1\u00b0, %2\u00b0 high").arg(azimuth_->value()).arg(elevation_->value()));
    Q_EMIT lightChanged(light());
  };
  connect(azimuth_, &QSlider::valueChanged, this, tell);
  connect(elevation_, &QSlider::valueChanged, this, tell);
  tell();
  showView({});
  showTurned(false);
}

LightOptions ViewPanel::light() const {
  return {static_cast<double>(azimuth_->value()), static_cast<double>(elevation_->value())};
}

void ViewPanel::showView(const QString& name) {
  setEnabled(!name.isEmpty());
  now_->setText(name.isEmpty() ? QString() : tr("Seen from: %1").arg(viewText(name)));
}

void ViewPanel::showTurned(bool turned) {
  use_->setEnabled(turned);
  straighten_->setEnabled(turned);
}

StereoPanel::StereoPanel(QWidget* parent)
    : QWidget(parent),
      on_(new QCheckBox(tr("Red/cyan &anaglyph"))),
      automatic_(new QCheckBox(tr("At &mid height"))),
      angle_(new QDoubleSpinBox),
      plane_(new QDoubleSpinBox) {
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(6, 0, 0, 6);
  layout->setVerticalSpacing(5);
  on_->setObjectName(QStringLiteral("stereo_on"));
  on_->setAccessibleName(tr("Red and cyan anaglyph"));
  on_->setToolTip(tr("For red and cyan glasses (Ctrl+3)"));
  const StereoOptions first;
  angle_->setObjectName(QStringLiteral("eye_angle"));
  angle_->setAccessibleName(tr("Eye separation"));
  angle_->setToolTip(tr("Angle between the two eyes' directions; more gives more depth"));
  angle_->setRange(0.5, 10);
  angle_->setSingleStep(0.5);
  angle_->setDecimals(1);
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
  layout->addRow(on_);
  layout->addRow(tr("Eye sepa&ration"), angle_);
  layout->addRow(tr("Zero &plane"), automatic_);
  layout->addRow(QString(), plane_);
  connect(on_, &QCheckBox::toggled, this, &StereoPanel::tell);
  connect(automatic_, &QCheckBox::toggled, this, &StereoPanel::tell);
  for (QDoubleSpinBox* box : {angle_, plane_}) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &StereoPanel::tell);
  }
}

void StereoPanel::tell() {
  plane_->setEnabled(!automatic_->isChecked());
  Q_EMIT changed(options());
}

StereoOptions StereoPanel::options() const {
  StereoOptions o;
  o.mode = on_->isChecked() ? StereoMode::anaglyph : StereoMode::off;
  o.eye_angle_deg = angle_->value();
  if (!automatic_->isChecked()) o.zero_plane_mm = plane_->value();
  return o;
}

void StereoPanel::setOn(bool on) {
  on_->setChecked(on);
}

void StereoPanel::show(const StereoOptions& options) {
  {
    const QSignalBlocker quiet(this);
    automatic_->setChecked(!options.zero_plane_mm.has_value());
    if (options.zero_plane_mm) plane_->setValue(*options.zero_plane_mm);
    angle_->setValue(options.eye_angle_deg);
    on_->setChecked(options.mode != StereoMode::off);
  }
  tell();
}

void StereoPanel::setHeights(double low_mm, double high_mm) {
  const QSignalBlocker quiet(plane_);
  const double range = high_mm - low_mm;
  plane_->setRange(low_mm - range, high_mm + range);
  plane_->setSingleStep(range > 0 ? range / 20 : 1);
  if (automatic_->isChecked()) plane_->setValue(0.5 * (low_mm + high_mm));
}

}  // namespace relievo
