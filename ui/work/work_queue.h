// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <QObject>

#include "ui/work/latest_worker.h"

namespace relievo {

/// Runs jobs off the GUI thread, one after the other; none takes another one's place. [GUI thread]
class WorkQueue : public QObject {
  Q_OBJECT
 public:
  explicit WorkQueue(QObject* parent = nullptr);

  void add(LatestWorker::Job job, LatestWorker::Done done);
  /// Stops the one that runs and forgets those that wait; their ends are not told.
  /// @return false: there was nothing to do
  bool cancel();
  bool busy() const { return worker_.busy() || !waiting_.empty(); }

 Q_SIGNALS:
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);

 private:
  struct Work {
    LatestWorker::Job job;
    LatestWorker::Done done;
  };
  void startNext();

  std::deque<Work> waiting_;
  LatestWorker worker_;
};

}  // namespace relievo
