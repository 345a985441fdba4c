// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measure_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace relievo {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

DepthMap ramp() {
  DepthMap map;
  map.frame = {
      .size = {.cols = 20, .rows = 20}, .spacing_mm = 1, .first_x_mm = 0.5, .first_y_mm = 0.5};
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 20; ++col) map.heights_mm.push_back(0.5F * static_cast<float>(col));
  }
  map.origins.assign(map.frame.size.count(), CellStatus::measured);
  return map;
}

TEST(MeasureText, AListIsOneRowPerQuantityWithQuotedNames) {
  const std::string csv =
      measurementsCsv(ramp(),
                      {{.name = "the \"long\" one, left",
                        .kind = MeasureKind::depth,
                        .places = {{2.5, 5}, {8.5, 5}}},
                       {.name = "p", .kind = MeasureKind::point, .places = {{4.5, 5}}}},
                      "first\nsecond");
  EXPECT_THAT(csv,
              StartsWith("# first\n# second\nname,kind,quantity,value,uncertainty,unit,"
                         "not_measured,plane,places_mm\n\"the \"\"long\"\" one, left\",depth,depth "
                         "difference,3,"));
  EXPECT_THAT(csv, HasSubstr("\"p\",point,height,2,0.500001"));
  EXPECT_THAT(csv, HasSubstr(",,2.5 5; 8.5 5\n")) << "no plane, two places";
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
}

TEST(MeasureText, WhatCouldNotBeReadIsACommentInItsPlace) {
  const Measurement m{.name = "p", .kind = MeasureKind::point, .places = {{4.5, 5}}};
  const std::string csv =
      measurementsCsv({{.measurement = m, .reading = {}, .problem = "No surface\nhere."},
                       {.measurement = m, .reading = read(ramp(), m), .problem = {}}});
  EXPECT_THAT(csv, HasSubstr("places_mm\n# p: No surface\n# here.\n\"p\",point,height,2,"));
}

TEST(MeasureText, AProfileIsOneRowPerSampleWithItsOrigin) {
  DepthMap map = ramp();
  map.origins[map.frame.size.index({.col = 4, .row = 5})] = CellStatus::base_plane;
  const auto rows = profile(map, {{2.5, 5.5}, {6.5, 5.5}});
  const std::string csv = profileCsv(rows, "");
  EXPECT_THAT(csv,
              StartsWith("along_mm,x_mm,y_mm,z_mm,uncertainty_mm,origin\n0,2.5,5.5,1,0.500001"));
  EXPECT_THAT(csv, ContainsRegex("\n2,4.5,5.5,2,0.50000[0-9]*,2\n"));
}

TEST(MeasureText, AProfilesDrawingDashesWhatWasNotMeasured) {
  DepthMap map = ramp();
  for (float& height : map.heights_mm) height *= 0.5F;
  const auto solid = profileSvg(profile(map, {{2.5, 5.5}, {16.5, 5.5}}), "a < b & c");
  EXPECT_THAT(solid, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(solid, HasSubstr("true to scale"));
  EXPECT_THAT(solid, Not(HasSubstr("stroke-dasharray")));
  map.origins[map.frame.size.index({.col = 9, .row = 5})] = CellStatus::interpolated;
  EXPECT_THAT(profileSvg(profile(map, {{2.5, 5.5}, {16.5, 5.5}}), ""),
              HasSubstr("stroke-dasharray"));
  // Flat: another scale for heights, and it is said.
  for (float& height : map.heights_mm) height *= 0.01F;
  EXPECT_THAT(profileSvg(profile(map, {{2.5, 5.5}, {16.5, 5.5}}), ""), HasSubstr("of the length"));
  EXPECT_THAT(profileSvg({}, "empty"), HasSubstr("</svg>"));
}

TEST(MeasureText, AProfilesDrawingIsOpenWhereItsLineIsBesideTheObject) {
  const auto pieces = [](const std::vector<PlaceMm>& places) {
    const std::string svg = profileSvg(profile(ramp(), places), "");
    std::size_t count = 0;
    for (std::size_t at = svg.find("<polyline"); at != std::string::npos;
         at = svg.find("<polyline", at + 1)) {
      ++count;
    }
    return count;
  };
  const std::size_t whole = pieces({{2.5, 5.5}, {16.5, 5.5}});
  EXPECT_EQ(pieces({{2.5, 5.5}, {2.5, -90}, {16.5, -90}, {16.5, 5.5}}), whole + 1);
}

TEST(MeasureText, APlaneIsSaidToPeopleAndToPrograms) {
  using enum MeasureKind;
  EXPECT_EQ(planeText({.kind = point}), "");
  EXPECT_EQ(planeNumbers({.kind = point}), "");
  EXPECT_EQ(planeText({.kind = area, .plane_mm = 2.5}), "level at 2.5 mm");
  EXPECT_EQ(planeNumbers({.kind = area, .plane_mm = 2.5}), "0 0 1 2.5");
  EXPECT_EQ(planeText({.kind = section, .plane_mm = -2.5, .normal = {0, 0, -3}}),
            "level at 2.5 mm");
  EXPECT_EQ(planeText({.kind = section, .plane_mm = 12, .normal = {3, -4, 0}}),
            "upright: 0.6 x \u2212 0.8 y = 12 mm");
  EXPECT_EQ(planeNumbers({.kind = section, .plane_mm = 12, .normal = {3, -4, 0}}), "3 -4 0 12");
  EXPECT_THAT(planeText({.kind = section, .plane_mm = 1, .normal = {0, 1, 1}}),
              StartsWith("oblique: 0.7071 y + 0.7071 z"));
}

TEST(MeasureText, TheFirstDigitOfAnUncertaintyIsAlwaysSeen) {
  EXPECT_EQ(decimalsFor(48), 0);
  EXPECT_EQ(decimalsFor(4.8), 1);
  EXPECT_EQ(decimalsFor(0.25), 2);
  EXPECT_EQ(decimalsFor(0.048), 3);
  EXPECT_EQ(decimalsFor(0.0048), 3);
  EXPECT_EQ(decimalsFor(6e-6), 6);
  EXPECT_EQ(decimalsFor(0), 3);
}

TEST(MeasureText, ASectionsDrawingIsTrueToScaleAndNamesItsAxes) {
  const DepthMap map = ramp();
  const auto drawn = [&](const PlaneMm& plane) {
    return sectionSvg(section(map, plane), plane, "a < b");
  };
  const std::string level = drawn({.normal = {0, 0, 1}, .offset_mm = 2.25});
  EXPECT_THAT(level, HasSubstr("a &lt; b"));
  EXPECT_THAT(level, HasSubstr("y (mm), true to scale"));
  EXPECT_THAT(level, HasSubstr("<polyline"));
  const std::string upright = drawn({.normal = {0, 1, 0}, .offset_mm = 5});
  EXPECT_THAT(upright, HasSubstr(">height (mm), true to scale"));
  // 19 mm along and 9.5 mm up: the first and the last point of one straight line of that slope.
  const std::size_t at = upright.find("points='") + 8;
  std::istringstream points(upright.substr(at, upright.find('\'', at) - at));
  std::vector<double> xy;
  for (std::string pair; points >> pair;) {
    xy.push_back(std::stod(pair));
    xy.push_back(std::stod(pair.substr(pair.find(',') + 1)));
  }
  ASSERT_GE(xy.size(), 4U);
  EXPECT_NEAR((xy[xy.size() - 1] - xy[1]) / (xy[xy.size() - 2] - xy[0]), -0.5, 0.01);
  EXPECT_THAT(drawn({.normal = {0, 1, 1}, .offset_mm = 9}), HasSubstr("up the plane (mm)"));
  EXPECT_THAT(sectionSvg({}, {}, "empty"), HasSubstr("</svg>"));
}

TEST(MeasureText, ASectionIsOneRowPerPoint) {
  const auto curves = section(ramp(), {.normal = {0, 0, 1}, .offset_mm = 2.25});
  const std::string csv = sectionCsv(curves, "h");
  EXPECT_THAT(csv, StartsWith("# h\ncurve,closed,x_mm,y_mm,z_mm\n1,0,5,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 22);
}

}  // namespace
}  // namespace relievo
