// SPDX-License-Identifier: BSD-3-Clause
// A failure of journey U3, in the middle of a touch: the device is pulled out and comes back. That
// the program itself ends, and is started again with the words "One moment please.", is
// app/exhibit/exhibit_program_test.
#include <gmock/gmock.h>

#include <QAction>
#include <QtTest/QTest>

#include "tests/app/journeys/exhibition.h"

namespace relievo {
namespace {

using testing::HasSubstr;

constexpr double kDomeX = 90, kDomeY = 100;  // Of relief F, mm.

class JourneyU3Failures : public Exhibition {
 protected:
  JourneyU3Failures() : Exhibition("u3_failures") {}
  void SetUp() override {
    if (!qEnvironmentVariableIsSet("RELIEVO_JOURNEY_U3")) {
      GTEST_SKIP() << "a visit is timed by the clock, and ends where the computer stalls: set "
                      "RELIEVO_JOURNEY_U3=1 on a quiet one";
    }
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
TEST_F(JourneyU3Failures, ADeviceThatIsPulledOutIsSaidOnceAndIsThereAgainWithoutForce) {
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

}  // namespace
}  // namespace relievo
