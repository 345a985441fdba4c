// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/colours/colours.h"
#include "core/pyramid/pyramid.h"

namespace relievo {

/// One row of one level; null for what there is not.
struct ColourRow {
  Level level;
  int row = 0;
  const Rgba* colours = nullptr;
  const GreyAlpha* intensities = nullptr;
};

/// colourLevels for maps whose rows come one by one, lowest first: the same bytes. Keeps the few
/// rows under the kernel.
class ColourPyramidRows {
 public:
  using TakeRow = std::function<void(const ColourRow&)>;

  /// @param frames  of the levels, finest first (PyramidRows::frames), @param factor  between them
  /// @param take    gets the rows of every level, each level's in order
  ColourPyramidRows(std::vector<GridFrame> frames, double factor, TakeRow take);
  ~ColourPyramidRows();

  /// The map's next row; the same kinds every time.
  void add(const Rgba* colours, const GreyAlpha* intensities);

 private:
  struct Step;
  void give(std::size_t level, const Rgba* colours, const GreyAlpha* intensities);

  std::vector<GridFrame> frames_;
  TakeRow take_;
  std::vector<std::unique_ptr<Step>> steps_;  ///< From each level to the next coarser one.
  std::vector<int> next_row_;                 ///< Per level.
};

}  // namespace relievo
