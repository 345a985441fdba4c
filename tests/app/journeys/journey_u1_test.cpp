// SPDX-License-Identifier: BSD-3-Clause
// Journey U1: a researcher with a Falcon drops a relief on the window, says its unit, closes gaps,
// feels dome, hole, ridge and grating, records, measures a step by touch, replays, makes a figure
// for print, and opens the work again without the Falcon. The Falcon is emulated behind the real
// libusb; pictures are kept in screenshots/ of the build folder.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QtTest/QTest>
#include <thread>

#include "core/project/recording.h"
#include "core/provenance/embedded.h"
#include "data/generate/relief_f.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/protocol.h"
#include "tests/app/journeys/journey.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/mock_usb.h"
#include "tests/emulator/stall_watch.h"
#include "ui/dialogs/depth_map_dialog.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/figure/figure.h"
#include "ui/panels/measure_panel.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using emulator::FalconEmulator;
using emulator::SharedFalcon;
using emulator::Triple;

constexpr Triple kFarOut{0, 0, 172}, kFarIn{0, 0, 90};
constexpr double kAboveZ = 150, kBelowZ = 108;  // Of the grip, over and under the relief.
constexpr std::chrono::milliseconds kShortPress{150};
constexpr double kLightZ = 121;      // A light press at the finest detail.
constexpr int kPatienceMs = 20'000;  // Then a person tries again.
const QString kRelief = QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply");

class JourneyU1 : public Journey {
 protected:
  JourneyU1() : Journey("u1") {}
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    const fs::path image = path("image.bin").toStdString();
    const std::vector<std::uint8_t> bytes = test::madeImage();
    std::ofstream(image, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    falcon::installFirmware(falcon::readFirmware(image), falcon::firmwarePlaces());
    window().settings().setChoice(
        QStringLiteral("plugins/haptics_plugin"),
        QByteArray(R"({"device": "falcon:0", "bound_by_rate": false})").toBase64());
    falcon_ = std::make_shared<SharedFalcon>(emulator::EmulatorOptions{});
    usb_.plugIn(falcon_);
    attach();
  }
  bool lit(int lights) {
    return eventually([&] {
      return falcon_->with([&](FalconEmulator& f) {
        return !f.commands().empty() && f.commands().back().lights == lights;
      });
    });
  }
  /// The hand over a place of the object, as deep as `z` says.
  void handTo(double x_mm, double y_mm, double z) {
    const HandMapping map = handMapping(*document().window());
    const DeviceMm at = map.device_from_view({x_mm, y_mm, 0});
    depth_ = z;
    falcon_->with([&](FalconEmulator& f) {
      f.body.pullToward({at.x + aside_.x, at.y + aside_.y, z});
    });
  }
  /// Commands of the force loop that have reached the device.
  std::uint64_t commandCount() {
    return falcon_->with([](FalconEmulator& f) { return f.commandCount(); });
  }
  /// A person whose hand rests and who sees that the proxy is elsewhere steers on. A window that
  /// came under a touching hand keeps the touched point there, so that the hand need not be in the
  /// middle of its space.
  bool proxyNear(double x_mm, double y_mm, double within_mm) {
    constexpr std::uint64_t kRestAfter = 1000;  // The hand's spring has settled long before.
    std::uint64_t steered_at = commandCount();
    return eventually([&] {
      if (!probe()) return false;
      const double aside_x = x_mm - probe()->proxy.x, aside_y = y_mm - probe()->proxy.y;
      if (std::hypot(aside_x, aside_y) < within_mm) return true;
      const bool is_of_this_window = probe()->window_id == document().window()->id;
      if (!is_of_this_window || commandCount() < steered_at + kRestAfter) return false;
      const double scale = handMapping(*document().window()).device_per_view;
      aside_.x += scale * aside_x;
      aside_.y += scale * aside_y;
      handTo(x_mm, y_mm, depth_);
      steered_at = commandCount();
      return false;
    });
  }
  /// Forces on over a place, then down on it. A busy computer may stop the forces for safety; then
  /// a person lifts the hand and begins again.
  bool touch(double x_mm, double y_mm, double z = kBelowZ) {
    const auto pushed = [this] {
      return falcon_->with([](FalconEmulator& f) { return f.body.force()[2] > 0.2; }) &&
             probe()->touching && probe()->hip.z < probe()->proxy.z;
    };
    return stalls_.repeatAfterStalls(5, [&] {
      handTo(x_mm, y_mm, kAboveZ);
      if (!proxyNear(x_mm, y_mm, 3)) return false;
      if (!action("forces")->isChecked()) key(Qt::Key_F5);
      if (!QTest::qWaitFor([this] { return probe() && probe()->forces_on; }, kPatienceMs)) {
        return false;
      }
      handTo(x_mm, y_mm, z);
      return QTest::qWaitFor(pushed, kPatienceMs);
    });
  }
  /// Runs a command that makes another surface; does the hand feel that one then?
  bool otherSurfaceBy(const char* command) {
    const std::uint64_t before = document().window()->id;
    window().runCommand(command);
    return eventually([&] {
      const std::uint64_t now = document().window()->id;
      return now != before && probe() && probe()->window_id == now;
    });
  }
  /// Window and hand, for a failure's message.
  std::string where() {
    const Region& r = document().project().region;
    return "window " + std::to_string(r.x_mm) + ", " + std::to_string(r.y_mm) + ", side " +
           std::to_string(r.side_mm) + "; proxy " +
           (probe() ? std::to_string(probe()->proxy.x) + ", " + std::to_string(probe()->proxy.y)
                    : "none") +
           "; " + said().toStdString();
  }
  /// Plus, pressed shortly; again if a busy computer took it for a long press, which goes
  /// elsewhere.
  bool plus(int wanted_detail) {
    const int before = document().detail();
    return stalls_.repeatAfterStalls(5, [&] {
      if (document().detail() != before) window().runCommand("undo");
      falcon_->with([](FalconEmulator& f) { f.buttons = 1; });
      std::this_thread::sleep_for(kShortPress);  // A window that is drawn meanwhile prolongs none.
      falcon_->with([](FalconEmulator& f) { f.buttons = 0; });
      const auto done = [&] { return document().detail() == wanted_detail; };
      return QTest::qWaitFor(done, kPatienceMs);
    });
  }
  /// Down on a place, and up again.
  bool tap(double x_mm, double y_mm) {
    if (!touch(x_mm, y_mm)) return false;
    handTo(x_mm, y_mm, kAboveZ);
    return eventually([this] { return probe() && !probe()->touching; });
  }
  double share(CellStatus origin) {
    return originShares(document().surface()->map)[static_cast<std::size_t>(origin)];
  }

  emulator::MockUsb usb_;
  std::shared_ptr<SharedFalcon> falcon_;
  emulator::StallWatch stalls_;
  DeviceMm aside_;          ///< Of the hand, from where the window alone would have it.
  double depth_ = kAboveZ;  ///< It is held at.
  fs::path log_;            ///< What was recorded.
  TouchRecording recorded_;
  std::size_t measured_ = 0;

 public:  // Named by the test below.
  void startFalcon();
  void dropScan();
  void closeHoles();
  void feelDomeAndHole();
  void feelRidge();
  void feelGrating();
  void readRecording();
  void measureByTouch();
  void seeStereo();
  void seeReplay();
  void makeFigure();
  void openElsewhere();
};

/// U1.1 The Falcon starts by itself and waits for its arms.
void JourneyU1::startFalcon() {
  ASSERT_TRUE(lit(falcon::red));
  falcon_->with([](FalconEmulator& f) { f.body.hold(kFarOut); });
  falcon_->with([](FalconEmulator& f) { f.body.hold(kFarIn); });
  ASSERT_TRUE(lit(falcon::blue)) << "not homed";
  falcon_->with([](FalconEmulator& f) { f.body.hold(kFarOut); });
  window().resize(1280, 800);
}

/// U1.2, U1.3 A file that carries no unit: the strip asks, nothing stands in the way.
void JourneyU1::dropScan() {
  QFile sample(kRelief);
  QFile scan(path("F.ply"));
  ASSERT_TRUE(sample.open(QIODevice::ReadOnly) && scan.open(QIODevice::WriteOnly));
  for (QByteArray line; !line.startsWith("end_header");) {
    line = sample.readLine();
    ASSERT_FALSE(line.isEmpty());
    if (!line.startsWith("comment")) scan.write(line);
  }
  scan.write(sample.readAll());
  scan.close();
  drop(scan.fileName());
  ASSERT_TRUE(settled()) << window().message().toStdString();
  EXPECT_TRUE(window().message().contains("E103")) << window().message().toStdString();
  EXPECT_TRUE(window().message().contains("Most likely millimetres"))
      << window().message().toStdString();
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  picture("1_unit");
  QTest::keyClick(&window().detailView(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(settled());
  EXPECT_EQ(document().surface()->unit_source, UnitSource::given);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  EXPECT_EQ(document().detail(), 1);
  EXPECT_TRUE(reference().sceneState().pink.has_value());
  picture("1_open");
}

/// U1.4, U1.5 The dialog says what was not measured; two holes are closed by interpolation, the
/// largest rests on the base plane.
void JourneyU1::closeHoles() {
  ASSERT_EQ(document().surface()->holes.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const double truth = samples::reliefFHoleAreaMm2(i + 1);
    EXPECT_NEAR(document().surface()->holes[static_cast<std::size_t>(i)].area_mm2, truth,
                i < 2 ? 0.02 * truth : 0.3);
  }
  key(Qt::Key_D, Qt::ControlModifier);
  auto* dialog = shown<DepthMapDialog>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(eventually([&] { return !dialog->isStale(); }));
  EXPECT_TRUE(dialog->summary().contains("1200 \u00d7 800 cells"))
      << dialog->summary().toStdString();
  // Heights as the closed form has them; a height field may be seen from any side.
  auto* view = dialog->findChild<QComboBox*>("depth_view");
  choose(*view, view->findData("top"));
  auto* holes = dialog->findChild<QComboBox*>("depth_holes");
  choose(*holes, holes->findData(static_cast<int>(HoleRule::interpolate)));
  type(*dialog->findChild<QDoubleSpinBox*>("depth_hole_area"), "100");
  ASSERT_TRUE(eventually([&] { return !dialog->isStale(); }));
  picture(*dialog, "1_depth_map");
  QTest::mouseClick(dialog->findChild<QPushButton*>("depth_ok"), Qt::LeftButton);
  ASSERT_TRUE(settled());
  EXPECT_GT(share(CellStatus::interpolated), 0);
  EXPECT_EQ(window().findChild<QLabel*>("surface_holes")->text(),
            "3: 1 on the base plane, 2 interpolated");
  EXPECT_NEAR(share(CellStatus::base_plane), 314.0 / 60'000, 0.03 * 314 / 60'000);
  picture("1_filled");
  ASSERT_TRUE(otherSurfaceBy("undo"));
  EXPECT_EQ(share(CellStatus::interpolated), 0) << "Ctrl+Z brings all holes back";
  ASSERT_TRUE(otherSurfaceBy("redo"));
  EXPECT_GT(share(CellStatus::interpolated), 0);
  falcon_->with([](FalconEmulator& f) {
    for (const auto& command : f.commands()) EXPECT_TRUE(command.neutral()) << "before F5";
  });
}

/// U1.6, U1.7, U1.8 What follows is recorded (U1.11). Forces on, down on the dome, over the hole.
void JourneyU1::feelDomeAndHole() {
  key(Qt::Key_R, Qt::ControlModifier);
  handTo(90, 100, kAboveZ);
  ASSERT_TRUE(proxyNear(90, 100, 2));
  EXPECT_FALSE(probe()->touching);
  ASSERT_TRUE(touch(90, 100)) << "the dome: " << where();
  picture("2_dome");
  handTo(150, 60, kBelowZ);
  ASSERT_TRUE(eventually([this] { return probe() && probe()->origin == CellStatus::base_plane; }));
  EXPECT_TRUE(eventually(
      [this] { return child<QLabel>("status_kind_of_surface")->text().contains("base plane"); }));
  picture("3_hole");
}

/// U1.9 Plus on the ridge: a finer window there, no kick.
void JourneyU1::feelRidge() {
  handTo(60, 30, kBelowZ);
  ASSERT_TRUE(proxyNear(60, 30, 6));
  ASSERT_TRUE(plus(2)) << where();
  QTest::qWait(300);
  picture("4_ridge");
  key(Qt::Key_Escape);  // Forces off, at once.
  ASSERT_TRUE(eventually([this] { return !action("forces")->isChecked(); }));
}

/// U1.10 To the grating on the overview, Plus twice, and once across it.
void JourneyU1::feelGrating() {
  const samples::Square grating = samples::kReliefFGrating;
  auto& overview = reference();
  const Region& region = document().project().region;
  drag(overview, overview.pointOf(region.centreX(), region.centreY()),
       overview.pointOf(grating.x_mm, grating.y_mm));
  handTo(grating.x_mm, grating.y_mm, kAboveZ);
  ASSERT_TRUE(proxyNear(grating.x_mm, grating.y_mm, 5)) << where();
  for (const int detail : {3, 4}) {
    ASSERT_TRUE(plus(detail)) << where();
    handTo(grating.x_mm, grating.y_mm, kAboveZ);
    ASSERT_TRUE(proxyNear(grating.x_mm, grating.y_mm, 2));
  }
  const HandMapping map = handMapping(*document().window());
  EXPECT_NEAR(map.objectMmPerHandMm(), 0.625, 1e-3) << "1 mm of hand is 0.625 mm on the object";
  const double from = grating.x_mm - 0.5 * grating.side_mm - 1;
  ASSERT_TRUE(touch(from, grating.y_mm, kLightZ)) << where();
  ASSERT_TRUE(proxyNear(from, grating.y_mm, 0.5)) << where();  // Before the first ridge.
  picture("5_grating");
  for (double x = from; x < from + grating.side_mm + 2; x += 0.25) {
    handTo(x, grating.y_mm, kLightZ);
    // By the loop's own time: a loop that is late must not skip a ridge.
    const std::uint64_t moved_by = commandCount() + 12;
    ASSERT_TRUE(eventually([&] { return commandCount() >= moved_by; }));
  }
  EXPECT_TRUE(proxyNear(from + grating.side_mm + 2, grating.y_mm, 1));
  key(Qt::Key_Escape);
  ASSERT_TRUE(eventually([this] { return !action("forces")->isChecked(); }));
}

/// How often the proxy climbs over the grating's ridges at the finest detail.
int ridgesFelt(const TouchRecording& recording) {
  const samples::Square grating = samples::kReliefFGrating;
  const double low = samples::kReliefFStepMm + 0.3 * samples::kReliefFGratingAmplitudeMm;
  const double high = samples::kReliefFStepMm + samples::kReliefFGratingAmplitudeMm;
  int ridges = 0;
  bool on_ridge = false;
  for (const TouchRow& row : recording.rows) {
    if (!row.contact || row.detail != 4) continue;
    if (std::abs(row.proxy.x - grating.x_mm) > 0.5 * grating.side_mm) continue;
    // Between the two nothing is counted: a hand that hesitates climbs once.
    if (!on_ridge && row.proxy.z > high) ++ridges;
    if (row.proxy.z > high) on_ridge = true;
    if (row.proxy.z < low) on_ridge = false;
  }
  return ridges;
}

/// U1.11 The recording ends; it knows its map and its windows.
void JourneyU1::readRecording() {
  key(Qt::Key_R, Qt::ControlModifier);
  ASSERT_FALSE(recordings().empty());
  log_ = recordings().back();
  ASSERT_TRUE(hears("Recording saved"));
  fs::copy_file(log_, kept("touch.csv").toStdString(), fs::copy_options::overwrite_existing);
  recorded_ = relievo::readRecording(log_);
  EXPECT_EQ(recorded_.input_sha256, document().fileSha256().toStdString());
  EXPECT_GE(recorded_.windows.size(), 4U);
  const auto known = [&](const TouchRow& row) { return windowOf(recorded_, row) != nullptr; };
  EXPECT_TRUE(std::all_of(recorded_.rows.begin(), recorded_.rows.end(), known));
  EXPECT_TRUE(std::any_of(recorded_.rows.begin(), recorded_.rows.end(), [](const TouchRow& row) {
    return row.contact && row.origin == CellStatus::base_plane;
  })) << "the mask stands in the same row";
  EXPECT_EQ(ridgesFelt(recorded_), 10) << "40 mm of 4 mm waves";
  std::ifstream in(log_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("zero violations 0, limit violations 0"), std::string::npos);
  EXPECT_NE(text.find("# loop ticks "), std::string::npos) << "the real rate is stated";
}

/// U1.12 Two taps, one on each side of the step, and a stroke over it. Where a busy computer stops
/// the forces meanwhile, a person begins again.
void JourneyU1::measureByTouch() {
  const double step = samples::kReliefFStepX;
  const double y = samples::kReliefFGrating.y_mm;
  for (int i = 0; i < 2; ++i) key(Qt::Key_Left, Qt::ControlModifier);
  ASSERT_LT(document().project().region.x_mm, step - 8);
  auto& panel = *window().findChild<MeasurePanel*>();
  // The last measurement's kind and its height, if that is the step's within a cell.
  const auto readsStep = [&](MeasureKind kind, std::size_t quantity) {
    if (panel.measurements().empty() || panel.measurements().back().kind != kind) return false;
    const Quantity height =
        read(document().surface()->map, panel.measurements().back()).quantities[quantity];
    return std::abs(height.value - samples::kReliefFStepMm) <= 0.25;
  };
  const auto tappedStep = [&] {
    key(Qt::Key_M, Qt::ControlModifier | Qt::AltModifier);
    return panel.byTouch() && tap(step - 5, y) && tap(step + 5, y) &&
           readsStep(MeasureKind::depth, 0);
  };
  ASSERT_TRUE(stalls_.repeatAfterStalls(5, tappedStep)) << where();
  EXPECT_LE(read(document().surface()->map, panel.measurements().back()).quantities[0].uncertainty,
            0.25);
  EXPECT_TRUE(said().contains("5.00")) << where();
  const auto drawnOverStep = [&] {
    if (!touch(step + 8, y)) return false;
    for (double x = step + 8; x > step - 8; x -= 0.25) {
      handTo(x, y, kBelowZ);
      QTest::qWait(12);
    }
    if (!proxyNear(step - 8, y, 1)) return false;
    handTo(step - 8, y, kAboveZ);
    return eventually([this] { return probe() && !probe()->touching; }) &&
           QTest::qWaitFor([&] { return readsStep(MeasureKind::profile, 1); }, kPatienceMs);
  };
  EXPECT_TRUE(stalls_.repeatAfterStalls(5, drawnOverStep)) << "height range; " << where();
  picture("6_by_touch");
  for (int i = 0; i < 3 && (panel.byTouch() || action("forces")->isChecked()); ++i) {
    key(Qt::Key_Escape);
  }
  EXPECT_FALSE(panel.byTouch()) << "Escape stops the forces, then the measuring";
  EXPECT_FALSE(action("forces")->isChecked());
  measured_ = panel.measurements().size();
}

/// U1.13 Stereo in half colour; the meter stays in its comfort.
void JourneyU1::seeStereo() {
  key(Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(detail().sceneState().stereo.mode, StereoMode::anaglyph);
  choose(*child<QComboBox>("stereo_kind"), 1);
  EXPECT_EQ(detail().sceneState().stereo.mode, StereoMode::half_colour);
  type(*child<QDoubleSpinBox>("eye_angle"), "3");
  EXPECT_EQ(detail().sceneState().stereo.eye_angle_deg, 3);
  EXPECT_TRUE(child<QWidget>("parallax_meter")->accessibleDescription().contains("of 1"))
      << child<QWidget>("parallax_meter")->accessibleDescription().toStdString();
  picture("7_stereo");
  key(Qt::Key_3, Qt::ControlModifier);
}

/// The recording again, without the Falcon: no command goes to it.
void JourneyU1::seeReplay() {
  ASSERT_TRUE(eventually([this] { return child<QLabel>("status_recording")->text().isEmpty(); }));
  const auto sent = [this] {
    return falcon_->with([](FalconEmulator& f) {
      return std::any_of(
          f.commands().end() - std::min<std::ptrdiff_t>(100, std::ssize(f.commands())),
          f.commands().end(), [](const auto& c) { return !c.neutral(); });
    });
  };
  window().replay(QString::fromStdString(log_.string()));
  ASSERT_TRUE(eventually([this] { return window().controllers().replays.control().showing(); }))
      << window().message().toStdString();
  const auto touch = std::find_if(recorded_.rows.begin(), recorded_.rows.end(),
                                  [](const TouchRow& row) { return norm(row.force) > 0.2; });
  ASSERT_NE(touch, recorded_.rows.end());
  window().controllers().replays.control().player().setTime(touch->t_s - recorded_.startS() + 0.2);
  EXPECT_TRUE(probe()->touching);
  EXPECT_FALSE(sent());
  picture("8_replay");
  window().runCommand("replay_close");
}

/// U1.14 A figure with the force plot, 180 mm at 600 dpi, by the dialog; its plot as vectors, too.
void JourneyU1::makeFigure() {
  for (const char* ending : {".png", ".pdf"}) {
    key(Qt::Key_E, Qt::ControlModifier);
    auto* dialog = shown<FigureDialog>();
    ASSERT_NE(dialog, nullptr);
    choose(*dialog->findChild<QComboBox*>("figure_layout"), static_cast<int>(FigureLayout::plot));
    auto* recording = dialog->findChild<QLineEdit*>("figure_recording");
    recording->setText(QString::fromStdString(log_.string()));
    QTest::keyClick(recording, Qt::Key_Tab);
    type(*dialog->findChild<QDoubleSpinBox*>("figure_width"), "180");
    type(*dialog->findChild<QDoubleSpinBox*>("figure_dpi"), "600");
    auto* caption = dialog->findChild<QPlainTextEdit*>("figure_caption");
    ASSERT_TRUE(eventually([&] { return caption->toPlainText().contains("F.ply"); }));
    const QString file = kept(QLatin1String("9_figure") + QLatin1String(ending));
    QFile::remove(file);
    auto* name = dialog->findChild<QLineEdit*>("figure_file");
    name->setText(file);
    if (file.endsWith(QLatin1String(".png"))) picture(*dialog, "9_dialog");
    auto* save = dialog->findChild<QPushButton*>("figure_save");
    ASSERT_TRUE(eventually([&] { return save->isEnabled(); }));
    QTest::mouseClick(save, Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return !dialog->isVisible() && QFile::exists(file); }));
  }
  const std::string figure = kept("9_figure.png").toStdString();
  EXPECT_EQ(QImage(kept("9_figure.png")).width(), 4252) << "180 mm at 600 dpi";
  ASSERT_TRUE(embeddedState(figure).has_value()) << "all parameters stand in the file";
}

/// U1.15 Saved, and opened again without a Falcon: the same state, the same figure.
void JourneyU1::openElsewhere() {
  window().saveProject(path("work.relievo.json"));
  const Region region = document().project().region;
  detach();
  usb_.unplug();
  restart();
  attach();
  window().open(path("work.relievo.json"));
  ASSERT_TRUE(settled()) << window().message().toStdString();
  EXPECT_EQ(document().project().region, region);
  EXPECT_GT(share(CellStatus::interpolated), 0);
  EXPECT_EQ(window().findChild<MeasurePanel*>()->measurements().size(), measured_);
  const Project project = window().project();
  EXPECT_EQ(project.figure.dpi, 600);
  // As the window does, not on its thread (ui/figure/figure.h).
  std::thread([&] {
    writeFigure(*document().surface(), project, path("again.png").toStdString());
  }).join();
  const QImage first(kept("9_figure.png"));
  ASSERT_FALSE(first.isNull());
  EXPECT_EQ(largestDifference(first, QImage(path("again.png"))), 0) << "the same figure";
  picture("10_elsewhere");
}

TEST_F(JourneyU1, FromThePlugToAProjectThatOpensElsewhere) {
  using Step = void (JourneyU1::*)();
  for (const Step step :
       {&JourneyU1::startFalcon, &JourneyU1::dropScan, &JourneyU1::closeHoles,
        &JourneyU1::feelDomeAndHole, &JourneyU1::feelRidge, &JourneyU1::feelGrating,
        &JourneyU1::readRecording, &JourneyU1::measureByTouch, &JourneyU1::seeStereo,
        &JourneyU1::seeReplay, &JourneyU1::makeFigure, &JourneyU1::openElsewhere}) {
    (this->*step)();
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace relievo
