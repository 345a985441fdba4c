// SPDX-License-Identifier: BSD-3-Clause
// What hand and view do to each other: taps that measure, an object that turns while it is touched,
// a cap that moves the scan.
#include <cmath>
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QtTest/QTest>

#include "tests/app/journeys/journey.h"
#include "tests/emulator/stall_watch.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/measure_readings.h"
#include "ui/views/cloud_view.h"
#include "ui/views/scan_view.h"

namespace relievo {
namespace {

class HandAndViewTest : public Journey {
 protected:
  HandAndViewTest() : Journey("hand_and_view") {}
  /// The mouse presses on the middle of the detail view, with forces on.
  void touchMiddle() {
    const QPointF middle = QRectF(detail().rect()).center();
    move(detail(), middle);
    if (!action("forces")->isChecked()) key(Qt::Key_F5);
    ASSERT_TRUE(eventually([this] { return probe() && probe()->forces_on; }));
    press(detail(), middle);
    ASSERT_TRUE(eventually([this] { return forceShown() > 0.1; }));
  }
};

TEST_F(HandAndViewTest, ACapMovesTheScanInAllSixWaysWhileThatHasTheKeyboard) {
  openRelief();
  attach();
  QApplication::setActiveWindow(&window());
  QTest::keyClick(&window().detailView(), Qt::Key_F8);
  auto& scan = *child<ScanView>("scan_view");
  ASSERT_TRUE(waitFor([&] { return scan.isVisible() && scan.isReady(); }));
  CloudView& cloud = *scan.cloud();
  ASSERT_TRUE(cloud.hasFocus());
  scan.lookAsRelief();
  const Region region = document().project().region;
  const CloudCamera first = cloud.camera();
  host().turnView(0, 0, 30);
  const Rotation tilted = cloud.camera().view;
  // What was upright leans to the left.
  EXPECT_NEAR(tilted[0] * first.view[3] + tilted[1] * first.view[4] + tilted[2] * first.view[5],
              -0.5, 1e-9);
  for (std::size_t i = 6; i < 9; ++i) EXPECT_NEAR(tilted[i], first.view[i], 1e-9);
  host().turnView(0, 0, -30);
  host().turnView(-20, 0, 0);
  EXPECT_NEAR(scan.turnedDeg(), 20, 1e-6);
  host().turnView(20, 0, 0);
  host().pushView({.right = 0.1, .up = 0.2, .nearer = 2});
  EXPECT_NEAR(cloud.camera().height, first.height / 2, 1e-9);
  EXPECT_GT(norm(cloud.camera().middle - first.middle), 1);
  EXPECT_FALSE(window().detailView().isTurned());
  EXPECT_EQ(document().project().region, region);
  // In the detail view that is what moves; it is never tilted.
  window().detailView().setFocus();
  const CloudCamera kept = cloud.camera();
  host().turnView(0, 0, 30);
  EXPECT_FALSE(window().detailView().isTurned());
  host().turnView(10, 0, 0);
  EXPECT_TRUE(window().detailView().isTurned());
  EXPECT_EQ(cloud.camera().view, kept.view);
}

TEST_F(HandAndViewTest, TapsMeasureAsSurelyAsTheSurfaceIsKnownAndAFastMoveIsNoTap) {
  attach();
  openRelief();
  auto& panel = *window().findChild<MeasurePanel*>();
  auto& view = window().detailView();
  const QPointF middle = QRectF(view.rect()).center();
  const QPointF aside(0.15 * view.height(), 0.1 * view.height());
  const auto& probe = this->probe();
  ASSERT_TRUE(window().runCommand("measure_touch"));
  move(view, middle);
  QTest::keyClick(&view, Qt::Key_F5);
  ASSERT_TRUE(waitFor([&] { return probe && probe->forces_on; }));
  for (int i = 0; i < 40; ++i) {
    move(view, i % 2 == 0 ? middle + aside : middle - aside);
    QTest::qWait(16);
  }
  EXPECT_TRUE(panel.byTouch());
  EXPECT_TRUE(panel.measurements().empty()) << "nothing was pressed";
  emulator::StallWatch stalls;
  EXPECT_TRUE(stalls.repeatAfterStalls(5, [&] {
    panel.setMeasurements({});
    for (const QPointF& at : {middle, middle + aside}) {
      move(view, at);
      if (!action("forces")->isChecked()) QTest::keyClick(&view, Qt::Key_F5);
      const auto arrived = [&] {
        return probe->forces_on && !probe->touching &&
               std::hypot(probe->hip.x - view.hand()->x, probe->hip.y - view.hand()->y) < 1;
      };
      if (!waitFor(arrived)) return false;
      press(view, at);
      const bool felt = waitFor([this] { return forceShown() > 0.1; });
      release(view, at);
      if (!felt || !waitFor([&] { return !probe->touching; })) return false;
    }
    return waitFor([&] { return panel.measurements().size() == 1; });
  }));
  detach();
  ASSERT_EQ(panel.measurements().size(), 1U);
  const Quantity of_map =
      read(document().surface()->map, panel.measurements().front()).quantities.front();
  ASSERT_GT(of_map.uncertainty, 0.01) << "half a cell on a slope";
  ASSERT_LT(of_map.uncertainty, 2);
  MeasureReadings readings(document());
  const auto shown = readings.of(panel.measurements().front());
  ASSERT_TRUE(shown && shown->reading);
  EXPECT_GE(shown->reading->quantities.front().uncertainty, of_map.uncertainty - 1e-12);
}

TEST_F(HandAndViewTest, ATouchedObjectTurnsUnderTheHandWithoutHarm) {
  attach();
  openRelief();
  auto& view = window().detailView();
  const QPointF middle = QRectF(view.rect()).center();
  const auto& probe = this->probe();
  action("turn_relief")->setChecked(true);
  emulator::StallWatch stalls;
  EXPECT_TRUE(stalls.repeatAfterStalls(5, [&] {
    release(view, middle);
    touchMiddle();
    const double at_x = probe->proxy.x - document().project().region.x_mm;
    double most_n = norm(probe->force);
    const double pressed_n = most_n;
    for (int i = 0; i < 6; ++i) {
      view.turnBy(i % 2 == 0 ? 6 : -2, i % 3 == 0 ? 3 : -1);
      EXPECT_TRUE(waitFor([&] {
        if (probe) most_n = std::max(most_n, norm(probe->force));
        return !document().loader().busy() && !view.isTurned();
      }));
    }
    // A hand that is still is not pushed by an object that turns about what it touches.
    EXPECT_LT(most_n, pressed_n + 1) << pressed_n;
    const auto feels = [&] {
      return probe && probe->touching && probe->window_id == document().window()->id;
    };
    if (!waitFor(feels) || !action("forces")->isChecked()) return false;
    EXPECT_NEAR(probe->proxy.x - document().project().region.x_mm, at_x, 3);
    return true;
  })) << child<QLabel>("status_message")->text().toStdString();
  release(view, middle);
  detach();
}

}  // namespace
}  // namespace relievo
