// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/work_queue.h"

#include <exception>
#include <memory>
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
  const auto fault = std::make_shared<std::exception_ptr>();
  worker_.start(
      [job = std::move(next.job), fault](const Task& task) {
        try {
          job(task);
        } catch (...) {
          *fault = std::current_exception();  // The others go on.
        }
      },
      [this, done = std::move(next.done), fault] {
        if (waiting_.empty()) {
          Q_EMIT busyChanged(false);
        } else {
          startNext();
        }
        if (*fault) std::rethrow_exception(*fault);
        done();
      });
}

}  // namespace relievo
