// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/base/task.h"
#include "core/depth/depth_map.h"
#include "core/depth/depth_request.h"
#include "core/depth/quality.h"

namespace relievo {

/// What of a scan's points (meshes: of its triangles, by their middles and areas) lies behind the
/// front that an engine found; for engines that do not count it themselves. [worker]
/// @throw Cancelled
HiddenSurface countHidden(const DepthRequest& request, const FrontDepths& front,
                          const Task& task = {});

/// Joins what engine and map know.
/// @param seen_through_points  of cells that showed the back and were left out of the map
/// @param cells  of the finished map, by origin
DepthLosses lossesOf(const HiddenSurface& hidden, std::size_t outliers,
                     std::size_t seen_through_points, const OriginCounts& cells);

}  // namespace relievo
