// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/cloud/scan.h"
#include "core/depth/view.h"
#include "core/message/message.h"

namespace relievo {

/// How fine a grid the data carry, and why.
struct CellProposal {
  int cells = 0;   ///< Samples across the longer side of the view, >= 2.
  Message reason;  ///< "the points lie on a regular grid"
};

/// Points on a regular grid: that grid. Other clouds: about 2.5 points a cell. Meshes: 800, the
/// paper's grid. [worker]
/// @param points_in_all  if `scan` is a sample of so many points; 0: it is all of them
CellProposal proposeCells(const Scan& scan, const Rotation& rotation,
                          std::uint64_t points_in_all = 0);

/// Points whose area is known.
struct CoveredArea {
  double side_mm = 0;  ///< Longer side of the grid.
  double covered_mm2 = 0;
  std::uint64_t points = 0;  ///< In `covered_mm2`.
  double points_per_cell = 0;
};

/// The same for the front of a closed cloud.
CellProposal proposeCells(const CoveredArea& covered);

}  // namespace relievo
