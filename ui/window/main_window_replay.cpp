// SPDX-License-Identifier: BSD-3-Clause
// The window's part in a replay: commands, what the status bar says, and the map it needs.
#include <array>
#include <QAction>
#include <QActionGroup>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/project/carried_state.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/status_fields.h"
#include "ui/language/spoken_error.h"
#include "ui/panels/replay_control.h"
#include "ui/panels/replay_panel.h"
#include "ui/panels/suggest_panel.h"
#include "ui/plots/time_plot.h"
#include "ui/views/detail_view.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr QLatin1String kRecordingKind("recording_kind");
constexpr QLatin1String kRecordingFolder("recording_folder");
constexpr std::array kOfShownRecording{Command::replay_play, Command::replay_next_event,
                                       Command::replay_previous_event, Command::replay_close};

}  // namespace

void MainWindow::makeReplayCommands() {
  commands_.on(Command::recording_folder, this, [this] { chooseRecordingFolder(); });
  commands_.on(Command::replay, this, [this] { chooseRecording(); });
  commands_.on(Command::replay_play, this, [this] { replay_->player().toggle(); });
  commands_.on(Command::replay_next_event, this, [this] { replay_->goToEvent(1); });
  commands_.on(Command::replay_previous_event, this, [this] { replay_->goToEvent(-1); });
  commands_.on(Command::replay_close, this, [this] { replay_->close(); });
  for (const Command command : kOfShownRecording) commands_[command].setEnabled(false);
  // What the next recording will be; the same choice as in the preferences.
  for (const auto& [command, ending] : {std::pair{Command::record_csv, QStringLiteral("csv")},
                                        std::pair{Command::record_h5, QStringLiteral("h5")}}) {
    commands_.on(command, this, [this, ending = ending] {
      settings_.setChoice(kRecordingKind, ending);
      announce(tr("The next recording is %1").arg(ending.toUpper()));
    });
  }
}

QString MainWindow::recordingEnding() const {
  const QString csv = QStringLiteral("csv"), h5 = QStringLiteral("h5");
  return settings_.choice(kRecordingKind, csv).toString() == h5 ? h5 : csv;
}

QString MainWindow::recordingFolder() const {
  const QString chosen = settings_.choice(kRecordingFolder, QString()).toString();
  if (!chosen.isEmpty()) return QFileInfo(chosen).absoluteFilePath();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return documents.isEmpty() ? QString() : documents + QLatin1String("/relievo");
}

void MainWindow::chooseRecordingFolder() {
  auto* dialog = new QFileDialog(this, tr("Folder of recordings"));
  dialog->setObjectName(QStringLiteral("recording_folder_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  if (QFileInfo(recordingFolder()).isDir()) dialog->setDirectory(recordingFolder());
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    settings_.setChoice(kRecordingFolder, folder);
    announce(tr("Recordings go to %1").arg(shownPath(folder)));
  });
  dialog->open();
}

// After the first recording, so that nothing stands between a hand and its record.
void MainWindow::askForRecordingFolder() {
  if (!settings_.choice(kRecordingFolder, QString()).toString().isEmpty()) return;
  if (strip_->isVisible()) return;  // Something else is asked or told: at the next one, then.
  settings_.setChoice(kRecordingFolder, recordingFolder());
  strip_->show(tr("Recordings are kept in %1.").arg(shownPath(recordingFolder())),
               {{tr("Another &folder\u2026"), [this] { chooseRecordingFolder(); }}});
}

void MainWindow::connectReplay() {
  connect(replay_, &ReplayControl::said, this, &MainWindow::announce);
  connect(replay_, &ReplayControl::failed, this, &MainWindow::showMessage);
  connect(replay_, &ReplayControl::shownChanged, this, &MainWindow::showReplaying);
  connect(replay_, &ReplayControl::probeMoved, this, &MainWindow::drawProbe);
  connect(replay_, &ReplayControl::needsItsMap, this, &MainWindow::offerRecordedMap);
  connect(replay_, &ReplayControl::inputFound, this, &MainWindow::openRecordedMap);
  connect(replay_, &ReplayControl::busyChanged, this, &MainWindow::showBusy);
  connect(replay_, &ReplayControl::progressed, status_, &StatusFields::showWork);
  connect(status_, &StatusFields::cancelAsked, replay_, &ReplayControl::cancel);
  // Another map: what was recorded on the one before is over.
  connect(&document_, &Document::surfaceChanged, replay_, &ReplayControl::close);
}

void MainWindow::setRecordingReader(RecordingReader reader) {
  replay_->setReader(std::move(reader));
}

void MainWindow::chooseRecording() {
  auto* dialog = new QFileDialog(this, tr("Replay"));
  dialog->setObjectName(QStringLiteral("replay_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilters({tr("Recordings (*.csv *.h5 *.hdf5)"), tr("All files (*)")});
  if (QFileInfo(recordingFolder()).isDir()) dialog->setDirectory(recordingFolder());
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::replay);
  dialog->open();
}

void MainWindow::replay(const QString& file) {
  if (touch_.recording) {
    strip_->show(tr("A recording is running. Nothing was opened. Stop it first (Ctrl+R)."));
    return;
  }
  strip_->close();
  replay_->open(QFileInfo(file).absoluteFilePath());
}

void MainWindow::showReplaying(bool on) {
  if (on) stopForces();  // What is shown is not where the hand is.
  if (QAction* forces = commands_.named(QStringLiteral("forces"))) forces->setEnabled(!on);
  for (const Command command : kOfShownRecording) commands_[command].setEnabled(on);
  replay_->panel()->setVisible(on);
  suggest_panel_->setEnabled(!on && document_.isOpen());
  showPlots();
  enableCommands();
  if (on) {
    replay_->panel()->setFocus();
    return;
  }
  probe_.reset();
  detail_->clearProbe();
  status_->set(StatusField::recording, {});
  detail_->setFocus();
}

void MainWindow::offerRecordedMap(const QString& sentence) {
  const auto recording = replay_->waiting();
  if (recording->input.empty()) {
    strip_->show(sentence);
    return;
  }
  strip_->show(tr("%1 Nothing was changed.").arg(sentence),
               {{tr("&Open its input"), [this] {
                   QStringList others{settings_.recentFiles()};
                   others << document_.file();
                   replay_->findInput(others);
                 }}});
}

/// Of a log of earlier versions, which names its scan and does not say how the map was made.
void MainWindow::openOld(const Project& project) {
  const QString log = replay_->waitingFile();
  whenFilesMayBeRead(project, log, [this, project, log](const auto& withheld) {
    if (!withheld.empty()) return tellInputWithheld(project, log);
    OpenRequest request;
    request.file = pathFromBytes(project.file);
    open(request);
  });
}

void MainWindow::openRecordedMap(const QString& file) {
  const auto recording = replay_->waiting();
  if (!recording) return;
  Project project;
  try {
    if (!recording->state.empty()) {
      project = projectFromState(recording->state, recording->name).value_or(Project{});
    }
  } catch (const Error& error) {
    replay_->forgetWaiting();
    strip_->show(shownError(error));
    return;
  }
  // Empty: not there; restoring says so and lets it be found by hand.
  project.file = file.isEmpty() ? recording->input : bytesOfPath(file);
  if (recording->state.empty() && !file.isEmpty()) {
    project.sha256 = recording->input_sha256;
    openOld(project);
  } else {
    restore(project, replay_->waitingFile());
  }
}

}  // namespace relievo
