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
}  // namespace

Corners brokenCorners(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  Corners c{smoothCorner(space, col, row), smoothCorner(space, col + 1, row),
            smoothCorner(space, col, row + 1), smoothCorner(space, col + 1, row + 1)};
  std::array<bool, 4> break_x{}, break_y{};
  for (std::size_t i = 0; i < 4; ++i) {
    const int at_col = col + static_cast<int>(i % 2), at_row = row + static_cast<int>(i / 2);
    const std::uint8_t mark = space.marks[HapticSpace::index(at_col, at_row)];
    break_x[i] = (mark & kBreakX) != 0;
    break_y[i] = (mark & kBreakY) != 0;
  }
  const auto height = [&](const SurfaceSample& sample) RELIEVO_REALTIME {
    return (static_cast<double>(sample.height_mm) - space.mid_mm) * space.cells_per_mm;
  };
  const auto col_of = [&](std::size_t i) RELIEVO_REALTIME { return col + static_cast<int>(i % 2); };
  const auto row_of = [&](std::size_t i) RELIEVO_REALTIME { return row + static_cast<int>(i / 2); };
  // Slopes along the four edges.
  for (const std::size_t low : {0U, 2U}) {
    const std::size_t high = low + 1, broken = break_x[low] ? low : high;
    const int sign = break_x[low] ? 1 : -1;
    EdgeBeyond past;
    if (break_x[low] != break_x[high]) {
      const SurfaceSample* far =
          sampleBeyond(space, col_of(broken), row_of(broken), kX, sign, kBreakX);
      if (far != nullptr) past = beyond(c[broken ^ 1U].f, height(*far), far->slope_x, sign);
    }
    const EdgeSlopes e = edgeSlopes(c[high].f - c[low].f, {c[low].fx, c[high].fx}, break_x[low],
                                    break_x[high], past);
    c[low].fx = e.first;
    c[high].fx = e.last;
  }
  for (const std::size_t low : {0U, 1U}) {
    const std::size_t high = low + 2, broken = break_y[low] ? low : high;
    const int sign = break_y[low] ? 1 : -1;
    EdgeBeyond past;
    if (break_y[low] != break_y[high]) {
      const SurfaceSample* far =
          sampleBeyond(space, col_of(broken), row_of(broken), kY, sign, kBreakY);
      if (far != nullptr) past = beyond(c[broken ^ 2U].f, height(*far), far->slope_y, sign);
    }
    const EdgeSlopes e = edgeSlopes(c[high].f - c[low].f, {c[low].fy, c[high].fy}, break_y[low],
                                    break_y[high], past);
    c[low].fy = e.first;
    c[high].fy = e.last;
  }
  // Twists: a corner that breaks in one direction follows that direction's edge, with the same
  // rule; one that breaks in both takes the twist of straight lines.
  const Corners edges = c;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t beside = i ^ 1U, across = i ^ 2U;
    const double sign_x = i % 2 == 0 ? 1 : -1, sign_y = i / 2 == 0 ? 1 : -1;
    const double along_x = sign_x * (edges[beside].fy - edges[i].fy);
    const double along_y = sign_y * (edges[across].fx - edges[i].fx);
    if (break_x[i] && break_y[i]) {
      c[i].fxy = 0.5 * (along_x + along_y);
    } else if (break_x[i]) {
      const bool straight = break_x[beside] || break_y[beside];
      const int sign = i % 2 == 0 ? 1 : -1;
      const SurfaceSample* far =
          sampleBeyond(space, col_of(i), row_of(i), kX, sign, kBreakX | kBreakY);
      EdgeBeyond past;
      if (far != nullptr) past = beyond(edges[beside].fy, far->slope_y, far->twist, sign);
      const EdgeSlopes e =
          edgeSlopes(along_x, {edges[beside].fxy, edges[beside].fxy}, i % 2 == 0, i % 2 != 0, past);
      c[i].fxy = straight ? along_x : i % 2 == 0 ? e.first : e.last;
    } else if (break_y[i]) {
      const bool straight = break_y[across] || break_x[across];
      const int sign = i / 2 == 0 ? 1 : -1;
      const SurfaceSample* far =
          sampleBeyond(space, col_of(i), row_of(i), kY, sign, kBreakX | kBreakY);
      EdgeBeyond past;
      if (far != nullptr) past = beyond(edges[across].fx, far->slope_x, far->twist, sign);
      const EdgeSlopes e =
          edgeSlopes(along_y, {edges[across].fxy, edges[across].fxy}, i / 2 == 0, i / 2 != 0, past);
      c[i].fxy = straight ? along_y : i / 2 == 0 ? e.first : e.last;
    }
  }
  return c;
}

}  // namespace relievo
