// SPDX-License-Identifier: BSD-3-Clause
// Whatever is thrown in a running window is said, and the window and its document go on.
#include "ui/window/guarded_application.h"

#include <array>
#include <cmath>
#include <fstream>
#include <QFile>
#include <QPainter>
#include <QTimer>
#include <QtTest/QTest>

#include "core/base/error.h"
#include "tests/ui/gui_fixture.h"
#include "ui/work/latest_worker.h"
#include "ui/work/work_queue.h"

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
    ASSERT_TRUE(waitFor([&] { return !document().loader().busy(); }));
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

using Points = std::vector<std::array<double, 3>>;

/// Points in the text of a format that has one: all numbers with all their digits.
QByteArray written(const QString& ending, const Points& points) {
  QByteArray text;
  const auto row = [](const std::array<double, 3>& p) {
    return QByteArray::number(p[0], 'g', 17) + ' ' + QByteArray::number(p[1], 'g', 17) + ' ' +
           QByteArray::number(p[2], 'g', 17) + '\n';
  };
  if (ending == QLatin1String("ply")) {
    text = "ply\nformat ascii 1.0\nelement vertex " +
           QByteArray::number(static_cast<int>(points.size())) +
           "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  }
  if (ending == QLatin1String("stl")) {
    text = "solid s\n";
    for (std::size_t i = 0; i < points.size(); ++i) {  // A triangle from every three neighbours.
      text += "facet normal 0 0 1\nouter loop\n";
      for (std::size_t k = 0; k < 3; ++k) text += "vertex " + row(points[(i + k) % points.size()]);
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid s\n";
  }
  for (const auto& p : points) text += row(p);
  return text;
}

/// Lines, planes, lone points, huge and tiny coordinates, one after the other in one window: a
/// picture or a sentence each, the window lives on, and nothing escapes. Small ones of each kind as
/// points, as a cloud with a header, and as triangles.
TEST_F(GuardTest, AnyScanGivesAPictureOrASentenceInOneRunningWindow) {
  const auto line = [](int count, const std::array<double, 3>& step) {
    Points points;
    for (int i = 0; i < count; ++i) points.push_back({step[0] * i, step[1] * i, step[2] * i});
    return points;
  };
  const auto plane = [](int count, double size, double at, const std::array<int, 3>& axes) {
    Points points;
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < count; ++k) {
        const std::array<double, 3> p{at + size * i / count, at + size * k / count, at};
        points.push_back({p[static_cast<std::size_t>(axes[0])],
                          p[static_cast<std::size_t>(axes[1])],
                          p[static_cast<std::size_t>(axes[2])]});
      }
    }
    return points;
  };
  const std::vector<std::pair<QString, Points>> shapes{
      {"one", {{1, 2, 3}}},
      {"two", {{0, 0, 0}, {1, 2, 3}}},
      {"three", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
      {"four", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
      {"same", Points(40, {5, 5, 5})},
      {"line_x", line(100, {1, 0, 0})},
      {"line_z", line(100, {0, 0, 1})},
      {"line_slanted", line(1000, {1, 2, 3})},
      {"line_fine", line(1000, {1e-9, 0, 0})},
      {"plane", plane(20, 20, 0, {0, 1, 2})},
      {"plane_upright", plane(20, 20, 0, {0, 2, 1})},
      {"plane_tiny", plane(12, 1e-12, 0, {0, 1, 2})},
      {"plane_huge", plane(12, 1e12, 0, {0, 1, 2})},
      {"plane_far", plane(12, 1, 5e6, {0, 1, 2})},
      {"plane_very_far", plane(12, 1, 1e15, {0, 1, 2})},
      {"plane_most", plane(4, 1e300, 0, {0, 1, 2})},
      {"strip", line(50, {0.001, 1, 0})}};
  int opened = 0, refused = 0;
  for (const auto& [name, points] : shapes) {
    for (const char* ending : {"xyz", "ply", "stl"}) {
      SCOPED_TRACE(name.toStdString() + "." + ending);
      const QString file = path(name + '.' + QLatin1String(ending));
      QFile out(file);
      ASSERT_TRUE(out.open(QIODevice::WriteOnly));
      out.write(written(QLatin1String(ending), points));
      out.close();
      const QString before = document().file();
      OpenRequest request;
      request.file = file;
      request.unit = LengthUnit::mm;
      window().open(request);
      ASSERT_TRUE(waitFor([&] { return !document().loader().busy(); }));
      QApplication::processEvents();
      ASSERT_TRUE(window().isVisible());
      if (document().file() == file) {
        ++opened;
        const Region& region = document().project().region;
        EXPECT_TRUE(std::isfinite(region.x_mm) && region.side_mm > 0);
        window().detailView().shot();
        window().referenceView().shot();
        window().runCommand("finer");
        window().runCommand("move_right");
        window().runCommand("stereo");
        window().detailView().shot();
        window().runCommand("stereo");
      } else {
        ++refused;
        EXPECT_EQ(document().file(), before) << "what was open stays";
        EXPECT_NE(window().message(), "");
      }
    }
  }
  EXPECT_EQ(opened + refused, 51);
  EXPECT_GE(opened, 15);
  EXPECT_EQ(told_.join('\n').toStdString(), "") << "nothing escaped";
}

}  // namespace
}  // namespace relievo
