// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/step_list.h"

#include <algorithm>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/prepare/crop.h"
#include "ui/prepare/prepare_runner.h"
#include "ui/prepare/prepare_widgets.h"
#include "ui/prepare/step_form.h"
#include "ui/prepare/step_words.h"

namespace relievo {
namespace {

QString nameOfAction(const std::vector<Step>& steps) {
  const auto* const base = std::get_if<Base>(&steps.front());
  return QLatin1String("add_") + QString::fromLatin1(kindOf(steps.front()).data()) +
         (steps.size() > 1 ? "_all" : "") + (base != nullptr && base->lay ? "_lay" : "");
}

}  // namespace

StepList::StepList(PrepareState& state, const PrepareRunner& runner)
    : QGroupBox(tr("Steps")), state_(state), runner_(runner) {
  steps_ = prepareList(tr("Steps"), "prepare_steps", {tr("Step"), tr("Points")});
  add_ = prepareButton(tr("Add s&tep"), "prepare_add_step", tr("Choose what is done next"));
  add_->setMenu(new QMenu(add_));
  add_->menu()->setToolTipsVisible(true);
  remove_ =
      prepareButton(tr("Remove"), "prepare_remove_step", tr("Leave the chosen step out (Delete)"));
  remove_->setAccessibleName(tr("Remove step"));
  up_ = prepareButton(tr("Earlier"), "prepare_step_up", tr("Do the chosen step earlier (Ctrl+Up)"));
  down_ =
      prepareButton(tr("Later"), "prepare_step_down", tr("Do the chosen step later (Ctrl+Down)"));
  undo_ = prepareButton(tr("&Undo"), "prepare_undo", tr("Undo the last change (Ctrl+Z)"));
  redo_ = prepareButton(tr("R&edo"), "prepare_redo", tr("Redo it (Ctrl+Y)"));
  form_ = new StepForm;
  layOut();
  connectButtons();
}

void StepList::layOut() {
  auto* column = new QVBoxLayout(this);
  column->addWidget(steps_, 1);
  column->addLayout(rowOf({add_, remove_}));
  column->addLayout(rowOf({up_, down_, undo_, redo_}));
  column->addWidget(form_);
}

void StepList::connectButtons() {
  connect(add_->menu(), &QMenu::aboutToShow, this, &StepList::makeMenu);
  connect(steps_, &QTreeWidget::itemChanged, this, &StepList::useItem);
  connect(steps_, &QTreeWidget::currentItemChanged, this, &StepList::showForm);
  connect(remove_, &QPushButton::clicked, this, &StepList::removeChosen);
  connect(up_, &QPushButton::clicked, this, [this] { shiftChosen(-1); });
  connect(down_, &QPushButton::clicked, this, [this] { shiftChosen(1); });
  connect(undo_, &QPushButton::clicked, this, &StepList::undoAsked);
  connect(redo_, &QPushButton::clicked, this, &StepList::redoAsked);
  addKeys("Del", steps_, Qt::WidgetShortcut, [this] { removeChosen(); });
  addKeys("Ctrl+Up", steps_, Qt::WidgetShortcut, [this] { shiftChosen(-1); });
  addKeys("Ctrl+Down", steps_, Qt::WidgetShortcut, [this] { shiftChosen(1); });
  connect(form_, &StepForm::changed, this, &StepList::changeChosen);
  connect(form_, &StepForm::outlineAsked, this, &StepList::outlineAsked);
}

std::optional<std::size_t> StepList::chosen() const {
  const int row = chosenRow(*steps_);
  if (row < 0 || row >= static_cast<int>(state_.now().steps.size())) return std::nullopt;
  return static_cast<std::size_t>(row);
}

void StepList::showSteps() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  const auto& steps = state_.now().steps;
  const int chosen = chosenRow(*steps_);
  setRowCount(*steps_, steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    QTreeWidgetItem* item = steps_->topLevelItem(static_cast<int>(i));
    item->setText(0, wordsOfStep(steps[i].step));
    item->setToolTip(0, wordsOfStep(steps[i].step));
    item->setCheckState(0, steps[i].on ? Qt::Checked : Qt::Unchecked);
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  }
  if (chosen >= 0 && steps_->topLevelItemCount() > 0) {
    steps_->setCurrentItem(steps_->topLevelItem(std::min(chosen, steps_->topLevelItemCount() - 1)));
  }
}

void StepList::showForm() {
  const auto step = chosen();
  form_->show(step ? &state_.now().steps[*step].step : nullptr);
  remove_->setEnabled(step.has_value() && chosenAs<Align>() == nullptr);
  up_->setEnabled(step && *step > 0);
  down_->setEnabled(step && *step + 1 < state_.now().steps.size());
  Q_EMIT chosenChanged();
}

void StepList::showResults() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  for (int i = 0; i < steps_->topLevelItemCount(); ++i) steps_->topLevelItem(i)->setText(1, {});
  if (runner_.fitsChoices()) {
    const std::vector<std::size_t> places = state_.stepsInRecipe();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const StepResult& made = runner_.result()->prepared.answer.steps[i];
      const auto gone = static_cast<qulonglong>(made.before - made.after);
      steps_->topLevelItem(static_cast<int>(places[i]))
          ->setText(1, !made.done  ? tr("not done")
                       : gone == 0 ? QStringLiteral("0")
                                   : QStringLiteral("\u2212%1").arg(QLocale().toString(gone)));
    }
  }
  undo_->setEnabled(state_.canUndo());
  redo_->setEnabled(state_.canRedo());
}

void StepList::makeMenu() {
  QMenu* menu = add_->menu();
  menu->clear();
  const PrepareInput& reference = state_.now().inputs[state_.reference()];
  const ReadScan* const first = runner_.reads().find(reference);
  const LengthUnit unit = runner_.reads().unitOf(reference);
  const double spacing = first != nullptr ? first->spacing : 1;
  for (const OfferedStep& offered : offeredSteps(boxLeft(), unit, spacing)) {
    QAction* action = menu->addAction(offered.text);
    action->setObjectName(nameOfAction(offered.steps));
    connect(action, &QAction::triggered, this, [this, steps = offered.steps] { addSteps(steps); });
  }
}

/// Around what stays as far as it is known, else around the scans.
FileBounds StepList::boxLeft() const {
  const auto& result = runner_.result();
  if (result && result->prepared.scan.info.bounds) return *result->prepared.scan.info.bounds;
  const ReadScan* const read = runner_.reads().find(state_.now().inputs[state_.reference()]);
  if (read != nullptr && read->scan->info.bounds) return *read->scan->info.bounds;
  return {};
}

void StepList::addSteps(const std::vector<Step>& steps) {
  std::size_t at = 0;
  for (const Step& step : steps) at = state_.addStep(step);
  Q_EMIT changed();
  steps_->setCurrentItem(steps_->topLevelItem(static_cast<int>(at)));
  if (std::holds_alternative<CropOutline>(steps.front())) Q_EMIT outlineAsked();
}

void StepList::removeChosen() {
  const auto step = chosen();
  if (!step || chosenAs<Align>() != nullptr) return;
  state_.removeStep(*step);
  Q_EMIT changed();
}

void StepList::shiftChosen(int by) {
  const auto step = chosen();
  if (!step || !state_.moveStep(*step, by)) return;
  Q_EMIT changed();
  steps_->setCurrentItem(steps_->topLevelItem(static_cast<int>(*step) + by));
}

void StepList::useItem(QTreeWidgetItem* item) {
  if (filling_) return;
  PrepareChoices next = state_.now();
  const int row = steps_->indexOfTopLevelItem(item);
  next.steps[static_cast<std::size_t>(row)].on = item->checkState(0) == Qt::Checked;
  state_.change(std::move(next));
  Q_EMIT changed();
}

void StepList::changeChosen(const Step& step) {
  const auto at = chosen();
  if (!at) return;
  PrepareChoices next = state_.now();
  next.steps[*at].step = step;
  // A field that is changed again and again is one step of the history.
  state_.change(std::move(next), 1 + static_cast<int>(*at));
  Q_EMIT changed();
}

}  // namespace relievo
