// SPDX-License-Identifier: BSD-3-Clause
#include <QAction>
#include <QLabel>
#include <QtTest/QTest>
#include <vector>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class HandTest : public GuiTest {
 protected:
  struct Moved {
    ViewMm position;
    bool inside;
  };

  void SetUp() override {
    openRelief();
    document().region().setRect({60, 50, 80, 80});
    QObject::connect(&window(), &MainWindow::handMoved, &window(),
                     [this](const ViewMm& p, bool inside) {
                       moves_.push_back({p, inside});
                     });
  }
  DetailView& view() { return window().detailView(); }
  QPointF middle() { return QRectF(view().rect()).center(); }
  double surfaceAt(const ViewMm& p) { return windowHeightMm(*document().window(), p.x, p.y); }
  double objectPerHand() { return handMapping(*document().window()).objectMmPerHandMm(); }
  const Moved& last() { return moves_.back(); }

  std::vector<Moved> moves_;
};

TEST_F(HandTest, ThePointerCarriesTheHandJustAboveTheSurface) {
  move(view(), middle());
  ASSERT_FALSE(moves_.empty());
  EXPECT_TRUE(last().inside);
  EXPECT_NEAR(last().position.x, 100, 0.5);
  EXPECT_NEAR(last().position.y, 90, 0.5);
  EXPECT_NEAR(last().position.z - surfaceAt(last().position), kHoverMm * objectPerHand(), 1e-9);
}

TEST_F(HandTest, TheLeftButtonPressesInToThePressDepthAndLetsGo) {
  action("pointer_touch")->trigger();
  press(view(), middle());
  EXPECT_NEAR(last().position.z - surfaceAt(last().position), -kPressDepthMm * objectPerHand(),
              1e-9);
  move(view(), middle() + QPointF(20, 0), Qt::LeftButton);
  EXPECT_NEAR(last().position.z - surfaceAt(last().position), -kPressDepthMm * objectPerHand(),
              1e-9);
  release(view(), middle() + QPointF(20, 0));
  EXPECT_GT(last().position.z, surfaceAt(last().position));
}

TEST_F(HandTest, AWindowElsewhereKeepsTheHandOfTheKeysOverIt) {
  QTest::keyClick(&view(), Qt::Key_Left);
  ASSERT_NEAR(last().position.x, 100, 2);
  document().region().setRect({0, 0, 40, 40});
  const Region region = document().project().region;
  EXPECT_LE(last().position.x, region.x_mm + region.side_mm);
  EXPECT_LE(last().position.y, region.y_mm + region.side_mm);
  EXPECT_NEAR(last().position.z - surfaceAt(last().position), kHoverMm * objectPerHand(), 1e-9);
}

TEST_F(HandTest, AWindowElsewhereComesUnderThePointer) {
  move(view(), middle());
  document().region().setRect({0, 0, 40, 40});
  const Region region = document().project().region;
  EXPECT_NEAR(last().position.x, region.centreX(), 0.02 * region.side_mm);
  EXPECT_NEAR(last().position.y, region.centreY(), 0.02 * region.side_mm);
}

TEST_F(HandTest, TheWheelWhilePressingChangesTheDepthNotTheWindow) {
  action("pointer_touch")->trigger();
  const Region before = document().project().region;
  press(view(), middle());
  wheel(view(), middle(), 2);
  EXPECT_NEAR(view().pressDepthMm(), kPressDepthMm + 0.5, 1e-12);
  EXPECT_NEAR(surfaceAt(last().position) - last().position.z,
              view().pressDepthMm() * objectPerHand(), 1e-9);
  release(view(), middle());
  wheel(view(), middle(), -1, Qt::ControlModifier);
  EXPECT_NEAR(view().pressDepthMm(), kPressDepthMm + 0.25, 1e-12);
  EXPECT_EQ(document().project().region, before);
}

TEST_F(HandTest, ArrowsMoveTheHandByCellsAndPageKeysPressItIn) {
  move(view(), middle());
  const ViewMm start = last().position;
  const double cell = document().window()->spacingMm();
  QTest::keyClick(&view(), Qt::Key_Right);
  EXPECT_NEAR(last().position.x, start.x + cell, 1e-9);
  QTest::keyClick(&view(), Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(last().position.y, start.y - 10 * cell, 1e-9);
  QTest::keyClick(&view(), Qt::Key_PageDown);
  QTest::keyClick(&view(), Qt::Key_PageDown);
  EXPECT_NEAR(surfaceAt(last().position) - last().position.z, 0.5 * objectPerHand(), 1e-9);
  QTest::keyClick(&view(), Qt::Key_PageUp);
  QTest::keyClick(&view(), Qt::Key_PageUp);
  EXPECT_GT(last().position.z, surfaceAt(last().position));
}

TEST_F(HandTest, TheHandIsOutsideOnceThePointerLeaves) {
  move(view(), middle());
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&view(), &leave);
  EXPECT_FALSE(last().inside);
}

TEST_F(HandTest, ARightDragMovesTheWindowUnderTheHandAsOneEntry) {
  const Region before = document().project().region;
  const int entries = document().history().count();
  drag(view(), middle(), middle() + QPointF(30, 0), Qt::RightButton);
  EXPECT_LT(document().project().region.x_mm, before.x_mm);
  EXPECT_EQ(document().project().region.side_mm, before.side_mm);
  EXPECT_EQ(document().history().count(), entries + 1);
}

TEST_F(HandTest, TheWheelZoomsAboutThePointerByChangingTheRegion) {
  move(view(), middle() + QPointF(40, -30));
  const ViewMm place = last().position;
  const Region before = document().project().region;
  wheel(view(), middle() + QPointF(40, -30), 1);
  EXPECT_LT(document().project().region.side_mm, before.side_mm);
  move(view(), middle() + QPointF(40, -30));
  EXPECT_NEAR(last().position.x, place.x, 1e-6);
  EXPECT_NEAR(last().position.y, place.y, 1e-6);
}

TEST_F(HandTest, FinerHappensAboutTheHand) {
  document().region().whole();
  move(view(), middle());
  while (document().detail() < 3) {
    QTest::keyClick(&view(), Qt::Key_Plus, Qt::ControlModifier);
  }
  const Region& r = document().project().region;
  EXPECT_NEAR(r.centreX(), 125, 1);
  EXPECT_NEAR(r.centreY(), 100, 1);
}

TEST_F(HandTest, TheStatusSaysWhereTheHandIsAndOnWhat) {
  move(view(), middle());
  const QString place = child<QLabel>("status_position")->text();
  EXPECT_TRUE(place.startsWith("x 100") || place.startsWith("x 99")) << place.toStdString();
  EXPECT_EQ(child<QLabel>("status_kind_of_surface")->text(), "measured");
  EXPECT_TRUE(view().whereAmI().contains("Resolution"));
}

TEST_F(HandTest, AProbeIsDrawnOnlyOnTheWindowItBelongsTo) {
  Probe probe;
  probe.window_id = document().window()->id + 1;
  probe.proxy = probe.hip = {100, 90, 20};
  window().controllers().touch.showProbe(probe);
  EXPECT_FALSE(view().sceneState().probe.has_value());
  probe.window_id = document().window()->id;
  probe.forces_on = true;
  probe.force = {0, 0, 0.5};
  probe.force_limit_n = 4;
  window().controllers().touch.showProbe(probe);
  ASSERT_TRUE(view().sceneState().probe.has_value());
  EXPECT_EQ(child<QLabel>("status_force")->text(), "0.50/4.0 N");
  ASSERT_TRUE(document().region().move(0.25, 0));
  EXPECT_FALSE(view().sceneState().probe.has_value());
}

TEST_F(HandTest, AGreyAnaglyphHasALegendOfHandAndProxy) {
  Probe probe;
  probe.window_id = document().window()->id;
  probe.proxy = probe.hip = {100, 90, 20};
  window().controllers().touch.showProbe(probe);
  auto* legend = view().findChild<QWidget*>("cell_legend");
  ASSERT_NE(legend, nullptr);
  EXPECT_FALSE(legend->isVisible());
  view().setStereo({.mode = StereoMode::anaglyph});
  EXPECT_TRUE(legend->isVisible());
  EXPECT_EQ(legend->accessibleDescription(), "ball: proxy, on the surface, ring with a cross: HIP");
  view().clearProbe();
  EXPECT_FALSE(legend->isVisible()) << "no hand, no legend";
  window().controllers().touch.showProbe(probe);
  EXPECT_TRUE(legend->isVisible());
  view().setStereo({.mode = StereoMode::half_colour});
  EXPECT_FALSE(legend->isVisible()) << "red and blue are told apart";
}

}  // namespace
}  // namespace relievo
