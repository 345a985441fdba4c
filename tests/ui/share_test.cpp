// SPDX-License-Identifier: BSD-3-Clause
// What leaves the window for others: a view as text, and a package for citation.
#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QtTest/QTest>

#include "core/base/error.h"
#include "core/project/package.h"
#include "haptics/record/sample_log.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/package_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/panels/measure_panel.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

class ShareTest : public GuiTest {
 protected:
  static QString clipboard() { return QGuiApplication::clipboard()->text(); }
  static void copy(const QString& text) { QGuiApplication::clipboard()->setText(text); }
  QString status() const { return child<QLabel>("status_message")->text(); }

  QString writeFile(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
  void saveImage(const QString& name) {
    window().saveImage(ImageSource::detail, {64, 48}, path(name));
    ASSERT_TRUE(waitFor([&] { return !window().savingImage(); }));
  }
  void note(const QString& recording) {
    const std::size_t before = window().project().recordings.size();
    window().controllers().replays.noteRecording(recording);
    ASSERT_TRUE(waitFor([&] { return window().project().recordings.size() > before; }));
    child<MessageStrip>("message_strip")->close();  // After the first: where they are kept.
  }
  void finishPacking() {
    ASSERT_TRUE(waitFor([&] { return !window().controllers().packages.busy(); }));
    QApplication::processEvents();
  }
  fs::path unpacked(const QString& package) const {
    const fs::path folder = path("unpacked").toStdString();
    fs::create_directories(folder);
    unpackPackage(package.toStdString(), folder);
    return folder;
  }
};

TEST_F(ShareTest, AViewGoesThroughTheClipboardAsText) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  window().runCommand("relief_slope");
  window().detailView().turnBy(20, 10);
  const ViewState shown = viewOf(window().project());
  QTest::keyClick(&window().detailView(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(viewFromText(clipboard().toStdString()), shown);

  window().runCommand("relief_lit");
  window().detailView().straighten();
  document().region().whole();
  const Region whole = document().project().region;
  copy("  " + clipboard() + "\n");  // As mail programs give it back.
  QTest::keyClick(&window().detailView(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(viewOf(window().project()), shown);
  EXPECT_TRUE(status().startsWith("The copied view is shown")) << status().toStdString();
  window().runCommand("undo");
  EXPECT_EQ(document().project().region, whole);
}

TEST_F(ShareTest, APictureFindsItsScanBesideItself) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  const Region region = document().project().region;
  saveImage("fig.png");
  document().region().whole();
  for (const QString& name : {QStringLiteral("fig.png"), QStringLiteral("relief.ply")}) {
    fs::create_directories(path("moved").toStdString());
    ASSERT_TRUE(QFile::rename(path(name), path("moved/" + name)));
  }
  window().open(path("moved/fig.png"));
  ASSERT_TRUE(waitFor([&] { return document().file() == path("moved/relief.ply"); }))
      << window().message().toStdString();
  EXPECT_EQ(document().project().region, region);
  EXPECT_EQ(window().message(), QString());
}

TEST_F(ShareTest, ATextThatIsNoViewOfThisMapChangesNothing) {
  openRelief();
  window().runCommand("copy_view");
  const QString view = clipboard();
  const Region before = document().project().region;
  copy("have a look");
  window().runCommand("paste_view");
  EXPECT_TRUE(window().message().contains("not a view of relievo"));
  ViewState elsewhere = viewFromText(view.toStdString());
  elsewhere.region.x_mm += 5000;
  copy(QString::fromStdString(toText(elsewhere)));
  window().runCommand("paste_view");
  EXPECT_TRUE(window().message().contains("does not lie on this map"));
  elsewhere = viewFromText(view.toStdString());
  elsewhere.region.level.value = 7;
  copy(QString::fromStdString(toText(elsewhere)));
  window().runCommand("paste_view");
  EXPECT_TRUE(window().message().contains("does not lie on this map"));
  EXPECT_EQ(document().project().region, before);
}

TEST_F(ShareTest, RecordingsBelongToTheProjectOnceEach) {
  openRelief();
  const QString log = writeFile("touch.csv", "what was felt");
  note(log);
  ASSERT_EQ(window().project().recordings.size(), 1U);
  EXPECT_EQ(window().project().recordings[0].file, log.toStdString());
  EXPECT_EQ(window().project().recordings[0].sha256.size(), 64U);
  window().controllers().replays.noteRecording(log);
  note(writeFile("more.csv", "and more"));
  EXPECT_EQ(window().project().recordings.size(), 2U);
  window().saveProject(path("p.relievo.json"));
  EXPECT_EQ(readProject(path("p.relievo.json").toStdString()).recordings.size(), 2U);
}

TEST_F(ShareTest, APackageForCitationIsMadeInTheDialog) {
  openRelief();
  saveImage("fig.png");
  note(writeFile("touch.csv", "what was felt"));
  const QString raster = writeFile("firm.asc", "where it is firm");
  window().controllers().packages.setDependencies(
      [&](const fs::path& recording, bool scans, const Task&) {
        EXPECT_EQ(recording.filename(), "touch.csv");
        EXPECT_TRUE(scans);
        const std::string file = raster.toStdString();
        return std::vector<InputFile>{{.file = file, .sha256 = sha256OfFile(file)}};
      });
  window().runCommand("package");
  auto* dialog = child<PackageDialog>("package_dialog");
  ASSERT_NE(dialog, nullptr);
  auto* files = dialog->findChild<QListWidget*>("package_files");
  ASSERT_EQ(files->count(), 2);
  EXPECT_EQ(files->item(0)->text(), "Recording touch.csv");
  EXPECT_EQ(files->item(1)->text(), "Figure fig.png");
  auto* file = dialog->findChild<QLineEdit*>("package_file");
  EXPECT_TRUE(file->text().endsWith("relief-package.zip")) << file->text().toStdString();
  file->clear();
  EXPECT_FALSE(dialog->findChild<QPushButton*>("package_save")->isEnabled());
  file->setText(path("cite"));
  QTest::mouseClick(dialog->findChild<QPushButton*>("package_save"), Qt::LeftButton);
  finishPacking();
  EXPECT_EQ(window().message(), QString());
  EXPECT_TRUE(status().startsWith("cite.zip is packed: 6 file")) << status().toStdString();
  const fs::path folder = unpacked(path("cite.zip"));
  for (const char* name : {"input/relief.ply", "recordings/touch.csv", "recordings/firm.asc",
                           "figures/fig.png", "README.txt", "project.json"}) {
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  const Project packed = readProject(folder / "project.json");
  EXPECT_EQ(packed.region, document().project().region);
  EXPECT_EQ(packed.recordings.size(), 1U);
}

TEST_F(ShareTest, ThePackageOpensWhereverItIsTaken) {
  openRelief();
  document().region().setRect({40, 40, 60, 60});
  const Region region = document().project().region;
  window().controllers().packages.write({path("cite.zip"), true, {}, {}});
  ASSERT_TRUE(waitFor([&] { return !window().controllers().packages.busy(); }));
  fs::create_directories(path("elsewhere").toStdString());
  ASSERT_TRUE(QFile::rename(path("cite.zip"), path("elsewhere/cite.zip")));
  ASSERT_TRUE(QFile::remove(path("relief.ply")));
  for (int times = 0; times < 2; ++times) {  // The second time it is there already.
    document().region().whole();
    window().open(path("elsewhere/cite.zip"));
    ASSERT_TRUE(waitFor([&] {
      return document().file() == path("elsewhere/cite/input/relief.ply") &&
             !document().loader().busy() && document().project().region == region;
    })) << window().message().toStdString()
        << document().file().toStdString();
    EXPECT_EQ(window().message(), QString());
  }
  EXPECT_FALSE(fs::exists(path("elsewhere/cite-2").toStdString()));
  for (const auto& entry : fs::directory_iterator(path("elsewhere").toStdString())) {
    EXPECT_NE(entry.path().filename().string().front(), '.') << "nothing half done stays";
  }
}

TEST_F(ShareTest, APackageThatWasChangedIsNotOpened) {
  openRelief();
  window().controllers().packages.write({path("cite.zip"), true, {}, {}});
  ASSERT_TRUE(waitFor([&] { return !window().controllers().packages.busy(); }));
  QFile zip(path("cite.zip"));
  ASSERT_TRUE(zip.open(QIODevice::ReadWrite));
  QByteArray bytes = zip.readAll();
  const int readme = bytes.indexOf("input/relief.ply") + 2000;
  bytes[readme] = static_cast<char>(bytes[readme] ^ 0x40);
  zip.seek(0);
  zip.write(bytes);
  zip.close();
  const QString before = document().file();
  window().open(path("cite.zip"));
  ASSERT_TRUE(waitFor([&] { return !window().message().isEmpty(); }));
  EXPECT_TRUE(window().message().contains("cite.zip")) << window().message().toStdString();
  EXPECT_EQ(document().file(), before);
  EXPECT_FALSE(fs::exists(path("cite").toStdString()));
}

TEST_F(ShareTest, AWindowThatIsClosedWritesItsPackageFirst) {
  openRelief();
  window().controllers().packages.write({path("p.zip"), true, {}, {}});
  ASSERT_TRUE(window().controllers().packages.busy());
  window().runCommand("quit");
  EXPECT_TRUE(window().isVisible());
  EXPECT_EQ(status(), "relievo closes when the package is written");
  EXPECT_TRUE(waitFor([&] { return !window().isVisible(); })) << "it closes by itself";
  EXPECT_TRUE(fs::exists(unpacked(path("p.zip")) / "project.json"));
}

TEST_F(ShareTest, AWindowDoesNotCloseOnAPackageThatFailed) {
  openRelief();
  window().controllers().packages.write({path("no/such/folder/p.zip"), true, {}, {}});
  window().close();
  finishPacking();
  EXPECT_TRUE(window().isVisible());
  EXPECT_TRUE(window().message().contains("could not be written"));
}

TEST_F(ShareTest, FiguresAreOfferedForAPackageAfterTheProjectIsOpenedAgain) {
  openRelief();
  window().saveProject(path("p.relievo.json"));
  EXPECT_FALSE(window().hasUnsavedWork());
  saveImage("fig.png");
  saveImage("gone.png");
  EXPECT_TRUE(window().hasUnsavedWork()) << "the project does not know them yet";
  window().saveProject(path("p.relievo.json"));
  QFile::remove(path("gone.png"));
  restart();
  window().open(path("p.relievo.json"));
  ASSERT_TRUE(waitFor([&] { return document().isOpen() && !document().loader().busy(); }));
  ASSERT_TRUE(waitFor([&] { return !window().project().figures.empty(); }));
  EXPECT_FALSE(window().hasUnsavedWork());
  window().runCommand("package");
  auto* dialog = child<PackageDialog>("package_dialog");
  ASSERT_NE(dialog, nullptr);
  auto* files = dialog->findChild<QListWidget*>("package_files");
  ASSERT_EQ(files->count(), 1) << "what is gone is not offered";
  EXPECT_EQ(files->item(0)->text(), "Figure fig.png");
  dialog->findChild<QLineEdit*>("package_file")->setText(path("cite.zip"));
  dialog->accept();
  finishPacking();
  const Project packed = readProject(unpacked(path("cite.zip")) / "project.json");
  ASSERT_EQ(packed.figures.size(), 1U);
  EXPECT_TRUE(fs::exists(packed.figures[0]));
}

TEST_F(ShareTest, WhatIsNotTickedStaysAway) {
  openRelief();
  saveImage("fig.png");
  window().runCommand("package");
  auto* dialog = child<PackageDialog>("package_dialog");
  ASSERT_NE(dialog, nullptr);
  QTest::mouseClick(dialog->findChild<QCheckBox*>("package_input"), Qt::LeftButton, Qt::NoModifier,
                    QPoint(6, 6));
  dialog->findChild<QListWidget*>("package_files")->item(0)->setCheckState(Qt::Unchecked);
  dialog->findChild<QLineEdit*>("package_file")->setText(path("bare.zip"));
  dialog->accept();
  finishPacking();
  const fs::path folder = unpacked(path("bare.zip"));
  EXPECT_FALSE(fs::exists(folder / "input"));
  EXPECT_FALSE(fs::exists(folder / "figures"));
  EXPECT_TRUE(fs::exists(folder / "project.json"));
}

TEST_F(ShareTest, APackageThatCannotBeMadeIsSaidAndLeavesNothing) {
  openRelief();
  window().controllers().packages.write({path("no/such/folder/p.zip"), true, {}, {}});
  finishPacking();
  EXPECT_TRUE(window().message().contains("could not be written"))
      << window().message().toStdString();
  saveImage("other.png");  // Carries the state of relief.ply.
  QFile::copy(path("relief.ply"), path("second.ply"));
  QFile more(path("second.ply"));
  ASSERT_TRUE(more.open(QIODevice::Append));
  more.write(" ");
  more.close();
  window().open(path("second.ply"));
  ASSERT_TRUE(waitFor([&] { return document().file().endsWith("second.ply"); }));
  window().controllers().packages.write({path("p.zip"), true, {path("other.png")}, {}});
  finishPacking();
  EXPECT_TRUE(window().message().contains("other.png is a recording of relief.ply"))
      << window().message().toStdString();
  EXPECT_FALSE(QFileInfo::exists(path("p.zip")));
}

TEST_F(ShareTest, NothingThatIsWrittenTakesThePlaceOfTheScan) {
  openRelief();
  const QString scan = document().file();
  const std::string before = sha256OfFile(scan.toStdString());
  const auto refused = [&](const QString& told) {
    EXPECT_TRUE(told.contains("is the scan itself. Nothing was written")) << told.toStdString();
    EXPECT_EQ(sha256OfFile(scan.toStdString()), before);
  };
  for (const ImageSource source : {ImageSource::detail, ImageSource::reference}) {
    window().showMessage("");
    window().saveImage(source, {64, 64}, scan);
    ASSERT_TRUE(waitFor([this] { return !window().savingImage(); }));
    refused(window().message());
  }
  window().saveProject(scan);
  refused(window().message());
  window().showMessage("");
  window().controllers().packages.write({scan, true, {}, {}});
  finishPacking();
  refused(window().message());
  try {
    window().findChild<MeasurePanel*>()->csv(scan);
    ADD_FAILURE() << "the list is made for the scan's name";
  } catch (const ArgumentError& error) {
    refused(error.what());
  }
}

TEST_F(ShareTest, RecordingsOfOtherFormatsTellTheirScanToo) {
  openRelief();
  Project touched;
  touched.file = "vase.stl";
  touched.sha256 = std::string(64, 'a');
  touched.region.side_mm = 10;
  std::string state = projectJson(touched);
  std::erase(state, '\n');  // A header's line.
  const auto log = openLog(path("other.h5").toStdString(), "relievo:state " + state);
  log->write({}, 0);
  log->close();
  window().controllers().packages.write({path("p.zip"), true, {path("other.h5")}, {}});
  finishPacking();
  EXPECT_TRUE(window().message().contains("other.h5 is a recording of vase.stl"))
      << window().message().toStdString();
  EXPECT_FALSE(QFileInfo::exists(path("p.zip")));
}

}  // namespace
}  // namespace relievo
