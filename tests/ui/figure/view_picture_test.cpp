// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/view_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "core/depth/rules/rasterize.h"
#include "core/relief/stereo.h"
#include "core/session/large/tiled_surface.h"

namespace relievo {
namespace {

constexpr int kSide = 240;          // Pixels.
constexpr int kLegend = kSide / 8;  // Its rows lie above this one.

/// A dome of 8 mm on a plane of 60 x 60 mm.
Scan makeScan() {
  Scan scan;
  for (int row = 0; row <= 120; ++row) {
    for (int col = 0; col <= 120; ++col) {
      const double x = 0.5 * col, y = 0.5 * row, d = std::hypot(x - 30, y - 30);
      scan.points.push_back({static_cast<float>(x), static_cast<float>(y),
                             static_cast<float>(d < 20 ? 8 * (1 - d * d / 400) : 0)});
    }
  }
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.format = "PLY";
  return scan;
}

class ViewPicture : public ::testing::Test {
 protected:
  ViewPicture() {
    SurfaceOptions options;
    options.unit = LengthUnit::mm;
    options.view = ViewChoice{"top", {}};
    options.spacing_mm = 0.5;
    surface_ = std::make_unique<Surface>(makeSurface(makeScan(), options, rasterize));
    project_.region = {.x_mm = 0, .y_mm = 0, .side_mm = 60, .level = {0}};
    project_.stereo.mode = StereoMode::anaglyph;
    project_.picture = PictureChoice{.width_px = kSide, .height_px = kSide};
  }
  RgbImage drawn(bool hand, FigureEye eye = FigureEye::both) {
    Project p = project_;
    if (hand) p.picture->hand = DrawnHand{.proxy = {20, 20, 4}, .hip = {20, 20, 1}, .force = {}};
    p.picture->eye = eye;
    return drawViewPicture(*surface_, windowOf(*surface_, p.region, 1), p);
  }

  std::unique_ptr<Surface> surface_;
  Project project_;
};

/// Pixels of the upper right corner that differ, where no hand is.
std::size_t cornerDifference(const RgbImage& a, const RgbImage& b) {
  std::size_t count = 0;
  for (int y = 0; y < kLegend; ++y) {
    for (int x = kSide / 2; x < kSide; ++x) {
      const auto at = 3 * static_cast<std::size_t>(y * kSide + x);
      if (!std::equal(&a.rgb[at], &a.rgb[at] + 3, &b.rgb[at])) ++count;
    }
  }
  return count;
}

TEST_F(ViewPicture, OfAHandInGreyAnaglyphHasTheLegendOfItsShapes) {
  EXPECT_GT(cornerDifference(drawn(true), drawn(false)), 1000U);
  project_.stereo.mode = StereoMode::half_colour;  // There colours tell them apart.
  EXPECT_EQ(cornerDifference(drawn(true), drawn(false)), 0U);
}

TEST_F(ViewPicture, IsItsTwoEyesMixedAndSoIsItsLegend) {
  const RgbImage left = drawn(true, FigureEye::left);
  const RgbImage right = drawn(true, FigureEye::right);
  EXPECT_GT(cornerDifference(left, drawn(false, FigureEye::left)), 1000U) << "each eye has it";
  RgbImage mixed = left;
  mixAnaglyph(printed(StereoMode::anaglyph), mixed.rgb, right.rgb, 3);
  const RgbImage both = drawn(true);
  ASSERT_EQ(mixed.rgb.size(), both.rgb.size());
  int most_in_legend = 0, most_below = 0;
  for (std::size_t i = 0; i < both.rgb.size(); ++i) {
    const bool below = i >= 3U * kSide * kLegend;
    int& most = below ? most_below : most_in_legend;
    most = std::max(most, std::abs(int{mixed.rgb[i]} - int{both.rgb[i]}));
  }
  EXPECT_EQ(most_below, 0);
  EXPECT_LE(most_in_legend, 6) << "its signs are nearly grey";
}

}  // namespace
}  // namespace relievo
