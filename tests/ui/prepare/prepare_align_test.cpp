// SPDX-License-Identifier: BSD-3-Clause
// Several scans of one object in the dialog Prepare: opened together, laid on each other, joined.
#include <cmath>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest/QTest>

#include "tests/ui/prepare/prepare_fixture.h"
#include "ui/prepare/prepare_work.h"

namespace relievo {
namespace {

class PrepareAlignTest : public PrepareGuiTest {
 protected:
  static constexpr BodyPlace kFront{};
  static constexpr BodyPlace kSide{.turned_deg = 40, .moved = {30, -20, 10}};

  PrepareDialog& openTwo() {
    return openTogether(
        {writeBody("front.ply", 0, 120, kFront), writeBody("side.ply", 70, 120, kSide)});
  }
  /// How far the second scan lies from where it belongs, mm, at places all over the body.
  static double worstError(const PrepareDialog& dialog) {
    const Pose& pose = dialog.result()->prepared.answer.poses.at(1);
    double worst = 0;
    for (const double azimuth : {-40.0, 40.0, 120.0}) {
      for (const double z : {-0.8, 0.0, 0.8}) {
        const auto p = onBody(azimuth, z);
        worst = std::max(worst, norm(pose(laid(p, kSide)) - laid(p, kFront)));
      }
    }
    return worst;
  }
  /// The form of the step that aligns.
  static void chooseMethod(PrepareDialog& dialog, int index) {
    QTreeWidget& steps = tree(dialog, "prepare_steps");
    steps.setCurrentItem(steps.topLevelItem(static_cast<int>(*dialog.state().alignStep())));
    choose(dialog, "align_method", index);
  }
  static void chooseScan(PrepareDialog& dialog, int row) {
    QTreeWidget& scans = tree(dialog, "prepare_scans");
    scans.setCurrentItem(scans.topLevelItem(row));
  }
  static QString lies(PrepareDialog& dialog, int row) {
    return tree(dialog, "prepare_scans").topLevelItem(row)->text(1);
  }
};

TEST_F(PrepareAlignTest, FilesOpenedTogetherAreJoinedAndOpened) {
  PrepareDialog& dialog = openTwo();
  EXPECT_EQ(tree(dialog, "prepare_scans").topLevelItemCount(), 2);
  EXPECT_EQ(lies(dialog, 0), "reference");
  EXPECT_EQ(lies(dialog, 1), "as stored");
  const ScanInfo& joined = dialog.result()->prepared.scan.info;
  ASSERT_EQ(joined.parts.size(), 2U);
  EXPECT_EQ(joined.parts[1].name, "side.ply");
  const auto points = joined.points;
  accept(dialog);
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(QFileInfo(document().file()).fileName(), "front-prepared.ply");
  EXPECT_EQ(document().source().scan->info.points, points);
  EXPECT_FALSE(document().history().canUndo()) << "opening is a new beginning";
}

TEST_F(PrepareAlignTest, AFolderOpensItsScansAndNothingElse) {
  const QString folder = path("parts");
  ASSERT_TRUE(QDir().mkpath(folder));
  writeBody("parts/b.ply", 70, 120, kSide);
  writeBody("parts/a.ply", 0, 120, kFront);
  QFile(path("parts/notes.md")).open(QIODevice::WriteOnly);
  window().openFolder(folder);
  ASSERT_TRUE(isShown(dialog()));
  QTreeWidget& scans = tree(dialog(), "prepare_scans");
  ASSERT_EQ(scans.topLevelItemCount(), 2);
  EXPECT_EQ(scans.topLevelItem(0)->text(0), "1 a.ply");
  EXPECT_EQ(scans.topLevelItem(1)->text(0), "2 b.ply");
  dialog().reject();
  ASSERT_TRUE(QDir().mkpath(path("empty")));
  window().openFolder(path("empty"));
  EXPECT_TRUE(window().message().contains("There is no scan")) << window().message().toStdString();
}

TEST_F(PrepareAlignTest, AScanThatIsNotTickedIsLeftOut) {
  PrepareDialog& dialog = openTwo();
  const auto both = dialog.result()->prepared.scan.points.size();
  QTreeWidget& scans = tree(dialog, "prepare_scans");
  chooseScan(dialog, 1);
  QTest::keyClick(&scans, Qt::Key_Space);
  ASSERT_TRUE(isShown(dialog));
  EXPECT_LT(dialog.result()->prepared.scan.points.size(), both);
  EXPECT_TRUE(dialog.result()->prepared.scan.info.parts.empty());
  chooseScan(dialog, 0);
  QTest::keyClick(&scans, Qt::Key_Space);
  auto* problem = dialog.findChild<QLabel*>("prepare_problem");
  ASSERT_TRUE(waitFor([&] { return problem->isVisible(); }));
  EXPECT_TRUE(problem->text().contains("No scan is chosen"));
}

TEST_F(PrepareAlignTest, AutomaticFindsWhereAScanLiesAndSaysHowWell) {
  PrepareDialog& dialog = openTwo();
  EXPECT_GT(worstError(dialog), 20);
  chooseMethod(dialog, 2);
  ASSERT_TRUE(isShown(dialog));
  EXPECT_LT(worstError(dialog), 0.2) << "half a spacing";
  const QString words = label(dialog, "prepare_words");
  EXPECT_TRUE(words.contains("rms over") && words.contains("in common") &&
              words.contains("within one spacing"))
      << words.toStdString();
  EXPECT_TRUE(lies(dialog, 1).endsWith(" mm")) << lies(dialog, 1).toStdString();
  // A step after it does not search again.
  addStep(dialog, "add_thin");
  ASSERT_TRUE(isShown(dialog));
  ASSERT_EQ(dialog.result()->recipe.steps.size(), 2U);
  EXPECT_EQ(std::get<Align>(dialog.result()->recipe.steps[0]).poses.size(), 2U);
  EXPECT_TRUE(label(dialog, "prepare_words").contains("rms over"));
}

TEST_F(PrepareAlignTest, DistancesOfTheScansAreColoursAndWords) {
  PrepareDialog& dialog = openTwo();
  chooseMethod(dialog, 2);
  ASSERT_TRUE(isShown(dialog));
  choose(dialog, "prepare_colour", 2);
  ASSERT_TRUE(isShown(dialog));
  EXPECT_TRUE(label(dialog, "prepare_words").contains("Blue lies on the surface"));
  std::size_t blue = 0, red = 0;
  for (const auto& c : cloudView(dialog).cloud()->colours) {
    if (c[2] > 150 && c[0] < 100) ++blue;
    if (c[0] > 150 && c[2] < 100) ++red;
  }
  EXPECT_GT(blue, 10'000U) << "scans that lie on each other";
  EXPECT_LT(red, blue / 100);
}

TEST_F(PrepareAlignTest, PlatesThatSlideAreRefusedInWords) {
  PrepareDialog& dialog = openTogether({writePlate("left.ply", 0), writePlate("right.ply", 20)});
  chooseMethod(dialog, 2);
  ASSERT_TRUE(isShown(dialog));
  const QString words = label(dialog, "prepare_words");
  EXPECT_TRUE(words.contains("right.ply") && words.contains("Not aligned")) << words.toStdString();
  EXPECT_EQ(dialog.result()->prepared.scan.points.size(), 6400U) << "left out, not laid anywhere";
}

TEST_F(PrepareAlignTest, PairsPickedByKeysLayAScanOnTheReference) {
  PrepareDialog& dialog = openTwo();
  chooseScan(dialog, 1);
  click(dialog, "prepare_pick");
  CloudView& scan = cloudView(dialog);
  CloudView& reference = cloudView(dialog, "prepare_reference_cloud");
  ASSERT_TRUE(reference.isVisible());
  const std::array<std::pair<double, double>, 3> places{{{0, -0.5}, {45, 0.1}, {10, 0.6}}};
  // From the side that the body's azimuth 20 looks to; in the scan it is turned.
  reference.look(turned(*standardRotation("right"), {0, -20, 0}));
  scan.look(turned(*standardRotation("right"), {0, -20 - kSide.turned_deg, 0}));
  QApplication::processEvents();
  for (const auto& [azimuth, z] : places) {
    const auto p = onBody(azimuth, z);
    ASSERT_TRUE(waitFor([&] { return scan.hasFocus(); })) << "the next place is on the scan";
    carryCross(scan, scan.pixelOf(laid(p, kSide)));
    EXPECT_TRUE(scan.accessibleDescription().startsWith("A point under the cross"));
    QTest::keyClick(&scan, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return reference.hasFocus(); })) << "then on the reference";
    carryCross(reference, reference.pixelOf(laid(p, kFront)));
    QTest::keyClick(&reference, Qt::Key_Return);
  }
  EXPECT_TRUE(label(dialog, "prepare_words").startsWith("3 "))
      << label(dialog, "prepare_words").toStdString();
  QTest::keyClick(&scan, Qt::Key_Escape);
  EXPECT_FALSE(reference.isVisible());
  EXPECT_TRUE(dialog.isVisible()) << "Escape ends the picking only";
  ASSERT_TRUE(isShown(dialog));
  EXPECT_LT(worstError(dialog), 0.2);
  EXPECT_EQ(std::get<Align>(dialog.state().now().steps[0].step).method, AlignMethod::points);
  QTest::keyClick(&dialog, Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(isShown(dialog));
  EXPECT_GT(worstError(dialog), 20) << "undone";
}

TEST_F(PrepareAlignTest, PairsPickedByMouseCanBeTakenBack) {
  PrepareDialog& dialog = openTwo();
  chooseScan(dialog, 1);
  click(dialog, "prepare_pick");
  CloudView& scan = cloudView(dialog);
  CloudView& reference = cloudView(dialog, "prepare_reference_cloud");
  reference.look(turned(*standardRotation("right"), {0, -20, 0}));
  scan.look(turned(*standardRotation("right"), {0, -20 - kSide.turned_deg, 0}));
  QApplication::processEvents();
  const auto pick = [&](CloudView& view, double azimuth, double z) {
    const BodyPlace& place = &view == &scan ? kSide : kFront;
    const QPointF at = view.pixelOf(laid(onBody(azimuth, z), place));
    press(view, at);
    release(view, at);
  };
  pick(scan, 0, -0.5);
  pick(reference, 10, 0.6);  // A mistake.
  click(dialog, "prepare_take_back");
  pick(reference, 0, -0.5);
  pick(scan, 45, 0.1);
  pick(reference, 45, 0.1);
  click(dialog, "prepare_pick");
  ASSERT_EQ(std::get<Align>(dialog.state().now().steps[0].step).pairs.size(), 2U);
  auto* problem = dialog.findChild<QLabel*>("prepare_problem");
  ASSERT_TRUE(waitFor([&] { return problem->isVisible(); }));
  EXPECT_TRUE(problem->text().contains("three")) << problem->text().toStdString();
  click(dialog, "prepare_pick");
  pick(scan, 10, 0.6);
  pick(reference, 10, 0.6);
  click(dialog, "prepare_pick");
  ASSERT_TRUE(isShown(dialog));
  EXPECT_LT(worstError(dialog), 0.2);
}

TEST_F(PrepareAlignTest, TheErrorOfEveryPairIsShownAndTheWorstIsRemoved) {
  PrepareDialog& dialog = openTwo();
  QTreeWidget& pairs = tree(dialog, "prepare_pairs");
  EXPECT_FALSE(pairs.isVisible());
  chooseScan(dialog, 1);
  click(dialog, "prepare_pick");
  ASSERT_TRUE(pairs.isVisible());
  CloudView& scan = cloudView(dialog);
  CloudView& reference = cloudView(dialog, "prepare_reference_cloud");
  reference.look(turned(*standardRotation("right"), {0, -20, 0}));
  scan.look(turned(*standardRotation("right"), {0, -20 - kSide.turned_deg, 0}));
  QApplication::processEvents();
  const auto pick = [](CloudView& view, const BodyPlace& place, double azimuth, double z) {
    const QPointF at = view.pixelOf(laid(onBody(azimuth, z), place));
    press(view, at);
    release(view, at);
  };
  const auto pickPair = [&](double azimuth, double z, double wrong_by = 0) {
    pick(scan, kSide, azimuth, z);
    pick(reference, kFront, azimuth + wrong_by, z);
  };
  const auto errorOf = [&pairs](int row) { return pairs.topLevelItem(row)->text(1); };
  const auto mmOf = [&](int row) { return errorOf(row).section(' ', 0, 0).toDouble(); };
  pickPair(0, -0.5);
  pickPair(45, 0.1);
  ASSERT_EQ(pairs.topLevelItemCount(), 2);
  EXPECT_EQ(errorOf(0), "") << "two pairs say no pose";
  pickPair(25, -0.1, 15);  // A mistake.
  pickPair(10, 0.6);
  pickPair(40, -0.6);
  ASSERT_EQ(pairs.topLevelItemCount(), 5);
  for (int row = 0; row < 5; ++row) {
    EXPECT_EQ(errorOf(row).endsWith("worst"), row == 2) << errorOf(row).toStdString();
    EXPECT_TRUE(errorOf(row).contains(" mm"));
    EXPECT_LE(mmOf(row), mmOf(2));
  }
  EXPECT_GT(mmOf(2), 4);
  EXPECT_TRUE(label(dialog, "prepare_words").contains("pair 3 fits worst"))
      << label(dialog, "prepare_words").toStdString();
  pairs.setCurrentItem(pairs.topLevelItem(2));
  pairs.setFocus();
  QTest::keyClick(&pairs, Qt::Key_Delete);
  ASSERT_EQ(pairs.topLevelItemCount(), 4);
  for (int row = 0; row < 4; ++row) EXPECT_LT(mmOf(row), 1) << row;
  // What is taken back afterwards is the pair placed last, and a half pair stays half.
  click(dialog, "prepare_take_back");
  EXPECT_EQ(pairs.topLevelItemCount(), 3);
  EXPECT_TRUE(label(dialog, "prepare_words").startsWith("Now place 4 on the reference"));
  pairs.setCurrentItem(pairs.topLevelItem(0));
  click(dialog, "prepare_remove_pair");
  EXPECT_EQ(pairs.topLevelItemCount(), 2);
  EXPECT_TRUE(label(dialog, "prepare_words").startsWith("Now place 3 on the reference"));
  pick(reference, kFront, 40, -0.6);
  ASSERT_EQ(pairs.topLevelItemCount(), 3);
  for (int row = 0; row < 3; ++row) EXPECT_LT(mmOf(row), 1) << row;
  click(dialog, "prepare_pick");
  EXPECT_FALSE(pairs.isVisible());
  ASSERT_TRUE(isShown(dialog));
  EXPECT_LT(worstError(dialog), 0.2);
}

TEST_F(PrepareAlignTest, PairsInOneLineAreToldWhileTheyArePicked) {
  PrepareDialog& dialog = openTwo();
  chooseScan(dialog, 1);
  click(dialog, "prepare_pick");
  CloudView& scan = cloudView(dialog);
  CloudView& reference = cloudView(dialog, "prepare_reference_cloud");
  const BodyPlace same = kFront;
  for (int i = 0; i < 3; ++i) {
    scan.pointChosen(laid(onBody(20, 0.1 * i), same));
    reference.pointChosen(laid(onBody(20, 0.1 * i), same));
  }
  EXPECT_TRUE(label(dialog, "prepare_words").contains("nearly in one line"))
      << label(dialog, "prepare_words").toStdString();
  EXPECT_EQ(tree(dialog, "prepare_pairs").topLevelItem(0)->text(1), "");
}

TEST_F(PrepareAlignTest, AFileOfSeveralScansIsSplitAndEachIsChosenForItself) {
  // Two scans of a PTX file: 30 x 20 points each, the second moved by its own matrix.
  QByteArray ptx;
  for (const char* place : {"0 0 0 1", "500 0 0 1"}) {
    ptx += "30\n20\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
    ptx += QByteArray(place) + '\n';
    for (int i = 0; i < 600; ++i) {
      ptx += QByteArray::number(1 + i / 20) + ' ' + QByteArray::number(1 + i % 20) + " 5 0.5\n";
    }
  }
  QFile file(path("rooms.ptx"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(ptx);
  file.close();
  window().openTogether({file.fileName(), writePlate("plate.ply", 0)});
  PrepareDialog& dialog = this->dialog();
  auto* problem = dialog.findChild<QLabel*>("prepare_problem");
  // The plate says its unit, the rooms do not.
  ASSERT_TRUE(waitFor([&] { return problem->isVisible(); }));
  EXPECT_TRUE(problem->text().contains("not all in one unit")) << problem->text().toStdString();
  chooseScan(dialog, 1);
  click(dialog, "prepare_remove_scan");
  ASSERT_TRUE(isShown(dialog));
  EXPECT_EQ(dialog.result()->prepared.scan.points.size(), 1200U);
  chooseScan(dialog, 0);
  click(dialog, "prepare_split");
  ASSERT_TRUE(isShown(dialog));
  QTreeWidget& scans = tree(dialog, "prepare_scans");
  ASSERT_EQ(scans.topLevelItemCount(), 2);
  EXPECT_TRUE(scans.topLevelItem(1)->text(0).startsWith("2 rooms.ptx / "))
      << scans.topLevelItem(1)->text(0).toStdString();
  EXPECT_EQ(dialog.result()->prepared.scan.points.size(), 1200U);
  EXPECT_EQ(dialog.result()->recipe.scans.at(1).parts, std::vector<int>{2});
  chooseScan(dialog, 0);
  QTest::keyClick(&scans, Qt::Key_Space);
  ASSERT_TRUE(isShown(dialog));
  ASSERT_EQ(dialog.result()->prepared.scan.points.size(), 600U);
  EXPECT_EQ(dialog.result()->prepared.scan.info.bounds->min, (FilePoint{501, 1, 5}))
      << "its pose is kept";
}

TEST_F(PrepareAlignTest, AnotherReferenceStaysWhereItIs) {
  PrepareDialog& dialog = openTwo();
  chooseScan(dialog, 1);
  click(dialog, "prepare_reference");
  chooseMethod(dialog, 2);
  ASSERT_TRUE(isShown(dialog));
  EXPECT_EQ(lies(dialog, 1), "reference");
  EXPECT_EQ(dialog.result()->prepared.answer.poses.at(1), Pose{});
  EXPECT_NE(dialog.result()->prepared.answer.poses.at(0), Pose{});
}

}  // namespace
}  // namespace relievo
