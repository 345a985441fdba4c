// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/self_test.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "haptics/device/falcon/calibration.h"
#include "haptics/device/falcon/kinematics.h"
#include "tests/haptics/device/falcon/falcon_fixture.h"

namespace relievo::falcon {
namespace {

using testing::HasSubstr;

class FalconSelfTest : public test::RunningFalconTest {
 protected:
  void SetUp() override {
    loop_runs_ = false;
    hold(0, 0, 125);
    begin();
    ASSERT_TRUE(becomes(LinkState::ready, 100));
  }
  template <class Test>
  void runFor(Test& test, int most_ms) {
    for (int i = 0; i < most_ms && test.step(clock_->now()); ++i) step();
  }
  void findsTheGain(double true_gain);
  static std::string textOf(const SelfTest& test) {
    std::string text;
    for (const SelfTestLine& line : test.lines()) text += englishText(line.text) + "\n";
    return text;
  }
};

TEST_F(FalconSelfTest, AGoodFalconPasses) {
  falcon([](auto& f) { f.body.pullToward({0, 0, 125}); });
  SelfTest test(*device_, {.wait_for_person_s = 5});
  for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
    step();
    if (test.phase() != SelfTest::Phase::person) continue;
    // To the end of each side and back, as a hand does it.
    const double way = 38 * std::sin(ms * 0.01);
    const int side = ms / 700 % 3;
    falcon([&](auto& f) {
      f.buttons = 1 << (ms / 50 % 4);
      f.body.carry({side == 0 ? way : 0, side == 1 ? way : 0, 125.0 + (side == 2 ? way : 0)});
    });
  }
  EXPECT_EQ(test.phase(), SelfTest::Phase::done);
  EXPECT_TRUE(test.passed()) << textOf(test);
  EXPECT_THAT(textOf(test), HasSubstr("Buttons: all four work."));
  EXPECT_THAT(textOf(test), HasSubstr("Edges: the hand reached 3")) << textOf(test);
  for (const SelfTestLine& line : test.lines()) {
    EXPECT_TRUE(line.result == SelfTestLine::Result::passed ||
                englishText(line.text).starts_with("Lights"))
        << englishText(line.text);
  }
}

TEST_F(FalconSelfTest, ASideThatTheHandDidNotReachIsAskedForAndNeverPassed) {
  falcon([](auto& f) { f.body.pullToward({0, 0, 125}); });
  SelfTest test(*device_, {.wait_for_person_s = 3});
  std::string asked;
  for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
    step();
    if (test.phase() != SelfTest::Phase::person) continue;
    asked = englishText(test.prompt());
    const double way = 38 * std::sin(ms * 0.01);
    const int side = ms / 700 % 3;
    falcon([&](auto& f) {
      f.buttons = 1 << (ms / 50 % 4);
      // Something stands in the way on the left.
      f.body.carry({side == 0 ? std::max(way, -10.0) : 0, side == 1 ? way : 0,
                    125.0 + (side == 2 ? way : 0)});
    });
  }
  EXPECT_THAT(asked, HasSubstr("Still missing: left side."));
  EXPECT_THAT(textOf(test), HasSubstr("not to the end: left side."));
  EXPECT_TRUE(test.passed()) << "what nobody did is not seen, and no failure";
}

TEST_F(FalconSelfTest, TimesAreThoseOfTheTest) {
  // Before it: answers that came late, and a rest, in which one may come after a quarter second.
  const auto holdAnswers = [this](std::int64_t ns) {
    falcon([ns](auto& f) { f.hold_answers_ns = ns; });
  };
  loop_runs_ = true;
  step(600);
  holdAnswers(4'000'000);
  step(100);
  ASSERT_GT(device_->status().worst_answer_ms, 3);
  holdAnswers(0);
  step(100);
  loop_runs_ = false;
  step(3100);
  for (const double seconds : {2.0, 5.0}) {
    SelfTest test(*device_, {.rate_s = seconds, .nudges = false});
    const std::int64_t began_ns = clock_->now();
    while (test.phase() == SelfTest::Phase::rate && test.step(clock_->now())) step();
    EXPECT_NEAR(1e-9 * static_cast<double>(clock_->now() - began_ns), seconds, 0.01);
    EXPECT_TRUE(test.passed()) << textOf(test);
    double mean_ms = 0, worst_ms = 0, gap_ms = 0;
    const std::string text = textOf(test), times = "From question to answer: ";
    const std::size_t at = text.find(times), longest = text.find("the longest ");
    ASSERT_NE(at, std::string::npos);
    ASSERT_NE(longest, std::string::npos);
    ASSERT_EQ(std::sscanf(text.c_str() + at + times.size(), "%lf ms on average, %lf", &mean_ms,
                          &worst_ms),
              2);
    ASSERT_EQ(std::sscanf(text.c_str() + longest, "the longest %lf", &gap_ms), 1);
    EXPECT_GT(mean_ms, 0.2);
    EXPECT_LT(mean_ms, 1.3);
    EXPECT_LT(worst_ms, 2.1) << text;
    EXPECT_LT(gap_ms, 2.1) << text;
    device_->showStateLights();
    step(3100);
  }
}

TEST_F(FalconSelfTest, NudgesAreHalfANewtonAndMoveTheHandTheirWay) {
  falcon([](auto& f) {
    f.body.pullToward({0, 0, 125});
    f.forgetCommands();
  });
  SelfTest test(*device_, {});
  double most = 0;
  for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
    step();
    most = std::max(most, norm(felt()));
  }
  EXPECT_LT(most, 0.52);
  EXPECT_GT(most, 0.48);
  EXPECT_THAT(textOf(test), HasSubstr("Nudges of 0.5 N moved the hand"));
  EXPECT_TRUE(std::any_of(test.lines().begin(), test.lines().end(), [](const auto& line) {
    return englishText(line.text).starts_with("Nudges") &&
           line.result == SelfTestLine::Result::passed;
  })) << textOf(test);
}

TEST_F(FalconSelfTest, MotorsThatMoveNothingFailAndNobodyIsAskedForMore) {
  // Held fast, or without power: it cannot be told apart, and is never passed.
  SelfTest test(*device_, {});
  std::string asked;
  for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
    step();
    asked += englishText(test.prompt());
  }
  EXPECT_FALSE(test.passed());
  EXPECT_EQ(englishText(test.prompt()), "The self test found something wrong.");
  EXPECT_THAT(textOf(test), HasSubstr("in 0.0 mm; the motors moved nothing. Check the Falcon's "
                                      "power supply, hold the grip loosely"));
  EXPECT_THAT(asked, HasSubstr("Hold the grip loosely"));
  EXPECT_THAT(asked, testing::Not(HasSubstr("press each of the four buttons")))
      << "nothing would be waited for";
}

TEST_F(FalconSelfTest, MotorsWithoutPowerFailInALooseHand) {
  falcon([](auto& f) {
    f.body.counts_per_n_mm = 1e9;
    f.body.pullToward({0, 0, 125});
  });
  SelfTest test(*device_, {});
  runFor(test, 20'000);
  EXPECT_FALSE(test.passed()) << textOf(test);
}

TEST_F(FalconSelfTest, WithoutNudgesNobodyIsAskedForButtonsThatAreNotTried) {
  SelfTest test(*device_, {.nudges = false});
  for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
    step();
    EXPECT_NE(test.phase(), SelfTest::Phase::person);
  }
  EXPECT_TRUE(test.passed()) << textOf(test);
}

TEST_F(FalconSelfTest, ANudgeEndsBeforeAGripThatNobodyHoldsGoesFar) {
  falcon([](auto& f) { f.body.letGo(0); });
  SelfTest test(*device_, {});
  DeviceMm from;
  bool pushed = false;
  double farthest_mm = 0;
  int nudges = 0;
  for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
    step();
    const emulator::Triple grip = falcon([](auto& f) { return f.body.grip(); });
    const DeviceMm here = deviceFromBase({grip[0], grip[1], grip[2]});
    const bool pushes = norm(felt()) > 0.1;
    if (pushes && !pushed) {
      from = here;
      ++nudges;
    }
    if (pushes) farthest_mm = std::max(farthest_mm, norm(here - from));
    pushed = pushes;
  }
  EXPECT_EQ(nudges, 6);
  EXPECT_GT(farthest_mm, 4);
  EXPECT_LT(farthest_mm, 6.5) << "three ticks of 0.2 m/s pass until the force is off";
}

TEST_F(FalconSelfTest, ShowsEveryLight) {
  falcon([](auto& f) { f.forgetCommands(); });
  SelfTest test(*device_, {.nudges = false});
  runFor(test, 10'000);
  falcon([](auto& f) {
    for (const int light : {2, 4, 8}) {
      EXPECT_TRUE(std::any_of(f.commands().begin(), f.commands().end(),
                              [light](const auto& c) { return c.lights == light; }));
    }
    EXPECT_TRUE(std::all_of(f.commands().begin(), f.commands().end(), [](const auto& c) {
      return c.neutral();
    })) << "no nudges were wanted";
  });
}

TEST_F(FalconSelfTest, ABadLineFails) {
  SelfTest test(*device_, {.nudges = false});
  for (int ms = 0; ms < 10'000 && test.step(clock_->now()); ++ms) {
    if (ms % 20 == 0) falcon([](auto& f) { f.troubles.short_answers = 1; });
    step();
  }
  EXPECT_FALSE(test.passed());
  EXPECT_THAT(textOf(test), HasSubstr("damaged answers"));
}

TEST_F(FalconSelfTest, UnpluggingEndsIt) {
  SelfTest test(*device_, {});
  for (int ms = 0; ms < 10'000 && test.step(clock_->now()); ++ms) {
    if (ms == 100) falcon([](auto& f) { f.unplug(); });
    step();
  }
  EXPECT_FALSE(test.passed());
  EXPECT_THAT(textOf(test), HasSubstr("unplugged"));
}

/// Public measurements: commands traced on the wire imply 2.3 to 4.8 counts per N mm; the largest
/// force that is quoted, 8 N, implies 20.
TEST_F(FalconSelfTest, AKnownWeightFindsTheMotorsTrueGain) {
  for (const double gain : {2.3, 4.6, 10.0, 18.0}) findsTheGain(gain);
}

void FalconSelfTest::findsTheGain(double true_gain) {
  SCOPED_TRACE(true_gain);
  constexpr double kWeightG = 100;
  falcon([true_gain](auto& f) {
    f.body.carry({0, 0, 125});
    f.body.counts_per_n_mm = true_gain;
    f.body.letGo(0.35);  // The grip's own.
  });
  device_->setGain(8);
  Calibration calibration(*device_, 8, kWeightG);
  for (int ms = 0; ms < 90'000 && calibration.step(clock_->now()); ++ms) {
    step();
    if (calibration.phase() == Calibration::Phase::hang_weight) {
      falcon([](auto& f) { f.body.letGo(0.35 + 9.80665e-3 * kWeightG); });
      calibration.weightHangs();
    }
  }
  ASSERT_TRUE(calibration.result()) << englishText(calibration.prompt());
  // 10 N/kg would be 2 % off.
  EXPECT_NEAR(*calibration.result(), true_gain, 0.005 * true_gain);
}

/// A window that answers ten times a second, as while it reads a scan: the link shows no force that
/// is older than 20 ms, so that what is asked for says nothing of the weight.
TEST_F(FalconSelfTest, ACalibrationThatStepsTooSlowlyGivesAReasonAndNoGain) {
  falcon([](auto& f) { f.body.letGo(0.35); });
  device_->setGain(8);
  Calibration calibration(*device_, 8, 100);
  for (int ms = 0; ms < 90'000; ms += 100) {
    if (!calibration.step(clock_->now())) break;
    step(100);
    if (calibration.phase() == Calibration::Phase::hang_weight) calibration.weightHangs();
  }
  EXPECT_FALSE(calibration.result());
  EXPECT_THAT(englishText(calibration.prompt()), HasSubstr("interrupted too often"));
}

/// The force rises from zero after each; what is asked for meanwhile says nothing of the weight.
TEST_F(FalconSelfTest, ALineWithInterruptionsGivesTheWeightOrAReason) {
  constexpr double kTrue = 6, kWeightG = 100;
  for (const int every_ms : {2500, 40}) {
    falcon([](auto& f) {
      f.body.counts_per_n_mm = kTrue;
      f.body.carry({0, 0, 125});
      f.body.letGo(0.3);
    });
    device_->setGain(8);
    Calibration calibration(*device_, 8, kWeightG);
    for (int ms = 0; ms < 90'000 && calibration.step(clock_->now()); ++ms) {
      if (ms % every_ms == 0) falcon([](auto& f) { f.troubles.lose_answer_bytes = 1; });
      step();
      if (calibration.phase() == Calibration::Phase::hang_weight) {
        falcon([](auto& f) { f.body.letGo(0.3 + 9.80665e-3 * kWeightG); });
        calibration.weightHangs();
      }
    }
    if (every_ms > 1000) {
      ASSERT_TRUE(calibration.result()) << englishText(calibration.prompt());
      EXPECT_NEAR(*calibration.result(), kTrue, 0.02 * kTrue);
      EXPECT_NEAR(calibration.gripWeightN(), 0.3, 0.02) << "of the empty grip";
    } else {
      EXPECT_FALSE(calibration.result());
      EXPECT_THAT(englishText(calibration.prompt()), HasSubstr("interrupted too often"));
    }
  }
}

TEST_F(FalconSelfTest, AWeightThatIsNotThereIsNoticed) {
  falcon([](auto& f) { f.body.letGo(0.2); });
  Calibration calibration(*device_, 10, 100);
  for (int ms = 0; ms < 90'000 && calibration.step(clock_->now()); ++ms) {
    step();
    calibration.weightHangs();
  }
  EXPECT_EQ(calibration.phase(), Calibration::Phase::failed);
  EXPECT_THAT(englishText(calibration.prompt()), HasSubstr("old setting is kept"));
  EXPECT_THROW(Calibration(*device_, 10, 5), ArgumentError);
}

}  // namespace
}  // namespace relievo::falcon
