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
  Visit visit_{
      {.languages = 2, .objects = 3}, {.still_there_s = 60, .goodbye_s = 15, .chime_s = 45}, 1000};
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
                                    VisitPress::forward, VisitPress::louder}) {
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
  Visit visit({.languages = 2, .objects = 1}, {}, now_s_);
  visit.stir(now_s_);
  visit.press(VisitPress::centre, false, now_s_);
  EXPECT_THAT(visit.take(now_s_), ElementsAre(Order{Do::welcome, 0}, Order{Do::open, 0}));
}

TEST_F(VisitTest, WithOneLanguageNobodyIsAskedForIt) {
  Visit visit({.languages = 1, .objects = 2}, {}, now_s_);
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
  EXPECT_EQ(visitPress("sayDetail"), VisitPress::help) << "Plus held: not two buttons at once";
  EXPECT_EQ(visitPress("repeatSpeech"), VisitPress::repeat);
  EXPECT_EQ(visitPress("forces"), VisitPress::other);
  EXPECT_EQ(visitPress("moveBack"), std::nullopt);
}

/// A visit with all that belongs to it: one object, introduction and guide.
class WholeVisitTest : public VisitTest {
 protected:
  WholeVisitTest() {
    visit_ = Visit({.languages = 2, .objects = 1, .introduction = true, .guide = true}, {}, now_s_);
    press(VisitPress::centre);
    press(VisitPress::forward);
  }
  void open() {
    press(VisitPress::centre);
    visit_.opened(now_s_);
  }
  void introduce() {
    open();
    after(0);
    visit_.introduced(now_s_);
  }
  void explainAll() {
    introduce();
    while (visit_.state() == State::buttons) press(VisitPress::centre);
  }
  std::vector<Order> silence(double seconds) {
    std::vector<Order> orders;
    for (double gone_s = 0; gone_s < seconds; gone_s += 0.1) {
      for (const Order& order : after(0.1)) orders.push_back(order);
    }
    return orders;
  }
  std::vector<Order> speech(double seconds) {
    std::vector<Order> orders;
    for (double gone_s = 0; gone_s < seconds; gone_s += 0.1) {
      visit_.speaking(now_s_);
      for (const Order& order : after(0.1)) orders.push_back(order);
    }
    return orders;
  }
};

TEST_F(WholeVisitTest, ShapesButtonsObjectAndGuideComeOneAfterTheOther) {
  open();
  EXPECT_THAT(after(0), ElementsAre(Order{Do::introduce}));
  EXPECT_THAT(silence(50), IsEmpty()) << "the shapes take their time, and nobody is asked";
  visit_.introduced(now_s_);
  EXPECT_THAT(speech(3), IsEmpty()) << "what they said is heard to its end";
  EXPECT_THAT(silence(1), ElementsAre(Order{Do::explain, 0}));
  EXPECT_THAT(silence(11), IsEmpty());
  EXPECT_THAT(silence(1), ElementsAre(Order{Do::explain, 1})) << "after twelve seconds";
  EXPECT_THAT(press(VisitPress::minus), ElementsAre(Order{Do::explain, 2, VisitPress::minus}));
  EXPECT_THAT(press(VisitPress::forward), ElementsAre(Order{Do::explain, 3, VisitPress::forward}));
  EXPECT_THAT(press(VisitPress::plus), ElementsAre(Order{Do::explain, 4, VisitPress::plus}));
  EXPECT_THAT(press(VisitPress::plus), ElementsAre(Order{Do::say_object, 0}));
  EXPECT_THAT(speech(9), IsEmpty());
  EXPECT_THAT(silence(0.8), ElementsAre(Order{Do::offer_guide})) << "once it is said";
  EXPECT_THAT(press(VisitPress::plus), ElementsAre(Order{Do::guide}));
  EXPECT_THAT(silence(40), IsEmpty());
  visit_.guided(now_s_);
  EXPECT_EQ(visit_.state(), State::touching);
  EXPECT_THAT(speech(2), IsEmpty()) << "the guide says why it ended";
  EXPECT_THAT(silence(0.8), ElementsAre(Order{Do::begin_free, 0})) << "once that was heard";
}

TEST_F(WholeVisitTest, WherePlusAndMinusAreFreeTheyAreTheVolumeAndCentreSaysItAgain) {
  const auto expect_voice = [&](const char* where) {
    EXPECT_THAT(press(VisitPress::plus), ElementsAre(Order{Do::louder})) << where;
    EXPECT_THAT(press(VisitPress::minus), ElementsAre(Order{Do::softer})) << where;
    EXPECT_THAT(press(VisitPress::centre), ElementsAre(Order{Do::repeat})) << where;
    EXPECT_TRUE(taken_) << where;
  };
  visit_.device(VisitDevice::preparing, now_s_);
  open();
  EXPECT_THAT(after(0), ElementsAre(Order{Do::say_homing}));
  expect_voice("homing");
  visit_.device(VisitDevice::ready, now_s_);
  after(0);
  EXPECT_THAT(press(VisitPress::plus), ElementsAre(Order{Do::louder})) << "shapes";
  EXPECT_THAT(press(VisitPress::centre), IsEmpty());
  EXPECT_FALSE(taken_) << "which say their task again";
  visit_.introduced(now_s_);
  while (visit_.state() == State::buttons) press(VisitPress::centre);
  expect_voice("object");
  press(VisitPress::forward);
  press(VisitPress::minus);
  ASSERT_EQ(visit_.state(), State::touching);
  EXPECT_THAT(press(VisitPress::help), ElementsAre(Order{Do::say_help}));
  expect_voice("help");
  EXPECT_THAT(press(VisitPress::forward), IsEmpty());
  EXPECT_EQ(visit_.state(), State::touching);
  press(VisitPress::help);
  silence(19);
  EXPECT_EQ(visit_.state(), State::help);
  silence(1.5);
  EXPECT_EQ(visit_.state(), State::touching) << "by itself after twenty seconds";
}

TEST_F(WholeVisitTest, OneButtonTakesGoesOnGoesBackAndHasTheVoiceEverywhere) {
  EXPECT_TRUE(visit_.chooses());
  EXPECT_THAT(press(VisitPress::next), ElementsAre(Order{Do::offer_language, 0}));
  EXPECT_THAT(press(VisitPress::back), ElementsAre(Order{Do::welcome, 0}));
  EXPECT_THAT(press(VisitPress::repeat), ElementsAre(Order{Do::repeat}));
  EXPECT_THAT(press(VisitPress::louder), ElementsAre(Order{Do::louder}));
  EXPECT_THAT(press(VisitPress::softer), ElementsAre(Order{Do::softer}));
  EXPECT_THAT(press(VisitPress::take), ElementsAre(Order{Do::open, 0}));
  visit_.opened(now_s_);
  visit_.introduced(now_s_);
  visit_.stopped(now_s_);
  after(0);
  ASSERT_EQ(visit_.state(), State::touching);
  EXPECT_FALSE(visit_.chooses());
  EXPECT_THAT(press(VisitPress::repeat), IsEmpty());
  EXPECT_FALSE(taken_) << "the voice's own command";
}

TEST_F(WholeVisitTest, AnOfferIsDeclinedByMinusAndBySilence) {
  explainAll();
  press(VisitPress::forward);
  ASSERT_EQ(visit_.state(), State::offer);
  EXPECT_THAT(press(VisitPress::centre), ElementsAre(Order{Do::repeat}));
  EXPECT_THAT(press(VisitPress::minus), ElementsAre(Order{Do::begin_free, 0}));
  visit_ = Visit({.objects = 1, .introduction = false, .guide = true}, {}, now_s_);
  visit_.stir(now_s_);
  after(0);
  press(VisitPress::centre);
  visit_.opened(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::say_object, 0}));
  EXPECT_THAT(silence(2), ElementsAre(Order{Do::offer_guide}));
  EXPECT_THAT(speech(5), IsEmpty());
  EXPECT_THAT(silence(9.5), IsEmpty());
  EXPECT_THAT(silence(0.8), ElementsAre(Order{Do::begin_free, 0}));
}

TEST_F(WholeVisitTest, AGripThatNobodyPushesInIsAskedForTwiceAndThenHelpIs) {
  visit_.device(VisitDevice::preparing, now_s_);
  open();
  after(0);
  EXPECT_THAT(silence(9.8), IsEmpty());
  EXPECT_THAT(silence(0.4), ElementsAre(Order{Do::say_homing}));
  EXPECT_THAT(silence(19.5), IsEmpty());
  EXPECT_THAT(silence(1),
              ElementsAre(Order{Do::end_touch}, Order{Do::reset}, Order{Do::say_needs_help}));
  visit_.device(VisitDevice::preparing, now_s_);
  EXPECT_EQ(visit_.state(), State::fault);
  visit_.device(VisitDevice::ready, now_s_);
  EXPECT_EQ(visit_.state(), State::idle);
}

TEST_F(WholeVisitTest, ADeviceThatFailsEndsTheVisitAndIsTriedAgainEachMinuteInSilence) {
  explainAll();
  after(0);
  visit_.device(VisitDevice::gone, now_s_);
  EXPECT_THAT(speech(1.9), IsEmpty()) << "it may only have answered late";
  visit_.device(VisitDevice::ready, now_s_);
  visit_.device(VisitDevice::gone, now_s_);
  EXPECT_THAT(speech(2.1), IsEmpty());
  visit_.device(VisitDevice::gone, now_s_);
  EXPECT_THAT(after(0),
              ElementsAre(Order{Do::end_touch}, Order{Do::reset}, Order{Do::say_needs_help}));
  EXPECT_THAT(press(VisitPress::centre), IsEmpty()) << "not without end";
  EXPECT_THAT(after(59.9), IsEmpty());
  EXPECT_THAT(after(0.2), ElementsAre(Order{Do::retry_device}));
  visit_.device(VisitDevice::gone, now_s_);
  EXPECT_THAT(press(VisitPress::centre), ElementsAre(Order{Do::say_needs_help}));
  visit_.device(VisitDevice::preparing, now_s_);
  EXPECT_EQ(visit_.state(), State::idle) << "plugged in again: the next visitor pushes it in";
}

TEST_F(WholeVisitTest, WhoStopsTheForcesIsToldHowToGoOn) {
  open();
  after(0);
  visit_.stopped(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::end_introduction}, Order{Do::say_forces_off}));
  EXPECT_EQ(visit_.state(), State::touching);
  visit_.stopped(now_s_);
  EXPECT_THAT(after(0), IsEmpty()) << "the window says it then";
}

TEST_F(WholeVisitTest, AGripThatLiesThereIsFreeUntilItIsTaken) {
  explainAll();
  press(VisitPress::forward);
  press(VisitPress::minus);
  visit_.letGo(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::end_touch}, Order{Do::say_let_go}));
  visit_.stir(now_s_);
  EXPECT_THAT(after(0), ElementsAre(Order{Do::touch_again}));
  EXPECT_EQ(visit_.state(), State::touching);
}

/// Whatever is pressed, whoever leaves comes to the beginning.
TEST_F(VisitTest, FromEveryStateSilenceLeadsBackToTheBeginning) {
  std::mt19937 random(18);
  visit_ = Visit({.languages = 2, .objects = 3, .introduction = true, .guide = true}, {}, now_s_);
  // What others do meanwhile: shapes and guide come to their end.
  const auto others = [&] {
    if (visit_.state() == State::opening) visit_.opened(now_s_);
    if (visit_.state() == State::introduction) visit_.introduced(now_s_);
    if (visit_.state() == State::guiding) visit_.guided(now_s_);
  };
  for (int round = 0; round < 2000; ++round) {
    const int steps = static_cast<int>(random() % 12);
    for (int i = 0; i < steps; ++i) {
      press(static_cast<VisitPress>(random() % 14), random() % 2 == 0);
      if (random() % 3 != 0) others();
      if (random() % 9 == 0) visit_.letGo(now_s_);
      if (random() % 9 == 0) visit_.stopped(now_s_);
      after(static_cast<double>(random() % 40));
    }
    for (int i = 0; i < 30; ++i) {
      others();
      after(20);
    }
    ASSERT_EQ(visit_.state(), State::idle) << "round " << round;
  }
}

}  // namespace
}  // namespace relievo
