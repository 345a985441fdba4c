// SPDX-License-Identifier: BSD-3-Clause
// A sitting of a study, by the window.
#include <QAction>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QtTest/QTest>
#include <QUndoStack>

#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/study_dialog.h"
#include "ui/window/controllers.h"

namespace relievo {
namespace {

class StudyWindowTest : public GuiTest {
 protected:
  StudyWindowTest() {
    openRelief();
    document().edit("Places", [](Project& p) {
      Region region = p.region;
      region.side_mm = 50;
      region.level = Level{0};
      for (const char* name : {"fine dome", "plain corner", "the edge"}) {
        region.x_mm += 20;
        p.places.push_back({.name = name, .region = region});
      }
      p.places.push_back({.name = "Marker 1", .region = region, .is_point = true});
    });
    study().setSeed(11);
  }
  StudyController& study() { return window().controllers().study; }
  QString said() const { return child<QLabel>("status_message")->text(); }
  QString textOf(const QString& name) const {
    QFile file(path("study/P-07/sitting_01/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  }
  StudyDialog* dialog() {
    action("study")->trigger();
    return window().findChild<StudyDialog*>();
  }
  void begin() {
    StudyDialog* asked = dialog();
    ASSERT_NE(asked, nullptr);
    asked->findChild<QLineEdit*>("study_participant")->setText("P-07");
    asked->findChild<QCheckBox*>("study_agreed")->setChecked(true);
    asked->findChild<QLineEdit*>("study_consent")->setText("Form 3");
    asked->findChild<QLineEdit*>("study_folder")->setText(path("study"));
    asked->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  }
};

TEST_F(StudyWindowTest, NothingBeginsWithoutCodeConsentAndConditions) {
  StudyDialog* asked = dialog();
  ASSERT_NE(asked, nullptr);
  auto* ok = asked->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  auto* missing = asked->findChild<QLabel*>("study_missing");
  auto* places = asked->findChild<QListWidget*>("study_conditions");
  EXPECT_EQ(places->count(), 3) << "a marker is no condition";
  EXPECT_FALSE(ok->isEnabled());
  asked->findChild<QLineEdit*>("study_participant")->setText("Anna M");
  EXPECT_TRUE(missing->text().contains("code"));
  asked->findChild<QLineEdit*>("study_participant")->setText("P-07");
  EXPECT_TRUE(missing->text().contains("agreed"));
  asked->findChild<QCheckBox*>("study_agreed")->setChecked(true);
  asked->findChild<QLineEdit*>("study_consent")->setText("Form 3");
  asked->findChild<QLineEdit*>("study_folder")->setText(path("study"));
  EXPECT_TRUE(ok->isEnabled()) << missing->text().toStdString();
  places->item(0)->setCheckState(Qt::Unchecked);
  places->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(ok->isEnabled());
  asked->reject();
  EXPECT_FALSE(QDir(path("study")).exists());
}

TEST_F(StudyWindowTest, ShowsEachConditionUnderItsLetterAndKeepsTheTable) {
  begin();
  ASSERT_TRUE(study().running());
  EXPECT_TRUE(said().startsWith("Condition ")) << said().toStdString();
  EXPECT_TRUE(said().endsWith(", 1 of 3."));
  EXPECT_EQ(study().folder(), path("study/P-07/sitting_01"));
  EXPECT_TRUE(study().recordingName().startsWith("trial_01_"));
  EXPECT_EQ(document().project().region.side_mm, 50) << "a place is shown";
  std::vector<Region> shown{document().project().region};
  QTest::keyClick(&window(), Qt::Key_N, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(said().endsWith(", 2 of 3."));
  shown.push_back(document().project().region);
  action("study_next")->trigger();
  shown.push_back(document().project().region);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(shown[i] == shown[k]);
  }
  for (const char* name : {"fine", "plain", "edge"}) {
    EXPECT_FALSE(said().contains(name));
    for (int i = 0; i < document().history().count(); ++i) {
      if (document().history().text(i) == "Places") continue;
      EXPECT_FALSE(document().history().text(i).contains(name)) << "blinded";
    }
    EXPECT_FALSE(textOf("sitting.json").contains(name)) << name;
    EXPECT_TRUE(textOf("key.json").contains(name)) << name;
  }
  action("study_next")->trigger();
  EXPECT_FALSE(study().running());
  EXPECT_TRUE(said().startsWith("All 3 conditions were shown.")) << said().toStdString();
  const QStringList rows = textOf("trials.csv").split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(rows.size(), 4);
  for (int i = 1; i < 4; ++i) {
    EXPECT_TRUE(rows[i].startsWith(QString::number(i) + ','));
    EXPECT_EQ(rows[i].count('Z'), 2) << "began and ended: " << rows[i].toStdString();
  }
}

TEST_F(StudyWindowTest, ARecordingBelongsToItsConditionAndHoldsTheNext) {
  begin();
  TouchReadout readout;
  readout.recording = true;
  study().follow(readout);
  action("study_next")->trigger();
  EXPECT_TRUE(said().startsWith("Stop the recording first")) << said().toStdString();
  EXPECT_TRUE(study().recordingName().startsWith("trial_01_"));
  readout.recording = false;
  study().follow(readout);
  study().noteRecording(study().folder() + "/trial_01_X_001.csv");
  study().noteRecording(path("elsewhere.csv"));
  EXPECT_TRUE(textOf("trials.csv").contains("trial_01_X_001.csv"));
  EXPECT_FALSE(textOf("trials.csv").contains("elsewhere"));
  action("study_end")->trigger();
  EXPECT_FALSE(study().running());
  EXPECT_TRUE(said().startsWith("The sitting ended after 1 of 3 conditions."));
  EXPECT_FALSE(action("study_next")->isEnabled());
}

TEST_F(StudyWindowTest, AnotherFileEndsTheSitting) {
  begin();
  OpenRequest request;
  request.file = writeRelief(QStringLiteral("other.ply"));
  window().open(request);
  ASSERT_TRUE(
      waitFor([&] { return !document().loader().busy() && document().file() == request.file; }));
  EXPECT_FALSE(study().running());
  EXPECT_EQ(textOf("trials.csv").count('\n'), 2) << "what was shown is kept";
}

}  // namespace
}  // namespace relievo
