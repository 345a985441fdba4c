// SPDX-License-Identifier: BSD-3-Clause
// "Feel with the mouse": the real pointer of the test's own screen.
#include "ui/views/pointer_feel.h"

#include <cmath>
#include <limits>
#include <QAction>
#include <QCursor>
#include <QLabel>
#include <QtTest/QTest>

#include "tests/ui/gui_fixture.h"

namespace relievo {
namespace {

TEST(FeltGainTest, IsSlowerUphillFasterDownhillAndNeverZero) {
  EXPECT_EQ(feltGain(0), 1);
  EXPECT_EQ(feltGain(1), 0.5);
  EXPECT_EQ(feltGain(-1), 2);
  EXPECT_EQ(feltGain(-0.5), 1.5);
  EXPECT_EQ(feltGain(1000), 0.25);
  EXPECT_EQ(feltGain(-1000), 2);
  EXPECT_EQ(feltGain(std::numeric_limits<double>::quiet_NaN()), 1);
  for (double rise = -3; rise < 5; rise += 0.01) EXPECT_GE(feltGain(rise), feltGain(rise + 0.01));
}

TEST(FeltGainTest, ThePointerIsLargerOnHeights) {
  EXPECT_EQ(feltDiameterPx(0), 10);
  EXPECT_EQ(feltDiameterPx(0.5), 28);
  EXPECT_EQ(feltDiameterPx(1), 46);
  EXPECT_EQ(feltDiameterPx(7), 46) << "a gap that was filled may be higher than what was measured";
  EXPECT_EQ(feltDiameterPx(std::numeric_limits<double>::quiet_NaN()), 28);
}

class PointerFeelTest : public GuiTest {
 protected:
  PointerFeelTest() {
    openRelief();
    document().edit("Steeper", [](Project& p) { p.gain = 8; });
    middle_ = QRectF(view().rect()).center().toPoint();
  }
  DetailView& view() { return window().detailView(); }
  QPoint pointer() { return view().mapFromGlobal(QCursor::pos()); }
  /// The mouse goes so far, and the program has had its say.
  void goTo(const QPoint& at) {
    QCursor::setPos(view().mapToGlobal(at));
    QPoint last(-1, -1);
    for (int still = 0, turns = 0; still < 3 && turns < 500; ++turns) {
      QTest::qWait(2);
      still = pointer() == last ? still + 1 : 0;
      last = pointer();
    }
  }
  /// Begins there, without any feeling on the way.
  void beginAt(const QPoint& at) {
    if (action("pointer_feel")->isChecked()) action("pointer_feel")->trigger();
    goTo(at);
    action("pointer_feel")->trigger();
    goTo(at + QPoint(0, 1));
  }
  /// How far the pointer goes if the mouse goes so many steps of 4 pixels.
  int way(int steps, int direction) {
    const int from = pointer().x();
    for (int i = 0; i < steps; ++i) goTo(pointer() + QPoint(4 * direction, 0));
    return direction * (pointer().x() - from);
  }

  QPoint middle_;
};

TEST_F(PointerFeelTest, ItIsOffAtFirst) {
  EXPECT_FALSE(action("pointer_feel")->isChecked());
  EXPECT_EQ(view().cursor().shape(), Qt::OpenHandCursor);
  goTo(middle_ - QPoint(100, 0));
  EXPECT_EQ(way(25, 1), 100);
}

TEST_F(PointerFeelTest, SlowUphillFastDownhillLargeOnHeights) {
  constexpr int kSteps = 15, kMousePx = 60;
  beginAt(middle_ - QPoint(80, 0));
  const int up = way(kSteps, 1);
  beginAt(middle_ + QPoint(20, 0));
  const int down = way(kSteps, 1);
  EXPECT_LT(up, kMousePx * 9 / 10);
  EXPECT_GT(down, kMousePx * 11 / 10);
  beginAt(middle_);
  const int on_top = view().cursor().pixmap().width();
  beginAt(QPoint(12, 12));
  EXPECT_LT(view().cursor().pixmap().width(), on_top / 2) << "on the plate";
}

TEST_F(PointerFeelTest, OnThePlateItIsAsFastAsTheMouse) {
  beginAt(QPoint(12, 12));
  EXPECT_EQ(way(10, 1), 40);
}

TEST_F(PointerFeelTest, NothingHoldsThePointerInTheView) {
  beginAt(middle_ - QPoint(60, 0));
  for (int i = 0; i < 300 && view().rect().contains(pointer()); ++i) {
    goTo(pointer() + QPoint(10, 0));
  }
  EXPECT_FALSE(view().rect().contains(pointer()));
}

TEST_F(PointerFeelTest, EscapeGivesTheSystemsPointerBack) {
  beginAt(middle_);
  EXPECT_EQ(view().cursor().shape(), Qt::BitmapCursor);
  EXPECT_TRUE(child<QLabel>("status_message")->text().contains("Escape ends it"));
  QTest::keyClick(&view(), Qt::Key_Escape);
  EXPECT_FALSE(action("pointer_feel")->isChecked());
  EXPECT_EQ(view().cursor().shape(), Qt::OpenHandCursor);
  EXPECT_TRUE(document().isOpen()) << "it has done nothing else";
  goTo(middle_ - QPoint(100, 0));
  EXPECT_EQ(way(10, 1), 40);
}

}  // namespace
}  // namespace relievo
