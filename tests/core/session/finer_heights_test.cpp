// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/finer_heights.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo {
namespace {

/// Level 1 of a map of 800 x 800 with its own heights, so that a mix-up of levels shows.
Surface surfaceOf(float (*finer)(double x, double y)) {
  Surface surface;
  GridFrame frame{{800, 800}, 0.5, 0.25, 0.25};
  surface.map.frame = frame;
  surface.map.heights_mm.resize(frame.size.count());
  surface.map.origins.assign(frame.size.count(), CellStatus::measured);
  for (int row = 0; row < 800; ++row) {
    for (int col = 0; col < 800; ++col) {
      surface.map.heights_mm[frame.size.index({col, row})] = finer(frame.xMm(col), frame.yMm(row));
    }
  }
  surface.pyramid = buildPyramid(surface.map);
  surface.ladder = detailLadder(surface.map, surface.pyramid);
  return surface;
}

TEST(FinerHeights, AreThoseOfTheNextFinerLevelAtFourHundredPlacesASide) {
  const auto wave = [](double x, double y) {
    return static_cast<float>(5 + 0.1 * x - 0.2 * y + std::sin(0.3 * x));
  };
  const Surface surface = surfaceOf(wave);
  // Places at 0.5 mm, on the samples of level 0.
  const Region region{100, 60, 200, Level{1}};
  const std::vector<float> heights = finerHeights(surface, region, 2);
  ASSERT_EQ(heights.size(), 400U * 400U);
  double off = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = 100 + 0.5 * (static_cast<double>(i % 400) + 0.5);
    const double y = 60 + 0.5 * (static_cast<double>(i / 400) + 0.5);
    off = std::max(off, std::abs(heights[i] - 2.0 * static_cast<double>(wave(x, y))));
  }
  EXPECT_LT(off, 1e-4);
}

TEST(FinerHeights, TheFinestLevelHasNone) {
  const Surface surface = surfaceOf([](double, double) { return 1.0F; });
  EXPECT_TRUE(finerHeights(surface, {100, 60, 100, Level{0}}).empty());
}

}  // namespace
}  // namespace relievo
