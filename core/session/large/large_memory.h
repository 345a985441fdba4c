// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/grid.h"
#include "core/session/large/large_map.h"

namespace relievo {

/// How the budget of a map by tiles is divided. The stages follow each other, so that each may use
/// what the other gave back.
struct MemoryPlan {
  std::uint64_t held_bytes = 0;    ///< Taken all the time, beside the stages.
  std::size_t points_bytes = 0;    ///< For TileStore, while points are sorted into it.
  std::size_t gridding_bytes = 0;  ///< For TileStore and what heights are made from.
  std::size_t depths_bytes = 0;    ///< For depths between the stages.
  std::size_t values_bytes = 0;    ///< For ValueStore while colours are made; 0: no room for them.
  std::uint64_t colours_need = 0;  ///< Memory that a map with colours needs in all.
};

/// What of `plan.gridding_bytes` is left for the store while heights are made, once it is known
/// where the points lie: three rows of tiles are in memory, sorted, and each thread has the points
/// of the tile it works on.
/// @param rows_bytes  of the fullest three rows, @param tile_bytes  about, of one tile
/// @throw ArgumentError  E102, with what would do
std::size_t storeBytes(const MemoryPlan& plan, const GridFrame& frame, const LargeMapOptions& large,
                       std::size_t rows_bytes, std::size_t tile_bytes);

/// To be asked before the work.
/// @param held_bytes  what the input keeps until the map is made
/// @throw ArgumentError  E102, with what would do
MemoryPlan planMemory(const GridFrame& frame, const LargeMapOptions& large,
                      std::uint64_t held_bytes = 0);

}  // namespace relievo
