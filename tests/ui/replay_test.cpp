// SPDX-License-Identifier: BSD-3-Clause
// A recording replayed in the window: picture, plots, keys, and the map it needs.
#include <cmath>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QtTest/QTest>

#include "core/base/error.h"
#include "core/project/project.h"
#include "tests/ui/gui_fixture.h"
#include "ui/panels/replay_panel.h"
#include "ui/plots/strip_plot.h"

namespace relievo {
namespace {

/// Ten seconds on the test relief: along x at y = 90; the window changes after five.
TouchRecording tenSeconds() {
  TouchRecording recording;
  recording.name = "touch.csv";
  for (int i = 0; i <= 10'000; ++i) {
    TouchRow row;
    row.t_s = 2 + 0.001 * i;  // A log need not begin at 0.
    row.proxy = {60 + 0.008 * i, 90, 15};
    row.hip = row.proxy + ViewMm{0, 0, i < 5000 ? 1.0 : -0.8};
    row.contact = i >= 5000;
    row.force = {0, 0, i < 5000 ? 0 : 0.4};
    row.origin = CellStatus::measured;
    row.window_id = i < 5000 ? 11 : 12;
    recording.rows.push_back(row);
  }
  recording.windows = {{11, {50, 50, 100, {1}}, 1, true}, {12, {80, 70, 40, {0}}, 1, true}};
  return recording;
}

class ReplayTest : public GuiTest {
 protected:
  void SetUp() override {
    openRelief();
    recording_ = std::make_shared<TouchRecording>(tenSeconds());
    recording_->input_sha256 = document().fileSha256().toStdString();
    recording_->input = "relief.ply";
    window().controllers().replays.setReader(
        [this](const std::filesystem::path& file, const Task&) {
          if (file.filename() != "touch.csv") throw FileError("This is no recording.");
          return *recording_;
        });
  }
  ReplayControl& control() { return window().controllers().replays.control(); }
  ReplayPlayer& player() { return control().player(); }
  void replay() {
    window().replay(path("touch.csv"));
    ASSERT_TRUE(waitFor([this] { return control().showing() || !window().message().isEmpty(); }));
  }
  const Probe& drawn() { return *window().detailView().sceneState().probe; }
  QString status(const char* field) { return child<QLabel>(field)->text(); }
  QString said() { return status("status_message"); }
  QSlider& slider() { return *child<QSlider>("replay_slider"); }

  std::shared_ptr<TouchRecording> recording_;
};

TEST_F(ReplayTest, ShowsHandProxyAndWindowOfTheRecordingAtEachTime) {
  replay();
  ASSERT_TRUE(control().showing()) << window().message().toStdString();
  EXPECT_FALSE(player().playing()) << "it waits for its user";
  EXPECT_DOUBLE_EQ(drawn().proxy.x, 60);
  EXPECT_FALSE(drawn().touching);
  EXPECT_DOUBLE_EQ(document().project().region.side_mm, 100);
  player().setTime(7.5);
  EXPECT_DOUBLE_EQ(drawn().proxy.x, 120);
  EXPECT_LT(drawn().hip.z, drawn().proxy.z);
  EXPECT_TRUE(drawn().touching);
  EXPECT_EQ(document().project().region, (Region{80, 70, 40, {0}}));
  EXPECT_EQ(drawn().window_id, document().window()->id) << "drawn in the window that is shown";
  EXPECT_EQ(status("status_force"), "0.40 N");
  EXPECT_EQ(status("status_recording"), "replay 7.50 of 10.00 s");
  player().setTime(1);
  EXPECT_DOUBLE_EQ(document().project().region.side_mm, 100) << "and back";
}

TEST_F(ReplayTest, AViewThatIsTurnedMeanwhileLeavesItsReliefAlone) {
  action("turn_relief")->setChecked(true);
  replay();
  ASSERT_TRUE(control().showing()) << window().message().toStdString();
  const auto replayed = document().surface();
  window().detailView().turnBy(10, 5);
  EXPECT_TRUE(window().detailView().isTurned());
  EXPECT_FALSE(document().loader().busy()) << "another relief would close the replay";
  ASSERT_TRUE(window().runCommand("replay_close"));
  EXPECT_EQ(document().surface(), replayed) << "nor is it made up for afterwards";
  window().detailView().turnBy(5, 0);
  EXPECT_TRUE(document().loader().busy()) << "as before the replay";
  ASSERT_TRUE(waitFor([this] { return !document().loader().busy(); }));
}

TEST_F(ReplayTest, KeysAndSliderGoThroughTheRecordingAndPlotsKeepStep) {
  replay();
  auto& panel = *control().panel();
  QApplication::processEvents();
  EXPECT_TRUE(panel.isVisible());
  EXPECT_FALSE(child<QWidget>("time_plot")->isVisible());
  slider().setFocus();
  QTest::keyClick(&slider(), Qt::Key_PageDown);
  EXPECT_NEAR(player().timeS(), 1, 1e-9);
  QTest::keyClick(&slider(), Qt::Key_Right);
  EXPECT_NEAR(player().timeS(), 1.1, 1e-9);
  QTest::keyClick(&panel, Qt::Key_Left);
  EXPECT_NEAR(player().timeS(), 1, 1e-9);
  QTest::keyClick(&slider(), Qt::Key_End);
  EXPECT_DOUBLE_EQ(player().timeS(), 10);
  EXPECT_DOUBLE_EQ(drawn().proxy.x, 140);
  slider().setValue(2500);
  EXPECT_NEAR(player().timeS(), 2.5, 1e-9);
  EXPECT_NEAR(panel.cursorS(), 2.5, 1e-9);
  EXPECT_EQ(panel.shownS(), (std::pair{0.0, 10.0}));
  EXPECT_EQ(status("replay_time"), "2.50 of 10.00 s");
  EXPECT_FALSE(slider().accessibleName().isEmpty());
  EXPECT_EQ(slider().accessibleDescription(), "2.50 of 10.00 s");
}

TEST_F(ReplayTest, EventsAndSamplesAreReachedByKeysButtonsAndCommands) {
  recording_->events = {{2, "window 11 of detail 1; stiffness 500 N/m; forces off", false},
                        {5.25, "a crack", true},
                        {7, "new window: window 12 of detail 2", false}};
  replay();
  auto& panel = *control().panel();
  QApplication::processEvents();
  const auto readout = [this] { return child<QLabel>("replay_readout")->text(); };
  EXPECT_TRUE(readout().contains("force 0.00 N")) << readout().toStdString();
  EXPECT_TRUE(
      readout().endsWith("since 0.00 s: window at resolution 1; stiffness 500 N/m; forces off"))
      << readout().toStdString();
  QTest::keyClick(&panel, Qt::Key_Down);
  EXPECT_DOUBLE_EQ(player().timeS(), 3.25);
  EXPECT_EQ(said(), "3.25 s: note: a crack");
  EXPECT_TRUE(readout().endsWith("since 3.25 s: note: a crack")) << readout().toStdString();
  EXPECT_EQ(child<QLabel>("replay_readout")->accessibleDescription(), readout());
  QTest::mouseClick(child<QToolButton>("replay_event_next"), Qt::LeftButton);
  EXPECT_DOUBLE_EQ(player().timeS(), 5);
  EXPECT_TRUE(readout().contains("HIP z 14.20 mm")) << readout().toStdString();
  EXPECT_TRUE(readout().contains("force 0.40 N"));
  QTest::keyClick(&slider(), Qt::Key_Down);
  EXPECT_DOUBLE_EQ(player().timeS(), 5) << "there is none";
  EXPECT_EQ(said(), "No event after this place");
  ASSERT_TRUE(window().runCommand("replay_previous_event"));
  EXPECT_DOUBLE_EQ(player().timeS(), 3.25);
  QTest::keyClick(&slider(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(player().timeS(), 3.249, 1e-9) << "one sample";
  EXPECT_TRUE(readout().contains("since 0.00 s"));
  player().play();
  QTest::mouseClick(child<QToolButton>("replay_sample_next"), Qt::LeftButton);
  EXPECT_FALSE(player().playing()) << "step by step";
  for (const char* name :
       {"replay_event_before", "replay_event_next", "replay_sample_before", "replay_sample_next"}) {
    EXPECT_FALSE(child<QToolButton>(name)->accessibleName().isEmpty()) << name;
    EXPECT_EQ(child<QToolButton>(name)->focusPolicy(), Qt::StrongFocus) << name;
  }
  control().close();
  EXPECT_FALSE(action("replay_next_event")->isEnabled());
}

TEST_F(ReplayTest, ALongNoteDoesNotWidenTheWindow) {
  replay();
  const int width = control().panel()->minimumSizeHint().width();
  recording_->events = {{2, std::string(2000, 'x'), true}};
  control().close();
  replay();
  QApplication::processEvents();
  EXPECT_EQ(control().panel()->minimumSizeHint().width(), width);
}

TEST_F(ReplayTest, PlaysAtFullAndAtQuarterSpeedAndHaltsAtTheEnd) {
  replay();
  QTest::keyClick(control().panel(), Qt::Key_Space);
  EXPECT_TRUE(player().playing());
  EXPECT_EQ(child<QLabel>("status_message")->text(), "Playing") << "no time that stands still";
  player().pause();
  player().setTime(0);
  player().advance(2);
  EXPECT_DOUBLE_EQ(player().timeS(), 2);
  auto* speed = child<QComboBox>("replay_speed");
  speed->setCurrentIndex(speed->findData(0.25));
  player().advance(2);
  EXPECT_DOUBLE_EQ(player().timeS(), 2.5);
  player().play();
  player().advance(1000);
  EXPECT_DOUBLE_EQ(player().timeS(), 10);
  EXPECT_FALSE(player().playing());
  player().play();
  EXPECT_DOUBLE_EQ(player().timeS(), 0) << "again from the start";
  EXPECT_TRUE(waitFor([this] { return player().timeS() > 0; })) << "the clock runs by itself";
}

TEST_F(ReplayTest, DrivesNoDeviceAndGivesTheWindowBack) {
  auto* off = new QAction("Forces &off now");
  off->setObjectName("forcesOff");
  bool stopped = false;
  QObject::connect(off, &QAction::triggered, off, [&] {
    stopped = true;
    window().controllers().touch.show(TouchReadout{});  // As the force loop answers at once.
  });
  window().addToMenu("Touch", off);
  auto* forces = new QAction("&Forces on");
  forces->setObjectName("forces");
  window().addToMenu("Touch", forces);
  document().region().setRect({60, 50, 80, 80});
  const Region before = document().project().region;
  TouchReadout readout;
  readout.forces_on = true;
  window().controllers().touch.show(readout);
  replay();
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(forces->isEnabled());
  EXPECT_FALSE(action("coarser")->isEnabled()) << "the recording chooses the window";
  player().setTime(7);
  Probe live;
  live.window_id = document().window()->id;
  live.proxy = {1, 2, 3};
  window().controllers().touch.showProbe(live);
  EXPECT_NEAR(drawn().proxy.x, 116, 1e-9) << "the hand of now is not mixed in";
  QTest::keyClick(control().panel(), Qt::Key_Escape);
  EXPECT_FALSE(control().showing());
  EXPECT_EQ(document().project().region, before);
  EXPECT_FALSE(window().detailView().sceneState().probe.has_value());
  EXPECT_TRUE(forces->isEnabled());
  EXPECT_TRUE(action("coarser")->isEnabled());
}

TEST_F(ReplayTest, EndsWhenForcesComeOnByAnotherWay) {
  replay();
  TouchReadout readout;
  readout.forces_on = true;
  window().controllers().touch.show(readout);
  EXPECT_FALSE(control().showing());
  EXPECT_TRUE(status("status_message").contains("Forces are on"));
}

TEST_F(ReplayTest, OffersTheMapOfARecordingThatDoesNotFit) {
  // The other file lies beside the recording under another name than the recording says.
  const QString other = path("other.ply");
  QFile::copy(writeRelief(), other);
  QFile file(other);
  ASSERT_TRUE(file.open(QIODevice::Append));
  file.write("\n");
  file.close();
  recording_->input = "gone.ply";
  recording_->input_sha256 = sha256OfFile(other.toStdString());
  Project made;
  made.file = "gone.ply";
  made.sha256 = recording_->input_sha256;
  made.options.unit = LengthUnit::cm;  // As nobody would guess.
  made.options.view = ViewChoice{"top", {}};
  made.region = recording_->windows.front().region;
  recording_->state = projectJson(made);
  window().settings().addRecentFile(other);
  const QString before = document().file();
  window().settings().addRecentFile(before);  // Looked at first.
  replay();
  EXPECT_FALSE(control().showing());
  EXPECT_TRUE(window().message().contains("gone.ply, not on relief.ply. Nothing was changed."))
      << window().message().toStdString();
  EXPECT_EQ(document().file(), before);
  QPushButton* open = nullptr;
  for (auto* button : window().findChildren<QPushButton*>()) {
    if (button->text().contains("input") && button->isVisible()) open = button;
  }
  ASSERT_NE(open, nullptr);
  open->click();
  ASSERT_TRUE(waitFor([this] { return control().showing(); })) << window().message().toStdString();
  EXPECT_EQ(document().file(), other) << "found by its checksum";
  EXPECT_EQ(document().surface()->unit, LengthUnit::cm) << "as it was recorded on";
  EXPECT_DOUBLE_EQ(document().project().region.side_mm, 100);
}

TEST_F(ReplayTest, ARecordingOfAnotherViewIsNotShownOnThisOne) {
  recording_->view_from_file = document().surface()->view_from_file.m;
  replay();
  EXPECT_TRUE(control().showing()) << window().message().toStdString();
  control().close();
  (*recording_->view_from_file)[0] *= -1;
  const Region before = document().project().region;
  replay();
  EXPECT_FALSE(control().showing());
  EXPECT_TRUE(window().message().contains("another view of relief.ply"))
      << window().message().toStdString();
  EXPECT_EQ(document().project().region, before);
}

TEST_F(ReplayTest, SaysWhatCannotBeReplayedAndChangesNothing) {
  window().replay(path("other.csv"));
  ASSERT_TRUE(waitFor([this] { return !window().message().isEmpty(); }));
  EXPECT_EQ(window().message(), "This is no recording.");
  EXPECT_FALSE(control().showing());
  TouchReadout readout;
  readout.recording = true;
  window().controllers().touch.show(readout);
  window().replay(path("touch.csv"));
  EXPECT_TRUE(window().message().contains("Stop it first"));
  EXPECT_FALSE(control().reading());
}

/// What of the second picture is not as in the first.
QRect differing(const QImage& a, const QImage& b) {
  QRect all;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (a.pixel(x, y) != b.pixel(x, y)) all |= QRect(x, y, 1, 1);
    }
  }
  return all;
}

TEST(StripPlot, EventsAreMarkedAtTheirTimes) {
  QWidget parent;
  StripPlot plot("Height", "z (mm)", {"z"}, 10, &parent);
  plot.widget()->resize(600, 200);
  plot.setTimes(0, 8);
  const auto drawn = [&](const QVector<double>& events) {
    plot.setEvents(events);
    plot.replot();
    return plot.widget()->grab().toImage();
  };
  const QImage empty = drawn({});
  const QRect early = differing(empty, drawn({2})), late = differing(empty, drawn({6}));
  const QRect ends = differing(empty, drawn({0, 8}));
  EXPECT_TRUE(differing(empty, drawn({-1, 9})).isEmpty()) << "before and after what is shown";
  EXPECT_GT(early.width(), 3);
  EXPECT_LT(early.width(), 20);
  EXPECT_EQ(early.top(), late.top());
  EXPECT_LT(early.height(), 20);
  EXPECT_NEAR(late.center().x() - early.center().x(), ends.width() / 2, 3);
}

/// From left to right, [first, last] columns with ink; parts of one number lie closer than `gap`.
QVector<QPair<int, int>> inkOf(const QImage& image, int gap) {
  QVector<QPair<int, int>> runs;
  for (int x = 0; x < image.width(); ++x) {
    bool is_ink = false;
    // The upper third has the marks of the scale.
    for (int y = image.height() / 3; y < image.height() && !is_ink; ++y) {
      is_ink = qGray(image.pixel(x, y)) < 128;
    }
    if (!is_ink) continue;
    if (!runs.isEmpty() && x - runs.back().second < gap) {
      runs.back().second = x;
    } else {
      runs.append({x, x});
    }
  }
  return runs;
}

TEST(StripPlot, NumbersOfSecondsDoNotTouchEachOtherHoweverNarrowThePlotIs) {
  QWidget parent;
  StripPlot plot("Height", "z (mm)", {"Hand"}, 10, &parent);
  plot.setColours(Qt::white, Qt::lightGray, Qt::black, {QPen(Qt::blue)});
  QFont large = parent.font();
  large.setPointSizeF(20);
  plot.takeFont(large);
  large.setPointSizeF(0.85 * large.pointSizeF());
  const QFontMetrics metrics(large);
  QWidget* axis = plot.widget()->findChild<QWidget*>("QwtPlotAxisXBottom");
  ASSERT_NE(axis, nullptr);
  QVector<int> counts;
  for (const int width : {1200, 500, 320, 290}) {
    plot.widget()->resize(width, 200);
    plot.replot();
    plot.widget()->grab();  // Lays out what was resized while it was not shown.
    const QImage image = plot.widget()->grab(axis->geometry()).toImage();
    const auto numbers = inkOf(image, metrics.horizontalAdvance('0') / 2);
    counts << numbers.size();
    for (const auto& [first, last] : numbers) {
      EXPECT_LE(last - first, metrics.horizontalAdvance("-10")) << width;
    }
  }
  EXPECT_EQ(counts.front(), 6) << "every two seconds";
  EXPECT_EQ(counts.back(), 2) << "one at each end";
}

TEST(StripPlot, ARoundingDoesNotLookLikeAJump) {
  QWidget parent;
  StripPlot plot("Height", "z (mm)", {"z"}, 10, &parent);
  plot.widget()->resize(600, 200);
  plot.setTimes(0, 8);
  const auto drawn = [&](double step) {
    plot.setCurve(0, {{0, 5}, {4, 5}, {4, 5 + step}, {8, 5 + step}});
    plot.setRangeFromCurves(0.05);
    plot.replot();
    return plot.widget()->grab().toImage();
  };
  EXPECT_LT(differing(drawn(0), drawn(1e-6)).height(), 4);
  EXPECT_GT(differing(drawn(0), drawn(0.03)).height(), 20);
  EXPECT_GT(differing(drawn(0), drawn(10)).height(), 50);
}

TEST_F(ReplayTest, ThePlotsMarkWhatHappened) {
  const auto forces = [this] {
    replay();
    EXPECT_TRUE(waitFor([this] { return !control().reading(); }));
    player().setTime(9);
    QImage image;
    for (QWidget* const plot : control().panel()->findChildren<QWidget*>()) {
      if (plot->accessibleName().startsWith("Force")) image = plot->grab().toImage();
    }
    return image;
  };
  forces();  // The panel takes its size.
  const QImage plain = forces();
  ASSERT_FALSE(plain.isNull());
  recording_->events = {{.t_s = 5, .text = "here", .is_note = true}};
  const QRect mark = differing(plain, forces());
  EXPECT_GT(mark.width(), 3);
  EXPECT_LT(mark.width(), 20);
}

TEST_F(ReplayTest, ALongRecordingIsPlottedPartByPart) {
  for (int i = 1; i <= 70; ++i) {
    TouchRow row = recording_->rows.back();
    row.t_s += 1;
    recording_->rows.push_back(row);
  }
  replay();
  EXPECT_EQ(control().panel()->shownS(), (std::pair{0.0, 20.0}));
  player().setTime(47);
  EXPECT_EQ(control().panel()->shownS(), (std::pair{40.0, 60.0}));
  player().setTime(80);
  EXPECT_EQ(control().panel()->shownS(), (std::pair{60.0, 80.0}));
}

}  // namespace
}  // namespace relievo
