// SPDX-License-Identifier: BSD-3-Clause
// One journey by window and by command line: two partial scans with strays are cleaned, laid on
// each other, thinned and joined; the files have equal bytes, and so have their maps.
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPushButton>
#include <QTreeWidget>
#include <QtTest/QTest>

#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "tests/app/command.h"
#include "tests/ui/prepare/prepare_fixture.h"

namespace relievo {
namespace {

using test::runRelievo;

QByteArray bytesOf(const QString& name) {
  QFile file(name);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
  return file.readAll();
}

class PrepareWindowTest : public PrepareGuiTest {
 protected:
  /// The same two scans for the window and for the command line.
  void writeScans() {
    for (const QString& folder : {QString("window"), QString("command")}) {
      ASSERT_TRUE(QDir().mkpath(path(folder)));
      writeBody(folder + "/front.ply", 0, 120, {});
      writeBody(folder + "/side.ply", 70, 120, {.turned_deg = 40, .moved = {30, -20, 10}});
    }
  }
  std::string at(const char* name) const { return path(QString::fromLatin1(name)).toStdString(); }
};

TEST_F(PrepareWindowTest, WindowAndCommandLineWriteEqualBytesAndOpenEqualMaps) {
  writeScans();
  PrepareDialog& dialog = openTogether({path("window/front.ply"), path("window/side.ply")});
  addStep(dialog, "add_lonely_all");  // --clean
  QTreeWidget& steps = tree(dialog, "prepare_steps");
  steps.setCurrentItem(steps.topLevelItem(static_cast<int>(*dialog.state().alignStep())));
  choose(dialog, "align_method", 2);
  addStep(dialog, "add_thin");
  setNumber(dialog, "thin_spacing", 1.5);
  ASSERT_TRUE(isShown(dialog));

  click(dialog, "prepare_save_recipe");
  auto* saving = dialog.findChild<QFileDialog*>("recipe_dialog");
  ASSERT_NE(saving, nullptr);
  Q_EMIT saving->fileSelected(path("window/recipe.json"));
  saving->close();
  auto* copy = dialog.findChild<QPushButton*>("prepare_copy_command");
  ASSERT_TRUE(waitFor([&] { return copy->isEnabled(); }));
  QTest::mouseClick(copy, Qt::LeftButton);
  EXPECT_EQ(QGuiApplication::clipboard()->text(),
            QStringLiteral("relievo prepare --recipe '%1' -o '%2'")
                .arg(path("window/recipe.json"), path("window/front-prepared.ply")));
  accept(dialog);
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));

  const auto made =
      runRelievo({"prepare", at("command/front.ply"), at("command/side.ply"), "--clean", "--align",
                  "auto", "--thin", "1.5", "-o", at("command/front-prepared.ply")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const QByteArray window_bytes = bytesOf(path("window/front-prepared.ply"));
  EXPECT_EQ(window_bytes, bytesOf(path("command/front-prepared.ply")));
  const auto again =
      runRelievo({"prepare", "--recipe", at("window/recipe.json"), "-o", at("window/again.ply")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(window_bytes, bytesOf(path("window/again.ply")));

  const auto map = runRelievo({"depthmap", at("command/front-prepared.ply"), "-o", at("map.tif")});
  ASSERT_EQ(map.exit_code, 0) << map.err;
  const RasterMap stored = importRaster(at("map.tif"), {});
  const DepthMap& shown = document().surface()->map;
  ASSERT_EQ(stored.values.size(), shown.heights_mm.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < stored.values.size(); ++i) {
    if (stored.valid[i] && stored.values[i] != shown.heights_mm[i]) ++different;
  }
  EXPECT_EQ(different, 0U);
}

TEST_F(PrepareWindowTest, AProjectOfAPreparedScanOpensElsewhere) {
  openRelief();
  PrepareDialog& dialog = openDialog();
  addStep(dialog, "add_crop_box");
  setNumber(dialog, "crop_x_max", 100);
  accept(dialog);
  ASSERT_TRUE(waitFor(
      [&] { return document().file().endsWith("-prepared.ply") && !document().loader().busy(); }));
  window().saveProject(path("work.relievo.json"));
  ASSERT_TRUE(QDir().mkpath(path("elsewhere")));
  for (const char* name : {"work.relievo.json", "relief-prepared.ply"}) {
    ASSERT_TRUE(QFile::copy(path(name), path("elsewhere/") + name));
    ASSERT_TRUE(QFile::remove(path(name)));
  }
  restart();
  window().open(path("elsewhere/work.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(document().file(), path("elsewhere/relief-prepared.ply"));
  EXPECT_EQ(document().surface()->info.points, 80'400U);
  EXPECT_FALSE(window().message().contains("E501")) << window().message().toStdString();
  EXPECT_EQ(document().project().history.back(), "Prepare");
}

}  // namespace
}  // namespace relievo
