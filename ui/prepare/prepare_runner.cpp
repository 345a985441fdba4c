// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_runner.h"

#include <algorithm>

#include "ui/language/core_text.h"
#include "ui/language/error_text.h"
#include "ui/prepare/step_words.h"
#include "ui/work/pictures/scan_points.h"
#include "ui/work/surface_work.h"

namespace relievo {
namespace {

constexpr int kDelayMs = 250;  // Between the last change and the work.

}  // namespace

PrepareRunner::PrepareRunner(PrepareState& state) : state_(state) {
  delay_.setSingleShot(true);
  delay_.setInterval(kDelayMs);
  connect(&delay_, &QTimer::timeout, this, &PrepareRunner::compute);
  connect(&worker_, &LatestWorker::busyChanged, this, &PrepareRunner::busyChanged);
  connect(&worker_, &LatestWorker::progressed, this, [this](const QString& step, double fraction) {
    Q_EMIT progressed(wordsOfWork(step), fraction);
  });
}

PrepareRunner::~PrepareRunner() {
  worker_.disconnect();
}

// The child reports the kind of the step that it does.
QString PrepareRunner::wordsOfWork(const QString& step) const {
  for (const PrepareStep& known : state_.now().steps) {
    if (step == QLatin1String(kindOf(known.step).data())) return nameOfStep(known.step);
  }
  return coreText(step);
}

bool PrepareRunner::fitsChoices() const {
  return result_ && result_->recipe.steps.size() == result_->prepared.answer.steps.size() &&
         result_->choices == state_.now();
}

void PrepareRunner::begin(std::shared_ptr<const Scan> scan, const std::string& sha256) {
  // What is drawn of it is chosen in the worker, too.
  reading_ = true;
  const auto read = std::make_shared<std::shared_ptr<const ReadScan>>();
  worker_.start(
      [read, scan = std::move(scan), sha256](const Task& task) {
        outcomeOf([&] {
          *read = shownOf(scan, sha256, kMostShownPoints, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, read, input = state_.now().inputs.front()] {
        reading_ = false;
        if (*read) reads_.add(input, *read);
        compute();
      });
}

void PrepareRunner::compute() {
  delay_.stop();
  if (reading_) return;  // What is read then is prepared as it is chosen then.
  stale_ = true;
  const std::vector<std::size_t> used = state_.usedInputs();
  if (used.empty()) {
    Q_EMIT refused(tr("No scan is chosen. Tick one in the list of scans."));
    return;
  }
  for (const std::size_t i : used) {
    if (reads_.find(state_.now().inputs[i]) != nullptr) continue;
    readNext(i);
    return;
  }
  doSteps();
}

void PrepareRunner::stop() {
  reading_ = false;
  delay_.stop();
  worker_.cancel();
}

void PrepareRunner::readNext(std::size_t i) {
  struct Reading {
    std::shared_ptr<const ReadScan> scan;
    SurfaceOutcome outcome;
  };
  reading_ = true;
  const PrepareInput input = state_.now().inputs[i];
  const std::size_t most = kMostShownPoints / std::max<std::size_t>(1, state_.now().inputs.size());
  const auto reading = std::make_shared<Reading>();
  worker_.start(
      [reading, input, most](const Task& task) {
        reading->outcome = outcomeOf([&] {
          reading->scan = readScan(input, most, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, reading, input] {
        reading_ = false;
        if (reading->scan) {
          reads_.add(input, reading->scan);
          Q_EMIT scanRead();
          compute();
        } else if (!reading->outcome.cancelled) {
          Q_EMIT refused(shownError(reading->outcome.error, reading->outcome.code));
        }
      });
}

void PrepareRunner::doSteps() {
  struct Making {
    PrepareResult result;
    SurfaceOutcome outcome;
  };
  const auto making = std::make_shared<Making>();
  PrepareResult& r = making->result;
  r.choices = state_.now();
  r.recipe = state_.recipe();
  r.used = state_.usedInputs();
  for (const std::size_t i : r.used) r.scans.push_back(reads_.held(r.choices.inputs[i]));
  if (!result_) {  // Something to see while the steps are done.
    auto stored = std::make_shared<PrepareResult>(r);
    stored->prepared.answer.poses.resize(r.scans.size());
    result_ = stored;
    Q_EMIT scansShown();
  }
  worker_.start(
      [making](const Task& task) {
        making->outcome = outcomeOf([&] {
          std::vector<const Scan*> scans;
          for (const auto& scan : making->result.scans) scans.push_back(scan->scan.get());
          making->result.prepared = prepare(scans, making->result.recipe, {}, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, making] {
        if (making->outcome.cancelled) return;
        if (!making->outcome.error.isEmpty()) {
          Q_EMIT refused(shownError(making->outcome.error, making->outcome.code));
          return;
        }
        show(std::shared_ptr<const PrepareResult>(making, &making->result));
      });
}

void PrepareRunner::show(const std::shared_ptr<const PrepareResult>& made) {
  result_ = made;
  if (made->prepared.answer.align) {
    state_.keepPoses(made->choices, made->recipe, *made->prepared.answer.align);
  }
  stale_ = isWaiting();
  Q_EMIT this->made();
}

void PrepareRunner::write(const std::function<void(const Task&)>& work,
                          const std::function<void()>& then) {
  const auto outcome = std::make_shared<SurfaceOutcome>();
  worker_.start(
      [outcome, work](const Task& task) {
        *outcome = outcomeOf([&] {
          task.report("Writing the scan", 0);
          work(task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, outcome, then] {
        if (outcome->cancelled) return;
        if (outcome->error.isEmpty()) {
          then();
        } else {
          Q_EMIT writeRefused(shownError(outcome->error, outcome->code));
        }
      });
}

}  // namespace relievo
