// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "ui/vtk/relief_scene.h"

namespace relievo {

/// A closed-form relief on a square grid whose first sample is at (0.5, 0.5) spacings.
struct SyntheticRelief {
  GridFrame frame;
  std::vector<float> heights_mm;
  std::vector<CellStatus> origins;

  SurfaceGrid grid() const { return {frame, &heights_mm, &origins}; }
};

inline SyntheticRelief makeRelief(int samples, double side_mm,
                                  const std::function<double(double, double)>& height) {
  SyntheticRelief relief;
  const double spacing = side_mm / samples;
  relief.frame = {{samples, samples}, spacing, 0.5 * spacing, 0.5 * spacing};
  for (int row = 0; row < samples; ++row) {
    for (int col = 0; col < samples; ++col) {
      relief.heights_mm.push_back(
          static_cast<float>(height(relief.frame.xMm(col), relief.frame.yMm(row))));
    }
  }
  relief.origins.assign(relief.frame.size.count(), CellStatus::measured);
  return relief;
}

/// A dome with three rings of lettering-like ridges, 100 x 100 mm, heights 0 .. about 13 mm.
inline double domeWithRidges(double x, double y) {
  const double dx = x - 50, dy = y - 50, r = std::hypot(dx, dy);
  double z = r < 40 ? 10 * (1 - (r / 40) * (r / 40)) : 0;
  const double angle = std::atan2(dy, dx);
  const auto smooth = [](double t) { return 0.5 * (1 + std::tanh(t)); };
  if (r > 24 && r < 36) {
    const double band = smooth((r - 26) * 2.5) * smooth((34 - r) * 2.5);
    z += 1.2 * band * smooth(6 * std::sin(18 * angle) + 3 * std::sin(7 * angle + r));
  }
  z += 1.8 * smooth((44 - r) * 3) * smooth((r - 41.5) * 3);
  z += 1.6 * smooth(3 * (1.2 - std::abs(dx))) * smooth(2 * (12 - std::abs(dy)));
  z += 1.6 * smooth(3 * (1.2 - std::abs(dy - 4))) * smooth(2 * (8 - std::abs(dx)));
  return z;
}

}  // namespace relievo
