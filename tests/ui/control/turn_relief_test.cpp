// SPDX-License-Identifier: BSD-3-Clause
// The relief follows the turned view: made anew again and again, what is touched under the hand.
#include <cmath>
#include <QAction>
#include <QFile>
#include <QtTest/QTest>

#include "core/region/hand.h"
#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class TurnReliefTest : public GuiTest {
 protected:
  void SetUp() override { openRelief(); }
  DetailView& detail() { return window().detailView(); }
  /// The relief is what the view shows: nothing is turned and nothing works any more.
  bool rests() {
    return waitFor([this] { return !document().loader().busy() && !detail().isTurned(); });
  }
  ViewMm middle() {
    const StepAbout at = document().region().aboutCentre();
    return {at.x_mm, at.y_mm, windowHeightMm(*document().window(), at.x_mm, at.y_mm)};
  }
  static FilePoint inFile(const Surface& surface, const ViewMm& place) {
    return surface.view_from_file.inverseOfSimilarity()(place);
  }
};

TEST_F(TurnReliefTest, WithoutItAViewIsTurnedAndTheReliefStays) {
  const auto before = document().surface();
  detail().turnBy(10, 5);
  EXPECT_FALSE(document().loader().busy());
  EXPECT_EQ(document().surface(), before);
}

TEST_F(TurnReliefTest, TheReliefIsMadeWhereTheViewLooksAndUndoneInOneStep) {
  const auto top = document().surface();
  const int steps = document().history().count();
  action("turn_relief")->setChecked(true);
  detail().turnBy(10, 5);
  const Rotation camera = detail().cameraRotation();
  ASSERT_TRUE(rests());
  // From the top, view axes are file axes: the camera's rotation is the new view's.
  const auto& m = document().surface()->view_from_file.m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(m[4 * i + j], camera[3 * i + j], 1e-9);
  }
  detail().turnBy(-7, 0);
  ASSERT_TRUE(rests());
  EXPECT_EQ(document().history().count(), steps + 1) << "turns in a row are one step";
  document().history().undo();
  EXPECT_EQ(document().surface(), top);
  ASSERT_TRUE(rests());
  EXPECT_EQ(document().surface(), top) << "an undo is no turn that the relief would follow";
}

TEST_F(TurnReliefTest, WhatIsTurnedWhileAReliefIsMadeComesNext) {
  action("turn_relief")->setChecked(true);
  int made = 0;
  QObject::connect(&document(), &Document::surfaceChanged, &window(), [&] { ++made; });
  detail().turnBy(6, 0);
  ASSERT_TRUE(document().loader().busy());
  detail().turnBy(6, 0);
  detail().turnBy(6, 0);
  ASSERT_TRUE(rests());
  EXPECT_EQ(made, 2) << "the first, and the rest at once";
  const auto& m = document().surface()->view_from_file.m;
  const double turned = std::atan2(-m[2], m[0]) * 180 / M_PI;
  EXPECT_NEAR(turned, 18, 1e-9);
}

TEST_F(TurnReliefTest, TheMiddleOfTheWindowStaysWhereItIsOfTheObject) {
  action("turn_relief")->setChecked(true);
  document().region().setRect({40, 50, 60, 60});
  const Region before = document().project().region;
  const FilePoint place = inFile(*document().surface(), middle());
  for (int i = 0; i < 4; ++i) {
    detail().turnBy(5, -3);
    ASSERT_TRUE(rests());
  }
  const Region& now = document().project().region;
  EXPECT_EQ(now.side_mm, before.side_mm);
  const ViewMm seen = document().surface()->view_from_file(place);
  const double cell = document().window()->spacingMm();
  EXPECT_NEAR(seen.x, now.centreX(), cell);
  EXPECT_NEAR(seen.y, now.centreY(), cell);
  EXPECT_NEAR(seen.z, middle().z, 3 * cell) << "the dome's height there is that of the relief";
}

TEST_F(TurnReliefTest, TheWholeObjectStaysTheWhole) {
  action("turn_relief")->setChecked(true);
  ASSERT_EQ(document().detail(), 1);
  detail().turnBy(20, 0);
  ASSERT_TRUE(rests());
  EXPECT_EQ(document().detail(), 1);
  EXPECT_EQ(document().project().region, wholeRegion(document().surface()->ladder));
}

TEST_F(TurnReliefTest, AStoppedReliefIsNotTriedAgainByItself) {
  action("turn_relief")->setChecked(true);
  const auto before = document().surface();
  detail().turnBy(10, 0);
  ASSERT_TRUE(document().loader().busy());
  document().loader().cancel();
  QApplication::processEvents();
  EXPECT_FALSE(document().loader().busy());
  EXPECT_EQ(document().surface(), before);
  EXPECT_TRUE(detail().isTurned()) << "the view stays as it was turned";
  detail().turnBy(1, 0);
  ASSERT_TRUE(rests());
  EXPECT_NE(document().surface(), before);
}

TEST_F(TurnReliefTest, AViewThatIsPastedFilmedOrOpenedKeepsItsRelief) {
  action("turn_relief")->setChecked(true);
  const auto before = document().surface();
  document().setTurn(20, 10);  // As all of them do.
  QApplication::processEvents();
  EXPECT_FALSE(document().loader().busy());
  EXPECT_EQ(document().surface(), before);
  EXPECT_TRUE(detail().isTurned());
}

TEST_F(TurnReliefTest, AMapThatIsARasterIsTurnedAlone) {
  action("turn_relief")->setChecked(true);
  QFile file(path("map.asc"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("ncols 40\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 1\n");
  for (int i = 0; i < 1600; ++i)
    file.write(QByteArray::number(i % 7) + (i % 40 == 39 ? '\n' : ' '));
  file.close();
  window().open(path("map.asc"));
  ASSERT_TRUE(waitFor(
      [this] { return document().file() == path("map.asc") && !document().loader().busy(); }));
  const auto before = document().surface();
  ASSERT_TRUE(before->is_raster);
  detail().turnBy(10, 0);
  EXPECT_FALSE(document().loader().busy());
  EXPECT_EQ(document().surface(), before);
}

TEST_F(TurnReliefTest, TheKeySwitchesItAndItIsRemembered) {
  QTest::keyClick(&detail(), Qt::Key_T, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(action("turn_relief")->isChecked());
  restart();
  EXPECT_TRUE(action("turn_relief")->isChecked());
}

}  // namespace
}  // namespace relievo
