// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/closed_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/depth/rules/rasterize.h"
#include "core/session/large/large_map.h"
#include "core/session/surface.h"
#include "core/tiles/tiled_map.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/scan_fixtures.h"
#include "tests/core/sphere_figure.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo {
namespace {

using test::FigureFront;
using test::FigureSampling;
using test::sampledFigure;
using test::sphereFigure;

SurfaceOptions seenFrom(const std::string& view) {
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{.name = view, .rotation = {}};
  return options;
}

/// Shares of the cells that the figure covers with two cells around them.
struct Found {
  double pits = 0, bumps = 0, lost = 0, beyond = 0;
  double rms_spacings = 0;
  int cells = 0;
};

Found heldAgainst(const Surface& surface, const std::string& view) {
  const FigureFront truth(sphereFigure(), *standardRotation(view));
  const GridFrame& frame = surface.map.frame;
  const auto& m = surface.view_from_file.m;
  // The view's own frame is the rotation plus a shift.
  const auto at = [&](int col, int row) {
    const auto z = truth.at(frame.xMm(col) - m[3], frame.yMm(row) - m[7]);
    return z ? std::optional(*z + m[11]) : std::nullopt;
  };
  const double size = frame.spacing_mm * std::max(frame.size.cols, frame.size.rows);
  Found found;
  double squares = 0;
  int compared = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const std::size_t i = frame.size.index({.col = col, .row = row});
      const CellStatus origin = surface.map.origins[i];
      const bool is_there = origin != CellStatus::outside && origin != CellStatus::base_plane;
      double low = 1e300;
      double high = -1e300;
      bool inside = true;
      bool is_near = false;
      for (int r = row - 2; r <= row + 2; ++r) {
        for (int c = col - 2; c <= col + 2; ++c) {
          const auto z = at(c, r);
          inside = inside && z.has_value();
          is_near = is_near || z.has_value();
          low = std::min(low, z.value_or(low));
          high = std::max(high, z.value_or(high));
        }
      }
      found.beyond += is_there && !is_near ? 1 : 0;
      if (!inside) continue;
      ++found.cells;
      found.lost += is_there ? 0 : 1;
      if (!is_there) continue;
      const auto height = static_cast<double>(surface.map.heights_mm[i]);
      const bool is_pit = height < low - 0.03 * size;
      const bool is_bump = height > high + 0.03 * size;
      found.pits += is_pit ? 1 : 0;
      found.bumps += is_bump ? 1 : 0;
      if (is_pit || is_bump || high - low > 8 * frame.spacing_mm) continue;
      squares += (height - *at(col, row)) * (height - *at(col, row));
      ++compared;
    }
  }
  found.rms_spacings = std::sqrt(squares / compared) / frame.spacing_mm;
  return found;
}

void expectWhole(const Surface& surface, const std::string& view, const std::string& what) {
  const Found found = heldAgainst(surface, view);
  SCOPED_TRACE(what + " from the " + view);
  ASSERT_GT(found.cells, 1000);
  EXPECT_LE(found.pits, 0.001 * found.cells);
  EXPECT_LE(found.bumps, 0.002 * found.cells);
  EXPECT_LE(found.lost, 0.005 * found.cells);
  EXPECT_LE(found.rms_spacings, 0.6);
}

TEST(ClosedCloud, HasNoPitsSeenFromAnySide) {
  const Scan scan = sampledFigure(sphereFigure(), {}, 1);
  for (const char* view : {"front", "back", "left", "right", "top", "bottom"}) {
    const Surface surface = makeSurface(scan, seenFrom(view), rasterize);
    expectWhole(surface, view, "Even");
    EXPECT_LE(heldAgainst(surface, view).beyond, 2) << view;
    // Half of a closed body and more is behind.
    EXPECT_GT(surface.losses->hidden_share, 0.45) << view;
  }
}

TEST(ClosedCloud, BearsNoiseUnevenDensityAndStrays) {
  const auto spheres = sphereFigure();
  expectWhole(
      makeSurface(sampledFigure(spheres, {.noise_mm = 0.12}, 2), seenFrom("front"), rasterize),
      "front", "Noisy");
  expectWhole(
      makeSurface(sampledFigure(spheres, {.unevenness = 10}, 3), seenFrom("right"), rasterize),
      "right", "Uneven");
  const Surface strayed =
      makeSurface(sampledFigure(spheres, {.strays = 0.01}, 4), seenFrom("front"), rasterize);
  expectWhole(strayed, "front", "With strays");
  EXPECT_GT(strayed.losses->outliers, 0U);
}

/// A capsule of 100 mm, 15 mm thick each way, that lies level and across the axes.
constexpr double kCapsuleMm = 15;
constexpr double kHalfAxisMm = 35;
const std::array<double, 2> kCapsuleAxis{std::cos(0.4), std::sin(0.4)};

Scan noisyCapsule(std::size_t count, double noise_mm) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::normal_distribution<double> normal(0, 1);
  Scan scan;
  while (scan.points.size() < count) {
    std::array<double, 3> way{normal(random), normal(random), normal(random)};
    // Both ends have as much surface as a ball, the part between them 70 of 30 times that.
    const bool is_end = 100 * (unit(random) + 1) / 2 < 30;
    if (!is_end) way[0] = 0;
    const double length = std::hypot(way[0], way[1], way[2]);
    for (double& value : way) value *= kCapsuleMm / length;
    way[0] += is_end ? std::copysign(kHalfAxisMm, way[0]) : kHalfAxisMm * unit(random);
    for (double& value : way) value += noise_mm * normal(random);
    const auto& [c, s] = kCapsuleAxis;
    scan.points.push_back({static_cast<float>(c * way[0] - s * way[1]),
                           static_cast<float>(s * way[0] + c * way[1]),
                           static_cast<float>(way[2])});
  }
  test::finishScan(scan);
  return scan;
}

// Of points far off by their noise thinning leaves more than of the surface: those before it must
// not hide it.
TEST(ClosedCloud, CellsOfADenseNoisyCloudAreMeasured) {
  const Surface surface = makeSurface(noisyCapsule(1'000'000, 0.1), seenFrom("top"), rasterize);
  const OriginCounts cells = originCounts(surface.map);
  const auto of = [&cells](CellStatus status) { return cells[static_cast<std::size_t>(status)]; };
  ASSERT_GT(of(CellStatus::measured), 50'000U);
  EXPECT_LT(of(CellStatus::interpolated), of(CellStatus::measured) / 20);
}

TEST(ClosedCloud, NoiseMakesNoCellSteep) {
  const Surface surface = makeSurface(noisyCapsule(200'000, 0.2), seenFrom("top"), rasterize);
  const GridFrame& frame = surface.map.frame;
  int gentle = 0;
  int steep = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const double x = frame.xMm(col) - surface.view_from_file.m[3];
      const double y = frame.yMm(row) - surface.view_from_file.m[7];
      const double along = kCapsuleAxis[0] * x + kCapsuleAxis[1] * y;
      const double across = kCapsuleAxis[0] * y - kCapsuleAxis[1] * x;
      const double off = std::hypot(across, std::max(std::abs(along) - kHalfAxisMm, 0.0));
      if (off > kCapsuleMm * std::sin(std::atan(5.0))) continue;  // Steeper than 79 degrees.
      ++gentle;
      const CellStatus origin = surface.map.origins[frame.size.index({.col = col, .row = row})];
      steep += origin == CellStatus::steep ? 1 : 0;
    }
  }
  ASSERT_GT(gentle, 3000);
  EXPECT_LE(steep, gentle / 1000) << gentle;
}

TEST(ClosedCloud, TheGridIsThatOfThePointsThatAreSeen) {
  const Scan scan = sampledFigure(sphereFigure(), {}, 1);
  const Surface surface = makeSurface(scan, seenFrom("front"), rasterize);
  std::size_t points = 0;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < surface.map.origins.size(); ++i) {
    points += surface.quality.counts[i];
    cells += surface.map.origins[i] == CellStatus::outside ? 0 : 1;
  }
  // 1.5 points a cell are wanted; the back, too, would make 3 and more of it.
  EXPECT_NEAR(static_cast<double>(points) / static_cast<double>(cells), 1.5, 0.3);
}

/// A plate of 60 x 60 mm at 40 mm over ground of 100 x 100 mm at 0.
std::optional<FrontSurface> plateOverGround(int count = 40'000, double noise_mm = 0) {
  std::vector<ViewMm> points;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 100);
  std::normal_distribution<double> normal(0, 1);
  const auto noise = [&] { return noise_mm > 0 ? noise_mm * normal(random) : 0; };
  for (int i = 0; i < count; ++i) {
    const ViewMm p{place(random), place(random), 0};
    const bool is_under = std::max(std::abs(p.x - 50), std::abs(p.y - 50)) < 30;
    points.push_back({p.x + noise(), p.y + noise(), (is_under && i % 2 == 0 ? 40.0 : 0) + noise()});
  }
  return frontOf([&](const auto& take) { take(points); }, points,
                 {.min = {0, 0, 0}, .max = {100, 100, 40}}, points.size(), {});
}

TEST(ClosedCloud, ACellIsWhatTheFrontIsThere) {
  const auto front = plateOverGround();
  ASSERT_TRUE(front);
  const GridFrame frame{.size = {.cols = 51, .rows = 51}, .spacing_mm = 2};
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  CapturedDepths depths;
  depths.front.assign(frame.size.count(), 40);
  depths.steep.assign(frame.size.count(), 1);
  const auto at = [&](int col, int row) { return frame.size.index({.col = col, .row = row}); };
  depths.front[at(12, 25)] = 0;    // On the plate, by points of the ground beside its edge.
  depths.front[at(25, 25)] = nan;  // Without points.
  depths.front[at(4, 25)] = 0;     // On the ground.
  depths.front[at(26, 25)] = 39.9F;
  addFront(*front, frame, depths);
  EXPECT_TRUE(std::isnan(depths.front[at(12, 25)]));
  EXPECT_NEAR(depths.between[at(12, 25)], 40, 1e-3);
  EXPECT_NEAR(depths.between[at(25, 25)], 40, 1e-3);
  EXPECT_EQ(depths.front[at(4, 25)], 0);
  EXPECT_EQ(depths.front[at(26, 25)], 39.9F);
  // Flat in the middle and on the ground, a step at the edge at 20 mm.
  EXPECT_EQ(depths.steep[at(25, 25)], 0);
  EXPECT_EQ(depths.steep[at(4, 25)], 0);
  EXPECT_EQ(depths.steep[at(10, 25)], 1);
}

// By its noise the plate seems to end a little before its edge.
TEST(ClosedCloud, ACellBesideAStepIsNotSteepByNoise) {
  const auto front = plateOverGround(400'000, 0.3);
  ASSERT_TRUE(front);
  EXPECT_GT(front->noiseMm(), 0.03);
  const GridFrame frame{.size = {.cols = 221, .rows = 221}, .spacing_mm = 100.0 / 220};
  CapturedDepths depths;
  depths.front.assign(frame.size.count(), 40);
  depths.steep.assign(frame.size.count(), 1);
  addFront(*front, frame, depths);
  int beside = 0;
  int steep = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const double off =
          std::max(std::abs(frame.spacing_mm * col - 50), std::abs(frame.spacing_mm * row - 50));
      const double inside = (30 - off) / frame.spacing_mm;
      if (inside < 0 || inside > 0.5) continue;
      ++beside;
      steep += depths.steep[frame.size.index({.col = col, .row = row})];
    }
  }
  ASSERT_GT(beside, 500);
  EXPECT_LT(steep, beside / 8) << beside;
}

TEST(ClosedCloud, NoiseAsksForACoarserGrid) {
  const auto front = plateOverGround();
  ASSERT_TRUE(front);
  const RotatedBounds box{.min = {0, 0, 0}, .max = {100, 100, 40}};
  // 10 000 points 1 mm apart: 1.5 of them a cell; with 2 mm of noise 5, whose mean errs by 0.4 of
  // its cell's 2.2 mm.
  EXPECT_NEAR(cellsOf(*front, box, 10'000, 0).cells, 100 / std::sqrt(1.5) + 1, 2);
  EXPECT_NEAR(cellsOf(*front, box, 10'000, 2).cells, 100 / std::sqrt(5.0) + 1, 1);
}

TEST(ClosedCloud, TheNoiseOfTheFrontIsThatOfItsPoints) {
  const auto front = plateOverGround();
  ASSERT_TRUE(front);
  std::mt19937 random(12);
  std::uniform_real_distribution<double> place(25, 75);
  std::normal_distribution<double> noise(40, 0.5);
  std::vector<ViewMm> points(10'000);
  for (ViewMm& p : points) p = {place(random), place(random), noise(random)};
  const auto at = [&](std::size_t i) { return points[i]; };
  EXPECT_NEAR(noiseOnFront(*front, points.size(), at), 0.5, 0.02);
  EXPECT_EQ(noiseOnFront(*front, 0, at), 0);
}

TEST(ClosedCloud, PointsAreSeenHiddenOrStray) {
  const auto spheres = sphereFigure();
  Scan scan = sampledFigure(spheres, {}, 5);
  const Rotation front = *standardRotation("front");
  scan.points.push_back({0, -75, 0});  // Alone before the trunk.
  const RotatedBounds box = rotatedBounds(scan, front, 1);
  const auto closed = closedCloud(scan, front, 1, box, {});
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->visible.points.size() + closed->hidden + closed->strays, scan.points.size());
  EXPECT_GE(closed->strays, 1U);
  EXPECT_LE(closed->strays, 150U);  // Half a per cent of good points at most.
  const FigureFront truth(spheres, front);
  std::size_t wrong = 0;
  for (const auto& p : closed->visible.points) {
    const auto x = static_cast<double>(p[0]);
    const auto z = truth.at(x, static_cast<double>(p[2]));
    // Behind by more than a few spacings is behind; at a silhouette the front falls steeply.
    wrong += !z || -static_cast<double>(p[1]) < *z - 12 ? 1 : 0;
  }
  EXPECT_LE(wrong, closed->visible.points.size() / 50);
}

TEST(ClosedCloud, AMeshAndAReliefOfOneLayerAreNone) {
  Scan relief;
  std::mt19937 random(6);
  std::uniform_real_distribution<float> place(0, 100);
  for (int i = 0; i < 20'000; ++i) {
    const float x = place(random);
    const float y = place(random);
    // A terrace: steps of 20 mm, whose groups lie side by side.
    relief.points.push_back({x, y, 20 * std::floor(x / 25) + std::sin(y / 5)});
  }
  const Rotation top = *standardRotation("top");
  EXPECT_FALSE(closedCloud(relief, top, 1, rotatedBounds(relief, top, 1), {}));
  Scan mesh = sampledFigure(sphereFigure(), {.points = 1000}, 7);
  mesh.triangles.push_back({0, 1, 2});
  EXPECT_FALSE(closedCloud(mesh, top, 1, rotatedBounds(mesh, top, 1), {}));
}

TEST(ClosedCloud, AMapByTilesMakesTheSameDecisionToTheBit) {
  // Whole numbers of 1/512 mm: the sums of both ways are exact.
  constexpr double kScale = 1.0 / 512;
  test::Las las;
  las.scale = {kScale, kScale, kScale};
  Scan scan;
  for (const auto& p :
       sampledFigure(sphereFigure(), {.points = 60'000, .strays = 0.002}, 9).points) {
    std::array<std::int32_t, 3> raw{};
    for (std::size_t k = 0; k < 3; ++k) {
      raw[k] = static_cast<std::int32_t>(std::lround(static_cast<double>(p[k]) / kScale));
    }
    las.raw.push_back(raw);
    scan.points.push_back({static_cast<float>(raw[0] * kScale), static_cast<float>(raw[1] * kScale),
                           static_cast<float>(raw[2] * kScale)});
  }
  las.promised = las.legacy_promised = static_cast<std::uint32_t>(las.raw.size());
  test::finishScan(scan);
  const test::TileFolder folder;
  std::ofstream(folder / "figure.las", std::ios::binary) << test::lasFile(las);
  SurfaceOptions options = seenFrom("front");
  options.spacing_mm = 0.25;
  options.rule = PointRule::median;
  const LargeMap large = makeLargeMap(
      folder / "figure.las", options,
      {.file = folder / "map.tif", .memory_bytes = 165'000'000, .threads = 2, .on_view = {}});
  const Surface whole = makeSurface(scan, options, rasterize);
  EXPECT_EQ(large.frames[0], whole.map.frame);
  EXPECT_EQ(large.losses->hidden_share, whole.losses->hidden_share);
  EXPECT_EQ(large.losses->outliers, whole.losses->outliers);
  const TiledMap tiled(folder / "map.tif");
  EXPECT_TRUE(std::ranges::equal(tiled.levelMap({0}).heights_mm, whole.map.heights_mm));
  EXPECT_EQ(tiled.levelMap({0}).origins, whole.map.origins);
}

TEST(ClosedCloud, AStopRequestEndsTheSearchForTheFront) {
  const Scan scan = sampledFigure(sphereFigure(), {}, 8);
  const Rotation front = *standardRotation("front");
  std::stop_source source;
  Task task;
  task.stop = source.get_token();
  task.progress = [&](std::string_view, double) { source.request_stop(); };
  EXPECT_THROW(closedCloud(scan, front, 1, rotatedBounds(scan, front, 1), task), Cancelled);
}

}  // namespace
}  // namespace relievo
