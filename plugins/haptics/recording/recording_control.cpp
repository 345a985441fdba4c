// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/recording/recording_control.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QSignalBlocker>
#include <QThread>
#include <utility>

#include "core/base/failure.h"
#include "core/recording/log_note.h"
#include "haptics/loop/device_limits.h"
#include "haptics/record/events.h"
#include "plugins/haptics/recording/recording_file.h"
#include "plugins/haptics/shown_file.h"
#include "ui/message/message_text.h"

namespace relievo {

bool RecordingControl::isRunning() const {
  return device_.session() != nullptr && device_.session()->recorder().running();
}

void RecordingControl::setRecording(bool on) {
  LoopSession* const session = device_.session();
  if (session == nullptr) return;
  if (!on) {
    if (note_) note_->accept();  // What is written already is not lost.
    parts_.actions.note->setEnabled(false);
    session->stopRecording(loopLines(session->stats()) + window_lines_.toStdString());
    return;
  }
  try {
    start();
  } catch (const Error& error) {
    const QSignalBlocker blocker(parts_.actions.record);
    parts_.actions.record->setChecked(false);
    const bool of_file = dynamic_cast<const WriteError*>(&error) != nullptr;
    parts_.host.messages.showError(messageText(messageOf(error)),
                                   of_file ? QStringLiteral("E401") : QString());
  }
}

void RecordingControl::start() {
  const Recordings& of_host = parts_.host.recordings;
  const QDateTime now = QDateTime::currentDateTime();
  const QString file = proposedRecording(of_host.recordingFolder(), of_host.scanName(),
                                         of_host.recordingEnding(), now.date());
  const DeviceInfo& device = device_.session()->loop().device();
  const HapticOptions asked = hapticOptions(parts_.settings, parts_.forces_asked);
  const QString limited = QString::fromStdString(limitedText(asked, device));
  const QString header = recordingHeaderLines(
      of_host.recordingHeader(file) + (limited.isEmpty() ? QString() : "\nlimits " + limited),
      QString::fromStdString(device.name), withinDevice(asked, device),
      parts_.settings.feel.surface, firmness_.get(), now);
  const auto window = parts_.host.view.shownWindow();
  device_.session()->startRecording(QFile::encodeName(file).toStdString(), header.toStdString());
  folder_ = QFileInfo(file).path();
  window_lines_ = window ? windowLine(*window) : QString();
  parts_.actions.note->setEnabled(true);
  parts_.host.messages.announce(tr("Recording to %1").arg(shownFilePath(file)));
}

QString RecordingControl::folder() const {
  return isRunning() ? folder_ : parts_.host.recordings.recordingFolder();
}

void RecordingControl::addWindow(const RegionWindow& window) {
  if (isRunning()) window_lines_ += windowLine(window);
}

void RecordingControl::end() {
  if (!isRunning()) return;
  setRecording(false);
  constexpr unsigned long kLookMs = 5;
  constexpr int kMostLooks = 200;  // The drain answers within hundredths of a second.
  for (int i = 0; i < kMostLooks && isRunning(); ++i) {
    QThread::msleep(kLookMs);
    watch();
  }
}

namespace {

QString textOf(const RecordingEnd& failed) {
  return failed.message ? messageText(*failed.message) : QString::fromStdString(failed.error);
}

}  // namespace

void RecordingControl::tellFlight(const RecordingEnd& flight) {
  QString text = flight.error.empty()
                     ? tr("The last %1 before the fault are kept: %2")
                           .arg(durationText(flight.samples))
                           .arg(shownFilePath(QFile::decodeName(flight.file.c_str())))
                     : textOf(flight);
  if (!fault_.isEmpty()) text.prepend(std::exchange(fault_, {}) + QLatin1Char(' '));
  parts_.host.messages.announce(text, SaidBecause::noticed);
}

void RecordingControl::watch() {
  if (const auto flight = device_.session()->flight().written()) tellFlight(*flight);
  const std::optional<RecordingEnd> end = device_.session()->recorder().ended();
  if (!end) return;
  const QSignalBlocker blocker(parts_.actions.record);
  parts_.actions.record->setChecked(false);
  parts_.actions.note->setEnabled(false);
  if (note_) note_->accept();
  if (!end->error.empty()) {
    parts_.host.messages.announce(tr("The recording has ended early."), SaidBecause::noticed);
    parts_.host.messages.showError(textOf(*end), QStringLiteral("E401"));
    parts_.host.recordings.recordingSaved(
        QFile::decodeName(end->file.c_str()));  // What is there is complete.
    return;
  }
  parts_.host.recordings.recordingSaved(QFile::decodeName(end->file.c_str()));
  parts_.host.messages.announce(tr("Recording saved: %1, %2 samples in %3")
                                    .arg(durationText(end->samples))
                                    .arg(end->samples)
                                    .arg(shownFilePath(QFile::decodeName(end->file.c_str()))));
}

void RecordingControl::askNote() {
  if (!isRunning()) return;
  if (note_) {
    note_->raise();
    note_->activateWindow();
    return;
  }
  constexpr double kSecondsPerSample = 1e-3;
  const double time_s =
      kSecondsPerSample * static_cast<double>(device_.session()->recorder().samples());
  note_ = new NoteDialog(device_.session()->update().tick, time_s,
                         parts_.panel ? parts_.panel->window() : nullptr);
  note_->setAttribute(Qt::WA_DeleteOnClose);
  connect(note_, &QDialog::accepted, this, &RecordingControl::addNote);
  connect(note_, &QDialog::rejected, this, [this] { note_.clear(); });
  note_->show();
  note_->activateWindow();
}

void RecordingControl::addNote() {
  const NoteDialog* const note = std::exchange(note_, nullptr);
  if (note == nullptr || note->text().isEmpty() || device_.session() == nullptr) return;
  const QString text = note->text();
  const QString time = QLocale().toString(note->timeS(), 'f', 2);
  if (device_.session()->recorder().note(noteEvent(note->tick(), text.toStdString()))) {
    parts_.host.messages.announce(tr("Note at %1 s: %2").arg(time, text));
    Q_EMIT noted();
  } else {
    parts_.host.messages.showError(
        tr("The recording had ended before the note \"%1\" was added. The note is in "
           "no file.")
            .arg(text),
        {});
  }
}

}  // namespace relievo
