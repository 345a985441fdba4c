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

TEST_F(FigureVerb, ACaptionToTheScreenIsNoFile) {
  ASSERT_EQ(figure({"--layout", "detail", "--caption", "-", "-o", path("a.png")}).exit_code, 0);
  EXPECT_FALSE(fs::exists("-"));
}

TEST_F(FigureVerb, DrawsASectionAndKeepsItInThePicture) {
  const std::string cut = "rim:section:0,0,1,2.5";
  ASSERT_EQ(figure({"--layout", "detail", "-o", path("plain.png")}).exit_code, 0);
  const CommandResult result =
      figure({"--layout", "detail", "--measure", cut, "-o", path("cut.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(bytesOf(path("plain.png")), bytesOf(path("cut.png")));
  const json rim = json::parse(result.out)["measurements"][0];
  EXPECT_EQ(rim["plane"], json({0, 0, 1, 2.5}));
  EXPECT_EQ(rim["values"][0]["what"], "length of the cut");
  const CommandResult again =
      runRelievo({"figure", "--from-image", path("cut.png"), "-o", path("again.png")}, {"DISPLAY"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(bytesOf(path("cut.png")), bytesOf(path("again.png")));
  EXPECT_EQ(figure({"--measure", "rim:section:0,0,1,99", "-o", path("c.png")}).exit_code, 1);
  EXPECT_EQ(figure({"--measure", "rim:section:0,0,1", "-o", path("c.png")}).exit_code, 1);
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
  for (const std::vector<std::string>& wrong : {
           std::vector<std::string>{"--range", "5,1"},
           {"--radius", "-1"},
           {"--light", "0,-20"},
           {"--scale", "2", "--width-mm", "85"},
           {"--heights", path("h.png")},
           {"--caption", path("a.png")},
           {"--stereo", "grey", "--zero-plane", "1e9"},
       }) {
    EXPECT_EQ(figure(test::joined(wrong, {"-o", path("a.png")})).exit_code, 1) << wrong[0];
  }
  EXPECT_FALSE(fs::exists(path("a.png")));
}

TEST_F(FigureVerb, SaysHowFarApartTheEyesOfItsFilesAre) {
  const CommandResult result = figure({"--layout", "detail", "--both-eyes", "-o", path("a.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_GT(report["eye_angle_deg"], 0);
  EXPECT_GT(report["parallax_deg"], 0);
  EXPECT_TRUE(fs::exists(path("a.left.png")));
  // Both verbs know both words.
  ASSERT_EQ(figure({"--stereo", "grey", "-o", path("grey.png")}).exit_code, 0);
  ASSERT_EQ(figure({"--stereo", "anaglyph", "-o", path("anaglyph.png")}).exit_code, 0);
  EXPECT_EQ(bytesOf(path("grey.png")), bytesOf(path("anaglyph.png")));
}

class RenderVerb : public test::CommandTest {
 protected:
  CommandResult render(const std::vector<std::string>& more) const {
    return runRelievo(
        test::joined({"render", plane_, "--unit", "mm", "--view", "top", "--pixels", "64"}, more),
        {"DISPLAY"});
  }
  const std::string plane_ = plane();
};

TEST_F(RenderVerb, PaintsReliefImages) {
  ASSERT_EQ(render({"-o", path("lit.png")}).exit_code, 0);
  const CommandResult painted = render({"--relief", "slope", "--colours", "cividis", "--range",
                                        "0,20", "--caption", "-", "-o", path("a.png")});
  ASSERT_EQ(painted.exit_code, 0) << painted.err;
  EXPECT_NE(painted.out.find("Slope in cividis"), std::string::npos) << painted.out;
  EXPECT_NE(bytesOf(path("a.png")), bytesOf(path("lit.png")));
  ASSERT_EQ(runRelievo({"render", "--from-image", path("a.png"), "-o", path("b.png")}, {"DISPLAY"})
                .exit_code,
            0);
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("b.png")));
}

TEST_F(RenderVerb, WritesWhatTheEndingSaysOrNothing) {
  ASSERT_EQ(render({"-o", path("a.png")}).exit_code, 0);
  ASSERT_EQ(render({"-o", path("a.tif")}).exit_code, 0);
  EXPECT_EQ(bytesOf(path("a.tif")).substr(0, 2), "II");
  ASSERT_EQ(runRelievo({"render", "--from-image", path("a.tif"), "-o", path("b.png")}, {"DISPLAY"})
                .exit_code,
            0);
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("b.png")));
  EXPECT_EQ(render({"-o", path("a.jpg")}).exit_code, 1);
  EXPECT_FALSE(fs::exists(path("a.jpg")));
  const CommandResult pair = render({"--stereo", "sidebyside", "-o", path("c.png")});
  EXPECT_EQ(pair.exit_code, 1);
  EXPECT_NE(pair.err.find("relievo figure"), std::string::npos) << pair.err;
  EXPECT_EQ(render({"--stereo", "grey", "--zero-plane", "1e9", "-o", path("c.png")}).exit_code, 1);
  EXPECT_FALSE(fs::exists(path("c.png")));
}

TEST_F(RenderVerb, ConvertWritesTheValuesOfAReliefImage) {
  const auto convert = [this](const std::vector<std::string>& more) {
    return runRelievo(test::joined({"convert", plane_}, more)).exit_code;
  };
  ASSERT_EQ(convert({path("slope.asc"), "--unit", "mm", "--view", "top", "--relief", "slope"}), 0);
  std::istringstream values(bytesOf(path("slope.asc")));
  std::string word;
  for (int i = 0; i < 12; ++i) values >> word;  // Its head.
  double slope = 0;
  values >> slope;
  EXPECT_NEAR(slope, 5.7106, 1e-3) << "the arc tangent of 1/10";
  EXPECT_EQ(convert({path("slope.tif"), "--relief", "slope"}), 0);
  EXPECT_EQ(convert({path("slope.ply"), "--relief", "slope"}), 1);
  EXPECT_EQ(convert({path("lit.tif"), "--relief", "lit"}), 1);
  EXPECT_EQ(convert({path("lit.tif"), "--radius", "3"}), 1);
}

}  // namespace
}  // namespace relievo
