// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "haptics/proxy/surface.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

// One step of the god-object down a patch: phi(x, y) = |p - HIP|^2 / 2 over the surface point
// p = (x, y, f(x, y)) falls; the local minimum it runs into is where the force is normal to the
// surface (paper sec. 3, point R).

inline constexpr double kConvergedCells = 1e-11;  ///< Remaining slope of phi: the distance to go.
/// A Newton step shorter than this lands closer to the minimum than 1e-10 cells: it is the last
/// one.
inline constexpr double kLastStepCells = 2e-5;

/// First and second derivatives of phi, and the metric of the surface, M = I + grad f grad f^T, in
/// which lengths along it are measured. The Hessian of phi is M + e_z H, e the way from the HIP.
struct Slope {
  double gx = 0, gy = 0;
  double m11 = 1, m12 = 0, m22 = 1;
  double h11 = 1, h12 = 0, h22 = 1;
};

inline Slope slopeOf(const Jet& f, GridPoint e) RELIEVO_REALTIME {
  const double m11 = 1 + f.fx * f.fx, m12 = f.fx * f.fy, m22 = 1 + f.fy * f.fy;
  return {e.x + e.z * f.fx,  e.y + e.z * f.fy, m11, m12, m22, m11 + e.z * f.fxx,
          m12 + e.z * f.fxy, m22 + e.z * f.fyy};
}

/// A direction along the surface, and how fast phi falls along it per unit of length.
struct Descent {
  double dx = 0, dy = 0;
  double rate = 0;
  bool trusted = false;  ///< The quadratic model has its minimum there.
};

inline bool staysInside(const CellBox& box, GridPoint p, double dx, double dy) RELIEVO_REALTIME {
  return !(dx < 0 && p.x <= box.x_low) && !(dx > 0 && p.x >= box.x_high) &&
         !(dy < 0 && p.y <= box.y_low) && !(dy > 0 && p.y >= box.y_high);
}

/// Newton's step. Where phi is not convex its Hessian is shifted by a multiple of the metric until
/// its least eigenvalue, measured in M, is the old one's size, at least a tenth.
inline Descent newton(const Slope& s) RELIEVO_REALTIME {
  double h11 = s.h11, h12 = s.h12, h22 = s.h22;
  double det = h11 * h22 - h12 * h12;
  const double det_m = s.m11 * s.m22 - s.m12 * s.m12;
  // Both eigenvalues of M^-1 H above a tenth: their sum and product say so without a root.
  const double trace = s.m22 * h11 - 2 * s.m12 * h12 + s.m11 * h22;
  const bool convex = det - 0.1 * trace + 0.01 * det_m > 0 && trace > 0.2 * det_m;
  if (!convex) {
    const double half = 0.5 * trace / det_m;
    const double least = half - std::sqrt(std::max(0.0, half * half - det / det_m));
    const double shift = std::max(0.1, -least) - least;
    h11 += shift * s.m11;
    h12 += shift * s.m12;
    h22 += shift * s.m22;
    det = h11 * h22 - h12 * h12;
  }
  const double over = 1 / det;
  return {-(h22 * s.gx - h12 * s.gy) * over, -(h11 * s.gy - h12 * s.gx) * over, 0, convex};
}

/// Newton along one axis: g / h, with h at least a tenth of the metric's.
inline double newtonAlong(double g, double h, double m) RELIEVO_REALTIME {
  return -g / std::max({h, -h, 0.1 * m});
}

/// Steepest way down within the closed cell: the projected gradient, and where it would leave the
/// cell the better of its two edge directions. Its length is Newton's along an edge.
inline Descent steepest(const CellBox& box, GridPoint p, const Slope& s) RELIEVO_REALTIME {
  const double det = s.m11 * s.m22 - s.m12 * s.m12;
  const double dx = -(s.m22 * s.gx - s.m12 * s.gy) / det;
  const double dy = -(s.m11 * s.gy - s.m12 * s.gx) / det;
  if (staysInside(box, p, dx, dy)) {
    return {dx, dy, std::sqrt(std::max(0.0, -(s.gx * dx + s.gy * dy))), false};
  }
  Descent best;
  const double along_x = newtonAlong(s.gx, s.h11, s.m11);
  const double along_y = newtonAlong(s.gy, s.h22, s.m22);
  if (staysInside(box, p, along_x, 0)) {
    best = {along_x, 0, std::abs(s.gx) / std::sqrt(s.m11), false};
  }
  const double rate_y = std::abs(s.gy) / std::sqrt(s.m22);
  if (rate_y > best.rate && staysInside(box, p, 0, along_y)) best = {0, along_y, rate_y, false};
  return best;
}

/// phi(to) - phi(from), without the difference of two large numbers.
inline double change(GridPoint from, GridPoint to, GridPoint hip) RELIEVO_REALTIME {
  const GridPoint way = to - from;
  return way.x * (from.x + 0.5 * way.x - hip.x) + way.y * (from.y + 0.5 * way.y - hip.y) +
         way.z * (from.z + 0.5 * way.z - hip.z);
}

/// Largest part of a step that stays in the cell along one axis.
inline double partInside(double x, double dx, double low, double high) RELIEVO_REALTIME {
  if (dx > 0 && x + dx > high) return std::max(0.0, (high - x) / dx);
  if (dx < 0 && x + dx < low) return std::max(0.0, (low - x) / dx);
  return 1;
}

/// Takes the step as far as the cell reaches and phi falls. @return false: phi does not fall
template <class Patch>
bool takeInside(const Patch& cell, GridPoint& p, GridPoint hip, Descent step) RELIEVO_REALTIME {
  const CellBox& box = cell.box;
  const double part_x = partInside(p.x, step.dx, box.x_low, box.x_high);
  const double part_y = partInside(p.y, step.dy, box.y_low, box.y_high);
  double part = std::min({1.0, part_x, part_y});
  GridPoint next{p.x + part * step.dx, p.y + part * step.dy, 0};
  // Exactly onto the border: the neighbours then know that the point is theirs as well.
  if (part_x <= part && part_x < 1) next.x = step.dx > 0 ? box.x_high : box.x_low;
  if (part_y <= part && part_y < 1) next.y = step.dy > 0 ? box.y_high : box.y_low;
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    if (next.x == p.x && next.y == p.y) return false;
    next.z = cell.height(next.x, next.y);
    if (change(p, next, hip) < 0) {
      p = next;
      return true;
    }
    part *= 0.5;
    next = {p.x + part * step.dx, p.y + part * step.dy, 0};
  }
  return false;
}

}  // namespace relievo
