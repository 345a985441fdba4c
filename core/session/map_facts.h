// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/base/task.h"
#include "core/measure/map_cells.h"
#include "core/session/surface.h"

namespace relievo {

// What is said and measured of a surface's depth map, in memory or by tiles: always of the finest
// level, never of the coarse one that a tiled surface holds for views of the whole (docs/adr/0063).

/// Where the finest cells lie.
const GridFrame& mapFrame(const Surface& surface);

/// The whole map in numbers; of a map by tiles as its files say them.
struct MapFacts {
  HeightRange heights;
  std::array<double, kOriginCount> shares{};  ///< As originShares.
};
MapFacts mapFacts(const Surface& surface);

/// The finest cells, to be measured. Valid as long as the surface; of a map by tiles also beyond.
/// Reading throws FileError if a file was damaged meanwhile, and Cancelled. [any thread]
MapCells mapCells(const Surface& surface, const Task& task = {});

}  // namespace relievo
