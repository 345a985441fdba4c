// SPDX-License-Identifier: BSD-3-Clause
// What an opened file leaves open is asked above the views, and answered by keys.
#include <cmath>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QPushButton>
#include <QtTest/QTest>
#include <QUndoStack>

#include "tests/ui/gui_fixture.h"
#include "ui/frame/message_strip.h"

namespace relievo {
namespace {

class QuestionsTest : public GuiTest {
 protected:
  QList<QPushButton*> buttons() const {
    QList<QPushButton*> shown;
    for (QPushButton* button : child<MessageStrip>("message_strip")->findChildren<QPushButton*>()) {
      if (!button->isHidden()) shown << button;
    }
    return shown;
  }
  QString written(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
  /// 60 x 50 points, 1 mm apart, and lines of one's own.
  QString relief(const QByteArray& more, double first_height = 5) const {
    QByteArray text;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 60; ++x) {
        const double z = x + y == 0 ? first_height : 5 + 3 * std::sin(x / 7.0) * std::cos(y / 5.0);
        text += QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' + QByteArray::number(z) +
                '\n';
      }
    }
    return written(QStringLiteral("relief.xyz"), text + more);
  }
  void openAs(const QString& file, std::optional<LengthUnit> unit) {
    OpenRequest request;
    request.file = file;
    request.unit = unit;
    window().open(request);
    ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
    ASSERT_TRUE(waitFor([this] { return !window().message().isEmpty(); }));
  }
  /// Presses a button of the strip as the keyboard does: by F6 and Tab, then Space.
  void pressByKeys(int number) {
    for (int i = 0; i < 12 && QApplication::focusWidget() != buttons().value(0); ++i) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
    }
    for (int i = 0; i < number; ++i) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    ASSERT_EQ(QApplication::focusWidget(), buttons().value(number));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  }
};

/// Counts how often a widget is asked to lay itself out anew.
class LayoutCount : public QObject {
 public:
  explicit LayoutCount(QWidget& of) { of.installEventFilter(this); }
  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) ++count;
    return false;
  }
  int count = 0;
};

TEST_F(QuestionsTest, AMessageWithItsButtonsRestsOnceItIsLaidOut) {
  openAs(relief({}), std::nullopt);
  ASSERT_FALSE(buttons().isEmpty());
  auto* strip = child<MessageStrip>("message_strip");
  for (const int width : {700, 860, 1100, 1400}) {
    window().resize(width, window().height());
    QTest::qWait(300);
    LayoutCount asked(*strip);
    QTest::qWait(300);
    EXPECT_LE(asked.count, 3) << "of a window " << width << " wide";
  }
}

TEST_F(QuestionsTest, StraysAreToldAndKeptByAKeyAndLeftOutAgainByUndo) {
  openAs(relief("1000000 20 5\n1000000 21 5\n"), LengthUnit::mm);
  EXPECT_TRUE(window().message().contains("2 of 3,002 points lie 99.9 % of the box away"))
      << window().message().toStdString();
  EXPECT_NEAR(document().surface()->map.widthMm(), 60, 3);
  ASSERT_EQ(buttons().size(), 2);
  EXPECT_EQ(buttons()[0]->accessibleName(), "Keep them");
  QTest::keyClick(&window().detailView(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([this] { return document().surface()->strays.kept; }));
  EXPECT_GT(document().surface()->map.widthMm(), 900'000);
  document().history().undo();
  EXPECT_FALSE(document().surface()->strays.kept);
  EXPECT_NEAR(document().surface()->map.widthMm(), 60, 3);
  document().history().redo();
  EXPECT_TRUE(document().surface()->strays.kept);
}

TEST_F(QuestionsTest, AGroupFarOffIsToldAndLeftOutByAKeyAndComesBackByUndo) {
  QByteArray group;
  for (int i = 0; i < 20; ++i) {
    group += QByteArray::number(900 + i % 5) + ' ' + QByteArray::number(20 + i / 5) + " 5\n";
  }
  openAs(relief(group), LengthUnit::mm);
  EXPECT_TRUE(window().message().startsWith(
      "20 of 3,020 points lie together, 93.4 % of the box away from all others. Kept,"))
      << window().message().toStdString();
  EXPECT_GT(document().surface()->map.widthMm(), 850);
  ASSERT_EQ(buttons().size(), 2);
  EXPECT_EQ(buttons()[0]->accessibleName(), "Leave them out");
  QTest::keyClick(&window().detailView(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([this] { return !document().surface()->strays.groups_kept; }));
  EXPECT_NEAR(document().surface()->map.widthMm(), 60, 3);
  document().history().undo();
  EXPECT_TRUE(document().surface()->strays.groups_kept);
  EXPECT_GT(document().surface()->map.widthMm(), 850);
}

TEST_F(QuestionsTest, OneQuestionFollowsTheOther) {
  openAs(relief("1000000 20 5\n"), std::nullopt);
  EXPECT_TRUE(window().message().contains("One of 3,001 points lies"))
      << window().message().toStdString();
  pressByKeys(1);  // Leave them out: as it is.
  EXPECT_TRUE(window().message().contains("E103")) << window().message().toStdString();
  QTest::keyClick(&window().detailView(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([this] { return document().surface()->unit_source == UnitSource::given; }));
  EXPECT_TRUE(window().message().isEmpty()) << window().message().toStdString();
}

TEST_F(QuestionsTest, HeightsThatMayStandForNoneAreLeftOutAndComeBackByAKey) {
  openAs(relief("70 1 -9999\n70 2 -9999\n70 3 -9999\n71 4 -9999\n"), LengthUnit::mm);
  ASSERT_TRUE(window().message().contains("-9999")) << window().message().toStdString();
  EXPECT_EQ(document().surface()->missing, 4U);
  EXPECT_LT(heightRange(document().surface()->map).max_mm, 100);
  EXPECT_EQ(buttons().value(0)->accessibleName(), "Keep as heights");
  QTest::keyClick(&window().detailView(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([this] { return document().surface()->missing == 0; }));
  EXPECT_FALSE(document().surface()->suspect_height.has_value());
  document().history().undo();
  EXPECT_EQ(document().surface()->missing, 4U);
}

TEST_F(QuestionsTest, MapCoordinatesAreShownInMetresAndAskedAbout) {
  QByteArray text;
  for (int i = 0; i < 3000; ++i) {
    text += QByteArray::number(512000 + i % 60) + ' ' + QByteArray::number(5403000 + i / 60) + ' ' +
            QByteArray::number(220 + 5 * std::sin(i / 400.0)) + '\n';
  }
  openAs(written(QStringLiteral("utm.xyz"), text), std::nullopt);
  EXPECT_EQ(document().surface()->unit, LengthUnit::m);
  EXPECT_EQ(document().surface()->unit_source, UnitSource::guessed);
  EXPECT_TRUE(window().message().contains("map projection")) << window().message().toStdString();
  EXPECT_EQ(buttons().value(0)->accessibleName(), "Metres");
  EXPECT_EQ(buttons().value(1)->accessibleName(), "Feet");
}

TEST_F(QuestionsTest, AnObjectThatMayStandAnyWayOffersItsSixFacesAsPictures) {
  // A ball: nothing says what is up.
  QByteArray text;
  for (int i = 0; i < 6000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 6000;
    const double angle = 2.399963229728653 * i;
    const double r = std::sqrt(1 - z * z);
    text += QByteArray::number(50 * r * std::cos(angle)) + ' ' +
            QByteArray::number(50 * r * std::sin(angle)) + ' ' + QByteArray::number(50 * z) + '\n';
  }
  openAs(written(QStringLiteral("ball.xyz"), text), LengthUnit::mm);
  ASSERT_TRUE(waitFor([this] { return buttons().size() == 6; }));
  EXPECT_TRUE(window().message().contains("From where"));
  QStringList names;
  for (const QPushButton* button : buttons()) {
    names << button->accessibleName();
    EXPECT_FALSE(button->icon().isNull());
    EXPECT_TRUE(button->text().isEmpty());
  }
  const QString shown = QString::fromStdString(document().surface()->view_name);
  EXPECT_EQ(names.front().toLower(), shown) << "the present one comes first";
  names.sort();
  EXPECT_EQ(names, (QStringList{"Back", "Bottom", "Front", "Left", "Right", "Top"}));
  const QString chosen = buttons()[3]->accessibleName().toLower();
  pressByKeys(3);
  ASSERT_TRUE(waitFor([&] { return document().surface()->view_name == chosen.toStdString(); }));
  document().history().undo();
  EXPECT_EQ(document().surface()->view_name, shown.toStdString());
}

}  // namespace
}  // namespace relievo
