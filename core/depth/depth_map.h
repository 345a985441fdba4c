// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/grid.h"
#include "core/base/origin.h"

namespace relievo {

/// Monge surface z = f(x, y) sampled on a square grid; paper sec. 3.
///
/// Heights are millimetres above the base plane (z = 0), toward the viewer. Every sample knows
/// where it comes from. Holes rest on the base plane, height 0 (the paper's z_MAX rule, sec. 6);
/// `outside` samples also have height 0 here and become NaN only in files.
struct DepthMap {
  GridFrame frame;
  std::vector<float> heights_mm;  ///< Row-major, row 0 at the lowest y; frame.size.count() values.
  std::vector<CellStatus> origins;  ///< Same order and size.

  float heightMm(Cell c) const noexcept { return heights_mm[frame.size.index(c)]; }
  CellStatus origin(Cell c) const noexcept { return origins[frame.size.index(c)]; }

  /// The map covers half a sample more than its samples, all round (view mm).
  double widthMm() const noexcept { return frame.size.cols * frame.spacing_mm; }
  double heightExtentMm() const noexcept { return frame.size.rows * frame.spacing_mm; }
  double leftMm() const noexcept { return frame.first_x_mm - 0.5 * frame.spacing_mm; }
  double bottomMm() const noexcept { return frame.first_y_mm - 0.5 * frame.spacing_mm; }
};

/// Fractions of all cells by origin, in the order of `CellStatus`; they sum to 1.
std::array<double, kOriginCount> originShares(const DepthMap& map);

/// Cells by origin.
using OriginCounts = std::array<std::size_t, kOriginCount>;
OriginCounts originCounts(const DepthMap& map);

struct HeightRange {
  double min_mm = 0, max_mm = 0;
};
/// Over cells that are not outside; 0, 0 if there are none.
HeightRange heightRange(const DepthMap& map);

}  // namespace relievo
