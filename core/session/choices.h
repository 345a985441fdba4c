// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/cloud/scan.h"
#include "core/depth/view.h"
#include "core/session/surface.h"

namespace relievo {

// What is chosen between a file and its surface, the same for maps in memory and for tiled ones.
// Each says in surface.messages what it chose unasked.

/// surface.unit and where it is from. @pre surface.info
void chooseUnit(Surface& surface, const SurfaceOptions& options);

/// Samples so that the first and last lie on the box; the map's lower left edge becomes (0, 0).
/// @param points_in_all  if `scan` is a sample of so many points; 0: it is all of them
/// @throw ArgumentError, FileError
GridFrame chooseFrame(Surface& surface, const Scan& scan, const SurfaceOptions& options,
                      const Rotation& rotation, const RotatedBounds& box,
                      std::uint64_t points_in_all);

/// Rotation, scaling to millimetres, then a shift.
ViewFromFile viewFromFile(const Rotation& rotation, double mm_per_unit, double dx, double dy,
                          double dz);

}  // namespace relievo
