// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/task.h"
#include "core/depth/fill/band_fill.h"
#include "core/tiles/job/job_folder.h"
#include "core/tiles/points/scatter.h"
#include "core/tiles/tile_store.h"

namespace relievo {

// What of a map is kept in a JobFolder: points sorted into tiles, rows of tiles with their heights,
// what was decided between the two, and the same rows with gaps and holes filled.

/// What follows from all points.
struct PointDecisions {
  RuleProposal rule;
  LeftOut left_out;
};
std::optional<PointDecisions> loadDecisions(JobFolder& job);
/// @throw WriteError
void keepDecisions(JobFolder& job, const PointDecisions& decisions);
/// The same for another process.
std::string bytesOfDecisions(const PointDecisions& decisions);
std::optional<PointDecisions> decisionsFrom(std::string_view bytes);

/// What is known of a row of tiles beside the heights.
struct RowsHead {
  std::int32_t first_row = 0, rows = 0;
  std::uint64_t outliers = 0, cells = 0, cells_in_layers = 0;
  double hidden = 0, all = 0;
  std::uint16_t has_between = 0, has_steep = 0, has_points = 0, has_hidden = 0;
};
RowsHead headOf(const DepthRows& rows);
std::optional<HiddenSurface> hiddenOf(const RowsHead& head);

/// @param tile_row  number of the row of tiles, @param map  size of the map
std::optional<DepthRows> loadRows(JobFolder& job, int tile_row, GridSize map);
/// @throw WriteError
void keepRows(JobFolder& job, int tile_row, const DepthRows& rows);

/// Rows of tiles as the finest level has them.
class JobBands : public BandKeeper {
 public:
  /// @param job  must stay
  explicit JobBands(JobFolder& job) : job_(job) {}
  bool load(int number, std::size_t cells, FilledBand& band) override;
  void keep(int number, const FilledBand& band) override;

 private:
  JobFolder& job_;
};

/// Points and files that were there already.
struct KnownParts {
  std::uint64_t points = 0, parts = 0;
};
/// scatterIntoTiles, so many points of the source at a time: each part becomes a file in the
/// folder, or is there from before; the store reads them from there. [worker]
/// @param processes  of which each makes some of the parts; null: this one alone
/// @throw Cancelled, FileError, WriteError, OtherProcessStopped
LeftOut scatterByParts(const PointSource& source, const ViewFromFile& view_from_file,
                       const GridFrame& frame, TileStore& store, JobFolder& job,
                       std::uint64_t part_points, KnownParts& known, const Task& task,
                       const FrontSurface* front = nullptr, Exchange* processes = nullptr);

}  // namespace relievo
