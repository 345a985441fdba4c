// SPDX-License-Identifier: BSD-3-Clause
// The window is told to end, from outside or by Ctrl+Q, while something is written: what is there
// afterwards is whole, and nothing else is.
#include <QDir>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest/QTest>

#include "core/project/package.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/dialogs/package_dialog.h"

namespace relievo {
namespace {

/// How long it is written until the end comes: before, at the beginning, and in the middle on one
/// computer or another. Whatever is met must hold.
constexpr int kMoments[] = {0, 5, 30, 120, 400};

class EndedTest : public GuiTest {
 protected:
  /// All that lies in a folder, hidden files too.
  QStringList left(const QString& folder) const {
    return QDir(path(folder)).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
  }
  QString freshFolder(int moment) {
    const QString folder = QStringLiteral("at-%1").arg(moment);
    EXPECT_TRUE(QDir().mkpath(path(folder)));
    return folder;
  }
  void beginFigure(const QString& file) {
    EXPECT_TRUE(window().runCommand("figure"));
    auto* dialog = window().findChildren<FigureDialog*>().last();
    ASSERT_TRUE(
        waitFor([&] { return dialog->findChild<QPushButton*>("figure_save")->isEnabled(); }));
    dialog->findChild<QDoubleSpinBox*>("figure_dpi")->setValue(600);
    dialog->findChild<QLineEdit*>("figure_file")->setText(file);
    QTest::mouseClick(dialog->findChild<QPushButton*>("figure_save"), Qt::LeftButton);
  }
};

TEST_F(EndedTest, FromOutsideAFigureIsWholeOrNotThere) {
  for (const int moment : kMoments) {
    const QString folder = freshFolder(moment);
    openRelief();
    beginFigure(path(folder + "/f.png"));
    QTest::qWait(moment);
    window().endAtOnce();
    restart();  // Joins what was at work.
    const QStringList files = left(folder);
    EXPECT_LE(files.size(), 1) << files.join(' ').toStdString();
    if (files.isEmpty()) continue;
    EXPECT_EQ(files.front(), "f.png");
    EXPECT_FALSE(QImage(path(folder + "/f.png")).isNull()) << "at " << moment;
  }
}

TEST_F(EndedTest, FromOutsideAPackageIsWholeOrNotThere) {
  for (const int moment : kMoments) {
    const QString folder = freshFolder(moment);
    openRelief();
    window().controllers().packages.write({path(folder + "/p.zip"), true, {}, {}});
    QTest::qWait(moment);
    window().endAtOnce();
    restart();
    const QStringList files = left(folder);
    EXPECT_LE(files.size(), 1) << files.join(' ').toStdString();
    if (files.isEmpty()) continue;
    EXPECT_TRUE(verifyPackage(path(folder + "/p.zip").toStdString()).problems.empty());
  }
}

TEST_F(EndedTest, AFigureThatIsBeingWrittenIsNotLeftByCtrlQ) {
  openRelief();
  const QString folder = freshFolder(0);
  beginFigure(path(folder + "/f.png"));
  auto* dialog = window().findChildren<FigureDialog*>().last();
  QTest::keyClick(dialog, Qt::Key_Q, Qt::ControlModifier);
  EXPECT_TRUE(window().isVisible()) << "the dialog is answered first";
  ASSERT_TRUE(waitFor([&] { return left(folder) == QStringList{"f.png"}; }));
  EXPECT_FALSE(QImage(path(folder + "/f.png")).isNull());
}

TEST_F(EndedTest, AClosedWindowWaitsForItsPackageWhateverIsStillAsked) {
  for (const int moment : kMoments) {
    const QString folder = freshFolder(moment);
    openRelief();
    window().controllers().packages.write({path(folder + "/p.zip"), true, {}, {}});
    QTest::qWait(moment);
    window().close();
    ASSERT_TRUE(waitFor([&] { return !window().isVisible(); }));
    EXPECT_EQ(left(folder), QStringList{"p.zip"});
    EXPECT_TRUE(verifyPackage(path(folder + "/p.zip").toStdString()).problems.empty());
    restart();
  }
}

}  // namespace
}  // namespace relievo
