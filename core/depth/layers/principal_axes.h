// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/base/task.h"
#include "core/cloud/scan.h"

namespace relievo {

using Axis = std::array<double, 3>;  ///< Unit vector in file axes.

/// The directions in which an object is long, middling and short.
struct PrincipalAxes {
  std::array<Axis, 3> axes;         ///< By falling spread.
  std::array<double, 3> spreads{};  ///< Standard deviation along each, file units.
};

/// Of the surface (triangles by their area) or, without triangles, of the points.
/// @param trimmed_share  of the points is left out, those farthest from the plane of the two longer
///                       axes: outliers do not tilt it; 0 takes all [worker]
/// @throw Cancelled
PrincipalAxes principalAxes(const Scan& scan, double trimmed_share, const Task& task = {});

}  // namespace relievo
