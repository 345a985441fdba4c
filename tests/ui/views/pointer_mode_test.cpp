// SPDX-License-Identifier: BSD-3-Clause
// Look and touch: what the buttons of the mouse do in the detail view.
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QToolBar>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/preferences_dialog.h"

namespace relievo {
namespace {

class PointerModeTest : public GuiTest {
 protected:
  PointerModeTest() { openRelief(); }
  DetailView& view() { return window().detailView(); }
  QPointF middle() { return QRectF(view().rect()).center(); }
  QString said() { return child<QLabel>("status_mouse")->text(); }
  void dragLeft(const QPointF& way) { drag(view(), middle(), middle() + way); }
};

TEST_F(PointerModeTest, ALeftDragTurnsAtFirstAndPressesNothing) {
  bool pressed = false;
  QObject::connect(&view(), &DetailView::handMoved,
                   [&](const ViewMm&, bool) { pressed = pressed || view().pressing(); });
  dragLeft({60, 0});
  EXPECT_TRUE(view().isTurned());
  EXPECT_LT(document().project().azimuth_deg, 0) << "the near side follows the pointer";
  EXPECT_FALSE(pressed);
}

TEST_F(PointerModeTest, TurnsInARowAreOneStepThatUndoTakesBack) {
  dragLeft({60, 0});
  const double turned_deg = document().project().azimuth_deg;
  dragLeft({-20, 15});
  EXPECT_EQ(document().history().count(), 1);
  EXPECT_EQ(document().history().undoText(), "Turn the view");
  const Project after = document().project();
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(view().isTurned());
  QTest::keyClick(&window(), Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(document().project().azimuth_deg, after.azimuth_deg);
  EXPECT_EQ(document().project().elevation_deg, after.elevation_deg);
  EXPECT_NE(document().project().azimuth_deg, turned_deg);
  // Straight again is a step of its own, so that the turned view is not lost by it.
  QTest::mouseClick(child<QPushButton>("straighten"), Qt::LeftButton);
  EXPECT_FALSE(view().isTurned());
  EXPECT_EQ(document().history().undoText(), "Straighten the view");
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().project().azimuth_deg, after.azimuth_deg);
}

TEST_F(PointerModeTest, TheSwitchIsInTheToolBarAndOnAKey) {
  auto* tools = child<QToolBar>("tools");
  ASSERT_NE(tools->widgetForAction(action("pointer_look")), nullptr);
  QTest::mouseClick(tools->widgetForAction(action("pointer_touch")), Qt::LeftButton);
  EXPECT_EQ(view().pointerMode(), PointerMode::touch);
  press(view(), middle());
  EXPECT_TRUE(view().pressing());
  release(view(), middle());
  EXPECT_FALSE(view().isTurned());
  QTest::keyClick(&view(), Qt::Key_F7);
  EXPECT_EQ(view().pointerMode(), PointerMode::look);
  EXPECT_TRUE(action("pointer_look")->isChecked());
  EXPECT_FALSE(action("pointer_touch")->isChecked());
}

TEST_F(PointerModeTest, AHandThatIsPressedInIsLiftedByTheSwitch) {
  action("pointer_touch")->trigger();
  press(view(), middle());
  QTest::keyClick(&view(), Qt::Key_F7);
  EXPECT_FALSE(view().pressing());
  release(view(), middle());
  EXPECT_FALSE(view().isTurned());
}

TEST_F(PointerModeTest, TheStatusBarSaysWhatTheButtonsDo) {
  EXPECT_EQ(said(), "Look: left turns, right moves, wheel zooms");
  QTest::keyClick(&view(), Qt::Key_F7);
  EXPECT_EQ(said(), "Touch: left presses the hand in, middle turns, right moves, wheel zooms");
}

TEST_F(PointerModeTest, PreferencesChangeTheButtonsAtOnceAndForTheNextStart) {
  window().runCommand("preferences");
  auto* dialog = window().findChild<PreferencesDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* left = dialog->findChild<QComboBox*>("pref_look_left");
  auto* right = dialog->findChild<QComboBox*>("pref_look_right");
  left->setCurrentIndex(1);
  right->setCurrentIndex(0);
  EXPECT_EQ(said(), "Look: left moves, middle turns, right turns, wheel zooms");
  document().region().setRect({40, 40, 60, 60});
  const Region before = document().project().region;
  dragLeft({-40, 0});
  EXPECT_FALSE(view().isTurned());
  EXPECT_GT(document().project().region.x_mm, before.x_mm);
  drag(view(), middle(), middle() + QPointF(0, 30), Qt::RightButton);
  EXPECT_TRUE(view().isTurned());
  action("pointer_touch")->trigger();
  restart();
  openRelief();
  EXPECT_EQ(view().pointerMode(), PointerMode::touch);
  QTest::keyClick(&view(), Qt::Key_F7);
  EXPECT_EQ(said(), "Look: left moves, middle turns, right turns, wheel zooms");
}

TEST_F(PointerModeTest, AButtonMayZoomAndTheWheelMayTurnRound) {
  window().settings().setChoice("look_right", "zoom");
  window().settings().setChoice("wheel_forward", false);
  restart();
  openRelief();
  const double whole = document().project().region.side_mm;
  drag(view(), middle(), middle() - QPointF(0, 60), Qt::RightButton);
  const double closer = document().project().region.side_mm;
  EXPECT_LT(closer, whole);
  wheel(view(), middle(), 1);
  EXPECT_GT(document().project().region.side_mm, closer);
}

/// As the haptics plugin adds it.
QAction* forcesIn(MainWindow& window) {
  auto* forces = new QAction("Forces");
  forces->setObjectName("forces");
  forces->setCheckable(true);
  window.addToMenu("Touch", forces);
  return forces;
}

TEST_F(PointerModeTest, ForcesWithTheMouseMeanTouchAndGiveLookBack) {
  QAction* forces = forcesIn(window());
  TouchReadout readout;
  readout.device = "mouse";
  window().controllers().touch.show(readout);
  forces->setChecked(true);
  EXPECT_EQ(view().pointerMode(), PointerMode::touch);
  forces->setChecked(false);
  EXPECT_EQ(view().pointerMode(), PointerMode::look);
  // Who chooses meanwhile has chosen.
  forces->setChecked(true);
  action("pointer_look")->trigger();
  readout.forces_on = true;
  window().controllers().touch.show(readout);
  EXPECT_EQ(view().pointerMode(), PointerMode::look);
  action("pointer_touch")->trigger();
  readout.forces_on = false;
  window().controllers().touch.show(readout);
  EXPECT_EQ(view().pointerMode(), PointerMode::touch);
}

TEST_F(PointerModeTest, ADeviceInTheHandLeavesTheLeftButtonToLooking) {
  QAction* forces = forcesIn(window());
  TouchReadout readout;
  readout.device = "Falcon ready";
  window().controllers().touch.show(readout);
  forces->setChecked(true);
  EXPECT_EQ(view().pointerMode(), PointerMode::look);
}

}  // namespace
}  // namespace relievo
