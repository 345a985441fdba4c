// SPDX-License-Identifier: BSD-3-Clause
// Journey U3, the whole of its script: a visitor who sees nothing is woken to by a chime, chooses a
// language, learns shapes and buttons, is told what the relief is like, is led round its outline
// and leads again, asks where the hand is, goes closer and back, moves, sets a marker, stops the
// forces, and goes away. All of it by the four buttons of an emulated Falcon and by what the speech
// service says. What fails meanwhile: journey_u3_failures_test.cpp.
#include <gmock/gmock.h>

#include <cmath>
#include <QAction>
#include <QFile>
#include <QtTest/QTest>
#include <utility>

#include "tests/app/journeys/exhibition.h"
#include "ui/exhibit/chime.h"

namespace relievo {
namespace {

using emulator::FalconEmulator;
using emulator::Triple;
using testing::HasSubstr;

constexpr double kDomeX = 90, kDomeY = 100, kHoleX = 150, kHoleY = 60;  // Of relief F, mm.
constexpr int kHeldMs = 1000, kHeldLongMs = 1800;                       // Of a button.
constexpr double kGuideN = 2;

class JourneyU3 : public Exhibition {
 protected:
  JourneyU3() : Exhibition("u3") {}
  /// What a shape's task ends with. A busy computer may have taken its forces meanwhile; then it
  /// goes on by itself.
  void finds(const QStringList& next);
  Triple grip() {
    return falcon_->with([](FalconEmulator& f) { return f.body.grip(); });
  }

 public:  // Named by the test below.
  void wakeIt();
  void chooseLanguage();
  void homeTheGrip();
  void learnShapes();
  void learnButtons();
  void hearOfObject();
  void beLed();
  void lead();
  void restOnTheDome();
  void restOnTheHole();
  void goCloserAndBack();
  void moveAndMark();
  void stopForces();
  void goAway();
};

/// U3.0 Nobody is there: a chime, no word, no force.
void JourneyU3::wakeIt() {
  ASSERT_TRUE(eventually([this] { return QFile::exists(path("chime.wav")); })) << "no chime";
  QFile chime(path("chime.wav"));
  ASSERT_TRUE(eventually([&] { return chime.size() == chimeWav(60).size(); }));
  ASSERT_TRUE(chime.open(QIODevice::ReadOnly));
  EXPECT_EQ(chime.readAll(), chimeWav(60)) << "as loud as the exhibit says";
  EXPECT_EQ(visit().state(), Visit::State::idle);
  EXPECT_TRUE(heard().isEmpty()) << heard().join('\n').toStdString();
  ASSERT_TRUE(waitsForGrip());
}

/// U3.1 Any button begins; a press cuts what is being said; languages, and how loud.
void JourneyU3::chooseLanguage() {
  speakSlowly(true);
  press(kForward);
  ASSERT_TRUE(hears({"Welcome."}));
  EXPECT_TRUE(speech_->isSpeaking());
  press(kForward);
  ASSERT_TRUE(hears("de", {QString::fromUtf8("Für Deutsch drücken Sie den mittleren Knopf.")}))
      << "the rest of the welcome was cut";
  press(kForward);
  speakSlowly(false);
  ASSERT_TRUE(
      hears({"For English press the middle button.", "The button Forward: another language."}));
  const double before = volume();
  press(kPlus);
  ASSERT_TRUE(hears({"Volume 80 percent."})) << "the loudest that the exhibit allows";
  EXPECT_GT(volume(), before);
  press(kMinus);
  ASSERT_TRUE(hears({"Volume 57 percent."}));
  press(kCentre);
  mayHear("One moment please.");
}

/// U3.2 The grip, of which nothing pulls; said again when asked, and once by itself.
void JourneyU3::homeTheGrip() {
  const QStringList words{"Hold the grip lightly.", "Nothing will pull you.",
                          "Push it in as far as it goes, and pull it out."};
  ASSERT_TRUE(hears(words));
  press(kCentre);
  ASSERT_TRUE(hears(words)) << "the middle button says it again";
  ASSERT_TRUE(hears(words)) << "after ten seconds";
  EXPECT_EQ(forces_->takePushes(), 0) << "no force so far";
  EXPECT_EQ(sound_->peakFrom(0), 0) << "and no sound but the voice's";
  ASSERT_TRUE(homeGrip());
  gripTo({}, kAboveZ);
}

void JourneyU3::finds(const QStringList& next) {
  mayHear("Push the grip away from you until it meets the plate.");
  mayHear("The bump is a little right and above the middle.");
  bool is_first = true;
  EXPECT_TRUE(stalls_.repeatAfterStalls(2, [&] {
    if (!std::exchange(is_first, false)) return true;
    if (mayHear("Yes.")) return true;
    mayHear("Let us go on.");
    return false;
  })) << "not found";
  ASSERT_TRUE(hears(next));
}

/// U3.3, U3.4 Forces come on; a plate, then a bump, are found.
void JourneyU3::learnShapes() {
  ASSERT_TRUE(hears({"I switch the forces on now.", "They start softly.", "There is a flat plate.",
                     "Push towards it and slide."}));
  EXPECT_TRUE(action("forces")->isChecked());
  gripTo({}, kInZ);
  finds({"Now there is a bump.", "Find it."});
  gripTo({6, 8, 0}, kAboveZ);  // Over it, then down.
  QTest::qWait(1000);
  gripTo({6, 8, 0}, kOnZ);
  finds({"The introduction has ended.", "The relief is under the hand again."});
  const double largest_n = forces_->takeLargestN();
  EXPECT_GT(largest_n, 0.5) << "they were felt";
  EXPECT_LE(largest_n, kLimitN + kMotorStepN);
  EXPECT_GT(sound_->peakFrom(0), 0.005) << "their contact, and three notes, were heard";
  EXPECT_LE(sound_->peakFrom(0), 0.5) << "never above the exhibit's percentage";
  gripTo({}, kAboveZ);
}

/// U3.5 Each button is named and, pressed, only says what it does.
void JourneyU3::learnButtons() {
  ASSERT_TRUE(
      hears({"Now the buttons.", "Press any of them to go on.", "Middle button: where am I."}));
  press(kCentre);
  ASSERT_TRUE(hears({"Middle button: where am I.", "Plus: closer.", "Plus held: help."}));
  ASSERT_TRUE(hears({"Minus: wider.", "Minus held: the whole relief."})) << "after 12 s";
  press(kForward);
  ASSERT_TRUE(hears({"Forward: move.", "Forward held: a marker."}));
  press(kPlus);
  ASSERT_TRUE(
      hears({"Plus: closer.", "Plus held: help.", "Middle button held long: stop, and go on."}));
  EXPECT_EQ(document().detail(), 1) << "nothing else was done";
}

/// U3.6 What the relief is like, and again.
void JourneyU3::hearOfObject() {
  const QStringList words{"Relief, 30 centimetres by 20 centimetres.",
                          "Its heights span 3 centimetres.", "Highest place: middle left.",
                          "You feel all of it now.",
                          "One centimetre of hand: nearly 4 centimetres of relief."};
  speakSlowly(true);  // Else it may be over before a busy computer has pressed the button.
  press(kMinus);
  mayHear("Minus: wider.");
  ASSERT_TRUE(hears({words.first()}));
  press(kCentre);
  ASSERT_TRUE(hears({words.first()})) << "the middle button says it again";
  speakSlowly(false);
  ASSERT_TRUE(hears(words.mid(1)));
}

/// U3.7 Led along the outline by no more than 2 N ...
void JourneyU3::beLed() {
  ASSERT_TRUE(
      hears({"Shall I guide your hand along the outline once? Plus for yes, Minus for no."}));
  gripTo({10, 0, 0}, 135);
  forces_->takeLargestN();
  press(kPlus);
  ASSERT_TRUE(hears({"Guiding along the outline of a raised area, you lead."}));
  EXPECT_EQ(visit().state(), Visit::State::guiding);
  letGripLie();
  falcon_->with([](FalconEmulator& f) { f.body.letGo(0); });  // It follows.
  const Triple from = grip();
  EXPECT_TRUE(eventually([&] {
    const Triple to = grip();
    return std::hypot(to[0] - from[0], to[1] - from[1]) > 15;
  })) << "it is led";
  EXPECT_EQ(visit().state(), Visit::State::guiding);
}

/// ... until the hand pushes back, which is said to its end.
void JourneyU3::lead() {
  speakSlowly(true);
  gripTo({-30, -30, 0}, kAboveZ);
  ASSERT_TRUE(hears({"You lead."}));
  EXPECT_LE(forces_->takeLargestN(), kGuideN + kMotorStepN);
  EXPECT_FALSE(action("guide")->isChecked());
  QTest::qWait(2000);  // Nothing takes its place.
  EXPECT_TRUE(speech_->isSpeaking());
  EXPECT_TRUE(heard().last().endsWith("|You lead.")) << heard().last().toStdString();
  speakSlowly(false);
  ASSERT_TRUE(hears({"Now touch as you like.", "Plus held: help, and louder, softer, say it again.",
                     "Minus held: the whole relief, then other objects."}));
  EXPECT_EQ(visit().state(), Visit::State::touching);
}

/// U3.8, U3.9 A hand that rests on the dome hears its name, once, and where it is when it asks.
void JourneyU3::restOnTheDome() {
  forgetHeard();
  ASSERT_TRUE(touch(kDomeX, kDomeY)) << where();
  ASSERT_TRUE(hears({"Bookmark: Dome."}));
  press(kCentre);
  ASSERT_TRUE(hears({"Touching: middle left, 3 centimetres high.", "Bookmark: Dome."}));
  press(kCentre);
  ASSERT_TRUE(hears({"Touching: middle left, 3 centimetres high.", "Bookmark: Dome."}));
  ASSERT_TRUE(hearsLength(kDomeX, kNearMm, " from the left edge."));
  ASSERT_TRUE(hearsLength(kDomeY, kNearMm, " from the bottom edge."));
  ASSERT_TRUE(hears({"Measured here.", "Resolution 1 of 4, 30 centimetres wide.",
                     "One centimetre of hand: nearly 4 centimetres of relief.",
                     "Samples are 2 millimetres apart."}));
}

/// U3.11 Where nobody measured the relief.
void JourneyU3::restOnTheHole() {
  forgetHeard();
  ASSERT_TRUE(touch(kHoleX, kHoleY, kInZ)) << where();
  ASSERT_TRUE(hears({"Not measured here.", "The real surface is missing in the scan."}));
}

/// U3.10, U3.14 Closer, and the whole again.
void JourneyU3::goCloserAndBack() {
  ASSERT_TRUE(touch(kDomeX, kDomeY)) << where();
  forgetHeard();
  const ViewMm touched = probe()->proxy;
  const DeviceMm under = handMapping(*document().window()).device_from_view(touched);
  ASSERT_TRUE(press(kPlus, [this] { return document().detail() == 2; }));
  ASSERT_TRUE(
      eventually([this] { return probe() && probe()->window_id == document().window()->id; }));
  const DeviceMm now_under = handMapping(*document().window()).device_from_view(touched);
  EXPECT_LE(std::hypot(now_under.x - under.x, now_under.y - under.y), 2)
      << "what was touched stays under the hand";
  ASSERT_TRUE(hears({"Closer.", "20 centimetres wide."}));
  ASSERT_TRUE(press(
      kMinus, [this] { return document().detail() == 1; }, kHeldMs));
  ASSERT_TRUE(hears({"The whole relief."}));
}

/// U3.12, U3.13 A marker, and the window goes a quarter to a side, and comes back.
void JourneyU3::moveAndMark() {
  ASSERT_TRUE(press(kPlus, [this] { return document().detail() == 2; }));
  ASSERT_TRUE(hears({"Closer.", "20 centimetres wide."}));
  handTo(kDomeX, kDomeY, kAboveZ);
  QTest::qWait(1500);
  forgetHeard();
  press(kForward, kHeldMs);
  ASSERT_TRUE(hears({"Marker 1 set."}));
  const Region from = document().project().region;
  press(kForward);
  ASSERT_TRUE(hears({"Move mode.", "Push the grip to a side; Forward when you are there."}));
  const Triple at = grip();
  gripTo({at[0] + 30, at[1], 0}, kAboveZ);
  ASSERT_TRUE(eventually([&] { return document().project().region.x_mm != from.x_mm; }));
  EXPECT_NEAR(document().project().region.x_mm, from.x_mm + from.side_mm / 4, 1e-6);
  gripTo({at[0], at[1], 0}, kAboveZ);
  QTest::qWait(1000);
  forgetHeard();
  press(kCentre);
  ASSERT_TRUE(hears({"Back at the old window."}));
  EXPECT_EQ(document().project().region, from);
}

/// U3.15 The middle button, held long, and none of it pushes any more.
void JourneyU3::stopForces() {
  ASSERT_TRUE(touch(kDomeX, kDomeY)) << where();
  EXPECT_LE(forces_->takeLargestN(), kLimitN + kMotorStepN);
  forgetHeard();
  press(kCentre, kHeldLongMs);
  // The loop has stopped them itself; who comes first says it.
  const bool is_said = mayHear("Forces are off.") || mayHear("Forces off.");
  EXPECT_TRUE(is_said);
  EXPECT_TRUE(eventually([this] { return forces_->isNeutral(); }));
  forces_->takePushes();
  QTest::qWait(500);
  EXPECT_EQ(forces_->takePushes(), 0) << "the hand is deep in the relief";
}

/// U3.16, U3.17 A grip that nobody holds is free; nobody is there, and the next one begins anew.
void JourneyU3::goAway() {
  ASSERT_TRUE(touch(kDomeX, kDomeY)) << where();
  forgetHeard();
  letGripLie();
  ASSERT_TRUE(hears({"Take the grip again to go on."}));
  EXPECT_TRUE(eventually([this] { return forces_->isNeutral(); }));
  EXPECT_EQ(visit().state(), Visit::State::let_go);
  gripTo({10, 0, 0}, kAboveZ);
  ASSERT_TRUE(reaches(Visit::State::touching)) << "it is taken again";
  ASSERT_TRUE(eventually([this] { return action("forces")->isChecked(); }));
  ASSERT_TRUE(hears({"Forces on."}));
  letGripLie();
  ASSERT_TRUE(hears({"Are you still there? Press any button, or I will stop.", "Goodbye."}));
  ASSERT_TRUE(reaches(Visit::State::idle));
  EXPECT_TRUE(eventually([this] { return forces_->isNeutral(); }));
  EXPECT_FALSE(action("forces")->isChecked());
  EXPECT_TRUE(!document().isOpen() || window().project().places.size() == 1) << "no marker stays";
  press(kForward);
  ASSERT_TRUE(hears({"Welcome."}));
}

TEST_F(JourneyU3, AVisitorWhoSeesNothingFeelsLearnsIsLedTouchesAndLeaves) {
  using Step = void (JourneyU3::*)();
  for (const Step step :
       {&JourneyU3::wakeIt, &JourneyU3::chooseLanguage, &JourneyU3::homeTheGrip,
        &JourneyU3::learnShapes, &JourneyU3::learnButtons, &JourneyU3::hearOfObject,
        &JourneyU3::beLed, &JourneyU3::lead, &JourneyU3::restOnTheDome, &JourneyU3::restOnTheHole,
        &JourneyU3::goCloserAndBack, &JourneyU3::moveAndMark, &JourneyU3::stopForces,
        &JourneyU3::goAway}) {
    (this->*step)();
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace relievo
