// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/hidden_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/depth/fill/fill.h"

namespace relievo {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr int kCells = 400;
constexpr double kSpacingMm = 0.25;
constexpr double kBackMm = 14;  // Below the front.

GridFrame frame() {
  return {.size = {.cols = kCells, .rows = kCells},
          .spacing_mm = kSpacingMm,
          .first_x_mm = 0.5 * kSpacingMm,
          .first_y_mm = 0.5 * kSpacingMm};
}

double heightMm(double x, double y) {
  return 20 + 2 * std::sin(x / 8) * std::cos(y / 9);
}

/// Cells of a front, hit at random and more often at the right; where the front is not hit a cell
/// shows the back, if that is hit. `depth` says how far below the front the object really is there:
/// NaN for a hole through everything.
template <class Depth>
FrontDepths scanned(double points_per_cell, Depth&& depth) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> uniform(0, 1);
  FrontDepths depths(frame().size.count(), kNothing);
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) {
      const double here = points_per_cell * (0.6 + 0.8 * col / kCells);
      const bool hit = uniform(random) < 1 - std::exp(-here);
      const bool back_hit = uniform(random) < 1 - std::exp(-here);
      const double below = depth(col, row);
      if (std::isnan(below) || !(hit || back_hit)) continue;
      const double front = heightMm(frame().xMm(col), frame().yMm(row)) - below;
      depths[frame().size.index({.col = col, .row = row})] =
          static_cast<float>(hit ? front : front - std::max(0.0, kBackMm - below));
    }
  }
  return depths;
}

/// @param rim  cells around them that count, too
bool isHole(int col, int row, double rim = 0) {
  return std::hypot(col - 120, row - 240) < 24 + rim || std::hypot(col - 280, row - 120) < 16 + rim;
}

struct Found {
  double holes_kept = 0, gaps_closed = 0;
  double pits = 0;    ///< Share of the cells away from the holes that lie 1 mm too deep ...
  double rms_mm = 0;  ///< ... and of the others.
  std::size_t dropped = 0;
};

Found foundBy(double points_per_cell) {
  const FilledMap filled = fillDepths(
      scanned(points_per_cell, [](int col, int row) { return isHole(col, row) ? NAN : 0.0; }),
      frame(), {}, {});
  Found found{.dropped = filled.seen_through};
  double holes = 0;
  double others = 0;
  double cells = 0;
  double squares = 0;
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) {
      const Cell cell{.col = col, .row = row};
      const CellStatus origin = filled.map.origin(cell);
      if (isHole(col, row)) {
        holes += 1;
        found.holes_kept += origin == CellStatus::base_plane ? 1 : 0;
        continue;
      }
      others += 1;
      if (origin == CellStatus::base_plane || origin == CellStatus::outside) continue;
      found.gaps_closed += 1;
      // A notch in the rim of a hole is as likely to be the hole's.
      if (isHole(col, row, 4)) continue;
      const double off = static_cast<double>(filled.map.heightMm(cell)) + filled.base_z_mm -
                         heightMm(frame().xMm(col), frame().yMm(row));
      cells += 1;
      if (off < -1) {
        found.pits += 1;
      } else {
        squares += off * off;
      }
    }
  }
  found.rms_mm = std::sqrt(squares / cells);
  found.pits /= cells;
  found.holes_kept /= holes;
  found.gaps_closed /= others;
  return found;
}

TEST(DropSeenThrough, OnAClosedFormHardlyAPitStaysEveryGapIsClosedAndHolesKeepTheirArea) {
  for (const double points_per_cell : {1.6, 2.5, 4.0}) {
    const Found found = foundBy(points_per_cell);
    EXPECT_LT(found.pits, 0.001) << points_per_cell;
    EXPECT_GE(found.holes_kept, 0.94) << points_per_cell;
    EXPECT_GE(found.gaps_closed, 0.999) << points_per_cell;
    EXPECT_LE(found.rms_mm, 0.016) << points_per_cell;
    EXPECT_GT(found.dropped, 1000U) << points_per_cell;
  }
}

TEST(DropSeenThrough, ABarThinnerThanTheNeighbourhoodHasNoPitsEither) {
  // Five cells of front over a back that is open on both sides.
  const auto bar = [](int, int row) { return row % 40 < 5 ? 0.0 : kBackMm; };
  const FilledMap filled = fillDepths(scanned(2.5, bar), frame(), {}, {});
  std::size_t pits = 0;
  std::size_t cells = 0;
  for (int row = 0; row < kCells; ++row) {
    if (row % 40 < 1 || row % 40 > 3) continue;
    for (int col = 0; col < kCells; ++col) {
      const double off = static_cast<double>(filled.map.heightMm({.col = col, .row = row})) +
                         filled.base_z_mm - heightMm(frame().xMm(col), frame().yMm(row));
      ++cells;
      pits += off < -1 ? 1U : 0U;
    }
  }
  EXPECT_LT(static_cast<double>(pits), 0.01 * static_cast<double>(cells));
}

/// Share of the measured cells of a groove that stay measured.
double keptOfGroove(double points_per_cell, int width, bool oblique) {
  const auto is_groove = [&](int col, int row) {
    const int across = oblique ? (2 * col + row) % 120 : row % 50;
    return across >= 0 && across < (oblique ? 2 * width + 1 : width) && col > 20 && col < 380;
  };
  FrontDepths depths = scanned(points_per_cell, [&](int col, int row) {
    return is_groove(col, row) ? 3.0 : 0.0;  // 12 cells deep, its floor measured.
  });
  const FrontDepths before = depths;
  dropSeenThrough(depths, frame(), 2);
  double measured = 0;
  double kept = 0;
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) {
      const std::size_t i = frame().size.index({.col = col, .row = row});
      const double truth = heightMm(frame().xMm(col), frame().yMm(row)) - 3;
      if (!is_groove(col, row) || !(std::abs(static_cast<double>(before[i]) - truth) < 0.01)) {
        continue;
      }
      measured += 1;
      kept += std::isnan(depths[i]) ? 0 : 1;
    }
  }
  EXPECT_GT(measured, 1000);
  return kept / measured;
}

TEST(DropSeenThrough, GroovesOneAndTwoCellsWideThatWereMeasuredStay) {
  EXPECT_GT(keptOfGroove(4, 1, false), 0.98);
  EXPECT_GT(keptOfGroove(4, 2, false), 0.98);
  EXPECT_GT(keptOfGroove(2.5, 1, false), 0.93);
  EXPECT_GT(keptOfGroove(2.5, 2, false), 0.98);
  EXPECT_GT(keptOfGroove(2.5, 2, true), 0.95);
}

TEST(DropSeenThrough, AMeasuredBlindHoleStaysAndALoneDeepCellIsAGap) {
  FrontDepths depths(frame().size.count(), 20.0F);
  std::mt19937 random(3);
  for (float& z : depths) z = random() % 8 == 0 ? kNothing : z;  // 2.1 points a cell.
  const auto deepen = [&](int col0, int row0, int side) {
    for (int row = row0; row < row0 + side; ++row) {
      for (int col = col0; col < col0 + side; ++col) {
        depths[frame().size.index({.col = col, .row = row})] = 6;
      }
    }
  };
  deepen(100, 100, 4);
  deepen(200, 200, 1);
  dropSeenThrough(depths, frame(), 2);
  EXPECT_EQ(std::count(depths.begin(), depths.end(), 6.0F), 16);
  EXPECT_TRUE(std::isnan(depths[frame().size.index({.col = 200, .row = 200})]));
}

TEST(DropSeenThrough, WallsAndTheirFeetStayWhereTheyAre) {
  const auto wall = [](int col, int) { return col < 200 ? 0.0 : kBackMm; };
  for (const double points_per_cell : {2.5, 4.0}) {
    FrontDepths depths = scanned(points_per_cell, wall);
    const FrontDepths before = depths;
    dropSeenThrough(depths, frame(), 2);
    std::size_t eaten = 0;
    for (int row = 0; row < kCells; ++row) {
      const std::size_t foot = frame().size.index({.col = 200, .row = row});
      if (!std::isnan(before[foot]) && std::isnan(depths[foot])) ++eaten;
    }
    EXPECT_LT(eaten, 4U) << points_per_cell;
  }
}

TEST(DropSeenThrough, TheLowCornerOfASteepPlaneIsNoBack) {
  const GridFrame small{.size = {.cols = 20, .rows = 20}, .spacing_mm = 1};
  FrontDepths depths;
  for (int row = 0; row < small.size.rows; ++row) {
    for (int col = 0; col < small.size.cols; ++col) {
      depths.push_back(static_cast<float>(col + 2 * row));
    }
  }
  EXPECT_EQ(dropSeenThrough(depths, small, 1), 0U);
}

}  // namespace
}  // namespace relievo
