// SPDX-License-Identifier: BSD-3-Clause
// The parts of the Falcon's link that need neither a device nor a clock: homing, buttons that
// bounce, the rate of answers, and silence.
#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "haptics/device/falcon/link/answer_times.h"
#include "haptics/device/falcon/link/button_debounce.h"
#include "haptics/device/falcon/link/homing.h"
#include "haptics/device/falcon/link/silence.h"

namespace relievo::falcon {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr double kIn = 0, kOut = 60;

/// The states after answers with these arms homed.
std::vector<LinkState> statesAfter(Homing& homing, LinkState state,
                                   std::initializer_list<std::uint8_t> homed, double out_mm = kIn) {
  std::vector<LinkState> states;
  for (const std::uint8_t arms : homed) {
    states.push_back(state = homing.after(state, arms, out_mm));
  }
  return states;
}
using States = std::vector<LinkState>;
constexpr LinkState kHoming = LinkState::homing, kPullOut = LinkState::pull_out,
                    kReady = LinkState::ready;

TEST(Homing, OneThatWasHomedBeforeIsReadyAfterThreeAnswers) {
  Homing homing;
  EXPECT_EQ(statesAfter(homing, kHoming, {7, 7, 7, 7}), (States{kHoming, kHoming, kReady, kReady}));
}

TEST(Homing, OneThatWasSeenUnhomedMustBePulledOut) {
  Homing homing;
  EXPECT_EQ(statesAfter(homing, kHoming, {3, 7, 7, 7, 7}),
            (States{kHoming, kHoming, kHoming, kPullOut, kPullOut}));
  EXPECT_EQ(homing.after(kPullOut, 7, kOut), kReady);
  homing.restart();
  EXPECT_EQ(statesAfter(homing, kHoming, {7, 7, 7}).back(), kReady) << "another start of it";
}

TEST(Homing, AnArmThatIsLostIsHomedAnew) {
  Homing homing;
  statesAfter(homing, kHoming, {7, 7, 7});
  EXPECT_EQ(statesAfter(homing, kReady, {5, 7, 7, 7}),
            (States{kHoming, kHoming, kHoming, kPullOut}));
}

TEST(Homing, OneAnswerBetweenIsNotEnough) {
  Homing homing;
  EXPECT_EQ(statesAfter(homing, kHoming, {7, 7, 6, 7, 7}).back(), kHoming);
}

TEST(Homing, IsLongAfterTwentySeconds) {
  Homing homing;
  homing.begin(1000 * kMs);
  EXPECT_FALSE(homing.isLong(21'000 * kMs));
  EXPECT_TRUE(homing.isLong(21'000 * kMs + 1));
}

/// Those that are down after answers.
std::uint32_t downAfter(ButtonDebounce& buttons, std::initializer_list<std::uint8_t> raw) {
  std::uint32_t down = buttons.down();
  for (const std::uint8_t answer : raw) down = buttons.take(answer);
  return down;
}

TEST(ButtonDebounce, ThreeAnswersInARowPressAndRelease) {
  ButtonDebounce buttons;
  EXPECT_EQ(downAfter(buttons, {0, 0, 0}), 0U);
  EXPECT_EQ(downAfter(buttons, {2, 2}), 0U);
  EXPECT_EQ(downAfter(buttons, {2}), 2U);
  EXPECT_EQ(downAfter(buttons, {0, 0}), 2U);
  EXPECT_EQ(downAfter(buttons, {0}), 0U);
}

TEST(ButtonDebounce, OneThatBouncesIsPressedOnce) {
  ButtonDebounce buttons;
  downAfter(buttons, {0, 0, 0});
  EXPECT_EQ(downAfter(buttons, {1, 0, 1, 1, 0, 1, 1}), 0U);
  EXPECT_EQ(downAfter(buttons, {1}), 1U);
}

TEST(ButtonDebounce, WhatIsHeldAtTheBeginningCountsOnceItWasLetGo) {
  ButtonDebounce buttons;
  EXPECT_EQ(downAfter(buttons, {4, 4, 4, 4, 4}), 0U);
  EXPECT_EQ(downAfter(buttons, {0, 0, 0, 4, 4, 4}), 4U);
  buttons.forget();
  EXPECT_EQ(buttons.down(), 0U);
  EXPECT_EQ(downAfter(buttons, {4, 4, 4, 4}), 0U);
}

TEST(ButtonDebounce, AnInterruptionReleasesNothingAndCountsAnew) {
  ButtonDebounce buttons;
  downAfter(buttons, {0, 0, 0, 8, 8, 8});
  EXPECT_EQ(downAfter(buttons, {0, 0}), 8U);
  buttons.interrupt();
  EXPECT_EQ(downAfter(buttons, {0, 0}), 8U);
  EXPECT_EQ(downAfter(buttons, {0}), 0U);
}

TEST(AnswerTimes, CountsTheRateOver256Answers) {
  AnswerTimes times;
  LinkStatus status;
  times.restart(0, status);
  for (int i = 1; i <= 256; ++i) {
    EXPECT_EQ(status.rate_hz, 0) << "too few are known";
    times.count({.now_ns = i * kMs, .gap_ns = kMs, .asked_ns = i * kMs - kMs / 2}, status);
  }
  EXPECT_NEAR(status.rate_hz, 1000, 1e-6);
  EXPECT_NEAR(status.mean_answer_ms, 0.5, 1e-9);
  EXPECT_EQ(status.counts.gaps[1], 256U);
  EXPECT_EQ(status.counts.worst_gap_ns, kMs);
}

TEST(AnswerTimes, OfOneThatRestsOnlyTheNumberCounts) {
  AnswerTimes times;
  LinkStatus status;
  times.count({.now_ns = 500 * kMs, .gap_ns = 500 * kMs, .asked_ns = 0, .at_rest = true}, status);
  EXPECT_EQ(status.counts.frames, 1U);
  EXPECT_EQ(status.counts.worst_gap_ns, 0);
  EXPECT_EQ(status.worst_answer_ms, 0);
}

TEST(AnswerTimes, AreMeasuredAnew) {
  AnswerTimes times;
  LinkStatus status;
  times.count({.now_ns = 9 * kMs, .gap_ns = 9 * kMs, .asked_ns = 0}, status);
  times.measureAnew(status);
  EXPECT_EQ(status.counts.worst_gap_ns, 0);
  times.count({.now_ns = 10 * kMs, .gap_ns = kMs, .asked_ns = 9 * kMs}, status);
  EXPECT_NEAR(status.mean_answer_ms, 1, 1e-9);
}

TEST(Silence, MeasuresComeAfter5And10And15MillisecondsThenEvery20) {
  Silence silence;
  silence.restart(100 * kMs);
  silence.ask(100 * kMs, false);
  std::vector<std::int64_t> at_ms;
  for (int i = 0; i < 6; ++i) {
    at_ms.push_back(Silence::measureAfter(silence.step()) / kMs);
    EXPECT_EQ(silence.nextMeasure(100 * kMs + Silence::measureAfter(silence.step())), i);
  }
  EXPECT_EQ(at_ms, (std::vector<std::int64_t>{5, 10, 15, 20, 40, 60}));
  silence.answer();
  silence.heard(200 * kMs);
  EXPECT_EQ(silence.step(), 0);
  EXPECT_FALSE(silence.isUnderWay());
}

TEST(Silence, WhatAWriteSleptThroughIsNotMadeUpFor) {
  Silence silence;
  silence.restart(0);
  EXPECT_EQ(silence.nextMeasure(17 * kMs), 2) << "one measure, the last that was due";
}

TEST(Silence, OneThatWasOnlyLateMayAnswerTwice) {
  Silence silence;
  silence.restart(0);
  silence.ask(0, false);
  silence.askedAgain(true);
  EXPECT_EQ(silence.underWay(), 2);
  EXPECT_TRUE(silence.isDoubtful());
  silence.answer();
  EXPECT_TRUE(silence.isUnderWay());
  silence.answer();
  EXPECT_FALSE(silence.isDoubtful());
  silence.answer();
  EXPECT_EQ(silence.underWay(), 0) << "one too many is none less";
}

TEST(Silence, FailedReadsCountInARow) {
  Silence silence;
  EXPECT_EQ(silence.failRead(), 1);
  silence.wake(5 * kMs);
  EXPECT_EQ(silence.failRead(), 2);
  silence.heard(6 * kMs);
  EXPECT_EQ(silence.failRead(), 1);
}

TEST(Silence, AnAnswerIsWaitedForSinceTheFirstQuestion) {
  Silence silence;
  silence.ask(1 * kMs, true);
  silence.ask(2 * kMs, false);
  EXPECT_EQ(silence.askedNs(), 1 * kMs);
  EXPECT_TRUE(silence.askedAtRest());
}

}  // namespace
}  // namespace relievo::falcon
