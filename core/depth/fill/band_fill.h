// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/exchange.h"
#include "core/base/grid.h"
#include "core/base/origin.h"
#include "core/base/task.h"
#include "core/depth/fill/empty_runs.h"
#include "core/depth/fill/fill.h"
#include "core/depth/fill/grid_rows.h"
#include "core/depth/fill/mask.h"
#include "core/depth/fill/plates.h"
#include "core/depth/fill/push_pull.h"

namespace relievo {

/// Rows of the finished map: heights above the base plane and origins.
struct FilledBand {
  std::vector<float> heights_mm;
  std::vector<CellStatus> origins;
};

/// Where finished bands are kept, so that work that stopped goes on with them.
class BandKeeper {
 public:
  BandKeeper() = default;
  BandKeeper(const BandKeeper&) = delete;
  BandKeeper& operator=(const BandKeeper&) = delete;
  virtual ~BandKeeper() = default;

  /// @param cells  that the band has @return  whether it is there [any thread]
  virtual bool load(int number, std::size_t cells, FilledBand& band) = 0;
  /// [any thread] @throw WriteError
  virtual void keep(int number, const FilledBand& band) = 0;
};

struct BandOptions {
  std::size_t memory_bytes = std::size_t{512} << 20U;  ///< For empty cells and rims of holes.
  int threads = 0;                                     ///< 0: as many as there are cores.
  int rows = 256;                 ///< Of a band, a multiple of 8. The bytes are those of any.
  Exchange* processes = nullptr;  ///< Of which each fills some bands; null: this one alone.
  BandKeeper* keeper = nullptr;   ///< Of filled bands; null: none. @pre several processes: some
};

/// CapturedDepths by rows; each must stay valid and may be called on any thread.
struct BandDepths {
  GridRows front;                  ///< NaN where nothing was hit.
  GridRows between;                ///< None if the rule gives none.
  const BitRows* steep = nullptr;  ///< What the engine saw to be steep; known with `front`.
  bool one_layer = false;          ///< Nothing shows through.
  RowsOf points = {};              ///< In each cell; null if not known.
};

/// From raw front depths to a depth map, wherever they lie (memory, files, several processes): each
/// step works on bands of rows with as many rows around them as it looks at, and gives the same
/// bytes for bands of any height. What is told between bands is one bit per cell, the runs of empty
/// cells, a 64th of the cells of push-pull, and the rims of membranes. fillDepths of fill.h is this
/// with everything in memory. docs/adr/0233.
class BandFill {
 public:
  /// Finds gaps, holes and the base plane; several processes find them together. [worker]
  /// @throw ArgumentError  no cell was hit. WriteError, Cancelled, OtherProcessStopped
  BandFill(BandDepths depths, const GridFrame& frame, const FillSource& source,
           const HoleChoice& choice, const BandOptions& options, const Task& task);

  double baseZMm() const noexcept { return base_z_mm_; }
  const std::vector<Hole>& holes() const noexcept { return enclosed_.holes; }
  std::size_t seenThrough() const noexcept { return seen_through_; }
  /// Points in these cells, if they are known.
  std::size_t seenThroughPoints() const noexcept { return seen_through_points_; }

  /// Each of several processes fills its bands and keeps them, and waits for the others. [worker]
  /// @return  how many bands of all were there before @throw WriteError, Cancelled,
  /// OtherProcessStopped
  int fillForOthers(const Task& task);

  /// Gives the finished rows, lowest first: heights above the base plane and origins, `cols` each.
  /// [worker] @throw WriteError, Cancelled and what `take` throws
  using TakeRow = std::function<void(int row, const float* heights_mm, const CellStatus* origins)>;
  void write(const TakeRow& take, const Task& task);
  /// How many bands of these `write` found kept.
  int bandsThere() const noexcept { return bands_there_; }

  /// The whole map at once. @param heights_mm, origins  room for all cells [worker]
  /// @throw Cancelled
  void fillInto(float* heights_mm, CellStatus* origins, const Task& task) const;

 private:
  struct Band {
    int first = 0, rows = 0;  ///< Of the result.
    int from = 0, to = 0;     ///< With the rows around: from ... to - 1.
  };
  Band bandOf(int number, int margin, int align) const noexcept;
  int bandCount() const noexcept;
  GridSize sizeOf(const Band& band) const noexcept;      ///< With the rows around.
  std::size_t cellsOf(const Band& band) const noexcept;  ///< Of the result.
  std::size_t startOf(const Band& band) const noexcept;  ///< Of the result, in the rows around.

  /// Depths of a band and around: in memory anyway, or read.
  struct Depths {
    std::vector<float> read;
    const float* at = nullptr;
  };
  Depths depthsOf(const Band& band) const;
  std::vector<float> readDepths(const Band& band) const;

  /// Where the work is and how far: a step's words and the part of them that this is.
  struct Step {
    const char* words;
    double from = 0, to = 1;
  };
  using MakeBand = std::function<std::string(int number)>;                   ///< [any thread]
  using TakeBand = std::function<void(int number, std::string_view found)>;  ///< In order.
  /// All bands, each made by the process that has it, taken by all.
  void forBands(const Step& step, const Task& task, const MakeBand& make, const TakeBand& take);

  void widenBands(int around);
  void markMeasured(const Task& task);
  void dropSeenThroughBands(int radius, const Task& task);
  std::uint64_t pointsOf(const Mask& cells, const Band& band) const;
  void requireRoom() const;
  void findHoles(int radius, const Task& task);
  bool needsPull() const noexcept;
  void pullAll(const Task& task);
  void layMembranes(const Task& task);
  void addBetween(const Band& band, std::vector<float>& depths) const;
  void placeOrigins(const Band& band, CellStatus* origins) const;
  void markSteep(const Band& band, CellStatus* origins) const;
  Mask gapsOf(const Band& band, const Mask& known) const;
  std::vector<float> completed(const Band& band, const Task& task) const;
  void fillBand(int number, float* heights_mm, CellStatus* origins, const Task& task) const;
  FilledBand filledBand(int number, const Task& task) const;
  bool isKept(int number, FilledBand& band) const;

  BandDepths given_;
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
  std::optional<PushPullLayer> coarse_;  ///< Completed; none if nothing is asked of it.
  Plates plates_;
};

}  // namespace relievo
