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

}  // namespace

void MainWindow::makeReplayCommands() {
  make({"recording_folder",
        tr("F&older of recordings\u2026"),
        {},
        tr("Where recordings go that are made from now on"),
        [this] { chooseRecordingFolder(); },
        {}});
  make({"replay",
        tr("Re&play\u2026"),
        {QKeySequence("Ctrl+Shift+R")},
        tr("Show a recording of a touch again; no device is moved"),
        [this] { chooseRecording(); },
        {}});
  make({"replay_play",
        tr("P&lay or pause"),
        {QKeySequence("Ctrl+Space")},
        tr("Go on with the replay, or halt it"),
        [this] { replay_->player().toggle(); },
        {}});
  make({"replay_next_event",
        tr("Ne&xt event"),
        {QKeySequence("Ctrl+Shift+PgDown")},
        tr("Go to the next event or note of the recording"),
        [this] { replay_->goToEvent(1); },
        {}});
  make({"replay_previous_event",
        tr("Event &before"),
        {QKeySequence("Ctrl+Shift+PgUp")},
        tr("Go back to the event or note before"),
        [this] { replay_->goToEvent(-1); },
        {}});
  make({"replay_close",
        tr("&Close replay"),
        {},
        tr("Back to the window from before"),
        [this] { replay_->close(); },
        {}});
  for (const char* name :
       {"replay_play", "replay_next_event", "replay_previous_event", "replay_close"}) {
    command(name)->setEnabled(false);
  }
}

// What the next recording will be; the same choice as in the preferences.
void MainWindow::makeRecordingKinds() {
  QMenu* record = menu(QStringLiteral("record"), {});
  auto* kinds = new QMenu(tr("Record &as"), record);
  kinds->setObjectName(QStringLiteral("record_as"));
  record->insertMenu(command("recording_folder"), kinds);
  kinds->menuAction()->setToolTip(tr("Kind of file of the next recording"));
  kinds->setToolTipsVisible(true);
  auto* group = new QActionGroup(this);
  struct Kind {
    const char* name;
    QString text, tip, ending;
  };
  const std::array<Kind, 2> all{
      {{"record_csv", tr("&CSV"), tr("A table as text that every program opens"),
        QStringLiteral("csv")},
       {"record_h5", tr("&HDF5"), tr("Smaller, with units and surface; for Python and MATLAB"),
        QStringLiteral("h5")}}};
  for (const Kind& kind : all) {
    QAction* action = make({kind.name,
                            kind.text,
                            {},
                            kind.tip,
                            [this, kind] {
                              settings_.setChoice(kRecordingKind, kind.ending);
                              announce(tr("The next recording is %1").arg(kind.ending.toUpper()));
                            },
                            {},
                            true});
    group->addAction(action);
    kinds->addAction(action);
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
  if (QAction* forces = command("forces")) forces->setEnabled(!on);
  for (const char* name :
       {"replay_play", "replay_next_event", "replay_previous_event", "replay_close"}) {
    command(name)->setEnabled(on);
  }
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
