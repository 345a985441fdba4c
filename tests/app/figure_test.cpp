// SPDX-License-Identifier: BSD-3-Clause
// Figures by the command line, tried from outside.
#include <filesystem>
#include <fstream>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bytesOf;
using test::CommandResult;
using test::runRelievo;

class FigureVerb : public test::CommandTest {
 protected:
  void SetUp() override {
    // A step of 5 mm at x = 50, 101 x 101 points, 1 mm apart.
    std::ofstream scan(path("step.xyz"));
    for (int y = 0; y <= 100; ++y) {
      for (int x = 0; x <= 100; ++x) scan << x << ' ' << y << ' ' << (x > 50 ? 5 : 0) << '\n';
    }
  }
  CommandResult figure(const std::vector<std::string>& more) const {
    return runRelievo(test::joined({"figure", path("step.xyz"), "--unit", "mm", "--view", "top",
                                    "--dpi", "100", "--report", "json"},
                                   more),
                      {"DISPLAY"});
  }
};

TEST_F(FigureVerb, ReportsItsSizeAndMeasuresWithoutADisplay) {
  const CommandResult result =
      figure({"--width-mm", "85", "--measure", "edge:depth:20,50;80,50", "--caption", path("c.txt"),
              "--heights", path("h.tif"), "-o", path("a.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["pixels"][0], 335);
  EXPECT_EQ(report["layout"], "reference");
  const json edge = report["measurements"][0]["values"][0];
  EXPECT_NEAR(edge["value"].get<double>(), 5, 1e-6);
  EXPECT_EQ(report["input_sha256"].get<std::string>().size(), 64U);
  EXPECT_NE(bytesOf(path("c.txt")).find("step.xyz"), std::string::npos);
  EXPECT_FALSE(bytesOf(path("h.tif")).empty());
}

TEST_F(FigureVerb, DrawsTheSamePixelsAgainFromItsPicture) {
  ASSERT_EQ(figure({"--relief", "slope", "--region", "30,30,40,40", "-o", path("a.png")}).exit_code,
            0);
  const CommandResult again =
      runRelievo({"figure", "--from-image", path("a.png"), "-o", path("b.png")}, {"DISPLAY"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("b.png")));
  const CommandResult render =
      runRelievo({"render", "--from-image", path("a.png"), "-o", path("c.png")}, {"DISPLAY"});
  ASSERT_EQ(render.exit_code, 0) << render.err;
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("c.png")));
}

TEST_F(FigureVerb, SaysSoWhenTheInputChanged) {
  ASSERT_EQ(figure({"-o", path("a.png")}).exit_code, 0);
  std::ofstream(path("step.xyz"), std::ios::app) << "50 50 9\n";
  const CommandResult again =
      runRelievo({"figure", "--from-image", path("a.png"), "-o", path("b.png")}, {"DISPLAY"});
  EXPECT_EQ(again.exit_code, 5);
  EXPECT_NE(again.err.find("E501"), std::string::npos) << again.err;
  EXPECT_FALSE(fs::exists(path("b.png"))) << "nothing is drawn from other bytes unasked";
  EXPECT_EQ(
      runRelievo({"figure", "--from-image", path("a.png"), "--changed-input", "-o", path("b.png")},
                 {"DISPLAY"})
          .exit_code,
      0);
  EXPECT_TRUE(fs::exists(path("b.png")));
}

TEST_F(FigureVerb, RefusesWhatItCannotDrawInWords) {
  EXPECT_EQ(figure({"--relief", "rainbow", "-o", path("a.png")}).exit_code, 1);
  EXPECT_EQ(figure({"--dpi", "9", "-o", path("a.png")}).exit_code, 1);
  EXPECT_EQ(figure({"--without", "sense", "-o", path("a.png")}).exit_code, 1);
  EXPECT_EQ(figure({"-o", path("a.jpg")}).exit_code, 1);
  EXPECT_EQ(
      figure({"--layout", "plot", "--recording", path("none.csv"), "-o", path("a.png")}).exit_code,
      2);
  EXPECT_EQ(runRelievo({"figure", "-o", path("a.png")}).exit_code, 1);
  std::ofstream(path("no.png")) << "no picture";
  EXPECT_EQ(runRelievo({"figure", "--from-image", path("no.png"), "-o", path("a.png")}).exit_code,
            2);
  EXPECT_FALSE(fs::exists(path("a.png")));
}

}  // namespace
}  // namespace relievo
