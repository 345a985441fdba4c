// SPDX-License-Identifier: BSD-3-Clause
// The whole program for as long as asked: the real force thread with the virtual hand, or with the
// emulated Falcon behind the real libusb, while the window renders, opens scans and switches
// levels. Writes what the loop counted, and what the Falcon saw. Exit 1: a force went beyond its
// bounds.
//   xvfb-run -a build/release/benchmark/soak_test --minutes 60 --out evidence.md
//   xvfb-run -a build/release/benchmark/soak_test --falcon --busy 2 --minutes 60 --out wire.md
#include <QVTKOpenGLNativeWidget.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <QAction>
#include <QApplication>
#include <QCommandLineParser>
#include <QDateTime>
#include <QElapsedTimer>
#include <QFile>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimer>

#include <csignal>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

#include "app/host.h"
#include "haptics/rt/realtime_thread.h"
#include "plugins/haptics/haptics_plugin.h"
#include "tests/emulator/mock_usb.h"
#include "tests/realtime/falcon_wire.h"
#include "ui/views/detail_view.h"
#include "ui/vtk/depth_capture.h"
#include "ui/vtk/offscreen.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {

/// What was done to the program while the loop ran.
struct Deeds {
  int opened = 0, levels = 0, forces_on = 0, forces_off = 0, presses = 0, blocked = 0;
};

class Exerciser : public QObject {
 public:
  /// @param falcon  whose grip is moved; null: the mouse leads the hand
  Exerciser(MainWindow& window, WindowHost& host, emulator::SharedFalcon* falcon)
      : window_(window), host_(host), falcon_(falcon) {
    every(50, [this] { moveHand(); });
    every(2'300, [this] { switchLevel(); });
    every(30'000, [this] { openNext(); });
    every(20'000, [this] { switchForcesOff(); });
    QTimer::singleShot(3'000, this, [this] { setForces(true); });
    every(60'000, [this] { block(); });
    // A person whose Falcon answered late switches the forces on again.
    if (falcon_ != nullptr) every(1'000, [this] { setForces(true); });
    openNext();
  }
  const Deeds& deeds() const { return deeds_; }

 private:
  template <class Work>
  void every(int ms, Work work) {
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, work);
    timer->start(ms);
  }
  void send(QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons held) {
    DetailView& view = window_.detailView();
    QMouseEvent event(type, at, view.mapToGlobal(at.toPoint()), button, held, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  }
  /// A path that fills the view; pressed in for two thirds of the time.
  void moveHand() {
    const double t = 0.05 * ++steps_;
    const QRectF box = QRectF(window_.detailView().rect());
    const QPointF at(box.center().x() + 0.35 * box.width() * std::sin(0.61 * t),
                     box.center().y() + 0.35 * box.height() * std::sin(0.47 * t + 1));
    const bool press = steps_ % 60 < 40;
    if (falcon_ != nullptr) {
      deeds_.presses += press && !pressed_ ? 1 : 0;
      pressed_ = press;
      falcon_->with([&](emulator::FalconEmulator& f) {
        f.body.pullToward(
            {20 * std::sin(0.61 * t), 20 * std::sin(0.47 * t + 1), press ? kPressedZ : kLiftedZ});
      });
      return;
    }
    if (press != pressed_) {
      pressed_ = press;
      deeds_.presses += press ? 1 : 0;
      send(press ? QEvent::MouseButtonPress : QEvent::MouseButtonRelease, at, Qt::LeftButton,
           press ? Qt::LeftButton : Qt::NoButton);
    }
    send(QEvent::MouseMove, at, Qt::NoButton, press ? Qt::LeftButton : Qt::NoButton);
  }
  void switchLevel() {
    constexpr std::array<const char*, 5> kCommands{"finer", "finer", "coarser", "finer", "whole"};
    if (host_.run(QString::fromLatin1(kCommands[next_level_++ % kCommands.size()]))) {
      ++deeds_.levels;
    }
  }
  void openNext() {
    constexpr std::array<const char*, 3> kSamples{"panel.ply", "relief_f.ply", "coin.ply"};
    OpenRequest request;
    request.file = QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/") +
                   QString::fromLatin1(kSamples[next_sample_++ % kSamples.size()]);
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    window_.open(request);
    ++deeds_.opened;
  }
  void setForces(bool on) {
    auto* forces = window_.findChild<QAction*>(QStringLiteral("forces"));
    if (forces->isChecked() == on) return;
    forces->trigger();
    ++(on ? deeds_.forces_on : deeds_.forces_off);
  }
  void switchForcesOff() {
    setForces(false);
    QTimer::singleShot(1'500, this, [this] { setForces(true); });
  }
  /// The GUI thread does nothing at all for a second, as one that hangs.
  void block() {
    sleepUntil(monotonicNs() + 1'000'000'000);
    ++deeds_.blocked;
  }

  static constexpr double kPressedZ = 112, kLiftedZ = 158;  // Of the grip, mm from the base.
  MainWindow& window_;
  WindowHost& host_;
  emulator::SharedFalcon* falcon_;
  Deeds deeds_;
  int steps_ = 0;
  std::size_t next_level_ = 0, next_sample_ = 0;
  bool pressed_ = false;
};

QString edgeText(std::int64_t ns) {
  return ns < 1'000'000 ? QStringLiteral("%1 us").arg(static_cast<double>(ns) / 1e3)
                        : QStringLiteral("%1 ms").arg(static_cast<double>(ns) / 1e6);
}

template <std::size_t Edges>
void writeBins(QTextStream& out, const char* what, const std::array<std::int64_t, Edges>& edges,
               const std::array<std::uint64_t, Edges + 1>& counts, std::uint64_t ticks) {
  out << "\n| " << what << " | ticks | share |\n|---|---:|---:|\n";
  for (std::size_t i = 0; i <= Edges; ++i) {
    const QString label =
        i < Edges ? QStringLiteral("up to ") + edgeText(edges[i]) : QStringLiteral("longer");
    out << "| " << label << " | " << counts[i] << " | "
        << QString::number(100.0 * static_cast<double>(counts[i]) / static_cast<double>(ticks), 'f',
                           4)
        << " % |\n";
  }
}

/// What the emulated Falcon saw, and every time that its force went out in a touch.
void writeWire(QTextStream& out, const test::FalconWire& wire) {
  out << "\n| the Falcon's side | |\n|---|---:|\n"
      << "| commands | " << wire.commands() << " |\n"
      << "| of these, unreadable | " << wire.badCommands() << " |\n"
      << "| of these, with a force | " << wire.pushing() << " |\n"
      << "| largest force at the grip, looked at 20 times a second | "
      << QString::number(wire.largestN(), 'f', 3) << " N |\n"
      << "| longest time between two commands | " << QString::number(wire.longestMs(), 'f', 1)
      << " ms |\n"
      << "| times that the force went out in a touch and came back within a second | "
      << wire.forceGaps().size() << " |\n";
  writeBins(out, "from command to command", test::FalconWire::kEdgesNs, wire.gaps(),
            std::max<std::uint64_t>(wire.commands(), 2) - 1);
  out << "\n| force out at | for | commands of zero |\n|---|---:|---:|\n";
  for (const test::FalconWire::ForceGap& gap : wire.forceGaps()) {
    out << "| " << QString::number(gap.at_s, 'f', 1) << " s | " << QString::number(gap.ms, 'f', 0)
        << " ms | " << gap.commands << " |\n";
  }
}

void writeReport(QTextStream& out, const LoopStats& stats, const RealtimeGrant& grant,
                 const Deeds& deeds, double seconds, const QString& hand, const QString& words) {
  const ForceAudit& audit = stats.audit;
  out << "# The force loop for " << QString::number(seconds / 60, 'f', 1) << " minutes\n\n"
      << "The whole program: the real force thread with " << hand << ", while the\n"
      << "window renders, opens the samples, switches levels, is pressed on and is blocked. "
         "Written\n"
      << "by `soak_test" << words << "`, which ends with an error\n"
      << "if a force went beyond its bounds; the bounds are computed from each tick's inputs "
         "alone\n"
      << "(`ForceAudit`). Stalls of the computer itself are in the tables; nothing is left out.\n\n"
      << "| | |\n|---|---:|\n"
      << "| ended | " << QDateTime::currentDateTimeUtc().toString(Qt::ISODate) << " |\n"
      << "| ticks | " << stats.ticks << " |\n"
      << "| ticks whose inputs demand zero | " << audit.zero_demanded << " |\n"
      << "| of these, with a force | " << audit.zero_violations << " |\n"
      << "| forces above the limit or not finite | " << audit.limit_violations << " |\n"
      << "| changes above the slew limit | " << audit.step_violations << " |\n"
      << "| largest force | " << QString::number(audit.largest_n, 'f', 3) << " N |\n"
      << "| largest change in a tick | " << QString::number(audit.largest_step_n, 'f', 4)
      << " N |\n"
      << "| late ticks (more than half a period) | " << stats.late_ticks << " |\n"
      << "| pauses over 20 ms, force from zero | " << stats.pauses << " |\n"
      << "| cuts by the watchdog | " << stats.watchdog_cuts << " |\n"
      << "| longest time between ticks | " << QString::number(stats.worst_period_ms, 'f', 1)
      << " ms |\n"
      << "| work per tick, mean and worst | " << QString::number(stats.mean_tick_us, 'f', 2)
      << " / " << QString::number(stats.worst_tick_us, 'f', 1) << " us |\n"
      << "| page faults of the loop's thread | " << stats.page_faults << " |\n"
      << "| real-time priority | "
      << (grant.realtime ? QStringLiteral("granted") : QString::fromStdString(grant.note)) << " |\n"
      << "| scans opened | " << deeds.opened << " |\n"
      << "| levels switched | " << deeds.levels << " |\n"
      << "| presses | " << deeds.presses << " |\n"
      << "| forces switched on, off | " << deeds.forces_on << ", " << deeds.forces_off << " |\n"
      << "| seconds with the GUI thread blocked | " << deeds.blocked << " |\n";
  writeBins(out, "wake-up delay", LoopStats::kDelayEdgesNs, stats.delays, stats.ticks);
  writeBins(out, "work", LoopStats::kWorkEdgesNs, stats.work, stats.ticks);
}

const QString kFalconWord = QStringLiteral("falcon"), kBusyWord = QStringLiteral("busy");

int run(QApplication& app) {
  QCommandLineParser parser;
  const QCommandLineOption minutes(QStringLiteral("minutes"), QStringLiteral("How long."),
                                   QStringLiteral("N"), QStringLiteral("1"));
  const QCommandLineOption file(QStringLiteral("out"), QStringLiteral("Where the report goes."),
                                QStringLiteral("FILE"), QStringLiteral("evidence.md"));
  // Both are looked at before there is an application.
  const QCommandLineOption falcon_option(kFalconWord, QStringLiteral("With an emulated Falcon."));
  const QCommandLineOption busy(kBusyWord, QStringLiteral("Other processes that do nothing else."),
                                QStringLiteral("N"), QStringLiteral("0"));
  parser.addOptions({minutes, file, falcon_option, busy});
  parser.addHelpOption();
  parser.process(app);

  std::unique_ptr<emulator::MockUsb> usb;
  std::shared_ptr<emulator::SharedFalcon> falcon;
  std::unique_ptr<test::FalconWire> wire;
  if (parser.isSet(falcon_option)) {
    usb = std::make_unique<emulator::MockUsb>();
    falcon = std::make_shared<emulator::SharedFalcon>(
        emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
    falcon->with([](emulator::FalconEmulator& f) { f.body.pullToward({0, 0, 158}); });
    usb->plugIn(falcon);
    wire = std::make_unique<test::FalconWire>(falcon);
  }
  MainWindow window(captureDepths);
  WindowHost host(window);
  HapticsPlugin plugin;
  plugin.attach(host.parts());
  plugin.restoreState(falcon ? R"({"device": "falcon:0", "strength_percent": 100})"
                             : R"({"device": "virtual:firm", "strength_percent": 100})");
  window.resize(900, 600);
  window.show();
  QElapsedTimer clock;
  clock.start();
  Exerciser exerciser(window, host, falcon.get());
  QTimer wire_timer;
  if (wire) {
    QObject::connect(&wire_timer, &QTimer::timeout, &wire_timer, [&] { wire->take(); });
    wire_timer.start(50);
  }
  const auto line = [&] {
    const LoopStats& stats = plugin.loopStats();
    std::printf("%7.1f s  ticks %llu  late %llu  pauses %llu  worst %.1f ms  violations %llu\n",
                1e-3 * static_cast<double>(clock.elapsed()),
                static_cast<unsigned long long>(stats.ticks),
                static_cast<unsigned long long>(stats.late_ticks),
                static_cast<unsigned long long>(stats.pauses), stats.worst_period_ms,
                static_cast<unsigned long long>(stats.audit.violations()));
    std::fflush(stdout);
  };
  QTimer tell;
  QObject::connect(&tell, &QTimer::timeout, line);
  tell.start(60'000);
  QTimer::singleShot(static_cast<int>(60'000 * parser.value(minutes).toDouble()), &app,
                     &QApplication::quit);
  QApplication::exec();

  line();
  const LoopStats stats = plugin.loopStats();
  QFile out(parser.value(file));
  if (!out.open(QIODevice::WriteOnly)) {
    std::fprintf(stderr, "soak_test: %s cannot be written.\n", qPrintable(out.fileName()));
    return 3;
  }
  QTextStream text(&out);
  const QString busy_words =
      parser.value(busy) == QStringLiteral("0")
          ? QString()
          : QStringLiteral(", beside %1 processes that keep a core each busy")
                .arg(parser.value(busy));
  const QString hand = (falcon ? QStringLiteral("the emulated Falcon behind the real libusb")
                               : QStringLiteral("the virtual hand (firm grip)")) +
                       busy_words;
  writeReport(text, stats, plugin.realtime(), exerciser.deeds(),
              1e-3 * static_cast<double>(clock.elapsed()), hand,
              ' ' + QCoreApplication::arguments().mid(1).join(' '));
  if (wire) {
    wire->take();
    writeWire(text, *wire);
  }
  text.flush();
  plugin.detach();
  return stats.audit.violations() == 0 ? 0 : 1;
}

/// The mocked port is a preloaded library's.
void preloadMock(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const bool falcon = std::find(words.begin(), words.end(), "--falcon") != words.end();
  if (!falcon || std::getenv("LD_PRELOAD") != nullptr) return;
  setenv("LD_PRELOAD", "libumockdev-preload.so.0", 1);
  execv("/proc/self/exe", argv);
}

/// Processes that only compute, until this one ends.
void keepCoresBusy(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const auto busy = std::find(words.begin(), words.end(), "--busy");
  if (busy == words.end() || busy + 1 == words.end()) return;
  const pid_t parent = getpid();
  for (int i = std::atoi((busy + 1)->data()); i > 0; --i) {
    if (fork() != 0) continue;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    volatile double sum = 0;
    while (getppid() == parent) {
      for (int k = 0; k < 1'000'000; ++k) sum = sum + std::sqrt(k);
    }
    _exit(0);
  }
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  relievo::preloadMock(argc, argv);
  relievo::keepCoresBusy(argc, argv);
  const relievo::DisplayGuard display;
  QTemporaryDir places;
  qputenv("XDG_CONFIG_HOME", places.filePath("config").toLocal8Bit());
  qputenv("XDG_STATE_HOME", places.filePath("state").toLocal8Bit());
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication app(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  return relievo::run(app);
}
