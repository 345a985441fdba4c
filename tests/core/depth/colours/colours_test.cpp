// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/base/error.h"
#include "core/depth/colours/colour_fill.h"
#include "core/depth/colours/linear_light.h"
#include "core/depth/rules/rasterize.h"
#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

constexpr Rgba kBlack{0, 0, 0, 255};
constexpr Rgba kWhite{255, 255, 255, 255};
constexpr Rgba kRed{255, 0, 0, 255};
constexpr Rgba kBlue{0, 0, 255, 255};
constexpr Rgba kNothing{};

GridFrame frameOf(int cols, int rows, double spacing = 1) {
  return {.size = {.cols = cols, .rows = rows},
          .spacing_mm = spacing,
          .first_x_mm = 0,
          .first_y_mm = 0};
}

/// All measured, at height `z_mm`.
DepthMap flatMap(const GridFrame& frame, float z_mm = 0) {
  DepthMap map{.frame = frame, .heights_mm = {}, .origins = {}};
  map.heights_mm.assign(frame.size.count(), z_mm);
  map.origins.assign(frame.size.count(), CellStatus::measured);
  return map;
}

void add(Scan& scan, double x, double y, double z, const Rgba& colour) {
  scan.points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  scan.colours.push_back(colour);
}

GridColours coloursOf(const Scan& scan, const DepthMap& map, ColourRule rule = ColourRule::layer,
                      int threads = 1) {
  return gridColours({.scan = scan, .view_from_file = {}, .frame = map.frame, .threads = threads},
                     map, rule);
}

/// Squares of eight samples, red and blue in turn.
const Rgba& board(int col, int row) {
  return (col / 8 + row / 8) % 2 == 0 ? kRed : kBlue;
}

/// Points anywhere in the cells of a board, `per_cell` each, on a slope.
Scan boardCloud(const GridFrame& frame, int per_cell, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> within(-0.49, 0.49);
  Scan scan;
  for (int i = 0; i < per_cell; ++i) {
    for (int row = 0; row < frame.size.rows; ++row) {
      for (int col = 0; col < frame.size.cols; ++col) {
        const double x = col + within(random);
        const double y = row + within(random);
        add(scan, x, y, 0.5 * x, board(col, row));
      }
    }
  }
  test::finishScan(scan);
  return scan;
}

DepthMap slopeMap(const GridFrame& frame) {
  DepthMap map = flatMap(frame);
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    map.heights_mm[i] = 0.5F * static_cast<float>(i % static_cast<std::size_t>(frame.size.cols));
  }
  return map;
}

TEST(LinearLight, EveryStoredByteComesBackAndTheMeanOfBlackAndWhiteIs188) {
  for (const Transfer* transfer : {&sRgb(), &proportional()}) {
    for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(transfer->stored[transfer->light[i]], i);
  }
  EXPECT_EQ(sRgb().storedOf(0.5F * Transfer::kMost), 188);
  EXPECT_EQ(proportional().storedOf(0.5F * Transfer::kMost), 128);
  EXPECT_EQ(sRgb().storedOf(-1), 0);
  EXPECT_EQ(sRgb().storedOf(1e9F), 255);
  EXPECT_EQ(sRgb().storedOf(std::nanf("")), 0);
}

TEST(Colours, ABoardComesThroughACloudAsItIs) {
  const GridFrame frame = frameOf(40, 24);
  const DepthMap map = slopeMap(frame);
  for (const ColourRule rule : {ColourRule::layer, ColourRule::winner}) {
    const GridColours made = coloursOf(boardCloud(frame, 3, 7), map, rule);
    ASSERT_EQ(made.colours.size(), frame.size.count());
    EXPECT_TRUE(made.intensities.empty());
    for (int row = 0; row < frame.size.rows; ++row) {
      for (int col = 0; col < frame.size.cols; ++col) {
        const std::size_t i = frame.size.index({.col = col, .row = row});
        ASSERT_EQ(made.colours[i], board(col, row)) << col << ' ' << row;
      }
    }
  }
}

TEST(Colours, TheMeanOfACellIsTakenInLinearLight) {
  Scan scan;
  add(scan, 0.1, 0, 0, kBlack);
  add(scan, -0.1, 0, 0, kWhite);
  add(scan, 1, 1, 0, kWhite);
  const GridColours made = coloursOf(scan, flatMap(frameOf(2, 2)));
  EXPECT_EQ(made.colours[0], (Rgba{188, 188, 188, 255}));
}

TEST(Colours, ARedPointBehindABlueFrontAndAnOutlierBeforeItLeaveNoTrace) {
  for (const ColourRule rule : {ColourRule::layer, ColourRule::winner}) {
    Scan scan;
    add(scan, 0, 0, -2, kRed);
    add(scan, 0, 0, 0, kBlue);
    add(scan, 0, 0, 40, kRed);
    add(scan, 1, 0, -1.6, kRed);  // Just behind the layer.
    add(scan, 1, 0, 0.2, kBlue);
    const GridColours made = coloursOf(scan, flatMap(frameOf(2, 2)), rule);
    EXPECT_EQ(made.colours[0], kBlue);
    EXPECT_EQ(made.colours[1], kBlue);
  }
}

TEST(Colours, FrontTakesTheWinnersWhereOthersTakeTheMean) {
  Scan scan;
  add(scan, 0, 0, -0.5, kRed);
  add(scan, 0, 0, 0, kBlue);
  add(scan, 0, 0, -0.5, kRed);
  const DepthMap map = flatMap(frameOf(2, 2));
  EXPECT_EQ(coloursOf(scan, map, ColourRule::winner).colours[0], kBlue);
  const Rgba mean = coloursOf(scan, map, ColourRule::layer).colours[0];
  const std::uint8_t third = sRgb().storedOf(Transfer::kMost / 3.0F);
  const std::uint8_t two_thirds = sRgb().storedOf(2 * Transfer::kMost / 3.0F);
  EXPECT_EQ(mean, (Rgba{two_thirds, 0, third, 255}));
}

TEST(Colours, OfEqualFrontsTheSameWinsInAnyOrder) {
  const DepthMap map = flatMap(frameOf(2, 2));
  Scan scan;
  Scan other;
  add(scan, 0, 0, 0, kRed);
  add(scan, 0, 0, 0, kBlue);
  add(other, 0, 0, 0, kBlue);
  add(other, 0, 0, 0, kRed);
  EXPECT_EQ(coloursOf(scan, map, ColourRule::winner), coloursOf(other, map, ColourRule::winner));
}

TEST(Colours, TheBytesAreTheSameForAnyNumberOfThreads) {
  const GridFrame frame = frameOf(61, 47);
  const DepthMap map = slopeMap(frame);
  Scan cloud = boardCloud(frame, 5, 3);
  std::mt19937 random(5);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    cloud.colours[i] = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                        static_cast<std::uint8_t>(random()), 255};
    cloud.intensities.push_back(static_cast<std::uint16_t>(random()));
  }
  for (const ColourRule rule : {ColourRule::layer, ColourRule::winner}) {
    const GridColours one = coloursOf(cloud, map, rule, 1);
    for (const int threads : {2, 3, 7}) EXPECT_EQ(coloursOf(cloud, map, rule, threads), one);
  }
}

TEST(Colours, HolesAndOutsideHaveNoneAndGapsAreBetweenTheirNeighbours) {
  const GridFrame frame = frameOf(16, 16);
  DepthMap map = flatMap(frame);
  Scan scan;
  const auto origin = [&](int col, int row) -> CellStatus& {
    return map.origins[frame.size.index({.col = col, .row = row})];
  };
  for (int col = 5; col < 9; ++col) origin(col, 5) = CellStatus::base_plane;
  origin(12, 3) = CellStatus::outside;
  origin(3, 12) = CellStatus::interpolated;
  for (int row = 0; row < 16; ++row) {
    for (int col = 0; col < 16; ++col) {
      // Also in the holes: what lies there did not make a height.
      if (origin(col, row) != CellStatus::interpolated) add(scan, col, row, 0, {10, 200, 30, 255});
    }
  }
  const GridColours made = coloursOf(scan, map);
  const auto at = [&](int col, int row) {
    return made.colours[frame.size.index({.col = col, .row = row})];
  };
  EXPECT_EQ(at(6, 5), kNothing);
  EXPECT_EQ(at(12, 3), kNothing);
  EXPECT_EQ(at(3, 12), (Rgba{10, 200, 30, kBetweenAlpha}));
  EXPECT_EQ(at(4, 5), (Rgba{10, 200, 30, 255}));
}

TEST(Colours, AHoleThatIsFilledLaterGetsThoseAroundIt) {
  const GridFrame frame = frameOf(16, 16);
  DepthMap map = flatMap(frame);
  Scan scan;
  for (int row = 0; row < 16; ++row) {
    for (int col = 0; col < 16; ++col) add(scan, col, row, 0, {10, 200, 30, 255});
  }
  const std::size_t hole = frame.size.index({.col = 7, .row = 7});
  map.origins[hole] = CellStatus::base_plane;
  GridColours made = coloursOf(scan, map);
  ASSERT_EQ(made.colours[hole], kNothing);
  fillColours(made, map, {});
  EXPECT_EQ(made.colours[hole], kNothing) << "still a hole";
  map.origins[hole] = CellStatus::interpolated;
  fillColours(made, map, {});
  EXPECT_EQ(made.colours[hole], (Rgba{10, 200, 30, kBetweenAlpha}));
}

TEST(Colours, ARimIsCoveredOneSampleWide) {
  const GridSize size{.cols = 5, .rows = 1};
  const std::vector<CellStatus> origins{CellStatus::measured, CellStatus::outside,
                                        CellStatus::outside, CellStatus::base_plane,
                                        CellStatus::measured};
  GridColours colours;
  colours.colours = {kRed, kNothing, kNothing, kNothing, kBlue};
  coverRim(colours, origins, size);
  EXPECT_EQ(colours.colours, (std::vector<Rgba>{kRed, kRed, kNothing, kNothing, kBlue}));
}

TEST(Colours, MeasuredCellsFarFromAnyColourStayWithout) {
  const GridFrame frame = frameOf(64, 64);
  Scan scan;
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col) {
      add(scan, col, row, 0, col < 8 ? kRed : Rgba{9, 9, 9, 0});  // Alpha 0: no colour here.
    }
  }
  const GridColours made = coloursOf(scan, flatMap(frame));
  EXPECT_EQ(made.colours[frame.size.index({.col = 7, .row = 30})], kRed);
  EXPECT_EQ(made.colours[frame.size.index({.col = 40, .row = 30})], kNothing);
}

TEST(Colours, AScanThatSaysNoneHasNone) {
  Scan scan;
  add(scan, 0, 0, 0, {9, 9, 9, 0});
  add(scan, 1, 1, 0, {9, 9, 9, 0});
  EXPECT_FALSE(hasColours(scan));
  EXPECT_TRUE(coloursOf(scan, flatMap(frameOf(2, 2))).empty());
  scan.colours.clear();
  EXPECT_FALSE(hasColours(scan));
  EXPECT_TRUE(coloursOf(scan, flatMap(frameOf(2, 2))).empty());
}

TEST(Colours, IntensitiesSpreadTheirMiddleOverGrey) {
  Scan scan;
  for (int i = 0; i < 1000; ++i) {
    add(scan, i % 10, 0, 0, kRed);
    scan.intensities.push_back(static_cast<std::uint16_t>(1000 + i % 10));
  }
  scan.intensities[0] = 65535;  // One glint must not make all else black.
  scan.info.intensity = IntensityRange{.low = 0, .high = 65535};
  const GridColours made = coloursOf(scan, flatMap(frameOf(10, 2)));
  ASSERT_EQ(made.intensities.size(), 20U);
  EXPECT_EQ(shownIntensities(scan).low, 1000);
  EXPECT_EQ(shownIntensities(scan).high, 1009);
  EXPECT_EQ(made.intensities[1][0], 28);  // One of nine steps.
  EXPECT_EQ(made.intensities[9], (GreyAlpha{255, 255}));
  scan.intensities.assign(scan.points.size(), 77);
  const std::uint8_t grey = coloursOf(scan, flatMap(frameOf(10, 2))).intensities[3][0];
  EXPECT_NEAR(grey, 128, 1);
}

/// Two triangles over the square 0 ... side.
Scan square(double side, double z) {
  Scan scan;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {side, 0.0}, {0.0, side}, {side, side}}) {
    scan.points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  }
  scan.triangles = {{0, 1, 2}, {1, 3, 2}};
  test::finishScan(scan);
  return scan;
}

TEST(Colours, AMeshIsColouredBetweenItsCornersInLinearLight) {
  Scan mesh = square(20, 3);
  mesh.colours = {kBlack, kWhite, kBlack, kWhite};
  const GridFrame frame = frameOf(21, 21);
  const GridColours made = coloursOf(mesh, flatMap(frame, 3));
  for (int col = 0; col <= 20; ++col) {
    const std::uint8_t expected = sRgb().storedOf(Transfer::kMost * static_cast<float>(col) / 20);
    const Rgba colour = made.colours[frame.size.index({.col = col, .row = 7})];
    EXPECT_NEAR(colour[0], expected, 1) << col;
    EXPECT_EQ(colour[3], 255);
  }
}

TEST(Colours, TheFrontMostTriangleGivesTheColour) {
  Scan mesh = square(20, 3);
  mesh.colours.assign(4, kBlue);
  const Scan back = square(20, 2.5);  // Nearer than the layer's depth, and last.
  for (const auto& p : back.points) mesh.points.push_back(p);
  for (const auto& t : back.triangles) mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  mesh.colours.resize(8, kRed);
  const GridFrame frame = frameOf(21, 21);
  for (const Rgba& colour : coloursOf(mesh, flatMap(frame, 3)).colours) ASSERT_EQ(colour, kBlue);
  EXPECT_EQ(coloursOf(mesh, flatMap(frame, 3), ColourRule::layer, 3),
            coloursOf(mesh, flatMap(frame, 3)));
}

/// A texture of texels that are black and white in turn, once over the square.
Scan texturedSquare(double side, std::uint32_t texels) {
  Scan mesh = square(side, 0);
  Texture texture{.cols = texels, .rows = texels, .texels = {}};
  for (std::uint32_t row = 0; row < texels; ++row) {
    for (std::uint32_t col = 0; col < texels; ++col) {
      texture.texels.push_back((row + col) % 2 == 0 ? kBlack : kWhite);
    }
  }
  mesh.textures.push_back(std::move(texture));
  mesh.texture_of = {0, 0};
  mesh.texture_corners = {TextureCorners{{{0, 0}, {1, 0}, {0, 1}}},
                          TextureCorners{{{1, 0}, {1, 1}, {0, 1}}}};
  return mesh;
}

TEST(Colours, ATextureFinerThanTheCellsIsItsMeanAndDoesNotSparkle) {
  const GridFrame frame = frameOf(33, 33);
  for (const std::uint32_t texels : {64U, 512U, 500U}) {
    const GridColours made = coloursOf(texturedSquare(32, texels), flatMap(frame));
    ASSERT_FALSE(made.colours.empty());
    for (const Rgba& colour : made.colours) ASSERT_NEAR(colour[0], 188, 1) << texels;
  }
}

TEST(Colours, ATextureAsFineAsTheCellsComesBackTexelByTexel) {
  // Texel i is centred on i + 0.5; so are the samples.
  GridFrame frame = frameOf(32, 32);
  frame.first_x_mm = frame.first_y_mm = 0.5;
  const GridColours made = coloursOf(texturedSquare(32, 32), flatMap(frame));
  for (int row = 0; row < 32; ++row) {
    for (int col = 0; col < 32; ++col) {
      // Rows of a texture begin at the top, those of a map at the bottom.
      const Rgba& expected = (31 - row + col) % 2 == 0 ? kBlack : kWhite;
      ASSERT_EQ(made.colours[frame.size.index({.col = col, .row = row})], expected)
          << col << ' ' << row;
    }
  }
}

TEST(Colours, ABrokenTextureHasNoColoursAndStopsNothing) {
  const GridFrame frame = frameOf(33, 33);
  Scan mesh = texturedSquare(32, 64);
  mesh.texture_corners[0][1][0] = std::nanf("");
  mesh.texture_corners[1][1][1] = 1e30F;
  EXPECT_NO_THROW(coloursOf(mesh, flatMap(frame)));
  mesh.textures[0].texels.resize(7);
  EXPECT_TRUE(coloursOf(mesh, flatMap(frame)).empty());
  mesh.texture_of = {4, kNoTexture};
  EXPECT_FALSE(hasColours(mesh));
}

TEST(Colours, CancellingEndsThePass) {
  std::stop_source stop;
  stop.request_stop();
  const Scan scan = boardCloud(frameOf(8, 8), 1, 1);
  const DepthMap map = slopeMap(frameOf(8, 8));
  EXPECT_THROW(gridColours({.scan = scan, .view_from_file = {}, .frame = map.frame}, map,
                           ColourRule::layer, {.stop = stop.get_token(), .progress = {}}),
               Cancelled);
}

}  // namespace
}  // namespace relievo
