// SPDX-License-Identifier: BSD-3-Clause
// From plug to touch: identification, firmware, homing.
#include <gmock/gmock.h>

#include "tests/haptics/device/falcon/falcon_fixture.h"

namespace relievo::falcon {
namespace {

using test::FalconTest;
using test::RunningFalconTest;
using testing::HasSubstr;

TEST_F(FalconTest, FromPlugToTouch) {
  begin();
  EXPECT_TRUE(becomes(LinkState::starting, 1000));
  ASSERT_TRUE(becomes(LinkState::homing, 5000)) << englishText(describe(device_->status()));
  EXPECT_EQ(falcon([](auto& f) { return f.uploads(); }), 1);
  EXPECT_EQ(falcon([](auto& f) { return f.lastImage(); }), firmware_) << "every byte, in order";
  EXPECT_EQ(falcon([](auto& f) { return f.unpurgedUploads(); }), 0)
      << "late answers to hello are not taken for the echo";
  EXPECT_FALSE(device_->status().firmware_was_running);
  step(50);
  EXPECT_EQ(reading_.fault, DeviceFault::not_ready);
  EXPECT_EQ(lastCommand().lights, red);
  EXPECT_THAT(englishText(describe(device_->status())), HasSubstr("top, right, left"));

  hold(0, 0, 172);
  step(20);
  hold(0, 0, 90);
  ASSERT_TRUE(becomes(LinkState::pull_out, 50));
  step(10);
  EXPECT_EQ(lastCommand().lights, blue);
  EXPECT_EQ(reading_.fault, DeviceFault::not_ready) << "no force before it was pulled out";
  hold(0, 0, 169);
  step(50);
  EXPECT_EQ(device_->status().state, LinkState::pull_out) << "not far enough";
  EXPECT_EQ(reading_.fault, DeviceFault::not_ready);
  hold(0, 0, 171);
  ASSERT_TRUE(becomes(LinkState::ready, 50));
  step(10);
  EXPECT_EQ(reading_.fault, DeviceFault::none);
  EXPECT_LT(clock_->now(), 21'000'000'000) << "within 20 seconds";
}

using Request = std::array<int, 3>;  // Request, value, index.
constexpr std::array<Request, 8> kToRun{{{0, 1, 0},
                                         {0, 2, 0},
                                         {9, 1, 0},
                                         {3, 0x0002, 0},
                                         {4, 0x0008, 0},
                                         {2, 0, 0},
                                         {0, 1, 0},
                                         {0, 2, 0}}};
constexpr std::array<Request, 13> kToUpload{{{0, 1, 0},
                                             {0, 2, 0},
                                             {9, 16, 0},
                                             {3, 0x4138, 0},
                                             {4, 0x0008, 0},
                                             {2, 0, 0},
                                             {1, 0x0200, 0},
                                             {1, 0x0100, 0},
                                             {1, 0x0101, 0},
                                             // After the answer to hello.
                                             {1, 0x0100, 0},
                                             {3, 0x0015, 0},
                                             {0, 1, 0},
                                             {0, 2, 0}}};
std::vector<Request> requestsTo(const emulator::FalconEmulator& falcon) {
  std::vector<Request> all;
  for (const auto& r : falcon.requests()) all.push_back({r.request, r.value, r.index});
  return all;
}

TEST_F(FalconTest, TheBridgeIsAskedWhatThePageOfTheProtocolSays) {
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 5000));
  std::vector<Request> expected(kToRun.begin(), kToRun.end());
  expected.insert(expected.end(), kToUpload.begin(), kToUpload.end());
  expected.insert(expected.end(), kToRun.begin(), kToRun.end());
  EXPECT_EQ(falcon(requestsTo), expected);
}

TEST_F(RunningFalconTest, ARunningOneIsAskedOnlyForTheRunningProtocol) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 200));
  step(100);
  EXPECT_EQ(falcon(requestsTo), std::vector<Request>(kToRun.begin(), kToRun.end()));
}

TEST_F(RunningFalconTest, NeedsNoFileWhenFirmwareRuns) {
  firmware_.clear();
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 200));
  EXPECT_TRUE(device_->status().firmware_was_running);
  EXPECT_EQ(falcon([](auto& f) { return f.uploads(); }), 0);
}

TEST_F(FalconTest, OneArmThatIsNotHomedIsNamedAndKeepsForceOff) {
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 5000));
  // Far to a side the top arm does not reach its place.
  hold(0, 0, 172);
  step(20);
  hold(0, -25, 86);
  step(200);
  const LinkStatus& status = device_->status();
  ASSERT_EQ(status.state, LinkState::homing);
  ASSERT_NE(status.homed, 0);
  ASSERT_NE(status.homed, kAllHomed);
  force_ = {0, 0, 3};
  step(50);
  EXPECT_TRUE(lastCommand().neutral());
  EXPECT_EQ(reading_.fault, DeviceFault::not_ready);
}

TEST_F(FalconTest, HomingFollowsTheOrderThatTheMessageAsksFor) {
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 5000));
  EXPECT_THAT(englishText(describe(device_->status())),
              testing::StartsWith("Please pull the grip fully out, then push it fully in."));
  step(20);
  hold(0, 0, 90);
  step(50);
  EXPECT_EQ(device_->status().homed, 0) << "in alone finds nothing";
  hold(0, 0, 172);
  step(50);
  EXPECT_EQ(device_->status().state, LinkState::homing);
  hold(0, 0, 90);
  EXPECT_TRUE(becomes(LinkState::pull_out, 50));
  EXPECT_THAT(englishText(describe(device_->status())),
              HasSubstr("Pull the grip fully out once more"));
}

TEST_F(FalconTest, AHintIsGivenAfterTwentySecondsOfHoming) {
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 5000));
  step(19'900);
  EXPECT_THAT(englishText(describe(device_->status())), testing::Not(HasSubstr("do not twist")));
  step(200);
  const Message message = describe(device_->status());
  EXPECT_EQ(codeOf(message), "E308");
  EXPECT_THAT(englishText(message), HasSubstr("do not twist"));
  EXPECT_THAT(englishSpoken(message), HasSubstr("do not twist"));
  ASSERT_TRUE(home()) << "there is no time limit";
  falcon([](auto& f) { f.body.forgetHoming(); });
  ASSERT_TRUE(becomes(LinkState::homing, 100));
  step(1000);
  EXPECT_THAT(englishText(describe(device_->status())), testing::Not(HasSubstr("do not twist")));
}

TEST_F(FalconTest, TriesAgainWhenTheBootLoaderIsDeafLateOrEchoesWrongly) {
  falcon([](auto& f) {
    f.troubles.deaf_hellos = 3;
    f.troubles.late_hellos = 2;
    f.troubles.wrong_echoes = 2;
  });
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 15'000)) << englishText(describe(device_->status()));
  EXPECT_EQ(device_->status().attempt, 3) << "two uploads broke off at the wrong echo";
  EXPECT_EQ(falcon([](auto& f) { return f.lastImage(); }), firmware_);
}

TEST_F(FalconTest, GivesUpAfterTenAttemptsAndSaysWhereThenRetries) {
  falcon([](auto& f) { f.troubles.wrong_echoes = 1000; });
  begin();
  ASSERT_TRUE(becomes(LinkState::not_started, 30'000));
  const Message message = describe(device_->status());
  EXPECT_EQ(codeOf(message), "E303");
  EXPECT_THAT(englishText(message), HasSubstr("10 attempts"));
  EXPECT_THAT(englishText(message), HasSubstr("Touch > Device set-up > Retry"));
  EXPECT_EQ(bus_->opens, 1 + 3) << "anew before every third attempt";
  EXPECT_THAT(englishText(message), HasSubstr("byte 992 of 8464")) << "the last whole chunk";
  falcon([](auto& f) { f.troubles.wrong_echoes = 0; });
  device_->retry();
  EXPECT_TRUE(becomes(LinkState::homing, 5000));
}

TEST_F(FalconTest, GoesOnForTwentySecondsBeforeItGivesUp) {
  falcon([](auto& f) { f.troubles.wrong_echoes = 1000; });
  begin();
  ASSERT_TRUE(becomes(LinkState::starting, 1000));
  const std::int64_t began_ns = clock_->now();
  ASSERT_TRUE(stepUntil([this] { return device_->status().attempt == 4; }, 2000))
      << "the first ones without a pause";
  ASSERT_TRUE(becomes(LinkState::not_started, 30'000));
  EXPECT_GE(clock_->now() - began_ns, 20'000'000'000);
}

TEST_F(FalconTest, APauseBetweenAttemptsEndsWithThePlug) {
  falcon([](auto& f) { f.troubles.wrong_echoes = 1000; });
  begin();
  ASSERT_TRUE(stepUntil([this] { return device_->status().attempt == 8; }, 20'000));
  step(1000);
  falcon([](auto& f) { f.unplug(); });
  EXPECT_TRUE(becomes(LinkState::absent, 500));
  EXPECT_EQ(device_->status().unplugged, 1U);
}

TEST_F(FalconTest, OneThatIsBusyWhenItIsOpenedAnewWasNotUnplugged) {
  falcon([](auto& f) { f.troubles.wrong_echoes = 1000; });
  begin();
  ASSERT_TRUE(becomes(LinkState::starting, 1000));
  bus_->pretend = Presence::busy;
  ASSERT_TRUE(becomes(LinkState::busy, 5000));
  EXPECT_EQ(codeOf(describe(device_->status())), "E304");
  EXPECT_EQ(device_->status().attempt, 4);
  falcon([](auto& f) { f.troubles.wrong_echoes = 0; });
  bus_->pretend = Presence::present;
  ASSERT_TRUE(becomes(LinkState::starting, 1500));
  EXPECT_EQ(device_->status().attempt, 4) << "the count goes on";
  EXPECT_TRUE(becomes(LinkState::homing, 5000));
  EXPECT_EQ(device_->status().unplugged, 0U);
}

TEST_F(FalconTest, SaysWhereFirmwareWasSoughtAndGoesOnWhenItIsThere) {
  const std::vector<std::uint8_t> image = firmware_;
  firmware_.clear();
  begin();
  ASSERT_TRUE(becomes(LinkState::no_firmware, 1000));
  EXPECT_THAT(englishText(describe(device_->status())), HasSubstr("Places searched"));
  firmware_ = image;
  device_->retry();
  EXPECT_TRUE(becomes(LinkState::homing, 5000));
}

TEST_F(FalconTest, FirmwareThatIsInstalledMeanwhileIsLoadedWithoutBeingAsked) {
  const std::vector<std::uint8_t> image = firmware_;
  firmware_.clear();
  begin();
  ASSERT_TRUE(becomes(LinkState::no_firmware, 1000));
  const int asked = firmware_asked_;
  step(5000);
  EXPECT_EQ(device_->status().state, LinkState::no_firmware);
  EXPECT_NEAR(firmware_asked_ - asked, 5, 1) << "once a second";
  firmware_ = image;
  EXPECT_TRUE(becomes(LinkState::homing, 1500 + 3000)) << englishText(describe(device_->status()));
}

class ZeroBeforeHelloTest : public FalconTest {
 protected:
  ZeroBeforeHelloTest() : FalconTest({.leading_zero = true}) {}
};
TEST_F(ZeroBeforeHelloTest, IsTolerated) {
  begin();
  EXPECT_TRUE(becomes(LinkState::homing, 5000));
  EXPECT_EQ(device_->status().attempt, 1);
}

class LateClearToSendTest : public FalconTest {
 protected:
  LateClearToSendTest() : FalconTest({.clear_to_send_delay_ns = 150'000'000}) {}
};
TEST_F(LateClearToSendTest, IsWaitedFor) {
  begin();
  EXPECT_TRUE(becomes(LinkState::homing, 5000));
  EXPECT_EQ(device_->status().attempt, 1);
}

class NoClearToSendTest : public FalconTest {
 protected:
  NoClearToSendTest() : FalconTest({.clear_to_send = false}) {}
};
TEST_F(NoClearToSendTest, IsDoneWithout) {
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 5000));
  EXPECT_EQ(device_->status().attempt, 1);
  falcon([](auto& f) {
    // From the baud rate of the upload to that of the running protocol: the wait is part of it.
    std::int64_t locked_ns = 0, runs_ns = 0;
    for (const auto& r : f.requests()) {
      if (r.request == 3 && r.value == 0x0015) locked_ns = r.time_ns;
      if (r.request == 3 && r.value == 0x0002) runs_ns = r.time_ns;
    }
    EXPECT_GT(runs_ns - locked_ns, 200'000'000);
  });
}

TEST_F(FalconTest, UnpluggedWhileStartingIsWaitedFor) {
  begin();
  ASSERT_TRUE(stepUntil([this] { return device_->status().uploaded_bytes > 2000; }, 5000));
  falcon([](auto& f) {
    f.unplug();
    f.powerCycle();
  });
  ASSERT_TRUE(becomes(LinkState::absent, 500));
  EXPECT_EQ(codeOf(describe(device_->status())), "E305");
  falcon([](auto& f) { f.plugIn(); });
  EXPECT_TRUE(becomes(LinkState::homing, 6000));
}

TEST_F(FalconTest, AbsentForbiddenAndBusyAreToldApart) {
  const auto failure = [this] {
    try {
      device_->open();
    } catch (const DeviceError& error) {
      return error.code + "|" + error.what();
    }
    return std::string("opened");
  };
  bus_->pretend = Presence::forbidden;
  EXPECT_THAT(failure(), HasSubstr("E301|A Falcon is plugged in but this account"));
  bus_->pretend = Presence::busy;
  EXPECT_THAT(failure(), HasSubstr("E304|Another program"));
  bus_->pretend = Presence::broken;
  EXPECT_THAT(failure(), HasSubstr("Input/output error"));
  falcon([](auto& f) { f.unplug(); });
  EXPECT_THAT(failure(), HasSubstr("|No Falcon is plugged in"));
}

TEST_F(RunningFalconTest, OneThatIsBusyIsTakenWhenItIsFree) {
  bus_->pretend = Presence::busy;
  begin();
  ASSERT_TRUE(becomes(LinkState::busy, 100));
  bus_->pretend = Presence::present;
  EXPECT_TRUE(becomes(LinkState::ready, 1500));
}

TEST_F(FalconTest, FilesAreReadAtOrdinaryPriorityWhateverTheLinksOwn) {
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 3000));
  EXPECT_GE(firmware_asked_, 1);
  EXPECT_EQ(firmware_policy_, SCHED_OTHER);
}

}  // namespace
}  // namespace relievo::falcon
