// SPDX-License-Identifier: BSD-3-Clause
// The windows that relievo proposes; which they must be is core/session/feelable_test's.
#include <gmock/gmock.h>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using Json = nlohmann::json;
using test::CommandResult;
using test::reportOf;
using test::runRelievo;
using testing::HasSubstr;

class Suggest : public test::CommandTest {};

TEST_F(Suggest, WindowsBestFirstThatOtherVerbsTakeAsTheyArePrinted) {
  const Json report = reportOf(runRelievo({"suggest", test::kReliefF, "--unit", "mm", "--view",
                                           "top", "--most", "4", "--report", "json"}));
  const Json& windows = report["windows"];
  ASSERT_GE(windows.size(), 2U);
  ASSERT_LE(windows.size(), 4U);
  double before = 1;
  for (const Json& window : windows) {
    EXPECT_LE(window["score"], before);
    before = window["score"];
    EXPECT_GT(window["felt"], 0);
    EXPECT_LE(window["felt"].get<double>() + window["steep"].get<double>(),
              window["measured"].get<double>() + 1e-12);
  }
  const CommandResult text =
      runRelievo({"suggest", test::kReliefF, "--unit", "mm", "--view", "top", "--most", "1"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  std::istringstream words(text.out);
  std::string number, option, region, level_option, level;
  words >> number >> option >> region >> level_option >> level;
  EXPECT_EQ(option, "--region");
  EXPECT_EQ(level_option, "--level");
  const Json felt = reportOf(runRelievo(
      {"touch", test::kReliefF, "--unit", "mm", "--view", "top", "--stroke", test::kFlatStroke,
       option, region, level_option, level, "-o", path("log.csv"), "--report", "json"}));
  EXPECT_EQ(felt["level"], windows[0]["level"]);
}

TEST_F(Suggest, APlaneHasNothingToFeel) {
  const std::vector<std::string> words{"suggest", plane(), "--unit", "mm", "--view", "top"};
  const CommandResult run = runRelievo(words);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("No window has relief that stands out"));
  EXPECT_EQ(reportOf(runRelievo(test::joined(words, {"--report", "json"})))["windows"].size(), 0U);
}

TEST_F(Suggest, NumbersThatMakeNoSenseAreMisuse) {
  for (const auto& [option, value] :
       {std::pair{"--most", "0"}, {"--gain", "0"}, {"--grip-factor", "-1"}}) {
    const CommandResult run = runRelievo({"suggest", plane(), option, value});
    EXPECT_EQ(run.exit_code, 1) << option;
    EXPECT_THAT(run.err, HasSubstr(option));
  }
}

}  // namespace
}  // namespace relievo
