// SPDX-License-Identifier: BSD-3-Clause
// The lists of the dialog Prepare, and what is said beside them.
#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>

#include "core/prepare/crop.h"
#include "ui/message/message_text.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/prepare/step_form.h"
#include "ui/prepare/step_words.h"
#include "ui/style/text.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

QString count(std::uint64_t number) {
  return QLocale().toString(static_cast<qulonglong>(number));
}

QString loopWords(const AlignLoop& loop) {
  QStringList scans;
  for (const std::uint32_t scan : loop.scans) scans << QString::number(scan + 1);
  return PrepareDialog::tr("The chain of scans %1 misses its beginning by %2 mm.")
      .arg(scans.join(QStringLiteral(", ")), numberText(loop.mm, 3));
}

}  // namespace

QString PrepareDialog::nameOf(const PrepareInput& input) const {
  const QString file = shownName(QFile::decodeName(input.file.c_str()));
  if (input.read.parts.size() != 1) return file;
  const ReadScan* const read = readOf(input);
  const bool named = read != nullptr && read->scan->info.parts.size() == 1 &&
                     !read->scan->info.parts[0].name.empty();
  return QStringLiteral("%1 / %2").arg(
      file, named ? QString::fromStdString(read->scan->info.parts[0].name)
                  : QString::number(input.read.parts[0]));
}

void PrepareDialog::showLists() {
  showScans();
  showSteps();
  showForm();
  showNumbers();
  showWords();
  showOutline();
}

std::size_t PrepareDialog::chosenScan() const {
  const int row = scans_->indexOfTopLevelItem(scans_->currentItem());
  return row < 0 ? 0 : static_cast<std::size_t>(row);
}

std::optional<std::size_t> PrepareDialog::chosenStep() const {
  const int row = steps_->indexOfTopLevelItem(steps_->currentItem());
  if (row < 0 || row >= static_cast<int>(state_.now().steps.size())) return std::nullopt;
  return static_cast<std::size_t>(row);
}

void PrepareDialog::showScans() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  const auto& inputs = state_.now().inputs;
  const int chosen = static_cast<int>(chosenScan());
  while (scans_->topLevelItemCount() > static_cast<int>(inputs.size())) {
    delete scans_->takeTopLevelItem(scans_->topLevelItemCount() - 1);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (scans_->topLevelItemCount() <= static_cast<int>(i)) new QTreeWidgetItem(scans_);
    QTreeWidgetItem* item = scans_->topLevelItem(static_cast<int>(i));
    item->setText(0, tr("%1 %2", "number, scan").arg(i + 1).arg(nameOf(inputs[i])));
    item->setToolTip(0, QFile::decodeName(inputs[i].file.c_str()));
    item->setCheckState(0, inputs[i].used ? Qt::Checked : Qt::Unchecked);
    const auto c = colourOfScan(i);
    QPixmap patch(12, 12);
    patch.fill(QColor(c[0], c[1], c[2]));
    item->setIcon(0, inputs.size() > 1 ? QIcon(patch) : QIcon());
  }
  scans_->setCurrentItem(scans_->topLevelItem(std::min(chosen, scans_->topLevelItemCount() - 1)));
}

void PrepareDialog::showSteps() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  const auto& steps = state_.now().steps;
  const int chosen = steps_->indexOfTopLevelItem(steps_->currentItem());
  while (steps_->topLevelItemCount() > static_cast<int>(steps.size())) {
    delete steps_->takeTopLevelItem(steps_->topLevelItemCount() - 1);
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps_->topLevelItemCount() <= static_cast<int>(i)) new QTreeWidgetItem(steps_);
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

void PrepareDialog::showForm() {
  const auto step = chosenStep();
  form_->show(step ? &state_.now().steps[*step].step : nullptr);
  const bool is_align = step && std::holds_alternative<Align>(state_.now().steps[*step].step);
  remove_step_->setEnabled(step.has_value() && !is_align);
  up_->setEnabled(step && *step > 0);
  down_->setEnabled(step && *step + 1 < state_.now().steps.size());
  const auto* const box = step ? std::get_if<CropBox>(&state_.now().steps[*step].step) : nullptr;
  view_->setBox(box == nullptr ? std::nullopt
                               : std::optional(CloudBox{box->min, box->max, box->axes}));
  showOutline();
}

// What the work gave, beside what it was given for; nothing beside what is newer.
void PrepareDialog::showNumbers() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  const bool fits =
      result_ && result_->recipe.steps.size() == result_->prepared.answer.steps.size();
  const bool same = fits && result_->choices == state_.now();
  for (int i = 0; i < steps_->topLevelItemCount(); ++i) steps_->topLevelItem(i)->setText(1, {});
  if (same) {
    const std::vector<std::size_t> places = state_.stepsInRecipe();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const StepResult& made = result_->prepared.answer.steps[i];
      steps_->topLevelItem(static_cast<int>(places[i]))
          ->setText(1, !made.done ? tr("not done")
                       : made.before == made.after
                           ? QStringLiteral("0")
                           : QStringLiteral("\u2212%1").arg(count(made.before - made.after)));
    }
  }
  const auto at = state_.alignStep();
  const bool several = state_.now().inputs.size() > 1;
  const std::size_t reference = state_.reference();
  const AlignAnswer* const found = state_.foundAlign();
  const std::vector<std::size_t> used = state_.usedInputs();
  for (int i = 0; i < scans_->topLevelItemCount(); ++i) {
    const auto input = static_cast<std::size_t>(i);
    const auto place = std::find(used.begin(), used.end(), input);
    QString text;
    if (several && input == reference) {
      text = tr("reference");
    } else if (several && place != used.end() && found != nullptr) {
      const auto& verdict = found->scans[static_cast<std::size_t>(place - used.begin())];
      text = tr("%1 mm").arg(numberText(verdict.rms_mm, 3));
    } else if (several && place != used.end() && at &&
               std::get<Align>(state_.now().steps[*at].step).method == AlignMethod::stored) {
      text = tr("as stored");
    } else if (several && place != used.end()) {
      text = tr("not yet");
    }
    scans_->topLevelItem(i)->setText(1, text);
  }
  showScanButtons();
  undo_->setEnabled(state_.canUndo());
  redo_->setEnabled(state_.canRedo());
  save_recipe_->setEnabled(same && !stale_);
  copy_command_->setEnabled(!recipe_file_.isEmpty());
}

void PrepareDialog::showScanButtons() {
  const PrepareInput& input = state_.now().inputs[chosenScan()];
  const ReadScan* const read = readOf(input);
  const bool several = state_.now().inputs.size() > 1;
  const bool can_align = several && state_.alignStep() && chosenScan() != state_.reference();
  remove_scan_->setEnabled(several && !pick_);
  add_scan_->setEnabled(!pick_);
  make_reference_->setEnabled(can_align && !pick_);
  make_reference_->setVisible(several);
  pick_button_->setVisible(several);
  pick_button_->setEnabled(can_align || pick_);
  pick_button_->setText(pick_ ? tr("Pairs are pic&ked") : tr("Pic&k pairs\u2026"));
  pick_button_->setAccessibleName(pick_ ? tr("Pairs are picked") : tr("Pick pairs"));
  for (QWidget* part : {static_cast<QWidget*>(take_back_), static_cast<QWidget*>(pairs_),
                        static_cast<QWidget*>(remove_pair_)}) {
    part->setVisible(pick_.has_value());
  }
  split_->setVisible(!pick_ && read != nullptr && read->scan->info.parts.size() > 1);
  withheld_->setVisible(input.read.keep_withheld ||
                        (read != nullptr && read->scan->info.withheld > 0));
  withheld_->setEnabled(!pick_);
  withheld_->setChecked(input.read.keep_withheld);
}

/// What is said of where the scans lie.
QStringList PrepareDialog::alignWords() const {
  QStringList lines;
  const auto& prepared = result_->prepared;
  const AlignAnswer* const found = state_.foundAlign();
  const AlignAnswer* const answer =
      found != nullptr ? found : (prepared.answer.align ? &*prepared.answer.align : nullptr);
  if (answer == nullptr || answer->scans.size() != result_->used.size()) return lines;
  for (std::size_t i = 0; i < answer->scans.size(); ++i) {
    const AlignVerdict& verdict = answer->scans[i];
    if (verdict.words.empty()) continue;
    QString text = messageText(verdict.words);
    if (verdict.rms_mm > 0 && verdict.holds) {
      text += ' ' + tr("%1 % of its points lie within one spacing.")
                        .arg(numberText(100 * verdict.tight_share, 0));
      if (verdict.uncertainty_mm > 0) {
        text += ' ' + tr("It may be off by %1 mm.").arg(numberText(verdict.uncertainty_mm, 3));
      }
    }
    lines
        << tr("%1: %2", "scan, words").arg(nameOf(result_->choices.inputs[result_->used[i]]), text);
  }
  for (const AlignLoop& loop : answer->loops) lines << loopWords(loop);
  return lines;
}

void PrepareDialog::showWords() {
  if (pick_) return;  // It says what to pick.
  if (!result_) {
    total_->clear();
    words_->clear();
    return;
  }
  std::uint64_t before = 0, shown = 0;
  for (const auto& scan : result_->scans) {
    before += scan->scan->points.size();
    shown += scan->shown.size();
  }
  const auto& prepared = result_->prepared;
  const bool made = !prepared.scan.points.empty();
  total_->setText(
      made ? tr("%1 of %2 points stay.").arg(count(prepared.scan.points.size()), count(before))
           : tr("%1 points.").arg(count(before)));
  QStringList lines;
  if (shown < before) lines << tr("%1 of them are drawn.").arg(count(shown));
  if (static_cast<CloudColour>(colour_->currentIndex()) == CloudColour::distance) {
    lines << tr(
        "Blue lies on the surface of the other scans, red three spacings from it; grey: no "
        "other scan is near.");
  }
  lines << alignWords();
  for (const StepResult& step : prepared.answer.steps) {
    if (!step.notes.empty()) lines << messageText(step.notes);
  }
  for (const auto& scan : result_->scans) {
    if (scan->scan->info.withheld > 0) {
      lines << tr("%1 points that the file marks as withheld are left out.")
                   .arg(count(scan->scan->info.withheld));
    }
  }
  words_->setText(lines.join('\n'));
}

void PrepareDialog::scanItemChanged(QTreeWidgetItem* item) {
  if (filling_) return;
  PrepareChoices next = state_.now();
  const int row = scans_->indexOfTopLevelItem(item);
  next.inputs[static_cast<std::size_t>(row)].used = item->checkState(0) == Qt::Checked;
  state_.change(std::move(next));
  choicesChanged();
}

void PrepareDialog::stepItemChanged(QTreeWidgetItem* item) {
  if (filling_) return;
  PrepareChoices next = state_.now();
  const int row = steps_->indexOfTopLevelItem(item);
  next.steps[static_cast<std::size_t>(row)].on = item->checkState(0) == Qt::Checked;
  state_.change(std::move(next));
  choicesChanged();
}

void PrepareDialog::addScans() {
  auto* dialog = new QFileDialog(this, tr("Add scans"));
  dialog->setObjectName(QStringLiteral("add_scans_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  dialog->setDirectory(
      QFileInfo(QFile::decodeName(state_.now().inputs.back().file.c_str())).absolutePath());
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    std::vector<PrepareInput> inputs;
    for (const QString& file : files) {
      PrepareInput input;
      input.file = QFile::encodeName(QFileInfo(file).absoluteFilePath()).toStdString();
      input.unit = state_.now().inputs.front().unit;
      inputs.push_back(input);
    }
    state_.addInputs(inputs);
    choicesChanged();
  });
  dialog->open();
}

void PrepareDialog::addSteps(const std::vector<Step>& steps) {
  std::size_t at = 0;
  for (const Step& step : steps) at = state_.addStep(step);
  choicesChanged();
  steps_->setCurrentItem(steps_->topLevelItem(static_cast<int>(at)));
  if (std::holds_alternative<CropOutline>(steps.front())) drawOutline();
}

void PrepareDialog::undo() {
  if (pick_ || !state_.undo()) return;
  choicesChanged();
  Q_EMIT said(tr("Undone"));
}

void PrepareDialog::redo() {
  if (pick_ || !state_.redo()) return;
  choicesChanged();
  Q_EMIT said(tr("Redone"));
}

/// Around what stays as far as it is known, else around the scans.
FileBounds PrepareDialog::boxLeft() const {
  if (result_ && result_->prepared.scan.info.bounds) return *result_->prepared.scan.info.bounds;
  const ReadScan* const read = readOf(state_.now().inputs[state_.reference()]);
  if (read != nullptr && read->scan->info.bounds) return *read->scan->info.bounds;
  return {};
}

}  // namespace relievo
