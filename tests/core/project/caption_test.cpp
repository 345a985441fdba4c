// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/caption.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/depth/rules/rasterize.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

using testing::HasSubstr;

Surface surfaceWithHole() {
  // A cap over a plate with a hole of 6 x 6 mm that shows nothing.
  Scan scan = test::latticeScan(101, 81, 0.5, [](double x, double y) {
    const double d2 = (x - 25) * (x - 25) + (y - 20) * (y - 20);
    return d2 < 100 ? 0.05 * (100 - d2) : 0;
  });
  std::erase_if(scan.points, [](const std::array<float, 3>& p) {
    return std::abs(p[0] - 40) < 3 && std::abs(p[1] - 30) < 3;
  });
  scan.info.points = scan.info.finite_points = scan.points.size();
  return makeSurface(scan, {}, rasterize);
}

TEST(Caption, SaysHowMuchTheLevelIsSmoothed) {
  const Scan scan = test::latticeScan(401, 401, 0.5, [](double, double) { return 0; });
  const Surface surface = makeSurface(scan, {}, rasterize);
  ASSERT_EQ(surface.ladder.levels(), 3);
  Project p;
  p.file = "plate.ply";
  p.region = {.x_mm = 20, .y_mm = 30, .side_mm = 100, .level = {1}};
  const RegionWindow window = sampleWindow(surface.map, surface.pyramid, p.region, p.gain);
  // A Gaussian of one cell of the finer level.
  EXPECT_THAT(
      captionOf(p, surface, window, pictureFacts(p, 0.25)),
      HasSubstr("Resolution 2 of 3 (level 1, pyramid factor 2, smoothed by \u03c3 = 0.5 mm)"));
}

TEST(Caption, SaysEverythingThatDecidesThePicture) {
  const Surface surface = surfaceWithHole();
  ASSERT_EQ(surface.holes.size(), 1U);
  Project p;
  p.file = "a/coin.ply";
  p.sha256 = sha256OfText("coin");
  p.region = wholeRegion(surface.ladder);
  p.gain = 2;
  p.azimuth_deg = 10;
  p.stereo.mode = StereoMode::dubois;
  const RegionWindow window = sampleWindow(surface.map, surface.pyramid, p.region, p.gain);
  CaptionFacts facts = pictureFacts(p, 0.25);
  facts.paper_mm_per_mm = 0.5;
  const std::string text = captionOf(p, surface, window, facts);
  for (const char* part :
       {"coin.ply", "mm (unit mm, assumed)", "view ", "method CPU", "1 enclosed hole of ",
        "on the base plane", "Resolution 1 of 1 (level 0, pyramid factor 2)",
        "vertical exaggeration \u00d7 2", "light from 315\u00b0, 45\u00b0", "turned by 10\u00b0",
        "Dubois red-cyan anaglyph, 4\u00b0", "1 pixel is 0.25 mm", "Scale 1:2", "% measured",
        "% outside the object", "input SHA-256"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text, HasSubstr(sha256OfText("coin")));
  EXPECT_THAT(text, HasSubstr(surface.rule));
}

TEST(Caption, NumbersAreShortAndWithoutExponents) {
  EXPECT_EQ(shortNumber(0.0022526303), "0.002253");
  EXPECT_EQ(shortNumber(-0.0), "0");
  EXPECT_EQ(shortNumber(12.0), "12");
  EXPECT_EQ(shortNumber(9999.6), "10000");
  EXPECT_EQ(shortNumber(-1025399.44), "-1025399");
}

TEST(Caption, ObjectsAreToldInTheUnitOfTheirScaleBars) {
  const Scan scan = test::latticeScan(101, 81, 20, [](double x, double) { return x / 20; });
  Project p;
  p.file = "hill.ply";
  for (const auto& [unit, size, pixel] :
       {std::tuple{LengthUnit::m, "hill.ply, 2.02 \u00d7 1.62 km \u00d7 100 m (unit m",
                   "20 m apart"},
        {LengthUnit::cm, "hill.ply, 20.2 \u00d7 16.2 \u00d7 1 m (unit cm", "0.2 m apart"},
        {LengthUnit::mm, "hill.ply, 2020 \u00d7 1620 \u00d7 100 mm (unit mm", "20 mm apart"}}) {
    SurfaceOptions options;
    options.unit = unit;
    options.view = ViewChoice{"top", {}};
    const Surface surface = makeSurface(scan, options, rasterize);
    p.region = wholeRegion(surface.ladder);
    const RegionWindow window = sampleWindow(surface.map, surface.pyramid, p.region, p.gain);
    const std::string text = captionOf(p, surface, window, pictureFacts(p, 0.25));
    EXPECT_THAT(text, HasSubstr(size));
    EXPECT_THAT(text, HasSubstr(pixel));
  }
}

TEST(Caption, NamesThePlanesOfWhatIsDrawn) {
  const Surface surface = surfaceWithHole();
  Project p;
  p.region = wholeRegion(surface.ladder);
  p.measurements = {{"rim", MeasureKind::section, {}, 2.5},
                    {"pit", MeasureKind::area, {{10, 10}, {20, 10}, {20, 20}}, 1},
                    {"dip", MeasureKind::depth, {{10, 10}, {20, 10}}, 0}};
  const RegionWindow window = sampleWindow(surface.map, surface.pyramid, p.region, p.gain);
  EXPECT_THAT(captionOf(p, surface, window, pictureFacts(p, 1)), testing::Not(HasSubstr("Planes")));
  p.picture = PictureChoice{.width_px = 10, .height_px = 10, .lines = {{{1, 1, 1}, {2, 2, 2}}}};
  EXPECT_THAT(captionOf(p, surface, window, pictureFacts(p, 1)),
              HasSubstr(" Planes: section rim, level at 2.5 mm; volume of pit, level at 1 mm. Of"));
}

TEST(Caption, SharesNameTheMeasuredCellsAlways) {
  EXPECT_EQ(sharesText({0, 0, 0, 0, 1}), "0 % measured, 100 % outside the object");
  EXPECT_EQ(sharesText({0.875, 0.125, 0, 0, 0}), "87.5 % measured, 12.5 % interpolated");
}

}  // namespace
}  // namespace relievo
