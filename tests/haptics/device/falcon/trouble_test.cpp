// SPDX-License-Identifier: BSD-3-Clause
// Everything that can go wrong while touching: noticed within 20 frames, the next frame on the
// wire carries zero, and it recovers without a restart.
#include <gmock/gmock.h>

#include "tests/haptics/device/falcon/falcon_fixture.h"

namespace relievo::falcon {
namespace {

using emulator::FalconEmulator;
using test::RunningFalconTest;

class FalconTroubleTest : public RunningFalconTest {
 protected:
  /// Starts a trouble while touching.
  void trouble(const std::function<void(FalconEmulator&)>& start) {
    beginTouching();
    falcon([&](auto& f) {
      f.forgetCommands();
      start(f);
    });
  }
  /// Within 20 ms of the emulator's clock a frame with zero arrives.
  bool zeroFollows() {
    return stepUntil(
        [this] {
          return falcon([](auto& f) {
            return std::any_of(f.commands().begin(), f.commands().end(),
                               [](const auto& c) { return c.neutral(); });
          });
        },
        23);
  }
  bool touchesAgain(int within_ms = 400) {
    return stepUntil([this] { return norm(felt()) > 1.9; }, within_ms);
  }
};

TEST_F(FalconTroubleTest, ALostByteOfAnAnswerCostsOneZeroFrame) {
  trouble([](auto& f) { f.troubles.lose_answer_bytes = 1; });
  EXPECT_TRUE(zeroFollows());
  EXPECT_EQ(device_->status().counts.stalls, 0U);
  EXPECT_TRUE(touchesAgain()) << "by itself";
  EXPECT_EQ(fault_, DeviceFault::none);
  EXPECT_GE(device_->status().counts.hiccups + device_->status().counts.malformed, 1U);
}

TEST_F(FalconTroubleTest, ALostByteOfACommandCostsOneZeroFrame) {
  trouble([](auto& f) { f.troubles.lose_command_bytes = 1; });
  EXPECT_TRUE(zeroFollows());
  EXPECT_TRUE(touchesAgain());
  EXPECT_EQ(fault_, DeviceFault::none);
  EXPECT_GE(device_->status().counts.hiccups, 1U);
}

TEST_F(FalconTroubleTest, OfAShortFrameNothingIsUsed) {
  const auto before = [this] { return reading_.position; };
  trouble([](auto& f) { f.troubles.short_answers = 1; });
  const DeviceMm place = before();
  EXPECT_TRUE(zeroFollows());
  EXPECT_LT(norm(reading_.position - place), 0.1);
  EXPECT_TRUE(touchesAgain());
  EXPECT_EQ(device_->status().counts.malformed, 1U);
}

TEST_F(FalconTroubleTest, AnOverrunIsCountedAndItsFrameDropped) {
  trouble([](auto& f) { f.troubles.overruns = 1; });
  EXPECT_TRUE(zeroFollows());
  EXPECT_TRUE(touchesAgain());
  EXPECT_EQ(device_->status().counts.overruns, 1U);
}

TEST_F(FalconTroubleTest, AStallSwitchesForcesOffUntilItAnswers) {
  trouble([](auto& f) { f.troubles.silent = true; });
  ASSERT_TRUE(stepUntil([this] { return fault_ == DeviceFault::timeout; }, 25));
  step(10);
  EXPECT_EQ(reading_.fault, DeviceFault::timeout) << "as long as it lasts";
  falcon([](auto& f) { f.troubles.silent = false; });
  EXPECT_TRUE(zeroFollows() || lastCommand().neutral());
  ASSERT_TRUE(stepUntil([this] { return reading_.fault == DeviceFault::none; }, 200));
  falcon([](auto& f) { EXPECT_TRUE(f.commands().front().neutral()) << "before anything else"; });
  EXPECT_EQ(device_->status().counts.stalls, 1U);
  EXPECT_TRUE(touchesAgain());
}

TEST_F(FalconTroubleTest, AHungProcessorIsStartedAnew) {
  trouble([](auto& f) { f.troubles.silent = true; });
  ASSERT_TRUE(becomes(LinkState::silent, 600));
  EXPECT_EQ(describe(device_->status()).spoken, "The Falcon does not answer. Forces are off.");
  ASSERT_TRUE(becomes(LinkState::starting, 3000));
  falcon([](auto& f) { f.troubles.silent = false; });
  ASSERT_TRUE(becomes(LinkState::homing, 15'000));
  EXPECT_EQ(falcon([](auto& f) { return f.uploads(); }), 1);
  ASSERT_TRUE(home());
  EXPECT_TRUE(touchesAgain());
}

TEST_F(FalconTroubleTest, ABridgeThatTakesNothingIsAStall) {
  trouble([](auto& f) { f.troubles.clogged = true; });
  ASSERT_TRUE(stepUntil([this] { return fault_ == DeviceFault::timeout; }, 300));
  falcon([](auto& f) { f.troubles.clogged = false; });
  ASSERT_TRUE(zeroFollows());
  falcon([](auto& f) { EXPECT_TRUE(f.commands().front().neutral()); });
  EXPECT_TRUE(touchesAgain(700));
}

TEST_F(FalconTroubleTest, UnpluggedInContactThenReplugged) {
  trouble([](auto& f) { f.unplug(); });
  ASSERT_TRUE(stepUntil([this] { return fault_ == DeviceFault::disconnected; }, 20));
  ASSERT_TRUE(becomes(LinkState::absent, 50));
  EXPECT_EQ(describe(device_->status()).code, "E305");
  step(300);
  EXPECT_NE(reading_.fault, DeviceFault::none);
  falcon([](auto& f) {
    f.powerCycle();
    f.plugIn();
  });
  ASSERT_TRUE(becomes(LinkState::homing, 6000));
  EXPECT_TRUE(lastCommand().neutral()) << "the loop still asks for 2 N";
  ASSERT_TRUE(home());
  EXPECT_TRUE(touchesAgain());
  EXPECT_EQ(device_->status().unplugged, 1U);
}

TEST_F(FalconTroubleTest, AnAnswerThatIsOnlyLateLeavesNoSecondQuestionUnderWay) {
  trouble([](auto& f) { f.hold_answers_ns = 8'000'000; });
  EXPECT_TRUE(zeroFollows());
  falcon([](auto& f) { f.hold_answers_ns = 0; });
  EXPECT_TRUE(touchesAgain());
  falcon([](auto& f) { f.forgetCommands(); });
  step(200);
  EXPECT_LE(falcon([](auto& f) { return f.commands().size(); }), 201U);
}

TEST_F(FalconTroubleTest, LostHomingSwitchesForcesOffAtOnce) {
  trouble([](auto& f) { f.body.forgetHoming(); });
  EXPECT_TRUE(zeroFollows());
  ASSERT_TRUE(becomes(LinkState::homing, 25));
  step(50);
  EXPECT_TRUE(lastCommand().neutral());
  EXPECT_EQ(reading_.fault, DeviceFault::not_ready);
  ASSERT_TRUE(home());
  EXPECT_TRUE(touchesAgain());
}

TEST_F(FalconTroubleTest, AComputerThatSleptKnowsNothingAnyMore) {
  trouble([](auto&) {});
  bus_->slept_ns += 3'600'000'000'000;
  EXPECT_TRUE(zeroFollows());
  step(2);
  EXPECT_EQ(fault_, DeviceFault::timeout);
}

TEST_F(FalconTroubleTest, AStaleForceIsNotShownAfterAnInterruption) {
  // A loop that does not look at faults: it goes on asking with what it was given.
  trouble([](auto& f) { f.troubles.silent = true; });
  loop_runs_ = false;
  step(60);
  falcon([](auto& f) { f.troubles.silent = false; });
  step(100);
  falcon([](auto& f) {
    for (const auto& command : f.commands()) EXPECT_TRUE(command.neutral());
  });
}

TEST_F(FalconTroubleTest, RandomTroublesNeverShowMoreThanWasAsked) {
  beginTouching();
  std::uint32_t random = 12345;
  for (int i = 0; i < 3000; ++i) {
    random = random * 1664525U + 1013904223U;
    if (random >> 26U == 0) {  // Every 64 ms; the line is bad, not dead.
      falcon([&](auto& f) {
        switch (random >> 20U & 7U) {
          case 0:
            f.troubles.lose_answer_bytes = 1 + static_cast<int>(random >> 8U & 15U);
            break;
          case 1:
            f.troubles.lose_command_bytes = 1 + static_cast<int>(random >> 8U & 15U);
            break;
          case 2:
            f.troubles.short_answers = 2;
            break;
          default:
            f.troubles.overruns = 1;
        }
      });
    }
    step();
    ASSERT_LT(norm(felt()), 2.05);
  }
  falcon([](auto& f) { f.troubles = {}; });
  EXPECT_TRUE(touchesAgain()) << describe(device_->status()).screen;
}

}  // namespace
}  // namespace relievo::falcon
