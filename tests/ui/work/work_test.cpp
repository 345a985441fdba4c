// SPDX-License-Identifier: BSD-3-Clause
// Named places, undo that outlives the program, and work that a crash left.
#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QtTest/QTest>

#include "core/project/autosave.h"
#include "core/project/project.h"
#include "tests/ui/gui_fixture.h"
#include "ui/frame/message_strip.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/replay_control.h"

namespace relievo {
namespace {

class WorkTest : public GuiTest {
 protected:
  QString copies() const { return path("state/relievo/autosave"); }
  int copyCount() const {
    return QDir(copies()).entryList({QStringLiteral("*.json")}, QDir::Files).size();
  }
  QPushButton* stripButton(const QString& text) {
    for (auto* button : window().findChild<MessageStrip*>()->findChildren<QPushButton*>()) {
      if (button->isVisibleTo(&window()) && button->text().remove('&') == text) return button;
    }
    return nullptr;
  }
  PlacesPanel& places() { return *window().findChild<PlacesPanel*>(); }
  QListWidget& list() { return *child<QListWidget>("places_list"); }
  void typeName(const QString& name) {
    QLineEdit* editor = nullptr;
    for (auto* one : list().findChildren<QLineEdit*>()) {
      if (one->isVisible()) editor = one;
    }
    ASSERT_NE(editor, nullptr) << "the name can be typed at once";
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
    QApplication::processEvents();  // The list takes the name later.
  }
  /// What a program that was killed leaves: a copy and a lock that nobody holds.
  void leaveWork(const Project& project) {
    QDir().mkpath(copies());
    writeProject((copies() + "/autosave-dead01.json").toStdString(), project);
    QFile lock(copies() + "/autosave-dead01.lock");
    ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
  }
};

TEST_F(WorkTest, APlaceIsNamedGoneToRenamedAndDeletedByKeys) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  document().region().setGain(2);
  const Region there = document().project().region;
  QTest::keyClick(&window().detailView(), Qt::Key_N, Qt::ControlModifier);
  ASSERT_EQ(places().places().size(), 1U);
  typeName("nose");
  EXPECT_EQ(places().places()[0].name, "nose");
  document().region().whole();
  document().region().setRect({100, 20, 40, 40});
  document().region().setGain(1);
  window().runCommand("name_place");
  ASSERT_EQ(places().places().size(), 2U);
  QTest::keyClick(list().findChild<QLineEdit*>(), Qt::Key_Escape);
  QTest::keyClick(&window().detailView(), Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_EQ(document().project().region, there) << "next, round and round";
  EXPECT_EQ(document().project().gain, 2);
  EXPECT_EQ(document().history().undoText(), "Go to nose");
  QTest::keyClick(&window().detailView(), Qt::Key_PageUp, Qt::ControlModifier);
  EXPECT_NE(document().project().region, there);
  list().setFocus();
  list().setCurrentRow(0);
  QTest::keyClick(&list(), Qt::Key_Return);
  EXPECT_EQ(document().project().region, there) << "Enter goes to it";
  QTest::keyClick(&list(), Qt::Key_F2);
  typeName("left eye");
  EXPECT_EQ(places().places()[0].name, "left eye");
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_EQ(places().places().size(), 1U);
}

TEST_F(WorkTest, AMarkerIsSetAndRemovedUnderTheHandAndGoneTo) {
  openRelief();
  window().runCommand("finer");
  document().region().setRect({40, 40, 50, 50});
  const Region there = document().project().region;  // The pointer is elsewhere: its centre counts.
  QTest::keyClick(&window().detailView(), Qt::Key_B, Qt::ControlModifier);
  ASSERT_EQ(places().places().size(), 1U);
  EXPECT_EQ(places().places()[0].name, "Marker 1");
  EXPECT_EQ(child<QLabel>("status_message")->text(), "Marker 1 set.");
  document().region().move(1, 0);
  window().runCommand("beacon");
  ASSERT_EQ(places().places().size(), 2U);
  document().region().move(-0.95, 0);  // 0.05 of the window: 4 mm of hand.
  window().runCommand("beacon");
  ASSERT_EQ(places().places().size(), 1U);
  EXPECT_EQ(child<QLabel>("status_message")->text(), "Marker 1 removed.");
  EXPECT_EQ(places().places()[0].name, "Marker 2");
  window().runCommand("beacon");
  EXPECT_EQ(places().places()[1].name, "Marker 1") << "the first number that is free";
  window().runCommand("next_place");
  EXPECT_NEAR(document().project().region.x_mm, there.x_mm + there.side_mm, 1e-9);
}

TEST_F(WorkTest, AMarkerIsAPointThatEveryResolutionFindsAgain) {
  openRelief();
  window().runCommand("finer");
  window().runCommand("finer");
  document().region().setRect({85, 95, 20, 20});
  const int fine = document().detail();
  const Region there = document().project().region;
  window().runCommand("beacon");
  ASSERT_TRUE(places().places().at(0).is_point);
  document().region().setRect({0, 0, 150, 150});
  const Region coarse = document().project().region;
  ASSERT_LT(document().detail(), fine);
  window().runCommand("next_place");
  const Region found = document().project().region;
  EXPECT_EQ(found.level, coarse.level) << "as fine as before, not as fine as where it was set";
  EXPECT_EQ(found.side_mm, coarse.side_mm);
  EXPECT_NEAR(found.centreX(), there.centreX(), 1e-9);
  EXPECT_NEAR(found.centreY(), there.centreY(), 1e-9);
  const QString file = path("marked.json");
  writeProject(QFile::encodeName(file).toStdString(), document().stored());
  EXPECT_TRUE(readProject(QFile::encodeName(file).toStdString()).places.at(0).is_point);
}

TEST_F(WorkTest, AViewIsKeptWithItsLightAndReliefByTheMouse) {
  openRelief();
  window().runCommand("relief_slope");
  window().detailView().turnBy(20, 10);
  child<QSlider>("light_azimuth")->setValue(90);
  window().runCommand("stereo");
  child<QCheckBox>("places_with_view")->setChecked(true);
  QTest::mouseClick(child<QPushButton>("place_add"), Qt::LeftButton);
  ASSERT_EQ(places().places().size(), 1U);
  window().runCommand("relief_lit");
  window().detailView().straighten();
  child<QSlider>("light_azimuth")->setValue(300);
  window().runCommand("stereo");
  QTest::mouseClick(child<QPushButton>("place_go"), Qt::LeftButton);
  const SceneState& seen = window().detailView().sceneState();
  EXPECT_EQ(seen.look.kind, ReliefKind::slope);
  EXPECT_EQ(seen.camera.azimuth_deg, 20);
  EXPECT_EQ(seen.camera.elevation_deg, 10);
  EXPECT_EQ(seen.light.azimuth_deg, 90);
  EXPECT_EQ(seen.stereo.mode, StereoMode::anaglyph);
  QTest::mouseClick(child<QPushButton>("place_delete"), Qt::LeftButton);
  EXPECT_TRUE(places().places().empty());
  EXPECT_FALSE(child<QPushButton>("place_go")->isEnabled());
}

TEST_F(WorkTest, ColoursStereoLightPlacesAndMeasurementsAreStepsToo) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  const int steps = document().history().index();
  const SceneState& seen = window().detailView().sceneState();
  window().runCommand("relief_slope");
  window().runCommand("stereo");
  QTest::mouseClick(child<QPushButton>("place_add"), Qt::LeftButton);
  ASSERT_EQ(document().history().index(), steps + 3);
  EXPECT_EQ(document().history().undoText(), "Bookmarks");
  window().runCommand("undo");
  EXPECT_TRUE(places().places().empty());
  window().runCommand("undo");
  EXPECT_EQ(seen.stereo.mode, StereoMode::off);
  window().runCommand("undo");
  EXPECT_EQ(seen.look.kind, ReliefKind::lit);
  EXPECT_EQ(document().history().index(), steps);
  for (int i = 0; i < 3; ++i) window().runCommand("redo");
  EXPECT_EQ(seen.look.kind, ReliefKind::slope);
  EXPECT_NE(seen.stereo.mode, StereoMode::off);
  EXPECT_EQ(places().places().size(), 1U);
  EXPECT_EQ(document().history().index(), steps + 3) << "a step back is no new step";

  // A place that is gone to may bring its own look; each is one step, and regions stay right.
  document().region().move(0.1, 0);
  window().saveProject(path("steps.relievo.json"));
  const Region end = document().project().region;
  restart();
  window().open(path("steps.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(document().project().region, end);
  EXPECT_FALSE(window().hasUnsavedWork());
}

TEST_F(WorkTest, ANewPlaceIsSeenWhereverThePanelsStand) {
  openRelief();
  window().resize(900, 500);
  QApplication::processEvents();
  window().runCommand("name_place");
  QApplication::processEvents();
  auto* list = child<QListWidget>("places_list");
  ASSERT_NE(list, nullptr);
  EXPECT_FALSE(list->visibleRegion().isEmpty());
}

TEST_F(WorkTest, PlacesAndAHundredStepsComeBackWithTheProjectAndAreUndone) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  for (int i = 0; i < 99; ++i) document().region().move(i % 2 == 0 ? 0.1 : -0.1, 0);
  const Region end = document().project().region;
  ASSERT_EQ(document().history().index(), 100);
  window().runCommand("name_place");
  window().saveProject(path("p.relievo.json"));
  restart();
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(document().project().region, end);
  EXPECT_EQ(places().places().size(), 1U);
  ASSERT_EQ(document().history().index(), 101);
  document().history().undo();
  EXPECT_TRUE(places().places().empty());
  EXPECT_EQ(document().history().undoText(), "Move window");
  for (int i = 0; i < 99; ++i) document().history().undo();
  EXPECT_EQ(document().project().region.side_mm, 60);
  EXPECT_EQ(document().history().undoText(), "Choose window");
  document().history().undo();
  EXPECT_EQ(document().detail(), 1) << "as it was opened";
  document().history().redo();
  EXPECT_EQ(document().project().region.side_mm, 60);
}

TEST_F(WorkTest, MeasurementsPlacesLookAndTurnAreUndoneAfterTheProjectIsOpenedAgain) {
  openRelief();
  auto* measure = window().findChild<MeasurePanel*>();
  measure->setMeasurements({{"first", MeasureKind::depth, {{10, 10}, {100, 90}}, 0}});
  window().detailView().turnBy(20, 10);
  window().runCommand("relief_slope");
  document().region().setRect({40, 40, 60, 60});
  window().runCommand("name_place");
  measure->setMeasurements({{"first", MeasureKind::depth, {{10, 10}, {100, 90}}, 0},
                            {"second", MeasureKind::depth, {{50, 50}, {80, 80}}, 0}});
  window().runCommand("name_place");
  std::vector<Project> states{window().project()};
  const int steps = document().history().index();
  for (int i = 0; i < steps; ++i) {
    document().history().undo();
    states.push_back(window().project());
  }
  for (int i = 0; i < steps; ++i) document().history().redo();
  window().saveProject(path("p.relievo.json"));
  restart();
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  ASSERT_EQ(document().history().index(), steps);
  for (const Project& was : states) {
    const Project& now = document().project();
    EXPECT_EQ(now.places, was.places);
    EXPECT_EQ(now.measurements, was.measurements);
    EXPECT_EQ(now.look, was.look);
    EXPECT_EQ(now.region, was.region);
    EXPECT_EQ(now.azimuth_deg, was.azimuth_deg);
    EXPECT_EQ(now.elevation_deg, was.elevation_deg);
    EXPECT_EQ(now.history, was.history);
    document().history().undo();
  }
  EXPECT_TRUE(document().project().measurements.empty());
  for (int i = 0; i < steps; ++i) document().history().redo();
  EXPECT_EQ(document().project().places, states.front().places);
  EXPECT_EQ(document().project().measurements, states.front().measurements);
}

TEST_F(WorkTest, UnsavedWorkHasACopyThatGoesWithSavingAndWithTheEnd) {
  openRelief();
  EXPECT_EQ(copyCount(), 0);
  document().region().setRect({40, 40, 60, 60});
  ASSERT_TRUE(waitFor([&] { return copyCount() == 1; }));
  window().saveProject(path("p.relievo.json"));
  EXPECT_TRUE(waitFor([&] { return copyCount() == 0; }));
  document().region().whole();
  ASSERT_TRUE(waitFor([&] { return copyCount() == 1; }));
  restart();
  EXPECT_EQ(copyCount(), 0) << "an end is no crash";
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
}

TEST_F(WorkTest, AfterACrashTheStartOffersTheWorkAndRestoresIt) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  const Region region = document().project().region;
  window().findChild<MeasurePanel*>()->setMeasurements(
      {{"top", MeasureKind::depth, {{10, 10}, {100, 90}}, 0}});
  const Project work = window().project();
  leaveWork(work);
  restart();
  EXPECT_TRUE(window().message().contains("relief.ply")) << window().message().toStdString();
  EXPECT_FALSE(document().isOpen()) << "nothing happens unasked";
  ASSERT_NE(stripButton("Restore"), nullptr);
  QTest::mouseClick(stripButton("Restore"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(document().project().region, region);
  EXPECT_EQ(window().findChild<MeasurePanel*>()->measurements().size(), 1U);
  EXPECT_EQ(document().history().undoText(), "Measurements");
  document().history().undo();
  EXPECT_TRUE(window().findChild<MeasurePanel*>()->measurements().empty());
  EXPECT_EQ(document().history().undoText(), "Choose window");
  document().history().redo();
  EXPECT_FALSE(QFile::exists(copies() + "/autosave-dead01.json"));
  ASSERT_TRUE(waitFor([&] { return copyCount() == 1; })) << "it is still in no file of the user's";
}

TEST_F(WorkTest, TheTitleNamesTheProjectAndSaysWhetherItIsSaved) {
  openRelief();
  EXPECT_EQ(window().windowTitle().section(' ', 0, 0), "relief.ply[*]");
  EXPECT_FALSE(window().isWindowModified());
  window().findChild<MeasurePanel*>()->setMeasurements(
      {{"top", MeasureKind::depth, {{10, 10}, {100, 90}}, 0}});
  Q_EMIT window().findChild<MeasurePanel*>()->changed();
  EXPECT_TRUE(waitFor([this] { return window().isWindowModified(); }));
  window().saveProject(path("p.relievo.json"));
  EXPECT_EQ(window().windowTitle().section(' ', 0, 0), "p.relievo.json[*]");
  EXPECT_FALSE(window().isWindowModified());
}

TEST_F(WorkTest, AfterACrashTheWorkGoesOnInItsProject) {
  openRelief();
  window().saveProject(path("p.relievo.json"));
  window().findChild<MeasurePanel*>()->setMeasurements(
      {{"top", MeasureKind::depth, {{10, 10}, {100, 90}}, 0}});
  Q_EMIT window().findChild<MeasurePanel*>()->changed();
  ASSERT_TRUE(waitFor([this] { return copyCount() == 1; }));
  const Project copy =
      readProject((copies() + '/' + QDir(copies()).entryList({"*.json"}).value(0)).toStdString());
  leaveWork(copy);
  restart();
  EXPECT_TRUE(window().message().contains("p.relievo.json")) << window().message().toStdString();
  QTest::mouseClick(stripButton("Restore"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(window().windowTitle().section(' ', 0, 0), "p.relievo.json[*]");
  EXPECT_TRUE(window().isWindowModified()) << "the crash came before it was saved";
  ASSERT_TRUE(window().runCommand("save_project"));
  EXPECT_FALSE(window().isWindowModified());
  const Project saved = readProject(path("p.relievo.json").toStdString());
  EXPECT_EQ(saved.measurements.size(), 1U);
  EXPECT_TRUE(saved.saved_as.empty()) << "only of copies";
}

TEST_F(WorkTest, ADamagedProjectOffersAnotherFileAndWorkThatWasKept) {
  openRelief();
  const Project work = window().project();
  QFile bad(path("bad.relievo.json"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("{ \"relievo_project\": 2,");
  bad.close();
  window().open(path("bad.relievo.json"));
  EXPECT_TRUE(window().message().contains("is damaged")) << window().message().toStdString();
  ASSERT_NE(stripButton(QString::fromUtf8("Choose another\u2026")), nullptr);
  EXPECT_EQ(stripButton(QString::fromUtf8("Work that was kept\u2026")), nullptr) << "there is none";
  QTest::mouseClick(stripButton(QString::fromUtf8("Choose another\u2026")), Qt::LeftButton);
  auto* chooser = child<QFileDialog>("open_dialog");
  ASSERT_NE(chooser, nullptr);
  chooser->reject();
  leaveWork(work);
  window().open(path("bad.relievo.json"));
  auto* kept = stripButton(QString::fromUtf8("Work that was kept\u2026"));
  ASSERT_NE(kept, nullptr);
  QTest::mouseClick(kept, Qt::LeftButton);
  EXPECT_NE(stripButton("Restore"), nullptr) << window().message().toStdString();
}

TEST_F(WorkTest, WorkThatIsRefusedIsForgotten) {
  openRelief();
  leaveWork(window().project());
  restart();
  ASSERT_NE(stripButton("Discard"), nullptr);
  QTest::mouseClick(stripButton("Discard"), Qt::LeftButton);
  EXPECT_FALSE(QFile::exists(copies() + "/autosave-dead01.json"));
  EXPECT_TRUE(window().message().isEmpty());
  QFile bad(copies() + "/autosave-dead02.json");
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("{");
  bad.close();
  QFile lock(copies() + "/autosave-dead02.lock");
  ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
  restart();
  EXPECT_TRUE(window().message().isEmpty()) << "what the crash cut is not offered";
}

class UnsavedTest : public WorkTest {
 protected:
  QMessageBox* question() { return window().findChild<QMessageBox*>("unsaved_dialog"); }
  void answer(QMessageBox::StandardButton with) {
    ASSERT_NE(question(), nullptr);
    QTest::mouseClick(question()->button(with), Qt::LeftButton);
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  void nameOne() {
    window().runCommand("name_place");
    QTest::keyClick(list().findChild<QLineEdit*>(), Qt::Key_Escape);
  }
};

TEST_F(UnsavedTest, LookingAboutIsNotAskedAbout) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  window().runCommand("relief_slope");
  EXPECT_FALSE(window().hasUnsavedWork());
  EXPECT_TRUE(window().close());
  EXPECT_EQ(question(), nullptr);
}

TEST_F(UnsavedTest, ARecordingThatWasShownIsAFileAlreadyAndNotAskedAbout) {
  openRelief();
  window().controllers().replays.setReader([](const std::filesystem::path&, const Task&) {
    TouchRecording recording;
    TouchRow row;
    row.window_id = 1;
    recording.rows = {row, row};
    recording.rows.back().t_s = 1;
    recording.windows = {{1, {50, 50, 100, {1}}, 1, true}};
    return recording;
  });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  EXPECT_FALSE(window().hasUnsavedWork());
  EXPECT_TRUE(window().close());
  EXPECT_EQ(question(), nullptr);
}

TEST_F(UnsavedTest, ClosingAsksAndCancelKeepsTheWindow) {
  openRelief();
  nameOne();
  EXPECT_FALSE(window().close());
  ASSERT_NE(question(), nullptr);
  EXPECT_TRUE(question()->text().contains("relief.ply")) << question()->text().toStdString();
  QTest::keyClick(question(), Qt::Key_Escape);
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(question(), nullptr) << "Escape is Cancel";
  EXPECT_TRUE(window().isVisible());
  EXPECT_EQ(places().places().size(), 1U);
  EXPECT_FALSE(window().close());
  answer(QMessageBox::Discard);
  EXPECT_FALSE(window().isVisible());
}

TEST_F(UnsavedTest, SaveWritesTheProjectAndThenCloses) {
  openRelief();
  window().saveProject(path("p.relievo.json"));
  EXPECT_FALSE(window().hasUnsavedWork());
  nameOne();
  EXPECT_TRUE(window().hasUnsavedWork());
  EXPECT_FALSE(window().close());
  answer(QMessageBox::Save);
  EXPECT_FALSE(window().isVisible());
  EXPECT_EQ(readProject(path("p.relievo.json").toStdString()).places.size(), 1U);
}

TEST_F(UnsavedTest, SaveWithoutAProjectAsksWhereAndAnotherScanWaitsForIt) {
  openRelief();
  nameOne();
  const QString other = writeRelief("other.ply");
  window().open(other);
  EXPECT_FALSE(document().loader().busy()) << "nothing is opened before the answer";
  answer(QMessageBox::Save);
  auto* dialog = window().findChild<QFileDialog*>("project_dialog");
  ASSERT_NE(dialog, nullptr);
  Q_EMIT dialog->fileSelected(path("named.relievo.json"));
  EXPECT_TRUE(waitFor([&] { return document().file() == other && !document().loader().busy(); }));
  EXPECT_EQ(readProject(path("named.relievo.json").toStdString()).places.size(), 1U);
  EXPECT_TRUE(places().places().empty());
  EXPECT_FALSE(window().hasUnsavedWork());
}

TEST_F(UnsavedTest, SettingsOfAProjectChangedByHandAreWork) {
  openRelief();
  window().saveProject(path("p.relievo.json"));
  document().region().whole();
  EXPECT_FALSE(window().hasUnsavedWork());
  window().runCommand("relief_slope");
  EXPECT_TRUE(window().hasUnsavedWork());
  window().runCommand("relief_lit");
  EXPECT_FALSE(window().hasUnsavedWork()) << "it is as it is in the file again";
  window().runCommand("stereo");
  EXPECT_TRUE(window().hasUnsavedWork());
  window().runCommand("stereo");
  EXPECT_FALSE(window().hasUnsavedWork());
  document().choices().setView({"bottom", {}});
  ASSERT_TRUE(waitFor([&] { return document().surface()->view_name == "bottom"; }));
  EXPECT_TRUE(window().hasUnsavedWork());
}

TEST_F(UnsavedTest, MeasurementsAndCameraPathsAreWork) {
  openRelief();
  auto* measure = window().findChild<MeasurePanel*>();
  measure->setMeasurements({{"top", MeasureKind::depth, {{10, 10}, {100, 90}}, 0}});
  EXPECT_TRUE(window().hasUnsavedWork());
  measure->setMeasurements({});
  EXPECT_FALSE(window().hasUnsavedWork());
  window().runCommand("key_view");
  EXPECT_TRUE(window().hasUnsavedWork());
  EXPECT_FALSE(window().close());
  answer(QMessageBox::Cancel);
  EXPECT_TRUE(window().isVisible());
}

TEST_F(UnsavedTest, ASaveThatFailsClosesNothing) {
  openRelief();
  window().saveProject(path("p.relievo.json"));
  nameOne();
  QFile::remove(path("p.relievo.json"));
  QDir().mkpath(path("p.relievo.json"));  // A folder has its name now.
  EXPECT_FALSE(window().close());
  answer(QMessageBox::Save);
  EXPECT_TRUE(window().isVisible());
  EXPECT_FALSE(window().message().isEmpty()) << "and it is said";
  EXPECT_TRUE(window().hasUnsavedWork());
  EXPECT_EQ(places().places().size(), 1U);
}

TEST_F(WorkTest, AProjectOfACutScanComesBackWithWhatIsThere) {
  openRelief();
  window().runCommand("name_place");
  window().runCommand("relief_slope");
  window().saveProject(path("p.relievo.json"));
  restart();
  QFile scan(path("relief.ply"));
  ASSERT_TRUE(scan.resize(scan.size() / 2));
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(
      waitFor([&] { return !document().loader().busy() && !window().message().isEmpty(); }));
  auto* load = stripButton("Load what is there");
  ASSERT_NE(load, nullptr) << window().message().toStdString();
  QTest::mouseClick(load, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(places().places().size(), 1U);
  EXPECT_EQ(document().project().look.kind, ReliefKind::slope);
  EXPECT_TRUE(document().project().accept_incomplete);
  EXPECT_EQ(document().saved().projectFile(), path("p.relievo.json"));
}

TEST_F(WorkTest, APictureOfTheWindowBringsItsStateBack) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  window().runCommand("relief_openness");
  const Region region = document().project().region;
  for (const ImageSource source :
       {ImageSource::detail, ImageSource::reference, ImageSource::window}) {
    const QString file = path(QStringLiteral("shot%1.png").arg(static_cast<int>(source)));
    document().region().setRect({40, 40, 60, 60});
    window().runCommand("relief_openness");
    window().saveImage(source, {300, 200}, file);
    ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
    document().region().whole();
    window().runCommand("relief_lit");
    window().open(file);
    EXPECT_TRUE(waitFor([&] { return document().project().region == region; }));
    EXPECT_EQ(window().detailView().sceneState().look.kind, ReliefKind::openness);
  }
}

}  // namespace
}  // namespace relievo
