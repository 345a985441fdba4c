// SPDX-License-Identifier: BSD-3-Clause
// Failures of journey U3: the device is pulled out in the middle of a touch and comes back, no
// voice speaks any more, headphones are pulled out. That the program itself ends, and is started
// again with the words "One moment please.", is app/exhibit/exhibit_program_test.
#include <gmock/gmock.h>

#include <QAction>
#include <QFile>
#include <QtTest/QTest>

#include "tests/app/journeys/exhibition.h"

namespace relievo {
namespace {

using testing::HasSubstr;

constexpr double kDomeX = 90, kDomeY = 100;  // Of relief F, mm.

class JourneyU3Failures : public Exhibition {
 protected:
  JourneyU3Failures() : Exhibition("u3_failures") {}
  void beginTouch() {
    begin();
    if (!HasFatalFailure()) passOverToTouch();
  }
  int timesHeard(const QString& sentence) const { return heard().filter(sentence).size(); }
  /// Seconds in which a program that repeats itself would have done so.
  static void wait() { QTest::qWait(4000); }
};

/// U3.x1.
TEST_F(JourneyU3Failures, ADeviceThatIsPulledOutIsSaidOnceAndIsThereAgainWithoutForce) {
  beginTouch();
  ASSERT_FALSE(HasFatalFailure());
  ASSERT_TRUE(touch(kDomeX, kDomeY));
  EXPECT_LE(forces_->takeLargestN(), kLimitN + kMotorStepN);
  usb_.unplug();
  ASSERT_TRUE(reaches(Visit::State::fault));
  ASSERT_TRUE(eventually([this] { return timesHeard("This exhibit needs help.") == 1; }));
  EXPECT_TRUE(eventually([this] { return heard().last() == "en|Please ask the staff."; }));
  EXPECT_FALSE(action("forces")->isChecked());
  EXPECT_THAT(health(), HasSubstr("help was asked for"));
  forgetHeard();
  wait();
  EXPECT_EQ(timesHeard("This exhibit needs help."), 1) << "no endless speech";

  forces_->takePushes();
  usb_.plugIn(falcon_);
  ASSERT_TRUE(reaches(Visit::State::idle)) << "it is there for the next visitor";
  wait();
  EXPECT_EQ(forces_->takePushes(), 0) << "and pushes nobody";
}

/// U3.x2.
TEST_F(JourneyU3Failures, WhereNoVoiceSpeaksAnyMoreTheGripTapsAndTheReliefIsTouchedAllTheSame) {
  beginTouch();
  ASSERT_FALSE(HasFatalFailure());
  ASSERT_TRUE(touch(kDomeX, kDomeY));
  EXPECT_FALSE(action("feltPatterns")->isChecked());
  QFile(path("mute")).open(QIODevice::WriteOnly);
  speech_->stop();
  press(kCentre);  // Where am I?
  ASSERT_TRUE(eventually([this] { return action("feltPatterns")->isChecked(); }));
  EXPECT_THAT(health(), HasSubstr("Speech is not available"));
  EXPECT_EQ(visit().state(), Visit::State::touching);
  EXPECT_TRUE(action("forces")->isChecked());
  EXPECT_TRUE(press(kPlus, [this] { return document().detail() == 2; })) << "still usable";
  EXPECT_TRUE(exhibit_->control().caption().text().contains("Closer.")) << "and it can be read";
}

/// U3.x4.
TEST_F(JourneyU3Failures, HeadphonesThatArePulledOutLeaveARoomThatIsNotTooLoud) {
  ASSERT_TRUE(waitsForGrip());
  press(kForward);
  ASSERT_TRUE(reaches(Visit::State::language));
  ASSERT_TRUE(eventually([this] { return heard().size() >= 6; })) << "the welcome";
  for (int i = 0; i < 2; ++i) press(kPlus);
  ASSERT_TRUE(eventually([this] { return heard().last() == "en|Volume 80 percent."; }));
  const double by_headphones = volume();
  speakSlowly(true);
  press(kPlus);  // As loud as it may be: said again, and lasts.
  ASSERT_TRUE(eventually([this] { return timesHeard("Volume 80 percent.") >= 2; }));
  forgetHeard();
  ASSERT_TRUE(sound_->sendTo("room"));
  ASSERT_TRUE(hears({"Welcome."})) << "speech goes on: what was said last but the volume";
  EXPECT_LT(volume(), by_headphones);
  press(kPlus);
  ASSERT_TRUE(hears({"Volume 50 percent."})) << "no button goes above it";
  speakSlowly(false);
  ASSERT_TRUE(reaches(Visit::State::idle)) << "nobody chose";
  forgetHeard();
  press(kForward);
  ASSERT_TRUE(hears({"Welcome."}));
  press(kPlus);
  ASSERT_TRUE(eventually([this] { return heard().last() == "en|Volume 50 percent."; }))
      << "nor for the next visitor";
  ASSERT_TRUE(sound_->sendTo("ears"));
  QTest::qWait(1000);
  press(kPlus);
  EXPECT_TRUE(eventually([this] { return heard().last() == "en|Volume 71 percent."; }))
      << "with headphones again";
}

}  // namespace
}  // namespace relievo
