// SPDX-License-Identifier: BSD-3-Clause
// The command line's contract, tried from outside: the built program, its files and its reports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/io/raster/raster.h"
#include "data/generate/relief_f.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::CommandResult;
using test::kReliefF;
using test::reportOf;
using test::runRelievo;
using testing::HasSubstr;

using Batch = test::CommandTest;

TEST_F(Batch, InfoTellsWhatAFileHolds) {
  const CommandResult result = runRelievo({"info", plane(), "--report", "json"});
  const json info = reportOf(result);
  EXPECT_EQ(info["points"], 10201);
  EXPECT_EQ(info["finite_points"], 10201);
  EXPECT_EQ(info["faces"], 0);
  EXPECT_EQ(info["bounds"]["min"], json({0, 0, 5}));
  EXPECT_EQ(info["bounds"]["max"], json({100, 100, 15}));
  EXPECT_EQ(info["unit"], "mm");
  EXPECT_EQ(info["unit_source"], "assumed");
  EXPECT_EQ(info["size_mm"], json({100, 100, 10}));
  EXPECT_EQ(info["likely_unit"], "mm");
  EXPECT_THAT(result.err, HasSubstr("unit"));
}

TEST_F(Batch, InfoTellsTheBoxWithoutHeightsThatStandForNone) {
  EXPECT_EQ(reportOf(runRelievo({"info", plane(), "--report", "json"}))["bounds_in_use"]["min"],
            json({0, 0, 5}));
  std::ofstream file(path("holed.xyz"));
  std::ofstream grid(path("holed.asc"));
  grid << "ncols 40\nnrows 30\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 1200; ++i) {
    const int z = i % 7 == 0 ? -9999 : 200 + i % 61;
    file << i % 40 << ' ' << i / 40 << ' ' << z << '\n';
    grid << z << (i % 40 == 39 ? '\n' : ' ');
  }
  file.close();
  grid.close();
  for (const char* name : {"holed.xyz", "holed.asc"}) {
    const CommandResult result = runRelievo({"info", path(name), "--report", "json"});
    const json info = reportOf(result);
    EXPECT_EQ(info["bounds"]["min"][2], -9999) << name;
    EXPECT_EQ(info["bounds_in_use"]["min"][2], 200) << name;
    EXPECT_EQ(info["bounds_in_use"]["max"], info["bounds"]["max"]) << name;
  }
  EXPECT_THAT(runRelievo({"info", path("holed.xyz")}).out,
              HasSubstr("without what is left out from [0.0,0.0,200.0] to"));
}

TEST_F(Batch, LimitsOfTheSystemAreNamedAsTheCause) {
  const auto said = [this](const std::string& before, const std::string& scan) {
    const std::string command = before + " '" RELIEVO_BINARY_DIR "/bin/relievo' info '" + scan +
                                "' > '" + path("out") + "' 2> '" + path("err") + "'";
    EXPECT_NE(std::system(("bash -c \"" + command + "\"").c_str()), 0) << before;
    return test::bytesOf(path("err"));
  };
  // A text is read by ourselves, a PLY by PCL through a file in memory.
  for (const std::string& scan :
       {plane(), std::string(RELIEVO_SOURCE_DIR "/data/samples/panel.ply")}) {
    EXPECT_THAT(said("ulimit -f 10;", scan), HasSubstr("no more than 10 kB here (ulimit -f)"));
  }
  EXPECT_THAT(said("ulimit -n 16;", plane()),
              HasSubstr("no more than 16 files may be open at once"));
  if (std::system("unshare -rm mount -t tmpfs none /proc 2> /dev/null") != 0) {
    GTEST_SKIP() << "no /proc to take away: namespaces are not allowed";
  }
  EXPECT_THAT(
      said("exec unshare -rm sh -c 'mount -t tmpfs none /proc && exec \\\"\\$@\\\"' sh", plane()),
      HasSubstr("/proc, by which relievo finds its own programs, is not there"));
}

TEST_F(Batch, AGivenUnitIsUsedAndNotWarnedAbout) {
  const CommandResult result = runRelievo({"info", plane(), "--unit", "us-ft", "--report", "json"});
  const json info = reportOf(result);
  EXPECT_EQ(info["unit"], "us-ft");
  EXPECT_EQ(info["unit_source"], "given");
  EXPECT_NEAR(info["size_mm"][0].get<double>(), 100 * 1200.0 / 3937 * 1000, 1e-6);
  EXPECT_EQ(info["likely_unit"], nullptr);
  EXPECT_EQ(result.err, "");
}

TEST_F(Batch, WrongUseIsExitOneWithOneSentence) {
  const std::string file = plane();
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"info"},
           {"info", file, "--unit", "furlong"},
           {"depthmap", file},
           {"depthmap", file, "-o", path("m.tif"), "--cells", "1"},
           {"depthmap", file, "-o", path("m.tif"), "--cells", "9", "--spacing", "2"},
           {"depthmap", file, "-o", path("m.tif"), "--view", "sideways"},
           {"depthmap", file, "-o", path("m.tif"), "--holes", "interpolate:few"},
           {"render", file, "-o", path("f.png"), "--region", "1,2,3"},
           {"render", file, "-o", path("f.png"), "--level", "7"},
           {"frobnicate-not-a-verb", "--report", "json"}}) {
    const CommandResult result = runRelievo(arguments);
    EXPECT_EQ(result.exit_code, 1) << testing::PrintToString(arguments) << result.err;
    EXPECT_NE(result.err, "");
    EXPECT_EQ(result.out, "");
  }
}

TEST_F(Batch, UnreadableFilesAreExitTwoAndUnwritableOnesExitThree) {
  EXPECT_EQ(runRelievo({"info", path("missing.ply")}).exit_code, 2);
  EXPECT_EQ(runRelievo({"info", folder_.path().string()}).exit_code, 2);
  EXPECT_EQ(runRelievo({"info", write("empty.ply", "")}).exit_code, 2);
  const CommandResult result =
      runRelievo({"depthmap", plane(), "-o", path("no/such/folder/map.tif")});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("map.tif"));
}

TEST_F(Batch, DepthmapOfReliefFIsItsClosedForm) {
  const std::string map_file = path("f.tif");
  const json report = reportOf(
      runRelievo({"depthmap", kReliefF, "--unit", "mm", "-o", map_file, "--report", "json"}));
  EXPECT_EQ(report["cells"], json({1200, 800}));
  EXPECT_DOUBLE_EQ(report["spacing_mm"], 0.25);
  EXPECT_EQ(report["engine"], "cpu");
  double sum = 0;
  for (const auto& share : report["shares"]) sum += share.get<double>();
  EXPECT_NEAR(sum, 1, 1e-12);
  const RasterMap map = readRaster(map_file);
  ASSERT_TRUE(map.is_own_map);
  double worst = 0;
  for (int row = 0; row < 800; row += 3) {
    for (int col = 0; col < 1200; col += 3) {
      const double x = 0.125 + 0.25 * col;
      const double y = 0.125 + 0.25 * row;
      const std::size_t i = map.size.index({.col = col, .row = row});
      ASSERT_EQ(map.valid[i], !samples::isOutside(x, y));
      if (samples::isOutside(x, y)) continue;
      const double truth = samples::isHole(x, y) ? 0 : samples::reliefFHeightMm(x, y);
      worst = std::max(worst, std::abs(static_cast<double>(map.values[i]) - truth));
    }
  }
  EXPECT_LT(worst, 5e-6);
}

TEST_F(Batch, TheSameMapComesBackFromItsFile) {
  const std::string first = path("first.tif");
  const std::string second = path("second.tif");
  reportOf(runRelievo({"depthmap", plane(), "-o", first, "--report", "json"}));
  reportOf(runRelievo({"depthmap", first, "-o", second, "--report", "json"}));
  const RasterMap a = readRaster(first);
  const RasterMap b = readRaster(second);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.origins, b.origins);
  EXPECT_EQ(a.view_from_file, b.view_from_file);
}

TEST_F(Batch, ConvertWritesTheMapForOtherProgramsAndItReopensToTheSameHeights) {
  const std::string map = path("map.tif");
  reportOf(runRelievo({"depthmap", kReliefF, "-o", map, "--cells", "120", "--report", "json"}));
  const RasterMap wanted = readRaster(map);
  for (const char* const name : {"out.tif", "out.asc"}) {
    const json report = reportOf(runRelievo({"convert", map, path(name), "--report", "json"}));
    EXPECT_EQ(report["frame"], "view");
    const RasterMap back = readRaster(path(name));
    EXPECT_EQ(back.valid, wanted.valid) << name;
    for (std::size_t i = 0; i < back.values.size(); ++i) {
      if (wanted.valid[i]) {
        ASSERT_EQ(back.values[i], wanted.values[i]) << name << " " << i;
      }
    }
  }
  for (const char* const name : {"out.ply", "out.xyz", "out.stl", "out.vti"}) {
    EXPECT_EQ(runRelievo({"convert", map, path(name)}).exit_code, 0);
    EXPECT_GT(std::filesystem::file_size(path(name)), 10'000U) << name;
  }
  const json mesh = reportOf(runRelievo({"info", path("out.ply"), "--report", "json"}));
  EXPECT_EQ(mesh["points"], wanted.info.finite_points);
}

TEST_F(Batch, ConvertGivesAnElevationModelBackInItsOwnCoordinates) {
  const std::string dem = write("dem.asc",
                                "ncols 3\nnrows 2\nxllcorner 512022.5\nyllcorner 5403117\n"
                                "cellsize 0.5\nNODATA_value -1\n250.1 250.2 250.3\n251 -1 252.7\n");
  const json report = reportOf(runRelievo({"convert", dem, path("out.tif"), "--report", "json"}));
  EXPECT_EQ(report["frame"], "file");
  const RasterMap before = readRaster(dem);
  const RasterMap after = readRaster(path("out.tif"));
  EXPECT_EQ(after.first.x, before.first.x);
  EXPECT_EQ(after.first.y, before.first.y);
  EXPECT_EQ(after.pixel, before.pixel);
  for (std::size_t i = 0; i < 6; ++i) {
    if (before.valid[i]) {
      EXPECT_EQ(after.values[i], before.values[i]);
    }
  }
  const CommandResult sideways =
      runRelievo({"convert", kReliefF, path("x.tif"), "--frame", "file", "--view", "left"});
  EXPECT_EQ(sideways.exit_code, 1);
  EXPECT_THAT(sideways.err, HasSubstr("--view top"));
  EXPECT_EQ(runRelievo({"convert", dem, path("x.docx")}).exit_code, 1);
  EXPECT_EQ(runRelievo({"convert", dem, path("no/x.vti")}).exit_code, 3);
}

TEST_F(Batch, FillTreatsHolesAnewAndSaysWhatItCouldNotDo) {
  // A plane z = x of 21 x 21 cells with a hole of 3 x 3 and one of 1.
  std::ostringstream grid;
  grid << "ncols 21\nnrows 21\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n";
  for (int row = 0; row < 21; ++row) {
    for (int col = 0; col < 21; ++col) {
      const bool large = row >= 9 && row <= 11 && col >= 9 && col <= 11;
      const bool small = row == 4 && col == 4;
      grid << (large || small ? "-9" : std::to_string(col) + ".0") << ' ';
    }
    grid << '\n';
  }
  const std::string map = path("map.tif");
  reportOf(runRelievo({"depthmap", write("plane.asc", grid.str()), "-o", map, "--report", "json"}));

  const CommandResult partly = runRelievo(
      {"fill", map, "-o", path("partly.tif"), "--holes", "interpolate:2", "--report", "json"});
  EXPECT_EQ(partly.exit_code, 4);
  EXPECT_THAT(partly.err, HasSubstr("1 of 2 holes"));
  EXPECT_EQ(json::parse(partly.out)["filled"], 1);

  const json report = reportOf(runRelievo(
      {"fill", map, "-o", path("full.tif"), "--holes", "interpolate:100", "--report", "json"}));
  EXPECT_EQ(report["filled"], 2);
  const RasterMap before = readRaster(map);
  const RasterMap after = readRaster(path("full.tif"));
  for (std::size_t i = 0; i < after.values.size(); ++i) {
    if (before.origins[i] == CellStatus::measured) {
      ASSERT_EQ(after.values[i], before.values[i]);
    } else {
      EXPECT_EQ(after.origins[i], CellStatus::interpolated);
      EXPECT_NEAR(after.values[i], static_cast<double>(i % 21), 0.6);
    }
  }
}

TEST_F(Batch, PyramidWritesEveryLevel) {
  const json report = reportOf(runRelievo({"pyramid", kReliefF, "--unit", "mm", "-o", path("p.tif"),
                                           "--factor", "2", "--report", "json"}));
  ASSERT_EQ(report["levels"].size(), 4U);
  EXPECT_EQ(report["levels"][3]["cells"], json({150, 100}));
  EXPECT_DOUBLE_EQ(report["levels"][3]["spacing_mm"], 2);
  const RasterMap level = readRaster(path("p.L3.tif"));
  EXPECT_DOUBLE_EQ(level.pixel, 2);
  EXPECT_DOUBLE_EQ(level.first.x, 0.125);
}

TEST_F(Batch, DepthmapTakesAPointRuleAndSaysWhichWasUsed) {
  const std::string cloud = write("rule.xyz", "0 0 1\n0 0 2\n0 0 6\n10 0 0\n0 10 0\n10 10 0\n");
  const auto rule_and_highest = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"depthmap", cloud,         "--unit",   "mm",
                                       "--view",   "top",         "--cells",  "2",
                                       "-o",       path("r.tif"), "--report", "json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const json report = reportOf(runRelievo(arguments));
    return std::pair{report["rule"].get<std::string>(), report["height_mm"]["max"].get<double>()};
  };
  using Said = std::pair<std::string, double>;
  EXPECT_EQ(rule_and_highest({}), Said("1.5 points per cell: local quadratic", 3));
  EXPECT_EQ(rule_and_highest({"--rule", "median"}), Said("as chosen: median of the points", 2));
  EXPECT_EQ(rule_and_highest({"--rule", "mean"}), Said("as chosen: mean of the points", 3));
  EXPECT_EQ(rule_and_highest({"--rule", "second"}),
            Said("as chosen: second point from the front", 2));
  const CommandResult wrong =
      runRelievo({"depthmap", cloud, "-o", path("r.tif"), "--rule", "highest"});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.err, HasSubstr("--rule"));
}

TEST_F(Batch, DepthmapFillsHolesAsAskedAndEndsWithFourWhereItCannot) {
  std::string text;
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 20; ++i) {
      if (std::abs(i - 9) < 3 && std::abs(j - 9) < 3) continue;
      text += std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(i + 2 * j) + "\n";
    }
  }
  const std::string cloud = write("hole.xyz", text);
  const auto run = [&](const std::string& holes) {
    return runRelievo({"depthmap", cloud, "--unit", "mm", "--view", "top", "--cells", "20",
                       "--holes", holes, "-o", path("h.tif"), "--report", "json", "--quality"});
  };
  const CommandResult left = run("interpolate:1");
  EXPECT_EQ(left.exit_code, 4);
  EXPECT_THAT(left.err, HasSubstr("0 of 1 holes filled. The largest left (25 mm2)"));
  EXPECT_EQ(json::parse(left.out)["not_done"].size(), 1U);
  const CommandResult filled = run("membrane");
  EXPECT_EQ(filled.exit_code, 0) << filled.err;
  const json report = json::parse(filled.out);
  EXPECT_EQ(report["holes"][0]["filled"], true);
  EXPECT_DOUBLE_EQ(report["shares"]["hole"], 0);
  EXPECT_EQ(report["losses"]["flyers"], 0);
  EXPECT_DOUBLE_EQ(report["quality"]["mean_points"], 1);
  const RasterMap map = readRaster(path("h.tif"));
  EXPECT_NEAR(map.values[9 * 20 + 9] - map.values[0], 27, 1e-3) << "a plane goes on through it";
  const RasterMap counts = readRaster(path("h.count.tif"));
  EXPECT_EQ(counts.values[0], 1);
  EXPECT_FALSE(counts.valid[9 * 20 + 9]);
  EXPECT_FALSE(counts.is_own_map);
  EXPECT_TRUE(readRaster(path("h.spread.tif")).is_own_map);
  EXPECT_EQ(run("membrane:few").exit_code, 1);
}

TEST_F(Batch, DepthmapTurnsAViewByDegrees) {
  const json report =
      reportOf(runRelievo({"depthmap", plane(), "--unit", "mm", "--view", "top", "--turn", "0,0,90",
                           "-o", path("t.tif"), "--report", "json"}));
  EXPECT_EQ(report["view"], "top + 0, 0, 90 degrees");
  EXPECT_NEAR(report["view_from_file"][1], -1, 1e-12);
  EXPECT_EQ(runRelievo({"depthmap", plane(), "--turn", "1,2", "-o", path("t.tif")}).exit_code, 1);
}

TEST_F(Batch, PyramidTakesAnyFactorAndSaysWhatPassesAtItsLimit) {
  for (const char* factor : {"1.5", "1.41421356", "3"}) {
    const json report =
        reportOf(runRelievo({"pyramid", kReliefF, "--unit", "mm", "-o", path("p.tif"), "--factor",
                             factor, "--report", "json"}));
    const double m = std::stod(factor);
    EXPECT_DOUBLE_EQ(report["factor"], m);
    EXPECT_LE(report["gain_at_nyquist"], 0.3);
    EXPECT_GT(report["gain_at_nyquist"], 0.1);
    EXPECT_DOUBLE_EQ(report["levels"][1]["spacing_mm"], 0.25 * m);
    EXPECT_DOUBLE_EQ(readRaster(path("p.L1.tif")).pixel, 0.25 * m);
  }
}

TEST_F(Batch, PyramidRefusesAFactorThatIsNone) {
  for (const char* factor : {"1", "8.5", "nan", "-2"}) {
    const CommandResult result = runRelievo({"pyramid", kReliefF, "--unit", "mm", "-o",
                                             path("p.tif"), std::string("--factor=") + factor});
    EXPECT_EQ(result.exit_code, 1) << factor;
    EXPECT_THAT(result.err, HasSubstr("--factor"));
  }
}

TEST_F(Batch, RenderDrawsExactlyTheRegionWithOrWithoutADisplay) {
  const std::vector<std::string> arguments{"render",   plane(),       "--unit",   "mm",
                                           "--region", "10,20,40,30", "--pixels", "200",
                                           "-o",       path("f.png"), "--report", "json"};
  const json report = reportOf(runRelievo(arguments));
  EXPECT_EQ(report["pixels"], json({200, 200}));
  EXPECT_EQ(report["region_mm"], json({10, 15, 40, 40}));
  EXPECT_DOUBLE_EQ(report["mm_per_pixel"], 0.2);
  const std::string first = test::bytesOf(path("f.png"));
  EXPECT_EQ(first.substr(1, 3), "PNG");
  EXPECT_EQ(reportOf(runRelievo(arguments, {"DISPLAY"})), report);
  EXPECT_EQ(first, test::bytesOf(path("f.png"))) << "the same pixels whatever the display";
}

TEST_F(Batch, TheDepthBufferGivesTheSameMapOfAMesh) {
  const std::string mesh =
      write("mesh.obj", "v 0 0 0\nv 10 0 1\nv 10 10 3\nv 0 10 2\nf 1 2 3\nf 1 3 4\n");
  for (const char* engine : {"cpu", "depthbuffer"}) {
    const json report = reportOf(
        runRelievo({"depthmap", mesh, "--unit", "mm", "--view", "top", "--cells", "101", "--engine",
                    engine, "-o", path(std::string(engine) + ".tif"), "--report", "json"}));
    EXPECT_EQ(report["engine"], engine);
    const json& buffer = report["depth_buffer"];
    EXPECT_EQ(buffer.is_null(), report["engine"] == "cpu");
    if (buffer.is_null()) continue;
    EXPECT_GE(buffer["bits"], 16);
    EXPECT_NEAR(buffer["near_mm"].get<double>() - buffer["far_mm"].get<double>(), 3, 1e-3);
    EXPECT_GT(buffer["step_mm"], 0);
    EXPECT_LT(buffer["accuracy_mm"], 1e-3);
  }
  const RasterMap cpu = readRaster(path("cpu.tif"));
  const RasterMap gl = readRaster(path("depthbuffer.tif"));
  // The base plane is a quantile of what was hit, and edges differ: compare the inner cells' shape.
  const auto at = [](const RasterMap& map, int col, int row) {
    return static_cast<double>(map.values[map.size.index({.col = col, .row = row})]);
  };
  const double shift = at(gl, 50, 50) - at(cpu, 50, 50);
  for (int row = 3; row < 98; ++row) {
    for (int col = 3; col < 98; ++col) {
      ASSERT_NEAR(at(gl, col, row) - shift, at(cpu, col, row), 2e-5 * 3);
    }
  }
}

TEST_F(Batch, ReadsNumbersUnderACommaLocaleToo) {
  const json report = reportOf(runRelievo({"info", plane(), "--report", "json"},
                                          {"LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8"}));
  EXPECT_EQ(report["bounds"]["max"], json({100, 100, 15}));
}

}  // namespace
}  // namespace relievo
