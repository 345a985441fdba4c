// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/output/save_controller.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QProcess>
#include <QTimer>
#include <utility>

#include "core/base/error.h"
#include "core/project/project_files.h"
#include "ui/control/output/export_controller.h"
#include "ui/control/output/package_controller.h"
#include "ui/control/output/picture_controller.h"
#include "ui/control/output/tiles_controller.h"
#include "ui/control/output/video_controller.h"
#include "ui/language/core_text.h"
#include "ui/language/error_text.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"
#include "ui/work/scheduling/event_turn.h"

namespace relievo {
namespace {

constexpr int kPatienceMs = 5000, kTurnMs = 20;

}  // namespace

SaveController::SaveController(const ControllerParts& parts)
    : Controller(parts),
      autosave_(settings_.choice(QStringLiteral("keep_work"), true).toBool()
                    ? settings_.stateFolder(QStringLiteral("autosave"))
                    : QString(),
                [this] { return autosavedProject(); }) {
  commands_.on(Command::save_project, this, [this] { saveNow(); });
  commands_.on(Command::save_project_as, this, [this] { saveAs(); });
  connect(&messages_, &WindowMessages::cancelAsked, this, &SaveController::stayOpen);
  connect(&document_, &Document::amended, this, &SaveController::keepWork);
  connect(&document_.history(), &QUndoStack::indexChanged, this, &SaveController::keepWork);
  connect(&autosave_, &AutosaveController::failed, &messages_,
          [this](const QString& text) { messages_.show(text); });
}

void SaveController::watch(const Writers& writers) {
  writers_.emplace(writers);
  connect(&writers.pictures, &PictureController::ended, this, &SaveController::closeIfAwaited);
  connect(&writers.packages, &PackageController::ended, this, &SaveController::closeIfAwaited);
  connect(&writers.exports, &ExportController::ended, this, &SaveController::closeIfAwaited);
  connect(&writers.tiles, &TilesController::ended, this, &SaveController::closeIfAwaited);
  connect(&writers.videos.control(), &VideoControl::ended, this, &SaveController::closeIfAwaited);
}

bool SaveController::mayClose() {
  if (!closes_anyway_ && document_.saved().hasUnsaved()) {
    whenNothingIsUnsaved([this] {
      closes_anyway_ = true;
      window_.close();
    });
    return false;
  }
  return ends_at_once_ || !closesWhenAllIsWritten();
}

void SaveController::whenNothingIsUnsaved(const std::function<void()>& then) {
  if (!document_.saved().hasUnsaved()) {
    then();
    return;
  }
  if (auto* asked = window_.findChild<QMessageBox*>(QStringLiteral("unsaved_dialog"))) {
    asked->raise();
    return;
  }
  const QString& project = document_.saved().projectFile();
  const QString name = shownName(project.isEmpty() ? document_.file() : project);
  auto* box = new QMessageBox(
      QMessageBox::Warning, tr("Unsaved work"),
      tr("Work on %1 is in no file yet: bookmarks, measurements, camera paths or settings.")
          .arg(name),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
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
    if (document_.saved().projectFile().isEmpty()) {
      saveAs(then);
    } else {
      save(document_.saved().projectFile());
      if (!document_.saved().hasUnsaved()) then();
    }
  });
  box->open();
}

void SaveController::restartWhenNothingIsUnsaved() {
  whenNothingIsUnsaved([this] { restart(); });
}

// The new one reads the settings, so it speaks the language that was chosen.
void SaveController::restart() {
  const QString& project = document_.saved().projectFile();
  const QString shown = project.isEmpty() ? addressOrPath(document_.file()) : project;
  if (!QProcess::startDetached(QCoreApplication::applicationFilePath(),
                               shown.isEmpty() ? QStringList() : QStringList{shown})) {
    messages_.show(
        tr("relievo could not be started again. Nothing was changed. Close it and start it "
           "yourself."));
    return;
  }
  closes_anyway_ = true;
  window_.close();
}

void SaveController::endAtOnce() {
  if (std::exchange(ends_at_once_, true)) return;
  if (document_.saved().hasUnsaved()) autosave_.leave();
  if (writers_) {
    VideoControl& video = writers_->videos.control();
    video.cancel();
    // What was filmed until now is as much a record as a recording is; its end takes moments.
    video.stopLive();
    const QDeadlineTimer patience(kPatienceMs);
    while (video.live() && !patience.hasExpired()) {
      waitForEvents(kTurnMs);
    }
  }
  closes_anyway_ = true;
  window_.close();
}

bool SaveController::writing() const {
  if (!writers_) return false;
  const VideoControl& video = writers_->videos.control();
  return writers_->pictures.busy() || writers_->packages.busy() || writers_->exports.busy() ||
         writers_->tiles.busy() || video.writing() || video.live();
}

bool SaveController::closesWhenAllIsWritten() {
  closes_when_saved_ = false;
  if (!writers_) return false;
  VideoControl& video = writers_->videos.control();
  if (video.live()) video.stopLive();
  closes_when_saved_ = writing();
  if (!closes_when_saved_) return false;
  announce(writers_->packages.busy() ? tr("relievo closes when the package is written")
           : writers_->exports.busy() || writers_->tiles.busy()
               ? tr("relievo closes when the map is written")
           : video.writing() || video.live()
               ? tr("relievo closes when the video is saved; Escape stops both")
               : tr("relievo closes when the picture is saved"));
  return true;
}

void SaveController::closeIfAwaited(bool written) {
  if (!written) stayOpen();
  if (closes_when_saved_ && !writing()) window_.close();
}

void SaveController::saveNow() {
  if (document_.saved().projectFile().isEmpty()) {
    saveAs();
  } else {
    save(document_.saved().projectFile());
  }
}

void SaveController::saveAs(const std::function<void()>& then) {
  auto* dialog = new QFileDialog(&window_, tr("Save project"), folderFor(document_.file()),
                                 tr("Projects (*.relievo.json)"));
  dialog->setObjectName(QStringLiteral("project_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QString ending = QStringLiteral(".relievo.json");
  dialog->selectFile(stemOf(document_.file(), ending) + ending);
  connect(dialog, &QFileDialog::fileSelected, this, [this, then](const QString& file) {
    save(file.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)
             ? file
             : file + QLatin1String(".relievo.json"));
    if (then && !document_.saved().hasUnsaved()) then();
  });
  dialog->open();
}

void SaveController::save(const QString& file) {
  try {
    writeProject(pathOf(file), document_.stored());
    document_.saved().noteSaved(file);
    showTitle();
    autosave_.forget();
    settings_.addRecentFile(file);
    Q_EMIT saved(file);
    announce(tr("%1 is saved").arg(shownName(file)));
  } catch (const Error& error) {
    messages_.show(shownError(error));
  }
}

Project SaveController::autosavedProject() const {
  Project p = document_.stored();
  const QString& file = document_.saved().projectFile();
  if (!file.isEmpty()) p.saved_as = bytesOfPath(QFileInfo(file).absoluteFilePath());
  return p;
}

void SaveController::keepWork() {
  if (!document_.isOpen()) return;
  autosave_.changed();
  if (std::exchange(title_due_, true)) return;
  constexpr int kTitleMs = 200;  // Of many changes in a row the title tells the last.
  QTimer::singleShot(kTitleMs, this, [this] {
    title_due_ = false;
    showTitle();
  });
}

void SaveController::showTitle() {
  if (!document_.isOpen()) return;
  const QString& project = document_.saved().projectFile();
  const QString shown = project.isEmpty() ? document_.file() : project;
  // Qt puts a star at the first [*] where something is unsaved.
  const QString name = shownName(shown).replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
  window_.setWindowTitle(tr("%1[*] \u2013 relievo").arg(name));
  window_.setWindowModified(document_.saved().hasUnsaved());
}

}  // namespace relievo
