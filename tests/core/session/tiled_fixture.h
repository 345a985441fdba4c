// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <filesystem>
#include <random>

#include "core/io/raster/raster.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/surface.h"
#include "core/tiles/level_files.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo::test {

/// A relief with noise, a hole on the base plane, an interpolated patch and a corner that belongs
/// to nothing.
inline DepthMap reliefMap(GridSize size) {
  std::mt19937 random(17);
  std::uniform_real_distribution<float> uniform(0, 0.2F);
  DepthMap map;
  map.frame = {.size = size, .spacing_mm = 0.125, .first_x_mm = 0.0625, .first_y_mm = 0.0625};
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const bool outside = col + row < size.cols / 3;
      const bool hole = std::hypot(col - size.cols / 2, row - size.rows / 2) < 40;
      const bool filled = std::hypot(col - 0.7 * size.cols, row - 0.6 * size.rows) < 25;
      const float z = 3 + std::sin(static_cast<float>(col) / 40) + uniform(random);
      map.heights_mm.push_back(outside || hole ? 0.0F : z);
      map.origins.push_back(outside  ? CellStatus::outside
                            : hole   ? CellStatus::base_plane
                            : filled ? CellStatus::interpolated
                                     : CellStatus::measured);
    }
  }
  return map;
}

/// From above, a cell every quarter of a millimetre.
inline SurfaceOptions topOptions(PointRule rule) {
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{.name = "top", .rotation = std::nullopt};
  options.spacing_mm = 0.25;
  options.rule = rule;
  return options;
}

/// Writes a map and its levels by tiles.
inline void writeTiled(const std::filesystem::path& file, const DepthMap& map, double factor = 2) {
  LevelFiles files(file, map.frame, {.factor = factor});
  for (int row = 0; row < map.frame.size.rows; ++row) {
    const std::size_t start = map.frame.size.index({.col = 0, .row = row});
    files.add(&map.heights_mm[start], &map.origins[start]);
  }
  files.finish({});
}

/// One map, by tiles and read whole from the same file.
struct BothWays {
  explicit BothWays(GridSize size, double factor = 2) {
    writeTiled(folder / "map.tif", reliefMap(size), factor);
    tiled = openTiledSurface(folder / "map.tif");
    SurfaceOptions options;
    options.pyramid.factor = factor;
    whole = makeSurface(readRaster(folder / "map.tif"), options);
  }
  TileFolder folder;
  Surface tiled, whole;
};

}  // namespace relievo::test
