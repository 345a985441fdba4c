// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/header_row.h"

#include <gtest/gtest.h>
#include <QBoxLayout>
#include <QCoreApplication>
#include <QLabel>

namespace relievo {
namespace {

class HeaderRowTest : public ::testing::Test {
 protected:
  HeaderRowTest() {
    for (QLabel* label : {title_, note_}) label->setMinimumWidth(10);  // As the window's.
    row_.resize(needed(), 60);
    row_.show();
    settle();
  }
  /// Width of both texts side by side.
  int needed() const {
    return title_->sizeHint().width() + note_->fontMetrics().horizontalAdvance(note_->text());
  }
  void say(const QString& note) {
    note_->setText(note);
    settle();
  }
  void widen(int width) {
    row_.resize(width, 160);
    settle();
  }
  static void settle() {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
  }
  bool isOneRow() const {
    return static_cast<QBoxLayout*>(row_.layout())->direction() == QBoxLayout::LeftToRight;
  }
  int digit() const { return note_->fontMetrics().horizontalAdvance('0'); }

  QLabel* title_ = new QLabel(QStringLiteral("DETAIL   |   Resolution 2 of 3"));
  QLabel* note_ = new QLabel(QStringLiteral("80.0 mm, 1 mm of hand is 1.5 mm"));
  HeaderRow row_{title_, note_};
};

TEST_F(HeaderRowTest, IsOneRowWhereBothTextsFit) {
  EXPECT_TRUE(isOneRow());
  widen(needed() - 1);
  EXPECT_FALSE(isOneRow());
}

TEST_F(HeaderRowTest, ComesBackToOneRowWhenThereIsRoom) {
  widen(needed() / 2);
  ASSERT_FALSE(isOneRow());
  widen(needed() + 6 * digit());
  EXPECT_TRUE(isOneRow());
}

TEST_F(HeaderRowTest, ATitleThatIsWiderThanTheRowIsBrokenAndNotCut) {
  widen(title_->sizeHint().width() / 2);
  EXPECT_LE(title_->heightForWidth(title_->width()), title_->height());
  EXPECT_TRUE(title_->wordWrap());
  widen(needed() + 6 * digit());
  EXPECT_FALSE(title_->wordWrap());
}

TEST_F(HeaderRowTest, ANumberThatGetsADigitMoreAndLessDoesNotMakeItJump) {
  int jumps = 0;
  bool was = isOneRow();
  for (int i = 0; i < 20; ++i) {
    say(i % 2 == 0 ? QStringLiteral("180.0 mm, 1 mm of hand is 1.5 mm")
                   : QStringLiteral("80.0 mm, 1 mm of hand is 1.5 mm"));
    if (isOneRow() != was) ++jumps;
    was = isOneRow();
  }
  EXPECT_LE(jumps, 1);
}

}  // namespace
}  // namespace relievo
