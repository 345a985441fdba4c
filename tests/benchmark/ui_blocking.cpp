// SPDX-License-Identifier: BSD-3-Clause
// How long the window's thread is held up while a scan is loaded, a figure exported and a video
// made, and how long work goes on after Cancel. Prints a table for docs/dev/ui-figures.md.
// ui_blocking [SCAN [MS]]; needs a display. With MS, what took the window's thread longer than that
// is told on stderr, event by event. As on a computer where Mesa cannot keep what it compiled:
// MESA_SHADER_CACHE_DISABLE=true ui_blocking.
#include <QVTKOpenGLNativeWidget.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <string>
#include <thread>

#include "core/depth/rules/rasterize.h"
#include "core/session/load.h"
#include "ui/dialogs/video_control.h"
#include "ui/figure/figure.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/video/video.h"
#include "ui/views/detail_view.h"
#include "ui/vtk/depth_capture.h"
#include "ui/vtk/offscreen.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double threadMs() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Tells which events held up the thread.
class TellingApplication : public QApplication {
 public:
  using QApplication::QApplication;
  void tellFrom(double ms) { tell_from_ms_ = ms; }
  bool notify(QObject* receiver, QEvent* event) override {
    const std::string name =
        receiver->metaObject()->className() + (" " + receiver->objectName().toStdString());
    const int type = event->type();
    const Clock::time_point start = Clock::now();
    const double start_ms = threadMs();
    const bool taken = QApplication::notify(receiver, event);
    const double took_ms = msSince(start);
    if (took_ms >= tell_from_ms_) {
      std::fprintf(stderr, "  %6.1f ms, own %5.1f: event %d to %s\n", took_ms,
                   threadMs() - start_ms, type, name.c_str());
    }
    return taken;
  }

 private:
  double tell_from_ms_ = 1e9;
};

/// The longest time between two rounds of the event loop. Wall time counts what other programs
/// took, too; processor time is the window's own.
class Watch : public QObject {
 public:
  Watch() {
    last_ = Clock::now();
    last_cpu_ms_ = threadMs();
    startTimer(1, Qt::PreciseTimer);
  }
  double longestMs() const { return longest_ms_; }
  double longestCpuMs() const { return longest_cpu_ms_; }

 protected:
  void timerEvent(QTimerEvent* /*event*/) override {
    longest_ms_ = std::max(longest_ms_, msSince(last_));
    longest_cpu_ms_ = std::max(longest_cpu_ms_, threadMs() - last_cpu_ms_);
    last_ = Clock::now();
    last_cpu_ms_ = threadMs();
  }

 private:
  Clock::time_point last_;
  double last_cpu_ms_ = 0, longest_ms_ = 0, longest_cpu_ms_ = 0;
};

/// Events are handled until the condition holds. @return false: it never did
bool until(const std::function<bool()>& holds) {
  constexpr double kGiveUpMs = 300'000;
  const Clock::time_point start = Clock::now();
  while (!holds()) {
    if (msSince(start) > kGiveUpMs) return false;
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 5);
  }
  return true;
}

/// Half a second, in which the window draws what it was asked for.
void settle() {
  const Clock::time_point start = Clock::now();
  until([&] { return msSince(start) > 500; });
}

void measured(const char* what, const std::function<void()>& begin,
              const std::function<bool()>& done) {
  const Watch watch;
  const Clock::time_point start = Clock::now();
  begin();
  const bool ended = until(done);
  const double took_ms = msSince(start);
  settle();  // What follows the end, too.
  std::printf("| %s%s | %.1f | %.0f | %.0f |\n", what, ended ? "" : " (never ended)",
              1e-3 * took_ms, watch.longestMs(), watch.longestCpuMs());
  std::fflush(stdout);
}

/// From the request to stop until the work has left its function.
void cancelled(const char* what, double after_ms, const std::function<void(const Task&)>& work) {
  std::stop_source stop;
  std::atomic<bool> early = true;
  Clock::time_point asked;
  std::thread worker([&] {
    try {
      work(Task{stop.get_token(), {}});
    } catch (const Cancelled&) {
      early = false;
    }
  });
  std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(after_ms));
  asked = Clock::now();
  stop.request_stop();
  worker.join();
  std::printf("| %s, after %.0f ms | %s%.0f |\n", what, after_ms,
              early ? "ended before Cancel; " : "", msSince(asked));
  std::fflush(stdout);
}

TouchRecording recordingOn(const Region& region) {
  TouchRecording recording;
  recording.name = "made.csv";
  for (int i = 0; i <= 2000; ++i) {
    TouchRow row;
    row.t_s = 0.001 * i;
    row.proxy = row.hip = {region.x_mm + region.side_mm * i / 2000, region.centreY(), 1};
    row.window_id = 1;
    recording.rows.push_back(row);
  }
  recording.windows = {{1, region, 1, true}};
  return recording;
}

void run(const QString& scan) {
  const QTemporaryDir folder;
  qputenv("XDG_CONFIG_HOME", folder.path().toLocal8Bit());
  qputenv("XDG_STATE_HOME", folder.path().toLocal8Bit());
  MainWindow window(captureDepths, Settings::Mode::safe);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) std::printf("The window did not appear.\n");
  std::printf(
      "| Work | seconds | longest block, ms | of the thread's own, ms |\n|---|---|---|---|\n");
  measured(
      "load", [&] { window.open(scan); },
      [&] {
        return !window.message().isEmpty() ||
               (window.document().isOpen() && !window.document().loader().busy());
      });
  if (!window.document().isOpen()) {
    std::printf("%s\n", window.message().toLocal8Bit().constData());
    return;
  }
  measured(
      "finer", [&] { window.runCommand("finer"); }, [] { return true; });
  for (const char* command :
       {"relief_height", "relief_hillshade", "relief_multi", "relief_slope", "relief_local",
        "relief_skyview", "relief_openness", "relief_multiscale", "relief_curvature", "relief_lit",
        "stereo", "full_screen"}) {
    const auto before = window.detailView().sceneState().grid;
    measured((std::string("first use of ") + command).c_str(),
             [&] {
               if (!window.runCommand(command)) std::printf("There is no command %s.\n", command);
             },
             [&] {  // What takes longer is painted in a worker.
               const SceneState& scene = window.detailView().sceneState();
               return std::string(command).rfind("relief_", 0) != 0 || scene.grid != before;
             });
  }
  measured(
      "full screen left", [&] { window.runCommand("full_screen"); }, [] { return true; });
  window.runCommand("stereo");
  settle();
  measured(
      "picture of a view, 1600 x 1200",
      [&] {
        window.saveImage(ImageSource::detail, {1600, 1200}, folder.filePath("picture.png"));
      },
      [&] { return !window.savingImage(); });
  measured(
      "figure, 180 mm at 600 dpi",
      [&] {
        window.runCommand("figure");
        auto* dialog = window.findChild<QDialog*>("figure_dialog");
        dialog->findChild<QLineEdit*>("figure_file")->setText(folder.filePath("figure.png"));
        dialog->findChild<QDoubleSpinBox*>("figure_dpi")->setValue(600);
        QMetaObject::invokeMethod(dialog->findChild<QPushButton*>("figure_save"), "click");
      },
      [&] { return QFile::exists(folder.filePath("figure.png")); });
  if (auto* dialog = window.findChild<QDialog*>("figure_dialog")) dialog->reject();
  settle();
  const TouchRecording recording = recordingOn(window.document().project().region);
  window.controllers().replays.setReader(
      [&](const std::filesystem::path&, const Task&) { return recording; });
  QFile made(folder.filePath("made.csv"));
  if (!made.open(QIODevice::WriteOnly)) return;
  made.close();
  measured(
      "replay", [&] { window.replay(made.fileName()); },
      [&] { return window.controllers().replays.control().showing(); });
  measured(
      "video of the replay, 2 s",
      [&] { window.controllers().videos.write(VideoRequest{}, folder.filePath("replay.mp4")); },
      [&] { return !window.controllers().videos.control().writing(); });
  window.controllers().replays.control().close();
  window.runCommand("key_view");
  window.runCommand("finer");
  window.runCommand("key_view");
  settle();
  measured(
      "video of the view, 3 s",
      [&] {
        window.controllers().videos.control().startLive(folder.filePath("live.mp4"),
                                                        VideoProfile::talk, "{}",
                                                        window.controllers().videos.liveSource());
      },
      [&] { return window.controllers().videos.control().liveS() > 3; });
  measured(
      "the same, 3 s, along a camera path", [&] { window.runCommand("path_play"); },
      [&] { return window.controllers().videos.control().liveS() > 6.5; });
  measured(
      "its end", [&] { window.controllers().videos.control().stopLive(); },
      [&] { return !window.controllers().videos.control().live(); });

  const auto dialog = [&] { return window.findChild<PrepareDialog*>(); };
  measured(
      "Prepare opens", [&] { window.runCommand("prepare"); },
      [&] { return dialog() != nullptr && !dialog()->isStale() && !dialog()->isBusy(); });
  measured(
      "a step of it, before and after drawn",
      [&] {
        PrepareChoices next = dialog()->state().now();
        next.steps.push_back({Lonely{}});
        dialog()->state().change(next);
        dialog()->findChild<QPushButton*>("prepare_recompute")->click();
      },
      [&] { return !dialog()->isStale() && !dialog()->isBusy(); });
  dialog()->reject();
  settle();

  std::printf("\n| Cancel of | ms until it has stopped |\n|---|---|\n");
  SurfaceOptions options = window.document().project().options;
  for (const double after_ms : {50.0, 300.0, 700.0}) {
    cancelled("load", after_ms, [&](const Task& task) {
      loadSurface(scan.toStdString(), options, rasterize, {}, task);
    });
  }
  const std::shared_ptr<const Scan> points = window.document().source().scan;
  const Recipe slow{.steps = {Outliers{.neighbours = kMostNeighbours}}};
  for (const double after_ms : {20.0, 200.0, 2000.0}) {
    cancelled("steps of Prepare", after_ms,
              [&](const Task& task) { prepare({points.get()}, slow, {}, task); });
  }
  const auto surface = window.document().surface();
  Project project = window.project();
  project.figure.width_mm = 180;
  project.figure.dpi = 600;
  for (const double after_ms : {100.0, 1000.0}) {
    cancelled("figure", after_ms, [&](const Task& task) { drawFigure(*surface, project, task); });
  }
  for (const double after_ms : {100.0, 1500.0}) {
    cancelled("video", after_ms, [&](const Task& task) {
      writeVideo(*surface, &recording, VideoRequest{}, "{}",
                 folder.filePath("cancelled.mp4").toStdString(), task);
    });
  }
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  const relievo::DisplayGuard display;
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  qputenv("QT_QPA_PLATFORM", "xcb");
  relievo::TellingApplication app(argc, argv);
  if (argc > 2) app.tellFrom(std::strtod(argv[2], nullptr));
  std::setlocale(LC_NUMERIC, "C");
  relievo::installAccessibleViews();
  relievo::run(argc > 1 ? QString::fromLocal8Bit(argv[1])
                        : QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply"));
  return 0;
}
