// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/region/hand.h"

namespace relievo {
namespace {

/// 400 x 300 samples of 0.5 mm: the plane z = 1 + 0.1 x + 0.05 y.
DepthMap planeMap() {
  DepthMap map;
  map.frame = {.size = {.cols = 400, .rows = 300},
               .spacing_mm = 0.5,
               .first_x_mm = 0.25,
               .first_y_mm = 0.25};
  for (int row = 0; row < 300; ++row) {
    for (int col = 0; col < 400; ++col) {
      map.heights_mm.push_back(
          static_cast<float>(1 + 0.1 * map.frame.xMm(col) + 0.05 * map.frame.yMm(row)));
      map.origins.push_back(CellStatus::measured);
    }
  }
  return map;
}

TEST(SampleWindow, IsExactOnAPlaneAtItsSamplePositions) {
  const DepthMap map = planeMap();
  const Pyramid pyramid = buildPyramid(map);
  const Region region{.x_mm = 13.3, .y_mm = 21.7, .side_mm = 61.9, .level = {0}};
  const RegionWindow window = sampleWindow(map, pyramid, region);
  for (int row = 0; row < kWindowSamples; row += 7) {
    for (int col = 0; col < kWindowSamples; col += 7) {
      const double x = region.x_mm + (col + 0.5) * region.side_mm / 200;
      const double y = region.y_mm + (row + 0.5) * region.side_mm / 200;
      const auto i =
          GridSize{.cols = kWindowSamples, .rows = kWindowSamples}.index({.col = col, .row = row});
      ASSERT_NEAR(window.heights_mm[i], 1 + 0.1 * x + 0.05 * y, 1e-5);
      ASSERT_EQ(window.origins[i], CellStatus::measured);
    }
  }
}

TEST(SampleWindow, BeyondTheMapIsOutsideWithHeightZero) {
  const DepthMap map = planeMap();
  const RegionWindow window = sampleWindow(
      map, buildPyramid(map), {.x_mm = -100, .y_mm = -100, .side_mm = 400, .level = {1}});
  EXPECT_EQ(window.origins[0], CellStatus::outside);
  EXPECT_EQ(window.heights_mm[0], 0);
  const std::size_t middle = 100U * kWindowSamples + 100U;  // (101, 101) mm.
  EXPECT_EQ(window.origins[middle], CellStatus::measured);
  EXPECT_NEAR(window.heights_mm[middle], 1 + 10.1 + 5.05, 1e-4);
}

DepthMap roughMap() {
  std::mt19937 random(3);
  DepthMap map;
  map.frame = {.size = {.cols = 300, .rows = 260},
               .spacing_mm = 0.5,
               .first_x_mm = 0.25,
               .first_y_mm = 0.25};
  for (std::size_t i = 0; i < map.frame.size.count(); ++i) {
    map.heights_mm.push_back(static_cast<float>(random()) * 1e-9F);
  }
  map.origins.assign(map.heights_mm.size(), CellStatus::measured);
  return map;
}

TEST(SampleWindow, IsBilinearBetweenTheNodesAtAnySpacing) {
  const DepthMap map = roughMap();
  const Pyramid pyramid = buildPyramid(map);
  // Samples per node spacing from four to less than one, at the map's far corner, too.
  for (const double side_mm : {25.0, 83.1, 96.7, 129.9, 149.9}) {
    const Region region{
        .x_mm = 149.95 - side_mm, .y_mm = 129.95 - side_mm, .side_mm = side_mm, .level = {0}};
    const RegionWindow window = sampleWindow(map, pyramid, region);
    for (int row = 0; row < kWindowSamples; ++row) {
      for (int col = 0; col < kWindowSamples; ++col) {
        const double u = (region.x_mm + (col + 0.5) * side_mm / 200 - 0.25) / 0.5;
        const double v = (region.y_mm + (row + 0.5) * side_mm / 200 - 0.25) / 0.5;
        if (u < 0 || v < 0 || u > 299 || v > 259) continue;
        const Cell c{.col = std::min(static_cast<int>(u), 298),
                     .row = std::min(static_cast<int>(v), 258)};
        const auto z = [&](int right, int up) {
          return static_cast<double>(map.heightMm({.col = c.col + right, .row = c.row + up}));
        };
        const double p = u - c.col;
        const double q = v - c.row;
        const double expected =
            (1 - q) * ((1 - p) * z(0, 0) + p * z(1, 0)) + q * ((1 - p) * z(0, 1) + p * z(1, 1));
        ASSERT_NEAR(
            window.heights_mm[static_cast<std::size_t>(row) * 200 + static_cast<std::size_t>(col)],
            expected, 1e-6)
            << side_mm << ' ' << col << ' ' << row;
      }
    }
  }
}

TEST(SampleWindow, AWindowOnTheNodesIsACopyOfThem) {
  const DepthMap map = roughMap();
  const Pyramid pyramid = buildPyramid(map);
  const RegionWindow window =
      sampleWindow(map, pyramid, {.x_mm = 20, .y_mm = 10, .side_mm = 100, .level = {0}});
  // A shift of a quarter of a sample mixes the neighbours bilinearly.
  const RegionWindow shifted =
      sampleWindow(map, pyramid, {.x_mm = 20.125, .y_mm = 10, .side_mm = 100, .level = {0}});
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 200; ++col) {
      const std::size_t i = static_cast<std::size_t>(row) * 200 + static_cast<std::size_t>(col);
      const float here = map.heightMm({.col = col + 40, .row = row + 20});
      const float next = map.heightMm({.col = col + 41, .row = row + 20});
      ASSERT_EQ(window.heights_mm[i], here);
      ASSERT_NEAR(shifted.heights_mm[i], 0.75F * here + 0.25F * next, 1e-6);
    }
  }
  EXPECT_NE(window.id, shifted.id);
}

TEST(SampleWindow, GainScalesHeightsAndChangesTheId) {
  const DepthMap map = planeMap();
  const Pyramid pyramid = buildPyramid(map);
  const Region region{.x_mm = 0, .y_mm = 0, .side_mm = 100, .level = {0}};
  const RegionWindow one = sampleWindow(map, pyramid, region);
  const RegionWindow three = sampleWindow(map, pyramid, region, 3);
  EXPECT_FLOAT_EQ(three.max_mm, 3 * one.max_mm);
  EXPECT_NE(one.id, three.id);
  EXPECT_EQ(one.id, sampleWindow(map, pyramid, region).id);
  EXPECT_THROW(sampleWindow(map, pyramid, region, 0), ArgumentError);
  EXPECT_THROW(sampleWindow(map, pyramid, {.side_mm = 10, .level = {9}}), ArgumentError);
}

TEST(HandMapping, FillsTheWidthOfTheHandSpaceWithOneScale) {
  const DepthMap map = planeMap();
  const RegionWindow window =
      sampleWindow(map, buildPyramid(map), {.x_mm = 0, .y_mm = 0, .side_mm = 100, .level = {0}});
  const HandMapping hand = handMapping(window);
  EXPECT_DOUBLE_EQ(hand.device_per_view, 0.8);
  EXPECT_DOUBLE_EQ(hand.objectMmPerHandMm(), 1.25);
  const double middle =
      0.5 * (static_cast<double>(window.min_mm) + static_cast<double>(window.max_mm));
  const DeviceMm centre = hand.device_from_view({50, 50, middle});
  EXPECT_NEAR(norm(centre), 0, 1e-12);
  EXPECT_NEAR(hand.device_from_view({100, 50, middle}).x, 40, 1e-12);
  const ViewMm back = hand.device_from_view.inverseOfSimilarity()({40, -40, 10});
  EXPECT_NEAR(back.x, 100, 1e-12);
  EXPECT_NEAR(back.z, middle + 12.5, 1e-12);
}

TEST(HandMapping, HighReliefIsScaledToFitTheHandsHeight) {
  DepthMap map = planeMap();
  map.heights_mm[0] = 500;
  const RegionWindow window =
      sampleWindow(map, buildPyramid(map), {.x_mm = 0, .y_mm = 0, .side_mm = 100, .level = {0}});
  const double range = static_cast<double>(window.max_mm) - static_cast<double>(window.min_mm);
  EXPECT_GT(range, 100);
  EXPECT_DOUBLE_EQ(handMapping(window).device_per_view, 60 / range);
}

TEST(HandOver, FloatsAboveTheSurfaceAndPressesIntoIt) {
  const DepthMap map = planeMap();
  const RegionWindow window =
      sampleWindow(map, buildPyramid(map), {.x_mm = 0, .y_mm = 0, .side_mm = 100, .level = {0}});
  const double surface = 1 + 0.1 * 40 + 0.05 * 30;
  EXPECT_NEAR(windowHeightMm(window, 40, 30), surface, 1e-5);
  EXPECT_NEAR(handOver(window, 40, 30, false, 2).z, surface + 0.5 * 1.25, 1e-5);
  EXPECT_NEAR(handOver(window, 40, 30, true, 2).z, surface - 2 * 1.25, 1e-5);
}

/// Each sample's origin is that of the cell it lies in, cell by cell.
TEST(SampleWindow, OriginsAreThoseOfTheCellsUnderTheSamples) {
  DepthMap map = planeMap();
  for (std::size_t i = 0; i < map.origins.size(); ++i) {
    const std::size_t col = i % 400;
    const std::size_t row = i / 400;
    map.origins[i] = (col + row) % 2 == 0 ? CellStatus::measured : CellStatus::interpolated;
  }
  const Pyramid pyramid = buildPyramid(map);
  for (const double side_mm : {20.0, 57.3, 99.9}) {
    const Region region{.x_mm = 31.37, .y_mm = 22.71, .side_mm = side_mm, .level = {0}};
    const RegionWindow window = sampleWindow(map, pyramid, region);
    std::size_t wrong = 0;
    for (int row = 0; row < kWindowSamples; ++row) {
      for (int col = 0; col < kWindowSamples; ++col) {
        const double x = region.x_mm + (col + 0.5) * side_mm / kWindowSamples;
        const double y = region.y_mm + (row + 0.5) * side_mm / kWindowSamples;
        const Cell cell{.col = static_cast<int>(std::floor(x / 0.5)),
                        .row = static_cast<int>(std::floor(y / 0.5))};
        const std::size_t i =
            static_cast<std::size_t>(row) * kWindowSamples + static_cast<std::size_t>(col);
        wrong += window.origins[i] != map.origin(cell);
      }
    }
    EXPECT_EQ(wrong, 0U) << side_mm;
  }
}

/// Beyond each of the four sides there is neither height nor origin, up to the map there are both.
TEST(SampleWindow, EndsWithTheMapOnAllFourSides) {
  const DepthMap map = planeMap();  // 200 x 150 mm.
  const Pyramid pyramid = buildPyramid(map);
  const Region region{.x_mm = -20.3, .y_mm = -40.7, .side_mm = 240.5, .level = {0}};
  const RegionWindow window = sampleWindow(map, pyramid, region);
  std::size_t inside = 0;
  for (int row = 0; row < kWindowSamples; ++row) {
    for (int col = 0; col < kWindowSamples; ++col) {
      const double x = region.x_mm + (col + 0.5) * region.side_mm / kWindowSamples;
      const double y = region.y_mm + (row + 0.5) * region.side_mm / kWindowSamples;
      const std::size_t i =
          static_cast<std::size_t>(row) * kWindowSamples + static_cast<std::size_t>(col);
      const bool on_map = x >= 0 && x <= 200 && y >= 0 && y <= 150;
      inside += on_map;
      ASSERT_EQ(window.origins[i], on_map ? CellStatus::measured : CellStatus::outside)
          << x << ' ' << y;
      if (on_map) {
        ASSERT_GE(window.heights_mm[i], 1) << x << ' ' << y;
      } else {
        ASSERT_EQ(window.heights_mm[i], 0) << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(inside, 10'000U);
}

}  // namespace
}  // namespace relievo
