// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relievo {

/// How well the points of a cloud carry each cell: a quality map beside the depth map. Row-major
/// like the heights; both lists are empty where the engine does not know (meshes, depth buffer).
struct QualityMap {
  std::vector<std::uint32_t> counts;  ///< Points in the cell, of every layer.
  std::vector<float> spreads_mm;      ///< Their standard deviation along the view within the layer
                                      ///< nearest the viewer; 0 below two points.

  bool empty() const noexcept { return counts.empty(); }
};

/// What a height field cannot say about an object, measured on the object's own points (clouds) or
/// surface (meshes, by area).
struct DepthLosses {
  double hidden_share = 0;    ///< Lies behind the surface nearest the viewer, [0, 1].
  double undercut_share = 0;  ///< Of the cells that are not outside: more surfaces lie one behind
                              ///< the other than the front and the back of a body.
  double steep_share = 0;     ///< Of the cells that are not outside: CellStatus::steep.
  std::size_t outliers = 0;   ///< Points (meshes: none) far off every neighbour, left out.
};

}  // namespace relievo
