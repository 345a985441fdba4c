// SPDX-License-Identifier: BSD-3-Clause
// A map by tiles in the window: never read whole, and the same as if it were.
#include <algorithm>
#include <QAction>
#include <QFile>
#include <QLabel>
#include <QRegExp>
#include <QSignalSpy>
#include <QTableWidget>

#include "core/measure/measure_text.h"
#include "core/session/finer_heights.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/session/tiled_fixture.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/depth_map_dialog.h"
#include "ui/panels/measure_panel.h"
#include "ui/work/pictures/relief_picture.h"

namespace relievo {
namespace {

class TiledWindowTest : public GuiTest {
 protected:
  void SetUp() override {
    window().open(file());
    ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
    ASSERT_TRUE(document().surface()->tiles);
    ASSERT_EQ(document().details(), 4);
  }
  QString file() const { return QString::fromStdString((both_.folder / "map.tif").string()); }
  const Surface& whole() const { return both_.whole; }
  MeasurePanel& measure() { return *window().findChild<MeasurePanel*>(); }
  /// The window on show has the bytes of the map in memory.
  void expectTheWindowOfTheWhole() {
    const RegionWindow there =
        windowOf(whole(), document().project().region, document().project().gain);
    EXPECT_EQ(document().window()->heights_mm, there.heights_mm);
    EXPECT_EQ(document().window()->id, there.id);
    if (there.region.level.value == 0) {
      EXPECT_EQ(document().window()->origins, there.origins);
    }
  }

  const test::BothWays both_{{.cols = 1400, .rows = 900}};
};

TEST_F(TiledWindowTest, EveryStepShowsTheWindowOfTheMapInMemoryAndComesBack) {
  EXPECT_TRUE(document().surface()->pyramid.levels.empty()) << "the map is in files only";
  std::vector<std::uint64_t> seen{document().window()->id};
  const auto shown = [&] {
    expectTheWindowOfTheWhole();
    seen.push_back(document().window()->id);
  };
  expectTheWindowOfTheWhole();
  for (int detail = 2; detail <= 4; ++detail) {
    ASSERT_TRUE(document().region().finer(document().region().aboutCentre()));
    EXPECT_EQ(document().detail(), detail);
    shown();
  }
  ASSERT_TRUE(document().region().move(0.25, -0.4));
  shown();
  ASSERT_TRUE(document().region().setRect({31, 40, 17, 17}));
  shown();
  ASSERT_TRUE(document().region().setGain(2));
  shown();
  ASSERT_TRUE(document().region().setLevel({2}));
  shown();
  document().region().preview({60, 40, 30, {1}});
  expectTheWindowOfTheWhole();
  document().region().revert();
  for (std::size_t i = seen.size() - 1; i-- > 0;) {
    document().history().undo();
    EXPECT_EQ(document().window()->id, seen[i]);
  }
  for (std::size_t i = 1; i < seen.size(); ++i) {
    document().history().redo();
    EXPECT_EQ(document().window()->id, seen[i]);
  }
}

TEST_F(TiledWindowTest, ReferenceAndPanelsShowTheWholeAsOfTheMapInMemory) {
  const auto grid = window().referenceView().sceneState().grid;
  ASSERT_TRUE(grid);
  const PyramidLevel& level = whole().pyramid.levels[2];
  EXPECT_EQ(grid->frame, level.frame);
  EXPECT_TRUE(std::ranges::equal(grid->heights_mm, level.heights_mm));
  EXPECT_TRUE(child<QLabel>("surface_cells")->text().startsWith("1400 \u00d7 900"))
      << child<QLabel>("surface_cells")->text().toStdString();
  EXPECT_TRUE(child<QLabel>("surface_holes")->text().contains(QRegExp("0[.,]40")))
      << child<QLabel>("surface_holes")->text().toStdString();
  EXPECT_EQ(reliefPicture(*document().surface(), 256), reliefPicture(whole(), 256));
  EXPECT_EQ(ReliefPictures::kept(file()).size(), reliefPicture(whole(), kPicturePx).size());
}

TEST_F(TiledWindowTest, MeasuresOnTheFinestLevelWhateverIsShown) {
  using enum MeasureKind;
  const std::vector<Measurement> list{{"point", point, {{32.01, 63.97}}},
                                      {"step", depth, {{87.5, 56.2}, {150, 100}}},
                                      {"cut", profile, {{40, 30}, {120, 67}, {170, 110}}},
                                      {"all", area, {{0, 0}, {175, 0}, {175, 112}, {0, 112}}, 2.5}};
  measure().setMeasurements(list);
  EXPECT_TRUE(child<QTableWidget>("measure_list")->item(0, 1)->text().contains("mm"));
  EXPECT_THROW(measure().csv(path("list.csv")), ArgumentError)
      << "what crosses the whole map is read by a worker";
  const auto text = [this](int row) {
    return child<QTableWidget>("measure_list")->item(row, 1)->text();
  };
  ASSERT_TRUE(waitFor([&] { return text(3).contains("mm\u00b2") && text(2).contains("mm"); }));
  // The same function on the map in memory; the words of its head aside.
  const std::string written = measure().csv(path("list.csv")).toStdString();
  const std::string rows = measurementsCsv(whole().map, list);
  EXPECT_TRUE(written.ends_with('\n' + rows)) << written;
}

TEST_F(TiledWindowTest, APointBesideTheObjectIsNone) {
  measure().begin(MeasureKind::point);
  QSignalSpy said(&measure(), &MeasurePanel::said);
  measure().addPlace(1, 1);
  ASSERT_EQ(said.size(), 1);
  EXPECT_TRUE(measure().measurements().empty());
  measure().addPlace(120, 80);
  EXPECT_EQ(measure().measurements().size(), 1U);
}

TEST_F(TiledWindowTest, AProjectOpensItAgainWithItsSteps) {
  document().region().finer(document().region().aboutCentre());
  document().region().finer({60, 50, false});
  document().region().setRect({31, 40, 17, 17});
  const DocumentState before = document().state();
  const std::uint64_t id = document().window()->id;
  window().saveProject(path("p.relievo.json"));
  document().region().whole();
  QSignalSpy windows(&document(), &Document::windowChanged);
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(waitFor(
      [&] { return document().state().surface != before.surface && !document().loader().busy(); }));
  EXPECT_EQ(windows.size(), 1) << "no window of the way there is read";
  EXPECT_EQ(document().project().region, before.project.region);
  EXPECT_EQ(document().window()->id, id);
  EXPECT_TRUE(document().surface()->tiles);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  document().history().undo();
  expectTheWindowOfTheWhole();
  EXPECT_EQ(document().detail(), 3);
  document().history().redo();
  EXPECT_EQ(document().window()->id, id);
}

TEST_F(TiledWindowTest, WhatNeedsTheWholeIsRefusedInOneSentence) {
  const DocumentState before = document().state();
  for (const char* command : {"front", "auto", "engine_depthbuffer", "depth_map"}) {
    SCOPED_TRACE(command);
    ASSERT_NE(action(command), nullptr);
    if (!action(command)->isEnabled()) continue;
    EXPECT_TRUE(window().runCommand(command));
    EXPECT_TRUE(window().message().contains("by tiles")) << window().message().toStdString();
    EXPECT_FALSE(document().loader().busy());
    EXPECT_EQ(window().findChild<DepthMapDialog*>(), nullptr);
    EXPECT_EQ(document().state(), before);
  }
  document().choices().setUnit(LengthUnit::m);
  EXPECT_EQ(document().state(), before);
}

TEST_F(TiledWindowTest, AFileThatIsDamagedMeanwhileLeavesWhatIsShown) {
  document().region().finer(document().region().aboutCentre());
  const DocumentState before = document().state();
  const auto shown = document().window();
  const int steps = document().history().count();
  // Level 0 is not in the cache yet, but for what was loaded ahead.
  QFile finest(file());
  ASSERT_TRUE(finest.resize(finest.size() / 8));
  EXPECT_TRUE(document().region().setRect({140, 2, 20, 20}));
  EXPECT_TRUE(window().message().contains("map.tif")) << window().message().toStdString();
  EXPECT_EQ(document().state(), before);
  EXPECT_EQ(document().window(), shown);
  EXPECT_EQ(document().history().count(), steps);
  document().history().undo();
  EXPECT_EQ(document().detail(), 1) << "and it works on";
}

TEST_F(TiledWindowTest, ItsWindowHasATextureFromTheNextFinerLevel) {
  document().region().finer(document().region().aboutCentre());
  const RegionWindow& w = *document().window();
  const std::vector<float> finer = finerHeights(*document().surface(), w.region, w.gain);
  EXPECT_FALSE(finer.empty());
  EXPECT_EQ(finer, finerHeights(whole(), w.region, w.gain));
}

}  // namespace
}  // namespace relievo
