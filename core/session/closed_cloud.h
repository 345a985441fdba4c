// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"
#include "core/depth/cell_points.h"
#include "core/depth/cell_size.h"
#include "core/depth/depth_request.h"
#include "core/depth/front_surface.h"
#include "core/depth/view.h"

namespace relievo {

/// A cloud that lies behind itself in places, reduced to what is seen of it.
struct ClosedCloud {
  FrontSurface surface;
  Scan visible;            ///< The points on it, in the scan's order; no colours and such.
  std::size_t hidden = 0;  ///< Points behind it ...
  std::size_t strays = 0;  ///< ... and off every surface.
};

/// Decides in 3-D which points of a cloud are seen, where they lie in several layers; nothing for
/// meshes and for clouds of one layer, whose maps stay as they are. The decision is one of scan and
/// view alone; the grid comes after it. [worker] @throw Cancelled
std::optional<ClosedCloud> closedCloud(const Scan& scan, const Rotation& rotation,
                                       double mm_per_unit, const RotatedBounds& box,
                                       const Task& task);

/// The front of points that need not be in memory, if they lie in several layers.
/// @param sample  of the points, from the box's lower corner, to tell the layers by
/// @param box  from its own lower corner [worker] @throw Cancelled
std::optional<FrontSurface> frontOf(const ViewBlocks& points, const std::vector<ViewMm>& sample,
                                    const ViewBox& box, std::uint64_t count, const Task& task);

/// How fine a grid the points that are seen carry. @param box  of the whole cloud
CellProposal cellsOf(const FrontSurface& front, const RotatedBounds& box, std::uint64_t points);

/// Heights of the surface in front for cells without a point, and nothing where it does not reach.
/// `depths.between` of the engine stays where it agrees with the surface.
void addFront(const FrontSurface& front, const GridFrame& frame, CapturedDepths& depths);

/// The same for some rows of the frame. @param depths, between  their cells
void addFront(const FrontSurface& front, const GridFrame& frame, RowRange rows, const float* depths,
              float* between);

}  // namespace relievo
