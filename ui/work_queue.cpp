// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work_queue.h"

#include <utility>

namespace relievo {

WorkQueue::WorkQueue(QObject* parent) : QObject(parent) {
  connect(&worker_, &LatestWorker::progressed, this, &WorkQueue::progressed);
}

void WorkQueue::add(LatestWorker::Job job, LatestWorker::Done done) {
  const bool was_busy = busy();
  waiting_.push_back({std::move(job), std::move(done)});
  if (was_busy) return;
  Q_EMIT busyChanged(true);
  startNext();
}

bool WorkQueue::cancel() {
  if (!busy()) return false;
  waiting_.clear();
  worker_.cancel();
  Q_EMIT busyChanged(false);
  return true;
}

void WorkQueue::startNext() {
  Work next = std::move(waiting_.front());
  waiting_.pop_front();
  worker_.start(std::move(next.job), [this, done = std::move(next.done)] {
    if (waiting_.empty()) {
      Q_EMIT busyChanged(false);
    } else {
      startNext();
    }
    done();
  });
}

}  // namespace relievo
