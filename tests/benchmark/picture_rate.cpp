// SPDX-License-Identifier: BSD-3-Clause
// Distinct pictures a second of both views while the pink window, the detail view, the hand and the
// camera are dragged, mono and anaglyph, and the processor's share at rest: for
// docs/dev/ui-figures.md. picture_rate [SCAN [SECONDS [ROW [composed]]]]; needs a display; of the
// rows only those whose name contains ROW. What is counted are pictures whose middle differs from
// the one before as the window shows them, not swaps. With "composed" Qt composes the views, as it
// does where OpenGL is not software.
#include <QVTKOpenGLNativeWidget.h>
#include <algorithm>
#include <chrono>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>
#include <QApplication>
#include <QHash>
#include <QImage>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest/QTest>
#include <string>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "ui/views/copied_picture.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/vtk/depth_capture.h"
#include "ui/vtk/offscreen.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double processSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Counts the pictures of a view that differ from those before, and how often it is composed.
class PictureCount : public QObject {
 public:
  explicit PictureCount(SurfaceView& view) : canvas_(view.findChild<QVTKOpenGLNativeWidget*>()) {
    connect(canvas_, &QOpenGLWidget::aboutToCompose, this, [this] { count(ofComposed()); });
    auto* const picture = view.findChild<CopiedPicture*>();
    connect(picture, &CopiedPicture::painted, this,
            [this, picture] { count(ofCopied(picture->image())); });
  }
  void restart() { distinct_ = composed_ = 0; }
  int distinct() const { return distinct_; }
  int composed() const { return composed_; }

 private:
  static constexpr int kSide = 96;

  void count(const QByteArray& bytes) {
    ++composed_;
    const uint seen = qHash(bytes);
    if (seen != last_) ++distinct_;
    last_ = seen;
  }
  static QByteArray ofCopied(const QImage& image) {
    QByteArray bytes;
    const int left = std::max(0, (image.width() - kSide) / 2);
    const int top = std::max(0, (image.height() - kSide) / 2);
    for (int row = top; row < std::min(top + kSide, image.height()); ++row) {
      const auto* const pixels = reinterpret_cast<const QRgb*>(image.constScanLine(row)) + left;
      const int cols = std::min(kSide, image.width());
      bytes.append(reinterpret_cast<const char*>(pixels), cols * static_cast<int>(sizeof(QRgb)));
    }
    return bytes;
  }
  QByteArray ofComposed() {
    const QSize size = canvas_->size() * canvas_->devicePixelRatioF();
    QByteArray bytes(4 * kSide * kSide, 0);
    canvas_->makeCurrent();
    QOpenGLFunctions* const gl = canvas_->context()->functions();
    gl->glBindFramebuffer(GL_FRAMEBUFFER, canvas_->defaultFramebufferObject());
    gl->glReadPixels((size.width() - kSide) / 2, (size.height() - kSide) / 2, kSide, kSide, GL_RGBA,
                     GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
  }

  QOpenGLWidget* canvas_;
  uint last_ = 0;
  int distinct_ = 0, composed_ = 0;
};

void sendMouse(QWidget& to, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::MouseButtons held) {
  QMouseEvent event(type, at, to.mapToGlobal(at.toPoint()), button, held, Qt::NoModifier);
  QApplication::sendEvent(&to, &event);
}

struct Rates {
  double detail = 0, reference = 0, cpu = 0;
};

class Bench {
 public:
  Bench(MainWindow& window, double seconds)
      : window_(window),
        seconds_(seconds),
        detail_(window.detailView()),
        reference_(window.referenceView()) {}

  /// The pointer goes round a circle of `radius` pixels, at 125 places a second as a mouse's; a
  /// round of the event loop gets one of them at most, as from an X server.
  Rates drag(QWidget& on, const QPointF& centre, double radius, Qt::MouseButton button) {
    const Clock::time_point start = Clock::now();
    const auto place = [&] {
      const double a = 2 * std::numbers::pi * secondsSince(start) / 3;
      return centre + radius * QPointF(std::cos(a), std::sin(a));
    };
    if (button != Qt::NoButton) sendMouse(on, QEvent::MouseButtonPress, place(), button, button);
    QTimer mouse;
    QObject::connect(&mouse, &QTimer::timeout,
                     [&] { sendMouse(on, QEvent::MouseMove, place(), Qt::NoButton, button); });
    mouse.start(8);
    const Rates rates = count();
    mouse.stop();
    if (button != Qt::NoButton) {
      sendMouse(on, QEvent::MouseButtonRelease, place(), button, Qt::NoButton);
    }
    QTest::qWait(300);
    return rates;
  }
  Rates count() {
    detail_.restart();
    reference_.restart();
    const double cpu = processSeconds();
    const Clock::time_point start = Clock::now();
    QTest::qWait(static_cast<int>(1000 * seconds_));
    const double took = secondsSince(start);
    return {detail_.distinct() / took, reference_.distinct() / took,
            100 * (processSeconds() - cpu) / took};
  }
  int composed() const { return detail_.composed(); }

 private:
  MainWindow& window_;
  double seconds_;
  PictureCount detail_, reference_;
};

void print(const char* what, const Rates& rates) {
  // On a computer that is busy with other things, rates say little and this what a picture costs.
  constexpr double kMsPerPercent = 10;
  const double both = rates.detail + rates.reference;
  std::printf("| %s | %.1f | %.1f | %.0f | %.0f |\n", what, rates.detail, rates.reference,
              rates.cpu, both > 0 ? kMsPerPercent * rates.cpu / both : 0);
  std::fflush(stdout);
}

void run(const QString& scan, double seconds, const std::string& row) {
  MainWindow window(captureDepths);
  WindowHost host(window);
  PluginLoader plugins(host, window.settings());
  plugins.load();
  window.resize(1440, 900);
  window.show();
  OpenRequest request;
  request.file = scan;
  request.unit = LengthUnit::mm;
  window.open(request);
  if (!QTest::qWaitFor(
          [&] { return window.document().isOpen() && !window.document().loader().busy(); },
          60'000)) {
    std::fprintf(stderr, "picture_rate: %s did not open.\n", qPrintable(scan));
    std::exit(1);
  }
  QTest::qWait(3000);
  Bench bench(window, seconds);
  ReferenceView& reference = window.referenceView();
  DetailView& detail = window.detailView();
  std::printf(
      "| | detail, pictures a second | reference | processor, %% of a core | ms a picture |\n");
  std::printf("|---|---:|---:|---:|---:|\n");
  for (const bool stereo : {false, true}) {
    if (stereo) window.runCommand("stereo");
    const std::string mode = stereo ? ", anaglyph" : "";
    const DetailLadder& ladder = window.document().surface()->ladder;
    const double side = 0.35 * ladder.sideMm(1);
    const double x = ladder.left_mm + 0.5 * ladder.width_mm;
    const double y = ladder.bottom_mm + 0.5 * ladder.height_mm;
    window.document().region().setRect({x - 0.5 * side, y - 0.5 * side, side, side});
    QTest::qWait(500);
    const QPointF middle = reference.pointOf(x, y);
    const QPointF over(0.5 * detail.width(), 0.5 * detail.height());
    const auto drag = [&](const std::string& what, QWidget& on, const QPointF& about, double radius,
                          Qt::MouseButton button) {
      if ((what + mode).find(row) == std::string::npos) return;
      print((what + mode).c_str(), bench.drag(on, about, radius, button));
    };
    drag("pink window dragged", reference, middle, 30, Qt::LeftButton);
    drag("detail view dragged", detail, over, 60, Qt::RightButton);
    drag("detail view turned", detail, over, 60, Qt::MiddleButton);
    detail.straighten();
    drag("hand hovers", detail, over, 40, Qt::NoButton);
    drag("hand presses", detail, over, 40, Qt::LeftButton);
  }
  const std::string at_rest = "at rest";
  if (at_rest.find(row) == std::string::npos) return plugins.detachAll();
  sendMouse(detail, QEvent::MouseMove, {5, 5}, Qt::NoButton, Qt::NoButton);
  QTest::qWait(15'000);  // The plots show the last ten seconds.
  const Rates rest = bench.count();
  print(at_rest.c_str(), rest);
  std::printf("\ncomposed at rest: %.1f a second\n", bench.composed() / seconds);
  plugins.detachAll();
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  const QTemporaryDir home;
  for (const char* place : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"}) {
    qputenv(place, home.path().toLocal8Bit());
  }
  const relievo::DisplayGuard display;
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  qputenv("QT_QPA_PLATFORM", "xcb");
  QApplication app(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  if (argc > 4 && std::string(argv[4]) == "composed") relievo::SurfaceView::setCopied(false);
  relievo::run(argc > 1 ? QString::fromLocal8Bit(argv[1])
                        : QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/panel.ply"),
               argc > 2 ? std::atof(argv[2]) : 6, argc > 3 ? argv[3] : "");
  return 0;
}
