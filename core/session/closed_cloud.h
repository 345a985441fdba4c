// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"
#include "core/depth/depth_map.h"
#include "core/depth/depth_request.h"
#include "core/depth/layers/front_surface.h"
#include "core/depth/rules/cell_points.h"
#include "core/depth/rules/cell_size.h"
#include "core/depth/view.h"

namespace relievo {

/// A cloud that lies behind itself in places, reduced to what is seen of it.
struct ClosedCloud {
  FrontSurface surface;
  Scan visible;            ///< The points on it, in the scan's order; no colours and such.
  std::size_t hidden = 0;  ///< Points behind it ...
  std::size_t strays = 0;  ///< ... and off every surface.
  double noise_mm = 0;     ///< Of the visible points, along the view.
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

/// How fine a grid the points that are seen carry: 1.5 points a cell, more where noise asks for a
/// mean of more. @param box  of the whole cloud
CellProposal cellsOf(const FrontSurface& front, const RotatedBounds& box, std::uint64_t points,
                     double noise_mm);

/// Standard deviation of points on the front about it, along the view, from the median: steep parts
/// and layers do not count. @param from_corner  the i-th of them, from the box's lower corner
double noiseOnFront(const FrontSurface& front, std::size_t points,
                    const std::function<ViewMm(std::size_t)>& from_corner);

/// What the search for the front left out, beside what was found in the points of the front.
/// @param cells  of the finished map
void addHidden(const FrontSurface& front, double hidden_points, const OriginCounts& cells,
               HiddenSurface& hidden);

/// Some rows of cells, each as in CapturedDepths.
struct FrontRows {
  RowRange rows;
  float* depths = nullptr;
  float* between = nullptr;
  std::uint8_t* steep = nullptr;  ///< Null if not known.
};

/// What the surface in front says of cells: one whose height lies behind it has none, as its points
/// are those beside an edge; one without a height gets the surface's as `between`, and nothing
/// where that does not reach, unless the rule's own agrees with it; one is steep where the surface
/// is.
void addFront(const FrontSurface& front, const GridFrame& frame, const FrontRows& to);

/// The same for all rows.
void addFront(const FrontSurface& front, const GridFrame& frame, CapturedDepths& depths);

}  // namespace relievo
