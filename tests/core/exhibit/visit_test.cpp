// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/visit.h"

#include <gmock/gmock.h>

#include <random>

namespace relievo {

void PrintTo(const Visit::Order& order, std::ostream* out) {
  *out << static_cast<int>(order.what) << '(' << order.index << ')';
}

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Do = Visit::Do;
using State = Visit::State;
using Order = Visit::Order;

class VisitTest : public testing::Test {
 protected:
  std::vector<Order> after(double seconds) {
    now_s_ += seconds;
    return visit_.take(now_s_);
  }
  std::vector<Order> press(VisitPress press, bool at_whole = false) {
    taken_ = visit_.press(press, at_whole, now_s_);
    return visit_.take(now_s_);
  }
  void touchFirst() {
    press(VisitPress::centre);  // Wakes.
    press(VisitPress::centre);  // Language.
    press(VisitPress::centre);  // Object.
    visit_.opened(now_s_);
    visit_.take(now_s_);
  }

  double now_s_ = 1000;
  bool taken_ = false;
  Visit visit_{2, 3, {.still_there_s = 60, .goodbye_s = 15, .chime_s = 45}, 1000};
};

TEST_F(VisitTest, NobodyThereAChimeSoundsNowAndThen) {
  EXPECT_THAT(after(44.9), IsEmpty());
  EXPECT_THAT(after(0.2), ElementsAre(Order{Do::chime}));
  EXPECT_THAT(after(0.2), IsEmpty());
  EXPECT_THAT(after(45), ElementsAre(Order{Do::chime}));
}

TEST_F(VisitTest, AnyInputBeginsAVisit) {
  visit_.stir(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::welcome, 0}));
  EXPECT_EQ(visit_.state(), State::language);
}

TEST_F(VisitTest, ThePressThatWakesChoosesNothing) {
  EXPECT_THAT(press(VisitPress::centre), ElementsAre(Order{Do::welcome, 0}));
  EXPECT_TRUE(taken_);
  EXPECT_EQ(visit_.state(), State::language);
}

TEST_F(VisitTest, LanguageAndObjectAreChosenByFourButtons) {
  visit_.stir(now_s_);
  after(0);
  EXPECT_THAT(press(VisitPress::plus), ElementsAre(Order{Do::louder}));
  EXPECT_THAT(press(VisitPress::minus), ElementsAre(Order{Do::softer}));
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::offer_language, 1}));
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::offer_language, 0}));
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::offer_language, 1}));
  EXPECT_THAT(press(VisitPress::centre), ElementsAre(Order{Do::offer_object, 0}));
  EXPECT_EQ(visit_.language(), 1U);
  EXPECT_THAT(press(VisitPress::plus), ElementsAre(Order{Do::louder}));
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::offer_object, 1}));
  EXPECT_THAT(press(VisitPress::forward_held), ElementsAre(Order{Do::offer_object, 1})) << "again";
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::offer_object, 2}));
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::offer_object, 0})) << "round";
  EXPECT_THAT(press(VisitPress::centre), ElementsAre(Order{Do::open, 0}));
  visit_.opened(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::begin_touch, 0}));
  EXPECT_EQ(visit_.state(), State::touching);
}

TEST_F(VisitTest, WhileTouchingButtonsAreTheWindowsAndMinusHeldGoesBackAtTheWhole) {
  touchFirst();
  for (const VisitPress press_of : {VisitPress::plus, VisitPress::minus, VisitPress::centre,
                                    VisitPress::forward, VisitPress::help}) {
    EXPECT_THAT(press(press_of, true), IsEmpty());
    EXPECT_FALSE(taken_);
  }
  EXPECT_THAT(press(VisitPress::minus_held, false), IsEmpty());
  EXPECT_FALSE(taken_) << "the whole relief first";
  EXPECT_THAT(press(VisitPress::minus_held, true),
              ElementsAre(Order{Do::end_touch}, Order{Do::offer_object, 0}));
  EXPECT_THAT(press(VisitPress::minus_held), ElementsAre(Order{Do::welcome, 0}))
      << "and from there to the languages";
}

TEST_F(VisitTest, WithOneObjectALanguageLeadsToIt) {
  Visit visit(2, 1, {}, now_s_);
  visit.stir(now_s_);
  visit.press(VisitPress::centre, false, now_s_);
  EXPECT_THAT(visit.take(now_s_), ElementsAre(Order{Do::welcome, 0}, Order{Do::open, 0}));
}

TEST_F(VisitTest, WithOneLanguageNobodyIsAskedForIt) {
  Visit visit(1, 2, {}, now_s_);
  visit.stir(now_s_);
  EXPECT_THAT(visit.take(now_s_), ElementsAre(Order{Do::welcome, 0}, Order{Do::offer_object, 0}));
}

TEST_F(VisitTest, WhoDoesNothingIsAskedAndThenAllBeginsAnew) {
  press(VisitPress::centre);
  press(VisitPress::forward);
  press(VisitPress::centre);
  press(VisitPress::forward);
  press(VisitPress::centre);
  visit_.opened(now_s_);
  after(0);
  EXPECT_THAT(after(59.9), IsEmpty());
  EXPECT_THAT(after(0.2), ElementsAre(Order{Do::ask_still_there}));
  EXPECT_THAT(after(14.8), IsEmpty());
  EXPECT_THAT(after(0.3),
              ElementsAre(Order{Do::say_goodbye}, Order{Do::end_touch}, Order{Do::reset}));
  EXPECT_EQ(visit_.state(), State::idle);
  EXPECT_EQ(visit_.language(), 0U);
  EXPECT_EQ(visit_.object(), 0U);
}

TEST_F(VisitTest, AHandThatMovesIsThere) {
  touchFirst();
  for (int i = 0; i < 5; ++i) {
    EXPECT_THAT(after(50), IsEmpty());
    visit_.stir(now_s_);
  }
  EXPECT_THAT(after(61), ElementsAre(Order{Do::ask_still_there}));
  EXPECT_THAT(press(VisitPress::plus), IsEmpty());
  EXPECT_TRUE(taken_) << "it only says that somebody is there";
  EXPECT_EQ(visit_.state(), State::touching);
  EXPECT_THAT(after(59), IsEmpty());
}

TEST_F(VisitTest, ALanguageThatNobodyTakesIsSaidTwiceAndThenNoMore) {
  visit_.stir(now_s_);
  after(0);
  EXPECT_THAT(after(12.1), ElementsAre(Order{Do::offer_language, 0}));
  EXPECT_THAT(after(12.1), IsEmpty());
  EXPECT_THAT(after(6), ElementsAre(Order{Do::end_touch}, Order{Do::reset}));
}

TEST_F(VisitTest, LoadingTakesAsLongAsItTakes) {
  press(VisitPress::centre);
  press(VisitPress::centre);
  press(VisitPress::centre);
  EXPECT_THAT(after(300), IsEmpty());
  EXPECT_THAT(press(VisitPress::centre), IsEmpty());
  EXPECT_TRUE(taken_);
  EXPECT_EQ(visit_.state(), State::opening);
}

TEST_F(VisitTest, AnObjectThatCannotBeOpenedIsPassedOverAndHelpIsAskedForWhenNoneCan) {
  press(VisitPress::centre);
  press(VisitPress::centre);
  press(VisitPress::centre);
  visit_.failed(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::say_failed, 0}, Order{Do::offer_object, 1}));
  press(VisitPress::centre);
  visit_.failed(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::say_failed, 1}, Order{Do::offer_object, 2}));
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::offer_object, 2}));
  press(VisitPress::centre);
  visit_.failed(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::say_needs_help}));
  EXPECT_EQ(visit_.state(), State::fault);
  EXPECT_THAT(press(VisitPress::centre), IsEmpty()) << "not without end";
  const auto retry = after(60.1);
  ASSERT_EQ(retry.size(), 1U);
  EXPECT_EQ(retry.front().what, Do::open) << "silently";
  visit_.failed(now_s_);
  EXPECT_THAT(press(VisitPress::centre), ElementsAre(Order{Do::say_needs_help}));
  after(60.1);
  visit_.opened(now_s_);
  after(0);
  EXPECT_EQ(visit_.state(), State::idle) << "it is well again";
}

TEST_F(VisitTest, CommandsOfButtonsArePresses) {
  EXPECT_EQ(visitPress("finer"), VisitPress::plus);
  EXPECT_EQ(visitPress("whereAmILong"), VisitPress::centre);
  EXPECT_EQ(visitPress("moveMode"), VisitPress::forward);
  EXPECT_EQ(visitPress("beacon"), VisitPress::forward_held);
  EXPECT_EQ(visitPress("whole"), VisitPress::minus_held);
  EXPECT_EQ(visitPress("forces"), VisitPress::other);
  EXPECT_EQ(visitPress("moveBack"), std::nullopt);
}

/// Whatever is pressed, whoever leaves comes to the beginning.
TEST_F(VisitTest, FromEveryStateSilenceLeadsBackToTheBeginning) {
  std::mt19937 random(18);
  for (int round = 0; round < 2000; ++round) {
    const int steps = static_cast<int>(random() % 12);
    for (int i = 0; i < steps; ++i) {
      press(static_cast<VisitPress>(random() % 8), random() % 2 == 0);
      if (visit_.state() == State::opening) visit_.opened(now_s_);
      after(static_cast<double>(random() % 40));
    }
    if (visit_.state() == State::opening) visit_.opened(now_s_);
    for (int i = 0; i < 10; ++i) after(20);
    ASSERT_EQ(visit_.state(), State::idle) << "round " << round;
  }
}

}  // namespace
}  // namespace relievo
