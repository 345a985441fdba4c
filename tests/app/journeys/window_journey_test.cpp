// SPDX-License-Identifier: BSD-3-Clause
// By window, from two partial coloured scans with strays to a project that opens elsewhere:
// cleaned, laid on each other, joined, mapped, touched, recorded, drawn. The map is held against
// the command line's, byte for byte; coloured_journey_test is the same journey by command line
// alone.
#include <cmath>
#include <numbers>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest/QTest>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "tests/app/command.h"
#include "tests/ui/prepare/prepare_fixture.h"
#include "ui/dialogs/figure/figure_dialog.h"

namespace relievo {
namespace {

using test::runRelievo;

constexpr int kStrays = 25;

class WindowJourney : public PrepareGuiTest {
 protected:
  void SetUp() override {
    qputenv("HOME", path("home").toLocal8Bit());
    qputenv("XDG_CONFIG_HOME", path("home/config").toLocal8Bit());
    for (const char* folder : {"work", "command"}) {
      ASSERT_TRUE(QDir().mkpath(path(folder)));
      writeScan(path(folder) + "/front.ply", 0, {});
      writeScan(path(folder) + "/side.ply", 70, {.turned_deg = 40, .moved = {30, -20, 10}});
    }
  }

  /// The side of the body that looks there: red where x of the body is positive, else blue; green
  /// strays above it.
  void writeScan(const QString& name, double azimuth_deg, const BodyPlace& place) const {
    constexpr int kPoints = 60'000;
    constexpr double kDeg = std::numbers::pi / 180;
    QByteArray points;
    int count = 0;
    const auto add = [&](const FilePoint& p, const QByteArray& colour) {
      for (const double c : {p.x, p.y, p.z}) {
        const auto stored = static_cast<float>(c);
        points.append(reinterpret_cast<const char*>(&stored), sizeof stored);
      }
      points.append(colour);
      ++count;
    };
    for (int i = 0; i < kStrays; ++i) {
      add({40.0 * i - 300, 25.0 * i, 900.0 + i}, QByteArray("\x00\xff\x00", 3));
    }
    for (int i = 0; i < kPoints; ++i) {
      const double z = 1 - 2 * (i + 0.5) / kPoints;
      const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0)) + azimuth_deg;
      if (std::sqrt(1 - z * z) * std::cos(turn - azimuth_deg * kDeg) < std::cos(120 * kDeg))
        continue;
      const auto p = onBody(turn / kDeg, z);
      add(laid(p, place), p[0] > 0 ? QByteArray("\xdc\x28\x1e", 3) : QByteArray("\x14\x3c\xd2", 3));
    }
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(
        "ply\nformat binary_little_endian 1.0\ncomment unit mm\nelement vertex " +
        QByteArray::number(count) +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty "
        "uchar green\nproperty uchar blue\nend_header\n" +
        points);
  }

  void waitUntilOpen() {
    ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  }

  void pressOnTheMiddle() {
    // The dialog was active, and Xvfb has no window manager that would go back to its parent.
    QApplication::setActiveWindow(&window());
    auto& view = window().detailView();
    const QPointF middle = QRectF(view.rect()).center();
    move(view, middle);
    QTest::keyClick(&view, Qt::Key_F5);
    ASSERT_TRUE(
        waitFor([&] { return view.sceneState().probe && view.sceneState().probe->forces_on; }));
    press(view, middle);
    ASSERT_TRUE(waitFor([this] {
      return child<QLabel>("status_force")->text().section('/', 0, 0).toDouble() > 0.1;
    }));
  }

  /// Starts and ends a recording while the hand presses. @return its file
  QString recorded() {
    action("record")->trigger();
    QTest::qWait(300);
    action("record")->trigger();
    const QDir folder(path("home/Documents/relievo"));
    QStringList files;
    EXPECT_TRUE(waitFor([&] {
      files = folder.entryList({"*.csv"}, QDir::Files, QDir::Time);
      QFile file(folder.filePath(files.value(0)));
      return file.open(QIODevice::ReadOnly) && file.readAll().contains("replay core ");
    }));
    return folder.filePath(files.value(0));
  }

  QImage figure(const QString& file) {
    EXPECT_TRUE(window().runCommand("figure"));
    auto* dialog = window().findChildren<FigureDialog*>().last();
    auto* caption = dialog->findChild<QPlainTextEdit*>("figure_caption");
    EXPECT_TRUE(waitFor([caption] { return !caption->toPlainText().isEmpty(); }));
    dialog->findChild<QLineEdit*>("figure_file")->setText(file);
    auto* save = dialog->findChild<QPushButton*>("figure_save");
    EXPECT_TRUE(waitFor([save] { return save->isEnabled(); }));
    QTest::mouseClick(save, Qt::LeftButton);
    EXPECT_TRUE(waitFor([dialog, &file] { return !dialog->isVisible() && QFile::exists(file); }));
    return QImage(file);
  }

  std::string at(const char* name) const { return path(QString::fromLatin1(name)).toStdString(); }
};

TEST_F(WindowJourney, FromTwoColouredScansToAProjectThatOpensElsewhere) {
  WindowHost host(window());
  PluginLoader plugins(host, window().settings());
  plugins.load();
  ASSERT_TRUE(plugins.has("haptics_plugin")) << plugins.problems().join(' ').toStdString();

  // Clean, align, join.
  PrepareDialog& dialog = openTogether({path("work/front.ply"), path("work/side.ply")});
  addStep(dialog, "add_lonely_all");
  QTreeWidget& steps = tree(dialog, "prepare_steps");
  steps.setCurrentItem(steps.topLevelItem(static_cast<int>(*dialog.state().alignStep())));
  choose(dialog, "align_method", 2);
  ASSERT_TRUE(isShown(dialog));
  accept(dialog);
  waitUntilOpen();
  ASSERT_TRUE(document().file().endsWith("front-prepared.ply"));
  const Scan joined = importScan(document().file().toStdString());
  EXPECT_LT(joined.info.bounds->max.z, 100) << "a stray is left";
  EXPECT_EQ(joined.colours.size(), joined.points.size());

  // The map of the command line, from scans of its own, is the same.
  const auto made = runRelievo({"prepare", at("command/front.ply"), at("command/side.ply"),
                                "--clean", "--align", "auto", "-o", at("command/joined.ply")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  ASSERT_EQ(
      runRelievo({"depthmap", at("command/joined.ply"), "-o", at("command/map.tif")}).exit_code, 0);
  const RasterMap map = importRaster(at("command/map.tif"), {});
  const Surface& shown = *document().surface();
  ASSERT_EQ(map.values.size(), shown.map.heights_mm.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    different += map.valid[i] && map.values[i] != shown.map.heights_mm[i] ? 1 : 0;
  }
  EXPECT_EQ(different, 0U);

  // Touch and record, with the mouse.
  pressOnTheMiddle();
  const QString recording = recorded();
  release(window().detailView(), QRectF(window().detailView().rect()).center());
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  plugins.detachAll();
  const auto replayed = runRelievo({"replay", recording.toStdString(), "--verify"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;

  // Figure in the scan's own colours, and project.
  ASSERT_TRUE(window().runCommand("relief_natural"));
  const QImage before = figure(path("work/figure.png"));
  ASSERT_FALSE(before.isNull());
  window().saveProject(path("work/p.relievo.json"));

  // Elsewhere: the same state, the same picture.
  const Region region = document().project().region;
  ASSERT_TRUE(QDir().rename(path("work"), path("elsewhere")));
  restart();
  window().open(path("elsewhere/p.relievo.json"));
  waitUntilOpen();
  EXPECT_EQ(document().file(), path("elsewhere/front-prepared.ply"));
  EXPECT_EQ(document().project().region, region);
  EXPECT_EQ(figure(path("elsewhere/again.png")), before);
}

}  // namespace
}  // namespace relievo
