// SPDX-License-Identifier: BSD-3-Clause
// The plugin's part in recordings: start, end, and notes into them.
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
#include "plugins/haptics/haptics_plugin.h"
#include "plugins/haptics/recording/recording_file.h"
#include "plugins/haptics/shown_file.h"
#include "ui/message/message_text.h"

namespace relievo {

void HapticsPlugin::setRecording(bool on) {
  if (!session_) return;
  if (!on) {
    if (note_) note_->accept();  // What is written already is not lost.
    actions_.note->setEnabled(false);
    session_->stopRecording(loopLines(session_->stats()) + recorded_windows_.toStdString());
    return;
  }
  try {
    const QDateTime now = QDateTime::currentDateTime();
    const QString file =
        proposedRecording(host_->recordings.recordingFolder(), host_->recordings.scanName(),
                          host_->recordings.recordingEnding(), now.date());
    const DeviceInfo& device = session_->loop().device();
    const HapticOptions asked = hapticOptions(settings_, forces_asked_);
    const QString limited = QString::fromStdString(limitedText(asked, device));
    const QString header = recordingHeaderLines(
        host_->recordings.recordingHeader(file) +
            (limited.isEmpty() ? QString() : "\nlimits " + limited),
        QString::fromStdString(device.name), withinDevice(asked, device), settings_.feel.surface,
        firmness_fits_ ? firmness_.get() : nullptr, now);
    const auto window = host_->view.shownWindow();
    session_->startRecording(QFile::encodeName(file).toStdString(), header.toStdString());
    recorded_in_ = QFileInfo(file).path();
    recorded_windows_ = window ? windowLine(*window) : QString();
    actions_.note->setEnabled(true);
    host_->messages.announce(tr("Recording to %1").arg(shownFilePath(file)));
  } catch (const Error& error) {
    const QSignalBlocker blocker(actions_.record);
    actions_.record->setChecked(false);
    const bool of_file = dynamic_cast<const WriteError*>(&error) != nullptr;
    host_->messages.showError(messageText(messageOf(error)),
                              of_file ? QStringLiteral("E401") : QString());
  }
}

QString HapticsPlugin::folderOfRecording() const {
  return session_ && session_->recorder().running() ? recorded_in_
                                                    : host_->recordings.recordingFolder();
}

void HapticsPlugin::endRecording() {
  if (!session_ || !session_->recorder().running()) return;
  setRecording(false);
  constexpr unsigned long kLookMs = 5;
  constexpr int kMostLooks = 200;  // The drain answers within hundredths of a second.
  for (int i = 0; i < kMostLooks && session_->recorder().running(); ++i) {
    QThread::msleep(kLookMs);
    watchRecording();
  }
}

namespace {

QString textOf(const RecordingEnd& failed) {
  return failed.message ? messageText(*failed.message) : QString::fromStdString(failed.error);
}

}  // namespace

void HapticsPlugin::watchRecording() {
  if (const std::optional<RecordingEnd> flight = session_->flight().written()) {
    host_->messages.announce(flight->error.empty()
                                 ? tr("The last %1 before the fault are kept: %2")
                                       .arg(durationText(flight->samples))
                                       .arg(shownFilePath(QFile::decodeName(flight->file.c_str())))
                                 : textOf(*flight),
                             SaidBecause::noticed);
  }
  const std::optional<RecordingEnd> end = session_->recorder().ended();
  if (!end) return;
  const QSignalBlocker blocker(actions_.record);
  actions_.record->setChecked(false);
  actions_.note->setEnabled(false);
  if (note_) note_->accept();
  if (!end->error.empty()) {
    host_->messages.announce(tr("The recording has ended early."), SaidBecause::noticed);
    host_->messages.showError(textOf(*end), QStringLiteral("E401"));
    host_->recordings.recordingSaved(
        QFile::decodeName(end->file.c_str()));  // What is there is complete.
    return;
  }
  host_->recordings.recordingSaved(QFile::decodeName(end->file.c_str()));
  host_->messages.announce(tr("Recording saved: %1, %2 samples in %3")
                               .arg(durationText(end->samples))
                               .arg(end->samples)
                               .arg(shownFilePath(QFile::decodeName(end->file.c_str()))));
}

void HapticsPlugin::askNote() {
  if (!session_ || !session_->recorder().running()) return;
  if (note_) {
    note_->raise();
    note_->activateWindow();
    return;
  }
  constexpr double kSecondsPerSample = 1e-3;
  const double time_s = kSecondsPerSample * static_cast<double>(session_->recorder().samples());
  note_ = new NoteDialog(session_->update().tick, time_s, panel_ ? panel_->window() : nullptr);
  note_->setAttribute(Qt::WA_DeleteOnClose);
  connect(note_, &QDialog::accepted, this, &HapticsPlugin::addNote);
  connect(note_, &QDialog::rejected, this, [this] { note_.clear(); });
  note_->show();
  note_->activateWindow();
}

void HapticsPlugin::addNote() {
  const NoteDialog* const note = std::exchange(note_, nullptr);
  if (note == nullptr || note->text().isEmpty() || !session_) return;
  const QString text = note->text();
  const QString time = QLocale().toString(note->timeS(), 'f', 2);
  if (session_->recorder().note(noteEvent(note->tick(), text.toStdString()))) {
    host_->messages.announce(tr("Note at %1 s: %2").arg(time, text));
  } else {
    host_->messages.showError(
        tr("The recording had ended before the note \"%1\" was added. The note is in "
           "no file.")
            .arg(text),
        {});
  }
}

}  // namespace relievo
