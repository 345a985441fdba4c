// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/task.h"
#include "core/depth/depth_map.h"

namespace relievo {

struct PyramidOptions {
  int coarsest_samples = 200;  ///< Stop once both sides fit into this many samples.
};

/// One level g_l of the pyramid. Heights in true millimetres at every level.
struct PyramidLevel {
  GridFrame frame;                ///< Sample i of level l lies at first + i M^l spacing_0, exactly.
  std::vector<float> heights_mm;  ///< Row-major, row 0 lowest y.
  std::vector<float> measured;    ///< Share of measured cells under the kernel, [0, 1].
};

/// Gaussian pyramid g_0 ... g_N of a depth map; paper sec. 5, its equation for g_l(i, j), M = 2.
/// Separable (1 4 6 4 1)/16, g_l(i) centred on g_(l-1)(2i), size ceil(n/2), borders mirrored
/// without repeating the edge sample. Holes and outside take part with height 0.
struct Pyramid {
  int factor = 2;                    ///< The paper's M.
  std::vector<PyramidLevel> levels;  ///< Finest first; at least one.
};

/// [worker] @throw Cancelled
Pyramid buildPyramid(const DepthMap& map, const PyramidOptions& options = {},
                     const Task& task = {});

}  // namespace relievo
