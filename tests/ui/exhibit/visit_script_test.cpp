// SPDX-License-Identifier: BSD-3-Clause
// A visitor who is alone and does not see goes through the whole visit: what is said in which
// language, when, and after which press. Clock, hand, shapes, guide and device are the test's; a
// voice speaks 160 words a minute.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/exhibit/visit.h"
#include "core/message/language.h"
#include "ui/exhibit/visit_words.h"
#include "ui/translations/message_languages.h"

namespace relievo {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Do = Visit::Do;
using State = Visit::State;

std::size_t wordsIn(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  std::size_t count = 0;
  while (words >> word) ++count;
  return count;
}

class VisitScript : public testing::Test {
 protected:
  VisitScript() {
    exhibit_.languages = {"en", "de"};
    ExhibitObject object;
    object.title = {{"en", "A dome"}, {"de", "Eine Kuppel"}};
    exhibit_.objects.push_back(object);
  }

  /// Time goes on; what is said takes its time.
  void pass(double seconds) {
    for (const double end_s = now_s_ + seconds; now_s_ < end_s; now_s_ += 0.05) {
      if (now_s_ < speaks_until_s_) visit_.speaking(now_s_);
      for (const Visit::Order& order : visit_.take(now_s_)) carryOut(order);
    }
  }
  void carryOut(const Visit::Order& order) {
    orders_.push_back(order.what);
    if (order.what == Do::welcome || order.what == Do::offer_language) language_ = order.index;
    if (order.what == Do::reset) language_ = 0;
    const auto words = visitWords(order, exhibit_, exhibit_.languages[language_]);
    if (words.empty()) return;
    for (const Message& sentence : words) {
      const std::string text = spoken(sentence);
      std::istringstream parts(text);
      for (std::string part; std::getline(parts, part, '.');) {
        EXPECT_LE(wordsIn(part), 12U) << part;
      }
    }
    said_ = spokenIn(messageLanguage(exhibit_.languages[language_]), words);
    all_.push_back(said_);
    speaks_until_s_ = now_s_ + 60.0 / 160 * static_cast<double>(wordsIn(said_));
  }
  std::string spoken(const Message& sentence) const {
    return spokenIn(messageLanguage(exhibit_.languages[language_]), sentence);
  }
  void press(VisitPress press) {
    speaks_until_s_ = now_s_;  // Any button cuts what is said.
    visit_.press(press, true, now_s_);
    pass(0.1);
  }
  bool did(Do what) const {
    return std::find(orders_.begin(), orders_.end(), what) != orders_.end();
  }
  void untilSilent() {
    while (now_s_ < speaks_until_s_) pass(0.1);
  }

  Exhibit exhibit_;
  double now_s_ = 100, speaks_until_s_ = 0;
  std::size_t language_ = 0;
  std::string said_;
  std::vector<std::string> all_;
  std::vector<Do> orders_;
  Visit visit_{{.languages = 2, .objects = 1, .introduction = true, .guide = true}, {}, 100};
};

TEST_F(VisitScript, FromTheChimeToTheGuideInEnglish) {
  pass(46);
  EXPECT_TRUE(did(Do::chime)) << "nobody is there";
  EXPECT_TRUE(all_.empty());
  press(VisitPress::forward);
  EXPECT_THAT(said_, AllOf(HasSubstr("Welcome."), HasSubstr("a grip with four buttons"),
                           HasSubstr("Plus is louder"), HasSubstr("For English press the middle")));
  visit_.device(VisitDevice::preparing, now_s_);
  press(VisitPress::centre);
  ASSERT_TRUE(did(Do::open));
  visit_.opened(now_s_);
  pass(0.1);
  EXPECT_EQ(said_,
            "Hold the grip lightly. Nothing will pull you. Push it in as far as it goes, and pull "
            "it out.");
  pass(10);
  EXPECT_EQ(all_.back(), all_[all_.size() - 2]) << "once more after ten seconds";
  visit_.device(VisitDevice::ready, now_s_);
  pass(0.1);
  ASSERT_TRUE(did(Do::introduce)) << "plate and bump, which speak for themselves";
  pass(40);
  visit_.introduced(now_s_);
  pass(1);
  EXPECT_EQ(said_, "Now the buttons. Press any of them to go on. Middle button: where am I.");
  press(VisitPress::centre);
  EXPECT_EQ(said_, "Middle button: where am I. Plus: closer. Plus held: help.");
  pass(12.1);
  EXPECT_EQ(said_, "Minus: wider. Minus held: the whole relief.") << "or twelve seconds";
  press(VisitPress::plus);
  press(VisitPress::plus);
  EXPECT_THAT(said_, HasSubstr("Middle button held long: stop, and go on."));
  press(VisitPress::plus);
  EXPECT_EQ(visit_.state(), State::object);
  pass(3);  // Its facts are those of the map.
  EXPECT_EQ(said_, "Shall I guide your hand along the outline once? Plus for yes, Minus for no.");
  press(VisitPress::plus);
  EXPECT_TRUE(did(Do::guide));
  visit_.guided(now_s_);
  pass(0.1);
  EXPECT_EQ(visit_.state(), State::touching);
}

TEST_F(VisitScript, WithEverythingPassedOverTouchBeginsSoon) {
  press(VisitPress::forward);
  const double began_s = now_s_;
  press(VisitPress::centre);
  visit_.opened(now_s_);
  pass(0.1);
  visit_.introduced(now_s_);
  pass(0.1);
  press(VisitPress::forward_held);
  press(VisitPress::forward);
  press(VisitPress::minus);
  EXPECT_EQ(visit_.state(), State::touching);
  EXPECT_LT(now_s_ - began_s, 90) << "of the visit's own time";
  EXPECT_THAT(said_, HasSubstr("Now touch as you like. Plus held: help"));
}

TEST_F(VisitScript, InGermanNoEnglishIsHeardAndTheNextVisitorBeginsAnew) {
  press(VisitPress::forward);
  press(VisitPress::forward);
  EXPECT_THAT(said_, HasSubstr("Für Deutsch"));
  const std::size_t from = all_.size();
  visit_.device(VisitDevice::preparing, now_s_);
  press(VisitPress::centre);
  visit_.opened(now_s_);
  pass(11);
  visit_.device(VisitDevice::ready, now_s_);
  pass(1);
  visit_.introduced(now_s_);
  pass(100);
  EXPECT_EQ(visit_.state(), State::touching) << "nobody answered";
  press(VisitPress::help);
  press(VisitPress::forward);
  visit_.letGo(now_s_);
  pass(0.1);
  visit_.stir(now_s_);
  pass(61);
  EXPECT_EQ(visit_.state(), State::still);
  pass(16);
  EXPECT_EQ(visit_.state(), State::idle);
  EXPECT_TRUE(did(Do::reset));
  ASSERT_GT(all_.size(), from + 8);
  for (std::size_t i = from; i < all_.size(); ++i) {
    for (const char* english :
         {"the ", "button", "Middle", "Forward", "grip", "Plus held", "you "}) {
      EXPECT_THAT(all_[i], testing::Not(HasSubstr(english)));
    }
  }
  press(VisitPress::centre);
  EXPECT_THAT(said_, HasSubstr("For English")) << "the language is that of the exhibit again";
}

TEST_F(VisitScript, AStopAnAbsenceAndADeviceThatFailsAreSaidOnce) {
  press(VisitPress::forward);
  press(VisitPress::centre);
  visit_.opened(now_s_);
  pass(0.1);
  visit_.stopped(now_s_);
  pass(0.1);
  EXPECT_EQ(said_, "Forces off. Middle button held long: on again.");
  visit_.letGo(now_s_);
  pass(0.1);
  EXPECT_EQ(said_, "Take the grip again to go on.");
  visit_.stir(now_s_);
  pass(61);
  EXPECT_EQ(said_, "Are you still there? Press any button, or I will stop.");
  press(VisitPress::plus);
  visit_.device(VisitDevice::gone, now_s_);
  pass(2.1);
  visit_.device(VisitDevice::gone, now_s_);
  pass(0.1);
  EXPECT_EQ(said_, "This exhibit needs help. Please ask the staff.");
  const std::size_t count = all_.size();
  for (int i = 0; i < 5; ++i) press(VisitPress::centre);
  pass(200);
  EXPECT_EQ(all_.size(), count) << "no endless speech";
  EXPECT_TRUE(did(Do::retry_device)) << "but it is tried again";
}

}  // namespace
}  // namespace relievo
