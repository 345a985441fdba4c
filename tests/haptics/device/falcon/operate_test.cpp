// SPDX-License-Identifier: BSD-3-Clause
// Running: places, forces, buttons, lights, and every way of leaving.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <vector>

#include "haptics/device/falcon/kinematics.h"
#include "tests/haptics/device/falcon/falcon_fixture.h"

namespace relievo::falcon {
namespace {

using test::RunningFalconTest;

TEST_F(RunningFalconTest, TellsWhereTheHandIs) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  for (const BaseMm place : {BaseMm{0, 0, 125}, BaseMm{30, -20, 110}, BaseMm{-25, 31, 150}}) {
    hold(place.x, place.y, place.z);
    step(80);  // A hand takes its time.
    EXPECT_LT(norm(reading_.position - deviceFromBase(place)), 0.05) << "one count is up to 48 um";
    EXPECT_EQ(reading_.fault, DeviceFault::none);
    EXPECT_LT(clock_->now() - reading_.time_ns, 3'000'000);
  }
}

TEST_F(RunningFalconTest, TheHandFeelsTheForceThatWasAskedFor) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  for (const BaseMm place : {BaseMm{0, 0, 125}, BaseMm{30, -20, 110}, BaseMm{-25, 21, 150}}) {
    hold(place.x, place.y, place.z);
    for (const DeviceN force : {DeviceN{1, 0, 0}, DeviceN{0, -1.5, 0}, DeviceN{0.3, 0.4, 3}}) {
      force_ = force;
      step(250);
      // A count is a ten-thousandth of a newton metre, 3 to 6 mN at the grip.
      EXPECT_LT(norm(felt() - force), 0.02) << place.x << ' ' << force.x << ' ' << force.z;
    }
  }
}

TEST_F(RunningFalconTest, TenThousandForcesAreOnTheWireAsTheyWereAsked) {
  beginTouching();
  step(300);
  const Report pose{.encoders = device_->status().encoders};
  const Angles angles = anglesFromEncoders(pose.encoders);
  const AngleJacobian jacobian = *angleJacobian(*gripFromAngles(angles), angles);
  falcon([](auto& f) { f.forgetCommands(); });
  std::vector<std::array<int, 3>> asked;
  constexpr int kForces = 10'000;
  std::uint32_t random = 1;
  const auto newton = [&random] {
    random = random * 1664525U + 1013904223U;
    return 4.0 * random / 4294967296.0 - 2;
  };
  for (int i = 0; i < kForces; ++i) {
    force_ = {newton(), newton(), newton()};
    const auto counts = countsForTorques(*torquesForForce(jacobian, force_), kNominalCountsPerNmm);
    asked.push_back({counts[0], counts[1], counts[2]});
    step();
  }
  step(5);
  EXPECT_EQ(device_->status().counts.malformed + device_->status().counts.hiccups, 0U);
  falcon([&](auto& f) {
    EXPECT_EQ(f.badCommands(), 0);
    ASSERT_GT(f.commands().size(), asked.size() - 10);
    // Each is one that was asked for, none comes before an earlier one, and few are missed.
    auto next = asked.begin();
    std::size_t found = 0;
    for (const auto& command : f.commands()) {
      const auto at = std::find(next, std::min(next + 5, asked.end()), command.motors);
      if (at == std::min(next + 5, asked.end())) continue;
      next = at;
      ++found;
    }
    EXPECT_GT(found, f.commands().size() - 10) << "the first and the last ones aside";
  });
}

TEST_F(RunningFalconTest, KeepsItsOwnLimitAndDirectionWhateverIsAsked) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  hold(0, 0, 125);
  force_ = {300, 0, 400};
  step(400);
  EXPECT_NEAR(norm(felt()), 5, 0.05);
  EXPECT_NEAR(felt().x, 3, 0.05);
  force_ = {std::nan(""), 0, 0};
  step(5);
  EXPECT_TRUE(lastCommand().neutral());
}

TEST_F(RunningFalconTest, ForceRisesGentlyAfterTheStart) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  hold(0, 0, 125);
  force_ = {0, 0, 5};
  double last = 0;
  for (int i = 0; i < 150; ++i) {
    step();
    EXPECT_LT(norm(felt()) - last, 0.15) << "50 N/s, a frame may be two ticks";
    last = norm(felt());
  }
  EXPECT_GT(last, 4.5);
}

TEST_F(RunningFalconTest, ButtonsAreDebounced) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  falcon([](auto& f) { f.buttons = 0b0001; });
  step(2);
  falcon([](auto& f) { f.buttons = 0; });
  step(10);
  EXPECT_EQ(reading_.buttons, 0U);
  for (const unsigned pressed : {1U, 2U, 4U, 8U, 9U}) {
    falcon([&](auto& f) { f.buttons = static_cast<int>(pressed); });
    step(8);
    EXPECT_EQ(reading_.buttons, pressed);
  }
}

TEST_F(RunningFalconTest, OfTwoFramesNothingCountsOfThreeAPress) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  step(50);
  const auto frames = [this] { return falcon([](auto& f) { return f.commandCount(); }); };
  const auto setFor = [&](int buttons, std::uint64_t count) {
    const int before = falcon([](auto& f) { return f.buttons; });
    falcon([&](auto& f) { f.buttons = buttons; });
    std::vector<int> seen;
    for (const std::uint64_t end = frames() + count; frames() < end;) {
      const std::vector<int> now = edges(1);
      seen.insert(seen.end(), now.begin(), now.end());
      EXPECT_LE(frames(), end) << "a frame a millisecond";
    }
    falcon([&](auto& f) { f.buttons = before; });
    const std::vector<int> now = edges(20);
    seen.insert(seen.end(), now.begin(), now.end());
    return seen;
  };
  EXPECT_EQ(setFor(0b0001, 1), std::vector<int>{});
  EXPECT_EQ(setFor(0b0001, 2), std::vector<int>{});
  EXPECT_EQ(setFor(0b0001, 3), (std::vector<int>{1, -1}));
  falcon([](auto& f) { f.buttons = 0b0001; });
  step(20);
  EXPECT_EQ(setFor(0, 2), std::vector<int>{}) << "nor is a gap of two a release";
  EXPECT_EQ(setFor(0, 3), (std::vector<int>{-1, 1}));
}

TEST_F(RunningFalconTest, AShortInterruptionWhileAButtonIsHeldIsNoSecondPress) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  falcon([](auto& f) { f.buttons = 0b0101; });
  EXPECT_EQ(edges(50), (std::vector<int>{1, 3}));
  falcon([](auto& f) { f.troubles.silent = true; });
  EXPECT_EQ(edges(40), std::vector<int>{});
  EXPECT_EQ(fault_, DeviceFault::timeout);
  falcon([](auto& f) { f.troubles.silent = false; });
  EXPECT_EQ(edges(150), std::vector<int>{});
  for (const int failed : {1, 3}) {
    falcon([failed](auto& f) { f.troubles.failed_reads = failed; });
    EXPECT_EQ(edges(50), std::vector<int>{});
  }
  EXPECT_EQ(bus_->opens, 1);
  falcon([](auto& f) { f.buttons = 0; });
  EXPECT_EQ(edges(50), (std::vector<int>{-1, -3}));
}

TEST_F(RunningFalconTest, AButtonThatWasHeldThroughALongInterruptionIsNoPress) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  step(50);
  const auto strike = [this](bool unplugged) {
    falcon([unplugged](auto& f) {
      if (unplugged) {
        f.unplug();
      } else {
        f.troubles.silent = true;
      }
    });
  };
  for (const bool unplugged : {true, false}) {
    falcon([](auto& f) { f.buttons = 0b0001; });
    EXPECT_EQ(edges(50), std::vector<int>{1});
    strike(unplugged);
    EXPECT_EQ(edges(800), std::vector<int>{-1}) << "the press is over";
    falcon([](auto& f) {
      f.plugIn();
      f.troubles.silent = false;
    });
    ASSERT_TRUE(becomes(LinkState::ready, 2000));
    EXPECT_EQ(edges(100), std::vector<int>{});
    falcon([](auto& f) { f.buttons = 0; });
    EXPECT_EQ(edges(50), std::vector<int>{});
    falcon([](auto& f) { f.buttons = 0b0001; });
    EXPECT_EQ(edges(50), std::vector<int>{1}) << "a new one counts";
    falcon([](auto& f) { f.buttons = 0; });
    EXPECT_EQ(edges(50), std::vector<int>{-1});
  }
}

TEST_F(RunningFalconTest, AButtonThatIsDownWhenItIsPluggedInIsNoPress) {
  falcon([](auto& f) { f.buttons = 0b0001; });
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  EXPECT_EQ(edges(100), std::vector<int>{});
}

/// As after SIGSTOP and SIGCONT: the loop is back before this thread, and asks at once.
TEST_F(RunningFalconTest, AfterAPauseOfItsOwnThreadForceRisesFromZeroAtTheNewPlace) {
  for (const std::int64_t pause_ms : {25, 1000}) {
    if (pause_ms == 25) {
      beginTouching();
    } else {
      ASSERT_TRUE(stepUntil([this] { return norm(felt()) > 1.9; }, 300));
    }
    step(250);
    falcon([](auto& f) { f.forgetCommands(); });
    hold(pause_ms == 25 ? 30 : 10, 10, 140);
    clock_->jump(pause_ms * 1'000'000);
    reading_ = device_->exchange(force_, clock_->now());
    step();
    falcon([](auto& f) {
      ASSERT_FALSE(f.commands().empty());
      EXPECT_TRUE(f.commands().front().neutral());
    });
    step(3);
    EXPECT_LT(norm(felt()), 0.3) << "50 N/s";
    EXPECT_TRUE(stepUntil([this] { return norm(felt()) > 1.9; }, 100));
    EXPECT_LT(norm(felt() - force_), 0.1) << "made for the place where the hand is";
    EXPECT_EQ(fault_, DeviceFault::none) << "the Falcon did nothing wrong";
  }
}

TEST_F(RunningFalconTest, ALoopThatStepsSlowlyKeepsItsForce) {
  beginTouching();
  step(250);
  loop_runs_ = false;  // As the set-up, whose timer gives 125 steps a second.
  falcon([](auto& f) { f.forgetCommands(); });
  for (int i = 0; i < 100; ++i) {
    reading_ = device_->exchange(force_, clock_->now());
    EXPECT_EQ(reading_.fault, DeviceFault::none);
    step(8);
  }
  falcon([](auto& f) {
    EXPECT_TRUE(std::none_of(f.commands().begin(), f.commands().end(),
                             [](const auto& c) { return c.neutral(); }));
  });
  EXPECT_GT(norm(felt()), 1.9);
}

TEST_F(RunningFalconTest, AfterARestTheFirstFrameIsZero) {
  beginTouching();
  loop_runs_ = false;
  step(2500);
  falcon([](auto& f) { f.forgetCommands(); });
  hold(30, 10, 140);
  loop_runs_ = true;
  ASSERT_TRUE(stepUntil([this] { return norm(felt()) > 0.01; }, 700));
  EXPECT_LT(norm(felt()), 0.5) << "50 N/s";
  EXPECT_TRUE(stepUntil([this] { return norm(felt()) > 1.9; }, 100));
}

TEST_F(RunningFalconTest, LightsTellTheStateAndCanBeTried) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  step(5);
  EXPECT_EQ(lastCommand().lights, blue);
  force_ = {0, 0, 1};
  step(50);
  EXPECT_EQ(lastCommand().lights, green);
  device_->showLights(red | green | blue);
  step(5);
  EXPECT_EQ(lastCommand().lights, red | green | blue);
  device_->showStateLights();
  step(5);
  EXPECT_EQ(lastCommand().lights, green);
}

TEST_F(RunningFalconTest, ACalibratedGainChangesTheCounts) {
  beginTouching();
  step(200);
  const auto full = lastCommand().motors;
  device_->setGain(kNominalCountsPerNmm / 2);
  step(5);
  EXPECT_NEAR(lastCommand().motors[0], full[0] / 2.0, 1);
  device_->setGain(1e9);
  step(5);
  EXPECT_NEAR(lastCommand().motors[0], 2 * full[0], 2) << "never above twice the nominal value";
}

TEST_F(RunningFalconTest, ClosingLeavesTheMotorsAtZeroAndTheLightsOff) {
  beginTouching();
  finish();
  EXPECT_TRUE(lastCommand().neutral());
  EXPECT_EQ(lastCommand().lights, lights_off);
  falcon([](auto& f) {
    // "<AAAAAAAAAAAAAA>", and more than one: nobody repeats a frame that is lost.
    const auto last = f.commands().rbegin();
    EXPECT_EQ(std::count_if(
                  last, last + 10,
                  [](const auto& c) { return c.neutral() && c.lights == lights_off && !c.homing; }),
              3);
    EXPECT_TRUE(std::all_of(last, last + 3, [](const auto& c) { return !c.homing; }));
  });
  EXPECT_EQ(device_->exchange({0, 0, 2}, clock_->now()).fault, DeviceFault::not_ready);
}

TEST_F(RunningFalconTest, ALoopThatHangsLosesItsForce) {
  beginTouching();
  loop_runs_ = false;
  step(25);
  EXPECT_TRUE(lastCommand().neutral());
  EXPECT_LT(norm(felt()), 1e-9);
}

TEST_F(RunningFalconTest, AWatchdogsCutIsZeroUntilTheLoopAsksAgain) {
  beginTouching();
  loop_runs_ = false;  // It hangs; what it asked for last is still fresh.
  device_->cutForce();
  step(2);
  EXPECT_TRUE(lastCommand().neutral());
  loop_runs_ = true;
  EXPECT_TRUE(stepUntil([this] { return norm(felt()) > 1.9; }, 300));
}

TEST_F(RunningFalconTest, TellsThePassivityControllerItsStepAndItsDelay) {
  // The largest way of the grip for one count of one encoder, in the middle and all round it.
  double most_mm = 0;
  const BaseMm middle{0, 0, kCentre.z};
  const Angles angles = *anglesFromGrip(middle);
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    Angles next = angles;
    next[arm] += anglesFromEncoders({1, 1, 1})[arm] - anglesFromEncoders({0, 0, 0})[arm];
    most_mm = std::max(most_mm, norm(*gripFromAngles(next) - middle));
  }
  EXPECT_NEAR(device_->info().position_step_mm, most_mm, 0.25 * most_mm);
  // From the loop's order to the first frame that carries it.
  beginTouching();
  force_ = {};
  step(5);
  force_ = {0, 0, 1};
  int ticks = 0;
  while (lastCommand().neutral()) {
    step();
    ASSERT_LT(++ticks, 10);
  }
  EXPECT_LE(ticks, device_->info().force_delay_ticks);
}

TEST_F(RunningFalconTest, NobodyAsksNobodyIsWoken) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  step(100);
  loop_runs_ = false;
  step(1100);
  const auto count = [this] { return falcon([](auto& f) { return f.commandCount(); }); };
  const std::uint64_t before = count();
  step(4000);
  EXPECT_LT(count() - before, 10U);
  EXPECT_GT(count() - before, 3U) << "but it is looked after";
  EXPECT_EQ(falcon([](auto& f) { return f.latencyMs(); }), 255);
  loop_runs_ = true;
  EXPECT_TRUE(stepUntil([&] { return clock_->now() - reading_.time_ns < 3'000'000; }, 600));
  step(50);
  const std::uint64_t again = count();
  step(100);
  EXPECT_GT(count() - again, 85U);
  step(200);
  EXPECT_NEAR(device_->status().rate_hz, 1000, 20) << "the rest is not part of the pace";
  EXPECT_EQ(device_->status().counts.stalls, 0U);
}

TEST_F(RunningFalconTest, AsksOneQuestionPerAnswerAtTheChipsPace) {
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  step(2000);
  const LinkStatus& status = device_->status();
  EXPECT_EQ(status.counts.malformed, 0U);
  EXPECT_EQ(status.counts.hiccups, 0U);
  EXPECT_NEAR(status.rate_hz, 1000, 60);
  EXPECT_GT(status.mean_answer_ms, 0.2);
  EXPECT_LT(status.mean_answer_ms, 1.3);
}

class FalconLatency : public RunningFalconTest {
 protected:
  /// Milliseconds of the emulator's own clock from a new place of the hand to the first command
  /// whose force was made from it. @param late  as a loop that sends the force of the tick before
  int msFromPlaceToWire(bool late) {
    const auto tick = [&] {
      const std::int64_t now_ns = clock_->now();
      const DeviceReading reading = device_->read(now_ns);
      const DeviceN force{0, 0, 2 - 0.5 * reading.position.z};
      device_->send(late ? before_ : force, now_ns);
      before_ = force;
      step();
    };
    z_ = z_ > 131 ? 130.5 : 131.5;  // As far as a hand can go in a tick and a half.
    for (int i = 0; i < 300; ++i) tick();
    const auto resting = lastCommand().motors;
    falcon([this](auto& f) { f.body.carry({10, -5, z_}); });
    int ms = 0;
    for (; ms < 50 && lastCommand().motors == resting; ++ms) tick();
    return ms;
  }

 private:
  DeviceN before_;
  double z_ = 130;
};

TEST_F(FalconLatency, AForceIsOnTheWireATickSoonerThanByTheOrderBefore) {
  hold(10, -5, 130);
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 100));
  loop_runs_ = false;
  std::array<std::vector<int>, 2> ms;
  for (int i = 0; i < 60; ++i) ms[i % 2].push_back(msFromPlaceToWire(i % 2 == 1));
  for (auto& all : ms) std::sort(all.begin(), all.end());
  const int now = ms[0][ms[0].size() / 2], late = ms[1][ms[1].size() / 2];
  EXPECT_LE(now, late - 1);
  EXPECT_LE(ms[0].back(), now + 1);
  RecordProperty("ms_now", now);
  RecordProperty("ms_before", late);
}

}  // namespace
}  // namespace relievo::falcon
