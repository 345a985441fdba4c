// SPDX-License-Identifier: BSD-3-Clause
// The exact god-object on bilinear patches: phi(x, y) = |p - HIP|^2 / 2 over the surface point
// p = (x, y, f(x, y)) is brought down monotonically from the last proxy, cell by cell; the local
// minimum it runs into is where the force is normal to the surface (paper sec. 3, point R).
#include <algorithm>
#include <cmath>

#include "haptics/proxy/first_hit.h"
#include "haptics/proxy/incident.h"
#include "haptics/proxy/patch.h"
#include "haptics/proxy/proxy.h"

namespace relievo {

namespace {
constexpr int kMostIterations = 256;       // Of one sub-step.
constexpr int kMostPerTick = 4096;         // Of all sub-steps together: bounds the work of a tick.
constexpr double kMostSubSteps = 256;      // Each at most one cell, unless the hand jumped farther.
constexpr double kConvergedCells = 1e-11;  // Remaining slope of phi, about the distance to go.

/// First and second derivatives of phi on one patch, and the metric of the surface,
/// M = I + grad f grad f^T, in which lengths along it are measured.
struct Slope {
  double gx = 0, gy = 0;
  double m11 = 1, m12 = 0, m22 = 1, det = 1;
  double twist = 0;  ///< phi_xy = m12 + twist; phi_xx = m11, phi_yy = m22 (f is bilinear).
};

Slope slopeOf(const Patch& patch, GridPoint p, GridPoint hip) RELIEVO_REALTIME {
  const double fx = patch.slopeX(p.y), fy = patch.slopeY(p.x);
  const GridPoint e = p - hip;
  return {e.x + e.z * fx, e.y + e.z * fy,        1 + fx * fx,  fx * fy,
          1 + fy * fy,    1 + fx * fx + fy * fy, e.z * patch.d};
}

/// A direction in a cell, and how fast phi falls along it per unit of length on the surface.
struct Descent {
  double dx = 0, dy = 0, rate = 0;
  bool along_edge = false;  ///< One coordinate is held by the cell's border.
};

bool staysInside(const Patch& cell, GridPoint p, double dx, double dy) RELIEVO_REALTIME {
  return !(dx < 0 && p.x <= cell.x_low) && !(dx > 0 && p.x >= cell.x_high) &&
         !(dy < 0 && p.y <= cell.y_low) && !(dy > 0 && p.y >= cell.y_high);
}

/// Steepest way down within the closed cell: the projected gradient. Where it would leave the cell
/// the better of its two edge directions.
Descent steepest(const Patch& cell, GridPoint p, const Slope& s) RELIEVO_REALTIME {
  const double dx = -(s.m22 * s.gx - s.m12 * s.gy) / s.det;
  const double dy = -(s.m11 * s.gy - s.m12 * s.gx) / s.det;
  if (staysInside(cell, p, dx, dy)) {
    return {dx, dy, std::sqrt(std::max(0.0, -(s.gx * dx + s.gy * dy))), false};
  }
  Descent best;
  const double along_x = -s.gx / s.m11, along_y = -s.gy / s.m22;
  if (staysInside(cell, p, along_x, 0)) {
    best = {along_x, 0, std::abs(s.gx) / std::sqrt(s.m11), true};
  }
  const double rate_y = std::abs(s.gy) / std::sqrt(s.m22);
  if (rate_y > best.rate && staysInside(cell, p, 0, along_y)) best = {0, along_y, rate_y, true};
  return best;
}

/// Newton's step for phi. Where phi is not convex its Hessian M + twist J is shifted by a multiple
/// of M until its least eigenvalue (measured in M) is the old one's size, at least a tenth. Along
/// an edge phi is a parabola's square-free case, phi_xx = m11: the steepest way is Newton's.
Descent newton(const Patch& cell, GridPoint p, const Slope& s, Descent down) RELIEVO_REALTIME {
  if (down.along_edge || s.twist == 0) return down;
  const double least = 1 - (s.twist * s.m12 + std::abs(s.twist) * std::sqrt(s.m11 * s.m22)) / s.det;
  const double shift = least < 0.1 ? std::max(0.1, -least) - least : 0;
  const double h11 = s.m11 * (1 + shift), h22 = s.m22 * (1 + shift);
  const double h12 = s.m12 * (1 + shift) + s.twist;
  const double det = h11 * h22 - h12 * h12;
  const double dx = -(h22 * s.gx - h12 * s.gy) / det;
  const double dy = -(h11 * s.gy - h12 * s.gx) / det;
  if (!(det > 0) || !(s.gx * dx + s.gy * dy < 0) || !staysInside(cell, p, dx, dy)) return down;
  return {dx, dy, down.rate, false};
}

/// Largest part of a step that stays in the cell along one axis.
double partInside(double x, double dx, double low, double high) RELIEVO_REALTIME {
  if (dx > 0 && x + dx > high) return (high - x) / dx;
  if (dx < 0 && x + dx < low) return (low - x) / dx;
  return 1;
}

/// phi(p + (du, dv)) - phi(p) on the patch, without the difference of two large numbers.
double change(const Patch& patch, GridPoint p, GridPoint hip, double du,
              double dv) RELIEVO_REALTIME {
  const double df = patch.slopeX(p.y) * du + patch.slopeY(p.x) * dv + patch.d * du * dv;
  return du * (p.x + 0.5 * du - hip.x) + dv * (p.y + 0.5 * dv - hip.y) +
         df * (p.z + 0.5 * df - hip.z);
}

/// Takes the step as far as the cell reaches and phi falls. @return false: phi does not fall
bool take(const Patch& cell, GridPoint& p, GridPoint hip, Descent step) RELIEVO_REALTIME {
  const double part_x = partInside(p.x, step.dx, cell.x_low, cell.x_high);
  const double part_y = partInside(p.y, step.dy, cell.y_low, cell.y_high);
  double part = std::min({1.0, part_x, part_y});
  GridPoint next{p.x + part * step.dx, p.y + part * step.dy, 0};
  // Exactly onto the border: the neighbours then know that the point is theirs as well.
  if (part_x <= part && part_x < 1) next.x = step.dx > 0 ? cell.x_high : cell.x_low;
  if (part_y <= part && part_y < 1) next.y = step.dy > 0 ? cell.y_high : cell.y_low;
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    if (change(cell, p, hip, next.x - p.x, next.y - p.y) < 0) {
      p = {next.x, next.y, cell.height(next.x, next.y)};
      return true;
    }
    part *= 0.5;
    next = {p.x + part * step.dx, p.y + part * step.dy, 0};
    if (next.x == p.x && next.y == p.y) return false;
  }
  return false;
}

/// One step down the surface, in the incident cell that falls most. @return false: converged
bool slide(const HapticSpace& space, GridPoint& p, GridPoint hip) RELIEVO_REALTIME {
  const IncidentCells cells = incidentCells(p.x, p.y);
  Patch best_cell;
  Slope best_slope;
  Descent best;
  for (int i = 0; i < cells.count; ++i) {
    const Patch cell = patchAt(space, cells.col[i], cells.row[i]);
    const Slope slope = slopeOf(cell, p, hip);
    const Descent down = steepest(cell, p, slope);
    if (down.rate > best.rate) {
      best_cell = cell;
      best_slope = slope;
      best = down;
    }
  }
  const GridPoint e = p - hip;
  if (best.rate <= kConvergedCells + 1e-14 * norm(e)) return false;
  if (take(best_cell, p, hip, newton(best_cell, p, best_slope, best))) return true;
  return take(best_cell, p, hip, best);
}

/// Leaves the surface where the way to the HIP is free. @return true: the proxy moved
bool castToHip(const HapticSpace& space, ProxyState& state, GridPoint hip) RELIEVO_REALTIME {
  const GridPoint way = hip - state.position;
  if (riseRate(space, state.position, way) <= 1e-12 * norm(way)) return false;
  const Hit hit = firstHit(space, state.position, hip);
  if (!hit.found) {
    state.position = hip;
    state.contact = false;
    return true;
  }
  const GridPoint moved = hit.point - state.position;
  if (norm(moved) <= 1e-12) return false;  // Grazing: only rounding says that it is free.
  state.position = hit.point;
  return true;
}

/// Follows the hand to one position. @return iterations spent
int settle(const HapticSpace& space, ProxyState& state, GridPoint hip) RELIEVO_REALTIME {
  state.hip = hip;
  if (!state.contact) {
    const Hit hit = firstHit(space, state.position, hip);
    state.position = hit.point;
    state.contact = hit.found;
  }
  int iterations = 0;
  while (state.contact && iterations < kMostIterations) {
    ++iterations;
    if (castToHip(space, state, hip)) continue;
    if (!slide(space, state.position, hip)) break;
  }
  return iterations;
}
}  // namespace

ProxyState convergedTick(const HapticSpace& space, ProxyState state,
                         GridPoint hip) RELIEVO_REALTIME {
  const GridPoint from = state.hip, way = hip - from;
  const auto sub_steps = static_cast<int>(std::clamp(std::ceil(norm(way)), 1.0, kMostSubSteps));
  int spent = 0;
  for (int i = 1; i < sub_steps && spent < kMostPerTick; ++i) {
    spent += settle(space, state, from + (static_cast<double>(i) / sub_steps) * way);
  }
  settle(space, state, hip);
  return state;
}

}  // namespace relievo
