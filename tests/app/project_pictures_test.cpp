// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a project's places and views, and pictures that are drawn again and compared.
#include <fstream>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bytesOf;
using test::CommandResult;
using test::joined;
using test::reportOf;
using test::runRelievo;
using Words = std::vector<std::string>;

class ProjectPictures : public test::CommandTest {
 protected:
  CommandResult run(const Words& words) const {
    return runRelievo(joined(words, {"--report", "json"}), {"DISPLAY"});
  }
  json drawn(const Words& words) const { return reportOf(run(words)); }

  /// A hill in 201 x 201 points, and a project on it with a place and a view.
  std::string project() const {
    std::ofstream scan(path("hill.xyz"));
    for (int y = 0; y <= 200; ++y) {
      for (int x = 0; x <= 200; ++x) {
        scan << x << ' ' << y << ' ' << 0.002 * x * (200 - x) + 3 * ((x / 10 + y / 10) % 2) << '\n';
      }
    }
    scan.close();
    drawn({"render", path("hill.xyz"), "--unit", "mm", "--view", "top", "--cells", "401", "-o",
           path("whole.png")});
    const std::string file = path("p.relievo.json");
    EXPECT_EQ(runRelievo({"project", "new", path("whole.png"), "-o", file}).exit_code, 0);
    json state = json::parse(bytesOf(file));
    json view = state["view"];
    view["region_mm"] = {30, 40, 50, 50};
    view["level"] = 0;
    view["gain"] = 2;
    view["look"]["kind"] = "slope";
    const json place{{"name", "north"}, {"x_mm", 100}, {"y_mm", 100},
                     {"side_mm", 80},   {"level", 0},  {"gain", 3}};
    json named{{"name", "crack"}, {"x_mm", 30}, {"y_mm", 40},
               {"side_mm", 50},   {"level", 0}, {"gain", 2}};
    named["view"] = view;
    state["places"] = {place, named};
    std::ofstream(file) << state.dump();
    return file;
  }
};

TEST_F(ProjectPictures, ShowAPlaceOrAViewByItsName) {
  const std::string p = project();
  const json place = drawn({"render", "--project", p, "--place", "north", "-o", path("n.png")});
  EXPECT_EQ(place["region_mm"], json({100, 100, 80, 80}));
  EXPECT_EQ(place["gain"], 3);
  const json view = drawn({"render", "--project", p, "--view", "crack", "-o", path("c.png")});
  EXPECT_EQ(view["region_mm"], json({30, 40, 50, 50}));
  EXPECT_EQ(view["gain"], 2);
  EXPECT_NE(view["caption"].get<std::string>().find("Slope"), std::string::npos) << view["caption"];
  EXPECT_EQ(place["caption"].get<std::string>().find("Slope"), std::string::npos);
  const json figure =
      drawn({"figure", "--project", p, "--view", "crack", "--dpi", "60", "-o", path("f.png")});
  EXPECT_EQ(figure["region_mm"], json({30, 40, 50, 50}));
  EXPECT_EQ(figure["relief"], "slope");
}

TEST_F(ProjectPictures, WhatIsGivenBesideGoesBeyondThem) {
  const std::string p = project();
  const json picture =
      drawn({"render", "--project", p, "--view", "crack", "--region", "10,10,40,40", "--level", "1",
             "--gain", "1.5", "--relief", "hillshade", "--pixels", "64", "-o", path("c.png")});
  EXPECT_EQ(picture["region_mm"], json({10, 10, 40, 40}));
  EXPECT_EQ(picture["level"], 1);
  EXPECT_EQ(picture["gain"], 1.5);
  EXPECT_EQ(picture["pixels"], json({64, 64}));
  EXPECT_NE(picture["caption"].get<std::string>().find("Hillshade"), std::string::npos);
  // As without a project.
  drawn({"render",   path("hill.xyz"), "--unit",      "mm",      "--view", "top",        "--cells",
         "401",      "--region",       "10,10,40,40", "--level", "1",      "--gain",     "1.5",
         "--relief", "hillshade",      "--pixels",    "64",      "-o",     path("d.png")});
  EXPECT_EQ(run({"figure", "--compare", path("c.png")}).exit_code, 0);
  const json figure = drawn({"figure", "--project", p, "--place", "north", "--gain", "1", "--dpi",
                             "60", "--relief", "height", "-o", path("f.png")});
  EXPECT_EQ(figure["region_mm"], json({100, 100, 80, 80}));
  EXPECT_EQ(figure["relief"], "height");
}

TEST_F(ProjectPictures, NamesThatTheProjectDoesNotHaveAreRefused) {
  const std::string p = project();
  const auto refused = [&](const Words& words, const std::string& what) {
    const CommandResult result = run(joined(words, {"-o", path("x.png")}));
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(path("x.png")));
  };
  refused({"render", "--project", p, "--place", "south"},
          "--place: the project has no bookmark 'south'; it has 'north', 'crack'.");
  refused({"figure", "--project", p, "--view", "north"},
          "--view: the project has no view 'north'; it has 'crack'.");
  refused({"render", path("hill.xyz"), "--place", "north"}, "--place needs --project");
  refused({"render", "--project", p, "--place", "north", "--level", "9"},
          "--level: the map has no level 9");
  refused({"render", "--project", p, "--cells", "100"}, "--cells: the project says this already.");
}

TEST_F(ProjectPictures, AreDrawnAgainAndCompared) {
  const std::string p = project();
  drawn({"figure", "--project", p, "--dpi", "60", "-o", path("f.png")});
  drawn({"figure", "--project", p, "--dpi", "60", "--transparent", "-o", path("f.tif")});
  drawn({"render", "--project", p, "--view", "crack", "--pixels", "90", "-o", path("v.png")});
  for (const char* name : {"f.png", "f.tif", "v.png", "whole.png"}) {
    const json report = drawn({"figure", "--compare", path(name)});
    EXPECT_EQ(report["same"], true) << name << report;
    EXPECT_EQ(report["differing_pixels"], 0) << name;
    EXPECT_EQ(report["other_programs"], json::object()) << name;
  }
}

TEST_F(ProjectPictures, ThatWereChangedAreNotAsBefore) {
  const std::string p = project();
  drawn({"render", "--project", p, "--view", "crack", "--pixels", "90", "-o", path("v.tif")});
  // The pixels of one picture with the state of another.
  std::string bytes = bytesOf(path("v.tif"));
  const std::size_t gain = bytes.find("\"gain\": 2");
  ASSERT_NE(gain, std::string::npos);
  bytes[gain + 8] = '3';
  std::ofstream(path("v.tif"), std::ios::binary) << bytes;
  const CommandResult result = run({"figure", "--compare", path("v.tif")});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["same"], false);
  EXPECT_GT(report["differing_pixels"], 100);
  EXPECT_GT(report["largest_difference"], 0);
}

TEST_F(ProjectPictures, ThatCannotBeComparedAreRefused) {
  const std::string p = project();
  const auto refused = [&](const Words& words, int exit_code, const std::string& what) {
    const CommandResult result = run(words);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  };
  drawn({"figure", "--project", p, "--dpi", "60", "-o", path("f.svg")});
  refused({"figure", "--compare", path("f.svg")}, 2, "has no pixels of 8 bits");
  refused({"figure", "--compare", path("whole.png"), "-o", path("x.png")}, 1, "-o: --compare");
  refused({"figure", "--compare", path("whole.png"), "--dpi", "90"}, 1, "--dpi: the image says");
  refused({"figure", "--project", p}, 1, "--output is required");
  write("not.png", "no picture");
  refused({"figure", "--compare", path("not.png")}, 2, "not.png");
  EXPECT_FALSE(fs::exists(path("x.png")));
}

TEST_F(ProjectPictures, SayTheLibrariesThatDrewThem) {
  project();
  const CommandResult own = runRelievo({"--version"}, {"DISPLAY"});
  EXPECT_EQ(own.out.rfind("relievo ", 0), 0U) << own.out;
  const CommandResult version = runRelievo({"--libraries"}, {"DISPLAY"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("relievo ", 0), 0U) << version.out;
  const std::string picture = bytesOf(path("whole.png"));
  for (const char* library : {"FLANN", "GDAL", "HDF5", "PCL", "Qt", "VTK", "libpng"}) {
    const std::size_t line = version.out.find(std::string("\n") + library + ' ');
    ASSERT_NE(line, std::string::npos) << library << " in " << version.out;
    const std::size_t start = version.out.find(' ', line) + 1;
    const std::string number = version.out.substr(start, version.out.find('\n', start) - start);
    EXPECT_NE(number.find('.'), std::string::npos) << library << ' ' << number;
    EXPECT_NE(picture.find('"' + std::string(library) + "\": \"" + number + '"'), std::string::npos)
        << library << ' ' << number;
  }
  for (const char* library : {"hidapi", "libusb", "libzip"}) {
    EXPECT_NE(version.out.find(std::string("\n") + library + ' '), std::string::npos) << library;
  }
}

TEST_F(ProjectPictures, OneFileIsNoFiles) {
  const std::string p = project();
  fs::create_directories(path("below"));
  fs::rename(path("hill.xyz"), path("below/moved.xyz"));
  const CommandResult one = runRelievo({"project", "relink", p, "--search", path("below")});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_NE(one.out.find("1 file was found again"), std::string::npos) << one.out;
}

}  // namespace
}  // namespace relievo
