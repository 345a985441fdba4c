// SPDX-License-Identifier: BSD-3-Clause
// Options that could change nothing are refused by name, and misuse is told in a sentence.
#include <fstream>
#include <functional>

#include "tests/app/command_test.h"

namespace relievo::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

class OptionUse : public CommandTest {
 protected:
  /// A map of 11 x 11 cells.
  std::string map() const {
    std::string grid = "ncols 11\nnrows 11\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int i = 0; i < 121; ++i) grid += std::to_string(i % 11) + (i % 11 == 10 ? "\n" : " ");
    return write("m.asc", grid);
  }
  /// One sentence of ours ends stderr and begins with `what`, exit 1, and no such output.
  void isRefused(const Words& words, const std::string& what, const std::string& out) const {
    const CommandResult result = runRelievo(words);
    std::string line;
    for (const std::string& word : words) line += word + " ";
    EXPECT_EQ(result.exit_code, 1) << line << result.err;
    EXPECT_NE(result.err.find("relievo: " + what), std::string::npos) << line << result.err;
    const std::size_t last = result.err.rfind("relievo: ");  // After what is said of the unit.
    EXPECT_EQ(last, result.err.find("relievo: " + what)) << line << result.err;
    EXPECT_EQ(result.err.find('\n', last), result.err.size() - 1) << line << result.err;
    EXPECT_FALSE(fs::exists(out)) << line;
  }
};

TEST_F(OptionUse, OfFiguresAndPicturesIsAsInTheWindow) {
  const std::string m = map(), out = path("f.png");
  const auto figure = [&](const Words& more, const std::string& what) {
    isRefused(joined({"figure", m, "-o", out}, more), what, out);
  };
  const auto render = [&](const Words& more, const std::string& what) {
    isRefused(joined({"render", m, "-o", out}, more), what, out);
  };
  figure({"--layout", "detail", "--recording", "none.csv"}, "--recording needs --layout plot.");
  for (const auto& verb : {std::function(figure), std::function(render)}) {
    verb({"--range", "0,5"}, "--range needs a --relief with colours");
    verb({"--relief", "hillshade", "--colours", "grey"}, "--colours needs a --relief with colours");
    verb({"--shading", "0.5"}, "--shading needs --relief natural or intensity");
    verb({"--relief", "natural", "--shading", "2"}, "--shading: '2' is not a number from 0 to 1.");
    verb({"--relief", "natural"},
         "The relief image 'natural' cannot be drawn: this surface has no ");
    verb({"--relief", "intensity"},
         "The relief image 'intensity' cannot be drawn: this surface has ");
    verb({"--relief", "slope", "--radius", "3"}, "--radius needs --relief local, skyview");
    verb({"--relief", "slope", "--light", "0,45"}, "--light needs --relief lit, height");
    verb({"--eye-angle", "4"}, "--eye-angle needs a kind of --stereo");
    verb({"--zero-plane", "1"}, "--zero-plane needs a kind of --stereo");
    verb({"--swap-eyes"}, "--swap-eyes needs a kind of --stereo");
    verb({"--changed-input"}, "--changed-input needs --from-image or --project.");
  }
  figure({"--any-parallax"}, "--any-parallax needs a kind of --stereo");
}

TEST_F(OptionUse, ThatAppliesIsTaken) {
  const std::string m = map(), out = path("f.png");
  for (const Words& more : std::vector<Words>{
           {"--both-eyes", "--eye-angle", "3", "--swap-eyes"},
           {"--stereo", "grey", "--eye-angle", "3", "--zero-plane", "5"},
           {"--relief", "local", "--radius", "3", "--range", "-1,1", "--colours", "grey"},
           {"--relief", "multi", "--light", "0,60"}}) {
    const CommandResult result = runRelievo(joined({"figure", m, "--dpi", "60", "-o", out}, more));
    EXPECT_EQ(result.exit_code, 0) << more[0] << result.err;
  }
}

TEST_F(OptionUse, OfOtherVerbsLikewise) {
  const std::string m = map(), out = path("o.csv"), log = path("log.csv");
  isRefused({"measure", m, "--plane", "3", "--point", "4,4", "-o", out}, "--plane needs --area.",
            out);
  const std::string cloud = write("c.xyz", "0 0 0\n1 0 1\n0 1 2\n1 1 3\n");
  for (const char* option : {"--pixel-size", "--height-scale", "--height-zero"}) {
    isRefused({"depthmap", cloud, "--unit", "mm", option, "2", "-o", path("d.tif")},
              std::string(option) + " needs a raster that relievo did not write.", path("d.tif"));
  }
  isRefused({"depthmap", m, "--unit", "mm", "--height-scale", "0", "-o", path("d.tif")},
            "A pixel size is above 0 mm, and a height scale is not 0 mm.", path("d.tif"));
  isRefused({"convert", m, path("o.tif"), "--plate", "2"}, "--plate needs an OUT.stl.",
            path("o.tif"));
  isRefused({"touch", m, "--stroke", kFlatStroke, "--magnet-reach", "2", "-o", out},
            "--magnet-reach needs --magnet.", out);
  isRefused({"touch", m, "--stroke", kFlatStroke, "--stiffness", "1", "--level-stiffness", "1,2",
             "-o", out},
            "--stiffness is one for all levels.", out);
  ASSERT_EQ(runRelievo({"touch", m, "--stroke", kFlatStroke, "-o", log}).exit_code, 0);
  const auto video = [&](const Words& more, const std::string& what) {
    isRefused(joined({"video", log, "--frame", "0", "-o", path("v.png")}, more), what,
              path("v.png"));
  };
  video({"--eye-angle", "3"}, "--eye-angle needs a kind of --stereo");
  video({"--swap-eyes"}, "--swap-eyes needs a kind of --stereo");
  video({"--colours", "grey"}, "--colours needs a --relief with colours");
  for (const char* size : {"640.5x480", "640x480.5"}) {
    video({"--size", size}, "--size must be WIDTHxHEIGHT, like 1280x720.");
  }
  isRefused({"video", log, "--frame", "0", "-o", path("v.mp4")},
            "A picture's name ends in .png or .tif; 'v.mp4' does not.", path("v.mp4"));
  isRefused({"project", "info", log, "-o", out}, "--output belongs to project new or relink", out);
  isRefused({"project", "new", log, "--to", m, "-o", out}, "--to belongs to project relink", out);
}

TEST_F(OptionUse, TheAngleBetweenTheEyesHasOneRange) {
  const std::string m = map(), out = path("e.png");
  for (const char* angle : {"0.009", "60.1"}) {
    const std::string why =
        std::string("--eye-angle: '") + angle + "' is not a number from 0.01 to 60 degrees.";
    for (const char* verb : {"render", "figure", "video"}) {
      isRefused({verb, m, "--stereo", "half", "--eye-angle", angle, "-o", out}, why, out);
    }
  }
  for (const char* angle : {"0.01", "60"}) {
    for (const char* verb : {"render", "figure"}) {
      const CommandResult drawn =
          runRelievo({verb, m, "--stereo", "half", "--eye-angle", angle, "-o", out});
      EXPECT_EQ(drawn.exit_code, 0) << verb << drawn.err;
    }
  }
}

TEST_F(OptionUse, AMapIsNotGivenTheNameOfSomethingElse) {
  const std::string m = map();
  const auto sentence = [](const std::string& option, const std::string& out) {
    return option + ": the file's name must end with .tif or .tiff, not '" + out + "'.";
  };
  for (const char* name : {"g.png", "g", "g.tif.gz"}) {
    const std::string out = path(name);
    isRefused({"depthmap", m, "-o", out}, sentence("--output", out), out);
    isRefused({"depthmap", m, "--memory", "400", "-o", out}, sentence("--output", out), out);
    isRefused({"fill", m, "-o", out}, sentence("--output", out), out);
    const std::string drawn = path("r.png"), why = sentence("--window-out", out);
    isRefused({"render", m, "-o", drawn, "--window-out", out}, why, drawn);
    isRefused({"figure", m, "-o", drawn, "--window-out", out}, why, drawn);
    isRefused({"touch", m, "--stroke", kFlatStroke, "-o", path("t.csv"), "--window-out", out}, why,
              path("t.csv"));
    EXPECT_FALSE(fs::exists(out)) << name;
  }
  for (const char* name : {"a.tiff", "B.TIF", "c.d.tif"}) {
    EXPECT_EQ(runRelievo({"depthmap", m, "-o", path(name)}).exit_code, 0) << name;
    EXPECT_TRUE(fs::exists(path(name))) << name;
  }
  // The name of a pyramid is the beginning of its files' names, which have its ending.
  for (const auto& [name, level] : {std::pair("g.png", "g.L0.png"), {"g.tif.gz", "g.tif.L0.gz"}}) {
    const std::string out = path(name), why = sentence("--output", out);
    isRefused({"pyramid", m, "-o", out}, why, path(level));
    isRefused({"pyramid", m, "--memory", "400", "-o", out}, why, path(level));
  }
  for (const auto& [name, level] : {std::pair("levels", "levels.L0"), {"l.TIFF", "l.L0.TIFF"}}) {
    EXPECT_EQ(runRelievo({"pyramid", m, "-o", path(name)}).exit_code, 0) << name;
    EXPECT_TRUE(fs::exists(path(level))) << name;
  }
}

TEST_F(OptionUse, AMeasurementIsNotGivenAnEmptyName) {
  const std::string m = map(), out = path("o.csv");
  for (const char* point : {"=1,1", " =1,1"}) {
    isRefused({"measure", m, "--point", point, "-o", out}, "--point needs a NAME before '='.", out);
  }
  EXPECT_EQ(runRelievo({"measure", m, "--point", "a=1,1", "--point", "1,1"}).exit_code, 0);
}

TEST_F(OptionUse, ThatIsWrongIsToldInASentence) {
  const std::string m = map(), out = path("f.png");
  const std::string none = " Nothing was done. 'relievo figure --help' says what there is.\n";
  isRefused({"figure", m, "--dpi", "abc", "-o", out},
            "--dpi: 'abc' is not a number from 30 to 2400." + none, out);
  isRefused({"figure", m}, "--output is required." + none, out);
  isRefused({"figure", m, "--colour", "-o", out},
            "The following argument was not expected: --colour." + none, out);
  const std::string render = " Nothing was done. 'relievo render --help' says what there is.\n";
  isRefused({"render", m, "--pixels", "15", "-o", out},
            "--pixels: '15' is not a number from 16 to 16384." + render, out);
  isRefused({"render", m, "--report", "xml", "-o", out},
            "--report: 'xml' is none of json,text." + render, out);
  isRefused({"figure", m, "--width-mm", "2000", "--dpi", "2400", "-o", out}, "A picture of ", out);
  const CommandResult large =
      runRelievo({"figure", m, "--width-mm", "2000", "--dpi", "2400", "-o", out});
  EXPECT_NE(large.err.find("can hold, 536 million in all. Nothing was drawn."), std::string::npos)
      << large.err;
}

TEST_F(OptionUse, ARegionBesideTheMapIsRefusedByEveryVerbThatTakesOne) {
  const std::string m = map(), nothing = "There is nothing of the object in this region.";
  for (const char* beside : {"30,30,4,4", "11,2,4,4", "2,11,4,4"}) {
    isRefused({"render", m, "--region", beside, "-o", path("r.png")}, nothing, path("r.png"));
    isRefused({"figure", m, "--region", beside, "-o", path("f.png")}, nothing, path("f.png"));
    isRefused({"touch", m, "--region", beside, "--stroke", kFlatStroke, "-o", path("t.csv")},
              nothing, path("t.csv"));
    isRefused({"convert", m, path("w.tif"), "--region", beside}, nothing, path("w.tif"));
  }
  isRefused({"record", m, "--region=-5,2,4,4", "--seconds", "0.1", "-o", path("t.csv")}, nothing,
            path("t.csv"));
  for (const char* partly : {"10,10,4,4", "-3,-3,4,4"}) {
    const CommandResult drawn =
        runRelievo({"render", m, std::string("--region=") + partly, "-o", path("p.png")});
    EXPECT_EQ(drawn.exit_code, 0) << partly << drawn.err;
  }
}

TEST_F(OptionUse, ThatALogHasIsNoMisuseWhenItIsReplayed) {
  const std::string m = map(), log = path("log.csv"), old = path("old.csv");
  const CommandResult touched = runRelievo(
      {"touch", m, "--region", "2,2,4,4", "--gain", "1", "--stroke", kFlatStroke, "-o", log});
  ASSERT_EQ(touched.exit_code, 0) << touched.err;
  ASSERT_EQ(runRelievo({"replay", log, "--verify"}).exit_code, 0);
  for (const auto& [now, then] : {std::pair{R"("2,2,4,4")", R"("30,30,4,4")"},
                                  std::pair{R"("--gain","1")", R"("--cells","7")"}}) {
    std::string text = bytesOf(log);
    const std::size_t at = text.find(now);
    ASSERT_NE(at, std::string::npos) << now;
    std::ofstream(old) << text.replace(at, std::string(now).size(), then);
    const CommandResult replayed = runRelievo({"replay", old, "--verify"});
    EXPECT_EQ(replayed.exit_code, 5) << "only its checksum tells: " << replayed.err;
  }
}

TEST_F(OptionUse, WhatARasterCannotFollowIsTold) {
  const std::string m = map();
  const std::vector<Words> of_scans{{"--cells", "5"},     {"--spacing", "2"},
                                    {"--rule", "median"}, {"--engine", "depthbuffer"},
                                    {"--strays", "keep"}, {"--every", "2"}};
  const std::vector<Words> of_others{{"--unit", "m"}, {"--view", "left"}, {"--turn", "0,9,0"}};
  const auto told = [&](const Words& words, const std::string& option, const std::string& why) {
    const CommandResult result = runRelievo(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find(option + " changes nothing here: " + why), std::string::npos)
        << result.err;
  };
  for (const Words& option : of_scans) {
    const std::string out = path("d" + option[0] + ".tif");
    told(joined(joined({"depthmap", m}, option), {"-o", out}), option[0], "a raster keeps ");
  }
  const std::vector<Words> of_points{
      {"--reader", "own"}, {"--parts", "1"}, {"--keep-withheld"}, {"--load-incomplete"}};
  for (const Words& option : of_points) {
    const std::string why = "a raster has no points to be read.", out = path("p.tif");
    told(joined({"info", m}, option), option[0], why);
    told(joined({"depthmap", m, "-o", out}, option), option[0], why);
    told(joined({"depthmap", m, "--memory", "400", "-o", out}, option), option[0], why);
    told(joined({"convert", m, out}, option), option[0], why);
  }
  for (const Words& option : std::vector<Words>{{"--cells", "5"}, {"--rule", "median"}}) {
    const std::string out = path("t.tif");
    told(joined({"depthmap", m, "--memory", "400", "-o", out}, option), option[0],
         "a raster keeps ");
    told(joined({"convert", m, out}, option), option[0], "a raster keeps ");
  }
  const std::string ours = path("ours.tif"), tiles = path("tiles.tif");
  ASSERT_EQ(runRelievo({"depthmap", m, "--unit", "cm", "-o", ours}).exit_code, 0);
  ASSERT_EQ(runRelievo({"depthmap", m, "--memory", "400", "-o", tiles}).exit_code, 0);
  for (const std::string& file : {ours, tiles}) {
    for (const Words& option : of_others) {
      told(joined(joined({"render", file}, option), {"-o", path("d.png")}), option[0],
           "a map that relievo wrote is taken as it is.");
    }
    const CommandResult quiet = runRelievo(
        {"render", file, "--unit", "mm", "--view", "top", "--rule", "auto", "-o", path("e.png")});
    EXPECT_EQ(quiet.exit_code, 0) << quiet.err;
    EXPECT_EQ(quiet.err.find("changes nothing"), std::string::npos) << quiet.err;
  }
  told({"depthmap", ours, "--memory", "400", "--unit", "m", "-o", path("again.tif")}, "--unit",
       "a map that relievo wrote is taken as it is.");
  isRefused({"convert", ours, path("no.tif"), "--pixel-size", "2"},
            "--pixel-size needs a raster that relievo did not write.", path("no.tif"));
}

TEST_F(OptionUse, ALogOrStrokeThatIsNotThereIsToldAsSuch) {
  const std::string m = map(), missing = path("none.csv"), out = path("o.csv");
  const auto told = [&](const Words& words, const std::string& why) {
    const CommandResult result = runRelievo(words);
    EXPECT_EQ(result.exit_code, 2) << words.front() << result.err;
    EXPECT_NE(result.err.find(why), std::string::npos) << words.front() << result.err;
    EXPECT_EQ(result.err.find(" log "), std::string::npos) << words.front() << result.err;
    EXPECT_EQ(result.err.find(" stroke "), std::string::npos) << words.front() << result.err;
  };
  for (const auto& [file, why] :
       {std::pair{missing,
                  "Cannot read none.csv: there is no such file. Check the name and the "
                  "folder."},
        std::pair{path("none.h5"), "Cannot read none.h5: there is no such file."},
        std::pair{path(""), "it is a folder. Choose one of the files in it."}}) {
    told({"sound", file, "-o", path("s.wav")}, why);
    told({"video", file, "-o", path("v.mp4")}, why);
    told({"figure", m, "--layout", "plot", "--recording", file, "-o", path("f.png")}, why);
    told({"touch", m, "--stroke", file, "-o", out}, why);
    told({"touch", m, "--device", "virtual", "--guide", file, "-o", out}, why);
    told({"record", m, "--stroke", file, "--seconds", "0.1", "-o", out}, why);
  }
}

TEST_F(OptionUse, ThatMeasuresNamesThePlaceAndTheSection) {
  const std::string m = map(), out = path("o.csv");
  isRefused({"measure", m, "--point", "900,9.25", "-o", out},
            "There is no surface at x 900, y 9.25 mm.", out);
  isRefused({"measure", m, "--section", "0,0,1,5", "--section", "rim=0,0,1,99", "-o", out},
            "The plane of 'rim' does not cut the surface.", out);
}

TEST_F(OptionUse, TakesAScaleAsItIsWritten) {
  const std::string m = map();
  const auto paper = [&](const std::string& scale) {
    const CommandResult result =
        runRelievo({"figure", m, "--layout", "detail", "--dpi", "60", "--scale", scale, "-o",
                    path("f.png"), "--report", "json"});
    return reportOf(result)["scale_1_to"].get<double>();
  };
  EXPECT_EQ(paper("0.5"), 0.5);
  EXPECT_EQ(paper("1:0.5"), 0.5);
  EXPECT_EQ(paper("2:1"), 0.5);
  EXPECT_EQ(paper("1:0.25"), paper("0.25"));
  isRefused({"figure", m, "--scale", "1:x", "-o", path("g.png")},
            "--scale: 'x' is not a number from -1e12 to 1e12.", path("g.png"));
  isRefused({"figure", m, "--scale", "0:1", "-o", path("g.png")},
            "--scale: '0:1' is not of the form 1:N.", path("g.png"));
}

}  // namespace
}  // namespace relievo::test
