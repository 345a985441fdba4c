// SPDX-License-Identifier: BSD-3-Clause
// Projects from elsewhere: the window asks before it reads what they name outside of their folder.
#include <algorithm>
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest/QTest>

#include "core/project/project.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/package_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

class ForeignFiles : public GuiTest {
 protected:
  void SetUp() override {
    QDir().mkpath(path("work"));
    openRelief();
    window().saveProject(projectFile());
    QFile secret(path("secret.csv"));
    ASSERT_TRUE(secret.open(QIODevice::WriteOnly));
    secret.write("my password is 1234\n");
    secret.close();
    restart();
  }
  QString projectFile() const { return path("work/p.relievo.json"); }
  Project stored() const { return readProject(bytesOfPath(projectFile())); }
  void store(const Project& project) const { writeProject(bytesOfPath(projectFile()), project); }
  QMessageBox* question() { return window().findChild<QMessageBox*>("foreign_dialog"); }
  QMessageBox* openAndWaitForQuestion() {
    window().open(projectFile());
    EXPECT_TRUE(waitFor([this] { return question() != nullptr && question()->isVisible(); }));
    return question();
  }
  bool opens() {
    return waitFor([this] { return document().isOpen() && !document().loader().busy(); });
  }
};

TEST_F(ForeignFiles, OnesOwnProjectOpensThoughItsScanIsElsewhere) {
  window().open(projectFile());
  ASSERT_TRUE(opens());
  EXPECT_EQ(question(), nullptr);
  EXPECT_EQ(window().message(), QString());
}

TEST_F(ForeignFiles, AScanThatIsNotTheProjectsIsReadOnlyIfSomebodySaysSo) {
  Project hostile = stored();
  hostile.sha256 = std::string(64, '0');
  store(hostile);
  QMessageBox* box = openAndWaitForQuestion();
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(box->isModal());
  EXPECT_TRUE(box->text().contains(path("relief.ply"))) << box->text().toStdString();
  EXPECT_EQ(box->defaultButton(), box->button(QMessageBox::No));
  QTest::keyClick(box, Qt::Key_Return);
  ASSERT_TRUE(waitFor([this] { return !window().message().isEmpty(); }));
  EXPECT_TRUE(window().message().contains("was not read")) << window().message().toStdString();
  EXPECT_FALSE(document().isOpen() || document().loader().busy());
  ASSERT_TRUE(waitFor([this] { return question() == nullptr; }));

  box = openAndWaitForQuestion();
  ASSERT_NE(box, nullptr);
  QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
  EXPECT_TRUE(opens());
}

TEST_F(ForeignFiles, WhatIsNotReadStaysNamedAndIsNotPacked) {
  Project hostile = stored();
  const std::string secret = bytesOfPath(path("secret.csv"));
  hostile.recordings = {{.file = secret, .sha256 = std::string(64, '0')}};
  hostile.figures = {secret};
  hostile.figure.recording = secret;
  store(hostile);
  QMessageBox* box = openAndWaitForQuestion();
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->text().count("secret.csv"), 1) << box->text().toStdString();
  QTest::keyClick(box, Qt::Key_Escape);
  ASSERT_TRUE(opens()) << "the rest opens";
  ASSERT_TRUE(waitFor([this] { return window().message().contains("were not read"); }))
      << window().message().toStdString();
  const Project kept = window().project();
  ASSERT_EQ(kept.recordings.size(), 1U) << "nothing is lost";
  EXPECT_EQ(kept.recordings[0].file, secret);
  EXPECT_EQ(kept.figures, std::vector<std::string>{secret});
  EXPECT_EQ(kept.figure.recording, secret);

  ASSERT_TRUE(window().runCommand("package"));
  auto* dialog = window().findChild<PackageDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->choice().recordings.isEmpty());
  EXPECT_TRUE(dialog->choice().figures.isEmpty());
  dialog->reject();
}

TEST_F(ForeignFiles, AfterAYesTheyArePackedLikeOthers) {
  Project project = stored();
  const std::string other = bytesOfPath(path("secret.csv"));
  project.recordings = {{.file = other, .sha256 = std::string(64, '0')}};
  store(project);
  QMessageBox* box = openAndWaitForQuestion();
  ASSERT_NE(box, nullptr);
  QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
  ASSERT_TRUE(opens());
  ASSERT_TRUE(window().runCommand("package"));
  auto* dialog = window().findChild<PackageDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->choice().recordings, QStringList{path("secret.csv")});
  dialog->reject();
}

TEST_F(ForeignFiles, APictureIsAskedAboutLikeAProject) {
  Project hostile = stored();
  hostile.sha256.clear();
  hostile.bytes = 0;
  hostile = relativeTo(hostile, bytesOfPath(path("work/p.csv")));
  std::string state = projectJson(hostile);
  state.erase(std::remove(state.begin(), state.end(), '\n'), state.end());
  QFile table(path("work/p.csv"));
  ASSERT_TRUE(table.open(QIODevice::WriteOnly));
  table.write(QByteArray::fromStdString("# relievo:state " + state + "\nx_mm,z_mm\n0,0\n"));
  table.close();
  window().open(path("work/p.csv"));
  ASSERT_TRUE(waitFor([this] { return question() != nullptr && question()->isVisible(); }));
  QTest::keyClick(question(), Qt::Key_Return);
  EXPECT_FALSE(document().isOpen() || document().loader().busy());
}

}  // namespace
}  // namespace relievo
