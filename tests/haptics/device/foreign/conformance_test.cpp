// SPDX-License-Identifier: BSD-3-Clause
// The tests that whoever writes a plug-in runs: they name each planted fault, and pass what has
// none.
#include <algorithm>
#include <string>
#include <vector>

#include "haptics/device/foreign/ask_host.h"
#include "tests/haptics/device/foreign/foreign_fixture.h"

namespace relievo::foreign {
namespace {

using test::standIn;
using testing::HasSubstr;

class ConformanceTest : public test::ForeignTest {
 protected:
  static std::vector<CheckResult> checked(const std::string& fault) {
    return checkPlugin(standIn(fault), {.device = test::kStandInId, .seconds = 0.1});
  }
  static std::string failures(const std::vector<CheckResult>& results) {
    std::string codes;
    for (const CheckResult& result : results) {
      if (result.verdict == Verdict::failed) codes += std::string(result.check.code) + " ";
    }
    return codes;
  }
  static std::string whyOf(const std::vector<CheckResult>& results, const std::string& code) {
    for (const CheckResult& result : results) {
      if (result.check.code == code) return result.why;
    }
    return "there is no " + code;
  }
};

TEST_F(ConformanceTest, TheStandInAndTheExampleHaveNoFault) {
  EXPECT_EQ(failures(checked("none")), "");
  const std::string example = std::string(RELIEVO_BINARY_DIR) + "/device_example/spring_hand.so";
  const auto results = checkPlugin(example, {.device = "spring.1",
                                             .newton = 1,
                                             .seconds = 0.2,
                                             .is_held = [] { return true; },
                                             .patience = test::longPatience()});
  EXPECT_EQ(failures(results), "");
  EXPECT_EQ(results.back().verdict, Verdict::passed) << "the force was asked for";
}

TEST_F(ConformanceTest, WithoutADeviceNoneIsOpened) {
  for (const CheckResult& result : checkPlugin(standIn("open_hangs"), {})) {
    EXPECT_EQ(result.verdict, result.check.with_device ? Verdict::skipped : Verdict::passed)
        << result.check.code << ": " << result.why;
  }
}

struct Planted {
  const char* fault;
  const char* code;
  const char* says;
};
class ConformanceFaults : public ConformanceTest, public testing::WithParamInterface<Planted> {};

TEST_P(ConformanceFaults, AreNamed) {
  const auto results = checked(GetParam().fault);
  EXPECT_THAT(failures(results), HasSubstr(GetParam().code));
  EXPECT_THAT(whyOf(results, GetParam().code), HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    All, ConformanceFaults,
    testing::Values(
        Planted{"no_table", "C01", "exports no relievo_device_entry"},
        Planted{"other_major", "C01", "another major version"},
        Planted{"short_table", "C01", "too small"}, Planted{"null_function", "C01", "missing"},
        Planted{"init_fails", "C02", "init failed"},
        Planted{"scan_overruns", "C03", "beyond the room"},
        Planted{"knows_everyone", "C04", "unknown id"},
        Planted{"false_extension", "C05", "does not exist"}, Planted{"leaks", "C06", "descriptors"},
        Planted{"changes_rounding", "C07", "rounding"},
        Planted{"takes_signals", "C07", "signal handlers"},
        Planted{"prints", "C08", "standard output"}, Planted{"no_limits", "C20", "impossible"},
        Planted{"open_fails", "C20", "another program holds it"},
        Planted{"sleeps", "C21", "longer"}, Planted{"nan_place", "C23", "not finite"},
        Planted{"far_place", "C23", "out of reach"}, Planted{"frozen_time", "C23", "older"},
        Planted{"future", "C23", "future"}, Planted{"jumps", "C24", "jumps"},
        Planted{"cut_fails", "C25", "fails"}, Planted{"cut_needs_open", "C25", "crashed"},
        Planted{"never_reopens", "C26", "open again"},
        Planted{"crashes", "C21", "crashed (signal 11)"},
        Planted{"aborts", "C21", "crashed (signal 6)"},
        Planted{"throws", "C21", "crashed (signal 6)"},
        Planted{"ends_process", "C21", "its process ended"}),
    [](const auto& tested) { return std::string(tested.param.fault); });

// Sanitizers have a malloc of their own, which is not counted.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(ConformanceTest, AStepThatAllocatesIsNamed) {
  EXPECT_THAT(whyOf(checked("allocates"), "C22"), HasSubstr("allocates"));
}
#endif

TEST_F(ConformanceTest, WhatAnotherThreadAllocatesIsNoFaultOfTheStep) {
  EXPECT_EQ(failures(checked("allocates_beside")), "");
}

/// The test that pushes is a session like any other: guarded, limited, and at an end with the first
/// fault.
class PushingTest : public ConformanceTest {
 protected:
  std::vector<CheckResult> pushed(const std::string& fault, bool held = true,
                                  Patience patience = test::longPatience()) {
    return checkPlugin(standIn(fault), {.device = test::kStandInId,
                                        .newton = 1,
                                        .seconds = 0.1,
                                        .is_held =
                                            [this, held] {
                                              ++asked;
                                              return held;
                                            },
                                        .patience = patience});
  }
  double mostForce() const {
    double most_n = 0;
    for (const test::StandInEntry& entry : log()) most_n = std::max(most_n, entry.force_n);
    return most_n;
  }
  int asked = 0;
};

TEST_F(PushingTest, AsksAndThenPushesNoMoreThanItSays) {
  const auto results = pushed("none");
  EXPECT_EQ(failures(results), "");
  EXPECT_EQ(results.back().verdict, Verdict::passed);
  EXPECT_EQ(asked, 1);
  EXPECT_GT(mostForce(), 0);
  EXPECT_LE(mostForce(), 1 + 1e-9);
}

TEST_F(PushingTest, WithoutAHandAtTheGripThereIsNoForce) {
  const auto results = pushed("none", false);
  EXPECT_EQ(results.back().verdict, Verdict::skipped);
  EXPECT_THAT(results.back().why, HasSubstr("nobody said"));
  EXPECT_EQ(checkPlugin(standIn("none"), {.device = test::kStandInId, .newton = 1, .seconds = 0.1})
                .back()
                .verdict,
            Verdict::skipped)
      << "nobody was asked";
  EXPECT_EQ(mostForce(), 0);
}

TEST_F(PushingTest, AfterAFailedTestThereIsNoForce) {
  const auto results = pushed("jumps");
  EXPECT_EQ(results.back().verdict, Verdict::skipped);
  EXPECT_THAT(results.back().why, HasSubstr("after a failed test"));
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(mostForce(), 0);
}

TEST_F(PushingTest, EndsAtTheFirstFault) {
  const auto results = pushed("fails_pushed");
  EXPECT_EQ(failures(results), "C27 ");
  EXPECT_THAT(results.back().why, HasSubstr("the force rose"));
  int pushes = 0;  // Above what makes it fail.
  for (const test::StandInEntry& entry : log()) pushes += entry.force_n > 0.2 ? 1 : 0;
  EXPECT_EQ(pushes, 1) << "the step that failed was the last that pushed";
}

TEST_F(PushingTest, AStepThatHangsIsCutByTheGuard) {
  auto patience = test::longPatience();
  patience.silence_ms = 1000;
  const auto results = pushed("hangs_pushed", true, patience);
  EXPECT_EQ(failures(results), "C27 ");
  const auto all = log();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.back().what, test::StandInEntry::What::cut);
}

TEST_F(ConformanceTest, SaysTheSameTwice) {
  for (const char* const fault : {"none", "jumps"}) {
    std::string texts;
    for (int i = 0; i < 2; ++i) {
      std::string text;
      for (const CheckResult& r : checked(fault)) text += std::string(r.check.code) + r.why + "\n";
      if (i > 0) {
        EXPECT_EQ(text, texts);
      }
      texts = text;
    }
  }
}

TEST_F(ConformanceTest, AScanTellsWhatThereIsAndOpensNothing) {
  const ScannedPlugin plugin = scanPlugin(standIn("open_hangs"));
  EXPECT_FALSE(plugin.trouble);
  EXPECT_EQ(plugin.name, "Stand-in");
  EXPECT_EQ(plugin.version, "3");
  EXPECT_EQ(plugin.licence, "BSD-3-Clause");
  ASSERT_EQ(plugin.devices.size(), 1U);
  EXPECT_EQ(plugin.devices[0].id, "stand-in.7");
  EXPECT_TRUE(log().empty());
  const ScannedPlugin other = scanPlugin(standIn("other_major"));
  ASSERT_TRUE(other.trouble);
  EXPECT_THAT(englishText(*other.trouble), HasSubstr("version 9"));
  ASSERT_TRUE(scanPlugin(folder / "nothing.so").trouble);
}

}  // namespace
}  // namespace relievo::foreign
