// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/latest_worker.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <QApplication>
#include <QDialog>
#include <QPointer>
#include <semaphore>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

/// A job that hears of no cancel until somebody opens the gate, as a driver that compiles a shader.
struct DeafJob {
  std::binary_semaphore inside{0}, gate{0};
  std::atomic<bool> stopped = false;
  LatestWorker::Job job() {
    return [this](const Task& task) {
      inside.release();
      gate.acquire();
      stopped = task.stop.stop_requested();
    };
  }
};

TEST(LatestWorker, CancelAnswersWhileTheJobIsStillInside) {
  DeafJob deaf;
  LatestWorker worker;
  bool told = false, left = false;
  QObject::connect(&worker, &LatestWorker::left, [&] { left = true; });
  worker.start(deaf.job(), [&] { told = true; });
  deaf.inside.acquire();
  EXPECT_TRUE(worker.cancel());
  EXPECT_FALSE(worker.busy());
  EXPECT_TRUE(worker.running());
  EXPECT_FALSE(left);
  deaf.gate.release();
  ASSERT_TRUE(waitFor([&] { return left; }));
  EXPECT_FALSE(worker.running());
  EXPECT_TRUE(deaf.stopped);
  EXPECT_FALSE(told) << "what comes of a cancelled job is dropped";
}

TEST(LatestWorker, AJobAskedForAfterCancelWaitsForTheOneInside) {
  DeafJob deaf;
  LatestWorker worker;
  worker.start(deaf.job(), [] {});
  deaf.inside.acquire();
  worker.cancel();
  std::atomic<bool> after_the_first = false;
  bool told = false;
  int busy_changes = 0;
  QObject::connect(&worker, &LatestWorker::busyChanged, [&](bool) { ++busy_changes; });
  worker.start([&](const Task&) { after_the_first = deaf.stopped.load(); }, [&] { told = true; });
  EXPECT_TRUE(worker.busy());
  deaf.gate.release();
  ASSERT_TRUE(waitFor([&] { return told; }));
  EXPECT_TRUE(after_the_first);
  EXPECT_EQ(busy_changes, 2);
}

TEST(LatestWorker, ADialogThatClosesGoesOnceItsJobHasLeft) {
  DeafJob deaf;
  struct Dialog : QDialog {
    LatestWorker worker;
    void done(int result) override {
      worker.outliveJob(*this);
      QDialog::done(result);
    }
  };
  QPointer<Dialog> dialog = new Dialog;
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
  dialog->worker.start(deaf.job(), [] {});
  deaf.inside.acquire();
  dialog->reject();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  ASSERT_FALSE(dialog.isNull()) << "its destructor would wait for the job";
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_FALSE(dialog->worker.busy());
  deaf.gate.release();
  EXPECT_TRUE(waitFor([&] { return dialog.isNull(); }));
}

TEST(LatestWorker, WorksInTheBackground) {
  const int before = ::getpriority(PRIO_PROCESS, 0);
  if (before >= 5) GTEST_SKIP() << "this process already runs in the background";
  LatestWorker worker;
  int inside = before;
  bool done = false;
  worker.start([&](const Task&) { inside = ::getpriority(PRIO_PROCESS, 0); }, [&] { done = true; });
  ASSERT_TRUE(waitFor([&] { return done; }));
  EXPECT_GT(inside, before) << "the window's drawing waits for it";
}

TEST(LatestWorker, TheEndOfTheProgramWaitsForTheJob) {
  DeafJob deaf;
  {
    LatestWorker worker;
    worker.start(deaf.job(), [] {});
    deaf.inside.acquire();
    worker.cancel();
    deaf.gate.release();
  }
  EXPECT_TRUE(deaf.stopped);
}

}  // namespace
}  // namespace relievo
