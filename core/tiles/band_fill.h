// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/fill/fill.h"
#include "core/depth/fill/mask.h"
#include "core/tiles/empty_runs.h"
#include "core/tiles/row_store.h"

namespace relievo {

struct BandOptions {
  std::size_t memory_bytes = std::size_t{512} << 20U;  ///< For depths that are kept in between.
  std::filesystem::path spill_folder = ".";
  int threads = 0;  ///< 0: as many as there are cores, at most 4.
};

/// CapturedDepths by rows; each must stay valid and may be called on any thread.
struct BandDepths {
  RowsOf front;                    ///< NaN where nothing was hit.
  RowsOf between;                  ///< Null if the rule gives none.
  const BitRows* steep = nullptr;  ///< What the engine saw to be steep.
  bool one_layer = false;          ///< Nothing shows through.
  RowsOf points = {};              ///< In each cell; null if not known.
};

/// fillDepths of core/depth for maps that do not fit into memory: the same steps, each on bands of
/// rows with as many rows around them as the step looks at, and so the same bytes (a hole's centre:
/// to rounding). Memory: bands, one bit per cell, the runs of empty cells.
class BandFill {
 public:
  /// Finds gaps, holes and the base plane. [worker]
  /// @throw ArgumentError  no cell was hit, or membranes are asked for. WriteError, Cancelled
  BandFill(BandDepths depths, const GridFrame& frame, const FillSource& source,
           const HoleChoice& choice, const BandOptions& options, const Task& task);

  double baseZMm() const noexcept { return base_z_mm_; }
  const std::vector<Hole>& holes() const noexcept { return enclosed_.holes; }
  std::size_t seenThrough() const noexcept { return seen_through_; }
  /// Points in these cells, if they are known.
  std::size_t seenThroughPoints() const noexcept { return seen_through_points_; }

  /// Gives the finished rows, lowest first: heights above the base plane and origins, `cols` each.
  /// [worker] @throw WriteError, Cancelled and what `take` throws
  using TakeRow = std::function<void(int row, const float* heights_mm, const CellStatus* origins)>;
  void write(const TakeRow& take, const Task& task) const;

 private:
  struct Band {
    int first = 0, rows = 0;  ///< Of the result.
    int from = 0, to = 0;     ///< With the rows around: from ... to - 1.
  };
  Band bandOf(int number, int margin, int align) const noexcept;
  int bandCount() const noexcept;
  std::vector<float> read(const RowsOf& rows, const Band& band) const;

  void markMeasured(const Task& task);
  int gapRadius() const;
  void dropSeenThroughBands(int radius, const Task& task);
  void countSeenThrough(int row, const float* depths);
  void pullAll(const Task& task);
  void findHoles(int radius, const Task& task);
  void addBetween(const Band& band, std::vector<float>& depths) const;
  void markSteep(const Band& band, std::vector<CellStatus>& origins) const;
  Mask gapsOf(const Band& band, const Mask& known) const;
  void fillBand(const Band& band, std::vector<float>& heights,
                std::vector<CellStatus>& origins) const;
  void placeOrigins(const Band& band, std::vector<CellStatus>& origins) const;

  BandDepths given_;
  RowsOf depths_;  ///< given_.front; later without what was seen through gaps.
  GridFrame frame_;
  FillSource source_;
  HoleChoice choice_;
  BandOptions options_;
  int threads_ = 1;
  BitRows measured_;
  std::unique_ptr<RowStore> kept_;  ///< Behind depths_, if anything was dropped.
  double base_z_mm_ = 0;
  std::size_t seen_through_ = 0, seen_through_points_ = 0;
  EmptyRuns empty_;
  EmptyRuns::Enclosed enclosed_;
  struct CoarseLayer;
  std::shared_ptr<CoarseLayer> coarse_;
};

}  // namespace relievo
