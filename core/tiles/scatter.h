// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/depth_request.h"
#include "core/depth/point_rule.h"
#include "core/tiles/point_source.h"
#include "core/tiles/tile_store.h"

namespace relievo {

/// Can the rule be computed from CellState alone?
bool isMergeable(PointRule rule);

/// Reads all points and puts each into the tile of its nearest sample; those outside the grid are
/// left out. [worker]
/// @throw Cancelled, FileError, WriteError
void scatterIntoTiles(const PointSource& source, const ViewFromFile& view_from_file,
                      const GridFrame& frame, TileStore& store, const Task& task);

/// Heights of one tile by a rule, NaN where it has no point: core/depth's own function for rules
/// that need the points, the states for the others. [any thread]
FrontDepths tileDepths(const TileStore& store, int tile, PointRule rule, double spacing_mm);

}  // namespace relievo
