// SPDX-License-Identifier: BSD-3-Clause
// A closed body whose front is known in closed form: a figure of spheres, sampled on its outside.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "core/cloud/scan.h"
#include "core/depth/view.h"

namespace relievo::test {

struct Sphere {
  std::array<double, 3> middle;
  double radius;
};

/// Trunk, head, an arm before the trunk that does not touch it, and a thin staff of beads.
inline std::vector<Sphere> sphereFigure() {
  std::vector<Sphere> spheres{{{0, 0, 0}, 40}, {{0, 0, 55}, 24}, {{30, -62, 10}, 14}};
  for (int i = 0; i < 16; ++i) spheres.push_back({{-62, -20, -40.0 + 6 * i}, 4});
  return spheres;
}

struct FigureSampling {
  std::size_t points = 30'000;
  double noise_mm = 0;
  double unevenness = 1;  ///< Density at one end over that at the other, along x.
  double strays = 0;      ///< Share of the points, anywhere in the box.
};

inline Scan sampledFigure(const std::vector<Sphere>& spheres, const FigureSampling& how,
                          unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> areas;
  for (const Sphere& s : spheres) areas.push_back(s.radius * s.radius);
  std::discrete_distribution<std::size_t> which(areas.begin(), areas.end());
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  Scan scan;
  scan.info.file = "figure.ply";
  while (scan.points.size() < how.points) {
    std::array<double, 3> p{};
    if (unit(random) < how.strays) {
      p = {-66 + 110 * unit(random), -76 + 116 * unit(random), -44 + 123 * unit(random)};
    } else {
      const Sphere& s = spheres[which(random)];
      std::array<double, 3> n{normal(random), normal(random), normal(random)};
      const double length = std::hypot(n[0], n[1], n[2]);
      const double radius = s.radius + how.noise_mm * normal(random);
      bool is_inside = false;
      for (std::size_t k = 0; k < 3; ++k) p[k] = s.middle[k] + radius * n[k] / length;
      for (const Sphere& other : spheres) {
        is_inside =
            is_inside || (&other != &s && std::hypot(p[0] - other.middle[0], p[1] - other.middle[1],
                                                     p[2] - other.middle[2]) < other.radius);
      }
      const double along = std::clamp((p[0] + 66) / 110, 0.0, 1.0);
      if (is_inside || unit(random) > 1 / how.unevenness + (1 - 1 / how.unevenness) * along) {
        continue;
      }
    }
    scan.points.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  scan.info.points = scan.info.finite_points = scan.points.size();
  return scan;
}

/// The figure's front in a rotated view, exact; coordinates of the view without a shift.
class FigureFront {
 public:
  FigureFront(const std::vector<Sphere>& spheres, const Rotation& r) : spheres_(spheres) {
    for (Sphere& s : spheres_) {
      const auto m = s.middle;
      for (std::size_t k = 0; k < 3; ++k) {
        s.middle[k] = r[3 * k] * m[0] + r[3 * k + 1] * m[1] + r[3 * k + 2] * m[2];
      }
    }
  }

  std::optional<double> at(double x, double y) const {
    double front = -std::numeric_limits<double>::infinity();
    for (const Sphere& s : spheres_) {
      const double d = std::hypot(x - s.middle[0], y - s.middle[1]);
      if (d <= s.radius) {
        front = std::max(front, s.middle[2] + std::sqrt(s.radius * s.radius - d * d));
      }
    }
    return std::isfinite(front) ? std::optional(front) : std::nullopt;
  }

 private:
  std::vector<Sphere> spheres_;
};

}  // namespace relievo::test
