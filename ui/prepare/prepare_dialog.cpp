// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_dialog.h"

#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/prepare/pair_picking.h"
#include "ui/prepare/prepare_report.h"
#include "ui/prepare/prepare_rows.h"
#include "ui/prepare/prepare_views.h"
#include "ui/prepare/prepare_widgets.h"
#include "ui/prepare/scan_list.h"
#include "ui/prepare/step_list.h"
#include "ui/style/dialog_size.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"

namespace relievo {
namespace {

/// For a shell: between single quotes.
QString quoted(const QString& word) {
  return '\'' + QString(word).replace('\'', QLatin1String("'\\''")) + '\'';
}

}  // namespace

PrepareDialog::PrepareDialog(const PrepareStart& start, QWidget* parent)
    : QDialog(parent), state_({.inputs = start.inputs, .steps = {}}), runner_(state_) {
  setObjectName(QStringLiteral("prepare_dialog"));
  setWindowTitle(tr("Prepare"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  scans_ = new ScanList(state_, runner_.reads());
  steps_ = new StepList(state_, runner_);
  report_ = new PrepareReport;
  views_ = new PrepareViews(report_);
  file_ = new PreparedFileRow;
  work_ = new PrepareWorkRow;
  layOut();
  picking_ = std::make_unique<PairPicking>(state_, runner_.reads(), *scans_, *views_, *report_);
  connectLists();
  connectViews();
  connectRunner();
  connectWork();
  views_->look(start.view);
  file_->suggestBeside(QFile::decodeName(start.inputs.front().file.c_str()));
  showLists();
  work_->showBusy(false);
  if (start.scan) {
    runner_.begin(start.scan, start.sha256);
  } else {
    runner_.compute();
  }
}

PrepareDialog::~PrepareDialog() = default;

void PrepareDialog::layOut() {
  auto* left = new QWidget;
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 6, 0);
  column->addWidget(scans_, 2);
  column->addWidget(steps_, 3);
  auto* scroll = new QScrollArea;
  scroll->setWidget(left);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(left->minimumSizeHint().width() + 24);
  auto* columns = new QHBoxLayout;
  columns->addWidget(scroll, 1);
  columns->addWidget(views_, 2);
  auto* all = new QVBoxLayout(this);
  all->addLayout(columns, 1);
  all->addWidget(file_);
  all->addWidget(work_);
  resizeToText(*this, {150, 44});
}

void PrepareDialog::connectLists() {
  connect(scans_, &ScanList::changed, this, &PrepareDialog::choicesChanged);
  connect(scans_, &ScanList::chosenChanged, this, &PrepareDialog::showNumbers);
  connect(steps_, &StepList::changed, this, &PrepareDialog::choicesChanged);
  connect(steps_, &StepList::chosenChanged, this, &PrepareDialog::showChosenStep);
  connect(steps_, &StepList::outlineAsked, this, &PrepareDialog::drawOutline);
  connect(steps_, &StepList::undoAsked, this, &PrepareDialog::undo);
  connect(steps_, &StepList::redoAsked, this, &PrepareDialog::redo);
  addKeys("Ctrl+Z", this, Qt::WindowShortcut, [this] { undo(); });
  addKeys("Ctrl+Y", this, Qt::WindowShortcut, [this] { redo(); });
  addKeys("Ctrl+Shift+Z", this, Qt::WindowShortcut, [this] { redo(); });
}

void PrepareDialog::connectViews() {
  connect(views_, &PrepareViews::said, this, &PrepareDialog::said);
  connect(views_, &PrepareViews::pictureShown, this, &PrepareDialog::showOutline);
  connect(views_, &PrepareViews::looksChanged, this, [this] {
    views_->showResult(runner_.result());
    showReport();
  });
  connect(views_, &PrepareViews::toolLeft, this, [this] {
    picking_->end();
    showOutline();
  });
  connect(views_, &PrepareViews::outlineDrawn, this, [this](const CloudView::Outline& outline) {
    takeOutline(outline.view, outline.corners);
  });
  connect(picking_.get(), &PairPicking::said, this, &PrepareDialog::said);
  connect(picking_.get(), &PairPicking::began, this, &PrepareDialog::showNumbers);
  connect(picking_.get(), &PairPicking::ended, this, [this] {
    views_->showResult(runner_.result());
    views_->scan().fit();
    choicesChanged();
  });
}

void PrepareDialog::connectRunner() {
  connect(&runner_, &PrepareRunner::busyChanged, work_, &PrepareWorkRow::showBusy);
  connect(&runner_, &PrepareRunner::progressed, work_, &PrepareWorkRow::showProgress);
  connect(&runner_, &PrepareRunner::scanRead, this, &PrepareDialog::showLists);
  connect(&runner_, &PrepareRunner::scansShown, this,
          [this] { views_->showResult(runner_.result()); });
  connect(&runner_, &PrepareRunner::made, this, &PrepareDialog::showMade);
  connect(&runner_, &PrepareRunner::refused, this, &PrepareDialog::refuse);
  connect(&runner_, &PrepareRunner::writeRefused, this, [this](const QString& sentence) {
    refuse(sentence);
    work_->setCanTake(true);  // Another name may do.
  });
}

void PrepareDialog::connectWork() {
  connect(work_, &PrepareWorkRow::madeLive, this, [this] {
    if (isStale()) runner_.compute();
  });
  connect(work_, &PrepareWorkRow::computeAsked, &runner_, &PrepareRunner::compute);
  connect(work_, &PrepareWorkRow::stopAsked, this, [this] {
    take_when_made_ = false;
    runner_.stop();
  });
  connect(work_, &PrepareWorkRow::recipeAsked, this, &PrepareDialog::saveRecipe);
  connect(work_, &PrepareWorkRow::commandAsked, this, &PrepareDialog::copyCommand);
  connect(work_, &PrepareWorkRow::accepted, this, &PrepareDialog::take);
  connect(work_, &PrepareWorkRow::rejected, this, &QDialog::reject);
}

bool PrepareDialog::isBusy() const {
  return runner_.isBusy() || views_->isBusy();
}

void PrepareDialog::choicesChanged() {
  runner_.noteChange();
  recipe_file_.clear();
  work_->setStale(true);
  showLists();
  if (picking_->isOn()) return;  // After all pairs are picked.
  if (work_->isLive()) runner_.computeSoon();
}

void PrepareDialog::undo() {
  if (picking_->isOn() || !state_.undo()) return;
  choicesChanged();
  Q_EMIT said(tr("Undone"));
}

void PrepareDialog::redo() {
  if (picking_->isOn() || !state_.redo()) return;
  choicesChanged();
  Q_EMIT said(tr("Redone"));
}

void PrepareDialog::showLists() {
  scans_->showInputs();
  steps_->showSteps();
  steps_->showForm();
  showNumbers();
  showReport();
  showOutline();
}

// What the work gave, beside what it was given for; nothing beside what is newer.
void PrepareDialog::showNumbers() {
  steps_->showResults();
  scans_->showPoses();
  work_->setCanSave(runner_.fitsChoices() && !isStale(), !recipe_file_.isEmpty());
}

void PrepareDialog::showReport() {
  if (picking_->isOn()) return;  // It says what to pick.
  if (const PrepareResult* const shown = result()) {
    report_->showResult(*shown, state_.foundAlign(), views_->colour(), runner_.reads());
  } else {
    report_->clear();
  }
}

void PrepareDialog::showChosenStep() {
  const auto* const box = steps_->chosenAs<CropBox>();
  views_->scan().setBox(box == nullptr ? std::nullopt
                                       : std::optional(CloudBox{box->min, box->max, box->axes}));
  showOutline();
}

void PrepareDialog::showOutline() {
  const auto* const outline = picking_->isOn() ? nullptr : steps_->chosenAs<CropOutline>();
  if (outline == nullptr || outline->outline.empty()) {
    views_->scan().setOutline(std::nullopt);
  } else {
    views_->scan().setOutline(CloudView::Outline{outline->view, outline->outline});
  }
}

void PrepareDialog::drawOutline() {
  if (picking_->isOn()) return;
  views_->scan().setTool(CloudView::Tool::outline);
  views_->scan().setFocus();
  Q_EMIT said(tr("Arrow keys carry the cross, Enter sets a corner, Ctrl+Enter closes the outline"));
  report_->showAdvice(
      tr("Drag the mouse round what is meant, or set corners with Enter; Ctrl+Enter closes."));
}

void PrepareDialog::takeOutline(const Rotation& view,
                                const std::vector<std::array<double, 2>>& corners) {
  views_->scan().setTool(CloudView::Tool::turn);
  if (steps_->chosenAs<CropOutline>() == nullptr) return;
  PrepareChoices next = state_.now();
  auto& step = std::get<CropOutline>(next.steps[*steps_->chosen()].step);
  step.view = view;
  step.outline = corners;
  state_.change(std::move(next));
  choicesChanged();
}

void PrepareDialog::refuse(const QString& sentence) {
  report_->showProblem(sentence);
  work_->setCanTake(sentence.isEmpty());
  if (sentence.isEmpty()) return;
  take_when_made_ = false;
  Q_EMIT said(sentence);
}

void PrepareDialog::showMade() {
  refuse({});
  if (!isStale()) work_->setStale(false);
  showNumbers();
  showReport();
  views_->showResult(runner_.result());
  picking_->show();
  Q_EMIT said(report_->total());
  if (take_when_made_) take();
}

void PrepareDialog::done(int result) {
  views_->cancel();
  runner_.outliveJob(*this);
  QDialog::done(result);
}

// What is on show is written; if the choices are newer than that, after they were computed.
void PrepareDialog::take() {
  picking_->end();
  if (isStale()) {
    take_when_made_ = true;
    if (!runner_.isBusy() || runner_.isWaiting()) runner_.compute();
    return;
  }
  take_when_made_ = false;
  const QString file = file_->file();
  runner_.write([result = runner_.result(),
                 file](const Task& task) { writePrepared(*result, pathOf(file), task); },
                [this, file] {
                  Q_EMIT prepared(file);
                  accept();
                });
}

void PrepareDialog::saveRecipe() {
  if (isStale()) return;
  const QFileInfo output(file_->file());
  auto* dialog =
      new QFileDialog(this, tr("Save recipe"), output.absolutePath(), tr("Recipes (*.json)"));
  dialog->setObjectName(QStringLiteral("recipe_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("json"));
  dialog->selectFile(output.completeBaseName() + QLatin1String(".json"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    runner_.write([result = runner_.result(),
                   file](const Task& task) { writeRecipe(*result, pathOf(file), task); },
                  [this, file] {
                    recipe_file_ = file;
                    showNumbers();
                    Q_EMIT said(tr("%1 is saved").arg(shownName(file)));
                  });
  });
  dialog->open();
}

void PrepareDialog::copyCommand() {
  if (recipe_file_.isEmpty()) return;
  QGuiApplication::clipboard()->setText(QStringLiteral("relievo prepare --recipe %1 -o %2")
                                            .arg(quoted(recipe_file_), quoted(file_->file())));
  Q_EMIT said(tr("The command is in the clipboard"));
}

}  // namespace relievo
