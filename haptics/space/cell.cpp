// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/space/cell.h"

namespace relievo {

namespace {
/// One step along x or y.
struct Along {
  int col = 0, row = 0;
};
constexpr Along kX{1, 0}, kY{0, 1};

/// The sample two steps from a corner that breaks along a direction, over the one that does not;
/// nothing if it breaks itself or lies beyond the window.
const SurfaceSample* sampleBeyond(const HapticSpace& space, int col, int row, Along way, int sign,
                                  std::uint8_t breaks) RELIEVO_REALTIME {
  const int far_col = col + 2 * sign * way.col, far_row = row + 2 * sign * way.row;
  if (far_col < 0 || far_row < 0 || far_col >= kWindowSamples || far_row >= kWindowSamples) {
    return nullptr;
  }
  const std::size_t i = HapticSpace::index(far_col, far_row);
  return (space.marks[i] & breaks) == 0 ? &space.samples[i] : nullptr;
}

/// Of an edge from a corner that breaks to one of value `near`.
EdgeBeyond beyond(double near, double far, double far_slope, int sign) RELIEVO_REALTIME {
  return {true, sign > 0 ? far - near : near - far, far_slope};
}
/// A cell of four corners, numbered by column, then row; some of them break along x or y.
struct BrokenCell {
  const HapticSpace& space;
  int col, row;
  std::array<bool, 4> along_x{}, along_y{};

  BrokenCell(const HapticSpace& of, int first_col, int first_row) RELIEVO_REALTIME
      : space(of),
        col(first_col),
        row(first_row) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint8_t mark = space.marks[HapticSpace::index(colOf(i), rowOf(i))];
      along_x[i] = (mark & kBreakX) != 0;
      along_y[i] = (mark & kBreakY) != 0;
    }
  }
  int colOf(std::size_t i) const RELIEVO_REALTIME { return col + static_cast<int>(i % 2); }
  int rowOf(std::size_t i) const RELIEVO_REALTIME { return row + static_cast<int>(i / 2); }
  double height(const SurfaceSample& sample) const RELIEVO_REALTIME {
    return (static_cast<double>(sample.height_mm) - space.mid_mm) * space.cells_per_mm;
  }
  const SurfaceSample* beyondCorner(std::size_t i, Along way, int sign,
                                    std::uint8_t breaks) const RELIEVO_REALTIME {
    return sampleBeyond(space, colOf(i), rowOf(i), way, sign, breaks);
  }
};

void slopeAlongX(const BrokenCell& cell, std::size_t low, Corners& c) RELIEVO_REALTIME {
  const std::array<bool, 4>& breaks = cell.along_x;
  const std::size_t high = low + 1, broken = breaks[low] ? low : high;
  const int sign = breaks[low] ? 1 : -1;
  EdgeBeyond past;
  if (breaks[low] != breaks[high]) {
    const SurfaceSample* far = cell.beyondCorner(broken, kX, sign, kBreakX);
    if (far != nullptr) past = beyond(c[broken ^ 1U].f, cell.height(*far), far->slope_x, sign);
  }
  const EdgeSlopes e =
      edgeSlopes(c[high].f - c[low].f, {c[low].fx, c[high].fx}, breaks[low], breaks[high], past);
  c[low].fx = e.first;
  c[high].fx = e.last;
}

void slopeAlongY(const BrokenCell& cell, std::size_t low, Corners& c) RELIEVO_REALTIME {
  const std::array<bool, 4>& breaks = cell.along_y;
  const std::size_t high = low + 2, broken = breaks[low] ? low : high;
  const int sign = breaks[low] ? 1 : -1;
  EdgeBeyond past;
  if (breaks[low] != breaks[high]) {
    const SurfaceSample* far = cell.beyondCorner(broken, kY, sign, kBreakY);
    if (far != nullptr) past = beyond(c[broken ^ 2U].f, cell.height(*far), far->slope_y, sign);
  }
  const EdgeSlopes e =
      edgeSlopes(c[high].f - c[low].f, {c[low].fy, c[high].fy}, breaks[low], breaks[high], past);
  c[low].fy = e.first;
  c[high].fy = e.last;
}

/// Twist of a corner that breaks along x only. @param straight  that of straight lines
double twistAlongX(const BrokenCell& cell, std::size_t i, const Corners& edges,
                   double straight) RELIEVO_REALTIME {
  const std::size_t beside = i ^ 1U;
  if (cell.along_x[beside] || cell.along_y[beside]) return straight;
  const int sign = i % 2 == 0 ? 1 : -1;
  const SurfaceSample* far = cell.beyondCorner(i, kX, sign, kBreakX | kBreakY);
  EdgeBeyond past;
  if (far != nullptr) past = beyond(edges[beside].fy, far->slope_y, far->twist, sign);
  const EdgeSlopes e =
      edgeSlopes(straight, {edges[beside].fxy, edges[beside].fxy}, i % 2 == 0, i % 2 != 0, past);
  return i % 2 == 0 ? e.first : e.last;
}

/// The same along y.
double twistAlongY(const BrokenCell& cell, std::size_t i, const Corners& edges,
                   double straight) RELIEVO_REALTIME {
  const std::size_t across = i ^ 2U;
  if (cell.along_y[across] || cell.along_x[across]) return straight;
  const int sign = i / 2 == 0 ? 1 : -1;
  const SurfaceSample* far = cell.beyondCorner(i, kY, sign, kBreakX | kBreakY);
  EdgeBeyond past;
  if (far != nullptr) past = beyond(edges[across].fx, far->slope_x, far->twist, sign);
  const EdgeSlopes e =
      edgeSlopes(straight, {edges[across].fxy, edges[across].fxy}, i / 2 == 0, i / 2 != 0, past);
  return i / 2 == 0 ? e.first : e.last;
}
}  // namespace

Corners brokenCorners(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  Corners c{smoothCorner(space, col, row), smoothCorner(space, col + 1, row),
            smoothCorner(space, col, row + 1), smoothCorner(space, col + 1, row + 1)};
  const BrokenCell cell(space, col, row);
  for (const std::size_t low : {0U, 2U}) slopeAlongX(cell, low, c);
  for (const std::size_t low : {0U, 1U}) slopeAlongY(cell, low, c);
  // Twists: a corner that breaks in one direction follows that direction's edge, with the same
  // rule; one that breaks in both takes the twist of straight lines.
  const Corners edges = c;
  for (std::size_t i = 0; i < 4; ++i) {
    const double sign_x = i % 2 == 0 ? 1 : -1, sign_y = i / 2 == 0 ? 1 : -1;
    const double along_x = sign_x * (edges[i ^ 1U].fy - edges[i].fy);
    const double along_y = sign_y * (edges[i ^ 2U].fx - edges[i].fx);
    if (cell.along_x[i] && cell.along_y[i]) {
      c[i].fxy = 0.5 * (along_x + along_y);
    } else if (cell.along_x[i]) {
      c[i].fxy = twistAlongX(cell, i, edges, along_x);
    } else if (cell.along_y[i]) {
      c[i].fxy = twistAlongY(cell, i, edges, along_y);
    }
  }
  return c;
}

}  // namespace relievo
