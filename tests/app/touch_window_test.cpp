// SPDX-License-Identifier: BSD-3-Clause
// The whole of it: window, host, loader and the haptics plugin that was built beside them.
#include <array>
#include <cmath>
#include <cstring>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QScrollBar>
#include <QtTest/QTest>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "core/region/hand.h"
#include "tests/ui/gui_fixture.h"
#include "ui/frame/side_panels.h"
#include "ui/panels/replay_panel.h"
#include "ui/views/reference_view.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

/// What the program does at its start.
class LoadedPlugins {
 public:
  explicit LoadedPlugins(MainWindow& window) : host_(window), loader_(host_, window.settings()) {
    loader_.load();
  }
  PluginLoader* operator->() { return &loader_; }

 private:
  WindowHost host_;
  PluginLoader loader_;
};

class TouchWindowTest : public GuiTest {
 protected:
  void TearDown() override { qunsetenv("RELIEVO_PLUGIN_PATH"); }
  double forceShown() {
    const QString text = child<QLabel>("status_force")->text();
    return text.endsWith("N") ? text.section('/', 0, 0).toDouble() : 0;
  }
  /// What the program prints; it must end so.
  static QByteArray said(const QStringList& words, int exit_code = 0) {
    QProcess program;
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(QStringLiteral(RELIEVO_BINARY_DIR "/bin/relievo"), words);
    EXPECT_TRUE(program.waitForFinished(60'000));
    QByteArray out = program.readAllStandardOutput();
    EXPECT_EQ(program.exitCode(), exit_code) << out.toStdString();
    return out;
  }
  void useOwnHome() {
    qputenv("HOME", path("home").toLocal8Bit());
    qputenv("XDG_CONFIG_HOME", path("home/config").toLocal8Bit());
  }
  /// The mouse presses on the middle of the detail view, with forces on.
  void touchMiddle() {
    auto& view = window().detailView();
    const QPointF middle = QRectF(view.rect()).center();
    move(view, middle);
    QTest::keyClick(&view, Qt::Key_F5);
    ASSERT_TRUE(
        waitFor([&] { return view.sceneState().probe && view.sceneState().probe->forces_on; }));
    press(view, middle);
    ASSERT_TRUE(waitFor([this] { return forceShown() > 0.1; }));
  }
  /// The relief with a hole of 24 mm across beside its middle.
  void openHoledRelief() {
    QFile whole(writeRelief());
    ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
    const QByteArray bytes = whole.readAll();
    constexpr int kPoint = 3 * sizeof(float);
    QByteArray points;
    for (int at = bytes.indexOf("end_header\n") + 11; at < bytes.size(); at += kPoint) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), bytes.constData() + at, kPoint);
      if (std::hypot(p[0] - 140, p[1] - 100) > 12) points.append(bytes.constData() + at, kPoint);
    }
    QFile holed(path("holed.ply"));
    ASSERT_TRUE(holed.open(QIODevice::WriteOnly));
    holed.write("ply\nformat binary_little_endian 1.0\nelement vertex " +
                QByteArray::number(points.size() / kPoint) +
                "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + points);
    holed.close();
    OpenRequest request;
    request.file = holed.fileName();
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    window().open(request);
    ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
    ASSERT_EQ(document().surface()->holes.size(), 1U);
  }
  /// A plate of 250 x 200 mm with a wall across its middle, 40 mm high and 8 mm thick.
  void openWalledRelief() {
    QFile plate(writeRelief());
    ASSERT_TRUE(plate.open(QIODevice::ReadOnly));
    QByteArray bytes = plate.readAll();
    constexpr int kPoint = 3 * sizeof(float);
    for (int at = bytes.indexOf("end_header\n") + 11; at < bytes.size(); at += kPoint) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), bytes.constData() + at, kPoint);
      p[2] = std::abs(p[0] - 125) < 4 ? 40 : 0;
      std::memcpy(bytes.data() + at, p.data(), kPoint);
    }
    QFile walled(path("walled.ply"));
    ASSERT_TRUE(walled.open(QIODevice::WriteOnly));
    walled.write(bytes);
    walled.close();
    OpenRequest request;
    request.file = walled.fileName();
    request.unit = LengthUnit::mm;
    request.view = ViewChoice{"top", {}};
    window().open(request);
    ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  }
  /// Until the force loop feels what the window shows; then a moment goes by, so that a recording
  /// has many rows of it. A slow computer gives it fewer.
  void feelAWhile() {
    const auto& probe = window().detailView().sceneState().probe;
    ASSERT_TRUE(waitFor([&] { return probe && probe->window_id == document().window()->id; }));
    QTest::qWait(300);
  }
  /// Ends the recording that runs. @return its file; empty: none came
  QString endRecording() {
    action("record")->trigger();
    const QDir folder(path("home/Documents/relievo"));
    QStringList files;
    const bool ended = waitFor([&] {
      files = folder.entryList({"*.csv", "*.h5"}, QDir::Files, QDir::Time);
      QFile file(folder.filePath(files.value(0)));
      return file.open(QIODevice::ReadOnly) && file.readAll().contains("replay core ");
    });
    return ended ? folder.filePath(files.front()) : QString();
  }
  QString writeGrid(const QString& name, const QByteArray& values) {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("ncols 5\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\n" + values);
    return file.fileName();
  }
};

TEST_F(TouchWindowTest, AModuleThatIsNoPluginIsSkippedAndNamed) {
  QFile module(path("broken.so"));
  ASSERT_TRUE(module.open(QIODevice::WriteOnly));
  module.write("this is text");
  module.close();
  qputenv("RELIEVO_PLUGIN_PATH", path("").toLocal8Bit());
  LoadedPlugins plugins(window());
  ASSERT_EQ(plugins->problems().size(), 1);
  EXPECT_TRUE(plugins->problems().front().contains("broken.so"));
  EXPECT_FALSE(plugins->has("broken"));
}

TEST_F(TouchWindowTest, WhatEverybodyNeedsFitsBesideAWindowOf900Pixels) {
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin")) << plugins->problems().join(' ').toStdString();
  window().resize(1440, 900);
  openRelief();
  QApplication::processEvents();
  auto& panels = *child<SidePanels>("side_panels");
  EXPECT_EQ(panels.titles().mid(4, 3), QStringList({"Measure", "Touch", "Touch: advanced"}));
  EXPECT_TRUE(child<QWidget>("strengthSlider")->isVisible());
  EXPECT_FALSE(child<QWidget>("stiffness")->isVisible());
  EXPECT_EQ(panels.verticalScrollBar()->maximum(), 0)
      << panels.widget()->sizeHint().height() << " of " << panels.viewport()->height();
}

TEST_F(TouchWindowTest, ADialogThatTakesTheReleaseEndsThePressAndTheForce) {
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin")) << plugins->problems().join(' ').toStdString();
  openRelief();
  touchMiddle();
  QDialog dialog(&window());
  dialog.open();
  ASSERT_TRUE(waitFor([this] {
    const auto& probe = window().detailView().sceneState().probe;
    return probe && !probe->touching && norm(probe->force) == 0;
  }));
  EXPECT_TRUE(action("forces")->isChecked()) << "they are on for the next press";
}

TEST_F(TouchWindowTest, PressingWithTheMouseIsAnsweredByAForceThatEscapeStops) {
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin")) << plugins->problems().join(' ').toStdString();
  openRelief();
  auto& view = window().detailView();
  const QPointF middle = QRectF(view.rect()).center();
  move(view, middle);
  QTest::keyClick(&view, Qt::Key_F5);
  // Forces begin only while the hand is clear of the surface.
  ASSERT_TRUE(
      waitFor([&] { return view.sceneState().probe && view.sceneState().probe->forces_on; }));
  EXPECT_TRUE(action("forces")->isChecked());
  press(view, middle);
  EXPECT_TRUE(waitFor([this] { return forceShown() > 0.1; })) << "no force";
  EXPECT_TRUE(waitFor([&] {
    const auto& probe = view.sceneState().probe;
    return probe && probe->touching && probe->hip.z < probe->proxy.z;
  })) << "the hand must be drawn below the proxy";
  EXPECT_TRUE(child<QWidget>("time_plot")->isVisible());
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_TRUE(waitFor([this] { return !action("forces")->isChecked(); }));
  EXPECT_TRUE(waitFor([this] { return forceShown() == 0; }));
  release(view, middle);
  plugins->detachAll();
}

TEST_F(TouchWindowTest, APictureOfTheDetailViewIsDrawnAgainFromTheCommandLine) {
  useOwnHome();
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  openRelief();
  const auto saved = [this](ImageSource source, const QString& name) {
    window().saveImage(source, {301, 200}, path(name));
    EXPECT_TRUE(waitFor([&] { return !window().savingImage(); }));
    return path(name);
  };
  const QString bare = saved(ImageSource::detail, "bare.png");
  document().region().setRect({40, 40, 60, 60});
  window().runCommand("relief_slope");
  window().detailView().turnBy(20, 10);
  touchMiddle();  // The hand is in the picture, too.
  window().detailView().setLines({{{50, 50, 3}, {80, 90, 3}}});
  const QString full = saved(ImageSource::detail, "full.png");
  const QString whole = saved(ImageSource::window, "whole.png");
  auto& view = window().detailView();
  release(view, QRectF(view.rect()).center());
  plugins->detachAll();
  for (const QString& picture : {bare, full}) {
    said({"render", "--from-image", picture, "-o", path("again.png")});
    EXPECT_EQ(QImage(path("again.png")), QImage(picture)) << picture.toStdString();
    EXPECT_EQ(QImage(picture).size(), QSize(301, 200));
  }
  EXPECT_NE(QImage(bare), QImage(full));
  EXPECT_TRUE(said({"render", "--from-image", whole, "-o", path("no.png")}, 1)
                  .contains("picture of the whole window, which only the window can draw"));
  EXPECT_FALSE(QFileInfo::exists(path("no.png")));
}

TEST_F(TouchWindowTest, PushesOfTheViewAreOneStepAndNoneWithinAGesture) {
  openRelief();
  WindowHost host(window());
  document().region().setRect({40, 40, 60, 60});
  const Region before = document().project().region;
  for (int i = 0; i < 10; ++i) host.pushView({.right = 0.01, .up = -0.02});
  const Region moved = document().project().region;
  EXPECT_NEAR(moved.x_mm, before.x_mm - 0.1 * before.side_mm, 1e-9) << "the relief goes right";
  EXPECT_NEAR(moved.y_mm, before.y_mm + 0.2 * before.side_mm, 1e-9);
  EXPECT_EQ(moved.level, before.level);
  host.pushView({.nearer = 1.5});
  EXPECT_NEAR(document().project().region.side_mm, before.side_mm / 1.5, 1e-9);
  document().history().undo();
  EXPECT_EQ(document().project().region, before);
  // A cap that is pushed is turned, too.
  const int before_all = document().history().count();
  for (int i = 0; i < 10; ++i) {
    host.turnView(1, 0.5, 0);
    host.pushView({.right = 0.01});
  }
  EXPECT_NEAR(document().project().azimuth_deg, 10, 1e-9);
  EXPECT_LE(document().history().count(), before_all + 1);
  document().history().undo();
  EXPECT_EQ(document().project().azimuth_deg, 0);
  EXPECT_EQ(document().project().region, before);
  document().region().preview(moved);
  host.pushView({.right = 0.1});
  EXPECT_EQ(document().project().region, moved) << "the mouse moves it";
  document().region().revert();
  const int steps = document().history().count();
  host.pushView({});
  EXPECT_EQ(document().history().count(), steps) << "at rest";
}

TEST_F(TouchWindowTest, ARecordingWithLiveChangesIsReplayedToTheLastBit) {
  useOwnHome();
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  openRelief();
  auto& view = window().detailView();
  const QPointF middle = QRectF(view.rect()).center();
  touchMiddle();
  // It begins while the hand touches; then window, level and feel change.
  action("record")->trigger();
  feelAWhile();
  ASSERT_TRUE(window().runCommand("finer"));
  feelAWhile();
  child<QComboBox>("surfacePreset")->setCurrentIndex(1);  // Another shape, too.
  move(view, middle + QPointF(30, 10));
  feelAWhile();
  window().runCommand("coarser");
  feelAWhile();
  const QString recording = endRecording();  // Knows where its scan lies.
  release(view, middle);
  plugins->detachAll();
  ASSERT_FALSE(recording.isEmpty());
  EXPECT_TRUE(said({"replay", recording, "--verify"}).contains("to the last bit"));
  // Packed for citation it is found and repeated as well.
  said({"project", "new", recording, "-o", path("p.json"), "--recording", recording});
  said({"project", "package", path("p.json"), "-o", path("p.zip")});
  EXPECT_TRUE(said({"replay", path("p.zip"), "--verify"}).contains("to the last bit"));
  // As if another build had recorded it.
  QFile file(recording);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  QByteArray text = file.readAll();
  const int core = text.indexOf("# replay core ");
  ASSERT_GT(core, 0);
  const int build = core + static_cast<int>(qstrlen("# replay core "));
  text.replace(build, text.indexOf(' ', build) - build, "0123abcd");
  file.seek(0);
  file.write(text);
  file.resize(text.size());
  file.close();
  const QString other = said({"replay", recording, "--verify"}, 5);
  EXPECT_TRUE(other.contains("ticks replayed, all the same to the last bit"))
      << other.toStdString();
  EXPECT_TRUE(other.contains("It was changed: ")) << "by its checksums";
  EXPECT_TRUE(other.contains(", build 0123abcd; this is version ")) << other.toStdString();
}

/// The recording is called after the scan, whose name is no UTF-8 and has two lines.
TEST_F(TouchWindowTest, ARecordingOfAScanOfAnyNameIsKeptAndReplayedToTheLastBit) {
  useOwnHome();
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  const std::string stem = "b\xFCste\n\"2\"";
  const QString scan = path(pathFromBytes(stem + ".ply"));
  ASSERT_TRUE(QFile::rename(writeRelief(), scan));
  OpenRequest request;
  request.file = scan;
  request.unit = LengthUnit::mm;
  request.view = ViewChoice{"top", {}};
  window().open(request);
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  for (const char* kind : {"record_csv", "record_h5"}) {
    ASSERT_TRUE(window().runCommand(kind)) << kind;
    touchMiddle();
    action("record")->trigger();
    feelAWhile();
    const QString recording = endRecording();
    release(window().detailView(), QRectF(window().detailView().rect()).center());
    QTest::keyClick(&window().detailView(), Qt::Key_F5);
    ASSERT_FALSE(recording.isEmpty());
    EXPECT_TRUE(QFile::encodeName(QFileInfo(recording).fileName()).startsWith(stem.c_str()))
        << recording.toStdString();
    EXPECT_TRUE(said({"replay", recording, "--verify"}).contains("to the last bit"));
    EXPECT_TRUE(waitFor([&] {
      const auto known = window().project().recordings;
      return !known.empty() && known.back().file == bytesOfPath(recording);
    }));
  }
  plugins->detachAll();
}

TEST_F(TouchWindowTest, AnHdf5RecordingIsNotedPackedReplayedHereAndToTheLastBit) {
  useOwnHome();
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  openRelief();
  auto& view = window().detailView();
  touchMiddle();
  action("record_h5")->trigger();
  action("record")->trigger();
  feelAWhile();
  ASSERT_TRUE(window().runCommand("addNote"));
  auto* text = child<QLineEdit>("note_text");
  ASSERT_NE(text, nullptr);
  QTest::keyClicks(text, "the dome");
  QTest::keyClick(text, Qt::Key_Return);
  ASSERT_TRUE(window().runCommand("finer"));
  feelAWhile();
  const QString recording = endRecording();
  release(view, QRectF(view.rect()).center());
  ASSERT_TRUE(recording.endsWith(".h5")) << recording.toStdString();
  EXPECT_TRUE(QFileInfo(recording).fileName().startsWith("relief_"));
  ASSERT_TRUE(waitFor([this] { return window().project().recordings.size() == 1; }));
  QTest::keyClick(&view, Qt::Key_Escape);  // Forces off.
  window().open(recording);                // As if it were dropped.
  ASSERT_TRUE(waitFor([this] { return window().controllers().replays.control().showing(); }))
      << window().message().toStdString();
  QTest::keyClick(window().controllers().replays.control().panel(), Qt::Key_Down);
  EXPECT_TRUE(child<QLabel>("replay_readout")->text().endsWith("note: the dome"))
      << child<QLabel>("replay_readout")->text().toStdString();
  plugins->detachAll();
  EXPECT_TRUE(said({"replay", recording, "--verify"}).contains("to the last bit"));
  window().saveProject(path("p.relievo.json"));
  said({"project", "package", path("p.relievo.json"), "-o", path("p.zip")});
  EXPECT_TRUE(said({"replay", path("p.zip"), "--verify"}).contains("to the last bit"));
}

TEST_F(TouchWindowTest, ARecordingAcrossOtherMapsOfTheScanIsReplayedToTheLastBit) {
  useOwnHome();
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  openHoledRelief();
  touchMiddle();
  action("record")->trigger();
  feelAWhile();
  const auto remade = [this](const std::function<void(SurfaceOptions&)>& change) {
    SurfaceOptions options = document().project().options;
    change(options);
    const auto before = document().surface();
    document().remake(options, "Change");
    ASSERT_TRUE(
        waitFor([&] { return document().surface() != before && !document().loader().busy(); }));
    feelAWhile();
  };
  // Fill, rotation, and back to the scan's other side.
  remade([](SurfaceOptions& o) { o.holes = {HoleRule::membrane, 1e6}; });
  ASSERT_TRUE(window().runCommand("finer"));
  feelAWhile();
  remade([](SurfaceOptions& o) { o.view = ViewChoice{.name = "bottom", .rotation = {}}; });
  remade([](SurfaceOptions& o) { o.cells = 300; });
  const QString recording = endRecording();
  auto& view = window().detailView();
  release(view, QRectF(view.rect()).center());
  plugins->detachAll();
  ASSERT_FALSE(recording.isEmpty());
  QFile file(recording);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll().count("# replay map "), 4);
  EXPECT_TRUE(said({"replay", recording, "--verify"}).contains("to the last bit"));
  // Another place is known by the checksum.
  ASSERT_TRUE(QDir().mkpath(path("moved")));
  ASSERT_TRUE(QFile::rename(path("holed.ply"), path("moved/scan.ply")));
  EXPECT_TRUE(said({"replay", recording, "--verify", "--input", path("moved/scan.ply")})
                  .contains("to the last bit"));
}

TEST_F(TouchWindowTest, ARecordingWithARasterOfFirmGroundIsReplayedUnlessTheRasterHasChanged) {
  useOwnHome();
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  openRelief();
  auto* name = child<QLabel>("firmnessName");
  const auto choose = [this](const QString& file) {
    child<QPushButton>("firmnessChoose")->click();
    auto* dialog = child<QFileDialog>("firmness_dialog");
    ASSERT_NE(dialog, nullptr);
    Q_EMIT dialog->fileSelected(file);
    delete dialog;
  };
  const auto status = [this](const QString& text) {
    return waitFor([&] { return child<QLabel>("status_message")->text().contains(text); });
  };
  // 250 x 200 mm: 5 x 4 cells. What cannot be used is said, and nothing changes.
  choose(path("relief.ply"));
  EXPECT_TRUE(status("relief.ply"));
  EXPECT_EQ(name->text(), "where it was measured");
  choose(writeGrid("two.asc", "2 2 2 2 2 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n"));
  EXPECT_TRUE(status("outside 0 to 1, such as 2"));
  QFile square(path("square.asc"));
  ASSERT_TRUE(square.open(QIODevice::WriteOnly));
  square.write("ncols 9\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 1\n" +
               QByteArray("1 ").repeated(45) + "\n");
  square.close();
  choose(square.fileName());
  EXPECT_TRUE(status("'square.asc' has 9 x 5 cells, but the map is"));
  EXPECT_EQ(name->text(), "where it was measured");
  touchMiddle();
  action("record")->trigger();
  feelAWhile();
  const QString firm =
      writeGrid("firm ground.asc", "1 0 1 0 1 0.5 1 0 1 0 1 0 0.2 0 1 0 1 0 1 0\n");
  choose(firm);
  ASSERT_TRUE(waitFor([&] { return name->text() == "firm ground.asc"; }));
  feelAWhile();
  ASSERT_TRUE(window().runCommand("finer"));
  feelAWhile();
  const QString recording = endRecording();
  auto& view = window().detailView();
  release(view, QRectF(view.rect()).center());
  plugins->detachAll();
  ASSERT_FALSE(recording.isEmpty());
  EXPECT_TRUE(said({"replay", recording, "--verify"}).contains("to the last bit"));
  said({"project", "new", recording, "-o", path("p.json"), "--recording", recording});
  said({"project", "package", path("p.json"), "-o", path("p.zip")});
  writeGrid("firm ground.asc", "1 0 1 0 1 0.5 1 0 1 0 1 0 0.3 0 1 0 1 0 1 0\n");
  EXPECT_TRUE(said({"replay", recording, "--verify"}, 5)
                  .contains("'firm ground.asc' is not the stiffness map that was felt"));
  ASSERT_TRUE(QFile::remove(firm));
  EXPECT_TRUE(said({"replay", recording, "--verify"}, 2).contains("is not there (E501)"));
  EXPECT_TRUE(said({"replay", path("p.zip"), "--verify"}).contains("to the last bit"))
      << "the package holds the raster that was felt";
}

TEST_F(TouchWindowTest, APointerThatIsNotPressedIsCarriedOverWallsAndItsRecordingRepeats) {
  useOwnHome();
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  openWalledRelief();
  auto& view = window().detailView();
  const QPointF middle = QRectF(view.rect()).center();
  const QPointF aside(0.3 * view.height(), 0);
  move(view, middle - aside);
  QTest::keyClick(&view, Qt::Key_F5);
  const auto& probe = view.sceneState().probe;
  ASSERT_TRUE(waitFor([&] { return probe && probe->forces_on; }));
  action("record")->trigger();
  double most_apart_mm = 0, most_n = 0;
  for (int i = 0; i < 60; ++i) {
    move(view, i % 2 == 0 ? middle + aside : middle - aside);
    QTest::qWait(16);
    most_apart_mm = std::max(most_apart_mm, norm(probe->proxy - probe->hip));
    most_n = std::max(most_n, norm(probe->force));
  }
  EXPECT_EQ(most_apart_mm, 0);
  EXPECT_EQ(most_n, 0);
  for (const QLabel* label : window().findChildren<QLabel*>()) {
    EXPECT_FALSE(label->text().contains("oftened to")) << label->text().toStdString();
  }
  // It touches where it is pressed, and then a wall holds it.
  press(view, middle + aside);
  ASSERT_TRUE(waitFor([this] { return forceShown() > 0.1; }));
  const double pressed_x = probe->proxy.x;
  move(view, middle - aside, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return probe->hip.x < 90; }));
  EXPECT_GT(pressed_x, 150);
  EXPECT_GT(probe->proxy.x, 120);
  const QString recording = endRecording();
  release(view, middle);
  plugins->detachAll();
  ASSERT_FALSE(recording.isEmpty());
  EXPECT_TRUE(said({"replay", recording, "--verify"}).contains("to the last bit"));
}

TEST_F(TouchWindowTest, AWindowDrawnByKeysKeepsTheHandOverIt) {
  LoadedPlugins plugins(window());
  ASSERT_TRUE(plugins->has("haptics_plugin"));
  openWalledRelief();
  auto& view = window().detailView();
  auto& overview = window().referenceView();
  const auto& probe = view.sceneState().probe;
  move(view, QPointF(4, 4));  // A corner, which will not be in the window.
  overview.setFocus();
  QTest::keyClick(&overview, Qt::Key_Space);
  for (const int key : {Qt::Key_Right, Qt::Key_Down, Qt::Key_Right, Qt::Key_Down, Qt::Key_Right}) {
    QTest::keyClick(&overview, static_cast<Qt::Key>(key));
    QTest::qWait(30);
  }
  QTest::keyClick(&overview, Qt::Key_Return);
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_Left);  // The keys take the hand.
  const auto is_over = [&] {
    const auto shown = document().window();
    if (!probe || probe->window_id != shown->id || probe->touching) return false;
    const Region& r = shown->region;
    const bool inside = probe->hip.x >= r.x_mm && probe->hip.x <= r.x_mm + r.side_mm &&
                        probe->hip.y >= r.y_mm && probe->hip.y <= r.y_mm + r.side_mm;
    const double above = probe->hip.z - windowHeightMm(*shown, probe->hip.x, probe->hip.y);
    return inside && above > 0 && above < 2 * kHoverMm * handMapping(*shown).objectMmPerHandMm();
  };
  EXPECT_TRUE(waitFor(is_over));
  QTest::keyClick(&view, Qt::Key_F5);
  ASSERT_TRUE(waitFor([&] { return probe && probe->forces_on; }));
  double most_n = 0;
  QTest::keyClick(&view, Qt::Key_PageDown);
  EXPECT_TRUE(waitFor([&] { return probe->touching && norm(probe->force) > 0.05; }));
  for (int i = 0; i < 30; ++i) {
    most_n = std::max(most_n, norm(probe->force));
    QTest::qWait(16);
  }
  EXPECT_LT(most_n, 0.13) << "0.25 mm at 0.8 N/mm and 60 % at most";
  plugins->detachAll();
}

}  // namespace
}  // namespace relievo
