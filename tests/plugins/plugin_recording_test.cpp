// SPDX-License-Identifier: BSD-3-Clause
// Recordings that the plugin makes: their names and kinds, notes in them, and how they end.
#include <gtest/gtest.h>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDate>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QTest>

#include "haptics/record/replay.h"
#include "tests/haptics/record/size_limit.h"
#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using test::eventually;

std::shared_ptr<const RegionWindow> flatWindow(double height, std::uint64_t id) {
  return std::make_shared<RegionWindow>(test::windowOf(
      80, [height](double, double) { return height; }, id));
}

using PluginRecordingTest = test::PluginTest;

TEST_F(PluginRecordingTest, RecordsEverySampleToTheDocumentsFolder) {
  host_.window = flatWindow(5, 41);
  attach();
  QAction* record = host_.actions.at("record");
  record->trigger();
  ASSERT_TRUE(eventually([this] { return host_.status.recorded_samples > 100; }));
  EXPECT_TRUE(host_.status.recording);
  record->trigger();
  ASSERT_TRUE(
      eventually([this] { return host_.announcements.last().startsWith("Recording saved"); }));
  const QDir folder(home_.file("Documents/relievo"));
  const QStringList files = folder.entryList({"relief_*.csv"});
  ASSERT_EQ(files.size(), 1);
  QFile file(folder.filePath(files[0]));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(file.readAll());
  EXPECT_TRUE(text.startsWith("# relievo recording, schema 1\n"));
  EXPECT_TRUE(text.contains("# input relief.ply\n"));
  EXPECT_TRUE(text.contains("# surface gated, friction 0 at rest"));
  EXPECT_TRUE(text.contains("\nt_s,tick,hip_x_mm"));
  EXPECT_TRUE(text.endsWith('\n'));
  EXPECT_TRUE(text.contains("\n# loop ticks ")) << "how the loop ran";
  EXPECT_TRUE(text.contains("\n# wake-up us "));
  EXPECT_TRUE(text.contains("of detail"));
}

TEST_F(PluginRecordingTest, RecordsToTheFolderThatWasChosenAndSaysIfItCannotBe) {
  host_.window = flatWindow(5, 43);
  host_.folder = home_.file("survey/day 1");
  attach();
  QAction* record = host_.actions.at("record");
  record->trigger();
  ASSERT_TRUE(eventually([this] { return host_.status.recorded_samples > 10; }));
  host_.folder = home_.file("elsewhere");  // For the next one.
  record->trigger();
  ASSERT_TRUE(
      eventually([this] { return host_.announcements.last().startsWith("Recording saved"); }));
  EXPECT_EQ(QDir(home_.file("survey/day 1")).entryList({"relief_*.csv"}).size(), 1);
  EXPECT_FALSE(QDir(home_.file("Documents/relievo")).exists());
  EXPECT_FALSE(QDir(home_.file("elsewhere")).exists());
  QFile(home_.file("a file")).open(QIODevice::WriteOnly);
  host_.folder = home_.file("a file");
  record->trigger();
  EXPECT_FALSE(record->isChecked());
  ASSERT_EQ(host_.errors.size(), 1) << "above the views, where it stays";
  EXPECT_TRUE(host_.errors[0].contains("a file\" for recordings cannot be made"))
      << host_.errors[0].toStdString();
  EXPECT_TRUE(host_.errors[0].endsWith(" E401"));
}

TEST_F(PluginRecordingTest, ARecordingThatCannotGoOnIsSaidAboveTheViewsAndKept) {
  host_.window = flatWindow(5, 44);
  attach();
  QAction* record = host_.actions.at("record");
  {
    const test::SizeLimit full_disk(100'000);
    record->trigger();
    EXPECT_TRUE(eventually([this] { return !host_.errors.isEmpty(); }));
  }
  ASSERT_EQ(host_.errors.size(), 1);
  EXPECT_TRUE(host_.errors[0].startsWith("Recording stopped")) << host_.errors[0].toStdString();
  EXPECT_TRUE(host_.errors[0].endsWith(" E401"));
  EXPECT_FALSE(record->isChecked());
  ASSERT_EQ(host_.recordings.size(), 1);
  EXPECT_GT(readLog(host_.recordings[0].toStdString()).rows.size(), 50U) << "what is whole is kept";
}

TEST_F(PluginRecordingTest, AnHdf5RecordingThatCannotGoOnIsCompleteToo) {
  host_.window = flatWindow(5, 44);
  host_.ending = "h5";
  attach();
  {
    const test::SizeLimit full_disk(420'000);  // 200'000 are the surface.
    host_.actions.at("record")->trigger();
    EXPECT_TRUE(eventually([this] { return !host_.errors.isEmpty(); }));
  }
  EXPECT_TRUE(host_.errors.value(0).startsWith("Recording stopped: disk full"))
      << host_.errors.value(0).toStdString();
  ASSERT_EQ(host_.recordings.size(), 1);
  EXPECT_GE(readLog(host_.recordings[0].toStdString()).rows.size(), 4096U);
}

TEST_F(PluginRecordingTest, AnHdf5RecordingWithoutRoomIsNotBegunAndSaysSo) {
  host_.window = flatWindow(5, 44);
  host_.ending = "h5";
  attach();
  QAction* record = host_.actions.at("record");
  {
    const test::SizeLimit full_disk(160'000);
    record->trigger();
  }
  EXPECT_FALSE(record->isChecked());
  ASSERT_EQ(host_.errors.size(), 1);
  const QDir folder(home_.file("Documents/relievo"));
  EXPECT_TRUE(host_.errors[0].contains(folder.path())) << host_.errors[0].toStdString();
  EXPECT_TRUE(host_.errors[0].contains("disk full")) << host_.errors[0].toStdString();
  EXPECT_TRUE(host_.errors[0].endsWith(" E401"));
  EXPECT_TRUE(folder.entryList({"*.h5"}).isEmpty());
  record->trigger();  // As soon as there is room.
  EXPECT_TRUE(eventually([this] { return host_.status.recorded_samples > 20; }));
  record->trigger();
  EXPECT_TRUE(eventually([this] { return host_.recordings.size() == 1; }));
}

TEST_F(PluginRecordingTest, ARecordingIsNamedAfterItsScanItsDayAndANumber) {
  host_.window = flatWindow(5, 41);
  attach();
  QAction* record = host_.actions.at("record");
  const auto recorded = [&](int count) {
    record->trigger();
    EXPECT_TRUE(eventually([this] { return host_.status.recorded_samples > 20; }));
    record->trigger();
    EXPECT_TRUE(eventually([&] { return host_.recordings.size() == count; }));
    return QFileInfo(host_.recordings.value(count - 1)).fileName();
  };
  const QString day = QDate::currentDate().toString(Qt::ISODate);
  EXPECT_EQ(recorded(1), "relief_" + day + "_001.csv");
  host_.ending = "h5";
  EXPECT_EQ(recorded(2), "relief_" + day + "_002.h5") << "a number of its own";
  host_.scan = QString(300, QChar(0xe4));
  EXPECT_TRUE(recorded(3).startsWith(QString(90, QChar(0xe4)))) << "no longer than a name may be";
  host_.scan.clear();
  EXPECT_EQ(recorded(4), "touch_" + day + "_001.h5");
}

TEST_F(PluginRecordingTest, ARecordingEndsWholeWhenItsDeviceIsChanged) {
  host_.window = flatWindow(5, 41);
  attach();
  host_.actions.at("record")->trigger();
  ASSERT_TRUE(eventually([this] { return host_.status.recorded_samples > 100; }));
  auto* device = inPanel<QComboBox>("deviceList");
  device->setCurrentIndex(device->findData("virtual:relaxed"));
  EXPECT_FALSE(host_.actions.at("record")->isChecked());
  ASSERT_EQ(host_.recordings.size(), 1);
  EXPECT_NE(readLog(host_.recordings[0].toStdString()).footer.find("replay core "),
            std::string::npos)
      << "it can be replayed";
}

/// What the note at the beginning of an event says; empty: there is none.
std::string noteOf(const LogTable& log) {
  for (const LogEvent& event : log.events) {
    if (event.text.starts_with("note at tick ")) return event.text;
  }
  return {};
}

TEST_F(PluginRecordingTest, ANoteIsWrittenWhileTheRecordingGoesOn) {
  host_.window = flatWindow(5, 41);
  attach();
  QAction* note = host_.actions.at("addNote");
  EXPECT_EQ(host_.menus["addNote"], "Record");
  EXPECT_FALSE(note->isEnabled()) << "into which recording?";
  host_.actions.at("record")->trigger();
  EXPECT_TRUE(note->isEnabled());
  ASSERT_TRUE(eventually([this] { return host_.status.recorded_samples > 100; }));
  note->trigger();
  const auto dialog = [] {
    for (QWidget* one : QApplication::topLevelWidgets()) {
      if (one->objectName() == "note_dialog" && one->isVisible()) return one;
    }
    return static_cast<QWidget*>(nullptr);
  };
  ASSERT_NE(dialog(), nullptr);
  EXPECT_FALSE(dialog()->isModal()) << "the hand goes on";
  const quint64 begun = host_.status.recorded_samples;
  ASSERT_TRUE(eventually([&] { return host_.status.recorded_samples > begun + 300; }));
  auto* text = dialog()->findChild<QLineEdit*>("note_text");
  EXPECT_FALSE(text->accessibleName().isEmpty());
  QTest::keyClicks(text, "a \"crack\", here");
  QTest::keyClick(text, Qt::Key_Return);
  EXPECT_EQ(dialog(), nullptr);
  ASSERT_TRUE(host_.announcements.last().startsWith("Note at "));
  EXPECT_TRUE(host_.announcements.last().endsWith(": a \"crack\", here"));
  const quint64 added = host_.status.recorded_samples;
  ASSERT_TRUE(eventually([&] { return host_.status.recorded_samples > added + 100; }));
  // One that is begun as the recording ends is not lost either.
  note->trigger();
  dialog()->findChild<QLineEdit*>("note_text")->setText(QString(300, QChar(0xe4)));
  host_.actions.at("record")->trigger();
  EXPECT_EQ(dialog(), nullptr);
  EXPECT_FALSE(note->isEnabled());
  ASSERT_TRUE(eventually([this] { return host_.recordings.size() == 1; }));
  const LogTable log = readLog(host_.recordings[0].toStdString());
  const std::string written = noteOf(log);
  EXPECT_TRUE(written.ends_with(": a \"crack\", here")) << written;
  const auto tick = std::stoull(written.substr(13));
  EXPECT_GE(tick, log.rows.front().tick);
  EXPECT_LE(tick + 300, log.rows.back().tick) << "of when it was begun";
  std::string all = log.header + log.footer;
  for (const LogEvent& event : log.events) all += event.text;
  EXPECT_NE(all.find("\u00e4\u00e4"), std::string::npos);
}

}  // namespace
}  // namespace relievo
