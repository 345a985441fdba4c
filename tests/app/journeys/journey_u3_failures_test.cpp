// SPDX-License-Identifier: BSD-3-Clause
// Failures of journey U3, in the middle of a touch: the device is pulled out and comes back, the
// speech service ends, and then nothing speaks at all. That the program itself ends, and is started
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
constexpr int kHeldLongMs = 1800;            // Of the middle button.
constexpr double kTapN = 0.4;

class JourneyU3Failures : public Exhibition {
 protected:
  JourneyU3Failures() : Exhibition("u3_failures") {}
  void SetUp() override {
    Exhibition::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    begin();
    if (HasFatalFailure()) return;
    passOverToTouch();
  }
  int timesHeard(const QString& sentence) const { return heard().filter(sentence).size(); }
  /// Seconds in which a program that repeats itself would have done so.
  static void wait() { QTest::qWait(4000); }
};

/// U3.x1.
TEST_F(JourneyU3Failures, ADeviceThatIsPulledOutIsSaidOnceAndTheNextVisitorHasItBack) {
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

  falcon_->with([](emulator::FalconEmulator& f) {
    f.powerCycle();
    f.body.forgetHoming();
    f.body.hold({0, 0, 108});  // Where a force would be, if there was one.
  });
  forces_->takePushes();
  usb_.plugIn(falcon_);
  ASSERT_TRUE(reaches(Visit::State::idle));
  begin();
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_EQ(timesHeard("Welcome."), 2);
  passOverToTouch();
  EXPECT_TRUE(touch(kDomeX, kDomeY)) << "it pushes again";
  EXPECT_LE(forces_->takeLargestN(), kLimitN + kMotorStepN);
}

/// U3.x2.
TEST_F(JourneyU3Failures, WithoutTheServiceEspeakSaysItAndWithNeitherTheGripTaps) {
  ASSERT_TRUE(touch(kDomeX, kDomeY));
  forgetHeard();
  speakSlowly(true);
  press(kCentre);
  ASSERT_TRUE(eventually([this] { return speech_->isSpeaking(); }));
  speech_->stop();
  speakSlowly(false);
  forgetHeard();
  press(kCentre);
  ASSERT_TRUE(eventually([this] {
    return heard().last().startsWith("Touching: middle left, 3 centimetres high. Bookmark: Dome.");
  })) << "the other program says it";
  EXPECT_TRUE(action("forces")->isChecked()) << "the touch goes on";

  ASSERT_FALSE(action("feltPatterns")->isChecked());
  QFile mute(path("mute"));
  ASSERT_TRUE(mute.open(QIODevice::WriteOnly));
  press(kCentre);
  ASSERT_TRUE(eventually([this] { return action("feltPatterns")->isChecked(); }));
  EXPECT_THAT(health(), HasSubstr("Speech is not available"));
  // Off, lifted, and on again, which one tap says.
  press(kCentre, kHeldLongMs);
  ASSERT_TRUE(eventually([this] { return !action("forces")->isChecked(); }));
  EXPECT_TRUE(eventually([this] { return forces_->isNeutral(); }));
  handTo(kDomeX, kDomeY, kAboveZ);
  QTest::qWait(1000);
  forces_->takePushes();
  forces_->takeLargestN();
  const bool is_tapped = stalls_.repeatAfterStalls(5, [this] {
    if (action("forces")->isChecked()) press(kCentre, kHeldLongMs);
    forces_->takePushes();
    press(kCentre, kHeldLongMs);
    QTest::qWait(4000);
    return action("forces")->isChecked() && forces_->takePushes() == 1;
  });
  EXPECT_TRUE(is_tapped) << "one tap: yes";
  const double tap_n = forces_->takeLargestN();
  EXPECT_GT(tap_n, 0.05);
  EXPECT_LE(tap_n, kTapN + kMotorStepN);
}

}  // namespace
}  // namespace relievo
