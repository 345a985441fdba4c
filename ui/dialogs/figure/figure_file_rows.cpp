// SPDX-License-Identifier: BSD-3-Clause
// What is written beside the figure.
#include <QFileInfo>
#include <QLineEdit>

#include "ui/dialogs/figure/figure_form.h"
#include "ui/dialogs/figure/figure_form_parts.h"
#include "ui/dialogs/figure/figure_form_rows.h"
#include "ui/work/file_path.h"

namespace relievo {

FigureFileRows::FigureFileRows(FigureFormRows& rows) {
  both_eyes_ = rows.field<QCheckBox>(
      FigureForm::tr("Both eyes &as files"), "figure_both_eyes",
      FigureForm::tr("Also write the detail as each eye sees it, as NAME.left.png "
                     "and NAME.right.png beside the figure"));
  heights_too_ = rows.field<QCheckBox>(
      FigureForm::tr("Sa&ve heights too"), "figure_heights_on",
      FigureForm::tr("Also write the detail's heights as a picture of 16 bits; its "
                     "description says millimetres per step"));
  heights_file_ = rows.place(
      FigureForm::tr("Heights"), "figure_heights", FigureForm::tr("Ends in .tif"),
      {FigureForm::tr("Save heights"), FigureForm::tr("Heights of 16 bits (*.tif *.tiff)")});
  caption_too_ = rows.field<QCheckBox>(FigureForm::tr("Save caption as te&xt"), "figure_caption_on",
                                       FigureForm::tr("Also write the caption as a text file"));
  caption_file_ = rows.place(FigureForm::tr("Caption's file"), "figure_caption_file",
                             FigureForm::tr("Where the caption is written"),
                             {FigureForm::tr("Save caption"), FigureForm::tr("Text (*.txt)")});
}

void FigureFileRows::limit() {
  setPlaceUsable(heights_file_, heights_too_->isChecked(),
                 FigureForm::tr("Turn on \"Save heights too\" first"));
  setPlaceUsable(caption_file_, caption_too_->isChecked(),
                 FigureForm::tr("Turn on \"Save caption as text\" first"));
}

bool FigureFileRows::bothEyes() const {
  return both_eyes_->isChecked();
}

FigureFiles FigureFileRows::files(const QString& figure) const {
  FigureFiles files{
      .figure = pathOf(figure), .both_eyes = both_eyes_->isChecked(), .heights = {}, .caption = {}};
  if (heights_too_->isChecked()) files.heights = pathOf(heights_file_->text());
  if (caption_too_->isChecked()) files.caption = pathOf(caption_file_->text());
  return files;
}

void FigureFileRows::suggestNames(const QString& file) {
  const QFileInfo figure(file);
  const QString stem = figure.path() + '/' + figure.completeBaseName();
  if (!heights_file_->isModified()) heights_file_->setText(stem + QLatin1String("-heights.tif"));
  if (!caption_file_->isModified()) caption_file_->setText(stem + QLatin1String(".txt"));
}

}  // namespace relievo
