// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/self_test.h"

#include <gmock/gmock.h>

#include "haptics/device/falcon/calibration.h"
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
  static std::string textOf(const SelfTest& test) {
    std::string text;
    for (const SelfTestLine& line : test.lines()) text += line.text + "\n";
    return text;
  }
};

TEST_F(FalconSelfTest, AGoodFalconPasses) {
  falcon([](auto& f) { f.body.pullToward({0, 0, 125}); });
  SelfTest test(*device_, {.wait_for_person_s = 5});
  for (int ms = 0; ms < 20'000 && test.step(clock_->now()); ++ms) {
    step();
    if (test.phase() != SelfTest::Phase::person) continue;
    falcon([&](auto& f) {
      f.buttons = 1 << (ms / 50 % 4);
      f.body.hold({0, 0, 110.0 + ms % 40});
    });
  }
  EXPECT_EQ(test.phase(), SelfTest::Phase::done);
  EXPECT_TRUE(test.passed()) << textOf(test);
  EXPECT_THAT(textOf(test), HasSubstr("Buttons: all four work."));
  for (const SelfTestLine& line : test.lines()) {
    EXPECT_TRUE(line.result == SelfTestLine::Result::passed || line.text.starts_with("Lights"))
        << line.text;
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
    return line.text.starts_with("Nudges") && line.result == SelfTestLine::Result::passed;
  })) << textOf(test);
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

TEST_F(FalconSelfTest, AKnownWeightFindsTheMotorsTrueGain) {
  constexpr double kTrue = 4.6, kWeightG = 100;
  falcon([](auto& f) {
    f.body.counts_per_n_mm = kTrue;
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
  ASSERT_TRUE(calibration.result()) << calibration.prompt();
  EXPECT_NEAR(*calibration.result(), kTrue, 0.02 * kTrue);
}

TEST_F(FalconSelfTest, AWeightThatIsNotThereIsNoticed) {
  falcon([](auto& f) { f.body.letGo(0.2); });
  Calibration calibration(*device_, 10, 100);
  for (int ms = 0; ms < 90'000 && calibration.step(clock_->now()); ++ms) {
    step();
    calibration.weightHangs();
  }
  EXPECT_EQ(calibration.phase(), Calibration::Phase::failed);
  EXPECT_THAT(calibration.prompt(), HasSubstr("old setting is kept"));
  EXPECT_THROW(Calibration(*device_, 10, 5), ArgumentError);
}

}  // namespace
}  // namespace relievo::falcon
