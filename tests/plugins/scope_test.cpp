// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/scope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <QXmlStreamReader>

namespace relievo {
namespace {

/// Every 5 ms, as the panel gets them: a ramp of force, so that each sample is another.
std::vector<ForcePoint> samples(int from, int count) {
  std::vector<ForcePoint> made;
  for (int i = from; i < from + count; ++i) {
    made.push_back({0.005 * i, std::sin(0.01 * i), 1 + std::sin(0.01 * i), 0.001 * i});
  }
  return made;
}

/// Is what is drawn and exported as long as the zoom says?
void expectShownAsLongAsItsSpan(const ScopeView& view) {
  const double shown_s = view.shown().back().t_s - view.shown().front().t_s;
  EXPECT_NEAR(shown_s, view.spanS(), 0.006);
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
  expectShownAsLongAsItsSpan(scope.view());
  for (int i = 0; i < 30; ++i) scope.findChild<QAction*>("scopeZoomOut")->trigger();
  EXPECT_EQ(scope.view().spanS(), ScopeView::kMostSpanS);
  expectShownAsLongAsItsSpan(scope.view());
  for (int i = 0; i < 30; ++i) QTest::keyClick(&scope.view(), Qt::Key_Plus);
  for (int i = 0; i < 30; ++i) scope.findChild<QAction*>("scopeZoomIn")->trigger();
  EXPECT_EQ(scope.view().spanS(), ScopeView::kLeastSpanS);
  expectShownAsLongAsItsSpan(scope.view());
}

TEST(Scope, ZoomsAboutTheCursorWhilePaused) {
  ScopeDialog scope(nullptr);
  scope.show();
  scope.add(samples(0, 8000));
  scope.findChild<QAction*>("scopePause")->trigger();
  // A click in the middle: 2.5 s before the end.
  QTest::mouseClick(&scope.view(), Qt::LeftButton, {},
                    {scope.view().width() / 2, scope.view().height() / 2});
  const QString there = scope.view().cursorText();
  EXPECT_TRUE(there.startsWith("At 37.49")) << there.toStdString();
  scope.findChild<QAction*>("scopeZoomIn")->trigger();
  expectShownAsLongAsItsSpan(scope.view());
  EXPECT_EQ(scope.view().cursorText(), there) << "the cursor stays on its sample";
  const double from_start_s = 37.5 - scope.view().shown().front().t_s;
  EXPECT_NEAR(from_start_s, 0.5 * scope.view().spanS(), 0.03) << "and where it was drawn";
  scope.findChild<QAction*>("scopeZoomOut")->trigger();
  EXPECT_EQ(scope.view().cursorText(), there);
}

TEST(Scope, TheCursorsValuesAreText) {
  ScopeDialog scope(nullptr);
  scope.show();
  EXPECT_EQ(scope.findChild<QLabel*>("scopeValues")->text(), "Nothing measured yet.");
  scope.add(samples(0, 1000));
  scope.findChild<QAction*>("scopePause")->trigger();
  QTest::keyClick(&scope.view(), Qt::Key_Left);
  const QString text = scope.findChild<QLabel*>("scopeValues")->text();
  EXPECT_EQ(text, "At 4.990 s: HIP -0.527 mm, proxy 0.473 mm, force 0.998 N") << text.toStdString();
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
  // sin 19.99 to nine digits.
  EXPECT_EQ(lines.back(), "9.995,0.908818851,1.90881885,1.999") << lines.back().toStdString();
  QFile drawing(svg);
  ASSERT_TRUE(drawing.open(QIODevice::ReadOnly));
  const QByteArray text = drawing.readAll();
  QXmlStreamReader xml(text);
  std::vector<QStringList> curves;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement || xml.name() != "polyline") continue;
    curves.push_back(xml.attributes().value("points").toString().split(' '));
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  ASSERT_EQ(curves.size(), 3U);
  for (const QStringList& points : curves) {
    EXPECT_EQ(points.size(), static_cast<int>(scope.view().shown().size()));
  }
  // The force rises from 0.999 to 1.999 N: over the right half of the lower strip's height.
  const auto height_of = [](const QString& point) { return point.section(',', 1).toDouble(); };
  EXPECT_NEAR(height_of(curves[2].front()) - height_of(curves[2].back()), 100, 0.2);
  EXPECT_TRUE(text.contains("force (N)"));
  EXPECT_TRUE(text.endsWith("</svg>\n"));
  EXPECT_FALSE(scope.exportTo("/nowhere/at/all.csv").isEmpty()) << "and says why";
}

TEST(Scope, ACommandAsksWhereToSaveAndSaysThatItDid) {
  QTemporaryDir folder;
  ScopeDialog scope(nullptr);
  scope.show();
  scope.add(samples(0, 2000));
  scope.findChild<QAction*>("scopePause")->trigger();
  scope.add(samples(2000, 300));
  for (const auto& [command, ending] : {std::pair{"scopeCsv", "csv"}, {"scopeSvg", "svg"}}) {
    scope.findChild<QAction*>(command)->trigger();
    auto* dialog = scope.findChild<QFileDialog*>("scope_dialog");
    ASSERT_NE(dialog, nullptr) << command;
    EXPECT_EQ(dialog->defaultSuffix(), ending);
    const QString name = folder.filePath(QStringLiteral("saved.") + ending);
    Q_EMIT dialog->fileSelected(name);
    delete dialog;
    EXPECT_EQ(scope.findChild<QLabel*>("scopeValues")->text(), "Saved: " + name);
    EXPECT_GT(QFile(name).size(), 1000);
  }
  QFile table(folder.filePath("saved.csv"));
  ASSERT_TRUE(table.open(QIODevice::ReadOnly));
  EXPECT_TRUE(table.readAll().contains("\n9.995,")) << "what is held still, not what came since";
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
