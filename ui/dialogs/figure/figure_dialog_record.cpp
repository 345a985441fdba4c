// SPDX-License-Identifier: BSD-3-Clause
// The fields of the figure dialog and the record they stand for.
#include <algorithm>
#include <cmath>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include "core/relief/relief_image.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/dialogs/figure/figure_number.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr double kSteps = 1000;  // That an automatic value is rounded to, of what it spans.

/// Enables a field, or says in its tooltip what keeps it from being of use.
void setUsable(QWidget* widget, bool usable, const QString& why_not) {
  constexpr const char* kTip = "figure_tip";
  if (!widget->property(kTip).isValid()) widget->setProperty(kTip, widget->toolTip());
  const QString tip = widget->property(kTip).toString();
  widget->setEnabled(usable);
  widget->setToolTip(usable ? tip : QStringLiteral("%1. (%2)").arg(tip, why_not));
}

double rounded(double value, double step) {
  return step > 0 ? std::round(value / step) * step : value;
}

std::filesystem::path pathOf(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

}  // namespace

void FigureDialog::showRequest(const FigureRequest& f) {
  const QSignalBlocker quiet(this);
  layout_->setCurrentIndex(static_cast<int>(f.layout));
  recording_->setText(pathFromBytes(f.recording));
  width_->show(f.width_mm);
  to_scale_->setChecked(f.scale_1_to.has_value());
  if (f.scale_1_to) scale_->show(*f.scale_1_to);
  dpi_->show(f.dpi);
  text_->show(f.text_pt);
  relief_->setCurrentIndex(static_cast<int>(f.look.kind));
  shown_relief_ = relief_->currentIndex();
  colours_->setCurrentIndex(static_cast<int>(f.look.colours));
  azimuth_->show(f.look.light.azimuth_deg);
  elevation_->show(f.look.light.elevation_deg);
  radius_->show(f.look.radius_mm);
  shading_->show(100 * f.look.shading);
  own_range_->setChecked(f.look.range.has_value());
  if (f.look.range) {
    range_low_->show((*f.look.range)[0]);
    range_high_->show((*f.look.range)[1]);
  }
  stereo_->setCurrentIndex(static_cast<int>(f.stereo));
  eye_->show(f.eye_angle_deg);
  comfort_->setChecked(f.limit_parallax);
  own_zero_plane_->setChecked(f.zero_plane_mm.has_value());
  if (f.zero_plane_mm) zero_plane_->show(*f.zero_plane_mm);
  swap_->setChecked(f.swap_eyes);
  transparent_->setChecked(f.transparent);
  const std::array<bool, 8> marks{f.scale_bar, f.height_bar, f.up_mark, f.window_outline,
                                  f.hatch,     f.legend,     f.letters, f.measurements};
  for (std::size_t i = 0; i < marks.size(); ++i) marks_[i]->setChecked(marks[i]);
  suggestNames();
  limit();
}

FigureRequest FigureDialog::request() const {
  FigureRequest f = project_.figure;
  f.layout = static_cast<FigureLayout>(layout_->currentIndex());
  f.recording = bytesOfPath(recording_->text());
  f.width_mm = width_->valueOr(f.width_mm);
  if (to_scale_->isChecked()) {
    f.scale_1_to = scale_->valueOr(f.scale_1_to.value_or(scale_->value()));
  } else {
    f.scale_1_to.reset();
  }
  f.dpi = dpi_->valueOr(f.dpi);
  f.text_pt = text_->valueOr(f.text_pt);
  f.look.kind = static_cast<ReliefKind>(relief_->currentIndex());
  f.look.colours = static_cast<ColourMap>(colours_->currentIndex());
  f.look.light = {azimuth_->valueOr(f.look.light.azimuth_deg),
                  elevation_->valueOr(f.look.light.elevation_deg)};
  f.look.radius_mm = radius_->valueOr(f.look.radius_mm);
  f.look.shading = shading_->valueOr(100 * f.look.shading) / 100;
  if (own_range_->isChecked()) {
    const auto before =
        f.look.range.value_or(std::array{range_low_->value(), range_high_->value()});
    f.look.range = {{range_low_->valueOr(before[0]), range_high_->valueOr(before[1])}};
  } else {
    f.look.range.reset();
  }
  f.stereo = static_cast<StereoPrint>(stereo_->currentIndex());
  if (f.stereo != project_.figure.stereo || f.layout != project_.figure.layout) {
    f.eye = FigureEye::both;  // The state of one eye's file; this is another figure.
  }
  f.eye_angle_deg = eye_->valueOr(f.eye_angle_deg);
  f.limit_parallax = comfort_->isChecked();
  if (own_zero_plane_->isChecked()) {
    f.zero_plane_mm = zero_plane_->valueOr(f.zero_plane_mm.value_or(zero_plane_->value()));
  } else {
    f.zero_plane_mm.reset();
  }
  f.swap_eyes = swap_->isChecked();
  f.transparent = transparent_->isChecked();
  const std::array<bool*, 8> marks{&f.scale_bar, &f.height_bar, &f.up_mark, &f.window_outline,
                                   &f.hatch,     &f.legend,     &f.letters, &f.measurements};
  for (std::size_t i = 0; i < marks.size(); ++i) *marks[i] = marks_[i]->isChecked();
  return f;
}

QString FigureDialog::file() const {
  return file_->text();
}

FigureFiles FigureDialog::files() const {
  FigureFiles files{
      .figure = pathOf(file()), .both_eyes = both_eyes_->isChecked(), .heights = {}, .caption = {}};
  if (heights_too_->isChecked()) files.heights = pathOf(heights_file_->text());
  if (caption_too_->isChecked()) files.caption = pathOf(caption_file_->text());
  return files;
}

/// Beside the figure and named after it, until they are given names of their own.
void FigureDialog::suggestNames() {
  const QFileInfo figure(file());
  const QString stem = figure.path() + '/' + figure.completeBaseName();
  if (!heights_file_->isModified()) heights_file_->setText(stem + QLatin1String("-heights.tif"));
  if (!caption_file_->isModified()) caption_file_->setText(stem + QLatin1String(".txt"));
}

void FigureDialog::limit() {
  const auto layout = static_cast<FigureLayout>(layout_->currentIndex());
  const bool to_scale = to_scale_->isChecked();
  setUsable(scale_, to_scale, tr("Turn on \"To scale\" first"));
  setUsable(width_, !to_scale, tr("It follows from the scale"));
  const auto usable_place = [](QLineEdit* path, bool usable, const QString& why_not) {
    setUsable(path, usable, why_not);
    auto* choose = path->parentWidget()->findChild<QPushButton*>();
    setUsable(choose, usable, why_not);
  };
  usable_place(recording_, layout == FigureLayout::plot,
               tr("Only the layout with force plots shows one"));
  usable_place(heights_file_, heights_too_->isChecked(), tr("Turn on \"Save heights too\" first"));
  usable_place(caption_file_, caption_too_->isChecked(),
               tr("Turn on \"Save caption as text\" first"));
  const bool whole = layout == FigureLayout::reference_detail || layout == FigureLayout::plot;
  setUsable(marks_[3], whole, tr("It is drawn on the whole object, which this layout lacks"));
  limitRelief();
  limitStereo();
}

void FigureDialog::limitRelief() {
  const auto kind = static_cast<ReliefKind>(relief_->currentIndex());
  const bool own_colours = showsOwnColours(kind);
  const QString stone = own_colours ? tr("Its colours are the scan's own")
                                    : tr("Stone and hillshades have no colours");
  setUsable(colours_, hasLegend(kind), stone);
  setUsable(own_range_, hasLegend(kind), stone);
  const bool own = own_range_->isChecked();
  for (QWidget* end : {range_low_, range_high_}) {
    setUsable(end, hasLegend(kind) && own,
              hasLegend(kind) ? tr("Turn on \"Own ends of the colours\" first") : stone);
  }
  const bool lamps = isLit(kind) || kind == ReliefKind::hillshade || own_colours;
  const bool four = kind == ReliefKind::multi_hillshade;
  const QString unlit = tr("No lamp shines on this relief");
  setUsable(azimuth_, lamps, four ? tr("The four lights come from all sides") : unlit);
  setUsable(elevation_, lamps || four, unlit);
  setUsable(radius_, hasRadius(kind), tr("This relief does not depend on one"));
  setUsable(shading_, own_colours, tr("Only natural colours and intensity are mixed with it"));
}

void FigureDialog::limitStereo() {
  const auto stereo = static_cast<StereoPrint>(stereo_->currentIndex());
  const bool eyes = stereo != StereoPrint::off || both_eyes_->isChecked();
  const QString one_eye = tr("Choose a kind of stereo, or both eyes as files");
  for (QWidget* widget : {static_cast<QWidget*>(eye_), static_cast<QWidget*>(comfort_),
                          static_cast<QWidget*>(swap_)}) {
    setUsable(widget, eyes, one_eye);
  }
  // What is on can be turned off: it may be what the figure is refused for.
  const bool own = own_zero_plane_->isChecked();
  setUsable(own_zero_plane_, eyes || own, one_eye);
  setUsable(zero_plane_, own, eyes ? tr("Turn on \"Own zero plane\" first") : one_eye);
  setUsable(transparent_, !isAnaglyph(stereo) || transparent_->isChecked(),
            tr("An anaglyph needs its background"));
}

/// Fields that are off show what is drawn without them, and start there when they are turned on.
void FigureDialog::showAutomatic(const FigureFacts& facts) {
  const QString unit =
      QString::fromUtf8(facts.range_unit.data(), static_cast<int>(facts.range_unit.size()));
  for (FigureNumber* end : {range_low_, range_high_}) {
    const QSignalBlocker quiet(end);
    end->setSuffix(unit == QLatin1String("mm") ? QLatin1Char(' ') + unit : unit);
  }
  if (facts.range && !own_range_->isChecked()) {
    const auto [low, high] = *facts.range;
    const double step = std::pow(10, std::floor(std::log10((high - low) / kSteps)));
    range_low_->show(rounded(low, step));
    range_high_->show(rounded(high, step));
  }
  if (!own_zero_plane_->isChecked()) zero_plane_->show(rounded(facts.zero_plane_mm, 1 / kSteps));
}

}  // namespace relievo
