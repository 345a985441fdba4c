// SPDX-License-Identifier: BSD-3-Clause
// Figures, projects, measurements and relief images in the window.
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest/QTest>
#include <thread>

#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "core/provenance/sha256.h"
#include "tests/ui/gui_fixture.h"
#include "ui/colour_bar.h"
#include "ui/figure/figure.h"
#include "ui/figure_dialog.h"
#include "ui/measure_panel.h"
#include "ui/vtk/offscreen.h"

namespace relievo {
namespace {

class PublishTest : public GuiTest {
 protected:
  MeasurePanel& measure() { return *window().findChild<MeasurePanel*>(); }
  /// Point of the detail view over a view position; the window must be untilted.
  QPointF detailPoint(double x_mm, double y_mm) {
    const DetailView& view = window().detailView();
    const Region& r = document().state().region;
    const double mm = r.side_mm / std::min(view.width() - 4, view.height() - 4);
    return QPointF(0.5 * view.width() + (x_mm - r.centreX()) / mm,
                   0.5 * view.height() - (y_mm - r.centreY()) / mm);
  }
  QString reads(int row) { return child<QTableWidget>("measure_list")->item(row, 1)->text(); }
  FigureDialog& openDialog() {
    EXPECT_TRUE(window().runCommand("figure"));
    auto* dialog = window().findChild<FigureDialog*>("figure_dialog");
    EXPECT_NE(dialog, nullptr);
    auto* caption = dialog->findChild<QPlainTextEdit*>("figure_caption");
    EXPECT_TRUE(waitFor([caption] { return !caption->toPlainText().isEmpty(); }));
    return *dialog;
  }
};

TEST_F(PublishTest, AFigureIsWrittenAsItsPreviewShowsAndCarriesTheState) {
  openRelief();
  document().setRect({40, 40, 60, 60});
  FigureDialog& dialog = openDialog();
  const QString file = path("out.png");
  dialog.findChild<QLineEdit*>("figure_file")->setText(file);
  EXPECT_TRUE(dialog.findChild<QLabel*>("figure_facts")->text().contains("2126"))
      << "180 mm at 300 dots per inch: "
      << dialog.findChild<QLabel*>("figure_facts")->text().toStdString();
  QTest::mouseClick(dialog.findChild<QPushButton*>("figure_save"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return QFile::exists(file); }));
  const QImage image(file);
  EXPECT_EQ(image.width(), 2126);
  EXPECT_EQ(image.dotsPerMeterX(), 11811);
  const auto state = embeddedState(file.toStdString());
  ASSERT_TRUE(state);
  EXPECT_EQ(projectFromJson(*state, "out.png").region, document().state().region);
}

// The worker may be in the driver, which cannot be stopped halfway: nobody waits for it.
TEST_F(PublishTest, AFigureStoppedInItsFirstMomentIsAnsweredAtOnceAndCanBeSavedAgain) {
  openRelief();
  FigureDialog& dialog = openDialog();
  const QString file = path("again.png");
  dialog.findChild<QLineEdit*>("figure_file")->setText(file);
  auto* save = dialog.findChild<QPushButton*>("figure_save");
  auto* stop = dialog.findChild<QPushButton*>("figure_stop");
  QTest::mouseClick(save, Qt::LeftButton);
  ASSERT_TRUE(stop->isVisible());
  QTest::mouseClick(stop, Qt::LeftButton);
  EXPECT_FALSE(stop->isVisible());
  auto* problem = dialog.findChild<QLabel*>("figure_problem");
  EXPECT_TRUE(problem->isVisible());
  EXPECT_EQ(problem->text(), "Stopped. Nothing was written.");
  EXPECT_FALSE(QFile::exists(file));
  QTest::mouseClick(save, Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return QFile::exists(file); }));
}

TEST_F(PublishTest, TheFigureDialogClosesWhileItsFirstPreviewIsDrawnAndOpensAgain) {
  openRelief();
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(window().runCommand("figure"));
    auto* dialog = window().findChild<FigureDialog*>("figure_dialog");
    ASSERT_NE(dialog, nullptr);
    dialog->reject();
    EXPECT_FALSE(dialog->isVisible());
  }
  openDialog();
  EXPECT_TRUE(waitFor([this] { return window().findChildren<FigureDialog*>().size() == 1; }))
      << "the closed ones go";
  // And the end of the program comes in the middle of one.
  window().findChild<FigureDialog*>("figure_dialog")->reject();
  ASSERT_TRUE(window().runCommand("figure"));
  restart();
}

// Not on the window's thread, as the window does it (ui/figure/figure.h).
TEST_F(PublishTest, AFigureIsTheSameAfterTheWindowWasMadeAnew) {
  openRelief();
  Project project = window().project();
  project.figure.dpi = 60;
  const auto surface = document().surface();
  const auto drawn = [&] {
    Figure figure;
    std::thread([&] { figure = drawFigure(*surface, project); }).join();
    return figure.image.rgba;
  };
  const auto before = drawn();
  restart();
  openRelief();
  EXPECT_EQ(drawn(), before);
}

TEST_F(PublishTest, ADialogsFigureIsThatOfTheSameRecordDrawnElsewhere) {
  openRelief();
  FigureDialog& dialog = openDialog();
  Project project = window().project();
  project.figure = dialog.request();
  project.figure.dpi = 60;
  const Figure here = drawFigure(*document().surface(), project);
  const Project copied = projectFromJson(projectJson(project), "copy");
  EXPECT_EQ(drawFigure(*document().surface(), copied).image.rgba, here.image.rgba);
}

TEST_F(PublishTest, DroppingAFigureRestoresWindowAndMeasurements) {
  openRelief();
  document().setRect({40, 40, 60, 60});
  document().setGain(2);
  measure().setMeasurements({{"top", MeasureKind::depth, {{10, 10}, {100, 90}}, 0}});
  window().runCommand("relief_slope");
  const Region region = document().state().region;
  Project project = window().project();
  project.figure.dpi = 40;
  writeFigure(*document().surface(), project, path("f.png").toStdString());
  OpenRequest other;  // Which asks nothing about what was measured.
  other.file = writeRelief("other.ply");
  window().open(other);
  ASSERT_TRUE(waitFor([&] { return document().file().endsWith("other.ply"); }));
  EXPECT_TRUE(measure().measurements().empty());
  window().open(path("f.png"));
  ASSERT_TRUE(waitFor([&] { return document().file().endsWith("relief.ply"); }));
  EXPECT_EQ(document().state().region, region);
  EXPECT_EQ(document().state().gain, 2);
  ASSERT_EQ(measure().measurements().size(), 1U);
  EXPECT_EQ(measure().measurements()[0].name, "top");
  EXPECT_EQ(window().detailView().sceneState().look.kind, ReliefKind::slope);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
}

TEST_F(PublishTest, DroppingAPictureOfRenderRestoresItsRegion) {
  openRelief();
  Provenance provenance = provenanceOf(*document().surface(), {});
  provenance.input = {.file = "relief.ply",
                      .sha256 = sha256OfFile(path("relief.ply").toStdString())};
  Region region = document().state().region;
  region.x_mm += 40;
  region.y_mm += 30;
  region.side_mm = 20;
  provenance.view = ViewState{.region = region, .gain = 2};
  writePng(path("r.png").toStdString(), {.width = 1, .height = 1, .rgb = {0, 0, 0}},
           {{std::string(kStateKey), toJson(provenance)}});
  window().open(path("r.png"));
  ASSERT_TRUE(waitFor([&] { return document().state().region.side_mm == 20; }));
  EXPECT_EQ(document().state().region, region);
  EXPECT_EQ(document().state().gain, 2);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
}

TEST_F(PublishTest, AProjectMovedWithItsScanOpensAndAChangedScanIsSaid) {
  openRelief();
  document().setRect({40, 40, 60, 60});
  const Region region = document().state().region;
  window().saveProject(path("p.relievo.json"));
  ASSERT_TRUE(QFile::exists(path("p.relievo.json")));
  document().whole();
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return document().state().region == region; }));
  EXPECT_TRUE(window().message().isEmpty());
  QFile scan(path("relief.ply"));
  ASSERT_TRUE(scan.open(QIODevice::ReadWrite));
  scan.seek(scan.size() - 4);
  scan.write("\x00\x00\x80\x3f", 4);  // The last point is 1 mm high now.
  scan.close();
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return window().message().contains("E501"); }))
      << window().message().toStdString() << document().fileSha256().toStdString() << ' '
      << window().project().sha256;
  scan.remove();
  window().open(path("p.relievo.json"));
  EXPECT_TRUE(window().message().contains("has moved")) << window().message().toStdString();
}

TEST_F(PublishTest, ADepthDifferenceIsMeasuredByTwoClicks) {
  openRelief();
  EXPECT_TRUE(window().runCommand("measure_depth"));
  ASSERT_TRUE(measure().measuring());
  press(window().detailView(), detailPoint(20, 20));
  press(window().detailView(), detailPoint(100, 90));
  ASSERT_EQ(measure().measurements().size(), 1U);
  // The dome is 20 mm high; a pixel beside the top is lower by far less than the cell.
  EXPECT_TRUE(reads(0).startsWith("depth difference 20.0") ||
              reads(0).startsWith("depth difference 19.9"))
      << reads(0).toStdString();
  EXPECT_TRUE(reads(0).contains("\u00b1"));
  EXPECT_EQ(window().detailView().sceneState().lines.size(), 1U);
  EXPECT_FALSE(window().detailView().pressing()) << "picking is not pressing";
}

TEST_F(PublishTest, AProfileIsMadeByKeysAloneAndSaved) {
  openRelief();
  EXPECT_TRUE(window().runCommand("measure_profile"));
  DetailView& view = window().detailView();
  const auto keys = [&](int key, int times, Qt::KeyboardModifiers with = Qt::NoModifier) {
    for (int i = 0; i < times; ++i) QTest::keyClick(&view, static_cast<Qt::Key>(key), with);
  };
  keys(Qt::Key_Left, 4, Qt::ShiftModifier);
  keys(Qt::Key_Return, 1);
  keys(Qt::Key_Right, 8, Qt::ShiftModifier);
  keys(Qt::Key_Return, 1);
  EXPECT_TRUE(measure().measuring()) << "a profile may bend";
  keys(Qt::Key_F, 1);
  ASSERT_EQ(measure().measurements().size(), 1U);
  EXPECT_EQ(measure().measurements()[0].kind, MeasureKind::profile);
  EXPECT_NEAR(measure().measurements()[0].places[1].x - measure().measurements()[0].places[0].x,
              80 * document().window()->spacingMm(), 1e-6);
  EXPECT_TRUE(measure().csv().contains("\"1\",profile,\"length\""))
      << measure().csv().toStdString();
  child<QTableWidget>("measure_list")->setCurrentCell(0, 0);
  measure().writeProfile(path("p.svg"));
  measure().writeProfile(path("p.csv"));
  QFile csv(path("p.csv"));
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_TRUE(csv.readAll().contains("along_mm,x_mm,y_mm,z_mm"));
}

TEST_F(PublishTest, EscapeEndsMeasuringAndKeepsWhatWasMeasured) {
  openRelief();
  window().runCommand("measure_angle");
  press(window().detailView(), detailPoint(20, 20));
  EXPECT_EQ(window().detailView().sceneState().lines.size(), 1U);
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_FALSE(measure().measuring());
  EXPECT_TRUE(window().detailView().sceneState().lines.empty());
}

TEST_F(PublishTest, ACommandIsFoundByItsWordsAndRun) {
  openRelief();
  EXPECT_TRUE(window().runCommand("search_commands"));
  auto* words = child<QLineEdit>("command_words");
  ASSERT_NE(words, nullptr);
  QTest::keyClicks(words, "sky");
  auto* list = child<QListWidget>("command_list");
  ASSERT_EQ(list->count(), 1);
  QTest::keyClick(words, Qt::Key_Return);
  EXPECT_EQ(window().detailView().sceneState().look.kind, ReliefKind::sky_view);
}

TEST_F(PublishTest, AReliefImageHasABarThatNamesItAndStoneHasNone) {
  openRelief();
  auto* bar = window().detailView().findChild<ColourBar*>();
  EXPECT_FALSE(bar->isVisible());
  window().runCommand("relief_openness");
  EXPECT_TRUE(bar->isVisible());
  EXPECT_TRUE(bar->accessibleDescription().startsWith("openness"));
  EXPECT_FALSE(window().detailView().sceneState().grid->colours.empty());
  document().setRect({40, 40, 60, 60});
  EXPECT_FALSE(window().detailView().sceneState().grid->colours.empty()) << "stays on a new window";
  window().runCommand("relief_lit");
  EXPECT_FALSE(bar->isVisible());
  EXPECT_TRUE(window().detailView().sceneState().grid->colours.empty());
}

}  // namespace
}  // namespace relievo
