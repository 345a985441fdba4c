// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/level_cut.h"

#include <algorithm>
#include <cmath>

namespace relievo {

DepthMap levelCut(const Surface& surface, Level level, const LevelSamples& samples, double gain) {
  const PyramidLevel& from = surface.pyramid.levels[static_cast<std::size_t>(level.value)];
  const GridFrame& f = from.frame;
  DepthMap cut;
  cut.frame = f;
  cut.frame.size = {.cols = samples.right - samples.left + 1,
                    .rows = samples.top - samples.bottom + 1};
  cut.frame.first_x_mm = f.xMm(samples.left);
  cut.frame.first_y_mm = f.yMm(samples.bottom);
  const GridFrame& finest = surface.map.frame;
  const auto nearest = [&](double at, double first, int count) {
    return std::clamp(static_cast<int>(std::lround((at - first) / finest.spacing_mm)), 0,
                      count - 1);
  };
  const auto factor = static_cast<float>(gain);
  for (int row = samples.bottom; row <= samples.top; ++row) {
    const int r = nearest(f.yMm(row), finest.first_y_mm, finest.size.rows);
    for (int col = samples.left; col <= samples.right; ++col) {
      const int c = nearest(f.xMm(col), finest.first_x_mm, finest.size.cols);
      cut.heights_mm.push_back(factor * from.heights_mm[f.size.index({.col = col, .row = row})]);
      cut.origins.push_back(surface.map.origin({.col = c, .row = r}));
    }
  }
  return cut;
}

}  // namespace relievo
