// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

inline constexpr int kFirstCell = -1;                 ///< The border below or left of the samples.
inline constexpr int kLastCell = kWindowSamples - 1;  ///< The border above or right of them.
inline constexpr double kLastSample = kWindowSamples - 1;

/// Value, slopes and twist of the surface at one corner of one cell, grid units.
struct Corner {
  double f = 0, fx = 0, fy = 0, fxy = 0;
};

/// The four corners of a cell: left low, right low, left top, right top.
using Corners = std::array<Corner, 4>;

/// Slopes at both ends of one edge of a cell.
struct EdgeSlopes {
  double first = 0, last = 0;
};

/// The edge beyond the end that does not break, if it does not break either.
struct EdgeBeyond {
  bool known = false;
  double rise = 0, far_slope = 0;
};

/// An end that breaks takes its slope from the other one: the edge goes on as the one beyond it
/// bends there, or is a parabola if that one is not known; between two breaks it is straight.
inline EdgeSlopes edgeSlopes(double rise, EdgeSlopes smooth, bool first_breaks, bool last_breaks,
                             const EdgeBeyond& beyond = {}) RELIEVO_REALTIME {
  if (first_breaks && last_breaks) return {rise, rise};
  if (!first_breaks && !last_breaks) return smooth;
  const double near = first_breaks ? smooth.last : smooth.first;
  // Half the second derivative, seen from the end that breaks; seen from there both are mirrored.
  const double end =
      beyond.known ? 3 * rise - 4 * near - beyond.far_slope + 3 * beyond.rise : 2 * rise - near;
  return first_breaks ? EdgeSlopes{end, near} : EdgeSlopes{near, end};
}

inline Corner smoothCorner(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  const SurfaceSample& s = space.samples[HapticSpace::index(col, row)];
  return {(static_cast<double>(s.height_mm) - space.mid_mm) * space.cells_per_mm, s.slope_x,
          s.slope_y, s.twist};
}

/// What a cell between samples, 0 <= col, row < 199, sees at its corners where one of them breaks.
/// Neighbours that share an edge find the same curve along it, so that the surface has no gap;
/// where neither end of the edge breaks across it they also find the same slope across it.
Corners brokenCorners(const HapticSpace& space, int col, int row) RELIEVO_REALTIME;

inline bool isSmoothCell(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  return (space.marks[HapticSpace::index(col, row)] & kSmoothCell) != 0;
}

/// Corners of any cell between samples.
inline Corners cornersOf(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  if (!isSmoothCell(space, col, row)) return brokenCorners(space, col, row);
  return {smoothCorner(space, col, row), smoothCorner(space, col + 1, row),
          smoothCorner(space, col, row + 1), smoothCorner(space, col + 1, row + 1)};
}

}  // namespace relievo
