// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/project.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <regex>
#include <set>

#include "core/base/error.h"
#include "core/provenance/program.h"
#include "core/recording/force_curve.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

class ProjectFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("relievo_project_" + std::to_string(getpid()));
    fs::create_directories(folder_ / "here");
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  fs::path folder_;
};

/// Every field differs from its default.
Project fullProject() {
  Project p;
  p.file = "scans/relief.ply";
  p.sha256 = std::string(64, 'f');
  p.bytes = 4711;
  p.accept_incomplete = true;
  p.options.unit = LengthUnit::cm;
  p.options.unit_source = UnitSource::remembered;
  p.options.view = ViewChoice{"free", Rotation{0, 1, 0, -1, 0, 0, 0, 0, 1}, {1, 2, 3}};
  p.options.spacing_mm = 0.1;
  p.options.engine = "depthbuffer";
  p.options.rule = PointRule::median;
  p.options.strays = StrayRule::keep;
  p.options.nodata = NodataChoice{.value = -9999};
  p.options.raster = {.pixel_mm = 0.05, .height_mm = -0.0002, .zero = 65535};
  p.options.holes = {.rule = HoleRule::interpolate, .max_area_mm2 = 12.5};
  p.options.pyramid.factor = 1.5;
  p.options.pyramid.coarsest_samples = 150;
  p.region = {.x_mm = 1.0 / 3, .y_mm = -2, .side_mm = 44.4, .level = {2}};
  p.gain = 1.7;
  p.look.kind = ReliefKind::openness;
  p.look.colours = ColourMap::cividis;
  p.look.light = {.azimuth_deg = 10, .elevation_deg = 20};
  p.look.radius_mm = 7;
  p.look.range = {{-1, 2}};
  p.look.shading = 0.3;
  p.look.unmeasured = true;
  p.stereo = {.mode = StereoMode::anaglyph,
              .eye_angle_deg = 2.5,
              .zero_plane_mm = 3,
              .swap_eyes = true,
              .automatic_depth = true};
  p.chosen_eye_angle_deg = 9.3;
  p.figures = {"fig.png"};
  p.azimuth_deg = 12;
  p.elevation_deg = -7;
  p.figure.layout = FigureLayout::plot;
  p.figure.width_mm = 85;
  p.figure.dpi = 600;
  p.figure.scale_1_to = 2;
  p.figure.text_pt = 7;
  p.figure.look = p.look;
  p.figure.scale_bar = p.figure.height_bar = p.figure.up_mark = p.figure.window_outline = false;
  p.figure.hatch = p.figure.legend = p.figure.letters = p.figure.measurements = false;
  p.figure.transparent = true;
  p.figure.stereo = StereoPrint::over_under;
  p.figure.eye_angle_deg = 3;
  p.figure.eye = FigureEye::left;
  p.figure.zero_plane_mm = 1;
  p.figure.swap_eyes = true;
  p.figure.limit_parallax = false;
  p.figure.recording = "run.csv";
  p.places = {{"nose", p.region, 2}, {"ear", p.region, 2, viewOf(p)}};
  p.measurements = {{"step", MeasureKind::depth, {{1, 2}, {3, 4}}, 0},
                    {"piece", MeasureKind::area, {{1, 2}, {3, 4}, {5, 6}}, 1.5},
                    {"cut", MeasureKind::section, {}, 7.25, {0.6, 0, 0.8}}};
  p.history = {"Depth map", "Detail 1 \u2192 2"};
  p.undo = {{.before = {"Detail 1 \u2192 2", p.region, 1.5}}};
  return p;
}

TEST(ProjectJson, EveryFieldComesBackBitForBit) {
  const std::string json = projectJson(fullProject());
  const Project back = projectFromJson(json, "test");
  EXPECT_EQ(projectJson(back), json);
  EXPECT_EQ(back.region, fullProject().region);
  EXPECT_EQ(back.look, fullProject().look);
  EXPECT_EQ(viewOf(back), viewOf(fullProject()));
  EXPECT_EQ(back.places, fullProject().places);
  EXPECT_EQ(back.undo, fullProject().undo);
  EXPECT_EQ(back.sha256, fullProject().sha256);
  EXPECT_EQ(back.measurements, fullProject().measurements);
  EXPECT_EQ(back.options.rule, PointRule::median);
  EXPECT_EQ(back.options.strays, StrayRule::keep);
  EXPECT_EQ(back.options.nodata, NodataChoice{.value = -9999});
  EXPECT_EQ(back.options.raster, fullProject().options.raster);
  // Had a field been forgotten, the text of a full project would share a value with a plain one.
  const std::string plain = projectJson(Project{});
  const std::set<std::string> kSame{"\"relievo_project\"", "\"version\"", "\"commit\"", "\"name\"",
                                    "\"cells\""};
  const std::regex line("\"[a-z_0-9]+\": [^{\\[\\n]+");
  for (auto it = std::sregex_iterator(plain.begin(), plain.end(), line);
       it != std::sregex_iterator(); ++it) {
    const std::string field = it->str().substr(0, it->str().find(':'));
    if (kSame.contains(field)) continue;
    EXPECT_EQ(json.find(it->str().back() == ',' ? it->str() : it->str() + "\n"), std::string::npos)
        << it->str() << " is as in an empty project";
  }
}

/// Also what only some projects hold.
Project fullestProject() {
  Project p = fullProject();
  p.version = programVersion();
  p.scan = {.keep_withheld = true, .reader = ReaderChoice::own, .parts = {2, 5}};
  p.picture = PictureChoice{
      .width_px = 300,
      .height_px = 200,
      .scale_bar = true,
      .source = "reference view",
      .background = "#102030",
      .lines = {{{1, 2, 3}, {4, 5, 6}}},
      .hand =
          DrawnHand{.proxy = {1, 2, 3}, .hip = {1, 2, 2}, .force = {0, 0, 1}, .force_limit_n = 8}};
  p.recordings = {{"touch.csv", std::string(64, 'a'), 12}};
  p.paths = {{"path", {{0, viewOf(p)}, {3, viewOf(p)}}}};
  p.saved_as = "elsewhere/p.relievo.json";
  p.others = "{\"later\":{\"deep\":[1,2]}}";
  return p;
}

TEST(ProjectJson, TheWholeValueComesBackEqual) {
  const Project p = fullestProject();
  EXPECT_TRUE(projectFromJson(projectJson(p), "test") == p);
  Project plain;
  plain.version = programVersion();
  plain.file = "a.ply";
  plain.region.side_mm = 1;
  EXPECT_TRUE(projectFromJson(projectJson(plain), "test") == plain);
}

TEST(ProjectJson, NumbersOfAnyBitsComeBackEqual) {
  std::mt19937_64 random(20261123);  // NOLINT(cert-msc51-cpp): the same numbers in every run.
  std::uniform_real_distribution<double> any(-1e3, 1e3), positive(1e-6, 80);
  for (int round = 0; round < 200; ++round) {
    Project p = fullestProject();
    p.region = {any(random), any(random), positive(random), {round % 7}};
    p.gain = positive(random);
    p.look.light = {any(random), positive(random)};
    p.stereo.eye_angle_deg = positive(random);
    p.stereo.zero_plane_mm = any(random);
    p.chosen_eye_angle_deg = positive(random);
    p.azimuth_deg = any(random);
    p.places = {{"p", p.region, p.gain, viewOf(p)}};
    p.measurements = {{"cut", MeasureKind::section, {}, any(random), {any(random), 0, 1}},
                      {"way", MeasureKind::profile, {{any(random), any(random)}, {0, 1}}, 0}};
    p.undo = {{.before = {"Move window", p.region, p.gain}}};
    EXPECT_TRUE(projectFromJson(projectJson(p), "test") == p) << "round " << round;
  }
}

TEST(Project, IsAnotherOneIfAnyFieldIs) {
  const Project full = fullestProject();
  EXPECT_TRUE(full == fullestProject());
  const std::vector<std::function<void(Project&)>> changes{
      [](Project& p) { p.file = "b"; },
      [](Project& p) { p.sha256 = "b"; },
      [](Project& p) { p.bytes = 1; },
      [](Project& p) { p.accept_incomplete = false; },
      [](Project& p) { p.scan.parts = {2}; },
      [](Project& p) { p.options.unit.reset(); },
      [](Project& p) { p.options.unit_source = UnitSource::given; },
      [](Project& p) { p.options.view->turn_deg[2] = 4; },
      [](Project& p) { p.options.view.reset(); },
      [](Project& p) { p.options.cells = 300; },
      [](Project& p) { p.options.spacing_mm = 0.2; },
      [](Project& p) { p.options.engine = "cpu"; },
      [](Project& p) { p.options.rule.reset(); },
      [](Project& p) { p.options.strays = StrayRule::drop; },
      [](Project& p) { p.options.nodata.reset(); },
      [](Project& p) { p.options.holes.max_area_mm2 = 1; },
      [](Project& p) { p.options.pyramid.factor = 2; },
      [](Project& p) { p.region.x_mm = std::nextafter(p.region.x_mm, 1.0); },
      [](Project& p) { p.gain = 1; },
      [](Project& p) { p.look.light.azimuth_deg = 11; },
      [](Project& p) { p.stereo.swap_eyes = false; },
      [](Project& p) { p.chosen_eye_angle_deg.reset(); },
      [](Project& p) { p.azimuth_deg = 13; },
      [](Project& p) { p.elevation_deg = 0; },
      [](Project& p) { p.picture->width_px = 301; },
      [](Project& p) { p.figure.dpi = 300; },
      [](Project& p) { p.places[1].view->gain = 3; },
      [](Project& p) { p.measurements[2].normal.x = 0.5; },
      [](Project& p) { p.recordings.clear(); },
      [](Project& p) { p.figures = {"other.png"}; },
      [](Project& p) { p.paths[0].keys[1].t_s = 4; },
      [](Project& p) { p.history.pop_back(); },
      [](Project& p) { p.undo[0].before.gain = 1; },
      [](Project& p) { p.version = "0"; },
      [](Project& p) { p.made = "{}"; },
      [](Project& p) { p.saved_as.clear(); },
      [](Project& p) { p.others.clear(); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Project changed = full;
    changes[i](changed);
    EXPECT_FALSE(changed == full) << "change " << i;
  }
  Project threads = full;
  threads.options.pyramid.threads = 3;
  EXPECT_TRUE(threads == full) << "the result is the same for every number of them";
}

TEST(Project, WorkIsWhatCostSomebodyWork) {
  Project p = fullestProject();
  const Project work = workIn(p, false);
  p.region.x_mm += 1;
  p.azimuth_deg = 50;
  p.recordings.clear();
  p.look.kind = ReliefKind::slope;
  EXPECT_TRUE(workIn(p, false) == work) << "to look about is no work";
  p.places.pop_back();
  EXPECT_FALSE(workIn(p, false) == work);
}

TEST(Project, OfAProjectFileTheLookIsWorkAndADrawnEyeAngleIsNot) {
  Project p = fullestProject();
  p.stereo.automatic_depth = false;
  const Project work = workIn(p, true);
  p.stereo.eye_angle_deg = 1;
  EXPECT_TRUE(workIn(p, true) == work) << "the view draws less than was chosen";
  p.chosen_eye_angle_deg = 10;
  EXPECT_FALSE(workIn(p, true) == work);
  p = fullestProject();
  p.look.kind = ReliefKind::slope;
  EXPECT_FALSE(workIn(p, true) == workIn(fullestProject(), true));
}

TEST(ProjectJson, OfAnOlderVersionKeepsStraysAndTheEarlierChoiceOfView) {
  Project p = fullProject();
  p.options.strays = StrayRule::drop;
  p.options.view.reset();
  const Project now = projectFromJson(projectJson(p), "p.json");
  EXPECT_EQ(now.options.strays, StrayRule::drop);
  EXPECT_FALSE(now.options.view.has_value());
  std::string older = projectJson(p);
  const std::size_t at = older.find("\"strays\": \"drop\",");
  ASSERT_NE(at, std::string::npos);
  older.erase(at, std::string("\"strays\": \"drop\",").size());
  const Project back = projectFromJson(older, "p.json");
  EXPECT_EQ(back.options.strays, StrayRule::keep);
  ASSERT_TRUE(back.options.view.has_value());
  EXPECT_EQ(back.options.view->name, kEarlierAutomatic);
}

TEST(ProjectJson, KeysOfALaterVersionAreKept) {
  std::string json = projectJson(fullProject());
  json.insert(json.find("\"input\""), "\"smell\": {\"of\": [1, 2]}, ");
  const Project back = projectFromJson(json, "test");
  EXPECT_NE(projectJson(back).find("smell"), std::string::npos);
}

TEST(ProjectJson, WhatIsNoProjectIsRefusedWithItsName) {
  std::string newer = projectJson(fullProject());
  newer.replace(newer.find("\"relievo_project\": 2"), 20, "\"relievo_project\": 9");
  std::string odd = projectJson(fullProject());
  odd.replace(odd.find("\"kind\": \"openness\""), 18, "\"kind\": \"tin\"");
  std::string wrong = projectJson(fullProject());
  wrong.replace(wrong.find("\"gain\": 1.7"), 11, "\"gain\": \"x\"");
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("{\"a\":1}"),
        std::string("{\"relievo_project\": 1}"), newer, odd, wrong, std::string(100000, '[')}) {
    try {
      projectFromJson(text, "odd.json");
      ADD_FAILURE() << text.substr(0, 60);
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("odd.json"), std::string::npos);
    }
  }
}

TEST_F(ProjectFile, AProjectMovedTogetherWithItsScanStillFindsIt) {
  Project p = fullProject();
  p.file = (folder_ / "here" / "relief.ply").string();
  writeProject(folder_ / "here" / "a.relievo.json", p);
  fs::rename(folder_ / "here", folder_ / "there");
  const Project back = readProject(folder_ / "there" / "a.relievo.json");
  EXPECT_EQ(back.file, (folder_ / "there" / "relief.ply").string());
  EXPECT_THROW(writeProject(folder_ / "missing" / "a.json", p), WriteError);
  EXPECT_THROW(readProject(folder_ / "missing.json"), FileError);
}

TEST_F(ProjectFile, AForceCurveIsReadByItsColumnsNames) {
  const fs::path good = write("good.csv",
                              "# header\nt_s,event,hip_z_mm,proxy_z_mm,f_x_N,f_y_N,f_z_N\n"
                              "0,\"a, b\",1,2,0,3,4\n0.001,,1.5,2,0,0,0\n");
  const auto rows = readForceCurve(good);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].force_n, 5);
  EXPECT_EQ(rows[1].hip_z_mm, 1.5);
  EXPECT_THROW(readForceCurve(write("none.csv", "t_s,hip_z_mm\n")), FileError);
  EXPECT_THROW(
      readForceCurve(write("bad.csv", "t_s,hip_z_mm,proxy_z_mm,f_x_N,f_y_N,f_z_N\n0,x,1,1,1,1\n")),
      FileError);
  EXPECT_THROW(readForceCurve(write("empty.csv", "t_s,hip_z_mm,proxy_z_mm,f_x_N,f_y_N,f_z_N\n")),
               FileError);
  EXPECT_THROW(readForceCurve(folder_ / "missing.csv"), FileError);
}

TEST(FigureRequest, NumbersBeyondTheirLimitsAndChoicesThatExcludeEachOtherAreRefused) {
  EXPECT_NO_THROW(check(FigureRequest{}));
  FigureRequest f;
  f.dpi = 5;
  EXPECT_THROW(check(f), ArgumentError);
  f = {};
  f.transparent = true;
  f.stereo = StereoPrint::dubois;
  EXPECT_THROW(check(f), ArgumentError);
  f = {};
  f.stereo = StereoPrint::side_by_side;
  EXPECT_THROW(check(f), ArgumentError);
  f.layout = FigureLayout::detail;
  EXPECT_NO_THROW(check(f));
  f = {};
  f.layout = FigureLayout::plot;
  EXPECT_THROW(check(f), ArgumentError);
}

}  // namespace
}  // namespace relievo
