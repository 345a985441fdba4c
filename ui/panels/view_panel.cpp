// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/view_panel.h"

#include <array>
#include <cmath>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/style/mnemonic.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr int kColumns = 2;
constexpr std::array<const char*, 6> kViews{"front", "back", "left", "right", "top", "bottom"};

QPushButton* button(const QString& text, const QString& name, const QString& tip) {
  auto* b = new QPushButton(text);
  b->setObjectName(name);
  b->setAccessibleName(withoutMnemonic(text));
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

ViewPanel::ViewPanel(QWidget* parent)
    : QWidget(parent), now_(new QLabel), light_part_(new QWidget(this)) {
  setObjectName(QStringLiteral("view_panel"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 0, 0, 2);
  layout->setSpacing(0);
  layout->setColumnStretch(0, 1);
  layout->setColumnStretch(1, 1);
  now_->setAccessibleName(tr("Seen from"));
  now_->setObjectName(QStringLiteral("view_now"));
  layout->addWidget(now_, 0, 0, 1, kColumns);
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    const QString name = QString::fromLatin1(kViews[i]);
    auto* b = button(viewText(name), QLatin1String("view_") + name,
                     tr("Look from this side (Alt+%1)").arg(i + 1));
    connect(b, &QPushButton::clicked, this, [this, name] { Q_EMIT viewChosen(name); });
    layout->addWidget(b, 1 + static_cast<int>(i) / kColumns, static_cast<int>(i) % kColumns);
  }
  auto* automatic = button(tr("Automatic"), QStringLiteral("view_auto"),
                           tr("Look from the side that shows most"));
  connect(automatic, &QPushButton::clicked, this,
          [this] { Q_EMIT viewChosen(QStringLiteral("auto")); });
  layout->addWidget(automatic, 4, 0, 1, kColumns);
  use_ = button(tr("Use this view"), QStringLiteral("use_this_view"),
                tr("Make the depth map from where the turned detail view looks"));
  straighten_ = button(tr("Straighten"), QStringLiteral("straighten"),
                       tr("Look straight down on the relief again"));
  connect(use_, &QPushButton::clicked, this, &ViewPanel::useThisViewAsked);
  connect(straighten_, &QPushButton::clicked, this, &ViewPanel::straightenAsked);
  layout->addWidget(use_, 5, 0, 1, kColumns);
  layout->addWidget(straighten_, 6, 0, 1, kColumns);
  makeLightPart();
  showView({});
  showTurned(false);
}

void ViewPanel::makeLightPart() {
  light_part_->setObjectName(QStringLiteral("light_panel"));
  auto* layout = new QVBoxLayout(light_part_);
  layout->setContentsMargins(6, 0, 0, 2);
  layout->setSpacing(0);
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
  layout->addWidget(light_text_);
  auto* sliders = new QHBoxLayout;  // Rough; the sphere in the view is the fine one.
  sliders->addWidget(azimuth_);
  sliders->addWidget(elevation_);
  layout->addLayout(sliders);
  const auto tell = [this] {
    tellLight();
    Q_EMIT lightChanged(light());
  };
  connect(azimuth_, &QSlider::valueChanged, this, tell);
  connect(elevation_, &QSlider::valueChanged, this, tell);
  tellLight();
  shading_text_ = new QLabel;
  shading_text_->setObjectName(QStringLiteral("shading_text"));
  shading_text_->setAccessibleName(tr("Shading of colours"));
  shading_ = slider(QStringLiteral("look_shading"), tr("Shading of colours"), QString(), 0, 100, 0);
  shading_->setPageStep(10);
  layout->addWidget(shading_text_);
  layout->addWidget(shading_);
  connect(shading_, &QSlider::valueChanged, this, [this](int percent) {
    tellShading();
    Q_EMIT shadingChanged(percent / 100.0);
  });
  showShading(ReliefLook{}.shading, false);
}

void ViewPanel::showShading(double shading, bool usable) {
  const QSignalBlocker quiet(shading_);  // A third is not 33 %.
  shading_->setValue(static_cast<int>(std::lround(100 * shading)));
  shading_->setEnabled(usable);
  // Of two relief images only: the others need the room for what follows.
  shading_->setVisible(usable);
  shading_text_->setVisible(usable);
  shading_->setToolTip(
      usable ? tr("How much relief shading the scan's own colours get: 0 is as photographed")
             : tr("Only natural colours and intensity are mixed with relief shading"));
  tellShading();
}

void ViewPanel::tellShading() {
  shading_text_->setText(tr("Shading of colours: %1 %").arg(shading_->value()));
}

LightOptions ViewPanel::light() const {
  return {static_cast<double>(azimuth_->value()), static_cast<double>(elevation_->value())};
}

void ViewPanel::showLight(const LightOptions& light) {
  const QSignalBlocker azimuth(azimuth_), elevation(elevation_);  // They show whole degrees only.
  azimuth_->setValue(static_cast<int>(std::lround(light.azimuth_deg)));
  elevation_->setValue(static_cast<int>(std::lround(light.elevation_deg)));
  tellLight();
}

void ViewPanel::tellLight() {
  light_text_->setText(
      tr("Light from %1\u00b0, %2\u00b0 high").arg(azimuth_->value()).arg(elevation_->value()));
}

void ViewPanel::showView(const QString& name) {
  setEnabled(!name.isEmpty());
  light_part_->setEnabled(!name.isEmpty());
  now_->setText(name.isEmpty() ? QString() : tr("Seen from: %1").arg(viewText(name)));
}

void ViewPanel::showTurned(bool turned) {
  use_->setEnabled(turned);
  straighten_->setEnabled(turned);
}

}  // namespace relievo
