// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/window_colours.h"

#include <gtest/gtest.h>

#include "core/depth/colours/linear_light.h"
#include "core/pyramid/colour_levels.h"

namespace relievo {
namespace {

class WindowColours : public ::testing::Test {
 protected:
  WindowColours() {
    map_.frame = {
        .size = {.cols = 400, .rows = 400}, .spacing_mm = 1, .first_x_mm = 0.5, .first_y_mm = 0.5};
    map_.heights_mm.assign(map_.frame.size.count(), 1);
    map_.origins.assign(map_.frame.size.count(), CellStatus::measured);
    for (int row = 0; row < 400; ++row) {
      for (int col = 0; col < 400; ++col) {
        const auto value = static_cast<std::uint8_t>(col / 2);
        colours_.colours.push_back({value, static_cast<std::uint8_t>(row / 2), 9, 255});
      }
    }
    for (int row = 100; row < 140; ++row) {
      for (int col = 100; col < 140; ++col) {
        const std::size_t i = map_.frame.size.index({.col = col, .row = row});
        map_.origins[i] = CellStatus::base_plane;
        colours_.colours[i] = {};
      }
    }
    pyramid_ = buildPyramid(map_);
    levels_ = colourLevels(GridColours(colours_), pyramid_, 1);
  }
  GridColours at(const Region& region, int ring = 0) const {
    const auto level = static_cast<std::size_t>(region.level.value);
    const GridFrame& nodes = pyramid_.levels[level].frame;
    return windowColours(nodesOf(levels_[level], nodes.size), nodes,
                         sampleWindow(map_, pyramid_, region), ring);
  }

  DepthMap map_;
  GridColours colours_;
  Pyramid pyramid_;
  std::vector<StoredColours> levels_;
};

TEST_F(WindowColours, SamplesOnNodesHaveTheirBytes) {
  const GridColours window = at({.x_mm = 50, .y_mm = 60, .side_mm = 200, .level = Level{0}});
  ASSERT_EQ(window.colours.size(), kWindowCount);
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 200; ++col) {
      const Rgba expected =
          colours_.colours[map_.frame.size.index({.col = col + 50, .row = row + 60})];
      ASSERT_EQ(window.colours[static_cast<std::size_t>(row * 200 + col)], expected);
    }
  }
}

TEST_F(WindowColours, BetweenNodesLightIsMixed) {
  const GridColours window = at({.x_mm = 200, .y_mm = 200, .side_mm = 100, .level = Level{0}});
  // Sample 0 lies a quarter of a cell before node 200, sample 1 a quarter behind it.
  const Transfer& light = sRgb();
  const auto mixed = [&](int node) {
    const auto of = [&](int n) {
      return static_cast<float>(light.light[static_cast<std::size_t>(n / 2)]);
    };
    return light.storedOf(0.75F * of(node) + 0.25F * of(node + 1));
  };
  EXPECT_EQ(window.colours[1][0], mixed(200));
  EXPECT_EQ(window.colours[3][0], mixed(201));
}

TEST_F(WindowColours, HolesAndWhatLiesBeyondTheMapHaveNone) {
  const GridColours window = at({.x_mm = 0, .y_mm = 0, .side_mm = 800, .level = Level{1}});
  const auto sample = [&](int col, int row) {
    return window.colours[static_cast<std::size_t>(row * 200 + col)];
  };
  EXPECT_EQ(sample(30, 30), Rgba{});
  EXPECT_EQ(sample(150, 30), Rgba{});
  EXPECT_NE(sample(50, 30), Rgba{});
}

TEST_F(WindowColours, ARingContinuesTheBorder) {
  const Region region{.x_mm = 50, .y_mm = 60, .side_mm = 200, .level = Level{0}};
  const GridColours inner = at(region);
  const GridColours ringed = at(region, 1);
  ASSERT_EQ(ringed.colours.size(), 202U * 202U);
  EXPECT_EQ(ringed.colours[0], inner.colours[0]);
  EXPECT_EQ(ringed.colours[202 + 1], inner.colours[0]);
  EXPECT_EQ(ringed.colours[202 * 202 - 1], inner.colours[kWindowCount - 1]);
}

TEST_F(WindowColours, ALevelWithoutColoursGivesNone) {
  const RegionWindow window =
      sampleWindow(map_, pyramid_, {.x_mm = 0, .y_mm = 0, .side_mm = 200, .level = Level{0}});
  EXPECT_TRUE(windowColours({}, map_.frame, window).empty());
  EXPECT_TRUE(windowColours(nodesOf({}, map_.frame.size), map_.frame, window).empty());
}

}  // namespace
}  // namespace relievo
