// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/space/haptic_space.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/base/error.h"
#include "core/region/hand.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using test::spaceOf;
using test::windowOf;

double wavy(double x, double y) {
  return 3 * std::sin(0.4 * x) + 2 * std::cos(0.3 * y) + 0.1 * x;
}

TEST(HapticSpace, IsExactAtTheSamplesAndBilinearBetweenThem) {
  const RegionWindow window = windowOf(50, wavy);
  const auto space = spaceOf(50, wavy);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(-5, 55);
  for (int i = 0; i < 2000; ++i) {
    const double x = anywhere(random), y = anywhere(random);
    const GridPoint g = space->gridFromView({x, y, 0});
    const double height = space->viewFromGrid({g.x, g.y, surfaceHeight(*space, g.x, g.y)}).z;
    EXPECT_NEAR(height, windowHeightMm(window, x, y), 1e-9) << x << ", " << y;
  }
}

TEST(HapticSpace, ContinuesTheOutermostSamplesAsConstants) {
  const auto space = spaceOf(50, wavy);
  EXPECT_DOUBLE_EQ(surfaceHeight(*space, -70, 20.25), surfaceHeight(*space, 0, 20.25));
  EXPECT_DOUBLE_EQ(surfaceHeight(*space, 900, 900), space->gridHeight(199, 199));
  EXPECT_DOUBLE_EQ(surfaceHeight(*space, 7.5, -1e6), surfaceHeight(*space, 7.5, 0));
}

TEST(HapticSpace, LiesInTheHandAsTheMappingSays) {
  const RegionWindow window = windowOf(50, wavy);
  const auto space = spaceOf(50, wavy);
  const HandMapping mapping = handMapping(window);
  for (const ViewMm p : {ViewMm{0, 0, 0}, ViewMm{10, 40, 3}, ViewMm{-3, 77, -9}}) {
    const DeviceMm expected = mapping.device_from_view(p), actual = space->deviceFromView(p);
    EXPECT_NEAR(norm(expected - actual), 0, 1e-12);
    EXPECT_NEAR(norm(space->viewFromDevice(actual) - p), 0, 1e-12);
    EXPECT_NEAR(norm(space->deviceFromGrid(space->gridFromDevice(actual)) - actual), 0, 1e-12);
  }
  const double mid = 0.5 * (double{window.min_mm} + double{window.max_mm});
  EXPECT_NEAR(norm(space->deviceFromView({25, 25, mid})), 0, 1e-12) << "centre at mid height";
}

TEST(HapticSpace, KeepsTheTouchedPointUnderTheHandThroughAZoom) {
  // A hill touched near its top, then a quarter of the window around the touched point.
  const auto hill = [](double x, double y) {
    return 20 * std::exp(-((x - 60) * (x - 60) + (y - 50) * (y - 50)) / 300) + wavy(x, y) / 5;
  };
  const RegionWindow whole = windowOf(100, hill);
  HapticSpace before;
  fill(before, whole, {}, SurfaceKind::crease_aware);
  const ViewMm touched{62, 49, hill(62, 49)};
  const Anchor anchor{touched, before.deviceFromView(touched)};
  RegionWindow part = windowOf(50, [&](double x, double y) { return hill(x + 31, y + 24.5); });
  part.region.x_mm = 31;
  part.region.y_mm = 24.5;
  HapticSpace after, unanchored;
  fill(after, part, {}, SurfaceKind::crease_aware, anchor);
  fill(unanchored, part, {}, SurfaceKind::crease_aware);
  EXPECT_LE(norm(after.deviceFromView(touched) - anchor.at), 2);
  EXPECT_GT(norm(unanchored.deviceFromView(touched) - anchor.at), 2) << "what the anchor is for";
  const double top = after.deviceFromView({0, 0, double{part.max_mm}}).z;
  const double low = after.deviceFromView({0, 0, double{part.min_mm}}).z;
  EXPECT_LE(std::max(std::abs(top), std::abs(low)), kHandReach.z + 1e-9);
  // An anchor that cannot be: the window stays within reach.
  HapticSpace far;
  fill(far, part, {}, SurfaceKind::crease_aware, Anchor{touched, {500, -500, 500}});
  EXPECT_LE(std::abs(far.deviceFromView({56, 49.5, double{part.max_mm}}).z), kHandReach.z + 1e-9);
}

TEST(HapticSpace, NamesTheOriginOfTheNearestSample) {
  RegionWindow window = windowOf(20, wavy);
  window.origins[5 * kWindowSamples + 7] = CellStatus::base_plane;
  window.origins[0] = CellStatus::outside;
  HapticSpace space;
  fill(space, window, {});
  EXPECT_EQ(space.originAt({7.4, 4.6, 0}), CellStatus::base_plane);
  EXPECT_EQ(space.originAt({7.6, 4.6, 0}), CellStatus::measured);
  EXPECT_EQ(space.originAt({-1000, -1000, 0}), CellStatus::outside) << "nearest is the corner";
}

TEST(HapticSpace, RefusesWindowsItCannotHold) {
  HapticSpace space;
  RegionWindow window = windowOf(20, wavy);
  window.heights_mm.pop_back();
  EXPECT_THROW(fill(space, window, {}), ArgumentError);
  window = windowOf(20, wavy);
  window.heights_mm[17] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(fill(space, window, {}), ArgumentError);
  window = windowOf(20, wavy);
  window.region.side_mm = 0;
  EXPECT_THROW(fill(space, window, {}), ArgumentError);
}

}  // namespace
}  // namespace relievo
