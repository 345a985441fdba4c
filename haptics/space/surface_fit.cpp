// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/space/surface_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "haptics/space/cell.h"

namespace relievo {

namespace {
constexpr std::size_t kCount = kWindowSamples;
using Line = std::array<double, kCount>;
using Flags = std::array<bool, kCount>;

enum class Bend : std::uint8_t { none, of_a_line, sharp };
using Bends = std::array<Bend, kCount>;

/// Where all else is straight, too weak bends for the rules below are edges, one or two side by
/// side: on either side of them lie two samples without bend, or one and a crease, or a crease.
/// Some bend must be missing.
void markFaintEdges(const Line& d2, Bends& bends) {
  const Bends first = bends;
  const auto mark = [&](std::size_t low, std::size_t high) {
    const double size = std::min(std::abs(d2[low]), std::abs(d2[high]));
    if (first[low] != Bend::none || first[high] != Bend::none || size < kLeastFaint) return;
    int quiet_samples = 0;
    const auto straight = [&](std::size_t next, std::size_t after) {
      if (first[next] == Bend::of_a_line) ++quiet_samples;  // It has some beside it.
      if (first[next] != Bend::none) return true;
      if (std::abs(d2[next]) > kQuiet * size) return false;
      ++quiet_samples;
      return first[after] != Bend::none || std::abs(d2[after]) <= kQuiet * size;
    };
    // At the window's border a line goes on as it ends.
    const bool straight_low = straight(low - 1, low > 1 ? low - 2 : 0);
    const bool straight_high = straight(high + 1, std::min(high + 2, kCount - 1));
    if (straight_low && straight_high && quiet_samples > 0) {
      bends[low] = bends[high] = Bend::of_a_line;
    }
  };
  for (std::size_t i = 1; i + 1 < kCount; ++i) {
    mark(i, i);
    if (i + 2 < kCount) mark(i, i + 1);
  }
}

/// Second differences measure a bend, fourth differences how far it stands out from its neighbours:
/// |d4| / 2 = |d2 - mean of both|.
Bends bendsOf(const Line& f) {
  Line d2{};
  for (std::size_t i = 1; i + 1 < kCount; ++i) d2[i] = f[i - 1] - 2 * f[i] + f[i + 1];
  d2[0] = d2[1];
  d2[kCount - 1] = d2[kCount - 2];
  Bends bends{};
  for (std::size_t i = 1; i + 1 < kCount; ++i) {
    const double size = std::abs(d2[i]);
    if (size < kLeastLine) continue;
    const double contrast = std::abs(d2[i] - 0.5 * (d2[i - 1] + d2[i + 1]));
    const auto quiet = [&](std::size_t k) { return std::abs(d2[k]) <= kQuiet * size; };
    if (size > kLeastCrease && contrast > std::max(kLeastCrease, kLeastContrast * size)) {
      bends[i] = Bend::sharp;
    } else if ((i >= 3 && quiet(i - 1) && quiet(i - 2)) ||
               (i + 3 < kCount && quiet(i + 1) && quiet(i + 2))) {
      bends[i] = Bend::of_a_line;
    }
  }
  // Beside a crease the other neighbour alone says what is smooth.
  const Bends first = bends;
  for (std::size_t i = 1; i + 1 < kCount; ++i) {
    const bool low = first[i - 1] == Bend::sharp, high = first[i + 1] == Bend::sharp;
    if (low == high && !low) continue;
    const double size = std::abs(d2[i]);
    const double other = low && high ? 0 : d2[low ? i + 1 : i - 1];
    const double contrast = std::abs(d2[i] - other);
    if (contrast > std::max(kLeastCrease, kLeastContrast * size) && size > kLeastCrease) {
      bends[i] = Bend::sharp;
    }
  }
  markFaintEdges(d2, bends);
  return bends;
}

/// Does a crease go on in this line of samples, straight or one sample aside?
bool goesOn(const Bends& bends, std::size_t i) {
  const std::size_t first = i > 0 ? i - 1 : 0, last = std::min(i + 1, kCount - 1);
  for (std::size_t k = first; k <= last; ++k) {
    if (bends[k] != Bend::none) return true;
  }
  return false;
}

/// Slopes of the C2 cubic spline through f[first .. last], without a break between the two.
/// Rows of the system: D[i-1] + 4 D[i] + D[i+1] = 3 (f[i+1] - f[i-1]) inside.
void splineSlopes(const Line& f, std::size_t first, std::size_t last, Line& slope) {
  const std::size_t cells = last - first;
  const auto rise = [&](std::size_t i) { return f[first + i + 1] - f[first + i]; };
  if (cells == 1) {
    slope[first] = slope[last] = rise(0);
    return;
  }
  Line diagonal{}, upper{}, right{};  // Thomas' algorithm; below the diagonal stands 1, 1 or 2.
  const bool knot_free = cells >= 3;  // Three cells or more: the end has no knot at its neighbour.
  diagonal[0] = 1;
  upper[0] = knot_free ? 2 : 1;
  right[0] = knot_free ? 0.5 * (5 * rise(0) + rise(1)) : 2 * rise(0);
  for (std::size_t i = 1; i <= cells; ++i) {
    const bool end = i == cells;
    const double lower = end && knot_free ? 2 : 1;
    const double centre = end ? 1 : 4;
    double b = 3 * (rise(i - 1) + (end ? 0 : rise(i)));
    if (end) {
      b = knot_free ? 0.5 * (5 * rise(i - 1) + rise(i - 2)) : 2 * rise(i - 1);
    }
    const double factor = lower / diagonal[i - 1];
    diagonal[i] = centre - factor * upper[i - 1];
    upper[i] = 1;
    right[i] = b - factor * right[i - 1];
  }
  slope[last] = right[cells] / diagonal[cells];
  for (std::size_t i = cells; i-- > 0;) {
    slope[first + i] = (right[i] - upper[i] * slope[first + i + 1]) / diagonal[i];
  }
}

/// Where a slope at a break comes from.
enum class Side : std::uint8_t { both, before, after, none };
using SidesOfLine = std::array<Side, kCount>;

/// Slopes along one line; at a break the mean of the two sides, or what `sides` says.
Line slopesAlong(const Line& f, const Flags& breaks, const SidesOfLine& sides) {
  Line slope{};
  double before_break = 0;
  std::size_t first = 0;
  for (std::size_t last = 1; last < kCount; ++last) {
    if (!breaks[last] && last + 1 < kCount) continue;
    splineSlopes(f, first, last, slope);
    if (breaks[first]) {
      const double after = slope[first], before = before_break;
      constexpr double kHalf = 0.5;
      slope[first] = sides[first] == Side::both     ? kHalf * (after + before)
                     : sides[first] == Side::before ? before
                     : sides[first] == Side::after  ? after
                                                    : 0;
    }
    before_break = slope[last];
    first = last;
  }
  return slope;
}

/// One row or column of the window: where its values and its breaks are.
struct Direction {
  std::size_t step, across;  // From sample to sample, from line to line.
  std::uint8_t mark;
};
constexpr Direction kAlongX{1, kCount, kBreakX}, kAlongY{kCount, 1, kBreakY};

Flags breaksOf(const HapticSpace& space, Direction d, std::size_t line) {
  Flags breaks{};
  for (std::size_t i = 0; i < kCount; ++i) {
    breaks[i] = (space.marks[line * d.across + i * d.step] & d.mark) != 0;
  }
  return breaks;
}

void markBreaks(HapticSpace& space, const std::vector<double>& heights, Direction d) {
  std::vector<Bends> bends(kCount);
  for (std::size_t line = 0; line < kCount; ++line) {
    Line f{};
    for (std::size_t i = 0; i < kCount; ++i) f[i] = heights[line * d.across + i * d.step];
    bends[line] = bendsOf(f);
  }
  for (std::size_t line = 0; line < kCount; ++line) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const Bend bend = bends[line][i];
      const bool breaks = bend == Bend::sharp ||
                          (bend == Bend::of_a_line && (line == 0 || goesOn(bends[line - 1], i)) &&
                           (line + 1 == kCount || goesOn(bends[line + 1], i)));
      if (breaks) space.marks[line * d.across + i * d.step] |= d.mark;
    }
  }
}

/// Values along one line.
Line lineOf(const std::vector<double>& values, Direction d, std::size_t line) {
  Line f{};
  for (std::size_t i = 0; i < kCount; ++i) f[i] = values[line * d.across + i * d.step];
  return f;
}

void keep(const Line& slope, Direction d, std::size_t line, std::vector<double>& result) {
  for (std::size_t i = 0; i < kCount; ++i) result[line * d.across + i * d.step] = slope[i];
}

/// Derivatives of the heights along a direction.
std::vector<double> slopes(const HapticSpace& space, const std::vector<double>& heights,
                           Direction d) {
  std::vector<double> result(kWindowCount);
  for (std::size_t line = 0; line < kCount; ++line) {
    keep(slopesAlong(lineOf(heights, d, line), breaksOf(space, d, line), {}), d, line, result);
  }
  return result;
}

/// Derivatives along x of the slopes in y. Where a wall ends, samples that break in y stand beside
/// others: their slopes are means of two sides, and a line through both would ring. It ends there
/// on either side.
std::vector<double> twists(const HapticSpace& space, const std::vector<double>& slope_y) {
  std::vector<double> result(kWindowCount);
  for (std::size_t row = 0; row < kCount; ++row) {
    Flags breaks = breaksOf(space, kAlongX, row);
    SidesOfLine sides{};
    const auto wall = [&](std::size_t i) {
      return (space.marks[row * kAlongX.across + i] & kBreakY) != 0;
    };
    for (std::size_t i = 1; i + 1 < kCount; ++i) {
      const bool before = wall(i - 1), after = wall(i + 1);
      breaks[i] = breaks[i] || wall(i) || before || after;
      if (before) sides[i] = after ? Side::none : Side::after;
      if (after && !before) sides[i] = Side::before;
    }
    keep(slopesAlong(lineOf(slope_y, kAlongX, row), breaks, sides), kAlongX, row, result);
  }
  return result;
}

void markSmoothCells(HapticSpace& space) {
  constexpr std::uint8_t kBreaks = kBreakX | kBreakY;
  for (int row = 0; row < kLastCell; ++row) {
    for (int col = 0; col < kLastCell; ++col) {
      const auto at = [&](int c, int r) { return space.marks[HapticSpace::index(c, r)]; };
      const int marks = at(col, row) | at(col + 1, row) | at(col, row + 1) | at(col + 1, row + 1);
      if ((marks & kBreaks) == 0) space.marks[HapticSpace::index(col, row)] |= kSmoothCell;
    }
  }
}

/// A bicubic patch lies in the hull of its Bezier points, a bilinear one in that of its corners.
float topOf(const Corners& corners, bool bilinear) {
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner& c = corners[i];
    top = std::max(top, c.f);
    if (bilinear) continue;
    const double x = (i % 2 == 0 ? 1 : -1) * c.fx / 3, y = (i / 2 == 0 ? 1 : -1) * c.fy / 3;
    const double xy = (i % 2 == i / 2 ? 1 : -1) * c.fxy / 9;
    top = std::max({top, c.f + x, c.f + y, c.f + x + y + xy});
  }
  // A little higher, for the rounding of both sides.
  top += 1e-9 + 1e-12 * std::abs(top);
  return std::nextafter(static_cast<float>(top), std::numeric_limits<float>::infinity());
}

void raiseTops(HapticSpace& space) {
  BlockTops& blocks = space.block_tops;
  constexpr float kLowest = std::numeric_limits<float>::lowest();
  blocks.coarse.fill(kLowest);
  blocks.middle.fill(kLowest);
  blocks.fine.fill(kLowest);
  const auto raise = [](float& top, float to) { top = std::max(top, to); };
  for (int row = 0; row < kLastCell; ++row) {
    for (int col = 0; col < kLastCell; ++col) {
      const float top = topOf(cornersOf(space, col, row), space.surface == SurfaceKind::bilinear);
      space.cell_tops[HapticSpace::index(col, row)] = top;
      raise(blocks.coarse[BlockTops::index(0, col, row)], top);
      raise(blocks.middle[BlockTops::index(1, col, row)], top);
      raise(blocks.fine[BlockTops::index(2, col, row)], top);
    }
  }
}
}  // namespace

void fitSurface(HapticSpace& space, SurfaceKind kind) {
  space.surface = kind;
  space.marks.fill(0);
  if (kind == SurfaceKind::bilinear) {  // Breaks everywhere: cells are ruled by straight lines.
    space.marks.fill(kBreakX | kBreakY);
    raiseTops(space);
    return;
  }
  std::vector<double> heights(kWindowCount);
  for (int row = 0; row < kWindowSamples; ++row) {
    for (int col = 0; col < kWindowSamples; ++col) {
      heights[HapticSpace::index(col, row)] = space.gridHeight(col, row);
    }
  }
  if (kind == SurfaceKind::crease_aware) {
    markBreaks(space, heights, kAlongX);
    markBreaks(space, heights, kAlongY);
  }
  markSmoothCells(space);
  const std::vector<double> slope_x = slopes(space, heights, kAlongX);
  const std::vector<double> slope_y = slopes(space, heights, kAlongY);
  const std::vector<double> twist = twists(space, slope_y);
  for (std::size_t i = 0; i < kWindowCount; ++i) {
    SurfaceSample& sample = space.samples[i];
    sample.slope_x = static_cast<float>(slope_x[i]);
    sample.slope_y = static_cast<float>(slope_y[i]);
    sample.twist = static_cast<float>(twist[i]);
  }
  raiseTops(space);
}

}  // namespace relievo
