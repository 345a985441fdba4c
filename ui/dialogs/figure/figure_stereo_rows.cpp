// SPDX-License-Identifier: BSD-3-Clause
// Two eyes.
#include <cmath>

#include "core/relief/eye_angle.h"
#include "ui/dialogs/figure/far_limit.h"
#include "ui/dialogs/figure/figure_form.h"
#include "ui/dialogs/figure/figure_form_parts.h"
#include "ui/dialogs/figure/figure_form_rows.h"

namespace relievo {
namespace {

constexpr double kStepMm = 0.001;  // That the automatic zero plane is rounded to.
constexpr std::array<const char*, 6> kStereos{
    QT_TRANSLATE_NOOP("relievo::FigureForm", "None"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Anaglyph, grey"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Anaglyph, half colour"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Anaglyph, Dubois"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Side by side"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "One over the other")};

}  // namespace

FigureStereoRows::FigureStereoRows(FigureFormRows& rows) {
  stereo_ = rows.field<QComboBox>(FigureForm::tr("Stereo"), "figure_stereo",
                                  FigureForm::tr("For red and cyan glasses, or two pictures"));
  for (const char* name : kStereos) stereo_->addItem(FigureForm::tr(name));
  eye_ = rows.field<FigureNumber>(FigureForm::tr("Eyes apart"), "figure_eye",
                                  FigureForm::tr("Angle between the two eyes' directions"));
  eye_->setLimits(kLeastEyeAngleDeg, kMostEyeAngleDeg, 1, QStringLiteral("\u00b0"));
  comfort_ =
      rows.field<QCheckBox>(FigureForm::tr("&Keep to 1\u00b0 of parallax"), "figure_comfort",
                            FigureForm::tr("Less angle where many readers would see double"));
  own_zero_plane_ =
      rows.field<QCheckBox>(FigureForm::tr("Own &zero plane"), "figure_zero_plane_on",
                            FigureForm::tr("Choose the height that lies in the plane of the paper; "
                                           "otherwise it is mid height"));
  zero_plane_ = rows.field<FigureNumber>(
      FigureForm::tr("Zero plane"), "figure_zero_plane",
      FigureForm::tr("Height of zero parallax: what is higher stands out of the "
                     "paper, what is lower lies behind it"));
  zero_plane_->setLimits(-kFarMm, kFarMm, 1, QStringLiteral(" mm"));
  zero_plane_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  swap_ =
      rows.field<QCheckBox>(FigureForm::tr("Swap eyes"), "figure_swap",
                            FigureForm::tr("For glasses the other way round, or for crossed eyes"));
}

void FigureStereoRows::show(const FigureRequest& f) {
  stereo_->setCurrentIndex(static_cast<int>(f.stereo));
  eye_->show(f.eye_angle_deg);
  comfort_->setChecked(f.limit_parallax);
  own_zero_plane_->setChecked(f.zero_plane_mm.has_value());
  if (f.zero_plane_mm) zero_plane_->show(*f.zero_plane_mm);
  swap_->setChecked(f.swap_eyes);
}

void FigureStereoRows::writeTo(FigureRequest& f) const {
  f.stereo = static_cast<StereoPrint>(stereo_->currentIndex());
  f.eye_angle_deg = eye_->valueOr(f.eye_angle_deg);
  f.limit_parallax = comfort_->isChecked();
  if (own_zero_plane_->isChecked()) {
    f.zero_plane_mm = zero_plane_->valueOr(f.zero_plane_mm.value_or(zero_plane_->value()));
  } else {
    f.zero_plane_mm.reset();
  }
  f.swap_eyes = swap_->isChecked();
}

StereoPrint FigureStereoRows::stereo() const {
  return static_cast<StereoPrint>(stereo_->currentIndex());
}

void FigureStereoRows::limit(bool both_eyes) {
  const bool eyes = stereo() != StereoPrint::off || both_eyes;
  const QString one_eye = FigureForm::tr("Choose a kind of stereo, or both eyes as files");
  for (QWidget* widget : {static_cast<QWidget*>(eye_), static_cast<QWidget*>(comfort_),
                          static_cast<QWidget*>(swap_)}) {
    setUsable(widget, eyes, one_eye);
  }
  // What is on can be turned off: it may be what the figure is refused for.
  const bool own = own_zero_plane_->isChecked();
  setUsable(own_zero_plane_, eyes || own, one_eye);
  setUsable(zero_plane_, own, eyes ? FigureForm::tr("Turn on \"Own zero plane\" first") : one_eye);
}

void FigureStereoRows::showAutomatic(const FigureFacts& facts) {
  if (own_zero_plane_->isChecked()) return;
  zero_plane_->show(std::round(facts.zero_plane_mm / kStepMm) * kStepMm);
}

}  // namespace relievo
