// SPDX-License-Identifier: BSD-3-Clause
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest/QTest>
#include <QUrl>

#include "tests/ui/gui_fixture.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/start_page.h"
#include "ui/prepare/prepare_dialog.h"

namespace relievo {
namespace {

class OpenTest : public GuiTest {
 protected:
  QStringList buttonsOfStrip() const {
    QStringList texts;
    for (const QPushButton* button :
         child<MessageStrip>("message_strip")->findChildren<QPushButton*>()) {
      if (!button->isHidden()) texts << button->text();
    }
    return texts;
  }
  QPushButton* stripButton(const QString& text) const {
    for (QPushButton* button : child<MessageStrip>("message_strip")->findChildren<QPushButton*>()) {
      if (button->text() == text && !button->isHidden()) return button;
    }
    return nullptr;
  }
  void drop(const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window(), &event);
  }
  bool settled() {
    return waitFor([this] { return !document().loader().busy(); });
  }
};

TEST_F(OpenTest, WithoutAFileThereIsAStartPage) {
  EXPECT_TRUE(child<StartPage>("start_page")->isVisible());
  EXPECT_FALSE(window().referenceView().isVisible());
  EXPECT_TRUE(child<QPushButton>("start_open")->isEnabled());
}

TEST_F(OpenTest, AScanOpensWholeWithBothViewsFilled) {
  openRelief();
  EXPECT_TRUE(window().referenceView().isVisible());
  EXPECT_TRUE(window().detailView().isVisible());
  EXPECT_EQ(document().detail(), 1);
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
  EXPECT_NE(window().referenceView().sceneState().grid, nullptr);
  EXPECT_TRUE(window().windowTitle().contains("relief.ply"));
}

TEST_F(OpenTest, ARegionBesideTheMapIsToldAndTheWholeMapIsShown) {
  OpenRequest request;
  request.file = writeRelief();
  request.unit = LengthUnit::mm;
  request.view = ViewChoice{"top", {}};
  request.region = RectMm{.x_mm = 900, .y_mm = 20, .width_mm = 50, .height_mm = 50};
  window().open(request);
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_EQ(window().message(), "There is nothing of the object in this region. Choose another.");
  EXPECT_EQ(document().project().region, wholeRegion(document().surface()->ladder));
  request.region->x_mm = 220;  // A part of it lies on the map.
  window().open(request);
  ASSERT_TRUE(waitFor([this] { return document().project().region.x_mm == 220; }));
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
}

TEST_F(OpenTest, AMissingFileIsSaidAboveTheViewsAndKeepsTheScanBefore) {
  openRelief();
  const DocumentState before = document().state();
  window().open(path("not_there.ply"));
  ASSERT_TRUE(settled());
  EXPECT_FALSE(window().message().isEmpty());
  EXPECT_EQ(document().state(), before);
  EXPECT_TRUE(window().detailView().isVisible());
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

TEST_F(OpenTest, ACutFileOffersItsCompletePointsAndLoadsThemOnRequest) {
  openRelief();
  const DocumentState before = document().state();
  QFile whole(writeRelief("whole.ply"));
  ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
  const QByteArray bytes = whole.readAll();
  QFile cut(path("cut.ply"));
  ASSERT_TRUE(cut.open(QIODevice::WriteOnly));
  cut.write(bytes.left(bytes.size() * 3 / 4));
  cut.close();
  window().open(cut.fileName());
  ASSERT_TRUE(settled());
  EXPECT_TRUE(window().message().contains("E101"));
  EXPECT_EQ(document().state(), before);
  QPushButton* load = stripButton("&Load what is there");
  ASSERT_NE(load, nullptr);
  QTest::mouseClick(load, Qt::LeftButton);
  ASSERT_TRUE(
      waitFor([&] { return !document().loader().busy() && document().file() == cut.fileName(); }));
  EXPECT_LT(document().surface()->info.points, before.surface->info.points);
}

TEST_F(OpenTest, AnUnknownUnitIsAskedForWithoutBlockingAndRememberedForTheFolder) {
  window().open(writeRelief());
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  EXPECT_TRUE(window().message().contains("E103"));
  EXPECT_EQ(document().surface()->unit_source, UnitSource::assumed);
  ASSERT_EQ(buttonsOfStrip().size(), 3);
  QTest::mouseClick(stripButton("Centimetres"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([this] { return document().surface()->unit == LengthUnit::cm; }));
  EXPECT_NEAR(document().surface()->map.widthMm(), 2500, 25);

  window().open(writeRelief("second.ply"));
  ASSERT_TRUE(waitFor([this] { return document().file().endsWith("second.ply"); }));
  EXPECT_EQ(document().surface()->unit, LengthUnit::cm);
  EXPECT_EQ(document().surface()->unit_source, UnitSource::remembered);
  EXPECT_TRUE(window().message().isEmpty());
}

TEST_F(OpenTest, TheFirstButtonOfAMessageIsPressedByItsKeyFromWhereverTheFocusIs) {
  EXPECT_FALSE(action("answer")->isEnabled());
  window().open(writeRelief());
  ASSERT_TRUE(waitFor([this] { return !window().message().isEmpty(); }));
  EXPECT_EQ(QApplication::focusWidget(), &window().detailView()) << "the hand keeps the keys";
  auto* strip = child<MessageStrip>("message_strip");
  const auto* key = child<QLabel>("message_key");
  EXPECT_TRUE(key->isVisible());
  EXPECT_EQ(key->text(), action("answer")->shortcut().toString(QKeySequence::NativeText));
  EXPECT_TRUE(strip->accessibleDescription().contains(key->text())) << "a screen reader says it";
  EXPECT_TRUE(strip->accessibleDescription().contains("Millimetres"));
  QTest::keyClick(&window().detailView(), Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(window().message().isEmpty());
  EXPECT_FALSE(action("answer")->isEnabled());
  ASSERT_TRUE(waitFor([this] { return document().surface()->unit_source != UnitSource::assumed; }));
  EXPECT_EQ(document().surface()->unit, LengthUnit::mm) << "the likely one comes first";
}

TEST_F(OpenTest, F6AndTabReachEveryButtonOfAMessage) {
  window().open(writeRelief());
  ASSERT_TRUE(waitFor([this] { return !window().message().isEmpty(); }));
  QTest::keyClick(&window().detailView(), Qt::Key_F6, Qt::ShiftModifier);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
  EXPECT_EQ(QApplication::focusWidget(), stripButton("Millimetres"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), stripButton("Centimetres"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), stripButton("Metres"));
}

TEST_F(OpenTest, ADroppedFileOpens) {
  drop({QUrl::fromLocalFile(writeRelief())});
  ASSERT_TRUE(waitFor([this] { return document().isOpen(); }));
}

TEST_F(OpenTest, SeveralDroppedFilesAreScansOfOneObject) {
  drop({QUrl::fromLocalFile(writeRelief("a.ply")), QUrl::fromLocalFile(writeRelief("b.ply"))});
  auto* dialog = window().findChild<PrepareDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(dialog->state().now().inputs.size(), 2U);
  dialog->reject();
  EXPECT_FALSE(document().isOpen());
}

TEST_F(OpenTest, DroppedFilesOfOtherComputersOpenNothingAndSaySo) {
  drop({QUrl::fromLocalFile(writeRelief()), QUrl("https://example.org/b.ply")});
  EXPECT_FALSE(document().loader().busy());
  EXPECT_TRUE(window().message().contains("Nothing was opened"));
}

TEST_F(OpenTest, RecentFilesAreOfferedAfterARestartTheNewestFirst) {
  openRelief();
  window().open(writeRelief("second.ply"));
  ASSERT_TRUE(waitFor([this] { return document().file().endsWith("second.ply"); }));
  restart();
  const QStringList recent = window().settings().recentFiles();
  ASSERT_EQ(recent.size(), 2);
  EXPECT_TRUE(recent[0].endsWith("second.ply"));
  QAction* entry = nullptr;
  for (QMenu* menu : window().findChildren<QMenu*>()) {
    for (QAction* a : menu->actions()) {
      if (a->text() == "&2 relief.ply") entry = a;
    }
  }
  ASSERT_NE(entry, nullptr);
  entry->trigger();
  EXPECT_TRUE(waitFor([this] { return document().file().endsWith("relief.ply"); }));
}

TEST_F(OpenTest, OnlyTenRecentFilesAreKept) {
  for (int i = 0; i < kRecentFiles + 5; ++i) {
    window().settings().addRecentFile(QStringLiteral("/tmp/scan%1.ply").arg(i));
  }
  EXPECT_EQ(window().settings().recentFiles().size(), kRecentFiles);
  EXPECT_EQ(window().settings().recentFiles().front(), "/tmp/scan14.ply");
}

TEST_F(OpenTest, SafeModeReadsAndKeepsNothing) {
  window().settings().addRecentFile("/tmp/scan.ply");
  Settings safe(Settings::Mode::safe);
  EXPECT_TRUE(safe.recentFiles().isEmpty());
  safe.addRecentFile("/tmp/other.ply");
  EXPECT_EQ(Settings().recentFiles(), QStringList{"/tmp/scan.ply"});
}

TEST_F(OpenTest, EscapeCancelsOpeningAndKeepsWhatWasShown) {
  openRelief();
  const DocumentState before = document().state();
  QSignalSpy cancelled(&document().loader(), &SurfaceLoader::cancelled);
  window().open(writeRelief("second.ply"));
  ASSERT_TRUE(document().loader().busy());
  QTest::keyClick(&window().detailView(), Qt::Key_Escape);
  EXPECT_FALSE(document().loader().busy());
  EXPECT_EQ(cancelled.size(), 1);
  EXPECT_EQ(document().state(), before);
}

TEST_F(OpenTest, ANewerRequestTakesThePlaceOfTheOlder) {
  window().open(writeRelief("first.ply"));
  window().open(writeRelief("second.ply"));
  ASSERT_TRUE(settled());
  EXPECT_TRUE(document().file().endsWith("second.ply"));
}

}  // namespace
}  // namespace relievo
