// SPDX-License-Identifier: BSD-3-Clause
// Measuring, projects and packages from the command line, tried from outside.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/io/formats/text_file.h"
#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "data/generate/relief_f.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::CommandResult;
using test::kReliefF;
using test::reportOf;
using test::runRelievo;
using testing::HasSubstr;
using testing::StartsWith;

using Work = test::CommandTest;

double valueOf(const json& report, const std::string& name, std::size_t quantity = 0) {
  for (const json& m : report["measurements"]) {
    if (m["name"] == name) return m["quantities"].at(quantity)["value"];
  }
  throw std::runtime_error("no measurement " + name);
}

TEST_F(Work, ReliefFMeasuresAsItsClosedForm) {
  const json report = reportOf(runRelievo({"measure",    kReliefF,
                                           "--unit",     "mm",
                                           "--point",    "cap=90,100",
                                           "--point",    "205,80",
                                           "--depth",    "step=199,80,202,80",
                                           "--distance", "base=30.1,100,149.9,100",
                                           "--angle",    "right=20,180,20,160,40,160",
                                           "--area",     "patch=160,90,190,90,190,120,160,120",
                                           "--plane",    "-1",
                                           "--section",  "contour=0,0,1,10",
                                           "--report",   "json"}));
  EXPECT_NEAR(valueOf(report, "cap"), samples::reliefFHeightMm(90, 100), 0.25);
  EXPECT_NEAR(valueOf(report, "point 2"), samples::reliefFHeightMm(205, 80), 1e-4);
  EXPECT_NEAR(valueOf(report, "step"), 5, 1e-4);
  EXPECT_NEAR(valueOf(report, "base"), 119.8, 0.25);
  EXPECT_NEAR(valueOf(report, "right"), 90, 0.1);
  EXPECT_NEAR(valueOf(report, "patch"), 900, 1e-6);
  EXPECT_NEAR(valueOf(report, "patch", 1), 900, 0.5) << "a flat piece, 1 mm above the plane";
  const json& contour = report["measurements"].back();
  ASSERT_EQ(contour["curves"].size(), 1U);
  EXPECT_EQ(contour["plane"], json({0, 0, 1, 10}));
  // A contour of the spherical cap at 10 mm: base radius 60, height 30, so R = 75.
  const double radius = std::sqrt(75.0 * 75.0 - std::pow(75 - 30 + 10, 2));
  EXPECT_NEAR(contour["curves"][0]["length_mm"], 2 * 3.14159265 * radius, 0.25);
  EXPECT_EQ(valueOf(report, "contour"), contour["curves"][0]["length_mm"]);
  for (const json& m : report["measurements"]) {
    for (const json& q : m["quantities"]) EXPECT_GT(q["uncertainty"], 0) << m;
  }
}

TEST_F(Work, AHoleIsSaidToBeNotMeasured) {
  const json report = reportOf(
      runRelievo({"measure", kReliefF, "--unit", "mm", "--point", "150,60", "--report", "json"}));
  EXPECT_EQ(report["measurements"][0]["not_measured"], 1);
  EXPECT_EQ(report["measurements"][0]["points"][0]["origin"], "base plane");
}

TEST_F(Work, MeasurementsAreExportedWithTheirSource) {
  const CommandResult result = runRelievo(
      {"measure", kReliefF, "--unit", "mm", "--profile", "across=10,100,180,100", "-o",
       path("list.csv"), "--profile-csv", path("p.csv"), "--profile-svg", path("p.svg"),
       "--section", "1,0,0,90", "--section-csv", path("s.csv"), "--section-svg", path("s.svg")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("across: length 170"));
  for (const char* file : {"list.csv", "p.csv", "s.csv"}) {
    const auto state = embeddedState(path(file));
    ASSERT_TRUE(state) << file;
    EXPECT_EQ(provenanceFromJson(*state, file).input.sha256, sha256OfFile(kReliefF));
  }
  EXPECT_THAT(readTextFile(path("list.csv"), 1 << 20),
              HasSubstr("\n\"across\",profile,length,170,"));
  EXPECT_THAT(readTextFile(path("p.svg"), 1 << 20), StartsWith("<svg"));
  EXPECT_THAT(readTextFile(path("s.svg"), 1 << 20), HasSubstr("height (mm), true to scale"));
  const CommandResult as_json = runRelievo(
      {"measure", kReliefF, "--unit", "mm", "--point", "90,100", "-o", path("list.json")});
  ASSERT_EQ(as_json.exit_code, 0) << as_json.err;
  const json list = json::parse(readTextFile(path("list.json"), 1 << 20));
  EXPECT_EQ(list["provenance"]["input"]["sha256"], sha256OfFile(kReliefF));
}

TEST_F(Work, WrongMeasurementsAreRefusedWithASentence) {
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
           {},
           {"--point", "1"},
           {"--point", "1,2,3"},
           {"--distance", "1,2"},
           {"--area", "1,2,3,4"},
           {"--profile", "1,2,3,4,5"},
           {"--point", "a=b,c"},
           {"--point", "-5,10"},
           {"--section", "0,0,0,1"},
           {"--section", "0,0,1"},
           {"--section", "0,0,1,999"},
           {"--area", "10,10,50,50,90,90"},
           {"--area", "10,10,50,50,50,10,10,50"},
           {"--point", "90,100", "-o", path("list.xyz")},
           {"--profile", "10,100,180,100", "--profile-csv", path("p.svg")},
           {"--point", "90,100", "--profile-svg", path("p.svg")},
           {"--point", "90,100", "--section-csv", path("s.csv")}}) {
    std::vector<std::string> arguments{"measure", kReliefF, "--unit", "mm"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const CommandResult result = runRelievo(arguments);
    EXPECT_EQ(result.exit_code, 1) << testing::PrintToString(wrong) << result.err;
    EXPECT_NE(result.err, "");
  }
  for (const char* const tie : {"10,10,50,50,50,10,10,50", "10,10,50,50,50,10,10,80"}) {
    EXPECT_THAT(runRelievo({"measure", kReliefF, "--unit", "mm", "--area", tie}).err,
                HasSubstr("crosses itself"));
  }
}

TEST_F(Work, AProjectIsMadeMovedRelinkedPackedAndVerified) {
  fs::create_directories(path("a"));
  fs::copy_file(kReliefF, path("a/f.ply"));
  ASSERT_EQ(runRelievo({"render", path("a/f.ply"), "--unit", "mm", "--pixels", "64", "-o",
                        path("a/fig.png")})
                .exit_code,
            0);
  std::ofstream(path("s.csv")) << "t_s,x_mm,y_mm,z_mm\n0,40,30,9\n0.05,40,30,1\n";
  ASSERT_EQ(runRelievo({"touch", path("a/f.ply"), "--unit", "mm", "--stroke", path("s.csv"), "-o",
                        path("a/log.csv")})
                .exit_code,
            0);
  ASSERT_EQ(runRelievo({"project", "new", path("a/fig.png"), "--recording", path("a/log.csv"), "-o",
                        path("a/p.json")})
                .exit_code,
            0);
  fs::rename(path("a"), path("b"));
  EXPECT_EQ(
      reportOf(runRelievo({"project", "info", path("b/p.json"), "--report", "json"}))["places"],
      json({"fig"}));
  EXPECT_EQ(runRelievo({"project", "check", path("b/p.json")}).exit_code, 0);
  fs::create_directories(path("b/scans"));
  fs::rename(path("b/f.ply"), path("b/scans/renamed.ply"));
  const CommandResult lost = runRelievo({"project", "check", path("b/p.json")});
  EXPECT_EQ(lost.exit_code, 5);
  EXPECT_THAT(lost.err, HasSubstr("E501"));
  EXPECT_EQ(
      runRelievo({"project", "relink", path("b/p.json"), "--search", path("nowhere")}).exit_code,
      5);
  EXPECT_EQ(
      reportOf(runRelievo({"project", "relink", path("b/p.json"), "--report", "json"}))["relinked"],
      1);
  EXPECT_EQ(runRelievo({"project", "check", path("b/p.json")}).exit_code, 0);
  ASSERT_EQ(runRelievo({"project", "package", path("b/p.json"), "--figure", path("b/fig.png"), "-o",
                        path("cite.zip")})
                .exit_code,
            0);
  const CommandResult whole =
      runRelievo({"project", "verify", path("cite.zip"), "--report", "json"});
  EXPECT_EQ(reportOf(whole)["files"], 5);
  std::string bytes = readTextFile(path("cite.zip"), 1U << 28U);
  const std::size_t middle = bytes.size() / 2;
  bytes[middle] = static_cast<char>(bytes[middle] ^ 1);
  std::ofstream(path("bad.zip"), std::ios::binary) << bytes;
  EXPECT_EQ(runRelievo({"project", "verify", path("bad.zip")}).exit_code, 5);
  EXPECT_EQ(runRelievo({"project", "verify", path("b/p.json")}).exit_code, 2);
  EXPECT_EQ(runRelievo({"project", "frobnicate", path("b/p.json")}).exit_code, 1);
}

}  // namespace
}  // namespace relievo
