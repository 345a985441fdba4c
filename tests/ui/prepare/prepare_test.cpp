// SPDX-License-Identifier: BSD-3-Clause
// Surface > Prepare... through its own widgets.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest/QTest>

#include "core/prepare/crop.h"
#include "core/project/project.h"
#include "core/provenance/embedded.h"
#include "core/provenance/prepared_state.h"
#include "tests/ui/prepare/prepare_fixture.h"
#include "ui/prepare/prepare_rows.h"

namespace relievo {
namespace {

class PrepareTest : public PrepareGuiTest {};

TEST_F(PrepareTest, AStepLeavesOutStraysAndSaysHowMany) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  EXPECT_EQ(label(dialog, "prepare_total"), "200,000 of 200,000 points stay.");
  addStep(dialog, "add_crop_box");
  setNumber(dialog, "crop_x_max", 100);
  ASSERT_TRUE(waitFor([&] { return !dialog.isStale(); }));
  // x = 0, 0.5, ..., 100 in 400 rows.
  EXPECT_EQ(label(dialog, "prepare_total"), "80,400 of 200,000 points stay.");
  EXPECT_EQ(tree(dialog, "prepare_steps").topLevelItem(0)->text(1),
            QString::fromUtf8("\u2212119,600"));
}

TEST_F(PrepareTest, OkWritesTheScanAndItIsOneStepOfTheHistory) {
  openRelief();
  const QString before = document().file();
  const auto surface = document().surface();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_crop_box");
  setNumber(dialog, "crop_x_max", 100);
  accept(dialog);
  ASSERT_TRUE(waitFor([&] { return document().file() != before && !document().loader().busy(); }));
  EXPECT_EQ(QFileInfo(document().file()).fileName(), "relief-prepared.ply");
  EXPECT_EQ(document().surface()->info.points, 80400U);
  EXPECT_EQ(document().history().undoText(), "Prepare");
  EXPECT_EQ(document().surface()->unit, LengthUnit::mm);
  const Project prepared = window().project();
  EXPECT_TRUE(QString::fromStdString(prepared.file).endsWith("relief-prepared.ply"));
  EXPECT_EQ(prepared.sha256.size(), 64U);
  document().history().undo();
  EXPECT_EQ(document().file(), before);
  EXPECT_EQ(document().surface(), surface);
  EXPECT_TRUE(window().windowTitle().contains("relief.ply"));
  EXPECT_TRUE(QString::fromStdString(window().project().file).endsWith("relief.ply"));
  document().history().redo();
  EXPECT_EQ(document().surface()->info.points, 80400U);
}

TEST_F(PrepareTest, TheOfferedNameLiesBesideTheScan) {
  PreparedFileRow row;
  const auto offered = [&row](const QString& scan) {
    row.suggestBeside(scan);
    return row.findChild<QLineEdit*>("prepare_file")->text().toStdString();
  };
  EXPECT_EQ(offered("/no such scan.ply"), "/no such scan-prepared.ply");
  EXPECT_EQ(offered("/no/such/scan.las"), "/no/such/scan-prepared.ply");
}

TEST_F(PrepareTest, WhatIsWrittenSaysWhereItCameFrom) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_thin");
  setNumber(dialog, "thin_spacing", 2);
  accept(dialog);
  ASSERT_TRUE(waitFor([&] { return document().file().endsWith("-prepared.ply"); }));
  const auto state = embeddedState(document().file().toStdString());
  ASSERT_TRUE(state.has_value());
  EXPECT_TRUE(isPreparedState(*state));
  EXPECT_NE(state->find("\"spacing_mm\":2.0"), std::string::npos) << *state;
  EXPECT_NE(state->find("relief.ply"), std::string::npos);
}

TEST_F(PrepareTest, CancelLeavesTheDocumentAndTheDiskAlone) {
  openRelief();
  const auto before = document().surface();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_outliers");
  dialog.reject();
  QTest::qWait(50);
  EXPECT_EQ(document().surface(), before);
  EXPECT_FALSE(document().history().canUndo());
  EXPECT_FALSE(QFileInfo::exists(path("relief-prepared.ply")));
}

TEST_F(PrepareTest, UndoAndRedoOfStepsByKeys) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_outliers");
  addStep(dialog, "add_thin");
  QTreeWidget& steps = tree(dialog, "prepare_steps");
  EXPECT_EQ(steps.topLevelItemCount(), 2);
  QTest::keyClick(&steps, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(steps.topLevelItemCount(), 1);
  QTest::keyClick(&steps, Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(steps.topLevelItemCount(), 2);
  steps.setFocus();
  steps.setCurrentItem(steps.topLevelItem(0));
  QTest::keyClick(&steps, Qt::Key_Down, Qt::ControlModifier);
  EXPECT_TRUE(steps.topLevelItem(1)->text(0).startsWith("Outliers"));
  QTest::keyClick(&steps, Qt::Key_Space);
  EXPECT_EQ(steps.topLevelItem(1)->checkState(0), Qt::Unchecked);
  QTest::keyClick(&steps, Qt::Key_Delete);
  EXPECT_EQ(steps.topLevelItemCount(), 1);
}

TEST_F(PrepareTest, BeforeAndAfterShowWhatStaysAndWhatGoes) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_crop_box");
  setNumber(dialog, "crop_x_max", 100);
  ASSERT_TRUE(waitFor([&] { return !dialog.isStale() && !dialog.isBusy(); }));
  const auto drawn = [&](CloudStage stage) {
    dialog.findChild<QComboBox*>("prepare_stage")->setCurrentIndex(static_cast<int>(stage));
    EXPECT_TRUE(waitFor([&] { return !dialog.isBusy(); }));
    return cloudView(dialog).cloud()->points.size();
  };
  EXPECT_EQ(drawn(CloudStage::before), 200'000U);
  EXPECT_EQ(drawn(CloudStage::after), 80'400U);
  EXPECT_EQ(drawn(CloudStage::both), 200'000U);
}

TEST_F(PrepareTest, StopEndsTheWorkAtOnceAndNothingIsTaken) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  const QString total = label(dialog, "prepare_total");
  addStep(dialog, "add_outliers");
  dialog.findChild<QSpinBox*>("outliers_neighbours")->setValue(1000);  // Minutes of work.
  auto* stop = dialog.findChild<QPushButton*>("prepare_stop");
  ASSERT_TRUE(waitFor([&] { return stop->isVisible(); }));
  QTest::mouseClick(stop, Qt::LeftButton);
  EXPECT_FALSE(stop->isVisible());
  EXPECT_TRUE(dialog.isStale());
  EXPECT_EQ(label(dialog, "prepare_total"), total);
}

TEST_F(PrepareTest, WhatCannotBeDoneIsSaidInWords) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_crop_box");
  setNumber(dialog, "crop_x_max", -500);
  auto* problem = dialog.findChild<QLabel*>("prepare_problem");
  ASSERT_TRUE(waitFor([&] { return problem->isVisible(); }));
  EXPECT_TRUE(problem->text().contains("No point is left")) << problem->text().toStdString();
  EXPECT_FALSE(dialog.findChild<QPushButton*>("prepare_ok")->isEnabled());
  QTest::mouseClick(dialog.findChild<QPushButton*>("prepare_undo"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !dialog.isStale(); }));
  EXPECT_FALSE(problem->isVisible());
  addStep(dialog, "add_classes");
  ASSERT_TRUE(waitFor([&] { return !dialog.isStale(); }));
  EXPECT_TRUE(label(dialog, "prepare_words").contains("states no classes"))
      << label(dialog, "prepare_words").toStdString();
}

/// How many points of the relief an outline keeps.
std::size_t keptOf(const CropOutline& outline) {
  std::size_t count = 0;
  for (int row = 0; row < 400; ++row) {
    for (int col = 0; col < 500; ++col) {
      if (keeps(outline, FilePoint{0.5 * col, 0.5 * row, 0})) ++count;
    }
  }
  return count;
}

TEST_F(PrepareTest, AnOutlineIsDrawnByMouseInOneDrag) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_crop_outline");
  CloudView& view = cloudView(dialog);
  ASSERT_EQ(view.tool(), CloudView::Tool::outline);
  const std::array<FilePoint, 4> corners{{{20, 20, 0}, {150, 20, 0}, {150, 120, 0}, {20, 120, 0}}};
  press(view, view.pixelOf(corners[0]));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const QPointF from = view.pixelOf(corners[i]);
    const QPointF to = view.pixelOf(corners[(i + 1) % corners.size()]);
    for (int k = 1; k <= 10; ++k) move(view, from + 0.1 * k * (to - from), Qt::LeftButton);
  }
  release(view, view.pixelOf(corners[0]));
  EXPECT_EQ(view.tool(), CloudView::Tool::turn);
  ASSERT_TRUE(isShown(dialog));
  const auto& outline = std::get<CropOutline>(dialog.state().now().steps[0].step);
  EXPECT_GE(outline.outline.size(), 30U);
  const std::size_t kept = dialog.result()->prepared.scan.points.size();
  EXPECT_EQ(kept, keptOf(outline));
  EXPECT_NEAR(static_cast<double>(kept), 260 * 200, 0.03 * 260 * 200) << "130 x 100 mm";
  EXPECT_EQ(outline.view, *standardRotation("top"));
}

TEST_F(PrepareTest, AnOutlineIsDrawnByKeysAndEscapeLeavesOnlyTheDrawing) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_crop_outline");
  CloudView& view = cloudView(dialog);
  for (const FilePoint& corner : {FilePoint{20, 20, 0}, {220, 20, 0}, {120, 180, 0}, {5, 5, 0}}) {
    carryCross(view, view.pixelOf(corner));
    QTest::keyClick(&view, Qt::Key_Return);
  }
  QTest::keyClick(&view, Qt::Key_Backspace);
  EXPECT_TRUE(view.accessibleDescription().startsWith("3 "));
  QTest::keyClick(&view, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(isShown(dialog));
  const auto& outline = std::get<CropOutline>(dialog.state().now().steps[0].step);
  ASSERT_EQ(outline.outline.size(), 3U);
  EXPECT_NEAR(outline.outline[1][0], 220, 1);
  EXPECT_NEAR(outline.outline[2][1], 180, 1);
  EXPECT_EQ(dialog.result()->prepared.scan.points.size(), keptOf(outline));
  click(dialog, "outline_draw");
  QTest::keyClick(&view, Qt::Key_Return);
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(view.tool(), CloudView::Tool::turn);
  EXPECT_TRUE(dialog.isVisible());
  EXPECT_EQ(std::get<CropOutline>(dialog.state().now().steps[0].step).outline.size(), 3U);
}

TEST_F(PrepareTest, AViewTurnsMovesAndComesNearerByMouseAndKeys) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  CloudView& view = cloudView(dialog);
  const CloudCamera first = view.camera();
  const QPointF middle = QRectF(view.rect()).center();
  drag(view, middle, middle + QPointF(50, 20));
  EXPECT_NE(view.camera().view, first.view);
  choose(dialog, "prepare_side", 0);
  QTest::keyClick(dialog.findChild<QComboBox*>("prepare_side"), Qt::Key_Return);
  const CloudCamera again = view.camera();
  QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_NE(view.camera().view, again.view);
  QTest::keyClick(&view, Qt::Key_Right);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(view.camera().view[i], again.view[i], 1e-12);
  wheel(view, middle, 1);
  EXPECT_LT(view.camera().height, again.height);
  QTest::keyClick(&view, Qt::Key_Minus);
  EXPECT_NEAR(view.camera().height, again.height, 1e-9);
  drag(view, middle, middle + QPointF(30, 0), Qt::RightButton);
  EXPECT_NE(view.camera().middle, again.middle);
  QTest::keyClick(&view, Qt::Key_Home);
  EXPECT_NEAR(norm(view.camera().middle - again.middle), 0, 1e-6);
}

TEST_F(PrepareTest, EveryControlHasANameOfItsOwnAndATooltip) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  for (const char* step : {"add_crop_box", "add_lonely", "add_base", "add_classes"}) {
    addStep(dialog, step);
    int named = 0;
    for (const QWidget* w : dialog.findChildren<QWidget*>()) {
      if (!w->isVisible() || (w->focusPolicy() & Qt::TabFocus) == 0) continue;
      if (qobject_cast<const QAbstractSpinBox*>(w->parentWidget()) != nullptr) continue;
      if (w->objectName().startsWith("qt_")) continue;
      EXPECT_FALSE(w->accessibleName().isEmpty())
          << w->metaObject()->className() << ' ' << w->objectName().toStdString();
      ++named;
    }
    EXPECT_GE(named, 8) << step;
  }
  QString seen;
  for (const QAbstractButton* button : dialog.findChildren<QAbstractButton*>()) {
    const int at = button->text().indexOf('&');
    if (!button->isVisible() || at < 0) continue;
    EXPECT_FALSE(button->toolTip().isEmpty() && !button->objectName().isEmpty() &&
                 button->objectName() != "prepare_ok")
        << button->objectName().toStdString();
    EXPECT_FALSE(seen.contains(button->text()[at + 1].toLower())) << button->text().toStdString();
    seen += button->text()[at + 1].toLower();
  }
  EXPECT_GE(seen.size(), 3);
}

}  // namespace
}  // namespace relievo
