// SPDX-License-Identifier: BSD-3-Clause
// How a surface feels, from the command line.
#include <fstream>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using Json = nlohmann::json;
using test::CommandResult;
using test::runRelievo;

class TouchFeel : public test::CommandTest {
 protected:
  CommandResult touch(const std::vector<std::string>& more) const {
    return runRelievo(test::joined(
        {"touch", test::kReliefF, "--unit", "mm", "--view", "top", "--cells", "300", "--region",
         "240,60,50,50", "--stroke", test::kFlatStroke, "-o", path("feel.csv"), "--report", "json"},
        more));
  }
};

TEST_F(TouchFeel, WithoutAPresetItIsASpringAndNothingElse) {
  const CommandResult run = touch({});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["stiffness_n_per_mm"], 0.5);
  EXPECT_EQ(report["surface"], "gated");
  EXPECT_EQ(report["softest_part"], 1);
  EXPECT_EQ(report["texture_mm"], 0);
  EXPECT_EQ(report["crossing_n"], 0);
}

TEST_F(TouchFeel, APresetOfTheWindowIsTakenAndOverriddenByWhatIsGiven) {
  const CommandResult paper = touch({"--preset", "paper"});
  ASSERT_EQ(paper.exit_code, 0) << paper.err;
  Json report = Json::parse(paper.out);
  EXPECT_EQ(report["proxy"], "equation");
  EXPECT_EQ(report["surface"], "exact");
  EXPECT_EQ(report["softest_part"], 1) << "off as in the paper";
  const CommandResult bronze = touch({"--preset", "bronze", "--friction", "0.1", "--knock", "0.2"});
  ASSERT_EQ(bronze.exit_code, 0) << bronze.err;
  report = Json::parse(bronze.out);
  EXPECT_EQ(report["stiffness_n_per_mm"], 0.8);
  EXPECT_EQ(report["friction"], Json({0.1, 0.1}));
  EXPECT_EQ(report["contact_n"], 0.2);
  EXPECT_EQ(report["softest_part"], 0.6);
  const CommandResult levels = touch({"--level-stiffness", "0.7,0.65"});
  ASSERT_EQ(levels.exit_code, 0) << levels.err;
  report = Json::parse(levels.out);
  EXPECT_TRUE(report["stiffness_n_per_mm"] == 0.7 || report["stiffness_n_per_mm"] == 0.65);
}

TEST_F(TouchFeel, StrengthIsAPresetOrPercentAndNeedsTheChainThatHasOne) {
  const auto strongest = [this](const std::string& strength) {
    const CommandResult run = touch({"--device", "virtual", "--strength", strength});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.exit_code == 0 ? Json::parse(run.out)["largest_force_n"].get<double>() : 0.0;
  };
  const double full = strongest("full"), gentle = strongest("gentle");
  EXPECT_EQ(strongest("30"), gentle);
  EXPECT_EQ(strongest("100"), full);
  EXPECT_GT(gentle, 0);
  EXPECT_LT(gentle, 0.6 * full) << "the hand comes deeper, but is pushed less";
  for (const char* word : {"0", "101", "strong", "50%", "5e1"}) {
    EXPECT_EQ(touch({"--device", "virtual", "--strength", word}).exit_code, 1) << word;
  }
  const CommandResult bare = touch({"--strength", "gentle"});
  EXPECT_EQ(bare.exit_code, 1);
  EXPECT_NE(bare.err.find("--strength"), std::string::npos) << bare.err;
}

TEST_F(TouchFeel, AGripPositionIsOfADeviceThatAPersonHolds) {
  const CommandResult run =
      runRelievo({"record", test::kReliefF, "--unit", "mm", "--device", "virtual", "--grip", "flat",
                  "--seconds", "0.1", "-o", path("grip.csv")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("--grip"), std::string::npos) << run.err;
}

TEST_F(TouchFeel, ARasterSaysWhereTheGroundIsFirm) {
  const auto grid = [this](const char* name, double part, int side = 2) {
    const std::string file = path(name);
    std::ofstream out(file);
    out << "ncols " << side << "\nnrows " << side
        << "\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n";
    for (int i = 0; i < side * side; ++i) out << part << "\n";
    return file;
  };
  const double firm = Json::parse(
      touch({"--firmness", grid("one.asc", 1), "--soft", "0.5"}).out)["largest_force_n"];
  const double soft = Json::parse(
      touch({"--firmness", grid("nil.asc", 0), "--soft", "0.5"}).out)["largest_force_n"];
  EXPECT_GT(firm, 0.05);
  EXPECT_NEAR(soft / firm, 0.5, 1e-6);
  const CommandResult wrong = touch({"--firmness", grid("two.asc", 2), "--soft", "0.5"});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("outside 0 to 1"), std::string::npos) << wrong.err;
  const CommandResult square = touch({"--firmness", grid("square.asc", 1, 30)});
  EXPECT_EQ(square.exit_code, 1);
  EXPECT_NE(square.err.find("'square.asc' has 30 x 30 cells, but the map is"), std::string::npos)
      << square.err;
}

TEST_F(TouchFeel, SaysWhatCannotBeFelt) {
  const CommandResult unknown = touch({"--preset", "marble"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_NE(unknown.err.find("soft_stone"), std::string::npos) << "names what there is";
  EXPECT_EQ(touch({"--soft", "0.1"}).exit_code, 1);
  EXPECT_EQ(touch({"--texture", "1"}).exit_code, 1);
  EXPECT_EQ(touch({"--magnet", "5"}).exit_code, 1);
  EXPECT_EQ(touch({"--level-stiffness", "0.5,-1"}).exit_code, 1);
}

}  // namespace
}  // namespace relievo
