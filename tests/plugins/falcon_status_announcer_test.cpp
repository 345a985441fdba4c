// SPDX-License-Identifier: BSD-3-Clause
// What is said of a Falcon, and what stands on the screen.
#include "plugins/haptics/device/falcon_status_announcer.h"

#include <gtest/gtest.h>

#include "tests/plugins/shouting.h"

namespace relievo {
namespace {

using falcon::LinkState;
using falcon::LinkStatus;

LinkStatus in(LinkState state) {
  LinkStatus status;
  status.state = state;
  return status;
}

TEST(FalconStatusAnnouncer, SpeaksWithoutCodesAndCounts) {
  FalconStatusAnnouncer news;
  EXPECT_EQ(news.take(in(LinkState::busy)), QStringList("The Falcon is busy."));
  LinkStatus starting = in(LinkState::starting);
  starting.attempts = 10;
  QStringList said;
  for (starting.attempt = 1; starting.attempt <= 10; ++starting.attempt) {
    said += news.take(starting);
  }
  EXPECT_EQ(said, (QStringList{"Starting the Falcon.", "Still starting."})) << "of ten attempts";
  starting.attempt = 2;
  EXPECT_EQ(screenText(falcon::describe(starting)),
            QString::fromUtf8("E302: Starting the Falcon – attempt 2 of 10. This is normal."));
}

TEST(FalconStatusAnnouncer, NamesEachArmOnceAndAgainInTheNextHoming) {
  FalconStatusAnnouncer news;
  LinkStatus homing = in(LinkState::homing);
  const QString ask = news.take(homing).value(0);
  EXPECT_TRUE(ask.startsWith("Please ")) << ask.toStdString();
  homing.homed = 0b010;
  EXPECT_EQ(news.take(homing), QStringList("Right arm found."));
  EXPECT_EQ(news.take(homing), QStringList());
  homing.homed = 0b111;
  EXPECT_EQ(news.take(homing), (QStringList{"Top arm found.", "Left arm found."}));
  EXPECT_EQ(news.take(in(LinkState::ready)), QStringList("Falcon ready."));
  homing.homed = 0b001;
  EXPECT_EQ(news.take(homing), (QStringList{"Top arm found.", ask}));
}

TEST(FalconStatusAnnouncer, TheScreenHasCodesAndTheCommandThatHelps) {
  const QString hint = " Touch > Device set-up > Firmware file takes one.";
  EXPECT_TRUE(windowText(in(LinkState::no_firmware)).endsWith(hint));
  const QString failed = windowText(in(LinkState::not_started));
  EXPECT_TRUE(failed.startsWith("E303: ")) << failed.toStdString();
  EXPECT_EQ(failed.count("Touch > Device set-up > Retry"), 1) << failed.toStdString();
  EXPECT_FALSE(windowText(in(LinkState::starting)).contains("Touch >")) << "it is at it";
}

TEST(FalconStatusAnnouncer, TheScreenSpeaksTheWindowsLanguage) {
  int argc = 0;
  const QCoreApplication application(argc, nullptr);
  const test::Shouting shouting;
  LinkStatus homing = in(LinkState::homing);
  homing.homed = 0b010;
  EXPECT_EQ(windowText(homing),
            "E308: PLEASE PULL THE GRIP FULLY OUT, THEN PUSH IT FULLY IN. STILL MISSING: TOP, "
            "LEFT.");
}

}  // namespace
}  // namespace relievo
