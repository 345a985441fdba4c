// SPDX-License-Identifier: BSD-3-Clause
// Journey U1: a researcher with a Falcon opens a relief, closes gaps, feels dome, hole and ridge,
// records, replays, makes a figure, and opens the work again without the Falcon. The Falcon is
// emulated behind the real libusb; pictures are kept in screenshots/ of the build folder.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QImage>
#include <QLabel>
#include <QSettings>
#include <QtTest/QTest>

#include "app/batch/recording.h"
#include "app/host.h"
#include "app/plugin_loader.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/protocol.h"
#include "tests/emulator/made_image.h"
#include "tests/emulator/mock_usb.h"
#include "tests/ui/gui_fixture.h"
#include "ui/figure/figure.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using emulator::FalconEmulator;
using emulator::SharedFalcon;
using emulator::Triple;

constexpr Triple kFarOut{0, 0, 172}, kFarIn{0, 0, 90};
constexpr double kAboveZ = 150, kBelowZ = 108;  // Of the grip, over and under the relief.
const QString kRelief = QStringLiteral(RELIEVO_SOURCE_DIR "/data/samples/relief_f.ply");

/// Of 255. A window made anew in one process can draw the edges of letters a little differently;
/// programs of their own give the same pixels (journey_test, figure_test).
constexpr int kTextEdge = 6;

/// Of any channel of any pixel; 255 where the sizes differ.
int largestDifference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 255;
  int largest = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      largest = std::max({largest, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                          std::abs(qBlue(p) - qBlue(q))});
    }
  }
  return largest;
}

class JourneyU1 : public GuiTest {
 protected:
  void SetUp() override {
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    qputenv("HOME", path("home").toUtf8());
    qputenv("XDG_DATA_HOME", path("data").toUtf8());
    QDir().mkpath(path("home/Documents"));
    const fs::path image = path("image.bin").toStdString();
    const std::vector<std::uint8_t> bytes = test::madeImage();
    std::ofstream(image, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    falcon::installFirmware(falcon::readFirmware(image), falcon::firmwarePlaces());
    window().settings().setChoice(QStringLiteral("plugins/haptics_plugin"),
                                  QByteArray(R"({"device": "falcon:0"})").toBase64());
    falcon_ = std::make_shared<SharedFalcon>(emulator::EmulatorOptions{});
    usb_.plugIn(falcon_);
    attach();
  }
  void TearDown() override {
    if (plugins_) plugins_->detachAll();
    plugins_.reset();
    host_.reset();
  }
  void attach() {
    window().setRecordingReader(batch::readRecording);
    host_ = std::make_unique<WindowHost>(window());
    plugins_ = std::make_unique<PluginLoader>(*host_, window().settings());
    plugins_->load();
    ASSERT_TRUE(plugins_->has("haptics")) << plugins_->problems().join(' ').toStdString();
  }
  static bool eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, 60'000);
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
    falcon_->with([&](FalconEmulator& f) { f.body.pullToward({at.x, at.y, z}); });
  }
  /// Forces on over a place, then down on it. A busy computer may stop the forces for safety; then
  /// a person lifts the hand and begins again.
  bool touch(double x_mm, double y_mm) {
    const auto pushed = [this] {
      return falcon_->with([](FalconEmulator& f) { return f.body.force()[2] > 0.2; }) &&
             probe()->touching && probe()->hip.z < probe()->proxy.z;
    };
    for (int attempt = 0; attempt < 5; ++attempt) {
      handTo(x_mm, y_mm, kAboveZ);
      if (!proxyNear(x_mm, y_mm, 3)) continue;
      if (!action("forces")->isChecked()) QTest::keyClick(&window().detailView(), Qt::Key_F5);
      if (!QTest::qWaitFor([this] { return probe() && probe()->forces_on; }, 5000)) continue;
      handTo(x_mm, y_mm, kBelowZ);
      if (QTest::qWaitFor(pushed, 8000)) return true;
    }
    return false;
  }
  const std::optional<Probe>& probe() { return window().detailView().sceneState().probe; }
  bool proxyNear(double x_mm, double y_mm, double within_mm) {
    return eventually([&] {
      return probe() && std::hypot(probe()->proxy.x - x_mm, probe()->proxy.y - y_mm) < within_mm;
    });
  }
  void open() {
    OpenRequest request;
    request.file = kRelief;
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    window().open(request);
    ASSERT_TRUE(eventually([this] { return document().isOpen() && !document().busy(); }))
        << window().message().toStdString();
  }
  void picture(const char* name) {
    QTest::qWait(300);  // For whoever looks at it.
    QDir().mkpath(RELIEVO_BINARY_DIR "/screenshots");
    window().grab().save(QStringLiteral(RELIEVO_BINARY_DIR "/screenshots/u1_%1.png").arg(name));
  }
  fs::path newestRecording() {
    fs::path newest;
    std::error_code error;
    for (const auto& entry :
         fs::directory_iterator(path("home/Documents/relievo").toStdString(), error)) {
      if (newest < entry.path()) newest = entry.path();
    }
    return newest;
  }
  static std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  emulator::MockUsb usb_;
  std::shared_ptr<SharedFalcon> falcon_;
  std::unique_ptr<WindowHost> host_;
  std::unique_ptr<PluginLoader> plugins_;
};

TEST_F(JourneyU1, FromThePlugToAProjectThatOpensElsewhere) {
  // U1.1 The Falcon starts by itself and waits for its arms; nothing pulls before U1.6.
  ASSERT_TRUE(lit(falcon::red));
  falcon_->with([](FalconEmulator& f) { f.body.hold(kFarOut); });
  falcon_->with([](FalconEmulator& f) { f.body.hold(kFarIn); });
  ASSERT_TRUE(lit(falcon::blue)) << "not homed";
  falcon_->with([](FalconEmulator& f) { f.body.hold(kFarOut); });

  // U1.2, U1.3 The relief lies open, the pink window is all of it.
  window().resize(1280, 800);
  open();
  EXPECT_EQ(document().detail(), 1);
  EXPECT_TRUE(window().referenceView().sceneState().pink.has_value());
  picture("1_open");

  // U1.4, U1.5 Three holes; two are closed by interpolation, the largest rests on the base plane.
  ASSERT_EQ(document().surface()->holes.size(), 3U);
  EXPECT_NEAR(document().surface()->holes[0].area_mm2, 314, 0.02 * 314);
  EXPECT_NEAR(document().surface()->holes[1].area_mm2, 36, 0.02 * 36);
  SurfaceOptions options = document().state().options;
  options.holes = {HoleRule::interpolate, 100};
  document().remake(options, "Holes");
  ASSERT_TRUE(eventually([this] { return !document().busy(); }));
  const auto share = [this](Origin origin) {
    return originShares(document().surface()->map)[static_cast<std::size_t>(origin)];
  };
  EXPECT_GT(share(Origin::interpolated), 0);
  EXPECT_EQ(window().findChild<QLabel*>("surface_holes")->text(),
            "3: 1 on the base plane, 2 interpolated");
  EXPECT_NEAR(share(Origin::base_plane), 314.0 / 60'000, 0.03 * 314 / 60'000);
  window().runCommand("undo");
  EXPECT_EQ(share(Origin::interpolated), 0) << "Ctrl+Z brings all holes back";
  window().runCommand("redo");
  EXPECT_GT(share(Origin::interpolated), 0);
  falcon_->with([](FalconEmulator& f) {
    for (const auto& command : f.commands()) EXPECT_TRUE(command.neutral()) << "before F5";
  });

  // U1.11 What follows is recorded. U1.6, U1.7 Forces on, down on the dome.
  QTest::keyClick(&window().detailView(), Qt::Key_R, Qt::ControlModifier);
  handTo(90, 100, kAboveZ);
  ASSERT_TRUE(proxyNear(90, 100, 2));
  EXPECT_FALSE(probe()->touching);
  ASSERT_TRUE(touch(90, 100)) << "the dome: "
                              << child<QLabel>("status_message")->text().toStdString();
  picture("2_dome");

  // U1.8 Over the hole that rests on the base plane, the status bar says so.
  handTo(150, 60, kBelowZ);
  ASSERT_TRUE(eventually([this] { return probe() && probe()->origin == Origin::base_plane; }));
  EXPECT_TRUE(eventually(
      [this] { return child<QLabel>("status_kind_of_surface")->text().contains("base plane"); }));
  picture("3_hole");

  // U1.9 Plus on the ridge: a finer window there, no kick.
  handTo(60, 30, kBelowZ);
  ASSERT_TRUE(proxyNear(60, 30, 6));
  falcon_->with([](FalconEmulator& f) { f.buttons = 1; });
  QTest::qWait(150);
  falcon_->with([](FalconEmulator& f) { f.buttons = 0; });
  ASSERT_TRUE(eventually([this] { return document().detail() == 2; }));
  QTest::qWait(300);
  picture("4_ridge");
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);  // Forces off, at once.
  ASSERT_TRUE(eventually([this] { return !action("forces")->isChecked(); }));

  // U1.11 The recording ends; it knows its map and both windows.
  QTest::keyClick(&window().detailView(), Qt::Key_R, Qt::ControlModifier);
  const fs::path log = newestRecording();
  ASSERT_TRUE(eventually([this] {
    return child<QLabel>("status_message")->text().contains("Recording saved");
  })) << child<QLabel>("status_message")->text().toStdString();
  fs::copy_file(log, RELIEVO_BINARY_DIR "/screenshots/u1_touch.csv",
                fs::copy_options::overwrite_existing);
  const TouchRecording recording = batch::readRecording(log);
  EXPECT_EQ(recording.input_sha256, document().fileSha256().toStdString());
  ASSERT_GE(recording.windows.size(), 2U);
  const auto known = [&](const TouchRow& row) { return windowOf(recording, row) != nullptr; };
  EXPECT_TRUE(std::all_of(recording.rows.begin(), recording.rows.end(), known));
  EXPECT_TRUE(std::any_of(recording.rows.begin(), recording.rows.end(), [](const TouchRow& row) {
    return row.contact && row.origin == Origin::base_plane;
  })) << "the mask stands in the same row";
  EXPECT_NE(bytesOf(log).find("zero violations 0, limit violations 0"), std::string::npos);

  // U1.13 Stereo. The recording again, without the Falcon: no command goes to it.
  QTest::keyClick(&window().detailView(), Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(window().detailView().sceneState().stereo.mode, StereoMode::anaglyph);
  picture("5_stereo");
  QTest::keyClick(&window().detailView(), Qt::Key_3, Qt::ControlModifier);
  ASSERT_TRUE(eventually([this] { return child<QLabel>("status_recording")->text().isEmpty(); }));
  window().replay(QString::fromStdString(log.string()));
  ASSERT_TRUE(eventually([this] { return window().replayControl().showing(); }))
      << window().message().toStdString();
  const auto touch = std::find_if(recording.rows.begin(), recording.rows.end(),
                                  [](const TouchRow& row) { return norm(row.force) > 0.2; });
  ASSERT_NE(touch, recording.rows.end());
  window().replayControl().player().setTime(touch->t_s - recording.startS() + 0.2);
  EXPECT_TRUE(probe()->touching);
  picture("6_replay");
  window().runCommand("replay_close");

  // U1.14 A figure with the force plot, 180 mm wide.
  Project project = window().project();
  project.figure.layout = FigureLayout::plot;
  project.figure.recording = log.string();
  project.figure.dpi = 150;
  const FigureFacts facts = writeFigure(*document().surface(), project,
                                        RELIEVO_BINARY_DIR "/screenshots/u1_7_figure.png");
  EXPECT_EQ(facts.width_px, 1063) << "180 mm at 150 dpi";

  // U1.15 Saved, and opened again without a Falcon: the same state, the same figure.
  window().saveProject(path("work.relievo.json"));
  const Region region = document().state().region;
  plugins_->detachAll();
  plugins_.reset();
  host_.reset();
  usb_.unplug();
  restart();
  window().open(path("work.relievo.json"));
  ASSERT_TRUE(eventually([this] { return document().isOpen() && !document().busy(); }))
      << window().message().toStdString();
  EXPECT_EQ(document().state().region, region);
  EXPECT_GT(share(Origin::interpolated), 0);
  project.file = window().project().file;
  writeFigure(*document().surface(), project, path("again.png").toStdString());
  const QImage first(RELIEVO_BINARY_DIR "/screenshots/u1_7_figure.png");
  ASSERT_FALSE(first.isNull());
  EXPECT_LE(largestDifference(first, QImage(path("again.png"))), kTextEdge) << "the same figure";
}

}  // namespace
}  // namespace relievo
