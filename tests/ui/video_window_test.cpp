// SPDX-License-Identifier: BSD-3-Clause
// Videos and camera paths by the window's commands.
#include <algorithm>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>

#include "core/base/error.h"
#include "core/replay/sound_track.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/video_control.h"
#include "ui/dialogs/video_dialog.h"
#include "ui/video/video_file.h"
#include "ui/views/path_preview.h"

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

/// The stone itself is nearly grey.
int colouredPixels(const QImage& image) {
  int coloured = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      const auto [least, most] = std::minmax({c.red(), c.green(), c.blue()});
      if (most - least > 40) ++coloured;
    }
  }
  return coloured;
}

class VideoWindowTest : public GuiTest {
 protected:
  void SetUp() override {
    qputenv("HOME", path("home").toLocal8Bit());
    QDir().mkpath(path("home"));
    openRelief();
  }
  VideoControl& video() { return window().controllers().videos.control(); }
  /// Videos have even sides, whatever the view has.
  void makeViewOdd() {
    const DetailView& view = window().detailView();
    for (int i = 0; i < 8 && view.width() % 2 == 0; ++i) {
      window().resize(window().width() + 1, window().height());
      QApplication::processEvents();
    }
    ASSERT_EQ(view.width() % 2, 1);
  }
  QString said() { return child<QLabel>("status_message")->text(); }
  QStringList videos() {
    return QDir(path("home/Videos/relievo")).entryList(QDir::Files | QDir::NoDotAndDotDot);
  }
};

TEST_F(VideoWindowTest, AVideoOfTheViewIsSavedWhileTheWindowGoesOn) {
  ASSERT_TRUE(haveFfmpeg());
  makeViewOdd();
  action("video_live")->setChecked(true);
  ASSERT_TRUE(video().live()) << window().message().toStdString();
  ASSERT_TRUE(waitFor([this] { return video().liveS() > 0.7; }));
  document().region().setRect({60, 50, 40, 40});
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
  EXPECT_TRUE(child<QLabel>("status_message")->text().startsWith("Video saved: 0.1 s"))
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
  window().controllers().replays.setReader([](const std::filesystem::path& file, const Task&) {
    return shortTouch(file.filename() == "long.csv" ? 20 : 0.1);
  });
  EXPECT_FALSE(action("video")->isEnabled()) << "of what?";
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  EXPECT_TRUE(action("video")->isEnabled());
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  window().controllers().videos.write(pictures(), path("frames"));
  EXPECT_TRUE(video().writing());
  EXPECT_FALSE(action("video")->isEnabled()) << "one at a time";
  ASSERT_TRUE(waitFor([this] { return !video().writing(); }));
  EXPECT_TRUE(said().contains("4 frames"))
      << said().toStdString() << window().message().toStdString();
  EXPECT_EQ(QDir(path("frames")).entryList({"*.png"}).size(), 4);

  window().replay(path("long.csv"));
  ASSERT_TRUE(waitFor(
      [this] { return window().controllers().replays.control().player().durationS() > 1; }));
  QFile(path("long.csv")).open(QIODevice::WriteOnly);
  window().controllers().videos.write(pictures(), path("long"));
  ASSERT_TRUE(waitFor([this] { return QFile::exists(path("long/frame_000001.png")); }));
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_FALSE(video().writing());
  EXPECT_TRUE(window().controllers().replays.control().showing()) << "Escape ended the work first";
  EXPECT_TRUE(waitFor([this] { return !QFile::exists(path("long")); })) << "nothing is left";
}

TEST_F(VideoWindowTest, AVideoCancelledInItsFirstMomentIsAnsweredAtOnceAndCanBeMadeAgain) {
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(0.1); });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  for (int i = 0; i < 3; ++i) {
    window().controllers().videos.write(pictures(), path("frames"));
    QTest::keyClick(&window().detailView(), Qt::Key_Escape);
    EXPECT_FALSE(video().writing());
    EXPECT_TRUE(action("video")->isEnabled());
    EXPECT_TRUE(said().contains("Cancelled")) << said().toStdString();
  }
  window().controllers().videos.write(pictures(), path("frames"));
  ASSERT_TRUE(waitFor([this] { return !video().writing(); }));
  EXPECT_EQ(QDir(path("frames")).entryList({"*.png"}).size(), 4)
      << said().toStdString() << window().message().toStdString();
  // The end of the program comes in the middle of one.
  window().controllers().videos.write(pictures(), path("left"));
  restart();
  EXPECT_FALSE(QFile::exists(path("left")));
}

TEST_F(VideoWindowTest, AWindowThatIsClosedSavesItsVideoFirst) {
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(0.1); });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  window().controllers().videos.write(pictures(), path("frames"));
  window().close();
  EXPECT_TRUE(window().isVisible());
  EXPECT_TRUE(said().contains("closes when the video is saved")) << said().toStdString();
  ASSERT_TRUE(waitFor([this] { return !window().isVisible(); }));
  EXPECT_EQ(QDir(path("frames")).entryList({"*.png"}).size(), 4) << "all of it";
}

TEST_F(VideoWindowTest, EscapeStopsTheVideoThatAClosedWindowWaitsForAndTheWindowStays) {
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(20); });
  window().replay(path("long.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  QFile(path("long.csv")).open(QIODevice::WriteOnly);
  window().controllers().videos.write(pictures(), path("long"));
  window().close();
  ASSERT_TRUE(window().isVisible());
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_FALSE(video().writing());
  EXPECT_TRUE(waitFor([this] { return !QFile::exists(path("long")); })) << "nothing is left";
  EXPECT_TRUE(window().isVisible());
  window().close();
  EXPECT_FALSE(window().isVisible()) << "nothing is waited for any more";
}

TEST_F(VideoWindowTest, AVideoOfTheViewEndsWholeWhenTheWindowIsClosed) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  action("video_live")->trigger();
  ASSERT_TRUE(video().live());
  window().close();
  ASSERT_TRUE(waitFor([this] { return !window().isVisible(); }));
  ASSERT_EQ(videos().size(), 1);
  QFile file(path("home/Videos/relievo/" + videos().front()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("moov")) << "a video without it cannot be played";
}

TEST_F(VideoWindowTest, AnEndFromOutsideWaitsForNoVideoAndLeavesNoHalfOne) {
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(20); });
  window().replay(path("long.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  QFile(path("long.csv")).open(QIODevice::WriteOnly);
  window().runCommand("beacon");
  ASSERT_TRUE(window().hasUnsavedWork());
  window().controllers().videos.write(pictures(), path("long"));
  ASSERT_TRUE(waitFor([this] { return QFile::exists(path("long/frame_000001.png")); }));
  window().endAtOnce();
  EXPECT_FALSE(window().isVisible());
  restart();
  EXPECT_FALSE(QFile::exists(path("long")));
  EXPECT_TRUE(window().message().contains("was kept")) << window().message().toStdString();
}

TEST_F(VideoWindowTest, SizeAndRateAreChosenInTheDialog) {
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(0.5); });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  makeViewOdd();
  window().runCommand("relief_slope");
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
  ASSERT_EQ(frames.size(), 5) << "half a second, both ends, at 8 a second";
  const QImage frame(path("chosen/" + frames.front()));
  EXPECT_EQ(frame.size(), chosen);
  EXPECT_GT(colouredPixels(frame), chosen.width() * chosen.height() / 5) << "painted as the view";
}

TEST_F(VideoWindowTest, PartSpeedContentAndEyesAreChosenInTheDialog) {
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(2); });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  window().controllers().replays.control().player().setSpeed(0.25);
  window().runCommand("video");
  auto* dialog = static_cast<VideoDialog*>(child<QDialog>("video_options_dialog"));
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->request().speed, 0.25) << "the replay's";
  EXPECT_FALSE(dialog->request().from_s || dialog->request().to_s) << "the whole";
  EXPECT_TRUE(dialog->request().plots && dialog->request().overview);
  EXPECT_FALSE(dialog->request().path);
  const auto number = [&](const char* name) { return dialog->findChild<QDoubleSpinBox*>(name); };
  const auto box = [&](const char* name) { return dialog->findChild<QCheckBox*>(name); };
  number("video_speed")->setValue(0.5);
  number("video_from")->setValue(0.5);
  number("video_to")->setValue(0.25);
  EXPECT_EQ(number("video_to")->value(), 0.5) << "not before it begins";
  number("video_to")->setValue(1.5);
  box("video_plots")->click();
  box("video_overview")->click();
  EXPECT_TRUE(box("video_scale_bar")->isChecked());
  EXPECT_FALSE(box("video_along_path")->isEnabled()) << "there is no camera path";
  auto* stereo = dialog->findChild<QComboBox*>("video_stereo");
  auto* profile = dialog->findChild<QComboBox*>("video_profile");
  const auto take = [profile](VideoProfile one) {
    profile->setCurrentIndex(profile->findData(static_cast<int>(one)));
  };
  take(VideoProfile::talk);
  EXPECT_FALSE(stereo->isEnabled()) << "halved colours mix the eyes";
  take(VideoProfile::anaglyph);
  EXPECT_EQ(dialog->request().stereo, StereoPrint::grey);
  stereo->setCurrentIndex(3);
  number("video_eye_angle")->setValue(2.5);
  box("video_swap_eyes")->setChecked(true);
  const VideoRequest chosen = dialog->request();
  EXPECT_EQ(chosen.speed, 0.5);
  EXPECT_EQ(chosen.from_s, 0.5);
  EXPECT_EQ(chosen.to_s, 1.5);
  EXPECT_FALSE(chosen.plots || chosen.overview);
  EXPECT_EQ(chosen.stereo, StereoPrint::dubois);
  EXPECT_EQ(chosen.eye_angle_deg, 2.5);
  EXPECT_TRUE(chosen.swap_eyes);
  EXPECT_NO_THROW(check(chosen));
  take(VideoProfile::talk);
  EXPECT_EQ(dialog->request().stereo, StereoPrint::off);
  EXPECT_NO_THROW(check(dialog->request()));
  EXPECT_FALSE(dialog->bothEyes());
  EXPECT_FALSE(number("video_eye_angle")->isEnabled());
  box("video_both_eyes")->setChecked(true);
  EXPECT_TRUE(number("video_eye_angle")->isEnabled()) << "the eyes' files have one";
  // One second of recording at half speed, eight pictures a second.
  take(VideoProfile::images);
  dialog->findChild<QComboBox*>("video_size")->setCurrentIndex(0);
  number("video_fps")->setValue(8);
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  QTest::mouseClick(dialog->findChild<QPushButton*>("video_next"), Qt::LeftButton);
  Q_EMIT child<QFileDialog>("video_dialog")->fileSelected(path("part"));
  ASSERT_TRUE(waitFor([this] { return !video().writing(); }));
  for (const char* folder : {"part", "part.left", "part.right"}) {
    EXPECT_EQ(QDir(path(folder)).entryList({"*.png"}).size(), 17)
        << folder << said().toStdString() << window().message().toStdString();
  }
}

/// A click of sixteen samples.
SoundTrack shortSound() {
  SoundTrack track;
  track.frames = 16;
  track.render = [](const auto& take, const Task&) { take(std::string(64, 'x')); };
  return track;
}

TEST_F(VideoWindowTest, SoundIsTickedWhereItCanBeMadeAndGoesIntoTheVideo) {
  ASSERT_TRUE(haveFfmpeg());
  std::vector<VideoRequest> heard;
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(0.2); });
  const auto open_dialog = [this] {
    window().runCommand("video");
    auto* const dialog = static_cast<VideoDialog*>(child<QDialog>("video_options_dialog"));
    EXPECT_NE(dialog, nullptr);
    return dialog;
  };
  const auto close = [](VideoDialog* dialog) {
    dialog->reject();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  VideoDialog* dialog = open_dialog();
  EXPECT_FALSE(dialog->findChild<QCheckBox*>("video_sound")->isEnabled()) << "nothing makes it";
  EXPECT_FALSE(dialog->request().sound);
  close(dialog);
  window().controllers().videos.setSound([&](const TouchRecording&, const VideoRequest& request) {
    heard.push_back(request);
    return shortSound();
  });
  dialog = open_dialog();
  auto* sound = dialog->findChild<QCheckBox*>("video_sound");
  EXPECT_TRUE(sound->isEnabled());
  EXPECT_TRUE(dialog->request().sound) << "it is part of the recording";
  EXPECT_EQ(sound->accessibleName(), "Sound");
  auto* profile = dialog->findChild<QComboBox*>("video_profile");
  profile->setCurrentIndex(profile->findData(static_cast<int>(VideoProfile::images)));
  EXPECT_FALSE(sound->isEnabled()) << "a folder of pictures";
  EXPECT_FALSE(dialog->request().sound);
  profile->setCurrentIndex(profile->findData(static_cast<int>(VideoProfile::talk)));
  EXPECT_TRUE(dialog->request().sound);
  VideoRequest request = dialog->request();
  sound->click();
  VideoRequest silent = dialog->request();
  EXPECT_FALSE(silent.sound);
  close(dialog);

  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  const auto written = [&](VideoRequest one, const char* file) {
    one.width_px = one.height_px = 96;
    window().controllers().videos.write(one, path(file));
    EXPECT_TRUE(waitFor([this] { return !video().writing(); }));
    QFile state(path(QString::fromLatin1(file) + ".json"));
    EXPECT_TRUE(state.open(QIODevice::ReadOnly)) << window().message().toStdString();
    return state.readAll();
  };
  request.speed = 0.5;
  EXPECT_TRUE(written(request, "loud.mp4").contains(R"("sound":"aac")"));
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard.front().speed, 0.5);
  EXPECT_FALSE(written(silent, "silent.mp4").contains("sound"));
  EXPECT_EQ(heard.size(), 1U);
  EXPECT_EQ(window().message(), QString());
}

TEST_F(VideoWindowTest, AVideoWhoseRecordingCannotBeHeardIsSavedAndSaysWhy) {
  ASSERT_TRUE(haveFfmpeg());
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(0.2); });
  window().controllers().videos.setSound([](const TouchRecording&, const VideoRequest&) {
    throw FileError("It is old.");
    return SoundTrack();
  });
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  QFile(path("touch.csv")).open(QIODevice::WriteOnly);
  VideoRequest request;
  request.width_px = request.height_px = 96;
  window().controllers().videos.write(request, path("old.mp4"));
  ASSERT_TRUE(waitFor([this] { return !video().writing(); }));
  EXPECT_TRUE(QFile::exists(path("old.mp4")));
  EXPECT_TRUE(said().startsWith("Video saved")) << said().toStdString();
  EXPECT_TRUE(window().message().contains("The video has no sound. It is old."))
      << window().message().toStdString();
}

TEST_F(VideoWindowTest, AReplayIsFilmedAlongTheCameraPathIfThatIsChosen) {
  window().controllers().replays.setReader(
      [](const std::filesystem::path&, const Task&) { return shortTouch(2); });
  window().runCommand("key_view");
  document().region().setRect({60, 50, 40, 40});
  window().runCommand("key_view");
  const auto open_dialog = [this] {
    window().runCommand("video");
    return static_cast<VideoDialog*>(child<QDialog>("video_options_dialog"));
  };
  VideoDialog* dialog = open_dialog();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->request().path) << "there is nothing else";
  EXPECT_FALSE(dialog->findChild<QCheckBox*>("video_plots")->isEnabled());
  dialog->reject();
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  window().replay(path("touch.csv"));
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }));
  dialog = open_dialog();
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->request().path);
  dialog->findChild<QCheckBox*>("video_along_path")->click();
  ASSERT_TRUE(dialog->request().path);
  EXPECT_EQ(dialog->request().path->keys.size(), 2U);
  EXPECT_TRUE(dialog->request().plots);
}

TEST_F(VideoWindowTest, KeyViewsMakeAPathThatIsShownAndKept) {
  EXPECT_FALSE(action("path_play")->isEnabled());
  window().runCommand("key_view");
  document().region().setRect({60, 50, 40, 40});
  window().detailView().turnBy(0, 20);
  window().runCommand("key_view");
  EXPECT_TRUE(said().contains("Key view 2 at 3 s")) << said().toStdString();
  EXPECT_TRUE(action("video")->isEnabled());
  const Project project = window().project();
  ASSERT_EQ(project.paths.size(), 1U);
  ASSERT_EQ(project.paths[0].keys.size(), 2U);
  EXPECT_DOUBLE_EQ(project.paths[0].keys[1].view.elevation_deg, 20);
  EXPECT_EQ(projectFromJson(projectJson(project), "p").paths, project.paths);
  const Region before = document().project().region;
  window().runCommand("path_play");
  EXPECT_NEAR(document().project().region.side_mm, project.paths[0].keys[0].view.region.side_mm, 1);
  EXPECT_TRUE(waitFor([&] { return document().project().region.side_mm < 150; })) << "it moves";
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_EQ(document().project().region, before);
  window().runCommand("path_clear");
  EXPECT_FALSE(action("path_play")->isEnabled());
  EXPECT_TRUE(window().project().paths.empty());
}

}  // namespace
}  // namespace relievo
