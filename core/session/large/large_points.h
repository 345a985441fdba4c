// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/depth/fill/band_fill.h"
#include "core/depth/layers/front_surface.h"
#include "core/depth/view.h"
#include "core/io/point_files.h"
#include "core/session/large/large_map.h"
#include "core/session/large/large_memory.h"
#include "core/session/source/source_in_use.h"
#include "core/session/surface.h"
#include "core/tiles/job/job_folder.h"
#include "core/tiles/points/scatter.h"
#include "core/tiles/row_store.h"

namespace relievo {

// The part of makeLargeMap that knows points: from a source of them to depths of cells.

/// The cloud's frame, its view and what the points are mapped with, z from the lowest point.
struct Placed {
  GridFrame frame;
  ViewFromFile view_from_file;
  NamedRotation rotation;
  double lowest_mm = 0, range_mm = 0;
  SourceInUse points;
  std::optional<FrontSurface> front;  ///< Of a cloud that lies behind itself.
};

/// Chooses unit, view and frame by a look at all points, and says so in `facts`. [worker]
/// @param sample  without strays @throw FileError, ArgumentError, Cancelled
Placed place(Surface& facts, const PointFiles& stream, const Scan& sample,
             const SurfaceOptions& options, const LargeMapOptions& large, const Task& task);

/// Says which points were left out. [worker]
void sayLeftOut(Surface& facts, const SourceInUse& points, const SurfaceOptions& options);

/// Depths of all cells, on disk.
class StoredDepths {
 public:
  StoredDepths(GridSize size, std::filesystem::path spill_folder);

  void keep(const DepthRows& rows);
  /// From now on rows of tiles that were not kept come from `row`, when they are asked for first.
  /// @param has_between, has_points  what they have [any thread]
  void comeFrom(std::function<DepthRows(int tile_row)> row, bool has_between, bool has_points);
  /// As long as this lives and is not moved. [any thread, after the last `keep`]
  BandDepths rows();

  bool one_layer = false;
  std::optional<HiddenSurface> hidden;
  std::size_t outliers = 0;
  LeftOut left_out;

 private:
  void keepIn(std::unique_ptr<RowStore>& store, const DepthRows& rows,
              const std::vector<float>& values) const;
  RowsOf of(const RowStore& store);
  void require(int first_row, int rows);

  GridSize size_;
  std::filesystem::path spill_folder_;
  RowStore front_;
  std::unique_ptr<RowStore> between_, points_;
  BitRows steep_;
  std::function<DepthRows(int tile_row)> row_;
  std::vector<bool> is_here_;  ///< Rows of tiles.
  std::shared_mutex asks_;     ///< For rows that come from `row_`.
};

using TakeDepthRows = std::function<void(const DepthRows& rows)>;

/// @param job  where finished parts lie; null: nowhere
/// @param on_rows  called with each row of tiles, from the lowest on; null: nobody looks [worker]
/// @throw FileError, WriteError, Cancelled, OtherProcessStopped; ArgumentError  E102 where points
/// lie too dense
std::unique_ptr<StoredDepths> gridPoints(LargeMap& map, const PointFiles& stream,
                                         const Placed& placed, const SurfaceOptions& options,
                                         const LargeMapOptions& large, const MemoryPlan& plan,
                                         JobFolder* job, const TakeDepthRows& on_rows,
                                         const Task& task);

}  // namespace relievo
