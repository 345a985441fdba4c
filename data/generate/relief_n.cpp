// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/relief_n.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "data/generate/random.h"

namespace relievo::samples {
namespace {

/// Along x, of density 1 + (ratio - 1) x / side: the inverse of its distribution function.
double denserToTheRight(double uniform) {
  constexpr double kRise = kReliefNDensityRatio - 1;
  const double t = (std::sqrt(1 + kRise * (kRise + 2) * uniform) - 1) / kRise;
  return kReliefNSideMm * t;
}

double wave(double position_mm, double length_mm) {
  return std::sin(2 * std::numbers::pi * position_mm / length_mm);
}

}  // namespace

double reliefNHeightMm(double x_mm, double y_mm) {
  // Figures, folds and chisel marks: wavelengths of 41, 11 and 2.6 mm.
  return 2.5 + 1.5 * wave(x_mm, 41) * wave(y_mm + 9, 37) + 0.55 * wave(x_mm + 0.6 * y_mm, 11) +
         0.03 * wave(0.5 * x_mm - y_mm, 2.6);
}

bool isReliefNHole(double x_mm, double y_mm) {
  return std::any_of(kReliefNHoles.begin(), kReliefNHoles.end(), [&](const Disc& hole) {
    return std::hypot(x_mm - hole.x_mm, y_mm - hole.y_mm) < hole.radius_mm;
  });
}

std::vector<std::array<float, 3>> makeReliefN(const ReliefNOptions& options) {
  Random random(options.seed);
  std::vector<std::array<float, 3>> points;
  points.reserve(options.points);
  while (points.size() < options.points) {
    const double x = denserToTheRight(random.uniform());
    const double y = kReliefNSideMm * random.uniform();
    if (isReliefNHole(x, y)) continue;
    double z = reliefNHeightMm(x, y) + options.noise_mm * random.normal();
    if (options.outlier_share > 0 && random.uniform() < options.outlier_share) {
      z += random.uniform(-kReliefNOutlierMm, kReliefNOutlierMm);
    }
    points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  }
  return points;
}

}  // namespace relievo::samples
