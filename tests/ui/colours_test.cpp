// SPDX-License-Identifier: BSD-3-Clause
// A scan's own colours in the window: chosen, shaded, undone, kept in a project.
#include <cmath>
#include <filesystem>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QStandardItemModel>
#include <QtTest/QTest>

#include "core/io/raster/colour_raster.h"
#include "core/session/colours/surface_colours.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/figure/figure_dialog.h"

namespace relievo {
namespace {

class ColoursTest : public GuiTest {
 protected:
  /// A dome of 300 x 240 cells whose left half is red and right half green.
  QString writeColouredMap() const {
    const GridSize size{.cols = 300, .rows = 240};
    DepthMap map{.frame = {.size = size, .spacing_mm = 0.5, .first_x_mm = 0.25, .first_y_mm = 0.25},
                 .heights_mm = {},
                 .origins = {}};
    GridColours colours;
    for (int row = 0; row < size.rows; ++row) {
      for (int col = 0; col < size.cols; ++col) {
        const double r = std::hypot(col - 150, row - 120) / 120;
        map.heights_mm.push_back(static_cast<float>(20 * std::max(0.0, 1 - r * r)));
        colours.colours.push_back(col < 150 ? Rgba{220, 20, 20, 255} : Rgba{20, 200, 30, 255});
      }
    }
    map.origins.assign(size.count(), CellStatus::measured);
    const std::filesystem::path file = path("coloured.tif").toStdString();
    writeMapWithColours(file, map, colours, {.view_from_file = {}});
    return QString::fromStdString(file.string());
  }
  void openFile(const QString& file) {
    window().open(file);
    ASSERT_TRUE(waitFor([&] {
      return document().isOpen() && !document().loader().busy() && document().file() == file;
    }));
    QApplication::processEvents();
  }
  void openColoured() { openFile(writeColouredMap()); }
  const SceneState& seen() { return window().detailView().sceneState(); }
  /// Colour of the detail's middle row at a column.
  Rgba shownAt(int col) {
    const std::size_t i = 3 * (100 * 200 + static_cast<std::size_t>(col));
    const auto& colours = seen().grid->colours;
    return {colours[i], colours[i + 1], colours[i + 2], 255};
  }
  QSlider& shading() { return *child<QSlider>("look_shading"); }
};

TEST_F(ColoursTest, ThatAreThereAreChosenFromTheMenuAndShadedByASlider) {
  openColoured();
  EXPECT_EQ(seen().look.kind, ReliefKind::lit) << "the first look stays stone";
  EXPECT_TRUE(action("relief_natural")->isEnabled());
  EXPECT_FALSE(action("relief_intensity")->isEnabled()) << "the map has none";
  EXPECT_FALSE(shading().isEnabled());
  window().runCommand("relief_natural");
  EXPECT_TRUE(action("relief_natural")->isChecked());
  ASSERT_TRUE(shading().isEnabled());
  EXPECT_EQ(shading().value(), 50);
  shading().setValue(0);
  EXPECT_EQ(shownAt(50), (Rgba{220, 20, 20, 255}));
  EXPECT_EQ(shownAt(150), (Rgba{20, 200, 30, 255}));
  EXPECT_FALSE(seen().grid->lit);
  shading().setValue(100);
  EXPECT_NE(shownAt(50), (Rgba{220, 20, 20, 255}));
  EXPECT_EQ(window().referenceView().sceneState().grid->colours.size(),
            3 * window().referenceView().sceneState().grid->heights_mm.size());
  const Rgba before = shownAt(40);
  child<QSlider>("light_azimuth")->setValue(90);
  EXPECT_NE(shownAt(40), before) << "the light moves the shading";
}

TEST_F(ColoursTest, ThePictureHasThem) {
  openColoured();
  window().runCommand("relief_natural");
  shading().setValue(0);
  const QImage picture = window().detailView().shot();
  const QRgb left = picture.pixel(picture.width() * 35 / 100, picture.height() / 2);
  const QRgb right = picture.pixel(picture.width() * 65 / 100, picture.height() / 2);
  EXPECT_NEAR(qRed(left), 220, 2);
  EXPECT_NEAR(qGreen(left), 20, 2);
  EXPECT_NEAR(qRed(right), 20, 2);
  EXPECT_NEAR(qGreen(right), 200, 2);
}

TEST_F(ColoursTest, LookAndShadingAreStepsThatCanBeUndone) {
  openColoured();
  const int steps = document().history().index();
  window().runCommand("relief_natural");
  shading().setValue(40);
  shading().setValue(20);
  ASSERT_EQ(document().history().index(), steps + 2) << "one pull of the slider is one step";
  document().history().undo();
  EXPECT_DOUBLE_EQ(seen().look.shading, 0.5);
  EXPECT_EQ(shading().value(), 50);
  EXPECT_EQ(seen().look.kind, ReliefKind::natural);
  document().history().undo();
  EXPECT_EQ(seen().look.kind, ReliefKind::lit);
  EXPECT_FALSE(shading().isEnabled());
  document().history().redo();
  document().history().redo();
  EXPECT_DOUBLE_EQ(seen().look.shading, 0.2);
}

TEST_F(ColoursTest, AProjectBringsThemBack) {
  openColoured();
  window().runCommand("relief_natural");
  shading().setValue(30);
  const QString project = path("look.relievo.json");
  window().saveProject(project);
  restart();
  window().open(project);
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  ASSERT_TRUE(waitFor([this] { return seen().look.kind == ReliefKind::natural; }));
  EXPECT_DOUBLE_EQ(seen().look.shading, 0.3);
  EXPECT_FALSE(seen().grid->colours.empty());
}

TEST_F(ColoursTest, AScanWithoutThemIsShownAsStoneAndSaysSo) {
  openColoured();
  window().runCommand("relief_natural");
  openFile(writeRelief());
  EXPECT_EQ(seen().look.kind, ReliefKind::lit);
  EXPECT_TRUE(seen().grid->colours.empty());
  EXPECT_FALSE(action("relief_natural")->isEnabled());
  EXPECT_TRUE(action("relief_lit")->isChecked());
}

TEST_F(ColoursTest, TheFigureDialogOffersWhatThereIs) {
  openColoured();
  window().runCommand("relief_natural");
  window().runCommand("figure");
  auto* dialog = child<FigureDialog>("figure_dialog");
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->request().look.kind, ReliefKind::natural);
  auto* relief = child<QComboBox>("figure_relief");
  const auto* items = qobject_cast<QStandardItemModel*>(relief->model());
  EXPECT_TRUE(items->item(static_cast<int>(ReliefKind::natural))->isEnabled());
  EXPECT_FALSE(items->item(static_cast<int>(ReliefKind::intensity))->isEnabled());
  dialog->close();
}

}  // namespace
}  // namespace relievo
