// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

#include "core/session/surface.h"
#include "data/generate/relief_n.h"
#include "tests/core/scan_fixtures.h"

namespace relievo::test {

inline Scan reliefNScan(const samples::ReliefNOptions& options) {
  Scan scan;
  scan.points = samples::makeReliefN(options);
  finishScan(scan);
  scan.info.unit = LengthUnit::mm;
  return scan;
}

/// A map of relief N against its closed form.
struct ReliefNAccuracy {
  double rms_mm = 0;       ///< Over all cells outside the holes that have a height.
  double holes_kept = 0;   ///< Share of the true hole area that is still a hole.
  double gaps_closed = 0;  ///< Share of the cells outside the holes that have a height.
};

inline ReliefNAccuracy accuracyOnReliefN(const Surface& surface) {
  const auto file_from_view = surface.view_from_file.inverseOfSimilarity();
  const GridFrame& frame = surface.map.frame;
  std::size_t hole_cells = 0;
  std::size_t kept = 0;
  std::size_t others = 0;
  std::size_t closed = 0;
  double squares = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const Cell cell{.col = col, .row = row};
      const auto height = static_cast<double>(surface.map.heightMm(cell));
      const FilePoint at = file_from_view({frame.xMm(col), frame.yMm(row), height});
      const CellStatus origin = surface.map.origin(cell);
      if (samples::isReliefNHole(at.x, at.y)) {
        ++hole_cells;
        kept += origin == CellStatus::base_plane ? 1 : 0;
        continue;
      }
      ++others;
      if (origin == CellStatus::base_plane || origin == CellStatus::outside) continue;
      ++closed;
      const double off = at.z - samples::reliefNHeightMm(at.x, at.y);
      squares += off * off;
    }
  }
  return {.rms_mm = std::sqrt(squares / static_cast<double>(closed)),
          .holes_kept = static_cast<double>(kept) / static_cast<double>(hole_cells),
          .gaps_closed = static_cast<double>(closed) / static_cast<double>(others)};
}

inline SurfaceOptions topView(int cells) {
  SurfaceOptions options;
  options.cells = cells;
  options.view = ViewChoice{.name = "top", .rotation = std::nullopt};
  return options;
}

}  // namespace relievo::test
