// SPDX-License-Identifier: BSD-3-Clause
// What a screen reader is told, and that it is told again where a window that gets the keyboard
// back would be read over it.
#include "ui/frame/announcer.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QTest>
#include <string>
#include <vector>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

using ::testing::ElementsAre;

class AnnouncerTest : public GuiTest {
 protected:
  void SetUp() override {
    frame_.setCentralWidget(field_);
    QObject::connect(&announcer_, &Announcer::told,
                     [this] { told_.push_back(announcer_.text().toStdString()); });
    frame_.show();
    comeBack();
    QTest::qWait(1500);  // Longer than anything is at once.
    told_.clear();
  }
  /// As a dialog that was answered leaves it.
  void comeBack() {
    QApplication::setActiveWindow(&frame_);
    field_->setFocus();
  }
  void openDialog() {
    dialog_.show();
    QApplication::setActiveWindow(&dialog_);
    in_dialog_->setFocus();
    QTest::qWait(1500);
    told_.clear();
  }

  QMainWindow frame_;
  QLineEdit* field_ = new QLineEdit;
  Announcer announcer_{&frame_};
  QDialog dialog_;
  QLineEdit* in_dialog_ = new QLineEdit(&dialog_);
  std::vector<std::string> told_;
};

TEST_F(AnnouncerTest, SaysEachThingOnceWhereTheKeyboardStays) {
  announcer_.say("Forces on.");
  EXPECT_THAT(told_, ElementsAre("Forces on."));
  QTest::qWait(1500);
  EXPECT_EQ(told_.size(), 1U);
}

TEST_F(AnnouncerTest, SaysAgainWhatWasSaidAsADialogClosed) {
  for (const bool said_first : {true, false}) {
    openDialog();
    if (said_first) announcer_.say("profile.csv is saved");
    dialog_.hide();
    comeBack();
    if (!said_first) announcer_.say("profile.csv is saved");
    EXPECT_EQ(told_.size(), 1U) << "at once";
    EXPECT_TRUE(waitFor([this] { return told_.size() == 2; })) << "and when the window was read";
    EXPECT_EQ(told_.back(), "profile.csv is saved");
    QTest::qWait(1500);
    EXPECT_EQ(told_.size(), 2U) << "no more";
  }
}

TEST_F(AnnouncerTest, SaysOnlyTheNewestAgain) {
  openDialog();
  announcer_.say("one.csv is saved");
  dialog_.hide();
  comeBack();
  announcer_.say("Recording.");
  EXPECT_TRUE(waitFor([this] { return told_.size() == 3; }));
  EXPECT_THAT(told_, ElementsAre("one.csv is saved", "Recording.", "Recording."));
}

}  // namespace
}  // namespace relievo
