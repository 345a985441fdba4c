// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/provenance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/raster/raster.h"
#include "core/provenance/embedded.h"
#include "core/provenance/program.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

using testing::HasSubstr;

Provenance fullRecord() {
  Provenance p;
  p.version = "1.2.3";
  p.commit = "0123456789abcdef0123456789abcdef01234567";
  p.input = {.file = "../scans/M\u00fcnze \"1\".ply", .sha256 = sha256OfText("x"), .bytes = 1};
  p.files = {{.file = "../scans/a.las", .sha256 = sha256OfText("y"), .bytes = 2},
             {.file = "../scans/b.las", .sha256 = sha256OfText("z"), .bytes = 3}};
  p.accept_incomplete = true;
  p.options.unit = LengthUnit::us_ft;
  p.options.unit_source = UnitSource::remembered;
  p.options.view = ViewChoice{
      .name = "free", .rotation = Rotation{0, 1, 0, -1, 0, 0, 0, 0, 1}, .turn_deg = {1, 2, 0.1}};
  p.options.spacing_mm = 0.1 + 0.2;
  p.options.engine = "depthbuffer";
  p.options.rule = PointRule::median;
  p.options.holes = {.rule = HoleRule::interpolate, .max_area_mm2 = 12.5};
  p.options.pyramid.factor = std::sqrt(2.0);
  p.view = ViewState{
      .region = {.x_mm = 1 / 3.0, .y_mm = -2, .side_mm = 1e-3, .level = Level{2}},
      .gain = 1.7,
      .look = {.kind = ReliefKind::openness,
               .colours = ColourMap::cividis,
               .light = {.azimuth_deg = 12, .elevation_deg = 33},
               .radius_mm = 4,
               .range = std::array{-1.0, 2.0},
               .shading = 0.75},
      .stereo = {.mode = StereoMode::anaglyph, .eye_angle_deg = 3.3, .zero_plane_mm = 0.25},
      .azimuth_deg = 10,
      .elevation_deg = -20};
  p.picture = PictureChoice{.width_px = 640,
                            .height_px = 480,
                            .scale_bar = true,
                            .source = "reference view",
                            .background = "#23262a",
                            .lines = {{{1, 2, 3}, {4, 5, 6}}, {}},
                            .hand = DrawnHand{{1, 2, 3}, {4, 5, 6}, {0, 0.5, 1}, 2, true, true, 3}};
  p.touch = R"({"proxy":"converged"})";
  p.made = R"({"cells":[3,4]})";
  p.figure = R"({"dpi":300})";
  return p;
}

TEST(Provenance, ComesBackFromItsTextBitByBit) {
  const Provenance before = fullRecord();
  for (const int indent : {-1, 2}) {
    const std::string text = toJson(before, indent);
    const Provenance after = provenanceFromJson(text, "fig.png");
    EXPECT_EQ(toJson(after, indent), text);
    EXPECT_EQ(after.version, before.version);
    EXPECT_EQ(after.input, before.input);
    EXPECT_EQ(after.files, before.files);
    EXPECT_EQ(after.options.spacing_mm, before.options.spacing_mm);
    EXPECT_EQ(after.options.unit, LengthUnit::us_ft);
    EXPECT_EQ(after.options.unit_source, UnitSource::remembered);
    EXPECT_EQ(after.options.view->rotation, before.options.view->rotation);
    EXPECT_EQ(after.options.view->turn_deg, before.options.view->turn_deg);
    EXPECT_EQ(after.options.rule, PointRule::median);
    EXPECT_EQ(after.options.holes.max_area_mm2, 12.5);
    EXPECT_EQ(after.options.pyramid.factor, std::sqrt(2.0));
    EXPECT_EQ(after.view, before.view);
    EXPECT_EQ(after.picture, before.picture);
    EXPECT_EQ(after.touch, before.touch);
    EXPECT_EQ(after.figure, before.figure);
    EXPECT_TRUE(after.accept_incomplete);
  }
}

TEST(Provenance, IsAsciiAndOneLineIfAsked) {
  const std::string text = toJson(fullRecord(), -1);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  for (const char c : text) EXPECT_TRUE(c >= ' ' && c < 0x7f) << static_cast<int>(c);
}

TEST(Provenance, NoLimitOfAreaIsNoNumber) {
  Provenance p = fullRecord();
  p.options.holes.max_area_mm2 = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isinf(provenanceFromJson(toJson(p), "x").options.holes.max_area_mm2));
}

void expectRefused(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  EXPECT_THROW(
      {
        try {
          provenanceFromJson(text, "fig.png");
        } catch (const FileError& error) {
          EXPECT_THAT(error.what(), HasSubstr("fig.png"));
          throw;
        }
      },
      FileError)
      << from << " -> " << to;
}

TEST(Provenance, WhatMakesNoSenseIsRefusedWithASentence) {
  const std::string text = toJson(fullRecord(), -1);
  expectRefused(text, "\"relievo_provenance\":1", "\"relievo_provenance\":2");
  expectRefused(text, "\"relievo_provenance\":1", "\"something\":1");
  expectRefused(text, "\"engine\":\"depthbuffer\"", "\"engine\":\"magic\"");
  expectRefused(text, "\"engine\":\"depthbuffer\"", "\"engine\":7");
  expectRefused(text, "\"unit\":\"us-ft\"", "\"unit\":\"furlong\"");
  expectRefused(text, "\"rule\":\"median\"", "\"rule\":\"best\"");
  expectRefused(text, "\"gain\":1.7", "\"gain\":0");
  expectRefused(text, "\"gain\":1.7", "\"gain\":1e999");
  expectRefused(text, "\"gain\":1.7", "\"gain\":\"1.7\"");
  expectRefused(text, "\"level\":2", "\"level\":-1");
  expectRefused(text, "\"level\":2", "\"level\":2.5");
  expectRefused(text, "\"pixels\":[640,480]", "\"pixels\":[640]");
  expectRefused(text, "\"pixels\":[640,480]", "\"pixels\":[640,2000000000]");
  expectRefused(text, "\"range\":[-1.0,2.0]", "\"range\":[-1.0]");
  expectRefused(text, "\"touch\":{", "\"touch\":[],\"x\":{");
  expectRefused(text, sha256OfText("x"), "abc");
  expectRefused(text, "}}", "}");
  expectRefused("", "", "");
  expectRefused("", "", std::string(100'000, '['));
  expectRefused(text, "{\"cells\":[3,4]}",
                "{\"a\":" + std::string(5000, '[') + std::string(5000, ']') + "}");
}

TEST(Provenance, NamesTheProgramsCommit) {
  const std::string commit(programCommit());
  const std::string digits = commit.substr(0, commit.find('-'));
  EXPECT_TRUE(commit == "unknown" || digits.size() == 40U) << commit;
  EXPECT_FALSE(programVersion().empty());
}

TEST(ViewText, ComesBackAndNonsenseIsRefused) {
  const ViewState view = *fullRecord().view;
  EXPECT_EQ(viewFromText(toText(view)), view);
  EXPECT_THROW(viewFromText("have a look"), ArgumentError);
  EXPECT_THROW(viewFromText("{}"), ArgumentError);
  EXPECT_THROW(viewFromText("[1]"), ArgumentError);
}

TEST(Resolved, OptionsMakeTheSameMapAgain) {
  const Scan scan =
      test::latticeScan(61, 41, 0.7, [](double x, double y) { return std::sin(x) * std::cos(y); });
  const SurfaceOptions asked;
  const Surface first = makeSurface(scan, asked, rasterize);
  const SurfaceOptions options = resolved(asked, first);
  EXPECT_TRUE(options.unit && options.view && options.spacing_mm);
  const Surface second = makeSurface(scan, options, rasterize);
  EXPECT_EQ(second.map.frame, first.map.frame);
  EXPECT_EQ(second.map.heights_mm, first.map.heights_mm);
  EXPECT_EQ(second.unit_source, UnitSource::assumed);
}

TEST(Embedded, StateComesBackFromTiffAndCsvAndIsMissedElsewhere) {
  const test::TemporaryFolder folder;
  const std::string json = toJson(fullRecord(), -1);
  DepthMap map;
  map.frame = {
      .size = {.cols = 3, .rows = 2}, .spacing_mm = 1, .first_x_mm = 0.5, .first_y_mm = 0.5};
  map.heights_mm.assign(6, 1.5F);
  map.origins.assign(6, CellStatus::measured);
  writeMap(folder.path() / "map.tif", map, {.view_from_file = {}, .state = json});
  EXPECT_EQ(embeddedState(folder.path() / "map.tif"), json);
  EXPECT_EQ(embeddedState(folder.path() / "map.origin.tif"), json);
  EXPECT_EQ(readRaster(folder.path() / "map.tif").values, map.heights_mm);
  writeMap(folder.path() / "bare.tif", map, {.view_from_file = {}});
  EXPECT_EQ(embeddedState(folder.path() / "bare.tif"), std::nullopt);

  const auto csv = folder.write("log.csv", "# relievo log\n# " + stateLine(json) + "\nt_s\n1\n");
  EXPECT_EQ(embeddedState(csv), json);
  EXPECT_EQ(embeddedState(folder.write("no.csv", "# a\nt_s\n# " + stateLine(json) + "\n")),
            std::nullopt);
  EXPECT_EQ(embeddedState(folder.write("scan.ply", "ply\n")), std::nullopt);
  EXPECT_THROW(embeddedState(folder.path() / "missing.png"), FileError);
  EXPECT_THROW(embeddedState(folder.write("cut.png", "\x89PNG\r\n\x1a\n____")), FileError);
}

}  // namespace
}  // namespace relievo
