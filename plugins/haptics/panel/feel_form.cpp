// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/feel_form.h"

#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <tuple>

#include "plugins/haptics/panel/panel_widgets.h"
#include "plugins/haptics/touch_settings.h"

namespace relievo {

namespace {
constexpr int kOwnValues = static_cast<int>(kSurfacePresets.size());  // Index after the presets.
}  // namespace

FeelForm::FeelForm(QObject* parent) : QObject(parent) {
  buildSurface();
  buildCues();
  connectControls();
}

void FeelForm::addSurfaceRows(QFormLayout* form) {
  addLabelled(form, tr("S&urface"), preset_, preset_);
  addLabelled(form, tr("Sh&ape"), surface_, surface_);
  addLabelled(form, tr("Prox&y"), proxy_, proxy_);
  addLabelled(form, tr("Stiff&ness"), stiffness_, stiffness_);
  form->addRow(QString(), by_detail_);
  addLabelled(form, tr("Fr&iction"), friction_, friction_);
  addLabelled(form, tr("Dam&ping"), damping_, damping_);
  addLabelled(form, tr("Not measure&d"), soft_, soft_);
}

void FeelForm::addCueRows(QFormLayout* form) {
  addLabelled(form, tr("Edge &cue"), edge_, edge_);
  addLabelled(form, tr("Te&xture"), texture_, texture_);
  addLabelled(form, tr("Co&ntact impulse"), contact_, contact_);
  addLabelled(form, tr("Ma&gnet"), magnet_, magnet_);
}

void FeelForm::buildSurface() {
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
  by_detail_ = named(new QCheckBox(tr("as the &level suggests")), "stiffnessByDetail",
                     tr("Stiffness as the level suggests"));
  by_detail_->setToolTip(tr(
      "0.8 N/mm at resolution 1 and 2, 0.6 at 3, 0.5 at finer ones. What is set here is then the "
      "shown level's own."));
  stiffness_ = named(new QDoubleSpinBox, "stiffness", tr("Stiffness in newtons per millimetre"));
  stiffness_->setRange(kLeastStiffness, kMostStiffness);
  stiffness_->setSingleStep(0.05);
  stiffness_->setDecimals(2);
  stiffness_->setSuffix(tr(" N/mm"));
  stiffness_->setToolTip(tr("Force per millimetre that the hand is pressed in."));
  soft_ =
      numberBox({"softPart", tr("Stiffness of ground that was not measured, in percent"), tr(" %"),
                 tr("How stiff filled gaps and the base plane are, as a part of the stiffness of "
                    "measured ground. 100 %: no difference."),
                 kPercent * kLeastSoftPart, kPercent, 5, 0});
}

void FeelForm::buildCues() {
  edge_ = numberBox({"crossingTick", tr("Edge cue at the border of measured ground, in newtons"),
                     tr(" N"),
                     tr("A faint cue on the way from measured ground to other ground, and "
                        "back. 0: none."),
                     0, kMostCrossingN, 0.02, 2});
  texture_ = numberBox({"texture", tr("Texture of the next finer level, in micrometres of hand"),
                        tr(" µm"),
                        tr("How much of the next finer level is felt, at most, on top of the level "
                           "that is touched. 0: none."),
                        0, kUmPerMm * kMostTextureMm, 5, 0});
  contact_ = numberBox({"contactKnock", tr("Contact impulse, in newtons at most"), tr(" N"),
                        tr("A short impulse as hard as the hand comes. 0: none."), 0, kMostContactN,
                        0.05, 2});
  magnet_ =
      numberBox({"magnet", tr("Pull toward the surface, in newtons at most"), tr(" N"),
                 tr("A gentle pull that begins 3 mm above the surface and ends on it. 0: none."), 0,
                 kMostMagnetN, 0.1, 2});
}

void FeelForm::connectControls() {
  connect(by_detail_, &QCheckBox::toggled, this, &FeelForm::takeChange);
  connect(stiffness_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          &FeelForm::takeStiffness);
  connect(by_detail_, &QCheckBox::toggled, this, &FeelForm::showStiffness);
  for (QDoubleSpinBox* box :
       {stiffness_, friction_, damping_, soft_, edge_, texture_, contact_, magnet_}) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &FeelForm::takeChange);
  }
  for (QComboBox* box : {proxy_, surface_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FeelForm::takeChange);
  }
  connect(preset_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &FeelForm::takePreset);
}

void FeelForm::takeChange() {
  showWhatDependsOnOthers();
  Q_EMIT changed();
}

void FeelForm::showWhatDependsOnOthers() {
  friction_->setEnabled(proxy_->currentIndex() == static_cast<int>(ProxyKind::converged));
  showPreset();
}

std::size_t FeelForm::level() const {
  constexpr int kLast = static_cast<int>(std::tuple_size_v<DetailStiffness>);
  return static_cast<std::size_t>(std::clamp<int>(detail_, 1, kLast) - 1);
}

void FeelForm::setDetail(int detail) {
  const bool is_another = detail != detail_;
  detail_ = detail;
  if (is_another && by_detail_->isChecked()) showStiffness();
}

void FeelForm::takeStiffness(double value) {
  (by_detail_->isChecked() ? detail_stiffness_.at(level()) : fixed_stiffness_) = value;
}

void FeelForm::showStiffness() {
  const double k = by_detail_->isChecked() ? detail_stiffness_.at(level()) : fixed_stiffness_;
  const QSignalBlocker blocker(stiffness_);
  stiffness_->setValue(k);
}

void FeelForm::takePreset(int index) {
  if (index < 0 || index >= kOwnValues) return;
  setFeel(kSurfacePresets.at(static_cast<std::size_t>(index)).feel);
  Q_EMIT changed();
}

void FeelForm::showPreset() {
  int index = 0;
  while (index < kOwnValues &&
         !feelsTheSame(feel(), kSurfacePresets.at(static_cast<std::size_t>(index)).feel)) {
    ++index;
  }
  const QSignalBlocker blocker(preset_);
  preset_->setCurrentIndex(index);
}

void FeelForm::setFeel(const SurfaceFeel& feel) {
  const QSignalBlocker a(by_detail_), b(stiffness_), c(proxy_), d(surface_), e(friction_),
      f(damping_), g(soft_), h(edge_), i(texture_), j(contact_), k(magnet_);
  by_detail_->setChecked(feel.stiffness_by_detail);
  detail_stiffness_ = feel.detail_stiffness;
  fixed_stiffness_ = feel.stiffness_n_per_mm;
  showStiffness();
  proxy_->setCurrentIndex(static_cast<int>(feel.proxy));
  surface_->setCurrentIndex(static_cast<int>(feel.surface));
  friction_->setValue(feel.friction);
  damping_->setValue(kMmPerM * feel.damping_n_s_per_mm);
  soft_->setValue(kPercent * feel.fields.softest_part);
  edge_->setValue(feel.transient.crossing_n);
  texture_->setValue(kUmPerMm * feel.fields.texture_mm);
  contact_->setValue(feel.transient.contact_n);
  magnet_->setValue(feel.fields.magnet_n);
  magnet_reach_mm_ = feel.fields.magnet_reach_mm;
  showWhatDependsOnOthers();
}

SurfaceFeel FeelForm::feel() const {
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
  feel.transient.crossing_n = edge_->value();
  feel.transient.contact_n = contact_->value();
  return feel;
}

}  // namespace relievo
