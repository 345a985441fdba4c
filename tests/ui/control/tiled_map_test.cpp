// SPDX-License-Identifier: BSD-3-Clause
// File > Map by tiles...: the map of a scan that may be larger than the memory, made in the
// background by the function of `relievo depthmap --memory`.
#include <fstream>
#include <iterator>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QtTest/QTest>

#include "core/project/tiled_work.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tiled_map.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/tiled_map_dialog.h"
#include "ui/work/file_path.h"

namespace relievo {
namespace {

class TiledMapDialogTest : public GuiTest {
 protected:
  TiledMapDialog& dialog() {
    auto* const shown = window().findChild<TiledMapDialog*>();
    if (shown != nullptr && shown->isVisible()) return *shown;
    EXPECT_TRUE(window().runCommand(QStringLiteral("tiled_map")));
    return *window().findChild<TiledMapDialog*>();
  }
  template <class Widget>
  Widget& part(const char* name) {
    return *dialog().findChild<Widget*>(QString::fromLatin1(name));
  }
  void make() { QTest::keyClick(&part<QPushButton>("tiles_make"), Qt::Key_Space); }
  bool working() { return window().controllers().tiles.busy(); }
  void name(const QString& file) {
    auto& line = part<QLineEdit>("tiles_file");
    line.setFocus();
    QTest::keyClick(&line, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&line, file);
  }
  bool hears(const QString& words) {
    return waitFor([&] { return child<QLabel>("status_message")->text().contains(words); });
  }
  static std::string bytes(const QString& file) {
    std::ifstream in(pathOf(file), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(TiledMapDialogTest, MakesTheMapOfThisScanShowsItOnTheWayAndOpensIt) {
  openRelief();
  EXPECT_EQ(part<QListWidget>("tiles_scan").count(), 1) << "what is open is offered";
  EXPECT_TRUE(part<QLineEdit>("tiles_file").text().endsWith("relief-map.relievo.tif"));
  EXPECT_EQ(dialog().order().unit, LengthUnit::mm) << "as it is shown";
  EXPECT_EQ(dialog().order().view, "top");
  const QString map = path(QStringLiteral("by_window.tif"));
  name(map);
  part<QSpinBox>("tiles_memory").setValue(400);
  make();
  EXPECT_TRUE(working());
  EXPECT_TRUE(part<QPushButton>("tiles_stop").isVisible());
  EXPECT_FALSE(part<QPushButton>("tiles_make").isEnabled());
  ASSERT_TRUE(hears(QStringLiteral("by_window.tif is made: ")));
  auto* const made = window().findChild<TiledMapDialog*>();
  const QString ready = made->findChild<QLabel*>("tiles_ready")->text();
  EXPECT_TRUE(ready.startsWith("All heights of ")) << ready.toStdString();
  EXPECT_FALSE(made->isVisible()) << "the map takes its place";
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && document().surface()->tiles; }));
  EXPECT_EQ(document().file(), map);
  EXPECT_FALSE(QFile::exists(map + ".job")) << "what was kept is not needed any more";

  TiledWork same{.names = {pathOf(writeRelief())}, .out = pathOf(path("by_hand.tif"))};
  same.options.unit = LengthUnit::mm;
  same.options.view = ViewChoice{"top", {}, {}};
  same.memory_bytes = 300'000'000;
  const LargeMap by_hand = makeTiledMap(same);
  for (int level = 0; level < static_cast<int>(by_hand.frames.size()); ++level) {
    const std::string one = bytes(QString::fromStdString(levelFile(pathOf(map), level).string()));
    EXPECT_FALSE(one.empty()) << level;
    EXPECT_EQ(one, bytes(QString::fromStdString(levelFile(same.out, level).string()))) << level;
  }
}

TEST_F(TiledMapDialogTest, FilesOfAFolderAreOneScan) {
  QDir().mkpath(path("parts"));
  ASSERT_TRUE(QFile::rename(writeRelief(), path("parts/a.ply")));
  ASSERT_TRUE(QFile::copy(path("parts/a.ply"), path("parts/b.ply")));
  EXPECT_EQ(part<QListWidget>("tiles_scan").count(), 0) << "nothing is open";
  EXPECT_FALSE(part<QPushButton>("tiles_make").isEnabled()) << "of nothing there is no map";
  TiledMapOrder begun;
  begun.names << path("parts");
  begun.unit = LengthUnit::mm;
  TiledMapDialog of_folder(begun);
  EXPECT_TRUE(of_folder.findChild<QPushButton*>("tiles_make")->isEnabled());
  EXPECT_EQ(of_folder.order().file, path("parts-map.relievo.tif"));
  TiledWork work{.names = {pathOf(of_folder.order().names.front())},
                 .out = pathOf(of_folder.order().file)};
  work.options.unit = of_folder.order().unit;
  EXPECT_EQ(makeTiledMap(work).info.finite_points, 2 * 500 * 400);
  // Chosen entries go, and with the last one the work that could be asked for.
  auto* const list = of_folder.findChild<QListWidget*>("tiles_scan");
  list->selectAll();
  QTest::keyClick(of_folder.findChild<QPushButton*>("tiles_remove"), Qt::Key_Space);
  EXPECT_EQ(list->count(), 0);
  EXPECT_FALSE(of_folder.findChild<QPushButton*>("tiles_make")->isEnabled());
}

TEST_F(TiledMapDialogTest, OffersTheScanThatIsOpenNow) {
  EXPECT_EQ(dialog().order().names, QStringList());
  dialog().close();
  openRelief();
  EXPECT_EQ(dialog().order().names, QStringList{document().file()});
}

TEST_F(TiledMapDialogTest, AMapThatWouldReplaceItsScanIsNotMade) {
  openRelief();
  const std::string before = bytes(document().file());
  const QString scan = document().file();
  ASSERT_TRUE(QFile::link(scan, path("link.tif")));
  name(path("link.tif"));
  make();
  ASSERT_TRUE(waitFor([&] { return !working(); }));
  auto& problem = part<QLabel>("tiles_problem");
  EXPECT_TRUE(problem.isVisible());
  EXPECT_TRUE(problem.text().contains("link.tif")) << problem.text().toStdString();
  EXPECT_EQ(window().message(), problem.text()) << "and above the views";
  EXPECT_EQ(bytes(scan), before);
  EXPECT_TRUE(part<QPushButton>("tiles_make").isEnabled()) << "it may be asked for differently";
  name(path("other.tif"));
  part<QCheckBox>("tiles_opens").setChecked(false);
  make();
  EXPECT_FALSE(part<QLabel>("tiles_problem").isVisible());
  ASSERT_TRUE(hears(QStringLiteral("other.tif is made: ")));
  EXPECT_TRUE(dialog().isVisible());
  EXPECT_EQ(document().file(), scan) << "nobody wanted it opened";
}

TEST_F(TiledMapDialogTest, StoppedItKeepsWhatIsFinishedAndGoesOn) {
  openRelief();
  const QString map = path(QStringLiteral("map.tif"));
  name(map);
  part<QCheckBox>("tiles_opens").setChecked(false);
  make();
  ASSERT_TRUE(waitFor([&] { return QFile::exists(map + ".job"); }));
  QTest::keyClick(&part<QPushButton>("tiles_stop"), Qt::Key_Space);
  EXPECT_FALSE(working());
  EXPECT_TRUE(hears(QStringLiteral("what was finished is kept in map.tif.job")));
  EXPECT_FALSE(TiledMap::isOne(pathOf(map)));
  EXPECT_TRUE(QFile::exists(map + ".job"));
  make();
  ASSERT_TRUE(hears(QStringLiteral("map.tif is made: ")));
  EXPECT_TRUE(TiledMap::isOne(pathOf(map)));
  EXPECT_FALSE(QFile::exists(map + ".job"));
}

TEST_F(TiledMapDialogTest, ClosedMeanwhileItWorksOnAndTheWindowClosesAfterIt) {
  openRelief();
  const QString map = path(QStringLiteral("map.tif"));
  name(map);
  part<QCheckBox>("tiles_opens").setChecked(false);
  make();
  auto* const asked = &dialog();
  asked->close();
  EXPECT_FALSE(asked->isVisible());
  EXPECT_TRUE(working());
  window().close();
  EXPECT_TRUE(window().isVisible()) << "what is being written is waited for";
  EXPECT_TRUE(waitFor([&] { return !window().isVisible(); }));
  EXPECT_TRUE(TiledMap::isOne(pathOf(map)));
}

}  // namespace
}  // namespace relievo
