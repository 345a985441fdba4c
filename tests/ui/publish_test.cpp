// SPDX-License-Identifier: BSD-3-Clause
// Figures, projects, measurements and relief images in the window.
#include <algorithm>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStyleOption>
#include <QTableWidget>
#include <QtTest/QTest>
#include <thread>

#include "core/io/formats/text_file.h"
#include "core/measure/measure_text.h"
#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "core/provenance/sha256.h"
#include "core/session/map_facts.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/figure/figure.h"
#include "ui/panels/measure_panel.h"
#include "ui/views/overlays/colour_bar.h"
#include "ui/views/overlays/grid_painter.h"
#include "ui/vtk/offscreen.h"

namespace relievo {
namespace {

/// A table without its comments.
std::string rowsOf(const QString& csv) {
  QStringList rows = csv.split('\n');
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const QString& row) { return row.startsWith('#'); }),
             rows.end());
  return rows.join('\n').toStdString();
}

class PublishTest : public GuiTest {
 protected:
  MeasurePanel& measure() { return *window().findChild<MeasurePanel*>(); }
  /// Point of the detail view over a view position; the window must be untilted.
  QPointF detailPoint(double x_mm, double y_mm) {
    const DetailView& view = window().detailView();
    const Region& r = document().project().region;
    const double mm = r.side_mm / std::min(view.width() - 4, view.height() - 4);
    return QPointF(0.5 * view.width() + (x_mm - r.centreX()) / mm,
                   0.5 * view.height() - (y_mm - r.centreY()) / mm);
  }
  /// And back.
  PlaceMm detailPlace(const QPointF& point) {
    const DetailView& view = window().detailView();
    const Region& r = document().project().region;
    const double mm = r.side_mm / std::min(view.width() - 4, view.height() - 4);
    return {r.centreX() + (point.x() - 0.5 * view.width()) * mm,
            r.centreY() - (point.y() - 0.5 * view.height()) * mm};
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
  document().region().setRect({40, 40, 60, 60});
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
  EXPECT_EQ(projectFromJson(*state, "out.png").region, document().project().region);
}

TEST_F(PublishTest, TheFigureFormShowsLayoutsWholeBesideTheirNames) {
  openRelief();
  FigureDialog& dialog = openDialog();
  auto* layouts = dialog.findChild<QComboBox*>("figure_layout");
  QStyleOptionComboBox option;
  option.initFrom(layouts);
  const int room =
      layouts->style()
          ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, layouts)
          .width();
  EXPECT_GE(room, layouts->fontMetrics().horizontalAdvance(layouts->itemText(1)));
  for (const char* name : {"figure_width", "figure_elevation", "figure_text"}) {
    auto* field = dialog.findChild<QWidget*>(name);
    const QLabel* label = nullptr;
    for (const QLabel* one : dialog.findChildren<QLabel*>()) {
      if (one->buddy() == field) label = one;
    }
    ASSERT_NE(label, nullptr) << name;
    EXPECT_LE(label->geometry().right(), field->geometry().left()) << name << " has a row";
    EXPECT_GT(label->width(), label->fontMetrics().horizontalAdvance(label->text().remove('&')));
  }
}

TEST_F(PublishTest, AFigureMakesNoFolderAndReplacesNoFileUnasked) {
  openRelief();
  FigureDialog& dialog = openDialog();
  auto* name = dialog.findChild<QLineEdit*>("figure_file");
  auto* save = dialog.findChild<QPushButton*>("figure_save");
  name->setText(path("typo/a.png"));
  QTest::mouseClick(save, Qt::LeftButton);
  auto* problem = dialog.findChild<QLabel*>("figure_problem");
  EXPECT_TRUE(problem->isVisible());
  EXPECT_TRUE(problem->text().contains("typo")) << problem->text().toStdString();
  EXPECT_FALSE(QFile::exists(path("typo")));
  const auto content = [&] {
    QFile file(path("mine.png"));
    file.open(QIODevice::ReadOnly);
    return file.readAll();
  };
  QFile mine(path("mine.png"));
  ASSERT_TRUE(mine.open(QIODevice::WriteOnly));
  mine.write("mine");
  mine.close();
  name->setText(path("mine.png"));
  QTest::mouseClick(save, Qt::LeftButton);
  auto* asked = dialog.findChild<QMessageBox*>("figure_replace");
  ASSERT_NE(asked, nullptr);
  asked->reject();
  EXPECT_EQ(content(), "mine");
  ASSERT_TRUE(dialog.isVisible());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  QTest::mouseClick(save, Qt::LeftButton);
  asked = dialog.findChild<QMessageBox*>("figure_replace");
  ASSERT_NE(asked, nullptr);
  for (QAbstractButton* button : asked->buttons()) {
    if (asked->buttonRole(button) == QMessageBox::AcceptRole) button->click();
  }
  EXPECT_TRUE(waitFor([&] { return content() != "mine"; }));
  EXPECT_EQ(QImage(path("mine.png")).width(), 2126);
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
  document().region().setRect({40, 40, 60, 60});
  document().region().setGain(2);
  measure().setMeasurements({{"top", MeasureKind::depth, {{10, 10}, {100, 90}}, 0}});
  window().runCommand("relief_slope");
  const Region region = document().project().region;
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
  EXPECT_EQ(document().project().region, region);
  EXPECT_EQ(document().project().gain, 2);
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
  Region region = document().project().region;
  region.x_mm += 40;
  region.y_mm += 30;
  region.side_mm = 20;
  provenance.view = ViewState{.region = region, .gain = 2};
  writePng(path("r.png").toStdString(), {.width = 1, .height = 1, .rgb = {0, 0, 0}},
           {{std::string(kStateKey), toJson(provenance)}});
  window().open(path("r.png"));
  ASSERT_TRUE(waitFor([&] { return document().project().region.side_mm == 20; }));
  EXPECT_EQ(document().project().region, region);
  EXPECT_EQ(document().project().gain, 2);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
}

TEST_F(PublishTest, AProjectMovedWithItsScanOpensAndAChangedScanIsSaid) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  const Region region = document().project().region;
  window().saveProject(path("p.relievo.json"));
  ASSERT_TRUE(QFile::exists(path("p.relievo.json")));
  document().region().whole();
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return document().project().region == region; }));
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
  EXPECT_EQ(rowsOf(measure().csv(path("list.csv"))),
            measurementsCsv(mapCells(*document().surface()), measure().measurements()))
      << "as the command line writes them";
  child<QTableWidget>("measure_list")->setCurrentCell(0, 0);
  measure().writeSelected(path("p.svg"));
  measure().writeSelected(path("p.csv"));
  QFile csv(path("p.csv"));
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_TRUE(csv.readAll().contains("along_mm,x_mm,y_mm,z_mm"));
  const auto state = embeddedState(path("p.csv").toStdString());
  ASSERT_TRUE(state) << "what it was read on";
  EXPECT_EQ(provenanceFromJson(*state, "p").input.sha256, document().fileSha256().toStdString());
  const std::string svg = readTextFile(path("p.svg").toStdString(), 1 << 20);
  EXPECT_NE(svg.find("<polyline"), std::string::npos) << svg;
}

// The dome's ground is at 0: a contour by one click, an upright cut by two, both as
// `relievo measure --section` reads them.
TEST_F(PublishTest, AListOfMeasurementsSaysWhatItWasMeasuredOn) {
  openRelief();
  measure().setMeasurements({{"top", MeasureKind::depth, {{10, 10}, {100, 90}}}});
  const QString file = path("list.csv");
  QFile out(file);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(measure().csv(file).toUtf8());
  out.close();
  const auto state = embeddedState(file.toStdString());
  ASSERT_TRUE(state);
  const Provenance made = provenanceFromJson(*state, "list");
  EXPECT_EQ(made.input.file, "relief.ply") << "from where the list is";
  EXPECT_EQ(made.input.sha256, document().fileSha256().toStdString());
  EXPECT_TRUE(measure().csv(file).contains(",10 10; 100 90\n"))
      << measure().csv(file).toStdString();
}

TEST_F(PublishTest, SectionsAreMadeByClicksReadAsTheCommandLineDrawnAndKept) {
  openRelief();
  EXPECT_TRUE(window().runCommand("measure_section"));
  press(window().detailView(), detailPoint(100, 70));
  QTest::keyClick(&window().detailView(), Qt::Key_F);
  EXPECT_TRUE(window().runCommand("measure_section"));
  press(window().detailView(), detailPoint(30, 90));
  press(window().detailView(), detailPoint(170, 90));
  EXPECT_TRUE(measure().measuring()) << "a third place may follow";
  QTest::keyClick(&window().detailView(), Qt::Key_F);
  ASSERT_EQ(measure().measurements().size(), 2U);
  const std::vector<Measurement> made = measure().measurements();
  EXPECT_EQ(made[0].normal, (ViewMm{0, 0, 1}));
  EXPECT_EQ(made[0].plane_mm,
            surfacePoint(document().surface()->map, detailPlace(detailPoint(100, 70)))->at.z);
  EXPECT_NEAR(std::abs(made[1].normal.y), 1, 1e-9);
  ASSERT_TRUE(waitFor([&] { return reads(0).contains("curve") && reads(1).contains("curve"); }));
  EXPECT_TRUE(reads(0).contains("Plane level at")) << reads(0).toStdString();
  EXPECT_TRUE(reads(1).contains("Plane upright")) << reads(1).toStdString();
  const MapCells cells = mapCells(*document().surface());
  EXPECT_EQ(rowsOf(measure().csv(path("list.csv"))), measurementsCsv(cells, made));
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(section(cells, planeOf(made[i])).size(), 1U);
  EXPECT_EQ(window().detailView().sceneState().curves.size(), 2U);
  EXPECT_TRUE(window().detailView().sceneState().lines.empty()) << "a section keeps no places";
  window().saveProject(path("p.relievo.json"));
  const std::string kept = readTextFile(path("p.relievo.json").toStdString(), 1 << 20);
  EXPECT_EQ(projectFromJson(kept, "p").measurements, made);
}

TEST_F(PublishTest, ASectionIsMadeByKeysAndByTapsAndSavedAsCsvAndDrawing) {
  openRelief();
  window().runCommand("measure_section");
  DetailView& view = window().detailView();
  QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
  QTest::keyClick(&view, Qt::Key_Return);
  const auto tap = [this](double x, double y) {
    measure().follow({{x, y}, 0.5, true});
    measure().follow({{x, y}, 0, false});
  };
  tap(60, 60);
  EXPECT_TRUE(measure().measuring());
  tap(100, 110);  // The third ends it.
  EXPECT_FALSE(measure().measuring());
  ASSERT_EQ(measure().measurements().size(), 1U);
  EXPECT_NE(measure().measurements()[0].normal.z, 0);
  ASSERT_TRUE(waitFor([&] { return reads(0).contains("curve"); })) << reads(0).toStdString();
  measure().writeSelected(path("cut.csv"));  // What was made last is selected.
  measure().writeSelected(path("cut.svg"));
  QFile csv(path("cut.csv")), svg(path("cut.svg"));
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly) && svg.open(QIODevice::ReadOnly));
  const QByteArray rows = csv.readAll();
  EXPECT_TRUE(rows.contains("curve,closed,x_mm,y_mm,z_mm"));
  EXPECT_TRUE(rows.startsWith("# relievo")) << "and what it was read on";
  EXPECT_TRUE(svg.readAll().contains("up the plane (mm)"));
  window().runCommand("measure_section");
  tap(60, 60);
  tap(60, 60);
  QTest::keyClick(&view, Qt::Key_F);
  EXPECT_TRUE(measure().measuring()) << "twice the same place gives no plane: one is taken back";
  EXPECT_EQ(measure().measurements().size(), 1U);
}

TEST_F(PublishTest, ThePlaneOfAnAreaAndOfASectionIsShownAndCanBeSet) {
  openRelief();
  auto* plane = child<QDoubleSpinBox>("measure_plane");
  ASSERT_NE(plane, nullptr);
  window().runCommand("measure_area");
  for (const auto& [x, y] : {std::pair{80, 80}, {120, 80}, {120, 120}}) {
    press(window().detailView(), detailPoint(x, y));
  }
  QTest::keyClick(&window().detailView(), Qt::Key_F);
  ASSERT_EQ(measure().measurements().size(), 1U);
  const MapCells cells = mapCells(*document().surface());
  Measurement m = measure().measurements()[0];
  double lowest = 1e9;
  for (const PlaceMm& p : m.places) lowest = std::min(lowest, surfacePoint(cells, p)->at.z);
  EXPECT_EQ(m.plane_mm, lowest);
  EXPECT_TRUE(plane->isVisible()) << "what was made last is selected";
  EXPECT_NEAR(plane->value(), lowest, 0.0005);
  EXPECT_FALSE(plane->accessibleName().isEmpty());
  EXPECT_TRUE(reads(0).contains("Plane level at")) << reads(0).toStdString();
  plane->setFocus();
  plane->selectAll();
  QTest::keyClicks(plane, "-2");
  QTest::keyClick(plane, Qt::Key_Return);
  m.plane_mm = -2;
  EXPECT_EQ(measure().measurements()[0], m);
  EXPECT_EQ(rowsOf(measure().csv(path("list.csv"))), measurementsCsv(cells, {m}));
  EXPECT_TRUE(measure().csv(path("list.csv")).contains(",0 0 1 -2,"))
      << measure().csv(path("list.csv")).toStdString();
  measure().setMeasurements({{.kind = MeasureKind::section, .plane_mm = 5}});
  child<QTableWidget>("measure_list")->setCurrentCell(0, 0);
  EXPECT_EQ(plane->value(), 5);
  plane->setValue(10);
  EXPECT_EQ(measure().measurements()[0].plane_mm, 10);
  measure().setMeasurements({{.kind = MeasureKind::point, .places = {{100, 90}}}});
  EXPECT_FALSE(plane->isVisible());
}

TEST_F(PublishTest, AnAreaOfALargeMapIsReadByAWorker) {
  QFile raster(path("slope.asc"));
  ASSERT_TRUE(raster.open(QIODevice::WriteOnly));
  constexpr int kCols = 1250, kRows = 900;
  raster.write("ncols 1250\nnrows 900\nxllcorner 0\nyllcorner 0\ncellsize 0.5\n");
  for (int row = 0; row < kRows; ++row) {
    QByteArray line;
    for (int col = 0; col < kCols; ++col) line += QByteArray::number((row + col) % 10) + ' ';
    raster.write(line + '\n');
  }
  raster.close();
  OpenRequest request;
  request.file = raster.fileName();
  request.unit = LengthUnit::mm;
  window().open(request);
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  const Measurement all{
      "all", MeasureKind::area, {{10, 10}, {600, 10}, {600, 400}, {10, 400}}, 2.5};
  measure().setMeasurements({all});
  EXPECT_THROW(measure().csv(path("list.csv")), ArgumentError) << "it is still being read";
  ASSERT_TRUE(waitFor([this] { return reads(0).contains("mm\u00b2"); }));
  const MapCells cells = mapCells(*document().surface());
  EXPECT_EQ(rowsOf(measure().csv(path("list.csv"))), measurementsCsv(cells, {all}));
}

TEST_F(PublishTest, AnOutlineThatWouldCrossItselfIsToldAtThePlace) {
  openRelief();
  window().runCommand("measure_area");
  for (const auto& [x, y] : {std::pair{60, 60}, {100, 100}, {100, 60}, {60, 100}}) {
    measure().addPlace(x, y);
  }
  EXPECT_TRUE(child<QLabel>("measure_hint")->text().contains("cross itself"));
  EXPECT_EQ(window().detailView().sceneState().lines.back().size(), 4U) << "three, and the first";
  measure().finish();
  ASSERT_EQ(measure().measurements().size(), 1U);
  EXPECT_EQ(measure().measurements()[0].places.size(), 3U);
  window().runCommand("measure_area");
  for (const double at : {60.0, 80.0, 100.0}) measure().addPlace(at, at);
  measure().finish();
  EXPECT_TRUE(measure().measuring()) << "on one line: a corner is taken back";
  EXPECT_EQ(measure().measurements().size(), 1U);
}

TEST_F(PublishTest, TheWheelTurnsNoValueThatTheKeyboardIsNotAt) {
  openRelief();
  int fields = 0;
  for (QWidget* const field : window().findChildren<QWidget*>()) {
    if (!qobject_cast<QAbstractSpinBox*>(field) && !qobject_cast<QComboBox*>(field)) continue;
    EXPECT_NE(field->focusPolicy(), Qt::WheelFocus) << field->objectName().toStdString();
    ++fields;
  }
  EXPECT_GT(fields, 5);
  window().runCommand("figure");
  auto* dialog = child<FigureDialog>("figure_dialog");
  ASSERT_NE(dialog, nullptr);
  auto* dpi = dialog->findChild<QDoubleSpinBox*>("figure_dpi");
  ASSERT_NE(dpi, nullptr);
  QApplication::setActiveWindow(dialog);
  dialog->findChild<QLineEdit*>("figure_file")->setFocus();
  const double before = dpi->value();
  wheel(*dpi, dpi->rect().center(), 2);
  EXPECT_EQ(dpi->value(), before);
  dpi->setFocus();
  wheel(*dpi, dpi->rect().center(), 2);
  EXPECT_EQ(dpi->value(), before + 2);
}

TEST_F(PublishTest, AFigureIsAskedForFromANumberField) {
  openRelief();
  const auto fields = window().findChildren<QDoubleSpinBox*>();
  const auto field = std::find_if(fields.begin(), fields.end(), [](QDoubleSpinBox* one) {
    return one->isVisible() && one->isEnabled();
  });
  ASSERT_NE(field, fields.end());
  (*field)->setFocus();
  QTest::keyClick(*field, Qt::Key_E, Qt::ControlModifier);
  EXPECT_NE(child<FigureDialog>("figure_dialog"), nullptr);
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

  EXPECT_TRUE(window().runCommand("search_commands"));
  auto* again = window().findChildren<QLineEdit*>("command_words").last();
  QTest::keyClicks(again, "measure");
  auto* found = window().findChildren<QListWidget*>("command_list").last();
  EXPECT_EQ(found->findItems("Angle", Qt::MatchStartsWith).size(), 1) << "by the menu it is in";
}

TEST_F(PublishTest, AReliefImageHasABarThatNamesItAndStoneHasNone) {
  openRelief();
  auto* bar = window().detailView().findChild<ColourBar*>();
  EXPECT_FALSE(bar->isVisible());
  window().runCommand("relief_slope");
  EXPECT_TRUE(bar->isVisible());
  EXPECT_TRUE(bar->accessibleDescription().startsWith("slope"));
  EXPECT_FALSE(window().detailView().sceneState().grid->colours.empty());
  document().region().setRect({40, 40, 60, 60});
  EXPECT_FALSE(window().detailView().sceneState().grid->colours.empty()) << "stays on a new window";
  window().runCommand("relief_lit");
  EXPECT_FALSE(bar->isVisible());
  EXPECT_TRUE(window().detailView().sceneState().grid->colours.empty());
}

// As the command line computes them, though they are made in the background.
TEST_F(PublishTest, AReliefImageThatTakesLongComesWhenItIsReady) {
  openRelief();
  const SurfaceView& view = window().detailView();
  auto* bar = view.findChild<ColourBar*>();
  window().runCommand("relief_openness");
  EXPECT_TRUE(view.sceneState().grid->colours.empty()) << "stone meanwhile";
  EXPECT_FALSE(bar->isVisible());
  ASSERT_TRUE(waitFor([&] { return !view.sceneState().grid->colours.empty(); }));
  EXPECT_TRUE(bar->accessibleDescription().startsWith("openness"));
  // The ends are those of the overview, once that is painted as well.
  const SurfaceView& overview = window().referenceView();
  ASSERT_TRUE(
      waitFor([&] { return overview.shownRange() && view.shownRange() == overview.shownRange(); }));
  const SceneState plain = view.plainState();
  ReliefLook look = plain.look;
  look.range = overview.shownRange();
  EXPECT_EQ(view.sceneState().grid->colours,
            GridPainter::paintNow(*plain.grid, look).grid->colours);

  const auto before = view.sceneState().grid;
  document().region().setRect({40, 40, 60, 60});
  EXPECT_EQ(view.sceneState().grid, before) << "until the new one has its colours";
  ASSERT_TRUE(waitFor([&] { return view.sceneState().grid != before; }));
  EXPECT_TRUE(waitFor([&] { return !view.sceneState().grid->colours.empty(); }));
  EXPECT_EQ(view.sceneState().grid->frame.spacing_mm, view.plainState().grid->frame.spacing_mm);

  window().runCommand("relief_skyview");
  window().runCommand("relief_lit");
  QTest::qWait(300);
  EXPECT_TRUE(view.sceneState().grid->colours.empty()) << "nobody wants the sky view any more";
}

}  // namespace
}  // namespace relievo
