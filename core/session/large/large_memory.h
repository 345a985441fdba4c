// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/grid.h"
#include "core/session/large/large_map.h"
#include "core/tiles/points/scatter.h"
#include "core/tiles/tile_rows.h"

namespace relievo {

/// How the budget of a map by tiles is divided. The stages follow each other, so that each may use
/// what the other gave back.
struct MemoryPlan {
  int threads = 1;
  std::uint64_t held_bytes = 0;    ///< Taken all the time, beside the stages.
  std::size_t points_bytes = 0;    ///< For TileStore, while points are sorted into it.
  std::size_t gridding_bytes = 0;  ///< For TileStore and what heights are made from.
  std::size_t depths_bytes = 0;    ///< For depths between the stages.
  std::size_t values_bytes = 0;    ///< For ValueStore while colours are made; 0: no room for them.
  std::uint64_t colours_need = 0;  ///< Memory that a map with colours needs in all.
};

/// Where heights are made: what of `plan.gridding_bytes` is left for the store beside the points
/// that are worked on, and how many of these there may be.
struct GriddingMemory {
  std::size_t store_bytes = 0;
  GriddingRoom room;
};
/// To be asked when it is known where the points lie. Where they lie so dense that not every thread
/// has room for a tile of them, tiles are cut, and fewer work at last.
/// @throw ArgumentError  E102, with what would do
GriddingMemory griddingMemory(const MemoryPlan& plan, const GridFrame& frame,
                              const LargeMapOptions& large, const GriddingNeeds& needs);

/// What is left for the store while so many points are looked at to choose a rule.
/// @throw ArgumentError  E102, with what would do
std::size_t samplingBytes(const MemoryPlan& plan, const GridFrame& frame,
                          const LargeMapOptions& large, std::size_t points);

/// Points of a tile that each thread can be given beside much of the store: as `ample` of
/// griddingNeeds.
std::size_t amplePoints(const MemoryPlan& plan) noexcept;

/// To be asked before the work. Where `large.threads` leaves it open, as many work as the budget
/// has room for.
/// @param held_bytes  what the input keeps until the map is made, of so many threads
/// @throw ArgumentError  E102, with what would do
MemoryPlan planMemory(const GridFrame& frame, const LargeMapOptions& large,
                      const std::function<std::uint64_t(int threads)>& held_bytes = {});

/// Bytes on the disk of the finest level while a map is made, at least: all levels and, of a cloud,
/// the depths before gaps are filled and the points that are not in memory.
/// @param frames  of the levels
/// @param points  that are kept until the cells have their heights; nothing: a raster
std::uint64_t diskBytes(const std::vector<GridFrame>& frames, std::optional<std::uint64_t> points,
                        const MemoryPlan& plan);

/// To be asked before the work. @param free_bytes  nothing: not known @throw WriteError
void requireDisk(const GridFrame& frame, const std::filesystem::path& folder, std::uint64_t needed,
                 std::optional<std::uint64_t> free_bytes);

}  // namespace relievo
