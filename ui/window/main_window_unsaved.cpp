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

#include "ui/frame/message_strip.h"
#include "ui/frame/start_page.h"
#include "ui/frame/status_fields.h"
#include "ui/language/core_words.h"
#include "ui/panels/measure_panel.h"
#include "ui/views/event_turn.h"
#include "ui/views/path_preview.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"
#include "ui/work/recordings_end.h"
#include "ui/work/work_keeper.h"

namespace relievo {
namespace {

constexpr int kPatienceMs = 5000, kTurnMs = 20;

}  // namespace

void MainWindow::whenNothingIsUnsaved(const std::function<void()>& then) {
  if (!hasUnsavedWork()) {
    then();
    return;
  }
  if (auto* asked = findChild<QMessageBox*>(QStringLiteral("unsaved_dialog"))) {
    asked->raise();
    return;
  }
  const QString& project = document_.projectFile();
  const QString name = shownName(project.isEmpty() ? document_.file() : project);
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
    if (document_.projectFile().isEmpty()) {
      saveProjectAs(then);
    } else {
      saveProject(document_.projectFile());
      if (!hasUnsavedWork()) then();
    }
  });
  box->open();
}

void MainWindow::closeDocument() {
  if (!document_.isOpen()) return;
  const QString name = shownName(document_.file());
  if (recordings_end_->endFirst(command("record"), [this] { closeDocument(); })) {
    announce(tr("%1 is closed when the recording is saved").arg(name));
    return;
  }
  whenNothingIsUnsaved([this, name, saved = recordings_end_->takeWords()] {
    stopForces();
    path_preview_->stop();
    if (replay_->showing()) replay_->close();
    replay_->forgetWaiting();
    measure_panel_->cancel();
    if (isFullScreen()) setFullScreenDetail(false);
    questions_.clear();
    strip_->close();
    restoring_.reset();
    probe_.reset();
    document_.close();
    keeper_->forget();
    recovered_copy_.clear();
    for (const StatusField field :
         {StatusField::position, StatusField::origin, StatusField::detail, StatusField::force}) {
      status_->set(field, {});
    }
    setWindowTitle(QStringLiteral("relievo"));
    setWindowModified(false);
    start_->setFocus();
    const QString closed = tr("%1 is closed").arg(name);
    announce(saved.isEmpty() ? closed : tr("%1. %2").arg(saved, closed));
  });
}

// The new one reads the settings, so it speaks the language that was chosen.
void MainWindow::restart() {
  const QString& project = document_.projectFile();
  const QString shown = project.isEmpty() ? document_.file() : project;
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
