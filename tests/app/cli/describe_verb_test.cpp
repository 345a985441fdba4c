// SPDX-License-Identifier: BSD-3-Clause
// relievo describe: sentences in three languages, for eyes and for ears, and the facts behind them;
// which they must be is core/describe/describe_test's.
#include <gmock/gmock.h>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using Json = nlohmann::json;
using test::CommandResult;
using test::reportOf;
using test::runRelievo;
using testing::HasSubstr;
using testing::Not;

class Describe : public test::CommandTest {
 protected:
  static std::vector<std::string> reliefF(const std::vector<std::string>& more) {
    return test::joined({"describe", test::kReliefF, "--unit", "mm", "--view", "top"}, more);
  }
};

/// Its cap is the highest place, and stands on the left; its step raises the right third.
TEST_F(Describe, TheReliefFAsItWasMade) {
  const Json report = reportOf(runRelievo(reliefF({"--report", "json"})));
  const Json& facts = report["facts"];
  EXPECT_NEAR(facts["size_mm"][0], 300, 1);
  EXPECT_NEAR(facts["size_mm"][1], 200, 1);
  EXPECT_EQ(facts["highest"]["place"], "middle_left");
  EXPECT_NEAR(facts["highest"]["at_mm"][0].get<double>() - facts["left_mm"].get<double>(), 90, 1.5);
  EXPECT_NEAR(facts["highest"]["at_mm"][1].get<double>() - facts["bottom_mm"].get<double>(), 100,
              1.5);
  EXPECT_NEAR(facts["highest"]["at_mm"][2], 30, 1.5);
  EXPECT_EQ(facts["roughness_mm"].size(), 9U);
  EXPECT_GT(facts["not_measured"], 0) << "it has holes";
  for (const Json& sentence : report["sentences"]) {
    EXPECT_NE(sentence["text"], "");
    EXPECT_NE(sentence["spoken"], "");
  }
}

TEST_F(Describe, SaysTheSameInThreeLanguages) {
  const CommandResult english = runRelievo(reliefF({"--spoken"}));
  EXPECT_THAT(english.out, HasSubstr("Relief, 30 centimetres by 20 centimetres.\n"));
  EXPECT_THAT(english.out, HasSubstr("Highest place: middle left.\n"));
  const CommandResult german = runRelievo(reliefF({"--spoken", "--lang", "de"}));
  EXPECT_THAT(german.out, HasSubstr("Relief, 30 Zentimeter mal 20 Zentimeter.\n"));
  const CommandResult hindi = runRelievo(reliefF({"--spoken", "--lang", "hi"}));
  EXPECT_THAT(hindi.out, HasSubstr("सबसे ऊँची जगह: बीच में बाएँ।"));
  const auto lines = [](const CommandResult& run) {
    return std::count(run.out.begin(), run.out.end(), '\n');
  };
  EXPECT_EQ(lines(english), lines(german));
  EXPECT_EQ(lines(english), lines(hindi));
  const Json facts = reportOf(runRelievo(reliefF({"--report", "json"})))["facts"];
  EXPECT_EQ(reportOf(runRelievo(reliefF({"--lang", "hi", "--report", "json"})))["facts"], facts);
}

TEST_F(Describe, ASlopeHasNoRaisedAreaAndNoHighestPlace) {
  const CommandResult run = runRelievo({"describe", plane(), "--unit", "mm", "--view", "top"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Heights from 0 mm to 10 mm: a span of 10 mm."));
  EXPECT_THAT(run.out, Not(HasSubstr("raised")));
  EXPECT_THAT(run.out, Not(HasSubstr("Highest")));
}

TEST_F(Describe, AnotherLanguageIsMisuse) {
  const CommandResult run = runRelievo({"describe", plane(), "--lang", "fr"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("--lang"));
}

}  // namespace
}  // namespace relievo
