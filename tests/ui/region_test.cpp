// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cmath>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QThread>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/views/overlays/pink_overlay.h"

namespace relievo {
namespace {

using testing::HasSubstr;

class RegionTest : public GuiTest {
 protected:
  void SetUp() override { openRelief(); }
  ReferenceView& view() { return window().referenceView(); }
  const Region& region() { return document().project().region; }
  std::string announced() {
    return window().findChild<QLabel*>(QStringLiteral("status_message"))->text().toStdString();
  }
  QPointF point(double x_mm, double y_mm) { return view().pointOf(x_mm, y_mm); }
  /// One pixel of the view, in mm: as exact as a pointer can be.
  double pixelMm() {
    const QPointF a = point(0, 0);
    const QPointF b = point(100, 0);
    return 100 / (b.x() - a.x());
  }
};

TEST_F(RegionTest, ADragOutsideDrawsANewWindowWhileTheDetailFollows) {
  document().region().setRect({40, 40, 60, 60});  // All fields of the status have their rows.
  QTest::qWait(0);
  const int before = document().history().count();
  press(view(), point(60, 150));
  for (const double side : {20.0, 40.0, 60.0}) {
    move(view(), point(60 + side, 150 - side), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return std::abs(region().side_mm - side) < 1e-6; }))
        << "the detail view must follow live: " << side << ", " << region().side_mm;
  }
  release(view(), point(120, 90));
  EXPECT_NEAR(region().x_mm, 60, 1e-6);
  EXPECT_NEAR(region().y_mm, 90, 1e-6);
  EXPECT_NEAR(region().side_mm, 60, 1e-6);
  EXPECT_EQ(window().detailView().sceneState().camera.rect.width_mm, region().side_mm);
  EXPECT_EQ(document().history().count(), before + 1) << "one gesture is one entry";
}

/// Counts the pictures that VTK draws for a view.
class Pictures {
 public:
  explicit Pictures(SurfaceView& view)
      : window_(view.findChild<QVTKOpenGLNativeWidget*>()->renderWindow()) {
    count_->SetClientData(&pictures_);
    count_->SetCallback(
        [](vtkObject*, unsigned long, void* pictures, void*) { ++*static_cast<int*>(pictures); });
    window_->AddObserver(vtkCommand::EndEvent, count_);
  }
  ~Pictures() { window_->RemoveObserver(count_); }
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;
  int count() const { return pictures_; }

 private:
  vtkRenderWindow* window_;
  vtkNew<vtkCallbackCommand> count_;
  int pictures_ = 0;
};

/// A pointer that moves in every round of the event loop, with handlers as slow as may be: the
/// newest place wins, and pictures of the detail come all the same. The overview's relief stays as
/// it is and is not drawn anew.
TEST_F(RegionTest, TheDetailFollowsADragThatNeverPauses) {
  document().region().setRect({40, 40, 60, 60});
  for (SurfaceView* shown :
       {static_cast<SurfaceView*>(&view()), static_cast<SurfaceView*>(&window().detailView())}) {
    ASSERT_TRUE(waitFor([&] {
      const QImage seen = shown->grab().toImage();
      return qGray(seen.pixel(seen.rect().center())) > 90;
    }));
  }
  const Pictures detail(window().detailView()), overview(view());
  QSignalSpy applied(&document(), &Document::windowChanged);
  press(view(), point(70, 70));
  constexpr int kRounds = 120;
  QPointF last;
  for (int i = 1; i <= kRounds; ++i) {
    last = point(70 + 0.3 * i, 70 + 0.2 * i);
    move(view(), last, Qt::LeftButton);
    QThread::msleep(25);  // As on a busy computer; a long round of the loop.
    QApplication::processEvents();
  }
  EXPECT_GE(detail.count(), kRounds / 12) << "one picture takes four rounds, or a few more";
  EXPECT_LE(applied.size(), detail.count() + 2) << "work that no picture shows is not done";
  EXPECT_EQ(overview.count(), 0);
  release(view(), last);
  EXPECT_NEAR(region().x_mm, 40 + 0.3 * kRounds, 1e-6) << "the last place counts";
  EXPECT_EQ(view().findChild<PinkOverlay*>()->frame()->topLeft(),
            point(region().x_mm, region().y_mm + region().side_mm));
}

/// The pink window of all of an object is a square as long as the object, however thin that is.
TEST_F(RegionTest, TheCornersOfATallObjectsWindowAreInView) {
  QFile file(path("tall.xyz"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  for (int row = 0; row < 120; ++row) {
    for (int col = 0; col < 15; ++col) {
      file.write(QByteArray::number(col) + ' ' + QByteArray::number(row) + " 0\n");
    }
  }
  file.close();
  OpenRequest request;
  request.file = file.fileName();
  request.unit = LengthUnit::mm;
  request.view = ViewChoice{"top", {}};
  window().open(request);
  ASSERT_TRUE(
      waitFor([&] { return document().file() == request.file && !document().loader().busy(); }));
  const double right = region().x_mm + region().side_mm, top = region().y_mm + region().side_mm;
  for (const QPointF& corner : {point(region().x_mm, region().y_mm), point(right, top),
                                point(region().x_mm, top), point(right, region().y_mm)}) {
    EXPECT_TRUE(QRectF(view().rect()).contains(corner)) << corner.x() << ", " << corner.y();
  }
  const double before = region().side_mm;
  drag(view(), point(right, top), point(right - 30, top - 30));
  EXPECT_NEAR(region().side_mm, before - 30, 1) << "by its corner";
}

TEST_F(RegionTest, ADragInsideMovesTheWindowAndKeepsItsSize) {
  document().region().setRect({40, 40, 60, 60});
  drag(view(), point(70, 70), point(100, 90));
  EXPECT_NEAR(region().x_mm, 70, 1e-6);
  EXPECT_NEAR(region().y_mm, 60, 1e-6);
  EXPECT_NEAR(region().side_mm, 60, 1e-9);
}

TEST_F(RegionTest, ACornerResizesAboutTheOppositeCorner) {
  document().region().setRect({40, 40, 60, 60});
  drag(view(), point(100, 100), point(130, 120));
  EXPECT_NEAR(region().x_mm, 40, 1e-6);
  EXPECT_NEAR(region().y_mm, 40, 1e-6);
  EXPECT_NEAR(region().side_mm, 90, 1e-6);
}

TEST_F(RegionTest, EscapeDuringADragReturnsToTheWindowBefore) {
  document().region().setRect({40, 40, 60, 60});
  const DocumentState before = document().state();
  const int entries = document().history().count();
  press(view(), point(70, 70));
  move(view(), point(100, 90), Qt::LeftButton);
  ASSERT_NE(document().state(), before);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_EQ(document().state(), before);
  release(view(), point(100, 90));
  EXPECT_EQ(document().state(), before);
  EXPECT_EQ(document().history().count(), entries);
}

TEST_F(RegionTest, AClickIsNotADrag) {
  const DocumentState before = document().state();
  drag(view(), point(60, 60), point(60, 60) + QPointF(1, 1));
  EXPECT_EQ(document().state(), before);
}

TEST_F(RegionTest, TypedNumbersGiveTheSameWindowAsADrag) {
  drag(view(), point(60, 90), point(120, 150));
  const Region dragged = region();
  document().history().undo();
  // Field by field, as fingers do; each entry is applied.
  child<QDoubleSpinBox>("region_side")->setValue(60);
  child<QDoubleSpinBox>("region_x")->setValue(60);
  child<QDoubleSpinBox>("region_y")->setValue(90);
  EXPECT_NEAR(region().x_mm, dragged.x_mm, 1e-6);
  EXPECT_NEAR(region().y_mm, dragged.y_mm, 1e-6);
  EXPECT_NEAR(region().side_mm, dragged.side_mm, 1e-6);
  EXPECT_EQ(region().level, dragged.level);
}

TEST_F(RegionTest, TheWheelChangesTheDetailAboutThePointer) {
  wheel(view(), point(70, 120), 1);
  EXPECT_EQ(document().detail(), 2);
  EXPECT_NEAR(region().centreX(), 100, 1e-6) << "kept on the map: half of 200 mm from the edge";
  wheel(view(), point(150, 100), 1);
  EXPECT_EQ(document().detail(), 3);
  EXPECT_NEAR(region().centreX(), 150, 1e-6);
  EXPECT_NEAR(region().centreY(), 100, 1e-6);
  wheel(view(), point(150, 100), -2);
  EXPECT_EQ(document().detail(), 1);
}

TEST_F(RegionTest, KeysStepThroughTheDetailsAndBack) {
  const DocumentState whole = document().state();
  QTest::keyClick(&window().detailView(), Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_EQ(document().detail(), 2);
  QTest::keyClick(&window().detailView(), Qt::Key_Equal, Qt::ControlModifier);
  EXPECT_EQ(document().detail(), 3);
  QTest::keyClick(&window().detailView(), Qt::Key_Minus, Qt::ControlModifier);
  EXPECT_EQ(document().detail(), 2);
  QTest::keyClick(&window().detailView(), Qt::Key_0, Qt::ControlModifier);
  EXPECT_EQ(document().state(), whole);
}

TEST_F(RegionTest, TheReferenceViewHasItsOwnKeys) {
  QTest::keyClick(&view(), Qt::Key_Plus);
  EXPECT_EQ(document().detail(), 2);
  QTest::keyClick(&view(), Qt::Key_Plus);
  const Region before = region();
  QTest::keyClick(&view(), Qt::Key_Right);
  EXPECT_NEAR(region().x_mm, before.x_mm + 0.05 * before.side_mm, 1e-9);
  EXPECT_THAT(announced(), HasSubstr("Resolution 3 of")) << "for who does not see it";
  QTest::keyClick(&view(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_LT(region().side_mm, before.side_mm);
}

TEST_F(RegionTest, SpaceArrowsAndEnterDrawAWindowAsADragDoes) {
  view().setFocus();
  const double step = 0.02 * 250;  // Of the map's longer side.
  QTest::keyClick(&view(), Qt::Key_Space);
  EXPECT_THAT(announced(), HasSubstr("Drawing a window from x 125.0 mm"));
  for (int i = 0; i < 4; ++i) {
    QTest::keyClick(&view(), Qt::Key_Right);
    QTest::keyClick(&view(), Qt::Key_Up);
  }
  EXPECT_THAT(announced(), HasSubstr("window 20.00 mm wide"));
  QTest::keyClick(&view(), Qt::Key_Left, Qt::ShiftModifier);
  QTest::keyClick(&view(), Qt::Key_Return);
  EXPECT_THAT(announced(), HasSubstr("window 20.00 mm wide, lower left corner at x 120.0 mm"));
  EXPECT_NEAR(region().side_mm, 4 * step, 1e-6);
  EXPECT_NEAR(region().x_mm, 125 - step, 1e-6);
  EXPECT_NEAR(region().y_mm, 100, 1e-6);
  EXPECT_EQ(document().history().count(), 1) << "one gesture is one entry";
  EXPECT_EQ(document().history().undoText(), "Draw window");
}

TEST_F(RegionTest, EscapeWhileDrawingByKeysReturnsToTheWindowBefore) {
  view().setFocus();
  const Region before = region();
  QTest::keyClick(&view(), Qt::Key_Space);
  for (int i = 0; i < 5; ++i) QTest::keyClick(&view(), Qt::Key_Down);
  EXPECT_FALSE(region() == before);
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_TRUE(region() == before);
  EXPECT_FALSE(document().history().canUndo());
}

TEST_F(RegionTest, ControlAndArrowsMoveTheWindowByAQuarter) {
  document().region().setRect({80, 80, 40, 40});
  QTest::keyClick(&window().detailView(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(region().x_mm, 90, 1e-9);
  QTest::keyClick(&window().detailView(), Qt::Key_Up, Qt::ControlModifier);
  EXPECT_NEAR(region().y_mm, 90, 1e-9);
  QTest::keyClick(&window().detailView(), Qt::Key_Left, Qt::ControlModifier);
  QTest::keyClick(&window().detailView(), Qt::Key_Down, Qt::ControlModifier);
  EXPECT_NEAR(region().x_mm, 80, 1e-9);
  EXPECT_NEAR(region().y_mm, 80, 1e-9);
}

TEST_F(RegionTest, TheLevelCanBeChosenWithoutMovingTheWindow) {
  document().region().setRect({40, 40, 60, 60});
  const Region before = region();
  auto* level = child<QComboBox>("region_level");
  ASSERT_EQ(level->count(), 3);
  EXPECT_EQ(level->itemText(1), "2/3 (level 1, \u03c3 0.500 mm)");
  level->setFocus();
  QTest::keyClick(level, Qt::Key_Home);
  EXPECT_EQ(region().level.value, 2);
  EXPECT_EQ(region().x_mm, before.x_mm);
  EXPECT_EQ(region().side_mm, before.side_mm);
}

TEST_F(RegionTest, UndoAndRedoBringBackIdenticalStatesUnderTheirNames) {
  const DocumentState first = document().state();
  const std::vector<float> first_heights = document().window()->heights_mm;
  QTest::keyClick(&window().detailView(), Qt::Key_Plus, Qt::ControlModifier);
  drag(view(), point(60, 90), point(120, 150));
  document().region().setGain(2);
  const DocumentState last = document().state();
  const std::vector<float> last_heights = document().window()->heights_mm;
  EXPECT_EQ(action("undo")->text(), "&Undo Vertical exaggeration");
  for (int i = 0; i < 3; ++i) QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().state(), first);
  EXPECT_EQ(document().window()->heights_mm, first_heights);
  EXPECT_EQ(action("redo")->text(), QString::fromUtf8("&Redo Resolution 1 \u2192 2"));
  EXPECT_FALSE(action("undo")->isEnabled());
  QTest::keyClick(&view(), Qt::Key_Y, Qt::ControlModifier);
  QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::keyClick(&view(), Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(document().state(), last);
  EXPECT_EQ(document().window()->heights_mm, last_heights);
}

TEST_F(RegionTest, GainStepsMergeIntoOneEntryAndTheGainIsShown) {
  auto* note = child<QLabel>("detail_note");
  EXPECT_FALSE(note->text().contains("heights"));
  document().region().setGain(1.5);
  document().region().setGain(2);
  EXPECT_EQ(document().history().count(), 1);
  EXPECT_TRUE(note->text().contains(QString::fromUtf8("heights \u00d7 2.00")));
  const float highest = document().window()->max_mm;
  document().history().undo();
  EXPECT_EQ(document().project().gain, 1);
  EXPECT_NEAR(highest, 2 * document().window()->max_mm, 1e-3);
}

TEST_F(RegionTest, TheHandScaleIsSaid) {
  document().region().setRect({40, 40, 80, 80});
  const double scale = handMapping(*document().window()).objectMmPerHandMm();
  const QString text = child<QLabel>("hand_scale")->text();
  EXPECT_TRUE(text.startsWith("Hand scale 1 : " + QString::number(scale, 'f', 2)))
      << text.toStdString();
}

TEST_F(RegionTest, AtTheLimitsTheCommandsAreOff) {
  EXPECT_FALSE(action("coarser")->isEnabled());
  EXPECT_FALSE(action("whole")->isEnabled());
  while (document().region().finer(document().region().aboutCentre())) {
  }
  EXPECT_FALSE(action("finer")->isEnabled());
  EXPECT_TRUE(action("coarser")->isEnabled());
}

TEST_F(RegionTest, PointerShapesSayWhatADragWillDo) {
  document().region().setRect({40, 40, 60, 60});
  move(view(), point(70, 70));
  EXPECT_EQ(view().cursor().shape(), Qt::SizeAllCursor);
  move(view(), point(40, 70));
  EXPECT_EQ(view().cursor().shape(), Qt::SizeHorCursor);
  move(view(), point(100, 100));
  EXPECT_EQ(view().cursor().shape(), Qt::SizeBDiagCursor);
  move(view(), point(150, 150));
  EXPECT_EQ(view().cursor().shape(), Qt::CrossCursor);
}

}  // namespace
}  // namespace relievo
