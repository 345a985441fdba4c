// SPDX-License-Identifier: BSD-3-Clause
// Videos and camera paths by the window's commands.
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/path_preview.h"
#include "ui/video/video_file.h"
#include "ui/video_control.h"

namespace relievo {
namespace {

/// A tenth of a second over the test relief.
TouchRecording shortTouch(double seconds) {
  TouchRecording recording;
  recording.name = "touch.csv";
  for (int i = 0; i <= 1000 * seconds; ++i) {
    TouchRow row;
    row.t_s = 0.001 * i;
    row.proxy = row.hip = {60 + 0.01 * i, 90, 15};
    row.window_id = 1;
    recording.rows.push_back(row);
  }
  recording.windows = {{1, {50, 50, 100, {1}}, 1, true}};
  return recording;
}

VideoRequest pictures() {
  VideoRequest request;
  request.profile = VideoProfile::images;
  return request;
}

class VideoWindowTest : public GuiTest {
 protected:
  void SetUp() override {
    qputenv("HOME", path("home").toLocal8Bit());
    QDir().mkpath(path("home"));
    openRelief();
  }
  VideoControl& video() { return window().videoControl(); }
  QString said() { return child<QLabel>("status_message")->text(); }
  QStringList videos() {
    return QDir(path("home/Videos/relievo")).entryList(QDir::Files | QDir::NoDotAndDotDot);
  }
};

TEST_F(VideoWindowTest, AVideoOfTheViewIsSavedWhileTheWindowGoesOn) {
  ASSERT_TRUE(haveFfmpeg());
  action("video_live")->setChecked(true);
  ASSERT_TRUE(video().live()) << window().message().toStdString();
  ASSERT_TRUE(waitFor([this] { return video().liveS() > 0.7; }));
  document().setRect({60, 50, 40, 40});
  action("video_live")->setChecked(false);
  ASSERT_TRUE(waitFor([this] { return !video().live(); }));
  ASSERT_EQ(videos().size(), 1) << window().message().toStdString();
  EXPECT_TRUE(said().contains("pictures dropped")) << said().toStdString();
  EXPECT_TRUE(videos().front().endsWith(".mp4"));
}

TEST_F(VideoWindowTest, AVideoThatIsStoppedAtOnceHasAPicture) {
  openRelief();
  action("video_live")->setChecked(true);
  ASSERT_TRUE(video().live()) << window().message().toStdString();
  action("video_live")->setChecked(false);
  ASSERT_TRUE(waitFor([this] { return !video().live(); }));
  EXPECT_EQ(window().message(), QString());
  EXPECT_TRUE(child<QLabel>("status_message")->text().startsWith("Video saved"))
      << child<QLabel>("status_message")->text().toStdString();
}

TEST_F(VideoWindowTest, WithoutFfmpegPicturesAreOffered) {
  const QByteArray before = qgetenv("PATH");
  qputenv("PATH", path("home").toLocal8Bit());
  action("video_live")->setChecked(true);
  qputenv("PATH", before);
  EXPECT_FALSE(action("video_live")->isChecked());
  EXPECT_FALSE(video().live());
  EXPECT_TRUE(window().message().contains("keep a folder of pictures"));
}

TEST_F(VideoWindowTest, AReplayBecomesAVideoInTheBackgroundAndEscapeEndsIt) {
  window().setRecordingReader([](const std::filesystem::path& file, const Task&) {
    return shortTouch(file.filename() == "long.csv" ? 20 : 0.1);
  });
  EXPECT_FALSE(action("video")->isEnabled()) << "of what?";
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().replayControl().showing(); }));
  EXPECT_TRUE(action("video")->isEnabled());
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  window().writeVideo(pictures(), path("frames"));
  EXPECT_TRUE(video().writing());
  EXPECT_FALSE(action("video")->isEnabled()) << "one at a time";
  ASSERT_TRUE(waitFor([this] { return !video().writing(); }));
  EXPECT_TRUE(said().contains("4 frames"))
      << said().toStdString() << window().message().toStdString();
  EXPECT_EQ(QDir(path("frames")).entryList({"*.png"}).size(), 4);

  window().replay(path("long.csv"));
  ASSERT_TRUE(waitFor([this] { return window().replayControl().player().durationS() > 1; }));
  QFile(path("long.csv")).open(QIODevice::WriteOnly);
  window().writeVideo(pictures(), path("long"));
  ASSERT_TRUE(waitFor([this] { return QFile::exists(path("long/frame_000001.png")); }));
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_FALSE(video().writing());
  EXPECT_TRUE(window().replayControl().showing()) << "Escape ended the work first";
  EXPECT_TRUE(waitFor([this] { return !QFile::exists(path("long")); })) << "nothing is left";
}

TEST_F(VideoWindowTest, AVideoCancelledInItsFirstMomentIsAnsweredAtOnceAndCanBeMadeAgain) {
  window().setRecordingReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(0.1); });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().replayControl().showing(); }));
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  for (int i = 0; i < 3; ++i) {
    window().writeVideo(pictures(), path("frames"));
    QTest::keyClick(&window().detailView(), Qt::Key_Escape);
    EXPECT_FALSE(video().writing());
    EXPECT_TRUE(action("video")->isEnabled());
    EXPECT_TRUE(said().contains("Cancelled")) << said().toStdString();
  }
  window().writeVideo(pictures(), path("frames"));
  ASSERT_TRUE(waitFor([this] { return !video().writing(); }));
  EXPECT_EQ(QDir(path("frames")).entryList({"*.png"}).size(), 4)
      << said().toStdString() << window().message().toStdString();
  // The end of the program comes in the middle of one.
  window().writeVideo(pictures(), path("left"));
  restart();
  EXPECT_FALSE(QFile::exists(path("left")));
}

TEST_F(VideoWindowTest, SizeAndRateAreChosenInTheDialog) {
  window().setRecordingReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(0.5); });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().replayControl().showing(); }));
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  window().runCommand("video");
  auto* dialog = child<QDialog>("video_options_dialog");
  ASSERT_NE(dialog, nullptr);
  auto* size = dialog->findChild<QComboBox*>("video_size");
  auto* profile = dialog->findChild<QComboBox*>("video_profile");
  EXPECT_EQ(size->itemText(2), QString::fromUtf8("3840 × 2160"));
  size->setCurrentIndex(size->count() - 1);  // As the detail view.
  const QSize chosen = size->currentData().toSize();
  EXPECT_LE(std::abs(chosen.width() - window().detailView().width()), 1);
  EXPECT_EQ(chosen.width() % 2, 0);
  profile->setCurrentIndex(profile->count() - 1);
  dialog->findChild<QDoubleSpinBox*>("video_fps")->setValue(8);
  QTest::mouseClick(dialog->findChild<QPushButton*>("video_next"), Qt::LeftButton);
  auto* file = child<QFileDialog>("video_dialog");
  ASSERT_NE(file, nullptr);
  Q_EMIT file->fileSelected(path("chosen"));
  ASSERT_TRUE(video().writing());
  ASSERT_TRUE(waitFor([this] { return !video().writing(); }));
  const QStringList frames = QDir(path("chosen")).entryList({"*.png"});
  EXPECT_EQ(frames.size(), 5) << "half a second, both ends, at 8 a second";
  EXPECT_EQ(QImage(path("chosen/" + frames.front())).size(), chosen);
}

TEST_F(VideoWindowTest, KeyViewsMakeAPathThatIsShownAndKept) {
  EXPECT_FALSE(action("path_play")->isEnabled());
  window().runCommand("key_view");
  document().setRect({60, 50, 40, 40});
  window().detailView().turnBy(0, 20);
  window().runCommand("key_view");
  EXPECT_TRUE(said().contains("Key view 2 at 3 s")) << said().toStdString();
  EXPECT_TRUE(action("video")->isEnabled());
  const Project project = window().project();
  ASSERT_EQ(project.paths.size(), 1U);
  ASSERT_EQ(project.paths[0].keys.size(), 2U);
  EXPECT_DOUBLE_EQ(project.paths[0].keys[1].view.elevation_deg, 20);
  EXPECT_EQ(projectFromJson(projectJson(project), "p").paths, project.paths);
  const Region before = document().state().region;
  window().runCommand("path_play");
  EXPECT_NEAR(document().state().region.side_mm, project.paths[0].keys[0].view.region.side_mm, 1);
  EXPECT_TRUE(waitFor([&] { return document().state().region.side_mm < 150; })) << "it moves";
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_EQ(document().state().region, before);
  window().runCommand("path_clear");
  EXPECT_FALSE(action("path_play")->isEnabled());
  EXPECT_TRUE(window().project().paths.empty());
}

}  // namespace
}  // namespace relievo
