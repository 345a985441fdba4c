// SPDX-License-Identifier: BSD-3-Clause
// Whatever is thrown in a running window is said, and the window and its document go on.
#include "ui/guarded_application.h"

#include <fstream>
#include <QFile>
#include <QPainter>
#include <QTimer>
#include <QtTest/QTest>

#include "core/base/error.h"
#include "tests/ui/gui_fixture.h"
#include "ui/latest_worker.h"
#include "ui/work_queue.h"

namespace relievo {
namespace {

class GuardTest : public GuiTest {
 protected:
  GuardTest() {
    app().tellTo([this](const QString& sentence) {
      told_ << sentence;
      window().showMessage(sentence);
    });
  }
  ~GuardTest() override {
    app().tellTo([](const QString& sentence) { ADD_FAILURE() << sentence.toStdString(); });
  }
  static GuardedApplication& app() { return *static_cast<GuardedApplication*>(qApp); }

  QStringList told_;
};

TEST_F(GuardTest, WhatASlotThrowsIsSaidAndTheDocumentStays) {
  openRelief();
  const auto surface = document().surface();
  QTimer::singleShot(0, [] { throw ArgumentError("made for this test"); });
  ASSERT_TRUE(waitFor([&] { return told_.size() == 1; }));
  EXPECT_TRUE(told_[0].contains("made for this test")) << told_[0].toStdString();
  EXPECT_EQ(window().message(), told_[0]);
  EXPECT_EQ(document().surface(), surface);
  QTimer::singleShot(0, [] { throw 7; });  // Nothing that anybody should throw.
  ASSERT_TRUE(waitFor([&] { return told_.size() == 2; }));
  QTimer::singleShot(0, [] { throw std::bad_alloc(); });
  ASSERT_TRUE(waitFor([&] { return told_.size() == 3; }));
  EXPECT_TRUE(told_[2].contains("memory")) << told_[2].toStdString();
  EXPECT_TRUE(window().isVisible());
}

class BadPaint : public QWidget {
 public:
  int paints = 0;

 private:
  void paintEvent(QPaintEvent* /*event*/) override {
    ++paints;
    throw std::runtime_error("no picture");
  }
};

TEST_F(GuardTest, APaintThatFailsOftenIsSaidOnce) {
  BadPaint widget;
  widget.show();
  ASSERT_TRUE(waitFor([&] { return !told_.isEmpty(); }));
  for (int i = 0; i < 5; ++i) {
    widget.repaint();
    QTest::qWait(5);
  }
  EXPECT_GE(widget.paints, 5);
  EXPECT_EQ(told_.size(), 1);
}

TEST_F(GuardTest, WhatAWorkerThrowsIsSaidAndItWorksOn) {
  LatestWorker worker;
  bool done = false;
  worker.start([](const Task&) { throw std::runtime_error("in the thread"); },
               [&] { done = true; });
  ASSERT_TRUE(waitFor([&] { return told_.size() == 1; }));
  EXPECT_TRUE(told_[0].contains("in the thread"));
  EXPECT_FALSE(done);
  EXPECT_FALSE(worker.busy());
  worker.start([](const Task&) {}, [&] { done = true; });
  EXPECT_TRUE(waitFor([&] { return done; }));

  WorkQueue queue;
  int ends = 0;
  queue.add([](const Task&) { throw std::runtime_error("in the queue"); }, [&] { ++ends; });
  queue.add([](const Task&) {}, [&] { ++ends; });
  ASSERT_TRUE(waitFor([&] { return !queue.busy(); }));
  EXPECT_TRUE(waitFor([&] { return told_.size() == 2 && ends == 1; }));
}

/// Scans too thin for a surface, one after the other in one window: a picture or a sentence each.
TEST_F(GuardTest, ThinScansOpenOrAreRefusedInARunningWindow) {
  openRelief();
  const std::vector<std::pair<std::string, std::string>> files{
      {"line_x", "0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n"},
      {"line_z", "0 0 0\n0 0 1\n0 0 2\n0 0 3\n"},
      {"slanted", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n"},
      {"four", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"},
      {"two", "0 0 0\n1 2 3\n"},
      {"one", "5 5 5\n"},
      {"same", "5 5 5\n5 5 5\n5 5 5\n"},
      {"tiny", "0 0 0\n1e-30 0 0\n0 1e-30 0\n1e-30 1e-30 1e-30\n"},
      {"huge", "0 0 0\n1e30 0 0\n0 1e30 0\n1e30 1e30 1e30\n"}};
  int opened = 0;
  for (const auto& [name, rows] : files) {
    SCOPED_TRACE(name);
    const QString file = path(QString::fromStdString(name) + ".xyz");
    std::ofstream(QFile::encodeName(file).toStdString()) << rows;
    OpenRequest request;
    request.file = file;
    request.unit = LengthUnit::mm;
    window().open(request);
    ASSERT_TRUE(waitFor([&] { return !document().busy(); }));
    QTest::qWait(50);  // Its pictures are drawn.
    if (document().file() == file) {
      ++opened;
      EXPECT_GE(std::min(document().surface()->map.frame.size.cols,
                         document().surface()->map.frame.size.rows),
                2);
    } else {
      EXPECT_NE(window().message(), "");
    }
    ASSERT_TRUE(document().isOpen());
  }
  EXPECT_GE(opened, 3);
  EXPECT_EQ(told_.join('\n').toStdString(), "");
}

}  // namespace
}  // namespace relievo
