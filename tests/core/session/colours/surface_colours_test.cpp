// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/colours/surface_colours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/raster/raster.h"
#include "core/session/large/memory_guard.h"
#include "core/session/large/tiled_surface.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

constexpr Rgba kRed{200, 30, 10, 255};
constexpr Rgba kBlue{10, 40, 220, 255};

/// Boards of 16 mm squares, told by the place.
const Rgba& board(double x, double y) {
  return (static_cast<int>(std::floor(x / 16)) + static_cast<int>(std::floor(y / 16))) % 2 == 0
             ? kRed
             : kBlue;
}

/// A wavy relief of 256 x 192 mm with its points at random places, coloured like a board.
Scan colouredCloud() {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> across(0, 256);
  std::uniform_real_distribution<double> up(0, 192);
  Scan scan;
  for (int i = 0; i < 150'000; ++i) {
    const double x = across(random);
    const double y = up(random);
    scan.points.push_back({static_cast<float>(x), static_cast<float>(y),
                           static_cast<float>(3 * std::sin(x / 20) * std::cos(y / 15))});
    scan.colours.push_back(board(x, y));
    scan.intensities.push_back(static_cast<std::uint16_t>(x * 200));
  }
  test::finishScan(scan);
  return scan;
}

SurfaceOptions fromTop() {
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{.name = "top", .rotation = {}};
  options.spacing_mm = 0.5;
  return options;
}

/// Far from the next square's border, in view mm?
bool isSure(double x, double y, double margin) {
  const auto off = [&](double at) {
    const double part = std::fmod(at, 16.0);
    return part > margin && part < 16 - margin;
  };
  return off(x) && off(y);
}

bool says(const Surface& surface, const std::string& words) {
  return std::any_of(surface.messages.begin(), surface.messages.end(), [&](const Message& message) {
    return englishText(message).find(words) != std::string::npos;
  });
}

class ColouredSurface : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    surface = new Surface(makeSurface(colouredCloud(), fromTop(), rasterize));
  }
  static void TearDownTestSuite() { delete surface; }
  static inline Surface* surface = nullptr;
};

TEST_F(ColouredSurface, HasTheBoardAtEveryLevel) {
  ASSERT_EQ(surface->colours.size(), surface->pyramid.levels.size());
  ASSERT_GE(surface->colours.size(), 2U);
  for (std::size_t level = 0; level < surface->colours.size(); ++level) {
    const GridFrame& f = surface->pyramid.levels[level].frame;
    const GridColours kept = surface->colours[level].all();
    ASSERT_EQ(kept.colours.size(), f.size.count());
    ASSERT_EQ(kept.intensities.size(), f.size.count());
    EXPECT_LE(surface->colours[level].bytes(), 4 * f.size.count());
    int seen = 0;
    for (int row = 0; row < f.size.rows; ++row) {
      for (int col = 0; col < f.size.cols; ++col) {
        // Its kernel and the points that cells in between are made from lie within.
        if (!isSure(f.xMm(col), f.yMm(row), std::max(4.0, 3 * f.spacing_mm))) continue;
        const Rgba& made = kept.colours[f.size.index({.col = col, .row = row})];
        ASSERT_NE(made[3], 0);
        const Rgba& expected = board(f.xMm(col), f.yMm(row));
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_NEAR(made[k], expected[k], 2) << col << ' ' << row;
        ++seen;
      }
    }
    EXPECT_GT(seen, 500) << level;
  }
}

TEST_F(ColouredSurface, SaysThatThereAreColoursAndHowToSeeThem) {
  EXPECT_TRUE(says(*surface, "The scan has colours"));
  EXPECT_TRUE(says(*surface, "'natural'"));
  EXPECT_TRUE(says(*surface, "The scan has intensities"));
  EXPECT_GT(surface->seconds.colours, 0);
}

TEST_F(ColouredSurface, AWindowAndACutShowTheSameColours) {
  const Level level{0};
  const Region region{.x_mm = 64, .y_mm = 32, .side_mm = 100, .level = level};
  const RegionWindow window = windowOf(*surface, region);
  const GridColours shown = windowColours(*surface, window);
  const GridColours cut =
      levelColours(*surface, level, {.left = 128, .right = 327, .bottom = 64, .top = 263});
  EXPECT_EQ(shown.colours, cut.colours);
  EXPECT_EQ(shown.intensities, cut.intensities);
}

TEST_F(ColouredSurface, CanBeShownSoAndOthersCannot) {
  EXPECT_TRUE(canShow(*surface, ReliefKind::natural));
  EXPECT_TRUE(canShow(*surface, ReliefKind::intensity));
  Scan plain = colouredCloud();
  plain.colours.clear();
  const Surface grey = makeSurface(plain, fromTop(), rasterize);
  EXPECT_FALSE(canShow(grey, ReliefKind::natural));
  EXPECT_TRUE(canShow(grey, ReliefKind::intensity));
  EXPECT_NO_THROW(requireColours(grey, ReliefKind::lit));
  EXPECT_THROW(requireColours(grey, ReliefKind::natural), ArgumentError);
  plain.intensities.clear();
  const Surface none = makeSurface(plain, fromTop(), rasterize);
  EXPECT_TRUE(none.colours.empty());
  EXPECT_FALSE(says(none, "colours"));
  EXPECT_TRUE(levelColours(none, Level{0}).empty());
  EXPECT_TRUE(windowColours(none, windowOf(none, wholeRegion(none.ladder))).empty());
}

TEST_F(ColouredSurface, WarnsWhereTheEyesWouldFight) {
  // Half of the board is a strong red.
  const RegionWindow window = windowOf(*surface, wholeRegion(surface->ladder));
  const double share = rivalShare(*surface, window, ReliefKind::natural, StereoPrint::half_colour);
  EXPECT_GT(share, kMostRivalShare);
  EXPECT_LT(share, 0.5 * 0.75);  // The window is square, the board 4 : 3; its seams are mixed.
  EXPECT_NE(rivalryWords(share).find("Grey stereo shows it to both."), std::string::npos);
  EXPECT_EQ(rivalShare(*surface, window, ReliefKind::natural, StereoPrint::grey), 0);
  EXPECT_EQ(rivalShare(*surface, window, ReliefKind::lit, StereoPrint::dubois), 0);
  EXPECT_EQ(rivalryWords(kMostRivalShare), "");
}

TEST_F(ColouredSurface, HeightsAreThoseOfTheScanWithoutColours) {
  Scan plain = colouredCloud();
  plain.colours.clear();
  plain.intensities.clear();
  const Surface grey = makeSurface(plain, fromTop(), rasterize);
  EXPECT_EQ(grey.map.heights_mm, surface->map.heights_mm);
  EXPECT_EQ(grey.map.origins, surface->map.origins);
}

TEST_F(ColouredSurface, AMapThatIsReadKeepsItsColours) {
  RasterMap raster;
  raster.size = surface->map.frame.size;
  raster.pixel = surface->map.frame.spacing_mm;
  raster.first = {surface->map.frame.first_x_mm, surface->map.frame.first_y_mm, 0};
  raster.is_own_map = true;
  raster.values = surface->map.heights_mm;
  raster.origins = surface->map.origins;
  raster.valid.assign(raster.values.size(), true);
  raster.colours = surface->colours.front().all();
  const Surface again = makeSurface(raster, fromTop());
  EXPECT_EQ(again.colours, surface->colours);
  EXPECT_TRUE(says(again, "The map has colours beside it"));
}

TEST(ColouredMesh, IsColouredFromItsFront) {
  Scan mesh = test::latticeMesh(9, 9, 10, [](double x, double y) { return 0.1 * x + 0.05 * y; });
  for (const auto& p : mesh.points) {
    mesh.colours.push_back({static_cast<std::uint8_t>(2 * p[0]), 50, 60, 255});
  }
  SurfaceOptions options = fromTop();
  const Surface surface = makeSurface(mesh, options, rasterize);
  const GridFrame& f = surface.map.frame;
  // At the corners their own bytes; the map's lower left sample lies half a cell off its edge.
  for (int i = 0; i <= 8; ++i) {
    const Rgba made = surface.colours[0].colour(f.size.index({.col = 20 * i, .row = 40}));
    EXPECT_NEAR(made[0], 20 * i, 1) << i;
    EXPECT_EQ(made[3], 255);
  }
}

TEST(ColourMemory, IsCountedBeforeTheWork) {
  const GridSize size{.cols = 10000, .rows = 10000};
  EXPECT_EQ(colourBytes(size, false, false), 0U);
  const std::uint64_t both = colourBytes(size, true, true);
  EXPECT_GT(both, colourBytes(size, true, false));
  const GridFrame frame{.size = size, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0};
  EXPECT_NO_THROW(requireMemory(frame, surfaceBytes(size)));
  EXPECT_THROW(requireMemory(frame, surfaceBytes(size), both), ArgumentError);
}

}  // namespace
}  // namespace relievo
