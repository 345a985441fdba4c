// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/scope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

namespace relievo {
namespace {

/// Every 5 ms, as the panel gets them: a ramp of force, so that each sample is another.
std::vector<PlotSample> samples(int from, int count) {
  std::vector<PlotSample> made;
  for (int i = from; i < from + count; ++i) {
    made.push_back({0.005 * i, std::sin(0.01 * i), 1 + std::sin(0.01 * i), 0.001 * i});
  }
  return made;
}

void wheel(QWidget& widget, int steps) {
  QWheelEvent event(QPointF(10, 10), widget.mapToGlobal(QPoint(10, 10)), {}, {0, 120 * steps},
                    Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

TEST(Scope, ShowsTheLastSecondsUntilItIsPaused) {
  ScopeDialog scope(nullptr);
  scope.add(samples(0, 2000));  // 10 s.
  EXPECT_NEAR(scope.view().shown().back().t_s - scope.view().shown().front().t_s, 5, 0.01);
  EXPECT_EQ(scope.view().shown().back().t_s, 0.005 * 1999);
  scope.findChild<QAction*>("scopePause")->trigger();
  scope.add(samples(2000, 100));
  EXPECT_EQ(scope.view().shown().back().t_s, 0.005 * 1999) << "held still";
  scope.findChild<QAction*>("scopePause")->trigger();
  EXPECT_EQ(scope.view().shown().back().t_s, 0.005 * 2099) << "goes on with what came meanwhile";
}

TEST(Scope, ZoomsWithWheelKeysAndCommandsWithinItsLimits) {
  ScopeDialog scope(nullptr);
  scope.show();
  scope.add(samples(0, 8000));
  const double before = scope.view().spanS();
  wheel(scope.view(), 1);
  const double by_wheel = scope.view().spanS();
  EXPECT_LT(by_wheel, before);
  QTest::keyClick(&scope.view(), Qt::Key_Minus);
  EXPECT_GT(scope.view().spanS(), by_wheel);
  for (int i = 0; i < 30; ++i) scope.findChild<QAction*>("scopeZoomOut")->trigger();
  EXPECT_EQ(scope.view().spanS(), ScopeView::kMostSpanS);
  for (int i = 0; i < 30; ++i) QTest::keyClick(&scope.view(), Qt::Key_Plus);
  for (int i = 0; i < 30; ++i) scope.findChild<QAction*>("scopeZoomIn")->trigger();
  EXPECT_EQ(scope.view().spanS(), ScopeView::kLeastSpanS);
}

TEST(Scope, TheCursorsValuesAreText) {
  ScopeDialog scope(nullptr);
  scope.show();
  EXPECT_EQ(scope.findChild<QLabel*>("scopeValues")->text(), "Nothing measured yet.");
  scope.add(samples(0, 1000));
  scope.findChild<QAction*>("scopePause")->trigger();
  QTest::keyClick(&scope.view(), Qt::Key_Left);
  const QString text = scope.findChild<QLabel*>("scopeValues")->text();
  EXPECT_EQ(text, "At 4.990 s: hand -0.527 mm, proxy 0.473 mm, force 0.998 N")
      << text.toStdString();
  QTest::keyClick(&scope.view(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_TRUE(scope.view().cursorText().contains("force 0.978 N"));
}

TEST(Scope, ExportsWhatIsShown) {
  QTemporaryDir folder;
  ScopeDialog scope(nullptr);
  scope.add(samples(0, 2000));
  const QString csv = folder.filePath("scope.csv"), svg = folder.filePath("scope.svg");
  EXPECT_EQ(scope.exportTo(csv), QString());
  EXPECT_EQ(scope.exportTo(svg), QString());
  QFile table(csv);
  ASSERT_TRUE(table.open(QIODevice::ReadOnly));
  const QStringList lines = QString::fromUtf8(table.readAll()).split('\n', Qt::SkipEmptyParts);
  EXPECT_EQ(lines.size(), static_cast<int>(scope.view().shown().size()) + 1);
  EXPECT_EQ(lines[0], "t_s,hip_z_mm,proxy_z_mm,f_N");
  EXPECT_TRUE(lines.back().startsWith("9.995,")) << lines.back().toStdString();
  EXPECT_TRUE(lines.back().endsWith(",1.999"));
  QFile drawing(svg);
  ASSERT_TRUE(drawing.open(QIODevice::ReadOnly));
  const QByteArray text = drawing.readAll();
  EXPECT_EQ(text.count("<polyline "), 3);
  EXPECT_TRUE(text.contains("force (N)"));
  EXPECT_TRUE(text.endsWith("</svg>\n"));
  EXPECT_FALSE(scope.exportTo("/nowhere/at/all.csv").isEmpty()) << "and says why";
}

TEST(Scope, EveryControlHasANameForSpeech) {
  ScopeDialog scope(nullptr);
  for (QToolButton* button : scope.findChildren<QToolButton*>()) {
    EXPECT_FALSE(button->accessibleName().isEmpty());
    ASSERT_NE(button->defaultAction(), nullptr);
  }
  EXPECT_FALSE(scope.view().accessibleName().isEmpty());
  EXPECT_NE(scope.view().focusPolicy(), Qt::NoFocus);
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
