// SPDX-License-Identifier: BSD-3-Clause
// A release of the mouse that never comes: a dialog or another program took it.
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/views/overlays/light_ball.h"

namespace relievo {
namespace {

class HeldButtonsTest : public GuiTest {
 protected:
  HeldButtonsTest() {
    openRelief();
    document().region().setRect({40, 40, 60, 60});
  }
  DetailView& view() { return window().detailView(); }
  ReferenceView& overview() { return window().referenceView(); }
  static QPointF middleOf(const QWidget& widget) { return QRectF(widget.rect()).center(); }
  void pressIn() {
    action("pointer_touch")->trigger();
    press(view(), middleOf(view()));
    ASSERT_TRUE(view().pressing());
  }
  const Region& region() { return document().project().region; }
  int steps() { return document().history().count(); }
};

TEST_F(HeldButtonsTest, AMoveWithoutTheButtonEndsThePress) {
  pressIn();
  const double pressed_z = view().hand()->z;
  move(view(), middleOf(view()) + QPointF(1, 0));
  EXPECT_FALSE(view().pressing());
  EXPECT_GT(view().hand()->z, pressed_z) << "the hand is above the surface again";
}

TEST_F(HeldButtonsTest, AMoveWithoutTheButtonEndsTheTurn) {
  press(view(), middleOf(view()));
  move(view(), middleOf(view()) + QPointF(20, 0), Qt::LeftButton);
  const double turned = document().project().azimuth_deg;
  ASSERT_NE(turned, 0);
  QApplication::processEvents();
  move(view(), middleOf(view()) + QPointF(60, 0));
  QApplication::processEvents();
  EXPECT_EQ(document().project().azimuth_deg, turned);
}

TEST_F(HeldButtonsTest, AMoveWithoutTheButtonEndsTheDragAndKeepsItAsOneStep) {
  const int before = steps();
  const Region start = region();
  press(view(), middleOf(view()), Qt::RightButton);
  move(view(), middleOf(view()) + QPointF(20, 0), Qt::RightButton);
  const Region dragged = region();
  ASSERT_NE(dragged, start);
  move(view(), middleOf(view()) + QPointF(60, 0));
  EXPECT_EQ(region(), dragged);
  EXPECT_FALSE(document().region().inGesture());
  EXPECT_EQ(steps(), before + 1);
}

TEST_F(HeldButtonsTest, ADialogEndsThePress) {
  pressIn();
  QDialog dialog(&window());
  dialog.open();
  EXPECT_FALSE(view().pressing());
}

TEST_F(HeldButtonsTest, ADialogEndsDragsInBothViews) {
  const Region start = region();
  press(view(), middleOf(view()), Qt::RightButton);
  move(view(), middleOf(view()) + QPointF(20, 0), Qt::RightButton);
  QDialog dialog(&window());
  dialog.open();
  EXPECT_FALSE(document().region().inGesture());
  dialog.close();
  const Region moved_once = region();
  ASSERT_NE(moved_once, start);

  press(overview(), QPointF(20, 20));
  move(overview(), QPointF(80, 80), Qt::LeftButton);
  ASSERT_TRUE(document().region().inGesture());
  dialog.open();
  EXPECT_FALSE(document().region().inGesture());
  const Region drawn = region();
  dialog.close();
  move(overview(), QPointF(120, 120), Qt::LeftButton);
  EXPECT_EQ(region(), drawn);
}

TEST_F(HeldButtonsTest, AMoveOverTheOverviewWithoutTheButtonEndsItsDrag) {
  press(overview(), QPointF(20, 20));
  move(overview(), QPointF(80, 80), Qt::LeftButton);
  ASSERT_TRUE(document().region().inGesture());
  move(overview(), QPointF(120, 120));
  EXPECT_FALSE(document().region().inGesture());
}

TEST_F(HeldButtonsTest, LosingTheFocusEndsThePress) {
  view().setFocus();
  pressIn();
  overview().setFocus();
  EXPECT_FALSE(view().pressing());
}

TEST_F(HeldButtonsTest, AHandPressedInByKeysStaysWhileSomethingElseIsChosen) {
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_PageDown);
  ASSERT_TRUE(view().pressing());
  overview().setFocus();
  EXPECT_TRUE(view().pressing()) << "no button is held that could be let go of";
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_PageUp);
  EXPECT_FALSE(view().pressing());
}

TEST_F(HeldButtonsTest, TheSphereOfTheLightIsLetGoOf) {
  auto& ball = *child<LightBall>("light_ball");
  press(ball, middleOf(ball));
  move(ball, middleOf(ball) + QPointF(5, 0), Qt::LeftButton);
  const LightOptions dragged = document().project().look.light;
  move(ball, middleOf(ball) + QPointF(0, 9), Qt::RightButton);
  move(ball, middleOf(ball) + QPointF(0, 9), Qt::LeftButton);
  EXPECT_EQ(document().project().look.light, dragged);
}

}  // namespace
}  // namespace relievo
