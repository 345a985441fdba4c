// SPDX-License-Identifier: BSD-3-Clause
#include "ui/plots/profile_strip.h"

#include <fstream>
#include <iterator>
#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QTableWidget>
#include <QToolButton>
#include <QtTest/QTest>

#include "core/provenance/embedded.h"
#include "tests/ui/gui_fixture.h"
#include "ui/views/overlays/view_labels.h"

namespace relievo {
namespace {

class ProfileStripTest : public GuiTest {
 protected:
  ProfileStripTest() { openRelief(); }
  ProfileStrip& strip() { return *child<ProfileStrip>("profile_strip"); }
  QWidget& curve() { return *child<QWidget>("profile_curve"); }
  QString readout() { return child<QLabel>("profile_readout")->text(); }
  /// Over the dome of 20 mm in 50 mm, from the plate to its top and down again.
  void measure() {
    document().edit({}, [](Project& p) {
      p.measurements = {
          {.name = "dome", .kind = MeasureKind::profile, .places = {{20, 90}, {180, 90}}}};
    });
    QApplication::processEvents();
  }
};

TEST_F(ProfileStripTest, IsThereOnceThereIsAProfileAndSaysLengthAndDepth) {
  EXPECT_FALSE(strip().isVisible());
  measure();
  ASSERT_TRUE(strip().isVisible());
  EXPECT_EQ(readout(), "Profile dome: 160.00 mm long, 20.00 mm deep");
  action("undo")->trigger();
  EXPECT_FALSE(strip().isVisible());
}

TEST_F(ProfileStripTest, LabelsAndLinesInTheViewsFollowTheVerticalExaggeration) {
  document().edit({}, [](Project& p) {
    p.measurements = {
        {.name = "top", .kind = MeasureKind::distance, .places = {{98, 90}, {102, 90}}}};
  });
  QApplication::processEvents();
  const auto* labels = window().detailView().findChild<ViewLabels*>();
  ASSERT_EQ(labels->labels().size(), 1U);
  const double label_z = labels->labels()[0].at.z;
  const auto line_z = [this] { return window().detailView().sceneState().lines.at(0).at(0).z; };
  const double z = line_z();
  ASSERT_NEAR(z, 20, 0.2);
  ASSERT_NEAR(label_z, 20, 0.2);
  document().region().setGain(2);
  EXPECT_NEAR(labels->labels()[0].at.z, 2 * label_z, 1e-9);
  EXPECT_NEAR(line_z(), 2 * z, 1e-9);
  action("undo")->trigger();
  EXPECT_NEAR(labels->labels()[0].at.z, label_z, 1e-9);
  EXPECT_NEAR(line_z(), z, 1e-9);
}

TEST_F(ProfileStripTest, TheCursorCarriesTheHandAndIsMarkedInBothViews) {
  measure();
  QTest::keyClick(&curve(), Qt::Key_Home);
  for (int i = 0; i < 16; ++i) QTest::keyClick(&curve(), Qt::Key_PageUp);
  const auto at = strip().cursorAt();
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x, 100, 0.5);
  EXPECT_NEAR(at->z, 20, 0.1);
  const auto hand = window().detailView().hand();
  ASSERT_TRUE(hand) << "the hand is carried there";
  EXPECT_NEAR(hand->x, at->x, 1e-9);
  EXPECT_NEAR(hand->y, at->y, 1e-9);
  for (SurfaceView* view : {static_cast<SurfaceView*>(&window().detailView()),
                            static_cast<SurfaceView*>(&window().referenceView())}) {
    const auto* labels = view->findChild<ViewLabels*>();
    ASSERT_TRUE(labels->mark());
    EXPECT_NEAR(labels->mark()->x, at->x, 1e-9);
  }
  EXPECT_TRUE(readout().contains("height 20.00 mm")) << readout().toStdString();
}

TEST_F(ProfileStripTest, ADragOrShiftAndArrowsReadLengthAndDepthOfAPiece) {
  measure();
  const double y = 0.5 * curve().height();
  drag(curve(), QPointF(0, y), QPointF(curve().width(), y));
  EXPECT_EQ(
      readout(),
      "Profile dome: 0.00 to 160.00 mm: 160.00 mm long, 20.00 mm deep, ends differ by 0.00 mm");
  QTest::keyClick(&curve(), Qt::Key_Home);
  QTest::keyClick(&curve(), Qt::Key_PageUp, Qt::ShiftModifier);
  EXPECT_TRUE(readout().contains(" 5.00 mm long")) << readout().toStdString();
}

TEST_F(ProfileStripTest, IsSavedAsItIsShownWithTheStateItCameFrom) {
  measure();
  QTest::keyClick(&curve(), Qt::Key_End);
  action("profile_save")->trigger();
  auto* dialog = window().findChild<QFileDialog*>("profile_dialog");
  ASSERT_NE(dialog, nullptr);
  Q_EMIT dialog->fileSelected(path("dome.svg"));
  dialog->close();
  std::ifstream in(path("dome.svg").toStdString());
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("at 160.00 mm"), std::string::npos) << "the cursor's numbers are in it";
  EXPECT_TRUE(embeddedState(path("dome.svg").toStdString()).has_value());
}

TEST_F(ProfileStripTest, IsHiddenByItsButtonAndShownByTheMenu) {
  measure();
  QTest::mouseClick(child<QToolButton>("profile_close_button"), Qt::LeftButton);
  EXPECT_FALSE(strip().isVisible());
  EXPECT_FALSE(action("show_profile")->isChecked());
  action("show_profile")->trigger();
  EXPECT_TRUE(strip().isVisible());
}

TEST_F(ProfileStripTest, LinesAndAreasAreLabelledWhereTheyAreSeen) {
  document().edit({}, [](Project& p) {
    p.measurements = {
        {.name = "a", .kind = MeasureKind::distance, .places = {{20, 20}, {50, 20}}},
        {.name = "b", .kind = MeasureKind::area, .places = {{10, 10}, {40, 10}, {40, 40}}}};
  });
  QApplication::processEvents();
  const auto* labels = window().detailView().findChild<ViewLabels*>();
  ASSERT_EQ(labels->labels().size(), 2U);
  EXPECT_TRUE(labels->labels()[0].text.startsWith("a: 30"))
      << labels->labels()[0].text.toStdString();
  EXPECT_NEAR(labels->labels()[0].at.x, 35, 1e-9);
  EXPECT_TRUE(labels->labels()[1].text.endsWith(QString::fromUtf8("mm\u00b2")));
  ReferenceView& overview = window().referenceView();
  const QPointF known = overview.pointOf(35, 20);
  const QPointF seen = overview.pointOver({35, 20, 0});
  EXPECT_NEAR(seen.x(), known.x(), 1.5);
  EXPECT_NEAR(seen.y(), known.y(), 1.5);
}

}  // namespace
}  // namespace relievo
