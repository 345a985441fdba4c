// SPDX-License-Identifier: BSD-3-Clause
// touch --guide: a simulated hand is led along outlines and recorded ways, and replays are the
// same.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using test::CommandResult;
using test::runRelievo;

class GuideVerb : public test::CommandTest {
 protected:
  static CommandResult led(const std::string& log, const std::vector<std::string>& more) {
    return runRelievo(test::joined({"touch", test::kReliefF, "--unit", "mm", "--view", "top",
                                    "--device", "virtual:relaxed", "-o", log, "--report", "json"},
                                   more));
  }
};

TEST_F(GuideVerb, LeadsRoundTheDomeAndIsReplayedBitByBit) {
  for (const char* name : {"led.csv", "led.h5"}) {
    const std::string log = path(name);
    const CommandResult touch = led(log, {"--guide", "outline", "--rounds", "2"});
    ASSERT_EQ(touch.exit_code, 0) << touch.err;
    const auto guide = nlohmann::json::parse(touch.out)["guide"];
    EXPECT_EQ(guide["along"], "raised area");
    EXPECT_EQ(guide["ended"], "arrived");
    // 300 mm of relief in 80 mm of hand; the dome's foot has a radius of 60 mm.
    EXPECT_NEAR(guide["length_mm"], 2 * std::numbers::pi * 57 * 80 / 300, 6);
    EXPECT_LE(guide["rms_mm"], 2);
    EXPECT_LE(guide["largest_force_n"], 2);
    EXPECT_LE(guide["largest_fed_mw"], 80);
    EXPECT_EQ(guide["violations"], 0);
    EXPECT_GT(guide["led_s"], 12) << "two rounds of six seconds";
    const CommandResult replay = runRelievo({"replay", log, "--verify", "--report", "json"});
    EXPECT_EQ(replay.exit_code, 0) << replay.err << replay.out;
    EXPECT_EQ(nlohmann::json::parse(replay.out)["identical"], true);
  }
}

TEST_F(GuideVerb, LeadsRoundTheObjectWithItsMissingCorner) {
  const CommandResult touch = led(path("object.csv"), {"--guide", "object"});
  ASSERT_EQ(touch.exit_code, 0) << touch.err;
  const auto guide = nlohmann::json::parse(touch.out)["guide"];
  EXPECT_EQ(guide["along"], "object");
  EXPECT_EQ(guide["ended"], "arrived");
  EXPECT_NEAR(guide["length_mm"], 1000.0 * 80 / 300, 8);
  EXPECT_GE(guide["pauses"], 5) << "corners";
  EXPECT_LE(guide["rms_mm"], 2);
}

TEST_F(GuideVerb, PlaysBackTheWayOfAHand) {
  const std::string stroke = path("stroke.csv"), log = path("way.csv");
  std::ofstream(stroke) << "t_s,x_mm,y_mm,z_mm\n0,60,100,20\n4,120,100,20\n5,120,100,20\n"
                           "8,120,140,10\n";
  const CommandResult along = led(log, {"--guide", stroke});
  ASSERT_EQ(along.exit_code, 0) << along.err;
  auto guide = nlohmann::json::parse(along.out)["guide"];
  EXPECT_EQ(guide["along"], "recorded way");
  EXPECT_EQ(guide["ended"], "arrived");
  EXPECT_EQ(guide["pauses"], 1) << "it rested for a second";
  EXPECT_EQ(runRelievo({"replay", log, "--verify"}).exit_code, 0);
  // What was recorded then leads another hand; the first stroke is not needed any more.
  std::filesystem::remove(stroke);
  const CommandResult again = led(path("again.csv"), {"--guide", log});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(nlohmann::json::parse(again.out)["guide"]["ended"], "arrived");
  EXPECT_EQ(runRelievo({"replay", log, "--verify"}).exit_code, 0) << "the way is in the log";
}

TEST_F(GuideVerb, AHandWithAWishOfItsOwnLeads) {
  const std::string stroke = path("held.csv");
  std::ofstream(stroke) << "t_s,x_mm,y_mm,z_mm\n0,40,100,40\n60,40,100,40\n";
  const CommandResult touch = led(path("held_log.csv"), {"--guide", "outline", "--stroke", stroke});
  ASSERT_EQ(touch.exit_code, 0) << touch.err;
  EXPECT_EQ(nlohmann::json::parse(touch.out)["guide"]["ended"], "the hand leads");
}

TEST_F(GuideVerb, SaysWhatIsMissing) {
  const std::string out = path("refused.csv");
  const auto refused = [&](const std::vector<std::string>& words, int code, const char* sentence) {
    const CommandResult result = runRelievo(words);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr(sentence));
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  const std::vector<std::string> touch{"touch",  test::kReliefF, "--unit", "mm",
                                       "--view", "top",          "-o",     out};
  refused(touch, 1, "There is nothing to touch along.");
  refused(test::joined(touch, {"--guide", "outline"}), 1, "--guide leads a hand.");
  refused(test::joined(touch, {"--guide", "outline", "--device", "virtual", "--safety", "off"}), 1,
          "--guide leads a hand.");
  // On the flat ground beside the dome there is nothing to be led along.
  refused(test::joined(touch,
                       {"--guide", "outline", "--device", "virtual", "--region", "155,90,30,30"}),
          1, "There is no outline in this window");
  refused(test::joined(touch, {"--guide", path("none.csv"), "--device", "virtual"}), 2, "none.csv");
}

}  // namespace
}  // namespace relievo
