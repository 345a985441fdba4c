// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/figure/figure_form.h"

#include <QFormLayout>
#include <QLineEdit>

#include "ui/dialogs/figure/figure_form_parts.h"
#include "ui/dialogs/figure/figure_form_rows.h"
#include "ui/work/file_names.h"

namespace relievo {

FigureForm::FigureForm(const Surface& surface, const Project& project, const QString& file,
                       QWidget* dialog)
    : first_(project.figure) {
  auto* layout = new QFormLayout(this);
  layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
  FigureFormRows rows(layout, dialog, pathFromBytes(project.file), [this] { takeChange(); });
  page_ = std::make_unique<FigurePageRows>(rows);
  relief_ = std::make_unique<FigureReliefRows>(rows, surface);
  stereo_ = std::make_unique<FigureStereoRows>(rows);
  marks_ = std::make_unique<FigureMarkRows>(rows);
  files_ = std::make_unique<FigureFileRows>(rows);
  connect(page_->file(), &QLineEdit::textChanged, this,
          [this](const QString& name) { files_->suggestNames(name); });
  page_->file()->setText(file);
  show(first_);
  complete_ = true;
}

FigureForm::~FigureForm() = default;

void FigureForm::show(const FigureRequest& request) {
  page_->show(request);
  relief_->show(request);
  stereo_->show(request);
  marks_->show(request);
  files_->suggestNames(file());
  limit();
}

FigureRequest FigureForm::request() const {
  FigureRequest request = first_;
  page_->writeTo(request);
  relief_->writeTo(request);
  stereo_->writeTo(request);
  marks_->writeTo(request);
  if (request.stereo != first_.stereo || request.layout != first_.layout) {
    request.eye = FigureEye::both;  // The state of one eye's file; this is another figure.
  }
  return request;
}

FigureFiles FigureForm::files() const {
  return files_->files(file());
}

QString FigureForm::file() const {
  return page_->file()->text();
}

void FigureForm::showAutomatic(const FigureFacts& facts) {
  relief_->showAutomatic(facts);
  stereo_->showAutomatic(facts);
}

void FigureForm::takeChange() {
  if (!complete_) return;
  limit();
  Q_EMIT changed();
}

void FigureForm::limit() {
  page_->limit();
  files_->limit();
  marks_->limit(page_->layout(), stereo_->stereo());
  relief_->limit();
  stereo_->limit(files_->bothEyes());
}

}  // namespace relievo
