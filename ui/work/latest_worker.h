// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <QObject>
#include <QString>
#include <thread>

#include "core/base/task.h"
#include "ui/work/scheduling/render_scheduler.h"

class QWidget;

namespace relievo {

/// Runs one job at a time off the GUI thread. A newer job, or cancel(), stops the older one; its
/// end is then not told. [GUI thread]
class LatestWorker : public QObject {
  Q_OBJECT
 public:
  using Job = std::function<void(const Task&)>;  ///< [worker] Checks its Task; what it throws, the
                                                 ///< GUI thread throws in place of Done.
  using Done = std::function<void()>;            ///< [GUI thread] After the job, unless stopped.

  explicit LatestWorker(QObject* parent = nullptr);
  ~LatestWorker() override;

  void start(Job job, Done done);
  /// @return false: nothing was running
  bool cancel();
  bool busy() const { return wanted_ != 0; }
  /// Is a job still on its way out, wanted or not? A driver that compiles a shader hears of no
  /// cancel, so this may last some tenths of a second after one. The destructor waits for it.
  bool running() const { return running_; }
  /// For a dialog that closes and would be deleted (Qt::WA_DeleteOnClose): cancels, and lets it
  /// live unseen until the job has left, so that its end holds nobody up.
  void outliveJob(QWidget& closing);

 Q_SIGNALS:
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);  ///< At most 30 times a second.
  void left();                                            ///< Nothing is running any more.

 private:
  struct Request {
    std::uint64_t id = 0;
    Job job;
    Done done;
  };
  void launch(Request request);
  void finish(std::uint64_t id, const Done& done, const std::exception_ptr& fault);

  std::uint64_t last_id_ = 0;
  std::uint64_t wanted_ = 0;  ///< The one whose end is waited for; 0: none.
  bool running_ = false;
  std::unique_ptr<Request> pending_;
  RenderScheduler turns_;  ///< Of results, which may take long to show.
  std::jthread thread_;
};

}  // namespace relievo
