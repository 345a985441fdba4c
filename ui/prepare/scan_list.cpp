// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/scan_list.h"

#include <algorithm>
#include <QCheckBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/prepare/prepare_widgets.h"
#include "ui/prepare/read_scans.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

QIcon patchOf(std::size_t scan) {
  const auto c = colourOfScan(scan);
  QPixmap patch(12, 12);
  patch.fill(QColor(c[0], c[1], c[2]));
  return QIcon(patch);
}

}  // namespace

ScanList::ScanList(PrepareState& state, const ReadScans& reads)
    : QGroupBox(tr("Scans")), state_(state), reads_(reads) {
  scans_ = prepareList(tr("Scans"), "prepare_scans", {tr("Scan"), tr("Lies")});
  add_ =
      prepareButton(tr("&Add\u2026"), "prepare_add_scans", tr("Further scans of the same object"));
  remove_ =
      prepareButton(tr("Remove"), "prepare_remove_scan", tr("Take the chosen scan off the list"));
  make_reference_ =
      prepareButton(tr("Reference"), "prepare_reference",
                    tr("The chosen scan stays where it is; the others are laid on it"));
  pick_ = prepareButton(tr("Pic&k pairs\u2026"), "prepare_pick",
                        tr("Show the same three places on the chosen scan and on the reference"));
  take_back_ =
      prepareButton(tr("Take back"), "prepare_take_back", tr("Forget the place picked last"));
  remove_pair_ =
      prepareButton(tr("Remove pair"), "prepare_remove_pair",
                    tr("Forget the chosen pair, such as the one that fits worst (Delete)"));
  pairs_ = prepareList(tr("Picked pairs"), "prepare_pairs", {tr("Pair"), tr("Error")});
  pairs_->setToolTip(
      tr("How far apart each pair's places are left where all pairs fit best; from three on"));
  split_ =
      prepareButton(tr("Split"), "prepare_split",
                    tr("Each of the file's scans for itself, to leave some out or align them"));
  withheld_ = new QCheckBox(tr("With withheld points"));
  withheld_->setObjectName(QStringLiteral("prepare_withheld"));
  withheld_->setAccessibleName(withheld_->text());
  withheld_->setToolTip(tr("Points of the chosen scan that its file marks as not to be used"));
  layOut();
  connectButtons();
}

void ScanList::layOut() {
  auto* column = new QVBoxLayout(this);
  column->addWidget(scans_, 1);
  column->addLayout(rowOf({add_, remove_, make_reference_}));
  column->addLayout(rowOf({pick_, take_back_, split_}));
  column->addWidget(pairs_, 1);
  column->addLayout(rowOf({remove_pair_}));
  column->addWidget(withheld_);
}

void ScanList::connectButtons() {
  connect(scans_, &QTreeWidget::itemChanged, this, &ScanList::useItem);
  connect(scans_, &QTreeWidget::currentItemChanged, this, [this] {
    if (!filling_) Q_EMIT chosenChanged();
  });
  connect(add_, &QPushButton::clicked, this, &ScanList::addScans);
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (state_.now().inputs.size() < 2) return;
    state_.removeInput(chosen());
    Q_EMIT changed();
  });
  connect(make_reference_, &QPushButton::clicked, this, &ScanList::makeReference);
  connect(pick_, &QPushButton::clicked, this, &ScanList::pickToggled);
  connect(take_back_, &QPushButton::clicked, this, &ScanList::takeBackAsked);
  connect(remove_pair_, &QPushButton::clicked, this, &ScanList::removePairAsked);
  addKeys("Del", pairs_, Qt::WidgetShortcut, [this] { Q_EMIT removePairAsked(); });
  connect(split_, &QPushButton::clicked, this, &ScanList::split);
  connect(withheld_, &QCheckBox::toggled, this, &ScanList::keepWithheld);
}

std::size_t ScanList::chosen() const {
  return static_cast<std::size_t>(std::max(0, chosenRow(*scans_)));
}

void ScanList::showInputs() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  const auto& inputs = state_.now().inputs;
  const int chosen = static_cast<int>(this->chosen());
  setRowCount(*scans_, inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    QTreeWidgetItem* item = scans_->topLevelItem(static_cast<int>(i));
    item->setText(0, tr("%1 %2", "number, scan").arg(i + 1).arg(reads_.nameOf(inputs[i])));
    item->setToolTip(0, QFile::decodeName(inputs[i].file.c_str()));
    item->setCheckState(0, inputs[i].used ? Qt::Checked : Qt::Unchecked);
    item->setIcon(0, inputs.size() > 1 ? patchOf(i) : QIcon());
  }
  scans_->setCurrentItem(scans_->topLevelItem(std::min(chosen, scans_->topLevelItemCount() - 1)));
}

/// How well an input lies on the reference; empty: it is alone or not used.
QString ScanList::poseText(std::size_t input, const std::vector<std::size_t>& used) const {
  if (state_.now().inputs.size() < 2) return {};
  if (input == state_.reference()) return tr("reference");
  const auto place = std::find(used.begin(), used.end(), input);
  if (place == used.end()) return {};
  if (const AlignAnswer* const found = state_.foundAlign()) {
    const auto& verdict = found->scans[static_cast<std::size_t>(place - used.begin())];
    return tr("%1 mm").arg(numberText(verdict.rms_mm, 3));
  }
  const auto at = state_.alignStep();
  const bool is_stored =
      at && std::get<Align>(state_.now().steps[*at].step).method == AlignMethod::stored;
  return is_stored ? tr("as stored") : tr("not yet");
}

void ScanList::showPoses() {
  const QScopedValueRollback<bool> quiet(filling_, true);
  const std::vector<std::size_t> used = state_.usedInputs();
  for (int i = 0; i < scans_->topLevelItemCount(); ++i) {
    scans_->topLevelItem(i)->setText(1, poseText(static_cast<std::size_t>(i), used));
  }
  showButtons();
}

void ScanList::showButtons() {
  const PrepareInput& input = state_.now().inputs[chosen()];
  const ReadScan* const read = reads_.find(input);
  const bool several = state_.now().inputs.size() > 1;
  const bool can_align = several && state_.alignStep() && chosen() != state_.reference();
  remove_->setEnabled(several && !picking_);
  add_->setEnabled(!picking_);
  make_reference_->setEnabled(can_align && !picking_);
  make_reference_->setVisible(several);
  pick_->setVisible(several);
  pick_->setEnabled(can_align || picking_);
  pick_->setText(picking_ ? tr("Pairs are pic&ked") : tr("Pic&k pairs\u2026"));
  pick_->setAccessibleName(picking_ ? tr("Pairs are picked") : tr("Pick pairs"));
  for (QWidget* part : {static_cast<QWidget*>(take_back_), static_cast<QWidget*>(pairs_),
                        static_cast<QWidget*>(remove_pair_)}) {
    part->setVisible(picking_);
  }
  split_->setVisible(!picking_ && read != nullptr && read->scan->info.parts.size() > 1);
  withheld_->setVisible(input.read.keep_withheld ||
                        (read != nullptr && read->scan->info.withheld > 0));
  withheld_->setEnabled(!picking_);
  withheld_->setChecked(input.read.keep_withheld);
}

void ScanList::setPicking(bool on) {
  picking_ = on;
}

void ScanList::showPairs(std::size_t pairs, const std::vector<double>& errors, double mm) {
  const auto worst = std::max_element(errors.begin(), errors.end());
  const int chosen = chosenPair();
  pairs_->clear();
  for (std::size_t i = 0; i < pairs; ++i) {
    auto* item = new QTreeWidgetItem(pairs_);
    item->setText(0, tr("Pair %1").arg(i + 1));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    if (errors.empty()) continue;
    const bool is_worst = worst == errors.begin() + static_cast<std::ptrdiff_t>(i);
    const QString error = numberText(mm * errors[i], 3);
    item->setText(1, is_worst ? tr("%1 mm, worst").arg(error) : tr("%1 mm").arg(error));
    QFont font = item->font(0);
    font.setBold(is_worst);
    for (const int column : {0, 1}) item->setFont(column, font);
  }
  if (pairs > 0) {
    pairs_->setCurrentItem(
        pairs_->topLevelItem(std::clamp(chosen, 0, static_cast<int>(pairs) - 1)));
  }
  remove_pair_->setEnabled(pairs > 0);
}

int ScanList::chosenPair() const {
  return chosenRow(*pairs_);
}

void ScanList::useItem(QTreeWidgetItem* item) {
  if (filling_) return;
  PrepareChoices next = state_.now();
  const int row = scans_->indexOfTopLevelItem(item);
  next.inputs[static_cast<std::size_t>(row)].used = item->checkState(0) == Qt::Checked;
  state_.change(std::move(next));
  Q_EMIT changed();
}

void ScanList::addScans() {
  auto* dialog = new QFileDialog(window(), tr("Add scans"));
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
    Q_EMIT changed();
  });
  dialog->open();
}

void ScanList::makeReference() {
  PrepareChoices next = state_.now();
  const auto at = state_.alignStep();
  if (!at) return;
  auto& align = std::get<Align>(next.steps[*at].step);
  align.pairs.clear();  // Their other halves were picked on the reference before.
  align.reference = static_cast<std::uint32_t>(chosen());
  state_.change(std::move(next));
  Q_EMIT changed();
}

void ScanList::split() {
  const ReadScan* const read = reads_.find(state_.now().inputs[chosen()]);
  if (read == nullptr || read->scan->info.parts.size() < 2) return;
  state_.splitInput(chosen(), static_cast<int>(read->scan->info.parts.size()));
  Q_EMIT changed();
}

void ScanList::keepWithheld(bool on) {
  if (filling_) return;
  PrepareChoices next = state_.now();
  next.inputs[chosen()].read.keep_withheld = on;
  state_.change(std::move(next));
  Q_EMIT changed();
}

}  // namespace relievo
