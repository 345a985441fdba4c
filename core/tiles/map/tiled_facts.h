// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/base/transform.h"
#include "core/depth/depth_map.h"
#include "core/region/region.h"

namespace relievo {

/// What a tiled map says of itself, whatever carries its tiles.
struct TiledFacts {
  double factor = 2;  ///< The paper's M.
  ViewFromFile view_from_file;
  std::vector<GridFrame> frames;  ///< Per level, finest first.
  DetailLadder ladder;
  HeightRange heights;                        ///< Of the finest level, as heightRange.
  std::array<double, kOriginCount> shares{};  ///< As originShares.
  std::string set;                            ///< The checksum that all its files have.
  std::string state;                          ///< How it was made, as its description has it.
  std::string place;                          ///< Its file, folder or address.

  /// Frames and ladder. As many levels as there are, whatever number of samples the coarsest was
  /// to have. @param sizes  per level, finest first, at least one
  void layOut(const GridFrame& finest, const std::vector<GridSize>& sizes);
  /// The first level whose size is not that of its finer one reduced by the factor.
  std::optional<std::size_t> oddLevel() const;
  /// Shares from cells counted by their status. @return false: these are not as many as there are
  bool takeCounts(const std::array<double, kOriginCount>& cells_by_status);
};

}  // namespace relievo
