// SPDX-License-Identifier: BSD-3-Clause
// Scans of every kind, one after the other in one running window with its haptics plugin: the
// program stays, no error leaves an event handler (gui_main.cpp fails then), and each gives a
// picture or a sentence. RELIEVO_SCANS=200 opens as many generated ones, RELIEVO_SEED chooses
// others.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <QAction>
#include <QApplication>
#include <QtTest/QTest>

#include "app/host.h"
#include "app/plugin_loader.h"
#include "tests/app/generated_scans.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

constexpr int kScans = 42;  ///< Two of each format.
constexpr std::uint32_t kSeed = 16;

int numberOr(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

class ManyScansTest : public GuiTest {
 protected:
  ManyScansTest() : host_(window()), plugins_(host_, window().settings()) {
    plugins_.load();
    EXPECT_TRUE(plugins_.has(QStringLiteral("haptics_plugin")))
        << plugins_.problems().join(' ').toStdString();
  }

  /// Opens it and does with it what a hand does first. @return what came of it
  std::string tryOut(const QString& file) {
    window().open(file);
    if (!waitFor([&] { return !document().loader().busy(); }) &&
        !waitFor([&] { return !document().loader().busy(); })) {
      ADD_FAILURE() << "still being opened: " << file.toStdString();
      document().loader().cancel();
      return "nothing";
    }
    QApplication::processEvents();
    if (document().file() != file) {
      EXPECT_FALSE(window().message().isEmpty()) << "neither picture nor sentence";
      return "sentence: " + window().message().toStdString();
    }
    expectPictures();
    touch();
    for (const char* name : {"finer", "whole", "coarser", "stereo", "stereo"}) {
      if (QAction* const command = action(name); command != nullptr && command->isEnabled())
        command->trigger();
      QApplication::processEvents();
    }
    expectPictures();
    return "picture";
  }

  /// Both views have been drawn, and show more than one colour.
  void expectPictures() {
    for (QWidget* view : {static_cast<QWidget*>(&window().referenceView()),
                          static_cast<QWidget*>(&window().detailView())}) {
      EXPECT_TRUE(waitFor([view] {
        const QImage seen = view->grab().toImage().convertToFormat(QImage::Format_RGB32);
        const QRgb first = seen.pixel(0, 0);
        for (int y = 0; y < seen.height(); ++y) {
          const auto* row = reinterpret_cast<const QRgb*>(seen.constScanLine(y));
          if (std::any_of(row, row + seen.width(), [first](QRgb c) { return c != first; }))
            return true;
        }
        return false;
      })) << "the picture has one colour";
    }
  }

  void touch() {
    auto& view = window().detailView();
    const QPointF middle = QRectF(view.rect()).center();
    move(view, middle);
    if (QAction* const forces = action("forces"); forces != nullptr) forces->trigger();
    drag(view, middle, middle + QPointF(40, 25));
    move(view, middle - QPointF(30, 30));
    wheel(view, middle, 1);
    QApplication::processEvents();
    if (QAction* const forces = action("forces"); forces != nullptr && forces->isChecked())
      forces->trigger();
  }

 private:
  WindowHost host_;
  PluginLoader plugins_;
};

TEST_F(ManyScansTest, EachGivesAPictureOrASentence) {
  const test::TemporaryFolder folder;
  const int scans = numberOr("RELIEVO_SCANS", kScans);
  const auto seed = static_cast<std::uint32_t>(numberOr("RELIEVO_SEED", kSeed));
  int pictures = 0;
  for (int i = numberOr("RELIEVO_FIRST_SCAN", 0); i < scans; ++i) {
    const test::GeneratedScan scan = test::generatedScan(seed, i);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.name + ": " + scan.about);
    const std::filesystem::path file = folder.write(scan.name, scan.bytes);
    std::cout << scan.name << ", " << scan.about << std::flush;
    const std::string came = tryOut(QString::fromStdString(file.string()));
    std::cout << ": " << came << std::endl;
    pictures += came == "picture" ? 1 : 0;
    std::filesystem::remove(file);
  }
  EXPECT_GT(pictures, 0) << "all of them were refused";
}

TEST_F(ManyScansTest, EachSharedScanGivesAPicture) {
  std::filesystem::path shared = test::sharedData();
  if (shared.empty()) GTEST_SKIP() << "there are no shared scans";
  shared = std::filesystem::canonical(shared);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shared)) {
    const std::string ending = entry.path().extension().string();
    if (entry.is_regular_file() && ending != ".md" && ending != ".tsv")
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty());
  for (const std::filesystem::path& file : files) {
    SCOPED_TRACE(file.string());
    EXPECT_EQ(tryOut(QString::fromStdString(file.string())), "picture");
  }
}

}  // namespace
}  // namespace relievo
