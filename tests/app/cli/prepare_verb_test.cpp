// SPDX-License-Identifier: BSD-3-Clause
#include <sys/wait.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include "core/io/import.h"
#include "core/prepare/recipe.h"
#include "core/provenance/embedded.h"
#include "core/provenance/sha256.h"
#include "tests/app/command_test.h"

namespace relievo::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

class PrepareVerb : public CommandTest {
 protected:
  /// A wavy relief of 80 x 80 mm with 9 strays far above, their numbers in front.
  std::string relief(const std::string& name, double shift = 0) const {
    std::ostringstream text;
    for (int i = 0; i < 9; ++i) text << 8 * i + shift << " 40 " << 150 + 40 * i << '\n';
    for (int y = 0; y <= 160; ++y) {
      for (int x = 0; x <= 160; ++x) {
        text << 0.5 * x + shift << ' ' << 0.5 * y << ' '
             << 3 * std::sin(0.1 * x) * std::cos(0.08 * y) << '\n';
      }
    }
    return write(name, text.str());
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }
  void isRefused(const Words& words, int code, const std::string& says) const {
    const auto before = files();
    const CommandResult result = runRelievo(joined({"prepare"}, words));
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
    EXPECT_EQ(files(), before);
  }
};

TEST_F(PrepareVerb, LeavesOutStraysAndSaysSo) {
  const std::string scan = relief("relief.xyz");
  const auto report = reportOf(runRelievo(
      {"prepare", scan, "--unit", "mm", "--clean", "-o", path("clean.ply"), "--report", "json"}));
  EXPECT_EQ(report["points"], 161 * 161);
  EXPECT_EQ(report["inputs"][0]["file"], "relief.xyz");
  EXPECT_EQ(report["inputs"][0]["points"], 161 * 161 + 9);
  EXPECT_EQ(report["inputs"][0]["sha256"], sha256OfFile(scan));
  std::uint64_t left_out = 0;
  for (const auto& step : report["steps"]) {
    left_out += step["before"].get<std::uint64_t>() - step["after"].get<std::uint64_t>();
    EXPECT_TRUE(step.contains("kind") && step.contains("parameters") && step.contains("seconds"));
  }
  EXPECT_EQ(left_out, 9U);
  for (const char* key : {"scans", "loops", "colours", "pcl", "flann", "warnings", "not_done"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  // Measured points are the bytes that were read.
  const Scan before = importScan(scan);
  const Scan after = importScan(path("clean.ply"));
  ASSERT_EQ(after.points.size(), before.points.size() - 9);
  EXPECT_EQ(after.info.unit, LengthUnit::mm);
  EXPECT_EQ(std::memcmp(after.points.data(), before.points.data() + 9, after.points.size() * 12),
            0);
  const auto map = reportOf(runRelievo(
      {"depthmap", path("clean.ply"), "--view", "top", "-o", path("map.tif"), "--report", "json"}));
  EXPECT_LT(map["height_mm"]["max"], 7);
  EXPECT_GT(map["cells"][0], 100);
}

TEST_F(PrepareVerb, CarriesWhereItComesFromAndDoesItAgain) {
  const std::string scan = relief("relief.xyz");
  const Words steps{"--unit", "mm",     "--crop", "0,0,-9,60,60,900", "--outliers",
                    "8,2",    "--thin", "1.5",    "--base",           "lay"};
  const CommandResult first = runRelievo(
      joined({"prepare", scan, "-o", path("a.ply"), "--write-recipe", path("r.json")}, steps));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const auto state = embeddedState(path("a.ply"));
  ASSERT_TRUE(state);
  const auto json = nlohmann::json::parse(*state);
  EXPECT_EQ(json["relievo_prepared"], 1);
  EXPECT_EQ(json["inputs"][0]["sha256"], sha256OfFile(scan));
  EXPECT_EQ(json["steps"].size(), 4U);
  EXPECT_EQ(json["flann"], "1.9.2");
  const Recipe recipe = recipeFromJson(bytesOf(path("r.json")), "r.json");
  ASSERT_EQ(recipe.steps.size(), 4U);
  EXPECT_EQ(recipe.scans[0].file, "relief.xyz");
  EXPECT_EQ(recipe.scans[0].unit, LengthUnit::mm);
  // No line that other programs stop at.
  std::istringstream header(bytesOf(path("a.ply")));
  for (std::string line; std::getline(header, line) && line != "end_header";) {
    EXPECT_LT(line.size(), 256U);
  }
  // The same bytes, from the recipe alone, from another folder, and by the options again.
  ASSERT_EQ(runRelievo({"prepare", "--recipe", path("r.json"), "-o", path("b.ply")}).exit_code, 0);
  EXPECT_TRUE(bytesOf(path("b.ply")) == bytesOf(path("a.ply")));
  ASSERT_EQ(runRelievo(joined({"prepare", scan, "-o", path("c.ply")}, steps)).exit_code, 0);
  EXPECT_TRUE(bytesOf(path("c.ply")) == bytesOf(path("a.ply")));
  // Another file in its place is not taken in silence.
  relief("relief.xyz", 1);
  isRefused({"--recipe", path("r.json"), "-o", path("d.ply")}, 5, "E501");
  EXPECT_EQ(
      runRelievo({"prepare", scan, "--recipe", path("r.json"), "-o", path("d.ply")}).exit_code, 0);
}

TEST_F(PrepareVerb, JoinsScansAsStoredInParts) {
  const std::string left = relief("left.xyz");
  const std::string right = relief("right.xyz", 40);
  const auto report =
      reportOf(runRelievo({"prepare", left, right, "--unit", "mm", "--outliers", "8,2",
                           "--drop-duplicates", "-o", path("both.ply"), "--report", "json"}));
  EXPECT_EQ(report["points"], 2 * 161 * 161);
  ASSERT_EQ(report["scans"].size(), 2U);
  EXPECT_EQ(report["scans"][1]["verdict"], "As stored.");
  EXPECT_EQ(report["steps"][2]["kind"], "align");
  const std::string bytes = bytesOf(path("both.ply"));
  const std::string header = bytes.substr(0, bytes.find("end_header"));
  EXPECT_NE(header.find("comment part 1 right.xyz\n"), std::string::npos) << header;
  EXPECT_NE(header.find("property uchar part\n"), std::string::npos) << header;
  EXPECT_EQ(importScan(path("both.ply")).info.bounds->max.x, 120);
}

TEST_F(PrepareVerb, KeepsTheResolutionOfCoordinatesOfAMap) {
  std::ostringstream text;
  text.precision(12);
  for (int i = 0; i < 4000; ++i) {
    text << 500000.25 + 0.001 * (i % 63) << ' ' << 5400000.5 + 0.001 * (i / 63) << " 100\n";
  }
  const std::string scan = write("site.xyz", text.str());
  const auto report = reportOf(runRelievo({"prepare", scan, "--unit", "m", "--drop-duplicates",
                                           "-o", path("site.ply"), "--report", "json"}));
  EXPECT_EQ(report["points"], 4000);
  const Scan after = importScan(path("site.ply"));
  EXPECT_NEAR(after.point(1).x - after.point(0).x, 0.001, 1e-7);
  EXPECT_NEAR(after.info.bounds->max.x, 500000.312, 1e-6);
}

TEST_F(PrepareVerb, WhatCannotBeDoneIsSaidAndExitsWithFour) {
  const std::string scan = relief("relief.xyz");
  const CommandResult result =
      runRelievo({"prepare", scan, "--unit", "mm", "--classes", "2,6", "-o", path("a.ply")});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("states no classes"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::exists(path("a.ply")));
}

TEST_F(PrepareVerb, RefusesInWordsAndWritesNothing) {
  const std::string scan = relief("relief.xyz");
  const std::string out = path("a.ply");
  const std::string bad =
      write("bad.json", R"({"relievo_recipe": 1, "steps": [{"kind": "thin"}]})");
  const std::string pairs = write("p.csv", "scan,x,y,z\n1,2,3,4\n");
  isRefused({scan, "-o", path("a.obj")}, 1, "is no .ply");
  isRefused({"-o", out}, 1, "There is no FILE");
  isRefused({scan, "--crop", "1,2,3", "-o", out}, 1, "is not 6 numbers");
  isRefused({scan, "--crop", "500,0,0,600,1,1", "-o", out}, 1, "No point is left");
  isRefused({scan, "--thin", "0", "-o", out}, 1, "is not a number from");
  isRefused({scan, "--thin", "nan", "-o", out}, 1, "is not a number from");
  isRefused({scan, "--outliers", "0,2", "-o", out}, 1, "'neighbours' is 0");
  isRefused({scan, "--outliers", "8.5,2", "-o", out}, 1, "not a whole number");
  isRefused({scan, "--sparse", "8", "-o", out}, 1, "two or three numbers");
  isRefused({scan, "--sparse", "8,2.6,-1", "-o", out}, 1, "'off_surface' is -1");
  isRefused({scan, "--parts", "one", "-o", out}, 1, "--parts: 'one'");
  isRefused({scan, "--parts", "2", "-o", out}, 1, "there is no scan 2");
  isRefused({scan, "--reader", "pcl", "-o", out}, 1, "no reader of this format");
  isRefused({scan, "--base", "up", "-o", out}, 1, "neither lay nor crop");
  isRefused({scan, "--align", "somehow", "-o", out}, 1, "none of points:P.csv");
  isRefused({scan, "--align", "points:" + pairs, "-o", out}, 2, "other columns");
  isRefused({scan, "--seed", "3", "-o", out}, 1, "--seed");
  isRefused({scan, "--reference", "2", "-o", out}, 1, "--reference");
  isRefused({scan, "--unit", "yard", "-o", out}, 1, "--unit");
  isRefused({scan, "--memory", "1", "-o", out}, 1, "--memory");
  isRefused({scan, "--recipe", bad, "-o", out}, 2, "is no recipe");
  isRefused({scan, "--recipe", bad, "--thin", "1", "-o", out}, 1, "--thin: the recipe says");
  isRefused({path("none.xyz"), "-o", out}, 2, "none.xyz");
  const std::string ply = path("scan.ply");
  ASSERT_EQ(runRelievo({"prepare", scan, "-o", ply}).exit_code, 0);
  isRefused({ply, "--thin", "1", "-o", ply}, 1, "is the scan itself");
  isRefused({ply, "-o", out, "--write-recipe", ply}, 1, "is the scan itself");
  isRefused({ply, "-o", out, "--write-recipe", out}, 1, "Two of the outputs");
}

TEST_F(PrepareVerb, OfARealScanWithStraysMakesTheMapOfTheScan) {
  const fs::path data = sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  const Scan bunny = importScan(data / "ply" / "bun_zipper.ply");
  std::mt19937 random(3);
  std::ostringstream text;
  for (const auto& p : bunny.points) {
    text << 1000 * p[0] << ' ' << 1000 * p[1] << ' ' << 1000 * p[2] << '\n';
  }
  std::uniform_real_distribution<float> far(400, 2000);
  for (int i = 0; i < 12; ++i) {
    text << far(random) << ' ' << far(random) << ' ' << far(random) << '\n';
  }
  const std::string scan = write("strays.xyz", text.str());
  const auto report = reportOf(runRelievo(
      {"prepare", scan, "--unit", "mm", "--clean", "-o", path("clean.ply"), "--report", "json"}));
  EXPECT_LE(report["points"], bunny.points.size());
  EXPECT_GE(report["points"], bunny.points.size() * 995 / 1000);
  const auto map = reportOf(runRelievo({"depthmap", path("clean.ply"), "--view", "front", "-o",
                                        path("map.tif"), "--report", "json"}));
  EXPECT_GT(map["cells"][0], 50);
  EXPECT_GT(map["shares"]["measured"], 0.3);
}

}  // namespace
}  // namespace relievo::test
