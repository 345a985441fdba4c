// SPDX-License-Identifier: BSD-3-Clause
// What the command line writes says where it came from, and is made again from it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::CommandResult;
using test::runRelievo;
using testing::HasSubstr;

class Repeatable : public test::CommandTest {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "scans");
    fs::create_directories(folder_.path() / "figures");
    writeScan("scans/a.xyz", 97);
  }
  /// Another `modulus` is another relief.
  void writeScan(const std::string& name, int modulus) const {
    std::string text;
    for (int y = 0; y <= 60; ++y) {
      for (int x = 0; x <= 80; ++x) {
        text += std::to_string(x) + " " + std::to_string(y) + " " +
                std::to_string((x * x + 3 * y * y) % modulus / 30.0) + "\n";
      }
    }
    std::ofstream(path(name)) << text;
  }
  static Provenance stateOf(const std::string& file) {
    const auto state = embeddedState(file);
    if (!state) throw std::runtime_error("no state in " + file);
    return provenanceFromJson(*state, file);
  }
  /// A file names the libraries that the program itself says it uses.
  void expectOwnLibraries(const std::string& file) const {
    const std::string said = runRelievo({"--libraries"}).out;
    const json libraries = json::parse(embeddedState(path(file)).value())["made"]["libraries"];
    for (const char* name : {"FLANN", "GDAL", "HDF5", "PCL", "libpng"}) {
      const std::string line =
          "\n" + std::string(name) + ' ' + libraries.value(name, std::string("none")) + '\n';
      EXPECT_THAT(said, HasSubstr(line)) << file;
    }
  }
  static bool samePixels(const std::string& a, const std::string& b) {
    const cv::Mat first = cv::imread(a);
    const cv::Mat second = cv::imread(b);
    return !first.empty() && first.size() == second.size() &&
           cv::norm(first, second, cv::NORM_INF) == 0;
  }
};

TEST_F(Repeatable, AMapByTilesSaysInEveryFileWhatItWasMadeFrom) {
  std::ofstream grid(path("scans/dem.asc"));
  grid << "ncols 300\nnrows 250\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 300 * 250; ++i) grid << i % 37 << ' ';
  grid.close();
  ASSERT_EQ(runRelievo({"depthmap", path("scans/dem.asc"), "--unit", "cm", "--memory", "500", "-o",
                        path("figures/map.tif")})
                .exit_code,
            0);
  for (const char* const name : {"map.tif", "map.origin.tif", "map.L1.tif"}) {
    SCOPED_TRACE(name);
    const Provenance found = stateOf(path(std::string("figures/") + name));
    EXPECT_EQ(found.input.file, "../scans/dem.asc");
    EXPECT_EQ(found.input.sha256, sha256OfFile(path("scans/dem.asc"), {}));
    EXPECT_EQ(found.options.unit, LengthUnit::cm);
    EXPECT_EQ(found.version, RELIEVO_VERSION_STRING);
    const json made = json::parse(found.made);
    EXPECT_EQ(made["cells"], (json{300, 250}));
    EXPECT_EQ(made["engine"], "raster");
  }
}

TEST_F(Repeatable, AnImageIsDrawnAgainFromItself) {
  const std::string first = path("figures/a.png");
  ASSERT_EQ(runRelievo({"render",
                        path("scans/a.xyz"),
                        "--unit",
                        "cm",
                        "--region",
                        "100,100,300,200",
                        "--gain",
                        "3",
                        "--light",
                        "40,20",
                        "--stereo",
                        "anaglyph",
                        "--eye-angle",
                        "5",
                        "--pixels",
                        "150",
                        "--scale-bar",
                        "--holes",
                        "interpolate:3",
                        "--factor",
                        "1.5",
                        "-o",
                        first})
                .exit_code,
            0);
  const std::string again = path("again.png");
  const CommandResult result =
      runRelievo({"render", "--from-image", first, "-o", again, "--report", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(samePixels(first, again));
  EXPECT_EQ(json::parse(result.out)["region_mm"], json({100, 50, 300, 300}));
  // And the picture of the picture is as good.
  ASSERT_EQ(runRelievo({"render", "--from-image", again, "-o", path("third.png")}).exit_code, 0);
  EXPECT_TRUE(samePixels(first, path("third.png")));
  // Another light is another picture: the comparison can fail.
  ASSERT_EQ(
      runRelievo({"render", path("scans/a.xyz"), "--unit", "cm", "--region", "100,100,300,200",
                  "--gain", "3", "--light", "41,20", "--stereo", "anaglyph", "--eye-angle", "5",
                  "--pixels", "150", "--scale-bar", "-o", path("other.png")})
          .exit_code,
      0);
  EXPECT_FALSE(samePixels(first, path("other.png")));
}

TEST_F(Repeatable, EachEyesPictureComesBackFromItself) {
  const std::string both = path("figures/e.png");
  ASSERT_EQ(runRelievo({"render", path("scans/a.xyz"), "--unit", "cm", "--region",
                        "100,100,300,200", "--stereo", "half", "--eye-angle", "5", "--pixels",
                        "150", "--both-eyes", "-o", both})
                .exit_code,
            0);
  const std::string left = path("figures/e.left.png"), right = path("figures/e.right.png");
  EXPECT_FALSE(samePixels(left, right));
  for (const std::string& eye : {left, right}) {
    const CommandResult again =
        runRelievo({"render", "--from-image", eye, "-o", path("eye.png"), "--report", "json"});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(samePixels(eye, path("eye.png"))) << eye;
    EXPECT_THAT(json::parse(again.out)["caption"].get<std::string>(),
                ::testing::HasSubstr(eye == left ? "left eye's picture" : "right eye's picture"));
  }
  // Eyes that change places.
  ASSERT_EQ(runRelievo({"render", path("scans/a.xyz"), "--unit", "cm", "--region",
                        "100,100,300,200", "--eye-angle", "5", "--pixels", "150", "--both-eyes",
                        "--swap-eyes", "-o", path("s.png")})
                .exit_code,
            0);
  EXPECT_TRUE(samePixels(path("s.left.png"), right));
  EXPECT_TRUE(samePixels(path("s.right.png"), left));
}

TEST_F(Repeatable, TheSameCommandGivesTheSameBytes) {
  const auto bytes = [&] {
    EXPECT_EQ(runRelievo({"render", path("scans/a.xyz"), "--pixels", "60", "-o", path("b.png")})
                  .exit_code,
              0);
    return sha256OfFile(path("b.png"));
  };
  EXPECT_EQ(bytes(), bytes());
}

TEST_F(Repeatable, AMovedInputIsGivenAndAChangedOneRefused) {
  const std::string first = path("figures/a.png");
  const std::string scan = path("scans/a.xyz");
  ASSERT_EQ(runRelievo({"render", scan, "--pixels", "64", "-o", first}).exit_code, 0);
  fs::create_directories(folder_.path() / "elsewhere/deep");
  fs::rename(scan, path("elsewhere/deep/b.xyz"));
  const CommandResult lost = runRelievo({"render", "--from-image", first, "-o", path("c.png")});
  EXPECT_EQ(lost.exit_code, 2);
  EXPECT_THAT(lost.err, HasSubstr("a.xyz"));
  EXPECT_FALSE(fs::exists(path("c.png")));
  ASSERT_EQ(runRelievo({"render", path("elsewhere/deep/b.xyz"), "--from-image", first, "-o",
                        path("c.png")})
                .exit_code,
            0);
  EXPECT_TRUE(samePixels(first, path("c.png")));

  writeScan("elsewhere/deep/b.xyz", 89);
  const CommandResult changed = runRelievo(
      {"render", path("elsewhere/deep/b.xyz"), "--from-image", first, "-o", path("d.png")});
  EXPECT_EQ(changed.exit_code, 5);
  EXPECT_THAT(changed.err, HasSubstr("checksum"));
  EXPECT_FALSE(fs::exists(path("d.png")));
  EXPECT_EQ(runRelievo({"render", path("elsewhere/deep/b.xyz"), "--from-image", first,
                        "--changed-input", "-o", path("d.png")})
                .exit_code,
            0);
  EXPECT_FALSE(samePixels(first, path("d.png")));
}

TEST_F(Repeatable, WhatTheImageSaysIsNotSaidTwice) {
  const std::string first = path("a.png");
  ASSERT_EQ(runRelievo({"render", path("scans/a.xyz"), "--pixels", "64", "-o", first}).exit_code,
            0);
  const CommandResult twice =
      runRelievo({"render", "--from-image", first, "--unit", "cm", "-o", path("b.png")});
  EXPECT_EQ(twice.exit_code, 1);
  EXPECT_THAT(twice.err, HasSubstr("--unit"));
  EXPECT_EQ(runRelievo({"render", "-o", path("b.png")}).exit_code, 1);
  cv::imwrite(path("foreign.png"), cv::Mat(4, 4, CV_8UC3));
  const CommandResult foreign =
      runRelievo({"render", "--from-image", path("foreign.png"), "-o", path("b.png")});
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_THAT(foreign.err, HasSubstr("foreign.png"));
}

TEST_F(Repeatable, AFigureIsToldFromAPictureAndBothAreDrawnAgain) {
  const std::string scan = path("scans/a.xyz");
  for (const char* file : {"figures/f.png", "figures/f.tif"}) {
    ASSERT_EQ(runRelievo({"figure", scan, "--unit", "mm", "--dpi", "60", "--relief", "slope", "-o",
                          path(file)})
                  .exit_code,
              0);
    const std::string again = path(fs::path(file).filename().string());
    const CommandResult result =
        runRelievo({"render", "--from-image", path(file), "-o", again, "--report", "json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(samePixels(path(file), again)) << file;
    EXPECT_THAT(json::parse(result.out)["caption"], HasSubstr("Slope in viridis"));
  }
  // The other way round: a figure of what a picture shows.
  const std::string picture = path("p.png");
  ASSERT_EQ(runRelievo({"render", scan, "--unit", "mm", "--region", "10,5,30,30", "-o", picture})
                .exit_code,
            0);
  const CommandResult figure =
      runRelievo({"figure", "--from-image", picture, "-o", path("pf.png"), "--report", "json"});
  ASSERT_EQ(figure.exit_code, 0) << figure.err;
  EXPECT_EQ(json::parse(figure.out)["region_mm"], json({10, 5, 30, 30}));
  // What is asked for beside the picture takes the place of what it says; the map stays its own.
  const CommandResult finer = runRelievo({"figure", "--from-image", path("figures/f.png"), "--dpi",
                                          "90", "-o", path("fine.png"), "--report", "json"});
  ASSERT_EQ(finer.exit_code, 0) << finer.err;
  EXPECT_EQ(json::parse(finer.out)["pixels"][0], 638) << "180 mm at 90 dots per inch";
  EXPECT_EQ(json::parse(finer.out)["relief"], "slope");
  const CommandResult other = runRelievo(
      {"figure", "--from-image", path("figures/f.png"), "--holes", "none", "-o", path("x.png")});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, HasSubstr("--holes"));
  EXPECT_FALSE(fs::exists(path("x.png")));
  // A project comes from either.
  for (const std::string& made : {picture, path("figures/f.tif")}) {
    const CommandResult project = runRelievo({"project", "new", made, "-o", path("p.json")});
    EXPECT_EQ(project.exit_code, 0) << made << project.err;
    EXPECT_EQ(runRelievo({"project", "check", path("p.json")}).exit_code, 0) << made;
  }
  // A map shows no region.
  ASSERT_EQ(runRelievo({"depthmap", scan, "-o", path("m.tif")}).exit_code, 0);
  EXPECT_EQ(runRelievo({"project", "new", path("m.tif"), "-o", path("q.json")}).exit_code, 2);
  EXPECT_EQ(runRelievo({"render", "--from-image", path("m.tif"), "-o", path("n.png")}).exit_code,
            2);
  EXPECT_FALSE(fs::exists(path("q.json")) || fs::exists(path("n.png")));
}

TEST_F(Repeatable, AFigureOfAChangedInputIsRefusedToo) {
  const std::string scan = path("scans/a.xyz");
  const std::string first = path("figures/f.png");
  ASSERT_EQ(runRelievo({"figure", scan, "--unit", "mm", "--dpi", "60", "-o", first}).exit_code, 0);
  fs::rename(scan, path("b.xyz"));
  EXPECT_EQ(runRelievo({"render", "--from-image", first, "-o", path("g.png")}).exit_code, 2);
  const CommandResult given =
      runRelievo({"render", path("b.xyz"), "--from-image", first, "-o", path("g.png")});
  ASSERT_EQ(given.exit_code, 0) << given.err;
  writeScan("b.xyz", 89);
  const CommandResult changed =
      runRelievo({"render", path("b.xyz"), "--from-image", first, "-o", path("h.png")});
  EXPECT_EQ(changed.exit_code, 5);
  EXPECT_THAT(changed.err, HasSubstr("E501"));
  EXPECT_FALSE(fs::exists(path("h.png")));
  ASSERT_EQ(runRelievo({"render", path("b.xyz"), "--from-image", first, "--changed-input", "-o",
                        path("h.png")})
                .exit_code,
            0);
  // What was drawn from the new bytes says so, and is itself drawn again.
  EXPECT_EQ(runRelievo({"render", "--from-image", path("h.png"), "-o", path("i.png")}).exit_code,
            0);
  EXPECT_TRUE(samePixels(path("h.png"), path("i.png")));
}

TEST_F(Repeatable, EveryWrittenFileNamesItsInput) {
  const std::string scan = path("scans/a.xyz");
  const std::string sum = sha256OfFile(scan);
  ASSERT_EQ(runRelievo({"depthmap", scan, "-o", path("m.tif")}).exit_code, 0);
  ASSERT_EQ(runRelievo({"pyramid", scan, "-o", path("p.tif")}).exit_code, 0);
  std::ofstream(path("s.csv")) << "t_s,x_mm,y_mm,z_mm\n0,40,30,9\n0.1,40,30,1\n";
  ASSERT_EQ(runRelievo({"touch", scan, "--stroke", path("s.csv"), "--stiffness", "0.7", "-o",
                        path("log.csv")})
                .exit_code,
            0);
  for (const char* file : {"m.tif", "m.origin.tif", "p.L0.tif", "log.csv"}) {
    const Provenance state = stateOf(path(file));
    EXPECT_EQ(state.input.sha256, sum) << file;
    EXPECT_EQ(state.input.file, "scans/a.xyz") << file;
    EXPECT_FALSE(state.commit.empty()) << file;
    expectOwnLibraries(file);
  }
  const json touch = json::parse(stateOf(path("log.csv")).touch);
  EXPECT_EQ(touch["stiffness_n_per_mm"], 0.7);
  EXPECT_EQ(touch["stroke"]["sha256"], sha256OfFile(path("s.csv")));
}

TEST_F(Repeatable, TheCaptionIsWrittenAndReported) {
  const CommandResult result =
      runRelievo({"render", path("scans/a.xyz"), "--unit", "mm", "--pixels", "64", "-o",
                  path("a.png"), "--caption", path("a.txt"), "--report", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::ifstream in(path("a.txt"));
  std::string text;
  std::getline(in, text);
  EXPECT_EQ(json::parse(result.out)["caption"], text);
  EXPECT_THAT(text, HasSubstr("a.xyz, 81 \u00d7 61"));
  const CommandResult shown = runRelievo({"render", path("scans/a.xyz"), "--unit", "mm", "--pixels",
                                          "64", "-o", path("a.png"), "--caption", "-"});
  EXPECT_THAT(shown.out, HasSubstr(text));
}

}  // namespace
}  // namespace relievo
