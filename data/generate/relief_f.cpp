// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/relief_f.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace relievo::samples {
namespace {

double squared(double v) {
  return v * v;
}

bool inside(const Disc& disc, double x, double y) {
  return squared(x - disc.x_mm) + squared(y - disc.y_mm) < squared(disc.radius_mm);
}
bool inside(const Square& square, double x, double y) {
  return std::abs(x - square.x_mm) < 0.5 * square.side_mm &&
         std::abs(y - square.y_mm) < 0.5 * square.side_mm;
}

double capMm(double x, double y) {
  if (!inside(kReliefFCap, x, y)) return 0;
  // A cap of base radius a and height h lies on a sphere of radius (a^2 + h^2) / 2h.
  const double sphere_mm =
      (squared(kReliefFCap.radius_mm) + squared(kReliefFCapHeightMm)) / (2 * kReliefFCapHeightMm);
  const double r2 = squared(x - kReliefFCap.x_mm) + squared(y - kReliefFCap.y_mm);
  return std::sqrt(squared(sphere_mm) - r2) - (sphere_mm - kReliefFCapHeightMm);
}

double ridgeMm(double y) {
  return kReliefFRidgeHeightMm *
         std::exp(-0.5 * squared((y - kReliefFRidgeY) / kReliefFRidgeSigmaMm));
}

double gratingMm(double x, double y) {
  if (!inside(kReliefFGrating, x, y)) return 0;
  return kReliefFGratingAmplitudeMm *
         (1 + std::sin(2 * std::numbers::pi * x / kReliefFGratingPeriodMm));
}

Reference grid() {
  Reference g;
  g.cols = kReliefFCols;
  g.rows = kReliefFRows;
  g.spacing = kReliefFSpacingMm;
  g.first_x = g.first_y = 0.5 * kReliefFSpacingMm;
  return g;
}

}  // namespace

double reliefFHeightMm(double x_mm, double y_mm) {
  return capMm(x_mm, y_mm) + (x_mm > kReliefFStepX ? kReliefFStepMm : 0) + ridgeMm(y_mm) +
         gratingMm(x_mm, y_mm);
}

bool isHole(double x_mm, double y_mm) {
  return inside(kReliefFHole1, x_mm, y_mm) || inside(kReliefFHole2, x_mm, y_mm) ||
         inside(kReliefFHole3, x_mm, y_mm);
}

bool isOutside(double x_mm, double y_mm) {
  const bool on_plate =
      x_mm >= 0 && x_mm <= kReliefFWidthMm && y_mm >= 0 && y_mm <= kReliefFDepthMm;
  return !on_plate || inside(kReliefFCorner, x_mm, y_mm);
}

double reliefFHoleAreaMm2(int hole) {
  const std::array<double, 3> areas{std::numbers::pi * squared(kReliefFHole1.radius_mm),
                                    squared(kReliefFHole2.side_mm),
                                    std::numbers::pi * squared(kReliefFHole3.radius_mm)};
  return areas.at(static_cast<std::size_t>(hole - 1));
}

Cloud makeReliefF() {
  Cloud cloud{"mm", false, {}};
  const Reference g = grid();
  for (int row = 0; row < g.rows; ++row) {
    for (int col = 0; col < g.cols; ++col) {
      const double x = g.x(col);
      const double y = g.y(row);
      if (!isHole(x, y) && !isOutside(x, y)) cloud.points.push_back({x, y, reliefFHeightMm(x, y)});
    }
  }
  return cloud;
}

Reference reliefFReference() {
  return evaluate(grid(), [](double x, double y) {
    return isOutside(x, y) ? std::numeric_limits<double>::quiet_NaN() : reliefFHeightMm(x, y);
  });
}

}  // namespace relievo::samples
