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
  double not_measured = 0;  ///< Share of its points beside samples that are not measured, [0, 1].
};

/// Where a plane cuts the surface, longest curve first. Along the lines between neighbouring
/// samples the curves are exactly on the bilinear surface; inside a cell they are straight. Cells
/// with a corner outside are left out. Reads some rows at a time. [worker]
/// @throw ArgumentError  no finite normal above 0, offset not finite, or more than `most_points`
/// points, which is 100 bytes of memory for each; also what `map` throws when it reads
inline constexpr std::size_t kMostSectionPoints = 10'000'000;
std::vector<SectionCurve> section(const MapCells& map, const PlaneMm& plane,
                                  std::size_t most_points = kMostSectionPoints);

}  // namespace relievo
