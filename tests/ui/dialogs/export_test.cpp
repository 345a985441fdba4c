// SPDX-License-Identifier: BSD-3-Clause
// File > Export..., by keys alone, and what lies on the disk then.
#include <fstream>
#include <iterator>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest/QTest>

#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "core/session/export_map.h"
#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

class ExportWindowTest : public GuiTest {
 protected:
  std::string bytes(const QString& file) const {
    std::ifstream in(QFile::encodeName(file).toStdString(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void typeInto(QLineEdit& field, const QString& text) {
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
  }
};

TEST_F(ExportWindowTest, IsReachedByKeysAndWritesWhatIsChosen) {
  ASSERT_FALSE(action("export")->isEnabled()) << "nothing is open";
  openRelief();
  ASSERT_TRUE(action("export")->isEnabled());
  auto* const menu = window().menuBar()->findChild<QMenu*>("menu_file");
  ASSERT_NE(menu, nullptr);
  menu->popup(window().mapToGlobal(QPoint(0, 0)));
  ASSERT_TRUE(waitFor([&] { return menu->isVisible(); }));
  QTest::keyClick(menu, Qt::Key_X);
  auto* const dialog = child<QDialog>("export_dialog");
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(dialog->isVisible());
  auto* const format = dialog->findChild<QComboBox*>("export_format");
  auto* const file = dialog->findChild<QLineEdit*>("export_file");
  auto* const size = dialog->findChild<QLabel*>("export_size");
  EXPECT_TRUE(file->text().endsWith(".tif")) << "web maps are offered first";
  const QString whole = size->text();
  EXPECT_TRUE(whole.contains("500")) << whole.toStdString();
  format->setFocus();
  QTest::keyClick(format, Qt::Key_Down);
  QTest::keyClick(format, Qt::Key_Down);
  EXPECT_TRUE(file->text().endsWith(".glb")) << file->text().toStdString();
  EXPECT_NE(size->text(), whole);
  auto* const part = dialog->findChild<QComboBox*>("export_part");
  EXPECT_EQ(part->count(), 1 + document().details() - 1 + 1);
  QTest::keyClick(part, Qt::Key_End);
  EXPECT_TRUE(size->text().startsWith("200 x 200")) << size->text().toStdString();
  QTest::keyClick(part, Qt::Key_Home);
  typeInto(*file, path("new folder/dome.glb"));
  QTest::keyClick(file, Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] {
    return !window().controllers().exports.busy() && !bytes(path("new folder/dome.glb")).empty();
  }));
  EXPECT_EQ(bytes(path("new folder/dome.glb")).substr(0, 4), "glTF");
  EXPECT_TRUE(
      waitFor([&] { return child<QLabel>("status_message")->text().contains("dome.glb"); }));
  EXPECT_EQ(window().message(), "");
}

TEST_F(ExportWindowTest, WritesTheBytesOfTheSameFunctionForEveryFormat) {
  openRelief();
  for (const char* const ending : {"tif", "asc", "vti", "ply", "xyz", "stl", "glb"}) {
    SCOPED_TRACE(ending);
    const QString name = path(QStringLiteral("a.%1").arg(QLatin1String(ending)));
    MapExport choice;
    choice.format = *exportFormatOf(name.toStdString());
    choice.part = ExportPart::level;
    choice.region.level = {1};
    window().controllers().exports.write(choice, name);
    ASSERT_TRUE(waitFor([&] { return !window().controllers().exports.busy(); }));
    ASSERT_EQ(window().message(), "");
    EXPECT_GT(bytes(name).size(), 1000U);
    if (choice.format == ExportFormat::geotiff) continue;  // Holds where it came from.
    const std::string other = path("other." + QLatin1String(ending)).toStdString();
    exportMap(other, *document().surface(), choice, nullptr);
    EXPECT_EQ(bytes(name), bytes(QString::fromStdString(other)));
  }
}

TEST_F(ExportWindowTest, OffersPicturesProfilesAndSectionsToo) {
  openRelief();
  document().edit({}, [](Project& p) {
    p.measurements = {
        {.name = "rim", .kind = MeasureKind::profile, .places = {{20, 90}, {180, 90}}},
        {.name = "contour", .kind = MeasureKind::section, .plane_mm = 10}};
  });
  const auto* list = child<QTableWidget>("measure_list");
  ASSERT_TRUE(waitFor([list] { return list->item(1, 1)->text().contains("curve"); }));
  const auto write = [&](const QString& what, const QString& name) {
    window().runCommand("export");
    auto* const dialog = child<QDialog>("export_dialog");
    auto* const format = dialog->findChild<QComboBox*>("export_format");
    format->setCurrentIndex(format->findText(what));
    EXPECT_FALSE(dialog->findChild<QComboBox*>("export_part")->isEnabled());
    typeInto(*dialog->findChild<QLineEdit*>("export_file"), path(name));
    QTest::keyClick(dialog->findChild<QLineEdit*>("export_file"), Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  write("Profile rim, numbers (.csv)", "rim.csv");
  EXPECT_NE(bytes(path("rim.csv")).find("along_mm"), std::string::npos);
  write("Profile rim, drawing (.svg)", "rim");
  EXPECT_NE(bytes(path("rim.svg")).find("<svg"), std::string::npos) << "the ending is added";
  write("Section contour, drawing (.svg)", "contour.svg");
  EXPECT_NE(bytes(path("contour.svg")).find("<svg"), std::string::npos);
  write("Picture of the detail view (.png)", "detail.png");
  ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
  EXPECT_EQ(QImage(path("detail.png")).size(), window().detailView().shotSize());
}

TEST_F(ExportWindowTest, NeverTakesThePlaceOfTheScanAndSaysWhy) {
  openRelief();
  const QString scan = document().file();
  const std::string before = bytes(scan);
  MapExport choice;
  choice.format = ExportFormat::ply;
  window().controllers().exports.write(choice, scan);
  ASSERT_TRUE(waitFor(
      [&] { return !window().controllers().exports.busy() && !window().message().isEmpty(); }));
  EXPECT_TRUE(window().message().contains("the scan itself")) << window().message().toStdString();
  EXPECT_EQ(bytes(scan), before);
  window().controllers().exports.write(choice, path("no/such/folder/a.ply"));
  EXPECT_TRUE(waitFor([&] { return window().message().contains("Cannot write"); }));
}

}  // namespace
}  // namespace relievo
