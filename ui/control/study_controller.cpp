// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/study_controller.h"

#include <QAction>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>

#include "core/base/error.h"
#include "core/provenance/program.h"
#include "ui/control/look_controller.h"
#include "ui/dialogs/study_dialog.h"
#include "ui/language/error_text.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

std::string nowUtc() {
  return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

}  // namespace

StudyController::StudyController(const ControllerParts& parts, LookController& look)
    : Controller(parts), look_(look) {
  commands_.on(Command::study, this, [this] { ask(); });
  commands_.on(Command::study_next, this, [this] { next(); });
  commands_.on(Command::study_end, this, [this] { end(); });
  connect(&document_, &Document::surfaceChanged, this, [this] {
    // Another object has none of the conditions.
    if (sitting_ && !document_.isOpen()) end();
    enableCommands();
  });
  connect(&document_, &Document::opened, this, [this] {
    if (sitting_) end();
  });
  enableCommands();
}

QString StudyController::folder() const {
  return QFile::decodeName(sitting_->folder.c_str());
}

QString StudyController::recordingName() const {
  const TrialRecord& trial = sitting_->trials.back();
  return QStringLiteral("trial_%1_%2")
      .arg(trial.number, 2, 10, QLatin1Char('0'))
      .arg(QString::fromStdString(trial.blinded));
}

void StudyController::ask() {
  if (!document_.isOpen() || sitting_) return;
  QStringList places;
  for (const NamedRegion& place : document_.project().places) {
    if (!place.is_point) places << QString::fromStdString(place.name);
  }
  auto* dialog = new StudyDialog(places, studies_folder_ ? studies_folder_() : QString(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &StudyDialog::chosen, this, &StudyController::begin);
  dialog->open();
}

void StudyController::begin(const Study& study, const QString& folder) {
  if (!document_.isOpen() || sitting_) return;
  try {
    Sitting sitting;
    sitting.study = study;
    sitting.study.seed = seed_.value_or(QRandomGenerator::system()->generate64());
    sitting.order = trialsOf(sitting.study);
    for (const std::string& name : study.conditions) {
      for (const NamedRegion& place : document_.project().places) {
        if (place.name == name) sitting.places.push_back(place);
      }
    }
    if (sitting.places.size() != study.conditions.size()) return;  // A place went meanwhile.
    sitting.folder = makeSittingFolder(QFile::encodeName(folder).toStdString(), study.participant);
    const Project& project = document_.project();
    writeSitting(sitting.folder, sitting.study,
                 {.program = "relievo " + std::string(programVersion()),
                  .input = std::filesystem::path(project.file).filename().string(),
                  .sha256 = project.sha256,
                  .started_utc = nowUtc()});
    sitting_ = std::move(sitting);
  } catch (const Error& error) {
    messages_.show(shownError(error));
    return;
  }
  showTrial();
}

void StudyController::next() {
  if (!sitting_) return;
  if (is_recording_) {
    announce(tr("Stop the recording first (Ctrl+R): it belongs to this condition."));
    return;
  }
  if (sitting_->trials.size() == sitting_->order.size()) return end();
  showTrial();
}

void StudyController::showTrial() {
  Sitting& s = *sitting_;
  if (!s.trials.empty()) s.trials.back().ended_utc = nowUtc();
  const StudyTrial& trial = s.order[s.trials.size()];
  s.trials.push_back({.number = static_cast<int>(s.trials.size()) + 1,
                      .blinded = trial.blinded,
                      .began_utc = nowUtc(),
                      .ended_utc = {},
                      .recordings = {}});
  if (!keepTrials()) return;
  const QString words = tr("Condition %1").arg(QString::fromStdString(trial.blinded));
  const NamedRegion& place = s.places[trial.condition];
  if (place.view) look_.showView(*place.view, words);
  document_.region().goTo(place.region, place.gain, words);
  enableCommands();
  announce(tr("Condition %1, %2 of %3.")
               .arg(QString::fromStdString(trial.blinded))
               .arg(s.trials.size())
               .arg(s.order.size()));
}

void StudyController::noteRecording(const QString& file) {
  if (!sitting_ || QFileInfo(file).absolutePath() != QFileInfo(folder()).absoluteFilePath()) return;
  sitting_->trials.back().recordings.push_back(
      QFile::encodeName(QFileInfo(file).fileName()).toStdString());
  keepTrials();
}

/// False, and the sitting has ended, if the disk has no room for it: a trial that is in no file was
/// none.
bool StudyController::keepTrials() {
  try {
    writeTrials(sitting_->folder, sitting_->trials);
    return true;
  } catch (const Error& error) {
    sitting_.reset();
    enableCommands();
    messages_.show(shownError(error));
    return false;
  }
}

void StudyController::end() {
  if (!sitting_) return;
  if (is_recording_) {
    announce(tr("Stop the recording first (Ctrl+R): it belongs to this condition."));
    return;
  }
  sitting_->trials.back().ended_utc = nowUtc();
  if (!keepTrials()) return;
  const bool whole = sitting_->trials.size() == sitting_->order.size();
  const QString where = shownPath(folder());
  const int shown = static_cast<int>(sitting_->trials.size());
  const int all = static_cast<int>(sitting_->order.size());
  sitting_.reset();
  enableCommands();
  announce(whole ? tr("All %1 conditions were shown. The sitting is in %2.").arg(all).arg(where)
                 : tr("The sitting ended after %1 of %2 conditions. It is in %3.")
                       .arg(shown)
                       .arg(all)
                       .arg(where));
}

void StudyController::enableCommands() {
  commands_[Command::study].setEnabled(document_.isOpen() && !sitting_);
  commands_[Command::study_next].setEnabled(running());
  commands_[Command::study_end].setEnabled(running());
}

}  // namespace relievo
