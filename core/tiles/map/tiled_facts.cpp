// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/map/tiled_facts.h"

#include <cmath>

#include "core/pyramid/pyramid.h"

namespace relievo {

void TiledFacts::layOut(const GridFrame& finest, const std::vector<GridSize>& sizes) {
  for (std::size_t l = 0; l < sizes.size(); ++l) {
    GridFrame frame = finest;
    frame.size = sizes[l];
    frame.spacing_mm = finest.spacing_mm * std::pow(factor, static_cast<double>(l));
    frames.push_back(frame);
  }
  ladder = {.left_mm = finest.first_x_mm - 0.5 * finest.spacing_mm,
            .bottom_mm = finest.first_y_mm - 0.5 * finest.spacing_mm,
            .width_mm = finest.size.cols * finest.spacing_mm,
            .height_mm = finest.size.rows * finest.spacing_mm,
            .spacings_mm = {},
            .factor = factor};
  for (const GridFrame& frame : frames) ladder.spacings_mm.push_back(frame.spacing_mm);
}

std::optional<std::size_t> TiledFacts::oddLevel() const {
  for (std::size_t l = 1; l < frames.size(); ++l) {
    if (!(frames[l].size == reducedSize(frames[l - 1].size, factor))) return l;
  }
  return std::nullopt;
}

bool TiledFacts::takeCounts(const std::array<double, kOriginCount>& cells_by_status) {
  // A double is a whole number up to 2^53 cells.
  const auto cells = static_cast<double>(frames[0].size.count());
  double all = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    all += cells_by_status[i];
    shares[i] = cells_by_status[i] / cells;
  }
  return all == cells;
}

}  // namespace relievo
