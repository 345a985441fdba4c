// SPDX-License-Identifier: BSD-3-Clause
// The curve of a profile under the views, and its cursor.
#include <QAction>
#include <QFileDialog>
#include <QFileInfo>

#include "ui/panels/measure_panel.h"
#include "ui/plots/profile_strip.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {

void MainWindow::makeProfileCommands() {
  commands_[Command::show_profile].setChecked(true);
  commands_.onToggled(Command::show_profile, this, [this](bool) { showPlots(); });
  commands_.on(Command::profile_save, this, [this] { saveProfile(); });
}

void MainWindow::connectProfile() {
  connect(profile_, &ProfileStrip::cursorMoved, this, &MainWindow::showProfileCursor);
  connect(profile_, &ProfileStrip::saveAsked, this, &MainWindow::saveProfile);
  connect(profile_, &ProfileStrip::closeAsked, this,
          [this] { commands_[Command::show_profile].setChecked(false); });
  connect(&document_, &Document::windowChanged, this, &MainWindow::showProfileMark);
  showProfile();
}

void MainWindow::showProfile() {
  const auto row = measure_panel_->shownProfile();
  const QString name =
      row ? QString::fromStdString(
                measure_panel_->measurements()[static_cast<std::size_t>(*row)].name)
          : QString();
  profile_->show(name, row ? measure_panel_->profileRows(*row) : std::vector<ProfileRow>());
  commands_[Command::profile_save].setEnabled(!profile_->isEmpty());
  showPlots();
}

void MainWindow::showProfileMark() {
  std::optional<ViewMm> mark = profile_->cursorAt();
  if (mark) mark->z *= document_.project().gain;
  detail_->setMark(mark);
  reference_->setMark(mark);
}

void MainWindow::showProfileCursor() {
  showProfileMark();
  if (const auto at = profile_->cursorAt()) detail_->carryHandTo(at->x, at->y);
}

void MainWindow::saveProfile() {
  if (profile_->isEmpty()) return;
  const QFileInfo input(document_.file());
  auto* dialog = new QFileDialog(this, tr("Save profile"), input.absolutePath());
  dialog->setObjectName(QStringLiteral("profile_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("As it is shown (*.svg)"), tr("Its numbers (*.csv)")});
  const QString ending = QStringLiteral("-profile.svg");
  dialog->selectFile(stemOf(document_.file(), ending) + ending);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    const auto row = measure_panel_->shownProfile();
    if (!row || profile_->isEmpty()) return;
    tellWritten(file, [this, row = *row, file] {
      if (file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        measure_panel_->writeRow(row, file);
      } else {
        measure_panel_->writeDrawing(profile_->drawing(), file);
      }
    });
  });
  dialog->open();
}

}  // namespace relievo
