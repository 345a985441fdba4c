// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/large_array.h"
#include "core/base/task.h"
#include "core/depth/depth_map.h"

namespace relievo {

inline constexpr double kLeastFactor = 1.1;  ///< Below, there are more levels than one can use.
inline constexpr double kMostFactor = 8;     ///< Beyond, too little is left between two levels.

struct PyramidOptions {
  double factor = 2;           ///< The paper's M: 1 < M <= 8, integer or not.
  int coarsest_samples = 200;  ///< Stop once both sides fit into this many samples.
  int threads = 0;             ///< 0: as many as pay. The bytes are the same for every number.
};

/// One level g_l of the pyramid. Heights in true millimetres at every level.
struct PyramidLevel {
  GridFrame frame;               ///< Sample i of level l lies at first + i M^l spacing_0, exactly.
  LargeArray<float> heights_mm;  ///< Row-major, row 0 lowest y.
  LargeArray<float> measured;    ///< Share of measured cells under the kernel, [0, 1]; empty at
                                 ///< level 0, where the map's origins say it.
};

/// Gaussian pyramid g_0 ... g_N of a depth map; paper sec. 5, its equation for g_l(i, j).
/// Separable; g_l(i) centred on position i M of g_(l-1), size floor((n-1)/M) + 1, borders mirrored
/// without repeating the edge sample. M = 2: (1 4 6 4 1)/16; other M: a Gaussian of the variance
/// in core/pyramid/kernel.h. Holes and outside take part with height 0.
struct Pyramid {
  double factor = 2;                 ///< The paper's M.
  std::vector<PyramidLevel> levels;  ///< Finest first; at least one.
};

/// How much of a wave at a coarser level's limit, pi/M of the finer grid, passes the kernel and
/// could fold back as vibration; at most 0.3 for every M. @param factor  in (1, 8]
double gainAtNyquist(double factor);

/// Size of the next coarser level.
GridSize reducedSize(GridSize size, double factor);
/// Which levels a map of this frame has, finest first. @pre factor > 1
std::vector<GridFrame> levelFrames(const GridFrame& map, const PyramidOptions& options);

// What a cell of the map gives to the levels: holes and outside the base plane's height, also in
// maps from elsewhere.
inline float heightForLevels(CellStatus origin, float height_mm) noexcept {
  const bool on_base = origin == CellStatus::base_plane || origin == CellStatus::outside;
  return on_base ? 0.0F : height_mm;
}
inline float measuredForLevels(CellStatus origin) noexcept {
  return origin == CellStatus::measured ? 1.0F : 0.0F;
}

/// [worker]
/// @throw ArgumentError  factor outside (1, 8], or so near to 1 that the levels outgrow memory
/// @throw Cancelled
Pyramid buildPyramid(const DepthMap& map, const PyramidOptions& options = {},
                     const Task& task = {});

}  // namespace relievo
