// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/latest_worker.h"

#include <chrono>
#include <QWidget>

#include "core/base/background.h"

namespace relievo {
namespace {
constexpr auto kProgressPeriod = std::chrono::milliseconds(33);
}

LatestWorker::LatestWorker(QObject* parent) : QObject(parent) {}

LatestWorker::~LatestWorker() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void LatestWorker::start(Job job, Done done) {
  const bool was_busy = busy();
  wanted_ = ++last_id_;
  Request request{wanted_, std::move(job), std::move(done)};
  if (running_) {
    thread_.request_stop();
    pending_ = std::make_unique<Request>(std::move(request));
  } else {
    launch(std::move(request));
  }
  if (!was_busy) Q_EMIT busyChanged(true);
}

bool LatestWorker::cancel() {
  if (!busy()) return false;
  wanted_ = 0;
  pending_.reset();
  thread_.request_stop();
  Q_EMIT busyChanged(false);
  return true;
}

void LatestWorker::outliveJob(QWidget& closing) {
  cancel();
  if (!running_ || !closing.testAttribute(Qt::WA_DeleteOnClose)) return;
  closing.setAttribute(Qt::WA_DeleteOnClose, false);
  closing.setObjectName({});  // The next of its kind may be there before it is gone.
  connect(this, &LatestWorker::left, &closing, &QObject::deleteLater);
}

void LatestWorker::launch(Request request) {
  if (thread_.joinable()) thread_.join();
  running_ = true;
  thread_ = std::jthread([this, request = std::move(request)](std::stop_token stop) {
    workInBackground();
    Task task;
    task.stop = std::move(stop);
    auto last = std::chrono::steady_clock::time_point{};
    task.progress = [this, id = request.id, last](std::string_view step, double fraction) mutable {
      const auto now = std::chrono::steady_clock::now();
      if (now - last < kProgressPeriod) return;
      last = now;
      const QString text = QString::fromUtf8(step.data(), static_cast<int>(step.size()));
      QMetaObject::invokeMethod(
          this,
          [this, id, text, fraction] {
            if (id == wanted_) Q_EMIT progressed(text, fraction);
          },
          Qt::QueuedConnection);
    };
    std::exception_ptr fault;
    try {
      request.job(task);
    } catch (...) {
      fault = std::current_exception();
    }
    QMetaObject::invokeMethod(
        this,
        [this, id = request.id, done = request.done, fault] {
          turns_.schedule(this, [this, id, done, fault] { finish(id, done, fault); });
        },
        Qt::QueuedConnection);
  });
}

void LatestWorker::finish(std::uint64_t id, const Done& done, const std::exception_ptr& fault) {
  running_ = false;
  if (pending_) launch(std::move(*std::exchange(pending_, nullptr)));
  if (id == wanted_) {  // Else cancelled, or a newer job took its place.
    wanted_ = 0;
    Q_EMIT busyChanged(false);
    if (!fault) done();
  }
  if (!running_) Q_EMIT left();
  // Told where everything is told (guarded_application.h); nobody could tell it in the thread.
  if (fault) std::rethrow_exception(fault);
}

}  // namespace relievo
