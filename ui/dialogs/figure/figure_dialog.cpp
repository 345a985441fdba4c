// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/figure/figure_dialog.h"

#include <algorithm>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/dialogs/figure/figure_error.h"
#include "ui/dialogs/figure/figure_form.h"
#include "ui/dialogs/figure/figure_preview.h"
#include "ui/language/core_text.h"
#include "ui/style/dialog_size.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr int kDelayMs = 300;
constexpr int kLeastPreviewPx = 900;
constexpr int kMostPreviewPx = 4000;
constexpr int kMargin = 8;

}  // namespace

FigureDialog::FigureDialog(std::shared_ptr<const Surface> surface, Project project,
                           const QString& file, QWidget* parent)
    : QDialog(parent),
      surface_(std::move(surface)),
      project_(std::move(project)),
      own_folder_(QFileInfo(file).absolutePath()),
      form_(new FigureForm(*surface_, project_, file, this)),
      delay_(new QTimer(this)) {
  setObjectName(QStringLiteral("figure_dialog"));
  setWindowTitle(tr("Figure"));
  auto* both = new QWidget;
  auto* columns = new QHBoxLayout(both);
  columns->setContentsMargins({});
  columns->addWidget(formColumn(), 0);
  columns->addLayout(previewColumn(), 1);
  // On a small screen with large text not even the columns' least widths have room.
  auto* scrolled = new QScrollArea;
  scrolled->setFocusPolicy(Qt::NoFocus);  // What stands in it has the keyboard.
  scrolled->setWidget(both);
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  auto* all = new QVBoxLayout(this);
  all->addWidget(scrolled, 1);
  all->addLayout(buttonRow());
  resizeToText(*this, {142, 37});
  delay_->setSingleShot(true);
  delay_->setInterval(kDelayMs);
  connect(delay_, &QTimer::timeout, this, &FigureDialog::preview);
  connect(form_, &FigureForm::changed, this, &FigureDialog::changed);
  connect(picture_, &FigurePreview::resized, this, &FigureDialog::previewLarger);
  connect(&worker_, &LatestWorker::busyChanged, this, &FigureDialog::showBusy);
  showBusy(false);
  for (const QLineEdit* field : form_->findChildren<QLineEdit*>()) {
    connect(field, &QLineEdit::textEdited, this, [this] {
      if (!refusal_.isEmpty()) showRefusal({});  // Another try.
    });
  }
  // Who types a name types all of it.
  form_->findChild<QLineEdit*>(QStringLiteral("figure_file"))->selectAll();
  preview();
}

FigureDialog::~FigureDialog() {
  worker_.disconnect();
}

QWidget* FigureDialog::formColumn() {
  QWidget* form = form_;
  auto* column = new QScrollArea;
  column->setFocusPolicy(Qt::NoFocus);  // What stands in it has the keyboard.
  column->setWidget(form);
  column->setWidgetResizable(true);
  column->setFrameShape(QFrame::NoFrame);
  column->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // Also when a letter, not Tab, led there.
  connect(qApp, &QApplication::focusChanged, column, [form, column](QWidget*, QWidget* now) {
    if (now != nullptr && form->isAncestorOf(now)) column->ensureWidgetVisible(now);
  });
  for (QCheckBox* box : form->findChildren<QCheckBox*>()) {
    connect(box, &QCheckBox::clicked, column, [box, column] { column->ensureWidgetVisible(box); });
  }
  // Names beside their fields, unless the screen is too narrow for them.
  const int least = form->minimumSizeHint().width();
  const int most = std::max(least, screen()->availableSize().width() * 2 / 5);
  column->setMinimumWidth(std::clamp(form->sizeHint().width(), least, most) +
                          column->verticalScrollBar()->sizeHint().width() + kMargin);
  return column;
}

QVBoxLayout* FigureDialog::previewColumn() {
  picture_ = new FigurePreview;
  picture_->setObjectName(QStringLiteral("figure_preview"));
  picture_->setAccessibleName(tr("Preview of the figure"));
  facts_ = new QLabel;
  facts_->setObjectName(QStringLiteral("figure_facts"));
  facts_->setAccessibleName(tr("Size"));
  problem_ = new QLabel;
  problem_->setObjectName(QStringLiteral("figure_problem"));
  problem_->setAccessibleName(tr("Problem"));
  problem_->hide();
  for (QLabel* label : {facts_, problem_}) label->setWordWrap(true);
  caption_ = new QPlainTextEdit;
  caption_->setObjectName(QStringLiteral("figure_caption"));
  caption_->setAccessibleName(tr("Caption"));
  caption_->setToolTip(tr("The text that belongs under this figure"));
  caption_->setReadOnly(true);
  caption_->setTabChangesFocus(true);
  caption_->setMaximumHeight(6 * fontMetrics().height());
  auto* copy = new QPushButton(tr("Cop&y caption"));
  copy->setObjectName(QStringLiteral("figure_copy"));
  copy->setAccessibleName(tr("Copy caption"));
  copy->setToolTip(tr("Put the caption into the clipboard"));
  copy->setAutoDefault(false);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(caption_->toPlainText()); });
  auto* column = new QVBoxLayout;
  column->addWidget(picture_, 1);
  column->addWidget(facts_);
  column->addWidget(problem_);
  auto* caption_row = new QHBoxLayout;
  caption_row->addWidget(caption_, 1);
  caption_row->addWidget(copy, 0, Qt::AlignTop);
  column->addLayout(caption_row);
  return column;
}

QHBoxLayout* FigureDialog::buttonRow() {
  bar_ = new QProgressBar;
  bar_->setRange(0, 0);
  bar_->setAccessibleName(tr("Progress"));
  stop_ = new QPushButton(tr("Sto&p"));
  stop_->setObjectName(QStringLiteral("figure_stop"));
  stop_->setAccessibleName(tr("Stop"));
  stop_->setToolTip(tr("Stop the work; no further file is written"));
  stop_->setAutoDefault(false);
  connect(stop_, &QPushButton::clicked, this, &FigureDialog::stop);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Close);
  nameButtons(*buttons);
  save_ = buttons->button(QDialogButtonBox::Save);
  save_->setObjectName(QStringLiteral("figure_save"));
  connect(save_, &QPushButton::clicked, this, &FigureDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* row = new QHBoxLayout;
  row->addWidget(bar_, 1);
  row->addWidget(stop_);
  row->addStretch(1);
  row->addWidget(buttons);
  return row;
}

Project FigureDialog::wanted() const {
  Project project = project_;
  project.figure = request();
  return project;
}

FigureRequest FigureDialog::request() const {
  return form_->request();
}

FigureFiles FigureDialog::files() const {
  return form_->files();
}

QString FigureDialog::file() const {
  return form_->file();
}

void FigureDialog::changed() {
  refusal_.clear();
  Q_EMIT requestChanged(request());
  delay_->start();
}

void FigureDialog::preview() {
  if (writing_) return;
  struct Drawn {
    Figure figure;
    QString error;
  };
  const auto drawn = std::make_shared<Drawn>();
  preview_px_ = std::clamp(picture_->longestPx(), kLeastPreviewPx, kMostPreviewPx);
  worker_.start(
      [drawn, surface = surface_, project = wanted(), px = preview_px_](const Task& task) {
        drawn->error = errorOf([&] { drawn->figure = previewFigure(*surface, project, px, task); });
      },
      [this, drawn] {
        showProblem(drawn->error.isEmpty() ? refusal_ : drawn->error);
        save_->setEnabled(drawn->error.isEmpty());
        const RgbaImage& image = drawn->figure.image;
        if (image.rgba.empty()) return;
        picture_->setPicture(QImage(image.rgba.data(), image.width, image.height, 4 * image.width,
                                    QImage::Format_RGBA8888_Premultiplied)
                                 .copy());
        showFacts(drawn->figure.facts);
      });
}

// What was drawn for a smaller place would be blurred in a larger one.
void FigureDialog::previewLarger() {
  const int wanted_px = std::min(picture_->longestPx(), kMostPreviewPx);
  if (preview_px_ > 0 && wanted_px > preview_px_) delay_->start();
}

void FigureDialog::showFacts(const FigureFacts& facts) {
  QString text = tr("%1 \u00d7 %2 mm on paper, %3 \u00d7 %4 pixels, scale 1 : %5")
                     .arg(numberText(facts.width_mm, 1), numberText(facts.height_mm, 1))
                     .arg(facts.width_px)
                     .arg(facts.height_px)
                     .arg(numberText(1 / facts.paper_per_mm, 3));
  if (facts.eye_angle_deg > 0) {
    text += tr(". Parallax %1\u00b0 of %2\u00b0 with %3\u00b0 between the eyes")
                .arg(numberText(facts.parallax_deg, 2), numberText(kComfortDeg, 1),
                     numberText(facts.eye_angle_deg, 1));
  }
  facts_->setText(text + '.');
  caption_->setPlainText(QString::fromStdString(facts.caption));
  form_->showAutomatic(facts);
}

void FigureDialog::showProblem(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
}

void FigureDialog::showRefusal(const QString& why) {
  refusal_ = why;
  showProblem(why);
  if (!why.isEmpty()) Q_EMIT refused(why);
}

void FigureDialog::done(int result) {
  worker_.outliveJob(*this);
  QDialog::done(result);
}

void FigureDialog::showBusy(bool busy) {
  if (!busy) writing_ = false;
  bar_->setVisible(busy);
  stop_->setVisible(busy);
}

}  // namespace relievo
