// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <filesystem>
#include <vector>

#include "core/tiles/level_files.h"

namespace relievo::test {

/// A map by tiles, 0.1 mm between cells: waves that every level shows, all of it measured.
inline void writeSmallMap(const std::filesystem::path& file, GridSize size) {
  const GridFrame frame{.size = size, .spacing_mm = 0.1, .first_x_mm = 0.05, .first_y_mm = 0.05};
  LevelFiles files(file, frame, {.factor = 2});
  std::vector<float> heights(static_cast<std::size_t>(size.cols));
  const std::vector<CellStatus> origins(heights.size(), CellStatus::measured);
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      heights[static_cast<std::size_t>(col)] =
          2 + std::sin(0.02F * static_cast<float>(col)) * std::cos(0.03F * static_cast<float>(row));
    }
    files.add(heights.data(), origins.data());
  }
  files.finish({}, "a state");
}

}  // namespace relievo::test
