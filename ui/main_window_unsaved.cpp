// SPDX-License-Identifier: BSD-3-Clause
// What would be lost if the window closed, or showed another scan, and the question about it.
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QMessageBox>
#include <QProcess>
#include <utility>

#include "ui/core_words.h"
#include "ui/event_turn.h"
#include "ui/file_names.h"
#include "ui/main_window.h"
#include "ui/work_keeper.h"

namespace relievo {
namespace {

constexpr int kPatienceMs = 5000, kTurnMs = 20;

/// What of a state cost somebody work, as text. Where the window stands is not work: to look about
/// must not end in a question; recordings are files already. @param settings  also how the surface
/// is made and looked at: of a state that a project file holds
std::string workIn(const Project& state, bool settings) {
  Project work;
  work.places = state.places;
  work.measurements = state.measurements;
  work.paths = state.paths;
  if (settings) {
    work.options = state.options;
    work.figures = state.figures;
    work.look = state.look;
    work.stereo = state.stereo;
    if (work.stereo.automatic_depth) work.stereo.eye_angle_deg = StereoOptions{}.eye_angle_deg;
  }
  return projectJson(work);
}

}  // namespace

bool MainWindow::hasUnsavedWork() {
  // While the first file is being opened nothing has been noted yet, and there is no work.
  return document_.isOpen() && !saved_work_.empty() &&
         workIn(project(), !project_file_.isEmpty()) != saved_work_;
}

void MainWindow::noteSaved() {
  saved_work_ = workIn(project(), !project_file_.isEmpty());
  showTitle();
}

void MainWindow::whenNothingIsUnsaved(const std::function<void()>& then) {
  if (!hasUnsavedWork()) {
    then();
    return;
  }
  if (auto* asked = findChild<QMessageBox*>(QStringLiteral("unsaved_dialog"))) {
    asked->raise();
    return;
  }
  const QString name = shownName(project_file_.isEmpty() ? document_.file() : project_file_);
  auto* box = new QMessageBox(
      QMessageBox::Warning, tr("Unsaved work"),
      tr("Work on %1 is in no file yet: places, measurements, camera paths or settings.").arg(name),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("unsaved_dialog"));
  box->setTextFormat(Qt::PlainText);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setAccessibleName(tr("Unsaved work"));
  box->setInformativeText(tr("Save it as a project?"));
  box->setDefaultButton(QMessageBox::Save);
  box->setEscapeButton(QMessageBox::Cancel);
  nameButtons(*box->findChild<QDialogButtonBox*>());
  connect(box, &QDialog::finished, this, [this, then](int answer) {
    if (answer == QMessageBox::Discard) then();
    if (answer != QMessageBox::Save) return;
    if (project_file_.isEmpty()) {
      saveProjectAs(then);
    } else {
      saveProject(project_file_);
      if (!hasUnsavedWork()) then();
    }
  });
  box->open();
}

// The new one reads the settings, so it speaks the language that was chosen.
void MainWindow::restart() {
  const QString shown = project_file_.isEmpty() ? document_.file() : project_file_;
  if (!QProcess::startDetached(QCoreApplication::applicationFilePath(),
                               shown.isEmpty() ? QStringList() : QStringList{shown})) {
    showMessage(
        tr("relievo could not be started again. Nothing was changed. Close it and start it "
           "yourself."));
    return;
  }
  closes_anyway_ = true;
  close();
}

void MainWindow::endAtOnce() {
  if (std::exchange(ends_at_once_, true)) return;
  if (hasUnsavedWork()) keeper_->leave();
  video_->cancel();
  // What was filmed until now is as much a record as a recording is; its end takes moments.
  video_->stopLive();
  const QDeadlineTimer patience(kPatienceMs);
  while (video_->live() && !patience.hasExpired()) {
    waitForEvents(kTurnMs);
  }
  closes_anyway_ = true;
  close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!closes_anyway_ && hasUnsavedWork()) {
    event->ignore();
    whenNothingIsUnsaved([this] {
      closes_anyway_ = true;
      close();
    });
    return;
  }
  if (!ends_at_once_ && closesWhenAllIsWritten()) {
    event->ignore();
    return;
  }
  saveLayout();
  document_.cancel();
  Q_EMIT closing();
  QMainWindow::closeEvent(event);
}

}  // namespace relievo
