// SPDX-License-Identifier: BSD-3-Clause
// The whole of it: window, host, loader and the haptics plugin that was built beside them.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QtTest/QTest>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class TouchWindowTest : public GuiTest {
 protected:
  void TearDown() override { qunsetenv("RELIEVO_PLUGIN_PATH"); }
  double forceShown() {
    const QString text = child<QLabel>("status_force")->text();
    return text.endsWith("N") ? text.section('/', 0, 0).toDouble() : 0;
  }
  /// What the program prints; it must succeed.
  static QByteArray said(const QStringList& words) {
    QProcess program;
    program.start(QStringLiteral(RELIEVO_BINARY_DIR "/bin/relievo"), words);
    EXPECT_TRUE(program.waitForFinished(60'000));
    const QByteArray out = program.readAllStandardOutput();
    EXPECT_EQ(program.exitCode(), 0)
        << program.readAllStandardError().toStdString() << out.toStdString();
    return out;
  }
};

TEST_F(TouchWindowTest, AModuleThatIsNoPluginIsSkippedAndNamed) {
  QFile module(path("broken.so"));
  ASSERT_TRUE(module.open(QIODevice::WriteOnly));
  module.write("this is text");
  module.close();
  qputenv("RELIEVO_PLUGIN_PATH", path("").toLocal8Bit());
  WindowHost host(window());
  PluginLoader plugins(host, window().settings());
  plugins.load();
  ASSERT_EQ(plugins.problems().size(), 1);
  EXPECT_TRUE(plugins.problems().front().contains("broken.so"));
  EXPECT_FALSE(plugins.has("broken"));
}

TEST_F(TouchWindowTest, PressingWithTheMouseIsAnsweredByAForceThatEscapeStops) {
  WindowHost host(window());
  PluginLoader plugins(host, window().settings());
  plugins.load();
  ASSERT_TRUE(plugins.has("haptics")) << plugins.problems().join(' ').toStdString();
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
  plugins.detachAll();
}

TEST_F(TouchWindowTest, ARecordingWithLiveChangesIsReplayedToTheLastBit) {
  qputenv("HOME", path("home").toLocal8Bit());
  qputenv("XDG_CONFIG_HOME", path("home/config").toLocal8Bit());
  WindowHost host(window());
  PluginLoader plugins(host, window().settings());
  plugins.load();
  ASSERT_TRUE(plugins.has("haptics"));
  openRelief();
  auto& view = window().detailView();
  const QPointF middle = QRectF(view.rect()).center();
  move(view, middle);
  QTest::keyClick(&view, Qt::Key_F5);
  ASSERT_TRUE(
      waitFor([&] { return view.sceneState().probe && view.sceneState().probe->forces_on; }));
  press(view, middle);
  ASSERT_TRUE(waitFor([this] { return forceShown() > 0.1; }));
  // It begins while the hand touches; then window, level and feel change.
  action("record")->trigger();
  QTest::qWait(300);
  ASSERT_TRUE(window().runCommand("finer"));
  QTest::qWait(600);
  child<QComboBox>("surfacePreset")->setCurrentIndex(1);  // Another shape, too.
  move(view, middle + QPointF(30, 10));
  QTest::qWait(300);
  window().runCommand("coarser");
  QTest::qWait(600);
  QStringList files;
  action("record")->trigger();
  const QDir folder(path("home/Documents/relievo"));
  ASSERT_TRUE(waitFor([&] {
    files = folder.entryList({"touch-*.csv"}, QDir::Files, QDir::Time);
    QFile file(folder.filePath(files.value(0)));
    return file.open(QIODevice::ReadOnly) && file.readAll().contains("# replay core ");
  }));
  release(view, middle);
  plugins.detachAll();
  const QString recording = folder.filePath(files.front());  // Knows where its scan lies.
  EXPECT_TRUE(said({"replay", recording, "--verify"}).contains("to the last bit"));
  // Packed for citation it is found and repeated as well.
  said({"project", "new", recording, "-o", path("p.json"), "--recording", recording});
  said({"project", "package", path("p.json"), "-o", path("p.zip")});
  EXPECT_TRUE(said({"replay", path("p.zip"), "--verify"}).contains("to the last bit"));
}

}  // namespace
}  // namespace relievo
