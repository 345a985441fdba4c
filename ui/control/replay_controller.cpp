// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/replay_controller.h"

#include <array>
#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/project/embedded_state.h"
#include "core/project/project_files.h"
#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "ui/control/open_controller.h"
#include "ui/control/touch_controller.h"
#include "ui/language/error_text.h"
#include "ui/panels/replay_panel.h"
#include "ui/views/detail_view.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

const QLatin1String kRecordingKind("recording_kind");
const QLatin1String kRecordingFolder("recording_folder");
constexpr std::array kOfShownRecording{Command::replay_play, Command::replay_next_event,
                                       Command::replay_previous_event, Command::replay_close};

/// A file with its path as it is here, and its checksum.
InputFile asItIs(const QString& file, const Task& task) {
  const std::filesystem::path path = QFile::encodeName(file).toStdString();
  InputFile known = inputFile(path, {}, task);
  known.file = bytesOfPath(QFileInfo(file).absoluteFilePath());
  return known;
}

}  // namespace

QString recordingHeader(const Document& document, const QString& file) {
  if (!document.isOpen()) return {};
  const Surface& s = *document.surface();
  const Project& state = document.project();
  const auto word = [](std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
  };
  const auto exact = [](double v) { return QString::number(v, 'g', 17); };
  QStringList matrix;
  for (const double v : s.view_from_file.m) matrix << exact(v);
  // Coarser than wanted while tiles are on their way from the web.
  const Region& r = document.window() ? document.window()->region : state.region;
  return QStringList{
      QLatin1String("# application: relievo ") + QStringLiteral(RELIEVO_VERSION_STRING),
      QLatin1String("# input: ") + wholeName(document.file()),
      QLatin1String("# input_sha256: ") + document.fileSha256(),
      QLatin1String("# unit: ") + word(name(s.unit)) + QLatin1String(" (") +
          word(name(s.unit_source)) + ')',
      QLatin1String("# view: ") + QString::fromStdString(s.view_name),
      QLatin1String("# view_from_file: ") + matrix.join(' '),
      QLatin1String("# engine: ") + QString::fromStdString(s.engine),
      QStringLiteral("# region_mm: %1 %2 %3 %3")
          .arg(exact(r.x_mm), exact(r.y_mm), exact(r.side_mm)),
      QStringLiteral("# level: %1").arg(r.level.value),
      QLatin1String("# gain: ") + exact(state.gain),
      QLatin1String("# ") +
          QString::fromStdString(stateLine(toJson(document.provenanceIn(file), -1)))}
      .join('\n');
}

void ReplayController::makeCommands() {
  commands_.on(Command::recording_folder, this, [this] { chooseFolder(); });
  commands_.on(Command::replay, this, [this] { choose(); });
  commands_.on(Command::replay_play, this, [this] { replay_.player().toggle(); });
  commands_.on(Command::replay_next_event, this, [this] { replay_.goToEvent(1); });
  commands_.on(Command::replay_previous_event, this, [this] { replay_.goToEvent(-1); });
  commands_.on(Command::replay_close, this, [this] { replay_.close(); });
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

void ReplayController::noteRecording(const QString& file) {
  askForFolder();
  Q_EMIT recordingNoted(file);
  if (!document_.isOpen()) return;
  const auto known = std::make_shared<InputFile>();
  const QString scan = document_.fileSha256();
  work_.add(
      [file, known](const Task& task) {
        try {
          *known = asItIs(file, task);
        } catch (const Error&) {  // It is gone again; then it belongs to nothing.
        }
      },
      [this, known, scan] {
        if (known->sha256.empty() || scan != document_.fileSha256()) return;
        document_.amend([&](Project& p) {
          std::erase_if(p.recordings,
                        [&](const InputFile& one) { return one.file == known->file; });
          p.recordings.push_back(*known);
        });
      });
}

QString ReplayController::ending() const {
  const QString csv = QStringLiteral("csv"), h5 = QStringLiteral("h5");
  return settings_.choice(kRecordingKind, csv).toString() == h5 ? h5 : csv;
}

QString ReplayController::folder() const {
  const QString chosen = settings_.choice(kRecordingFolder, QString()).toString();
  if (!chosen.isEmpty()) return QFileInfo(chosen).absoluteFilePath();
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return documents.isEmpty() ? QString() : documents + QLatin1String("/relievo");
}

void ReplayController::chooseFolder() {
  auto* dialog = new QFileDialog(&window_, tr("Folder of recordings"));
  dialog->setObjectName(QStringLiteral("recording_folder_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  if (QFileInfo(folder()).isDir()) dialog->setDirectory(folder());
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    settings_.setChoice(kRecordingFolder, folder);
    announce(tr("Recordings go to %1").arg(shownPath(folder)));
  });
  dialog->open();
}

// After the first recording, so that nothing stands between a hand and its record.
void ReplayController::askForFolder() {
  if (!settings_.choice(kRecordingFolder, QString()).toString().isEmpty()) return;
  if (!messages_.shown().isEmpty())
    return;  // Something else is asked or told: at the next one, then.
  settings_.setChoice(kRecordingFolder, folder());
  messages_.show(tr("Recordings are kept in %1.").arg(shownPath(folder())),
                 {{tr("Another &folder\u2026"), [this] { chooseFolder(); }}});
}

ReplayController::ReplayController(const ControllerParts& parts, ReplayControl& replay,
                                   DetailView& detail, TouchController& touch,
                                   OpenController& opening)
    : Controller(parts), replay_(replay), detail_(detail), touch_(touch), opening_(opening) {
  makeCommands();
  connect(&replay_, &ReplayControl::said, &messages_, &WindowMessages::announce);
  connect(&replay_, &ReplayControl::failed, &messages_,
          [this](const QString& text) { messages_.show(text); });
  connect(&replay_, &ReplayControl::shownChanged, this, &ReplayController::showReplaying);
  connect(&replay_, &ReplayControl::needsItsMap, this, &ReplayController::offerRecordedMap);
  connect(&replay_, &ReplayControl::inputFound, this, &ReplayController::openRecordedMap);
  messages_.follow(replay_);
  connect(&messages_, &WindowMessages::cancelAsked, &replay_, &ReplayControl::cancel);
  // Another map: what was recorded on the one before is over.
  connect(&document_, &Document::surfaceChanged, &replay_, &ReplayControl::close);
}

void ReplayController::setReader(RecordingReader reader) {
  replay_.setReader(std::move(reader));
}

void ReplayController::choose() {
  auto* dialog = new QFileDialog(&window_, tr("Replay"));
  dialog->setObjectName(QStringLiteral("replay_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilters({tr("Recordings (*.csv *.h5 *.hdf5)"), tr("All files (*)")});
  if (QFileInfo(folder()).isDir()) dialog->setDirectory(folder());
  connect(dialog, &QFileDialog::fileSelected, this, &ReplayController::open);
  dialog->open();
}

void ReplayController::open(const QString& file) {
  if (touch_.readout().recording) {
    messages_.show(tr("A recording is running. Nothing was opened. Stop it first (Ctrl+R)."));
    return;
  }
  messages_.close();
  replay_.open(QFileInfo(file).absoluteFilePath());
}

void ReplayController::showReplaying(bool on) {
  if (on) touch_.stopForces();  // What is shown is not where the hand is.
  if (QAction* forces = commands_.named(QStringLiteral("forces"))) forces->setEnabled(!on);
  for (const Command command : kOfShownRecording) commands_[command].setEnabled(on);
  replay_.panel()->setVisible(on);
  Q_EMIT shownChanged(on);
  if (on) {
    replay_.panel()->setFocus();
    return;
  }
  touch_.forgetProbe();
  detail_.clearProbe();
  messages_.set(StatusField::recording, {});
  detail_.setFocus();
}

void ReplayController::offerRecordedMap(const QString& sentence) {
  const auto recording = replay_.waiting();
  if (recording->input.empty()) {
    messages_.show(sentence);
    return;
  }
  messages_.show(tr("%1 Nothing was changed.").arg(sentence),
                 {{tr("&Open its input"), [this] {
                     QStringList others{settings_.recentFiles()};
                     others << document_.file();
                     replay_.findInput(others);
                   }}});
}

// Logs of earlier versions name their scan and do not say how the map was made.
void ReplayController::openOld(const Project& project) {
  opening_.openNamed(project, replay_.waitingFile());
}

void ReplayController::openRecordedMap(const QString& file) {
  const auto recording = replay_.waiting();
  if (!recording) return;
  Project project;
  try {
    if (!recording->state.empty()) {
      project = projectFromState(recording->state, recording->name).value_or(Project{});
    }
  } catch (const Error& error) {
    replay_.forgetWaiting();
    messages_.show(shownError(error));
    return;
  }
  // Empty: not there; restoring says so and lets it be found by hand.
  project.file = file.isEmpty() ? recording->input : bytesOfPath(file);
  if (recording->state.empty() && !file.isEmpty()) {
    project.sha256 = recording->input_sha256;
    openOld(project);
  } else {
    opening_.restore(project, replay_.waitingFile());
  }
}

void ReplayController::showKind() {
  const bool is_h5 = ending() == QLatin1String("h5");
  commands_[is_h5 ? Command::record_h5 : Command::record_csv].setChecked(true);
}

}  // namespace relievo
