// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/grid.h"
#include "core/base/origin.h"
#include "core/pyramid/pyramid.h"
#include "core/pyramid/row_reducer.h"

namespace relievo {

/// One row of one level.
struct LevelRow {
  Level level;
  int row = 0;
  const float* heights_mm = nullptr;
  const float* measured = nullptr;      ///< Share of measured cells under the kernel, [0, 1].
  const CellStatus* origins = nullptr;  ///< Of the map's cell nearest to the node.
};

/// buildPyramid for maps whose rows come one by one, lowest first: every row drives all coarser
/// levels while it is in the cache, and only the few rows under the kernel are kept. The heights
/// and shares are those of buildPyramid, bit for bit.
class PyramidRows {
 public:
  using TakeRow = std::function<void(const LevelRow&)>;

  /// Which levels a map of this frame has, finest first.
  /// @throw ArgumentError  factor outside (1, 8]
  static std::vector<GridFrame> frames(const GridFrame& map, const PyramidOptions& options);

  /// @param take  gets the rows of every level, each level's in order
  PyramidRows(const GridFrame& map, const PyramidOptions& options, TakeRow take);
  ~PyramidRows();

  /// The map's next row. @param heights_mm, origins  as in DepthMap
  void add(const float* heights_mm, const CellStatus* origins);

 private:
  struct Step;
  void give(std::size_t level, const float* heights, const float* measured);
  void keepOrigins(const CellStatus* origins);

  std::vector<GridFrame> frames_;
  double factor_ = 2;
  TakeRow take_;
  std::vector<std::unique_ptr<Step>> steps_;  ///< From each level to the next coarser one.
  std::vector<int> next_row_;                 ///< Per level.
  std::vector<int> next_origin_row_;
  std::vector<std::deque<std::vector<CellStatus>>>
      origins_;                            ///< Per level: known before the heights.
  std::vector<float> heights_, measured_;  ///< Of the row being added.
  int rows_added_ = 0;
};

}  // namespace relievo
