// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QObject>
#include <QStringList>

class QAction;

namespace relievo {

class VideoControl;
class WorkQueue;

/// Ends what is being recorded before the scan that it shows goes: a recording of the touch, and a
/// video of the view. Both are on the disk then, and the work knows of the recording. [GUI thread]
class RecordingsEnd : public QObject {
  Q_OBJECT
 public:
  /// @param noting  where saved recordings are added to the work
  RecordingsEnd(VideoControl& video, WorkQueue& noting, QObject* parent);

  /// @param record  the command that starts and ends recordings; null: there is none
  /// @param then    once all of it is on the disk; the last asked for counts
  /// @return false: nothing runs; `then` is forgotten
  bool endFirst(QAction* record, std::function<void()> then);
  bool ending() const { return then_ != nullptr; }
  /// What was asked for last is not done: something could not be written, which has to be read
  /// first, or another scan is opened, or somebody changed their mind.
  void forget() { then_ = nullptr; }

  /// A recording is on the disk.
  void noteSaved(const QString& name);
  /// As the loop says; half a second old at most.
  void noteRunning(bool running);
  /// What was saved since it was asked last, in sentences.
  QString takeWords();

 private:
  void goOnIfEnded();

  VideoControl& video_;
  WorkQueue& noting_;
  bool runs_ = false;     ///< As it was told last.
  bool awaited_ = false;  ///< A recording that was asked to end.
  QStringList words_;
  std::function<void()> then_;
};

}  // namespace relievo
