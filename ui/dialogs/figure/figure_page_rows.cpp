// SPDX-License-Identifier: BSD-3-Clause
// What stands beside what, and how large it is on paper.
#include <QLineEdit>

#include "ui/dialogs/figure/far_limit.h"
#include "ui/dialogs/figure/figure_form.h"
#include "ui/dialogs/figure/figure_form_parts.h"
#include "ui/dialogs/figure/figure_form_rows.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr std::array<const char*, 5> kLayouts{
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Detail alone"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Whole object and detail"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "As measured and filled"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Several levels"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "With force plots of a recording")};

}  // namespace

FigurePageRows::FigurePageRows(FigureFormRows& rows) {
  file_ = rows.place(
      FigureForm::tr("&File"), "figure_file", FigureForm::tr("Ends in .png, .tif, .pdf or .svg"),
      {FigureForm::tr("Save figure"), FigureForm::tr("Figures (*.png *.tif *.pdf *.svg)")});
  layout_ = rows.field<QComboBox>(FigureForm::tr("&Layout"), "figure_layout",
                                  FigureForm::tr("What stands beside what"));
  for (const char* name : kLayouts) layout_->addItem(FigureForm::tr(name));
  recording_ = rows.place(
      FigureForm::tr("&Recording"), "figure_recording",
      FigureForm::tr("File of a recording, CSV or HDF5, for the plots"),
      {FigureForm::tr("Recording"), FigureForm::tr("Recordings (*.csv *.h5 *.hdf5)"), false});
  width_ =
      rows.field<FigureNumber>(FigureForm::tr("Wi&dth on paper"), "figure_width",
                               FigureForm::tr("Journals have columns of 85 and pages of 180 mm"));
  width_->setLimits(20, 2000, 1, QStringLiteral(" mm"));
  to_scale_ = rows.field<QCheckBox>(
      FigureForm::tr("To &scale"), "figure_to_scale",
      FigureForm::tr("Choose the scale of the detail; the width follows from it"));
  scale_ =
      rows.field<FigureNumber>(FigureForm::tr("Scale &1 :"), "figure_scale",
                               FigureForm::tr("Millimetres of object on one millimetre of paper"));
  scale_->setLimits(0.001, kFarMm, 3, {});
  scale_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  scale_->setValue(1);
  dpi_ = rows.field<FigureNumber>(FigureForm::tr("D&ensity"), "figure_dpi",
                                  FigureForm::tr("Dots per inch of paper"));
  dpi_->setLimits(30, 2400, 0, FigureForm::tr(" dpi"));
  text_ = rows.field<FigureNumber>(FigureForm::tr("&Text size"), "figure_text",
                                   FigureForm::tr("Text and bars on paper, in points"));
  text_->setLimits(4, 36, 1, FigureForm::tr(" pt"));
}

void FigurePageRows::show(const FigureRequest& f) {
  layout_->setCurrentIndex(static_cast<int>(f.layout));
  recording_->setText(pathFromBytes(f.recording));
  width_->show(f.width_mm);
  to_scale_->setChecked(f.scale_1_to.has_value());
  if (f.scale_1_to) scale_->show(*f.scale_1_to);
  dpi_->show(f.dpi);
  text_->show(f.text_pt);
}

void FigurePageRows::writeTo(FigureRequest& f) const {
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
}

FigureLayout FigurePageRows::layout() const {
  return static_cast<FigureLayout>(layout_->currentIndex());
}

void FigurePageRows::limit() {
  const bool to_scale = to_scale_->isChecked();
  setUsable(scale_, to_scale, FigureForm::tr("Turn on \"To scale\" first"));
  setUsable(width_, !to_scale, FigureForm::tr("It follows from the scale"));
  setPlaceUsable(recording_, layout() == FigureLayout::plot,
                 FigureForm::tr("Only the layout with force plots shows one"));
}

}  // namespace relievo
