// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_rows.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>

#include "ui/language/core_text.h"
#include "ui/prepare/prepare_widgets.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

/// NAME-prepared.ply, NAME-prepared-2.ply, ... beside the scan: the first that is free.
QString freeName(const QString& scan) {
  const QString base =
      QDir(folderFor(scan)).filePath(stemOf(scan, QStringLiteral("-prepared-9999.recipe.json")));
  QString file = base + QLatin1String("-prepared.ply");
  for (int n = 2; QFileInfo::exists(file); ++n) {
    file = QStringLiteral("%1-prepared-%2.ply").arg(base).arg(n);
  }
  return file;
}

}  // namespace

PreparedFileRow::PreparedFileRow() {
  file_ = new QLineEdit;
  file_->setObjectName(QStringLiteral("prepare_file"));
  file_->setAccessibleName(tr("Prepared scan"));
  file_->setToolTip(
      tr("The file that the prepared scan is written to; the scans stay as they are"));
  note_ = new QLabel(tr("It is there already and will be replaced."));
  auto* browse = prepareButton(tr("Choose\u2026"), "prepare_browse", tr("Another place or name"));
  browse->setAccessibleName(tr("Choose the file"));
  auto* title = new QLabel(tr("P&repared scan:"));
  title->setBuddy(file_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(title);
  row->addWidget(file_, 1);
  row->addWidget(browse);
  row->addWidget(note_);
  note_->hide();
  connect(browse, &QPushButton::clicked, this, &PreparedFileRow::choose);
  connect(file_, &QLineEdit::textChanged, this,
          [this] { note_->setVisible(QFileInfo::exists(file())); });
}

void PreparedFileRow::suggestBeside(const QString& scan) {
  file_->setText(QDir::toNativeSeparators(freeName(scan)));
}

QString PreparedFileRow::file() const {
  QString file = QDir::fromNativeSeparators(file_->text().trimmed());
  if (!file.endsWith(QLatin1String(".ply"), Qt::CaseInsensitive)) file += QLatin1String(".ply");
  return QFileInfo(file).absoluteFilePath();
}

void PreparedFileRow::choose() {
  auto* dialog = new QFileDialog(window(), tr("Prepared scan"), QFileInfo(file()).absolutePath(),
                                 tr("Scans (*.ply)"));
  dialog->setObjectName(QStringLiteral("prepared_file_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("ply"));
  dialog->selectFile(QFileInfo(file()).fileName());
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& file) { file_->setText(QDir::toNativeSeparators(file)); });
  dialog->open();
}

PrepareWorkRow::PrepareWorkRow() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  makeWork(row);
  row->addStretch(1);
  makeResult(row);
}

void PrepareWorkRow::makeWork(QHBoxLayout* row) {
  live_ = new QCheckBox(tr("L&ive"));
  live_->setObjectName(QStringLiteral("prepare_live"));
  live_->setAccessibleName(tr("Live preview"));
  live_->setToolTip(tr("Do the steps anew after each change"));
  live_->setChecked(true);
  recompute_ =
      prepareButton(tr("Recom&pute"), "prepare_recompute", tr("Do the steps as they are shown"));
  recompute_->setAccessibleName(tr("Recompute"));
  stop_ = prepareButton(tr("&Stop"), "prepare_stop", tr("Stop the work; the picture before stays"));
  bar_ = new QProgressBar;
  bar_->setAccessibleName(tr("Progress"));
  bar_->setRange(0, 100);
  step_ = new QLabel;
  step_->setAccessibleName(tr("What is being done"));
  row->addWidget(live_);
  row->addWidget(recompute_);
  row->addWidget(step_);
  row->addWidget(bar_, 1);
  row->addWidget(stop_);
  connect(live_, &QCheckBox::toggled, this, [this](bool on) {
    if (on) Q_EMIT madeLive();
  });
  connect(recompute_, &QPushButton::clicked, this, &PrepareWorkRow::computeAsked);
  connect(stop_, &QPushButton::clicked, this, &PrepareWorkRow::stopAsked);
}

void PrepareWorkRow::makeResult(QHBoxLayout* row) {
  save_recipe_ = prepareButton(tr("Sa&ve recipe\u2026"), "prepare_save_recipe",
                               tr("Keep these steps as a file, to do them again"));
  copy_command_ = prepareButton(tr("Cop&y as command"), "prepare_copy_command",
                                tr("The command that does the same, once the recipe is saved"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  nameButtons(*buttons);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  ok_->setObjectName(QStringLiteral("prepare_ok"));
  ok_->setToolTip(tr("Write the prepared scan and open it"));
  for (QAbstractButton* made : buttons->buttons()) made->setAccessibleName(made->text());
  row->addWidget(save_recipe_);
  row->addWidget(copy_command_);
  row->addWidget(buttons);
  connect(save_recipe_, &QPushButton::clicked, this, &PrepareWorkRow::recipeAsked);
  connect(copy_command_, &QPushButton::clicked, this, &PrepareWorkRow::commandAsked);
  connect(buttons, &QDialogButtonBox::accepted, this, &PrepareWorkRow::accepted);
  connect(buttons, &QDialogButtonBox::rejected, this, &PrepareWorkRow::rejected);
}

bool PrepareWorkRow::isLive() const {
  return live_->isChecked();
}

void PrepareWorkRow::showBusy(bool busy) {
  bar_->setVisible(busy);
  step_->setVisible(busy);
  stop_->setVisible(busy);
  if (!busy) return;
  bar_->setValue(0);
  ok_->setEnabled(true);  // May be pressed before the work is done.
}

void PrepareWorkRow::showProgress(const QString& step, double fraction) {
  step_->setText(step);
  bar_->setValue(static_cast<int>(100 * fraction));
}

void PrepareWorkRow::setStale(bool stale) {
  recompute_->setText(stale ? tr("Recom&pute *") : tr("Recom&pute"));
}

void PrepareWorkRow::setCanTake(bool can) {
  ok_->setEnabled(can);
}

void PrepareWorkRow::setCanSave(bool recipe, bool command) {
  save_recipe_->setEnabled(recipe);
  copy_command_->setEnabled(command);
}

}  // namespace relievo
