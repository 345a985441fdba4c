// SPDX-License-Identifier: BSD-3-Clause
// The link with Haply's service, as it should be and with everything that may go wrong in it.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/haptics/device/haply/haply_fixture.h"

namespace relievo::haply {
namespace {

using testing::Contains;
using testing::Not;

TEST_F(HaplyLink, ShowsForcesOnTheAxesOnWhichTheyWereOrdered) {
  const std::vector<DeviceN> ways{{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                  {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  int ms = 1000;
  for (const DeviceN way : ways) {
    at(ms, [this, way] { wanted_ = 2.0 * way; });
    at(ms + 90, [this, way] {
      EXPECT_NEAR(world().force()[0], 2 * way.x, 1e-3);
      EXPECT_NEAR(world().force()[1], 2 * way.y, 1e-3);
      EXPECT_NEAR(world().force()[2], 2 * way.z, 1e-3);
    });
    ms += 100;
  }
  run(ms);
  EXPECT_THAT(told_, Not(Contains(DeviceFault::protocol)));
}

TEST_F(HaplyLink, TellsPlacesOnTheAxesOfTheHand) {
  const std::vector<HaplyWorld::Triple> places{{7, 0, 0},  {0, 7, 0},  {0, 0, 7},
                                               {-7, 0, 0}, {0, -7, 0}, {0, 0, -7}};
  int ms = 1000;
  for (const HaplyWorld::Triple& place : places) {
    // As fast as a hand, so that no place jumps.
    for (int step = 1; step <= 50; ++step) {
      at(ms + step, [this, place, step] {
        const double part = step / 50.0;
        world().hold({part * place[0], part * place[1], part * place[2]});
      });
      at(ms + 100 + step, [this, place, step] {
        const double part = 1 - step / 50.0;
        world().hold({part * place[0], part * place[1], part * place[2]});
      });
    }
    at(ms + 90, [this, place] {
      EXPECT_NEAR(reading_.position.x, place[0], 1e-3);
      EXPECT_NEAR(reading_.position.y, place[1], 1e-3);
      EXPECT_NEAR(reading_.position.z, place[2], 1e-3);
    });
    ms += 200;
  }
  run(ms);
  EXPECT_EQ(status().counts.jumps, 0U);
}

TEST_F(HaplyLink, EachVersionIsOrderedInItsOwnWords) {
  wanted_ = {0, 0, 2};
  world().version = "3.4.8";
  at(900, [this] { EXPECT_NEAR(shownN(), 2, 1e-3); });
  run(1000);
  world().version = "3.5.1";
  run(1000);
  EXPECT_EQ(world().refused, 0U);
}

TEST_F(HaplyLink, IsSetUpOnceAndAskedOnceAMillisecond) {
  wanted_ = {0, 0, 1};
  run(2000);
  EXPECT_EQ(world().configurations, 1U);
  EXPECT_EQ(status().counts.extra, 0U);
  EXPECT_NEAR(static_cast<double>(world().messages), 2000, 20);
  EXPECT_EQ(status().counts.hiccups, 0U);
}

TEST_F(HaplyLink, ForcesStayWithinTheDevice) {
  wanted_ = {0, 9, 0};
  run(1000);
  EXPECT_NEAR(world().largest_n, 5, 1e-3);
}

TEST_F(HaplyLink, AMinverseHasLess) {
  world().type = "minverse";
  wanted_ = {0, 9, 0};
  run(1000);
  EXPECT_NEAR(world().largest_n, 2, 1e-3);
}

TEST_F(HaplyLink, ForcesBeginFromZeroAndEndAtZero) {
  wanted_ = {0, 0, 3};
  run(1000);
  const auto [steepest, most] = riseAfter(0);
  EXPECT_NEAR(most, 3, 1e-3);
  EXPECT_LE(steepest, 0.11);
  ASSERT_FALSE(world().log.empty());
  EXPECT_EQ(world().log.back().force, HaplyWorld::Triple{});
  EXPECT_STREQ(world().log.back().why, "ordered") << "before the session is closed";
}

TEST_F(HaplyLink, AServiceThatIsSilentGetsZeroThenTheForcesAreOff) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::silent);
  at(1030, [this] {
    EXPECT_EQ(shownN(), 0);
    EXPECT_EQ(reading_.fault, DeviceFault::timeout);
    EXPECT_EQ(status().state, LinkState::silent);
  });
  plantAt(3000, HaplyFault::none);
  run(8000);
  const double zero_ms = zeroAfterMs(timeOf(1000));
  EXPECT_GE(zero_ms, 0);
  EXPECT_LE(zero_ms, 20);
  EXPECT_GE(status().counts.stalls, 1U);
  EXPECT_GE(status().counts.lost, 1U) << "half a second later another session is tried";
  const auto [steepest, most] = riseAfter(timeOf(3000));
  EXPECT_NEAR(most, 3, 1e-3) << "it comes back by itself";
  EXPECT_LE(steepest, 0.11) << "and rises";
}

TEST_F(HaplyLink, IsLeftAtOnceWhileTheServiceIsSilent) {
  plantAt(1000, HaplyFault::silent);
  run(1100);
  EXPECT_LE(service_.now(), timeOf(1100) + 30'000'000) << "and not when the session is given up";
  EXPECT_EQ(status().state, LinkState::closed);
}

TEST_F(HaplyLink, AnswersThatAreALittleLateChangeNothing) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::late_3_ms);
  run(2000);
  EXPECT_LT(zeroAfterMs(timeOf(1001)), 1002) << "zero at its end alone";
  EXPECT_GT(zeroAfterMs(timeOf(1001)), 990);
  EXPECT_EQ(status().counts.hiccups, 0U);
}

TEST_F(HaplyLink, AnswersThatAreLateTakeTheForceAway) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::late_10_ms);
  plantAt(2000, HaplyFault::none);
  run(3000);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 20);
  EXPECT_GE(zeroAfterMs(timeOf(1000)), 0);
  EXPECT_GT(status().counts.hiccups, 0U);
  EXPECT_THAT(told_, Not(Contains(DeviceFault::timeout)));
  EXPECT_NEAR(riseAfter(timeOf(2000)).second, 3, 1e-3);
}

TEST_F(HaplyLink, AnswersThatAreVeryLateAreATimeout) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::late_30_ms);
  plantAt(2000, HaplyFault::none);
  run(4000);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 20);
  EXPECT_THAT(told_, Contains(DeviceFault::timeout));
  const auto [steepest, most] = riseAfter(timeOf(2000));
  EXPECT_NEAR(most, 3, 1e-3);
  EXPECT_LE(steepest, 0.11);
}

TEST_F(HaplyLink, TwoAnswersForOneQuestionDoNotPileUp) {
  wanted_ = {0, 0, 1};
  plantAt(1000, HaplyFault::two_answers);
  for (int ms = 1000; ms < 1900; ++ms) {
    at(ms, [this, ms] { world().hold({0, 0, (ms - 1000) * 0.01}); });
  }
  at(1890, [this] { EXPECT_NEAR(reading_.position.z, 8.9, 0.05) << "the newest place counts"; });
  run(2000);
  EXPECT_GT(status().counts.extra, 900U);
}

class HaplyNonsense : public HaplyLink, public testing::WithParamInterface<HaplyFault> {};

TEST_P(HaplyNonsense, IsNotBelievedAndEndsTheForce) {
  wanted_ = {0, 0, 3};
  plantAt(1000, GetParam());
  at(1005, [this] {
    EXPECT_EQ(shownN(), 0);
    EXPECT_NE(reading_.fault, DeviceFault::none);
  });
  plantAt(1030, HaplyFault::none);
  run(3000);
  EXPECT_GE(status().counts.nonsense, 20U);
  EXPECT_THAT(told_, Contains(DeviceFault::protocol));
  const auto [steepest, most] = riseAfter(timeOf(1031));
  EXPECT_NEAR(most, 3, 1e-3);
  EXPECT_LE(steepest, 0.11);
}
INSTANTIATE_TEST_SUITE_P(OfTheService, HaplyNonsense,
                         testing::Values(HaplyFault::truncated, HaplyFault::null_place,
                                         HaplyFault::number_too_large, HaplyFault::wrong_type,
                                         HaplyFault::deep, HaplyFault::duplicate),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

TEST_F(HaplyLink, NonsenseThatGoesOnEndsTheSession) {
  plantAt(1000, HaplyFault::truncated);
  plantAt(2000, HaplyFault::none);
  run(6000);
  EXPECT_GT(service_.connections, 1);
  EXPECT_EQ(reading_.fault, DeviceFault::none) << "it comes back";
}

TEST_F(HaplyLink, OtherOrdersAndMissingMembersAreNoFault) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::member_order);
  plantAt(1500, HaplyFault::members_missing);
  run(2000);
  EXPECT_GT(zeroAfterMs(timeOf(900)), 1000);
  EXPECT_EQ(status().counts.nonsense, 0U);
}

class HaplyAway : public HaplyLink, public testing::WithParamInterface<HaplyFault> {};

TEST_P(HaplyAway, IsDisconnectedAndComesBack) {
  wanted_ = {0, 0, 3};
  plantAt(1000, GetParam());
  at(1010, [this] {
    EXPECT_EQ(shownN(), 0);
    EXPECT_EQ(reading_.fault, DeviceFault::disconnected);
  });
  plantAt(2000, HaplyFault::none);
  at(5000, [this] { EXPECT_NEAR(shownN(), 3, 1e-3) << "within three seconds"; });
  run(5100);
  EXPECT_LE(riseAfter(timeOf(1010)).first, 0.11);
}
INSTANTIATE_TEST_SUITE_P(FromTheService, HaplyAway,
                         testing::Values(HaplyFault::device_absent, HaplyFault::other_id,
                                         HaplyFault::closes),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

TEST_F(HaplyLink, ASecondDeviceIsLeftAlone) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::second_device);
  run(2000);
  EXPECT_GT(zeroAfterMs(timeOf(900)), 1000) << "the one that it began with goes on";
}

TEST_F(HaplyLink, AServiceThatEndsIsLookedForUntilItIsBack) {
  wanted_ = {0, 0, 3};
  at(1000, [this] { service_.runs = false; });
  at(1100, [this] {
    EXPECT_EQ(reading_.fault, DeviceFault::disconnected);
    EXPECT_EQ(status().state, LinkState::no_service);
    EXPECT_TRUE(status().was_open);
  });
  at(4000, [this] { service_.runs = true; });
  at(7000, [this] { EXPECT_NEAR(shownN(), 3, 1e-3) << "within three seconds"; });
  run(7100);
}

struct Waiting {
  HaplyFault fault;
  LinkState state;
};
class HaplyWaits : public HaplyLink, public testing::WithParamInterface<Waiting> {};

TEST_P(HaplyWaits, WithoutForceAndSaysWhy) {
  wanted_ = {0, 0, 3};
  plantAt(1000, GetParam().fault);
  at(1100, [this] {
    EXPECT_EQ(status().state, GetParam().state);
    EXPECT_EQ(reading_.fault, DeviceFault::not_ready);
    EXPECT_EQ(shownN(), 0);
  });
  plantAt(1500, HaplyFault::none);
  run(2500);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 5);
  const auto [steepest, most] = riseAfter(timeOf(1500));
  EXPECT_NEAR(most, 3, 1e-3);
  EXPECT_LE(steepest, 0.11);
}
INSTANTIATE_TEST_SUITE_P(ForTheDevice, HaplyWaits,
                         testing::Values(Waiting{HaplyFault::uncalibrated,
                                                 LinkState::not_calibrated},
                                         Waiting{HaplyFault::no_power, LinkState::no_power},
                                         Waiting{HaplyFault::not_started, LinkState::not_started}),
                         [](const auto& one) { return std::string(nameOf(one.param.fault)); });

TEST_F(HaplyLink, APlaceThatJumpsEndsTheForceUntilTheSetUpIsKnown) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::jump);
  run(2000);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 5);
  EXPECT_EQ(status().counts.jumps, 1U);
  EXPECT_THAT(told_, Contains(DeviceFault::protocol));
  EXPECT_EQ(world().configurations, 1U) << "it was still ours";
  EXPECT_NEAR(riseAfter(timeOf(1010)).second, 3, 1e-3);
}

TEST_F(HaplyLink, AxesThatOthersChangeAreFoundAndSetBack) {
  wanted_ = {0, 0, 3};
  world().hold({0, 30, -10});
  plantAt(1000, HaplyFault::foreign_basis);
  run(3000);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 5) << "the place jumps";
  EXPECT_EQ(world().configurations, 2U);
  const auto [steepest, most] = riseAfter(timeOf(1010));
  EXPECT_NEAR(most, 3, 1e-3);
  EXPECT_LE(steepest, 0.11);
  EXPECT_NEAR(reading_.position.y, 30, 1e-3);
}

TEST_F(HaplyLink, AxesThatOthersChangeAreFoundWhereNoPlaceJumps) {
  wanted_ = {0, 0, 3};
  world().hold({10, 0, 0});  // The same in either set of axes.
  plantAt(1000, HaplyFault::foreign_basis);
  run(3000);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 110);
  EXPECT_GE(zeroAfterMs(timeOf(1000)), 0);
  EXPECT_EQ(world().configurations, 2U);
  EXPECT_NEAR(riseAfter(timeOf(1001)).second, 3, 1e-3);
}

TEST_F(HaplyLink, WhoeverChangesAxesAgainAndAgainEndsTheForce) {
  wanted_ = {0, 0, 3};
  world().hold({10, 0, 0});
  plantAt(1000, HaplyFault::foreign_basis_always);
  at(4000, [this] {
    EXPECT_EQ(status().state, LinkState::foreign);
    EXPECT_NE(reading_.fault, DeviceFault::none);
  });
  plantAt(5000, HaplyFault::none);
  run(20'000);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 110);
  EXPECT_LE(riseAfter(timeOf(1001)).first, 0.11);
  EXPECT_EQ(status().state, LinkState::closed);
  EXPECT_NEAR(riseAfter(timeOf(5000)).second, 3, 1e-3) << "ten seconds later it is tried again";
}

/// What is answered first was asked before, and few questions ask for the set-up.
TEST_F(HaplyLink, ATimeInWhichNothingRanIsNoSetUpOfOthers) {
  wanted_ = {0, 0, 3};
  plantAt(900, HaplyFault::late_3_ms);
  for (const int ms : {1000, 2011, 3022}) {
    at(ms, [this] { service_.sleepThrough(2'000'000'000); });
  }
  at(5000, [this] {
    EXPECT_EQ(status().state, LinkState::ready);
    EXPECT_NEAR(shownN(), 3, 1e-3);
  });
  run(5100);
  EXPECT_EQ(world().configurations, 1U);
  EXPECT_THAT(told_, Not(Contains(DeviceFault::protocol)));
}

TEST_F(HaplyLink, AServiceThatDoesNotObeyIsSaidAndGetsNoForce) {
  wanted_ = {0, 0, 3};
  world().fault = HaplyFault::disobedient;
  at(1000, [this] {
    EXPECT_EQ(status().state, LinkState::disobeyed);
    EXPECT_EQ(reading_.fault, DeviceFault::protocol);
    EXPECT_GT(status().ordered_n, 0.5);
    EXPECT_EQ(codeOf(describe(status())), "E317");
    world().fault = HaplyFault::none;
  });
  at(2000, [this] {
    EXPECT_EQ(shownN(), 0) << "it does not heal by itself";
    mailbox_.commands.write({.retries = 1});
  });
  at(2900, [this] { EXPECT_NEAR(shownN(), 3, 1e-3); });
  run(3000);
}

TEST_F(HaplyLink, WhereOthersPushTooTheForceEnds) {
  wanted_ = {0, 0, 3};
  plantAt(1000, HaplyFault::foreign_force);
  at(1030, [this] {
    EXPECT_EQ(status().state, LinkState::pushed);
    EXPECT_EQ(shownN(), 0);
  });
  plantAt(2000, HaplyFault::none);
  run(6000);
  EXPECT_NEAR(riseAfter(timeOf(2000)).second, 3, 1e-3);
}

class HaplyTells : public HaplyLink, public testing::WithParamInterface<HaplyFault> {};

TEST_P(HaplyTells, OwnForceIsNotTakenForThatOfOthers) {
  world().fault = GetParam();
  wanted_ = {0, 0, 3};
  at(1000, [this] { mailbox_.cuts.fetch_add(1); });
  at(1500, [this] { wanted_ = {}; });
  at(2000, [this] { wanted_ = {0, 4, 0}; });
  at(2500, [this] { wanted_ = {4, 0, 0}; });
  at(3000, [this] { wanted_ = {-4, 0, 0}; });
  at(3500, [this] { loop_runs_ = false; });
  at(3900, [this] { loop_runs_ = true; });
  run(5000);
  EXPECT_THAT(told_, Not(Contains(DeviceFault::protocol)));
}
INSTANTIATE_TEST_SUITE_P(OfTheService, HaplyTells,
                         testing::Values(HaplyFault::tells_late, HaplyFault::tells_smooth),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

TEST_F(HaplyLink, ACutEndsTheForceUntilANewerOrder) {
  wanted_ = {0, 0, 3};
  at(1000, [this] {
    mailbox_.cuts.fetch_add(1);
    loop_runs_ = false;
  });
  run(1500);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 2);
  EXPECT_GE(zeroAfterMs(timeOf(1000)), 0);
}

TEST_F(HaplyLink, AnOrderThatIsOldIsNothing) {
  wanted_ = {0, 0, 3};
  at(1000, [this] { loop_runs_ = false; });
  run(1500);
  EXPECT_LE(zeroAfterMs(timeOf(1000)), 22);
  EXPECT_GE(zeroAfterMs(timeOf(1000)), 0);
}

TEST_F(HaplyLink, RestsWhileNobodyAsksAndWakesSoon) {
  wanted_ = {0, 0, 3};
  std::uint64_t before = 0;
  at(1000, [this] { loop_runs_ = false; });
  at(3000, [&] { before = world().messages; });
  at(4000, [&] {
    EXPECT_LE(world().messages - before, 11U);
    loop_runs_ = true;
  });
  at(4500, [this] { EXPECT_NEAR(shownN(), 3, 1e-3); });
  run(4600);
  EXPECT_LE(riseAfter(timeOf(4000)).first, 0.11);
}

TEST_F(HaplyLink, ButtonsOfBothGripsArePlusCentreAndMinus) {
  at(1000, [this] { world().button_a = true; });
  at(1010, [this] { EXPECT_EQ(reading_.buttons, 0b0001U); });
  at(1020, [this] { world().button_a = false, world().button_b = true; });
  at(1030, [this] { EXPECT_EQ(reading_.buttons, 0b0100U); });
  at(1040, [this] { world().button_b = false, world().button_c = true; });
  at(1050, [this] { EXPECT_EQ(reading_.buttons, 0b1000U); });
  at(1060, [this] { world().button_c = false, world().wired_button = true; });
  at(1070, [this] { EXPECT_EQ(reading_.buttons, 0b0100U); });
  run(1100);
}

TEST_F(HaplyLink, AButtonThatWasHeldThroughAnInterruptionPressesNothing) {
  at(1000, [this] { world().button_a = true; });
  plantAt(1100, HaplyFault::truncated);
  plantAt(1105, HaplyFault::none);
  at(1200, [this] { EXPECT_EQ(reading_.buttons, 0U); });
  at(1300, [this] { world().button_a = false; });
  at(1310, [this] { world().button_a = true; });
  at(1320, [this] { EXPECT_EQ(reading_.buttons, 0b0001U); });
  run(1400);
}

TEST_F(HaplyLink, AHandThatLetsItselfBePushedIsPushedThere) {
  world().pullToward({0, 0, 0});
  wanted_ = {0, 0, 1};
  at(2900, [this] { EXPECT_NEAR(reading_.position.z, 4, 0.2) << "1 N on a hand of 0.25 N/mm"; });
  run(3000);
}

}  // namespace
}  // namespace relievo::haply
