// SPDX-License-Identifier: BSD-3-Clause
// What older versions wrote still opens, whichever of the two kinds it is.
#include "core/project/embedded_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/provenance/embedded.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

/// As figures carry it and project files hold it.
std::string projectText() {
  Project p;
  p.file = "scans/relief.ply";
  p.sha256 = std::string(64, '2');
  p.region = {.x_mm = 1.5, .y_mm = -2, .side_mm = 44.4, .level = Level{2}};
  p.look.kind = ReliefKind::openness;
  p.figure.dpi = 600;
  return projectJson(p);
}

/// As version 0.1 wrote pictures of `render`.
constexpr const char* kPicture = R"({
  "relievo_provenance": 1,
  "program": {"name": "relievo", "version": "0.1.0", "commit": "unknown"},
  "input": {"file": "a.xyz", "bytes": 9, "sha256": "", "incomplete": true},
  "depth_map": {"unit": "mm", "unit_source": "assumed",
                "view": {"name": "top", "turn_deg": [0, 0, 0]}, "cells": null, "spacing_mm": 1,
                "engine": "cpu", "rule": null, "holes": {"rule": "base"}, "factor": 2,
                "coarsest_samples": 200},
  "view": {"region_mm": [10, 5, 30, 30], "level": 1, "gain": 3, "turn_deg": [10, -20],
           "look": {"kind": "lit", "colours": "viridis", "light_azimuth_deg": 40,
                    "light_elevation_deg": 20, "radius_mm": 0, "range": null},
           "stereo": {"mode": "anaglyph", "eye_angle_deg": 5, "zero_plane_mm": null}},
  "picture": {"pixels": [640, 480], "scale_bar": true},
  "made": {"cells": [3, 4]}
})";

TEST(CarriedState, MarkupCarriesItWhateverStandsAroundIt) {
  const test::TemporaryFolder folder;
  const std::string element = stateElement(projectText());
  EXPECT_EQ(element.find("\"openness\""), std::string::npos) << "no quotes of JSON";
  // Longer than a block that is read at once, with the mark across the blocks' border.
  const std::string before = "%PDF-1.4\n" + std::string((1U << 20U) - 14, ' ');
  for (const std::string& start : {std::string("<svg><metadata>"), before}) {
    const auto p = embeddedProject(folder.write("f.svg", start + element + "</metadata>"));
    ASSERT_TRUE(p);
    EXPECT_EQ(p->figure.dpi, 600);
  }
  EXPECT_FALSE(embeddedProject(folder.write("other.svg", "<?xml version='1.0'?><svg></svg>")));
  EXPECT_THROW(embeddedProject(folder.write("cut.svg", "<svg>" + element.substr(0, 900))),
               FileError);
}

TEST(CarriedState, AProjectOfTheSchemaBeforeTheFirstReleaseIsRefusedByItsNumber) {
  std::string text = projectText();
  const std::string schema = "\"relievo_project\": 2";
  ASSERT_NE(text.find(schema), std::string::npos);
  text.replace(text.find(schema), schema.size(), "\"relievo_project\": 1");
  try {
    projectFromState(text, "f.png");
    FAIL() << "read it";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("(schema 1; this one reads 2)"));
  }
}

TEST(CarriedState, APictureOfAnOlderVersionBecomesAProjectThatDrawsIt) {
  const auto p = projectFromState(kPicture, "r.png");
  ASSERT_TRUE(p);
  EXPECT_EQ(p->region, (Region{.x_mm = 10, .y_mm = 5, .side_mm = 30, .level = Level{1}}));
  EXPECT_EQ(p->gain, 3);
  EXPECT_EQ(p->azimuth_deg, 10);
  EXPECT_EQ(p->elevation_deg, -20);
  EXPECT_EQ(p->look.light.azimuth_deg, 40);
  EXPECT_EQ(p->stereo.mode, StereoMode::anaglyph);
  EXPECT_TRUE(p->accept_incomplete);
  EXPECT_EQ(p->picture, (PictureChoice{.width_px = 640, .height_px = 480, .scale_bar = true}));
  // Written again it is of today's kind and says the same.
  const auto again = projectFromState(projectJson(*p), "r.png");
  EXPECT_EQ(viewOf(*again), viewOf(*p));
  EXPECT_EQ(again->picture, p->picture);
}

TEST(CarriedState, AMapShowsNoRegion) {
  std::string map = kPicture;
  const std::size_t view = map.find("\"view\": {\"region_mm\"");
  map.replace(view, map.find("\"made\"") - view, "");
  EXPECT_FALSE(projectFromState(map, "m.tif"));
}

TEST(CarriedState, ALogsPlaceIsTakenFromItsFolder) {
  const test::TemporaryFolder folder;
  std::string line = kPicture;
  std::erase(line, '\n');
  const auto log = folder.write("log.csv", "# " + stateLine(line) + "\nt_s\n");
  EXPECT_EQ(embeddedProject(log)->file, (folder.path() / "a.xyz").string());
  EXPECT_EQ(embeddedProject(folder.write("p.json", projectText()))->file,
            (folder.path() / "scans/relief.ply").string());
  EXPECT_FALSE(embeddedProject(folder.write("points.csv", "x,y,z\n1,2,3\n")));
  EXPECT_THROW(embeddedProject(folder.write("bad.json", "{\"a\": 1}")), FileError);
}

}  // namespace
}  // namespace relievo
