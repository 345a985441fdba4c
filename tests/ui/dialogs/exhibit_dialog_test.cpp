// SPDX-License-Identifier: BSD-3-Clause
// The dialog in which a curator makes an exhibit.
#include "ui/dialogs/exhibit/exhibit_dialog.h"

#include <fstream>
#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/exhibit/exhibit_objects_page.h"

namespace relievo {
namespace {

const std::vector<std::string> kKnown{"en", "de", "hi"};

class ExhibitDialogTest : public GuiTest {
 protected:
  ExhibitDialog& dialog() {
    if (auto* const shown = window().findChild<ExhibitDialog*>()) return *shown;
    EXPECT_TRUE(window().runCommand(QStringLiteral("exhibit_setup")));
    return *window().findChild<ExhibitDialog*>();
  }
  template <class Part>
  Part& part(const char* name) {
    return *dialog().findChild<Part*>(QString::fromLatin1(name));
  }
  QStringList faults() {
    QStringList said;
    auto& list = part<QListWidget>("exhibit_faults");
    for (int row = 0; row < list.count(); ++row) said << list.item(row)->text();
    return said;
  }
  void type(const char* field, const char* text) {
    auto& line = part<QLineEdit>(field);
    line.setFocus();
    line.clear();
    QTest::keyClicks(&line, QString::fromUtf8(text));
  }
  std::filesystem::path file(const char* name) const { return path(name).toStdString(); }
  /// An exhibit that is whole, of the relief that is open.
  void makeWhole() {
    openRelief();
    type("exhibit_title_en", "A dome on a plate");
    type("exhibit_pin", "2580");
  }
};

TEST_F(ExhibitDialogTest, MakesAnExhibitThatIsReadAsItWasMade) {
  openRelief();
  EXPECT_EQ(faults(), (QStringList{"Object 1: Title, English has no words.",
                                   "New PIN of the staff is missing."}))
      << "begins with what is open";
  part<QCheckBox>("exhibit_language_de").click();
  type("exhibit_title_en", "A dome on a plate");
  type("exhibit_title_de", "Kuppel");
  part<QPlainTextEdit>("exhibit_description_en").setPlainText("Round, and 12 mm high.");
  EXPECT_TRUE(faults().contains("Object 1: Description, Deutsch has no words."));
  part<QPlainTextEdit>("exhibit_description_de").setPlainText("Rund.");
  auto& first = part<QComboBox>("exhibit_first_language");
  first.setCurrentIndex(first.findData("de"));
  part<QDoubleSpinBox>("exhibit_chime").setValue(0);
  part<QSpinBox>("exhibit_volume").setValue(60);
  part<QSpinBox>("exhibit_loudest").setValue(80);
  EXPECT_EQ(part<QSpinBox>("exhibit_room_loudest").text(), "The same");
  part<QSpinBox>("exhibit_room_loudest").setValue(65);
  part<QComboBox>("exhibit_device").setEditText("falcon");
  part<QDoubleSpinBox>("exhibit_limit").setValue(2.5);
  part<QCheckBox>("exhibit_guide").click();
  type("exhibit_pin", "258");
  EXPECT_EQ(faults(), QStringList{"New PIN of the staff is missing."}) << "three digits are none";
  type("exhibit_pin", "2580");
  EXPECT_TRUE(faults().isEmpty());
  EXPECT_TRUE(dialog().isUnsaved());

  ASSERT_TRUE(dialog().save(path("museum.json")));
  EXPECT_FALSE(dialog().isUnsaved());
  EXPECT_TRUE(waitFor([&] {
    return part<QLabel>("exhibit_state").text().contains("relievo --exhibit '");
  })) << "once the relief was opened";
  const Exhibit made = readExhibit(file("museum.json"), kKnown);
  EXPECT_EQ(made.languages, (std::vector<std::string>{"de", "en"}));
  ASSERT_EQ(made.objects.size(), 1U);
  EXPECT_EQ(made.objects[0].file, file("relief.ply"));
  EXPECT_EQ(made.objects[0].unit, LengthUnit::mm) << "as it is shown";
  EXPECT_EQ(made.objects[0].view, "top");
  EXPECT_EQ(made.objects[0].title.at("de"), "Kuppel");
  EXPECT_EQ(made.objects[0].description.at("en"), "Round, and 12 mm high.");
  EXPECT_EQ(made.times.chime_s, 0);
  EXPECT_EQ(made.speech.volume_percent, 60);
  EXPECT_EQ(made.speech.loudest_percent, 80);
  EXPECT_EQ(made.speech.room_loudest_percent, 65);
  EXPECT_EQ(made.touch.device, "falcon");
  EXPECT_EQ(made.touch.limit_n, 2.5);
  EXPECT_FALSE(made.touch.guide);
  EXPECT_EQ(made.pin.sha256, staffPinOf("2580", made.pin.salt).sha256);
  std::ifstream in(file("museum.json"));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("\"relief.ply\""), std::string::npos) << "from its own folder: " << text;
  EXPECT_EQ(text.find("2580"), std::string::npos);
}

TEST_F(ExhibitDialogTest, ChangesAnExhibitThatIsThere) {
  makeWhole();
  ASSERT_TRUE(dialog().save(path("museum.json")));
  const Exhibit before = readExhibit(file("museum.json"), kKnown);
  part<QSpinBox>("exhibit_strength").setValue(77);
  dialog().openFile(path("museum.json"));
  EXPECT_EQ(part<QSpinBox>("exhibit_strength").value(), before.touch.strength_percent);
  EXPECT_FALSE(dialog().isUnsaved());
  part<QSpinBox>("exhibit_strength").setValue(25);
  ASSERT_TRUE(dialog().save(path("museum.json")));
  const Exhibit after = readExhibit(file("museum.json"), kKnown);
  EXPECT_EQ(after.touch.strength_percent, 25);
  EXPECT_EQ(after.pin.sha256, before.pin.sha256) << "no other was typed";
  EXPECT_EQ(after.objects[0].title, before.objects[0].title);
}

TEST_F(ExhibitDialogTest, ObjectsAreAddedMovedAndTakenOut) {
  makeWhole();
  auto* objects = dialog().findChild<ExhibitObjectsPage*>();
  objects->add({writeRelief(QStringLiteral("second.ply")), path("gone.ply")});
  auto& list = part<QListWidget>("exhibit_objects");
  EXPECT_EQ(list.count(), 3);
  EXPECT_EQ(list.currentRow(), 2);
  part<QPushButton>("exhibit_up").click();
  EXPECT_EQ(list.item(1)->text(), "gone.ply");
  EXPECT_TRUE(faults().join(' ').contains("Object 2: File: there is no file"));
  EXPECT_EQ(part<QLineEdit>("exhibit_file").text(), path("gone.ply"));
  part<QPushButton>("exhibit_remove").click();
  EXPECT_EQ(list.count(), 2);
  EXPECT_EQ(dialog().exhibit().objects[1].file, file("second.ply"));
  EXPECT_EQ(part<QLineEdit>("exhibit_file").text(), path("second.ply")) << "the one that follows";
  EXPECT_EQ(faults(), QStringList{"Object 2: Title, English has no words."});
  for (int i = 0; i < 2; ++i) part<QPushButton>("exhibit_remove").click();
  EXPECT_EQ(faults(), QStringList{"Objects is empty."});
  EXPECT_FALSE(part<QLineEdit>("exhibit_title_en").isEnabled());
}

TEST_F(ExhibitDialogTest, AFaultLeadsToItsPlace) {
  makeWhole();
  part<QCheckBox>("exhibit_language_hi").click();
  auto& pages = part<QTabWidget>("exhibit_pages");
  pages.setCurrentIndex(1);
  auto& list = part<QListWidget>("exhibit_faults");
  ASSERT_EQ(list.count(), 1);
  Q_EMIT list.itemActivated(list.item(0));
  EXPECT_EQ(pages.currentIndex(), 0);
  EXPECT_TRUE(part<QLineEdit>("exhibit_title_hi").isVisible());
  EXPECT_EQ(dialog().focusWidget(), &part<QLineEdit>("exhibit_title_hi"));
  part<QSpinBox>("exhibit_volume").setValue(80);
  part<QSpinBox>("exhibit_loudest").setValue(20);
  ASSERT_EQ(list.count(), 2);
  EXPECT_EQ(faults().back(), "Volume of a new visitor is 80, above Loudest, which is 20.");
  Q_EMIT list.itemActivated(list.item(1));
  EXPECT_EQ(pages.currentIndex(), 1);
  EXPECT_EQ(dialog().focusWidget(), &part<QSpinBox>("exhibit_volume"));
}

TEST_F(ExhibitDialogTest, AnObjectThatCannotBeOpenedIsSaid) {
  makeWhole();
  const auto write = [this](const char* points) {
    QFile scan(path("cut.ply"));
    ASSERT_TRUE(scan.open(QIODevice::WriteOnly));
    scan.write(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n");
    scan.write(points);
  };
  write("0 0 0\n1 0 0\n");
  type("exhibit_file", path("cut.ply").toUtf8().constData());
  ASSERT_TRUE(waitFor([this] { return faults().size() == 1; }));
  EXPECT_TRUE(faults().front().contains("cut.ply")) << faults().join(' ').toStdString();
  EXPECT_TRUE(part<QLabel>("exhibit_state").text().contains("cannot be shown yet"));
  auto& list = part<QListWidget>("exhibit_faults");
  Q_EMIT list.itemActivated(list.item(0));
  EXPECT_EQ(dialog().focusWidget(), &part<QLineEdit>("exhibit_file"));

  write("0 0 0\n1 0 0\n0 1 0.5\n");
  QFile scan(path("cut.ply"));
  ASSERT_TRUE(scan.open(QIODevice::ReadWrite));
  scan.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime);
  scan.close();
  part<QSpinBox>("exhibit_strength").setValue(25);
  EXPECT_TRUE(waitFor([this] { return faults().isEmpty(); })) << "mended, and opened again";
}

TEST_F(ExhibitDialogTest, WhatIsInNoFileIsAskedAbout) {
  makeWhole();
  dialog().reject();
  auto* asked = dialog().findChild<QMessageBox*>("exhibit_unsaved");
  ASSERT_NE(asked, nullptr);
  asked->button(QMessageBox::Cancel)->click();
  EXPECT_TRUE(dialog().isVisible());
  ASSERT_TRUE(dialog().save(path("museum.json")));
  dialog().reject();
  EXPECT_FALSE(dialog().isVisible());
}

TEST_F(ExhibitDialogTest, AFileWithFaultsIsShownAndSaid) {
  makeWhole();
  ASSERT_TRUE(dialog().save(path("museum.json")));
  QFile written(path("museum.json"));
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  QByteArray text = written.readAll();
  written.close();
  text.replace("\"loudest_percent\": 100", "\"loudest_percent\": 500");
  ASSERT_TRUE(written.open(QIODevice::WriteOnly));
  written.write(text);
  written.close();
  dialog().openFile(path("museum.json"));
  EXPECT_TRUE(part<QLabel>("exhibit_problem").text().contains("must be from 10 to 100"))
      << part<QLabel>("exhibit_problem").text().toStdString();
  EXPECT_EQ(part<QSpinBox>("exhibit_loudest").value(), 100);
  EXPECT_TRUE(dialog().isUnsaved()) << "saved it would say something else";
  type("exhibit_title_en", "Another title");
  ASSERT_TRUE(written.open(QIODevice::WriteOnly));
  written.write("no exhibit");
  written.close();
  dialog().openFile(path("museum.json"));
  EXPECT_TRUE(part<QLabel>("exhibit_problem").text().contains("museum.json is not JSON"));
  EXPECT_EQ(dialog().exhibit().objects[0].title.at("en"), "Another title") << "stays";
  EXPECT_FALSE(dialog().save(path("no/such/folder/museum.json")));
  EXPECT_TRUE(part<QLabel>("exhibit_problem").text().contains("Cannot write"));
}

}  // namespace
}  // namespace relievo
