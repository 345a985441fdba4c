// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/tiles/job/job_folder.h"
#include "core/tiles/points/scatter.h"
#include "core/tiles/tile_store.h"

namespace relievo {

// What of a map is kept in a JobFolder: points sorted into tiles, rows of tiles with their heights,
// and what was decided between the two.

/// What follows from all points.
struct PointDecisions {
  RuleProposal rule;
  LeftOut left_out;
};
std::optional<PointDecisions> loadDecisions(JobFolder& job);
/// @throw WriteError
void keepDecisions(JobFolder& job, const PointDecisions& decisions);

/// @param tile_row  number of the row of tiles, @param map  size of the map
std::optional<DepthRows> loadRows(JobFolder& job, int tile_row, GridSize map);
/// @throw WriteError
void keepRows(JobFolder& job, int tile_row, const DepthRows& rows);

/// Points and files that were there already.
struct KnownParts {
  std::uint64_t points = 0, parts = 0;
};
/// scatterIntoTiles, so many points of the source at a time: each part becomes a file in the
/// folder, or is there from before; the store reads them from there. [worker]
/// @throw Cancelled, FileError, WriteError
LeftOut scatterByParts(const PointSource& source, const ViewFromFile& view_from_file,
                       const GridFrame& frame, TileStore& store, JobFolder& job,
                       std::uint64_t part_points, KnownParts& known, const Task& task,
                       const FrontSurface* front = nullptr);

}  // namespace relievo
