// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <QObject>
#include <QTimer>

#include "ui/prepare/prepare_state.h"
#include "ui/prepare/prepare_work.h"
#include "ui/prepare/read_scans.h"
#include "ui/work/latest_worker.h"

namespace relievo {

/// Reads the scans that are chosen, does the steps, and writes what they gave: one after the other,
/// in a worker. A newer change stops older work. [GUI thread]
class PrepareRunner : public QObject {
  Q_OBJECT
 public:
  explicit PrepareRunner(PrepareState& state);
  ~PrepareRunner() override;

  const ReadScans& reads() const { return reads_; }
  /// Of the choices on show; null: no scan was read yet. As stored until the steps are done.
  const std::shared_ptr<const PrepareResult>& result() const { return result_; }
  /// The result is of the choices as they are now, all steps done.
  bool fitsChoices() const;
  /// The result is of other choices, or still being made.
  bool isStale() const { return stale_; }
  bool isBusy() const { return worker_.busy(); }
  /// A change waits for computeSoon().
  bool isWaiting() const { return delay_.isActive(); }

  /// Begins with a scan in memory, which is that of the first input.
  void begin(std::shared_ptr<const Scan> scan, const std::string& sha256);
  void noteChange() { stale_ = true; }
  /// After a moment without further changes.
  void computeSoon() { delay_.start(); }
  void compute();
  void stop();
  /// Runs `work` in the worker; then `then`, or writeRefused().
  void write(const std::function<void(const Task&)>& work, const std::function<void()>& then);
  /// As LatestWorker has it.
  void outliveJob(QWidget& closing) { worker_.outliveJob(closing); }

 Q_SIGNALS:
  void scanRead();    ///< One more of reads().
  void scansShown();  ///< result() is the scans as stored, while the steps are done.
  void made();        ///< result() is another one, made by all steps.
  void refused(const QString& sentence);
  void writeRefused(const QString& sentence);
  void busyChanged(bool busy);
  /// @param step  in words of the window
  void progressed(const QString& step, double fraction);

 private:
  void readNext(std::size_t input);
  void doSteps();
  void show(const std::shared_ptr<const PrepareResult>& made);
  QString wordsOfWork(const QString& step) const;

  PrepareState& state_;
  ReadScans reads_;
  std::shared_ptr<const PrepareResult> result_;
  bool stale_ = true, reading_ = false;
  QTimer delay_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
