// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/fill/fill.h"
#include "core/depth/fill/mask.h"
#include "core/tiles/empty_runs.h"
#include "core/tiles/job/exchange.h"
#include "core/tiles/job/job_parts.h"
#include "core/tiles/row_store.h"

namespace relievo {

struct BandOptions {
  std::size_t memory_bytes = std::size_t{512} << 20U;  ///< For empty cells that touch each other.
  int threads = 0;                ///< 0: as many as there are cores, at most 4.
  Exchange* processes = nullptr;  ///< Of which each fills some bands; null: this one alone.
  JobFolder* job = nullptr;  ///< Where filled bands are kept; null: nowhere. @pre several: some
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
  /// Finds gaps, holes and the base plane; several processes find them together. [worker]
  /// @throw ArgumentError  no cell was hit, or membranes are asked for. WriteError, Cancelled
  BandFill(BandDepths depths, const GridFrame& frame, const FillSource& source,
           const HoleChoice& choice, const BandOptions& options, const Task& task);

  double baseZMm() const noexcept { return base_z_mm_; }
  const std::vector<Hole>& holes() const noexcept { return enclosed_.holes; }
  std::size_t seenThrough() const noexcept { return seen_through_; }
  /// Points in these cells, if they are known.
  std::size_t seenThroughPoints() const noexcept { return seen_through_points_; }

  /// Each of several processes fills its bands into the folder, and waits for the others. [worker]
  /// @return  how many bands of all were there before @throw WriteError, Cancelled,
  /// OtherProcessStopped
  int fillIntoFolder(const Task& task);

  /// Gives the finished rows, lowest first: heights above the base plane and origins, `cols` each.
  /// [worker] @throw WriteError, Cancelled and what `take` throws
  using TakeRow = std::function<void(int row, const float* heights_mm, const CellStatus* origins)>;
  void write(const TakeRow& take, const Task& task);
  /// How many bands of these `write` found in the folder.
  int bandsThere() const noexcept { return bands_there_; }

 private:
  struct Band {
    int first = 0, rows = 0;  ///< Of the result.
    int from = 0, to = 0;     ///< With the rows around: from ... to - 1.
  };
  Band bandOf(int number, int margin, int align) const noexcept;
  int bandCount() const noexcept;
  std::size_t cellsOf(const Band& band) const noexcept;  ///< Of the result.
  std::vector<float> read(const RowsOf& rows, const Band& band) const;

  /// Where the work is and how far: a step's words and the part of them that this is.
  struct Step {
    const char* words;
    double from = 0, to = 1;
  };
  using MakeBand = std::function<std::string(int number)>;                   ///< [any thread]
  using TakeBand = std::function<void(int number, std::string_view found)>;  ///< In order.
  /// All bands, each made by the process that has it, taken by all.
  void forBands(const Step& step, const Task& task, const MakeBand& make, const TakeBand& take);

  void markMeasured(const Task& task);
  int gapRadius() const;
  void dropSeenThroughBands(int radius, const Task& task);
  std::uint64_t pointsOf(const Mask& cells, const Band& band) const;
  void takeSeenThrough(const Band& band, const Mask& dropped);
  void pullAll(const Task& task);
  void findHoles(int radius, const Task& task);
  void addBetween(const Band& band, std::vector<float>& depths) const;
  void markSteep(const Band& band, std::vector<CellStatus>& origins) const;
  Mask gapsOf(const Band& band, const Mask& known) const;
  FilledBand filledBand(int number) const;
  bool isKept(int number, FilledBand& band) const;
  void placeOrigins(const Band& band, std::vector<CellStatus>& origins) const;

  BandDepths given_;
  RowsOf depths_;  ///< given_.front; later without what was seen through gaps.
  Alone alone_;
  Exchange& processes_;
  GridFrame frame_;
  FillSource source_;
  HoleChoice choice_;
  BandOptions options_;
  int threads_ = 1;
  BitRows measured_;
  std::optional<BitRows> dropped_;  ///< Seen through gaps, if they were looked for.
  int bands_there_ = 0;
  double base_z_mm_ = 0;
  std::size_t seen_through_ = 0, seen_through_points_ = 0;
  EmptyRuns empty_;
  EmptyRuns::Enclosed enclosed_;
  struct CoarseLayer;
  std::shared_ptr<CoarseLayer> coarse_;
};

}  // namespace relievo
