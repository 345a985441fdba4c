// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/light_ball.h"

#include <QAction>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class LightBallTest : public GuiTest {
 protected:
  LightBallTest() { openRelief(); }
  LightBall& ball() { return *child<LightBall>("light_ball"); }
  const LightOptions& light() { return document().project().look.light; }
  QPointF middle() { return QRectF(ball().rect()).center(); }
};

TEST_F(LightBallTest, ItsSpotAndALightAreTheSameBothWays) {
  for (const LightOptions& wanted :
       {LightOptions{315, 45}, LightOptions{10, 20}, LightOptions{180, 80}}) {
    const LightOptions back = ball().lightAt(ball().spotOf(wanted));
    EXPECT_NEAR(back.azimuth_deg, wanted.azimuth_deg, 1e-9);
    EXPECT_NEAR(back.elevation_deg, wanted.elevation_deg, 1e-9);
  }
}

TEST_F(LightBallTest, ADragIsOneStepOfTheDocumentAndUndoBringsTheLightBack) {
  const LightOptions before = light();
  const double right = 0.5 * ball().width() - 1;
  drag(ball(), middle() + QPointF(0, -10), middle() + QPointF(right, 0));
  EXPECT_NEAR(light().azimuth_deg, 90, 1e-9);
  EXPECT_NEAR(light().elevation_deg, kLeastLightDeg, 1e-9) << "the rim rakes";
  EXPECT_EQ(window().detailView().sceneState().light, light());
  EXPECT_EQ(window().referenceView().sceneState().light, light());
  EXPECT_EQ(document().history().count(), 1);
  action("undo")->trigger();
  EXPECT_EQ(light(), before);
  EXPECT_EQ(ball().light(), before);
}

TEST_F(LightBallTest, EachDragIsAStepOfItsOwn) {
  drag(ball(), middle(), middle() + QPointF(12, 0));
  const LightOptions first = light();
  drag(ball(), middle(), middle() + QPointF(0, 12));
  ASSERT_NE(light(), first);
  EXPECT_EQ(document().history().count(), 2);
  action("undo")->trigger();
  EXPECT_EQ(light(), first);
  QTest::keyClick(&ball(), Qt::Key_Right);
  QTest::keyClick(&ball(), Qt::Key_Right);
  EXPECT_NE(light(), first);
  EXPECT_EQ(document().history().index(), 2);
  EXPECT_EQ(document().history().count(), 2) << "keys are another step than the drag before";
}

TEST_F(LightBallTest, ItsDragTurnsNoViewAndPressesNothing) {
  drag(ball(), middle(), middle() + QPointF(12, 12));
  EXPECT_FALSE(window().detailView().isTurned());
  EXPECT_FALSE(window().detailView().pressing());
}

TEST_F(LightBallTest, ArrowsOnItAndCommandsMoveTheLightByFiveDegrees) {
  QTest::keyClick(&ball(), Qt::Key_Right);
  EXPECT_NEAR(light().azimuth_deg, 320, 1e-9);
  QTest::keyClick(&ball(), Qt::Key_Down);
  EXPECT_NEAR(light().elevation_deg, 40, 1e-9);
  QTest::keyClick(&window().detailView(), Qt::Key_Left, Qt::AltModifier | Qt::ShiftModifier);
  QTest::keyClick(&window().detailView(), Qt::Key_Up, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_EQ(light(), LightOptions{});
  EXPECT_NEAR(turnedLight({3, 45}, -5, 0).azimuth_deg, 358, 1e-9);
  EXPECT_NEAR(turnedLight({3, 6}, 0, -5).elevation_deg, kLeastLightDeg, 1e-9);
  EXPECT_NEAR(turnedLight({3, 88}, 0, 5).elevation_deg, 90, 1e-9);
}

TEST_F(LightBallTest, PresetsRakeFromFourSidesAndGiveTheUsualLightBack) {
  action("light_rake_left")->trigger();
  EXPECT_EQ(light(), (LightOptions{270, 10}));
  action("light_rake_above")->trigger();
  EXPECT_EQ(light(), (LightOptions{0, 10}));
  action("light_usual")->trigger();
  EXPECT_EQ(light(), LightOptions{});
  EXPECT_EQ(document().history().count(), 3);
}

TEST_F(LightBallTest, AnImageWithoutALampHasNone) {
  EXPECT_TRUE(ball().isVisible());
  action("relief_slope")->trigger();
  EXPECT_FALSE(ball().isVisible());
  action("relief_hillshade")->trigger();
  EXPECT_TRUE(ball().isVisible());
}

}  // namespace
}  // namespace relievo
