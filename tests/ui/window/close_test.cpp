// SPDX-License-Identifier: BSD-3-Clause
// File > Close: back to the start page, and on from there.
#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/video_control.h"
#include "ui/frame/start_page.h"

namespace relievo {
namespace {

using CloseTest = GuiTest;

TEST_F(CloseTest, GoesBackToTheStartPageAndAnotherFileOpensAsTheFirst) {
  EXPECT_FALSE(action("close")->isEnabled()) << "nothing is open";
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  window().detailView().turnBy(20, 10);
  action("light_rake_left")->trigger();
  QTest::keyClick(&window(), Qt::Key_W, Qt::ControlModifier);
  EXPECT_FALSE(document().isOpen());
  EXPECT_TRUE(window().findChild<StartPage*>()->isVisible());
  EXPECT_EQ(window().windowTitle(), "relievo");
  EXPECT_EQ(document().history().count(), 0);
  EXPECT_FALSE(action("close")->isEnabled());
  EXPECT_FALSE(action("finer")->isEnabled());
  EXPECT_TRUE(child<QLabel>("status_message")->text().contains("is closed"));
  for (const char* field : {"status_position", "status_detail", "status_mouse"}) {
    EXPECT_TRUE(child<QLabel>(field)->text().isEmpty()) << field;
  }
  openRelief();
  EXPECT_TRUE(action("close")->isEnabled());
  EXPECT_FALSE(window().detailView().isTurned());
  EXPECT_EQ(document().project().look.light, (LightOptions{270, 10}))
      << "how things are looked at goes on";
  EXPECT_TRUE(document().region().setRect({40, 40, 60, 60}));
  EXPECT_EQ(document().history().count(), 1);
}

TEST_F(CloseTest, AsksForWorkThatIsInNoFile) {
  openRelief();
  document().edit({}, [](Project& p) {
    p.places = {{"rim", {.x_mm = 0, .y_mm = 0, .side_mm = 50, .level = Level{0}}}};
  });
  action("close")->trigger();
  auto* question = child<QMessageBox>("unsaved_dialog");
  ASSERT_NE(question, nullptr);
  EXPECT_TRUE(document().isOpen());
  QTest::mouseClick(question->button(QMessageBox::Discard), Qt::LeftButton);
  EXPECT_FALSE(document().isOpen());
  EXPECT_TRUE(document().project().places.empty());
}

TEST_F(CloseTest, StopsTheForcesAndLetsNoneComeOnBehindTheStartPage) {
  auto* forces = new QAction("Forces");
  forces->setObjectName("forces");
  forces->setCheckable(true);
  auto* off = new QAction("Off");
  off->setObjectName("forcesOff");
  bool stopped = false;
  QObject::connect(off, &QAction::triggered, [&stopped] { stopped = true; });
  window().addToMenu("Touch", forces);
  window().addToMenu("Touch", off);
  openRelief();
  TouchReadout readout;
  readout.forces_on = true;
  window().controllers().touch.show(readout);
  action("close")->trigger();
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(window().runCommand("forces"));
}

/// As the haptics plugin adds it.
QAction* recordIn(MainWindow& window) {
  auto* record = new QAction("Record");
  record->setObjectName("record");
  record->setCheckable(true);
  window.addToMenu("Record", record);
  return record;
}

TEST_F(CloseTest, ARecordingEndsAndIsSavedBeforeItsScanGoes) {
  QAction* record = recordIn(window());
  openRelief();
  record->setChecked(true);
  action("close")->trigger();
  EXPECT_FALSE(record->isChecked()) << "it is asked to end";
  EXPECT_TRUE(document().isOpen()) << "until it is on the disk";
  action("close")->trigger();
  EXPECT_TRUE(document().isOpen());
  QFile file(path("touch.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.close();
  window().controllers().replays.noteRecording(file.fileName());
  ASSERT_TRUE(waitFor([this] { return !document().isOpen(); }));
  const QString said = child<QLabel>("status_message")->text();
  EXPECT_TRUE(said.contains("relief.ply is closed")) << said.toStdString();
  EXPECT_TRUE(said.contains("touch.csv")) << said.toStdString();
  // The next one is closed as ever.
  openRelief();
  action("close")->trigger();
  EXPECT_FALSE(document().isOpen());
}

TEST_F(CloseTest, TheWorkKnowsOfARecordingBeforeItGoes) {
  QAction* record = recordIn(window());
  openRelief();
  std::size_t known = 0;
  QObject::connect(&document(), &Document::amended, [&] {
    if (document().isOpen()) known = document().project().recordings.size();
  });
  record->setChecked(true);
  action("close")->trigger();
  QFile file(path("touch.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.close();
  window().controllers().replays.noteRecording(file.fileName());
  ASSERT_TRUE(waitFor([this] { return !document().isOpen(); }));
  EXPECT_EQ(known, 1U);
}

TEST_F(CloseTest, ARecordingThatHadEndedAlreadyHoldsNothingUp) {
  recordIn(window());
  openRelief();
  TouchReadout readout;
  readout.recording = true;  // Half a second old.
  window().controllers().touch.show(readout);
  action("close")->trigger();
  EXPECT_TRUE(document().isOpen());
  readout.recording = false;
  window().controllers().touch.show(readout);
  ASSERT_TRUE(waitFor([this] { return !document().isOpen(); }));
}

TEST_F(CloseTest, WhatIsSaidOfARecordingThatCouldNotBeWrittenIsReadBeforeTheScanGoes) {
  QAction* record = recordIn(window());
  openRelief();
  record->setChecked(true);
  action("close")->trigger();
  window().messages().showError("The disk is full. The recording ends early.", "E401");
  QFile file(path("touch.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.close();
  std::size_t known = 0;
  QObject::connect(&document(), &Document::amended,
                   [&] { known = document().project().recordings.size(); });
  window().controllers().replays.noteRecording(file.fileName());
  ASSERT_TRUE(waitFor([&] { return known == 1; }));
  QApplication::processEvents();
  EXPECT_TRUE(document().isOpen());
  EXPECT_TRUE(window().message().contains("The disk is full")) << window().message().toStdString();
}

TEST_F(CloseTest, EscapeOrAnotherScanTakesACloseBackThatWaits) {
  QAction* record = recordIn(window());
  openRelief();
  record->setChecked(true);
  action("close")->trigger();
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_TRUE(child<QLabel>("status_message")->text().contains("relief.ply stays open"));
  record->setChecked(true);
  action("close")->trigger();
  const QString other = writeRelief("other.ply");
  window().open(other);
  QFile file(path("touch.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.close();
  window().controllers().replays.noteRecording(file.fileName());
  ASSERT_TRUE(waitFor(
      [this] { return document().file().endsWith("other.ply") && !document().loader().busy(); }));
  QApplication::processEvents();
  EXPECT_TRUE(document().isOpen());
}

TEST_F(CloseTest, AVideoOfTheViewEndsWholeBeforeItsScanGoes) {
  qputenv("HOME", path("home").toLocal8Bit());
  QDir().mkpath(path("home"));
  openRelief();
  action("video_live")->setChecked(true);
  ASSERT_TRUE(window().controllers().videos.control().live()) << window().message().toStdString();
  action("close")->trigger();
  EXPECT_TRUE(document().isOpen()) << "its last picture is being written";
  ASSERT_TRUE(waitFor([this] { return !document().isOpen(); }));
  EXPECT_FALSE(window().controllers().videos.control().live());
  EXPECT_FALSE(action("video_live")->isChecked());
  const QString said = child<QLabel>("status_message")->text();
  EXPECT_TRUE(said.contains("Video saved")) << said.toStdString();
  EXPECT_TRUE(said.contains("relief.ply is closed")) << said.toStdString();
  EXPECT_EQ(QDir(path("home/Videos/relievo")).entryList(QDir::Files).size(), 1);
}

}  // namespace
}  // namespace relievo
