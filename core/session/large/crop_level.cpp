// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/crop_level.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/failure.h"
#include "core/tiles/tiled_map.h"

namespace relievo {

const GridFrame& levelFrame(const Surface& surface, Level level) {
  if (level.value < 0 || level.value >= surface.ladder.levels()) {
    throw failure<MessageId::surface_has_no_level>(level.value);
  }
  const auto index = static_cast<std::size_t>(level.value);
  return surface.tiles ? surface.tiles->frames()[index] : surface.pyramid.levels[index].frame;
}

DepthMap cropLevel(const Surface& surface, Level level, const LevelSamples& samples, double gain) {
  const GridFrame& f = levelFrame(surface, level);
  const auto factor = static_cast<float>(gain);
  const Cell first{.col = samples.left, .row = samples.bottom};
  const GridSize size{.cols = samples.right - samples.left + 1,
                      .rows = samples.top - samples.bottom + 1};
  if (surface.tiles) {
    DepthMap cut = surface.tiles->part(level, first, size);
    for (float& height : cut.heights_mm) height *= factor;
    return cut;
  }
  DepthMap cut;
  cut.frame = f;
  cut.frame.size = size;
  cut.frame.first_x_mm = f.xMm(first.col);
  cut.frame.first_y_mm = f.yMm(first.row);
  const LargeArray<float>& heights =
      surface.pyramid.levels[static_cast<std::size_t>(level.value)].heights_mm;
  // As the levels of a map by tiles have them (PyramidRows): a node that lies between two cells has
  // the upper one, whatever the rounding of its place in millimetres.
  const GridFrame& finest = surface.map.frame;
  const double step = f.spacing_mm / finest.spacing_mm;
  const auto nearest = [step](int node, int count) {
    return std::min(static_cast<int>(std::lround(node * step)), count - 1);
  };
  for (int row = samples.bottom; row <= samples.top; ++row) {
    const int r = nearest(row, finest.size.rows);
    for (int col = samples.left; col <= samples.right; ++col) {
      const int c = nearest(col, finest.size.cols);
      cut.heights_mm.push_back(factor * heights[f.size.index({.col = col, .row = row})]);
      cut.origins.push_back(surface.map.origin({.col = c, .row = r}));
    }
  }
  return cut;
}

DepthMap cropLevel(const Surface& surface, Level level) {
  const GridSize size = levelFrame(surface, level).size;
  return cropLevel(surface, level,
                   {.left = 0, .right = size.cols - 1, .bottom = 0, .top = size.rows - 1}, 1);
}

}  // namespace relievo
