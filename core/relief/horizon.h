// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/depth/depth_map.h"

namespace relievo {

/// How high the horizon stands around a cell, in 16 directions. Heights between samples are
/// bilinear. Keeps a reference to the map. [any thread]
class HorizonSearch {
 public:
  static constexpr int kDirections = 16;

  /// @param radius_samples  how far is looked, >= 1
  HorizonSearch(const DepthMap& map, double radius_samples);

  /// 1 - mean of sin(horizon), horizons below level counting as level: 1 on open ground (Zaksek,
  /// Ostir, Kokalj 2011, eq. 4).
  double skyView(Cell at) const;
  /// Mean zenith angle of the horizon, degrees: 90 on a plane, less in a hollow, more on a ridge
  /// (Yokoyama, Shirasawa, Pike 2002).
  double openness(Cell at) const;

 private:
  struct Step {
    int col = 0, row = 0;     ///< Lower left of the four samples, from the cell.
    float right = 0, up = 0;  ///< Weights of the other ones.
    float per_mm = 0;         ///< 1 / distance.
  };
  using Tangents = std::array<float, kDirections>;
  /// Tangent of the horizon's angle; a direction that leaves the object at once is level.
  Tangents tangents(Cell at) const;

  const DepthMap& map_;
  std::array<std::vector<Step>, kDirections> rays_;
};

}  // namespace relievo
