// SPDX-License-Identifier: BSD-3-Clause
// Everything that can go wrong while touching: noticed within 20 frames, the next frame on the
// wire carries zero, and it recovers without a restart.
#include <gmock/gmock.h>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/device/falcon/falcon_fixture.h"
#include "tests/haptics/device/falcon/faults.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo::falcon {
namespace {

using emulator::FalconEmulator;
using test::Fault;
using test::kFaults;
using test::mendsItself;
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

class FalconFaultTest : public FalconTroubleTest, public ::testing::WithParamInterface<Fault> {
 protected:
  /// Noticed within 20 frames: the next command carries zero, or none comes and the loop is told.
  bool noticed() {
    return stepUntil(
        [this] {
          return falcon([this](auto& f) {
            return test::nextCommandIsNeutral(f) ||
                   (f.commands().size() < 2 && fault_ != DeviceFault::none);
          });
        },
        23);
  }
};

TEST_P(FalconFaultTest, EndsInItsDocumentedStateAndMendsWithoutARestart) {
  const Fault& fault = GetParam();
  trouble(fault.strike);
  ASSERT_TRUE(noticed());
  step(50);  // The status is told every 20 ms.
  const std::uint64_t counted_at_once = fault.counted(device_->status());
  EXPECT_EQ(fault_, fault.told);
  falcon([&](auto& f) {
    f.forgetCommands();
    fault.mend(f);
  });
  if (fault.told != DeviceFault::none) {
    ASSERT_TRUE(
        stepUntil([this] { return falcon([](auto& f) { return !f.commands().empty(); }); }, 6000));
    EXPECT_TRUE(lastCommand().neutral()) << "the loop goes on asking for 2 N";
  }
  if (fault.homing_lost) {
    ASSERT_TRUE(becomes(LinkState::homing, 6000));
    step(50);
    EXPECT_TRUE(lastCommand().neutral());
    EXPECT_NE(reading_.fault, DeviceFault::none);
    ASSERT_TRUE(home());
  }
  EXPECT_TRUE(touchesAgain());
  EXPECT_GE(std::max(counted_at_once, fault.counted(device_->status())), 1U);
}

/// What the test above sees comes from the fault: an emulator that carries none out fails it.
TEST_P(FalconFaultTest, OfAHealthyFalconNothingOfItIsSeen) {
  trouble(mendsItself);
  EXPECT_FALSE(noticed());
  step(40);
  EXPECT_EQ(GetParam().counted(device_->status()), 0U);
  EXPECT_EQ(fault_, DeviceFault::none);
}
INSTANTIATE_TEST_SUITE_P(Faults, FalconFaultTest, ::testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST_F(FalconTroubleTest, OfAShortFrameNothingIsUsed) {
  const auto before = [this] { return reading_.position; };
  trouble([](auto& f) { f.troubles.short_answers = 1; });
  const DeviceMm place = before();
  EXPECT_TRUE(zeroFollows());
  EXPECT_LT(norm(reading_.position - place), 0.1);
  EXPECT_TRUE(touchesAgain());
  EXPECT_EQ(device_->status().counts.malformed, 1U);
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

TEST_F(FalconTroubleTest, InAStallEveryFrameOnTheWireIsZero) {
  trouble([](auto& f) { f.troubles.silent = true; });
  step(300);
  falcon([](auto& f) {
    EXPECT_TRUE(f.commands().empty());
    // The one that was under way aside; then after 5, 10, 15, 20 and every 20 ms.
    ASSERT_GE(f.unheeded().size(), 15U);
    EXPECT_LE(f.unheeded().size(), 20U);
    EXPECT_TRUE(std::all_of(f.unheeded().begin() + 1, f.unheeded().end(),
                            [](const auto& c) { return c.neutral(); }));
    EXPECT_LT(f.unheeded()[1].time_ns - f.unheeded()[0].time_ns, 7'000'000);
  });
}

TEST_F(FalconTroubleTest, MeasuresAgainstSilenceComeAtTheirTimes) {
  beginTouching();
  step(100);
  falcon([](auto& f) {
    f.troubles.silent = true;
    f.forgetRequests();
  });
  const std::int64_t began_ns = clock_->now();
  const auto sinceMs = [&] { return 1e-6 * static_cast<double>(clock_->now() - began_ns); };
  const auto purges = [this](int value) {
    return falcon([value](auto& f) {
      return std::count_if(f.requests().begin(), f.requests().end(),
                           [value](const auto& r) { return r.request == 0 && r.value == value; });
    });
  };
  ASSERT_TRUE(stepUntil([this] { return fault_ == DeviceFault::timeout; }, 40));
  EXPECT_NEAR(sinceMs(), 20, 4);
  ASSERT_TRUE(stepUntil([&] { return purges(1) > 0 && purges(2) > 0; }, 1000));
  EXPECT_NEAR(sinceMs(), 500, 10);
  ASSERT_TRUE(becomes(LinkState::silent, 5));
  ASSERT_TRUE(becomes(LinkState::checking, 3000));
  EXPECT_NEAR(sinceMs(), 2000, 25);
  EXPECT_EQ(device_->status().counts.purges, 3U);
}

TEST_F(FalconTroubleTest, AHungProcessorIsStartedAnew) {
  trouble([](auto& f) { f.troubles.silent = true; });
  ASSERT_TRUE(becomes(LinkState::silent, 600));
  EXPECT_EQ(englishSpoken(describe(device_->status())),
            "The Falcon does not answer. Forces are off.");
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

TEST_F(FalconTroubleTest, LosingTheHomingOfAnyArmEndsForce) {
  beginTouching();
  for (int lost = 1; lost < 7; ++lost) {
    falcon([lost](auto& f) {
      f.forgetCommands();
      f.body.forgetHoming(lost);
    });
    step(30);
    falcon([](auto& f) { EXPECT_TRUE(test::everyNextCommandIsNeutral(f)); });
    EXPECT_EQ(reading_.fault, DeviceFault::not_ready);
    EXPECT_EQ(device_->status().state, LinkState::homing) << lost;
    EXPECT_EQ(device_->status().homed, kAllHomed & ~lost);
    ASSERT_TRUE(home()) << lost;
    hold(10, -5, 130);
    ASSERT_TRUE(touchesAgain()) << lost;
  }
}

TEST_F(FalconTroubleTest, UnpluggedInContactThenReplugged) {
  trouble([](auto& f) { f.unplug(); });
  ASSERT_TRUE(stepUntil([this] { return fault_ == DeviceFault::disconnected; }, 20));
  ASSERT_TRUE(becomes(LinkState::absent, 50));
  EXPECT_EQ(codeOf(describe(device_->status())), "E305");
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

TEST_F(FalconTroubleTest, AnAnswerThatWasAskedForTwiceIsTimedFromTheFirstQuestion) {
  trouble([](auto& f) { f.troubles.lose_command_bytes = 1; });
  step(50);
  EXPECT_GE(device_->status().counts.hiccups, 1U);
  EXPECT_GT(device_->status().worst_answer_ms, 4.9);
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

TEST_F(FalconTroubleTest, AFreshForceFromBeforeAnInterruptionIsNotShown) {
  trouble([](auto&) {});
  bus_->slept_ns += 3'600'000'000'000;  // Over at once: the order is still fresh after it.
  loop_runs_ = false;
  step(15);
  falcon([](auto& f) {
    ASSERT_GT(f.commands().size(), 10U);
    // The one that was under way aside.
    EXPECT_TRUE(std::all_of(f.commands().begin() + 2, f.commands().end(),
                            [](const auto& c) { return c.neutral(); }));
  });
}

TEST_F(FalconTroubleTest, AfterNoiseOnTheLineForceRisesGently) {
  trouble([](auto& f) { f.troubles.noisy_answers = 1; });
  EXPECT_TRUE(stepUntil([this] { return norm(felt()) < 0.1; }, 5));
  step(10);
  EXPECT_LT(norm(felt()), 0.7) << "50 N/s";
  EXPECT_TRUE(touchesAgain());
}

TEST_F(FalconTroubleTest, AnImpossiblePoseKeepsTheLastPlaceAndNoForceUntilItIsOver) {
  beginTouching();
  const DeviceMm place = reading_.position;
  falcon([](auto& f) { f.troubles.impossible_encoders = true; });
  step(5);
  falcon([](auto& f) { f.forgetCommands(); });
  step(100);
  EXPECT_LT(norm(reading_.position - place), 0.1);
  EXPECT_TRUE(falcon([](auto& f) {
    return std::all_of(f.commands().begin(), f.commands().end(),
                       [](const auto& c) { return c.neutral(); });
  }));
  falcon([](auto& f) { f.troubles.impossible_encoders = false; });
  EXPECT_TRUE(touchesAgain());
}

TEST_F(FalconTroubleTest, AReadThatFailsOnceIsZeroAtOnceAndNoMore) {
  trouble([](auto& f) { f.troubles.failed_reads = 1; });
  ASSERT_TRUE(stepUntil(
      [this] { return falcon([](auto& f) { return test::nextCommandIsNeutral(f); }); }, 3));
  step(8);
  EXPECT_LT(norm(felt()), 0.6) << "50 N/s";
  EXPECT_TRUE(touchesAgain());
  EXPECT_EQ(bus_->opens, 1);
  EXPECT_EQ(fault_, DeviceFault::none);
  falcon([](auto& f) { f.forgetCommands(); });
  step(200);
  EXPECT_LE(falcon([](auto& f) { return f.commands().size(); }), 201U) << "one question at a time";
}

/// The motors' side of the line works: whoever only looked at the other one would leave the force.
TEST_F(FalconTroubleTest, ReadsThatGoOnFailingLeaveNoForceAndAreNotOpenedForEver) {
  trouble([](auto& f) { f.troubles.failed_reads = test::kForEver; });
  ASSERT_TRUE(stepUntil([this] { return fault_ == DeviceFault::timeout; }, 25));
  EXPECT_LT(norm(felt()), 1e-9);
  step(10);
  falcon([](auto& f) {
    ASSERT_GT(f.commands().size(), 3U);
    EXPECT_TRUE(test::everyNextCommandIsNeutral(f));
    for (std::size_t i = f.commands().size() - 3; i < f.commands().size(); ++i) {
      EXPECT_EQ(f.commands()[i].lights, red) << "before it was closed";
    }
  });
  ASSERT_TRUE(becomes(LinkState::silent, 200));
  EXPECT_THAT(englishText(describe(device_->status())),
              testing::HasSubstr("although it is plugged in"));
  step(1000);
  EXPECT_LE(bus_->opens, 1 + 6) << "20, 40, 80, 160, 320, 640 ms";
  EXPECT_GE(bus_->opens, 1 + 4);
  EXPECT_EQ(device_->status().unplugged, 0U);
  EXPECT_EQ(firmware_asked_, 0) << "nothing of it hints at the firmware";

  ASSERT_TRUE(becomes(LinkState::not_started, 15'000));
  const Message message = describe(device_->status());
  EXPECT_EQ(codeOf(message), "E303");
  EXPECT_THAT(englishText(message),
              testing::StartsWith("The connection to the Falcon failed 10 times, "
                                  "although it is plugged in. Forces are off"));
  const int opens = bus_->opens;
  step(60'000);
  EXPECT_LE(bus_->opens - opens, 6) << "one in ten seconds";
  EXPECT_GE(bus_->opens - opens, 5);
  falcon([](auto& f) {
    EXPECT_TRUE(test::everyNextCommandIsNeutral(f));
    f.troubles.failed_reads = 0;
  });
  ASSERT_TRUE(becomes(LinkState::ready, 11'000)) << "without a restart";
  EXPECT_TRUE(touchesAgain());
}

TEST_F(FalconTroubleTest, ReadsThatGoOnFailingAreTriedAtOnceWhenAsked) {
  trouble([](auto& f) { f.troubles.failed_reads = test::kForEver; });
  ASSERT_TRUE(becomes(LinkState::not_started, 20'000));
  step(1000);
  falcon([](auto& f) { f.troubles.failed_reads = 0; });
  device_->retry();
  EXPECT_TRUE(becomes(LinkState::ready, 300));
}

TEST_F(FalconTroubleTest, ReadsThatFailNowAndThenAreNotOpenedInALoop) {
  beginTouching();
  for (int i = 0; i < 40; ++i) {
    falcon([](auto& f) { f.troubles.failed_reads = 5; });  // Enough for one opening.
    step(100);
  }
  EXPECT_LE(bus_->opens, 1 + 20);
  EXPECT_GE(bus_->opens, 1 + 5);
}

TEST_F(FalconTroubleTest, ClosedWhileReadsFailTheMotorsAreAtZero) {
  trouble([](auto& f) { f.troubles.failed_reads = test::kForEver; });
  finish();
  EXPECT_LT(norm(felt()), 1e-9);
  device_.reset();
  EXPECT_LT(norm(felt()), 1e-9);
  EXPECT_TRUE(lastCommand().neutral());
}

TEST_F(FalconTroubleTest, PulledWhileReadsFailItIsUnplugged) {
  trouble([](auto& f) { f.troubles.failed_reads = test::kForEver; });
  ASSERT_TRUE(becomes(LinkState::silent, 200));
  falcon([](auto& f) { f.unplug(); });
  ASSERT_TRUE(becomes(LinkState::absent, 200));
  EXPECT_EQ(codeOf(describe(device_->status())), "E305");
  EXPECT_EQ(device_->status().unplugged, 1U);
  step(2);
  EXPECT_EQ(fault_, DeviceFault::disconnected);
}

/// Every call fails, yet it is found each time.
class DeadPort : public Port {
 public:
  PortResult request(const BridgeRequest& /*request*/) override { return PortResult::gone; }
  PortResult write(std::span<const std::uint8_t> /*bytes*/) override { return PortResult::gone; }
  Incoming read(std::span<std::uint8_t> /*into*/, std::int64_t /*until_ns*/) override {
    return {0, PortResult::gone};
  }
  void discardInput() override {}
  bool clearToSend() const override { return false; }
  LineErrors lineErrors() const override { return {}; }
};
class DeadBus : public Bus {
 public:
  Opening open() override {
    ++opens;
    return {.presence = Presence::present, .port = std::make_unique<DeadPort>(), .detail = {}};
  }
  void waitForChange(std::int64_t until_ns) override {
    now_ns_ = until_ns;
    if (now_ns_ > kUntilNs) stop.request_stop();
  }
  std::int64_t now() override { return now_ns_ += 1000; }

  static constexpr std::int64_t kUntilNs = 60'000'000'000;
  int opens = 0;
  std::stop_source stop;

 private:
  std::int64_t now_ns_ = 0;
};
TEST(FalconLink, APortThatIsDeadEachTimeIsNotOpenedInALoop) {
  DeadBus bus;
  LinkMailbox mailbox;
  int firmware_asked = 0;
  Link link(bus, mailbox, [&] {
    ++firmware_asked;
    return relievo::test::madeImage();
  });
  link.run(bus.stop.get_token(), {});
  EXPECT_LE(bus.opens, 16) << "in a minute";
  EXPECT_GE(bus.opens, 10);
  EXPECT_EQ(firmware_asked, 0);
}

class FrozenFalconTest : public test::FalconTest {};
TEST_F(FrozenFalconTest, EncodersThatStandStillAfterTheStartGetNoForce) {
  // As was seen after loads whose echo nobody had checked: frames come, the arms are homed, and
  // the grip seems to stay where it is.
  falcon([](auto& f) { f.troubles.frozen_encoders = true; });
  begin();
  ASSERT_TRUE(becomes(LinkState::homing, 5000));
  force_ = {0, 0, 2};
  EXPECT_FALSE(home()) << "it is never seen to be pulled out";
  EXPECT_EQ(device_->status().state, LinkState::pull_out);
  EXPECT_EQ(reading_.fault, DeviceFault::not_ready);
  EXPECT_TRUE(falcon([](auto& f) {
    return std::all_of(f.commands().begin(), f.commands().end(),
                       [](const auto& c) { return c.neutral(); });
  }));
  falcon([](auto& f) { f.troubles.frozen_encoders = false; });
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  EXPECT_TRUE(stepUntil([this] { return norm(felt()) > 1.9; }, 400));
}

TEST_F(FalconTroubleTest, AnAlteredNibbleIsNotBelieved) {
  beginTouching();
  step(300);
  const DeviceMm place = reading_.position;
  int held_up = 0;
  for (int i = 0; i < 200; ++i) {
    falcon([](auto& f) { f.troubles.altered_nibbles = 1; });
    for (int ms = 0; ms < 20; ++ms) {
      step();
      // The lowest three bits of a count are less than a hand trembles.
      ASSERT_LT(norm(reading_.position - place), 0.35) << i;
      ASSERT_LT(felt().z, 2.1) << i;
      held_up += felt().z > 1.9 ? 1 : 0;
    }
  }
  // Some angles belong to no place at all; of those the force rises anew.
  EXPECT_GT(held_up, 1000);
  EXPECT_EQ(fault_, DeviceFault::none);
  EXPECT_GT(device_->status().counts.held_poses, 100U);
}

TEST_F(FalconTroubleTest, NibblesThatGoOnBeingAlteredAreAFaultOfTheLine) {
  trouble([](auto& f) { f.troubles.altered_nibbles = test::kForEver; });
  const DeviceMm place = reading_.position;
  ASSERT_TRUE(stepUntil(
      [&] {
        EXPECT_LT(norm(reading_.position - place), 1.5);
        return fault_ == DeviceFault::protocol;
      },
      60));
  falcon([](auto& f) { f.troubles.altered_nibbles = 0; });
  EXPECT_TRUE(touchesAgain());
}

/// A fin between two halves, a hand that presses against it from the left and over the ground, and
/// bursts of altered nibbles: two of them believed could lead the hand over the fin and down.
TEST_F(FalconTroubleTest, TheProxyNeverEndsBehindAWallByAlteredNibbles) {
  constexpr double kFinMm = 13;  // Of hand, from the middle.
  const auto space = relievo::test::spaceOf(
      80, [](double x, double) { return std::abs(x - 40 - kFinMm) < 1 ? 6.0 : 0.0; });
  const double ground_mm = space->deviceFromView({40, 40, 0}).z;
  HapticOptions options;
  options.force.forces_on = true;
  HapticCore core;
  hold(10, -5, kCentre.z + ground_mm + 2);
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  std::uint32_t random = 99;
  for (int ms = 0; ms < 8000; ++ms) {
    random = random * 1664525U + 1013904223U;
    if (ms % 40 == 0) {
      falcon([&](auto& f) { f.troubles.altered_nibbles = static_cast<int>(random >> 16U) % 6; });
    }
    const double t = 1e-3 * ms;
    falcon([&](auto& f) {
      f.body.carry({10.5 + 2 * std::sin(3 * t), -5 + 4 * std::cos(2 * t),
                    kCentre.z + ground_mm + 2 + 3 * std::sin(1.7 * t)});
    });
    step();
    ASSERT_EQ(fault_ == DeviceFault::protocol, false) << ms;
    const HapticSample s = core.tick(*space, options, reading_, clock_->now());
    force_ = s.force;
    ASSERT_LT(s.proxy.x, kFinMm) << "in tick " << ms;
  }
  EXPECT_GT(device_->status().counts.held_poses, 100U);
  EXPECT_EQ(core.audit().violations(), 0U);
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
  EXPECT_TRUE(touchesAgain()) << englishText(describe(device_->status()));
}

}  // namespace
}  // namespace relievo::falcon
