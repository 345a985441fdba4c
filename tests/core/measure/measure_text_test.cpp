// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measure_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace relievo {
namespace {

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
  map.origins.assign(map.frame.size.count(), Origin::measured);
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
  EXPECT_THAT(csv, StartsWith("# first\n# second\nname,kind,quantity,value,uncertainty,unit,"
                              "not_measured\n\"the \"\"long\"\" one, left\",depth,depth "
                              "difference,3,"));
  EXPECT_THAT(csv, HasSubstr("\"p\",point,height,2,0.5,mm,0\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
}

TEST(MeasureText, AProfileIsOneRowPerSampleWithItsOrigin) {
  DepthMap map = ramp();
  map.origins[map.frame.size.index({.col = 4, .row = 5})] = Origin::base_plane;
  const auto rows = profile(map, {{2.5, 5.5}, {6.5, 5.5}});
  const std::string csv = profileCsv(rows, "");
  EXPECT_THAT(csv,
              StartsWith("along_mm,x_mm,y_mm,z_mm,uncertainty_mm,origin\n0,2.5,5.5,1,0.5,0\n"));
  EXPECT_THAT(csv, HasSubstr("\n2,4.5,5.5,2,0.5,2\n"));
}

TEST(MeasureText, AProfilesDrawingDashesWhatWasNotMeasured) {
  DepthMap map = ramp();
  for (float& height : map.heights_mm) height *= 0.5F;
  const auto solid = profileSvg(profile(map, {{2.5, 5.5}, {16.5, 5.5}}), "a < b & c");
  EXPECT_THAT(solid, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(solid, HasSubstr("true to scale"));
  EXPECT_THAT(solid, Not(HasSubstr("stroke-dasharray")));
  map.origins[map.frame.size.index({.col = 9, .row = 5})] = Origin::interpolated;
  EXPECT_THAT(profileSvg(profile(map, {{2.5, 5.5}, {16.5, 5.5}}), ""),
              HasSubstr("stroke-dasharray"));
  // Flat: another scale for heights, and it is said.
  for (float& height : map.heights_mm) height *= 0.01F;
  EXPECT_THAT(profileSvg(profile(map, {{2.5, 5.5}, {16.5, 5.5}}), ""), HasSubstr("of the length"));
  EXPECT_THAT(profileSvg({}, "empty"), HasSubstr("</svg>"));
}

TEST(MeasureText, ASectionIsOneRowPerPoint) {
  const auto curves = section(ramp(), {.normal = {0, 0, 1}, .offset_mm = 2.25});
  const std::string csv = sectionCsv(curves, "h");
  EXPECT_THAT(csv, StartsWith("# h\ncurve,closed,x_mm,y_mm,z_mm\n1,0,5,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 22);
}

}  // namespace
}  // namespace relievo
