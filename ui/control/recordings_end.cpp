// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/recordings_end.h"

#include <QAction>
#include <utility>

#include "ui/dialogs/video_control.h"
#include "ui/work/work_queue.h"

namespace relievo {

RecordingsEnd::RecordingsEnd(VideoControl& video, WorkQueue& noting, QObject* parent)
    : QObject(parent), video_(video), noting_(noting) {
  // In their own turns: whoever told it goes on first.
  connect(&noting_, &WorkQueue::busyChanged, this, &RecordingsEnd::goOnIfEnded,
          Qt::QueuedConnection);
  connect(&video_, &VideoControl::ended, this, &RecordingsEnd::goOnIfEnded, Qt::QueuedConnection);
  connect(&video_, &VideoControl::failed, this, &RecordingsEnd::forget);
  connect(&video_, &VideoControl::said, this, [this](const QString& text) {
    if (ending()) words_ << text;
  });
}

bool RecordingsEnd::endFirst(QAction* record, std::function<void()> then) {
  const bool was_ending = ending();
  const bool records = record != nullptr && record->isChecked();
  awaited_ = awaited_ || records || runs_;
  if (!awaited_ && !video_.live() && !noting_.busy()) {
    then_ = nullptr;
    return false;
  }
  if (!was_ending) words_.clear();
  then_ = std::move(then);
  if (records) record->setChecked(false);
  video_.stopLive();
  return true;
}

void RecordingsEnd::noteSaved(const QString& name) {
  awaited_ = runs_ = false;
  if (ending()) words_ << tr("Recording saved: %1").arg(name);
  QMetaObject::invokeMethod(this, &RecordingsEnd::goOnIfEnded, Qt::QueuedConnection);
}

void RecordingsEnd::noteRunning(bool running) {
  runs_ = running;
  if (running || !std::exchange(awaited_, false)) return;
  QMetaObject::invokeMethod(this, &RecordingsEnd::goOnIfEnded, Qt::QueuedConnection);
}

QString RecordingsEnd::takeWords() {
  return std::exchange(words_, {}).join(QStringLiteral(". "));
}

void RecordingsEnd::goOnIfEnded() {
  if (!ending() || awaited_ || video_.live() || noting_.busy()) return;
  std::exchange(then_, nullptr)();
}

}  // namespace relievo
