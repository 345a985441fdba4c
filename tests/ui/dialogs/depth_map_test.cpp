// SPDX-License-Identifier: BSD-3-Clause
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/depth_map_dialog.h"

namespace relievo {
namespace {

class DepthMapDialogTest : public GuiTest {
 protected:
  DepthMapDialog& openDialog() {
    EXPECT_TRUE(window().runCommand("depth_map"));
    auto* dialog = window().findChild<DepthMapDialog*>();
    EXPECT_NE(dialog, nullptr);
    EXPECT_TRUE(waitFor([dialog] { return !dialog->isStale(); }));
    return *dialog;
  }
  /// Chooses as a user does: the field tells of it.
  static void choose(DepthMapDialog& dialog, const char* name, const QVariant& data) {
    auto* box = dialog.findChild<QComboBox*>(QString::fromLatin1(name));
    const int index = box->findData(data);
    ASSERT_GE(index, 0) << name;
    box->setFocus();
    while (box->currentIndex() != index) {
      QTest::keyClick(box, box->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
    }
  }
  static void accept(DepthMapDialog& dialog) {
    QTest::mouseClick(dialog.findChild<QPushButton*>("depth_ok"), Qt::LeftButton);
  }
};

TEST_F(DepthMapDialogTest, ShowsTheShareOfMeasuredCellsAndTheSizeInMillimetres) {
  openRelief();
  DepthMapDialog& dialog = openDialog();
  EXPECT_TRUE(dialog.summary().contains("100.0 % of the cells are measured"))
      << dialog.summary().toStdString();
  const auto size = [&] { return dialog.findChild<QLabel*>("depth_size")->text(); };
  EXPECT_EQ(size(), "249.5 \u00d7 199.5 \u00d7 20.0 mm") << size().toStdString();
  choose(dialog, "depth_unit", static_cast<int>(LengthUnit::cm));
  EXPECT_EQ(size(), "2495.0 \u00d7 1995.0 \u00d7 200.0 mm") << size().toStdString();
}

TEST_F(DepthMapDialogTest, AChangeMakesThePreviewStaleAndOkTakesWhatIsOnShow) {
  openRelief();
  DepthMapDialog& dialog = openDialog();
  choose(dialog, "depth_cell_choice", 1);
  auto* cells = dialog.findChild<QSpinBox*>("depth_cells");
  ASSERT_TRUE(cells->isEnabled());
  cells->setValue(250);
  EXPECT_TRUE(dialog.isStale());
  ASSERT_TRUE(waitFor([&] { return !dialog.isStale(); }));
  EXPECT_TRUE(dialog.summary().contains("250 \u00d7 200 cells")) << dialog.summary().toStdString();
  EXPECT_EQ(document().surface()->map.frame.size.cols, 500);
  accept(dialog);
  EXPECT_EQ(document().surface()->map.frame.size.cols, 250);
  EXPECT_EQ(document().project().options.cells, 250);
  EXPECT_EQ(document().history().undoText(), "Depth map");
  document().history().undo();
  EXPECT_EQ(document().surface()->map.frame.size.cols, 500);
}

TEST_F(DepthMapDialogTest, OkBeforeThePreviewIsReadyWaitsForIt) {
  openRelief();
  DepthMapDialog& dialog = openDialog();
  choose(dialog, "depth_engine", "depthbuffer");
  EXPECT_TRUE(dialog.isStale());
  accept(dialog);
  ASSERT_TRUE(waitFor([&] { return document().surface()->engine == "depthbuffer"; }));
}

TEST_F(DepthMapDialogTest, CancelLeavesTheDocumentAlone) {
  openRelief();
  const auto before = document().surface();
  DepthMapDialog& dialog = openDialog();
  choose(dialog, "depth_view", "front");
  dialog.reject();
  QTest::qWait(50);
  EXPECT_EQ(document().surface(), before);
  EXPECT_FALSE(document().history().canUndo());
}

TEST_F(DepthMapDialogTest, StopEndsTheWorkAtOnceAndKeepsThePictureBefore) {
  openRelief();
  DepthMapDialog& dialog = openDialog();
  choose(dialog, "depth_cell_choice", 1);
  dialog.findChild<QSpinBox*>("depth_cells")->setValue(8000);
  auto* stop = dialog.findChild<QPushButton*>("depth_stop");
  ASSERT_TRUE(waitFor([&] { return stop->isVisible(); }));
  QTest::mouseClick(stop, Qt::LeftButton);
  EXPECT_FALSE(stop->isVisible());
  EXPECT_TRUE(dialog.isStale());
  EXPECT_TRUE(dialog.summary().contains("500 \u00d7 400 cells"));
}

TEST_F(DepthMapDialogTest, AMapThatCannotBeMadeIsRefusedInWordsBeforeTheWork) {
  openRelief();
  DepthMapDialog& dialog = openDialog();
  choose(dialog, "depth_cell_choice", 2);
  dialog.findChild<QDoubleSpinBox*>("depth_spacing")->setValue(0.0001);
  auto* problem = dialog.findChild<QLabel*>("depth_problem");
  ASSERT_TRUE(waitFor([&] { return problem->isVisible(); }));
  EXPECT_TRUE(problem->text().contains("Choose")) << problem->text().toStdString();
  EXPECT_FALSE(dialog.findChild<QPushButton*>("depth_ok")->isEnabled());
  dialog.findChild<QDoubleSpinBox*>("depth_spacing")->setValue(1);
  ASSERT_TRUE(waitFor([&] { return !dialog.isStale(); }));
  EXPECT_FALSE(problem->isVisible());
}

TEST_F(DepthMapDialogTest, AUnitSaidHereIsKeptForTheFolder) {
  openRelief();
  DepthMapDialog& dialog = openDialog();
  choose(dialog, "depth_unit", static_cast<int>(LengthUnit::cm));
  ASSERT_TRUE(waitFor([&] { return !dialog.isStale(); }));
  accept(dialog);
  EXPECT_EQ(document().surface()->unit, LengthUnit::cm);
  EXPECT_EQ(window().settings().unitOfFolder(document().file()), LengthUnit::cm);
}

TEST_F(DepthMapDialogTest, EveryFieldHasANameATooltipAndItsLabelsKey) {
  openRelief();
  DepthMapDialog& dialog = openDialog();
  QString seen;
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    const int at = label->text().indexOf('&');
    if (at < 0 || label->buddy() == nullptr) continue;
    EXPECT_FALSE(label->buddy()->accessibleName().isEmpty()) << label->text().toStdString();
    EXPECT_FALSE(label->buddy()->toolTip().isEmpty()) << label->text().toStdString();
    const QChar letter = label->text()[at + 1].toLower();
    EXPECT_FALSE(seen.contains(letter)) << label->text().toStdString();
    seen += letter;
  }
  for (const QAbstractButton* button : dialog.findChildren<QAbstractButton*>()) {
    const int at = button->text().indexOf('&');
    if (!button->isVisible() || at < 0 || button->objectName().isEmpty()) continue;
    EXPECT_FALSE(seen.contains(button->text()[at + 1].toLower())) << button->text().toStdString();
    seen += button->text()[at + 1].toLower();
  }
  EXPECT_GE(seen.size(), 12);
}

}  // namespace
}  // namespace relievo
