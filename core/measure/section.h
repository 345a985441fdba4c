// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/vec3.h"
#include "core/measure/map_cells.h"

namespace relievo {

/// A plane in the view: the points p with normal . p = offset_mm.
struct PlaneMm {
  ViewMm normal{0, 0, 1};  ///< Of any length but 0; (0, 0, 1) is a contour at a height.
  double offset_mm = 0;    ///< Along the normal made 1 long.
};

/// One curve in which a plane cuts the surface.
struct SectionCurve {
  std::vector<ViewMm> points;  ///< In order; at least two.
  bool closed = false;         ///< The last point is joined to the first.
  double length_mm = 0;
  /// Bound: half a cell more or less at each end, or all round if closed; and each piece between
  /// two points as far askew as the heights' errors may move these.
  double length_off_mm = 0;
  double not_measured = 0;  ///< Share of its points beside samples that are not measured, [0, 1].
};

/// How much longer a path of points may be than its straight pieces, because walls stand inside
/// them: that part of a climb that the piece before or after does not share, where the heights'
/// errors `off_mm` do not explain it, goes straight up and the rest of the piece beside it.
double wallsOff(const std::vector<ViewMm>& points, const std::vector<double>& off_mm, bool closed);

/// The level plane through one point, the upright one through two, the one through three.
/// @throw ArgumentError  points too close together, or three on one line
PlaneMm planeThrough(const std::vector<ViewMm>& points);

/// Where a plane cuts the surface, longest curve first. Along the lines between neighbouring
/// samples the curves are exactly on the bilinear surface; inside a cell they are straight. Cells
/// with a corner outside are left out. Reads some rows at a time. [worker]
/// @throw ArgumentError  no finite normal above 0, offset not finite, or more than `most_points`
/// points, which is 100 bytes of memory for each; also what `map` throws when it reads
inline constexpr std::size_t kMostSectionPoints = 10'000'000;
std::vector<SectionCurve> section(const MapCells& map, const PlaneMm& plane,
                                  std::size_t most_points = kMostSectionPoints);

}  // namespace relievo
