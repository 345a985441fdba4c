// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/first_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {

namespace {
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Smallest s in [0, 1] from which g(s) = g0 + b s + a s^2 is below zero, for g0 >= 0; kNever if
/// there is none. Written without the difference of nearly equal numbers.
double firstCrossing(double g0, double b, double a) RELIEVO_REALTIME {
  if (b >= 0 && a >= 0) return kNever;
  const double discriminant = b * b - 4 * a * g0;
  if (discriminant < 0) return kNever;  // Convex, and its lowest point is above the surface.
  const double root = std::sqrt(discriminant);
  const double s = b < 0 ? 2 * g0 / (root - b) : -(b + root) / (2 * a);
  return s <= 1 ? s : kNever;
}

/// Parameter at which the segment leaves a cell along one axis.
double leaves(double from, double step, double low, double high) RELIEVO_REALTIME {
  if (step > 0) return (high - from) / step;
  if (step < 0) return (low - from) / step;
  return kNever;
}

/// A segment and how far along it the walk has come.
struct Walk {
  GridPoint from, to, step;
  double t = 0;
  GridPoint at;
  GridPoint pointAt(double s) const RELIEVO_REALTIME { return s >= 1 ? to : from + s * step; }
};

/// Moves the walk to the end of its cell. @return how many cells it enters in x and y
struct Turn {
  int x = 0, y = 0;
};
Turn advance(Walk& walk, const Patch& cell) RELIEVO_REALTIME {
  const double tx = leaves(walk.from.x, walk.step.x, cell.x_low, cell.x_high);
  const double ty = leaves(walk.from.y, walk.step.y, cell.y_low, cell.y_high);
  walk.t = std::clamp(std::min(tx, ty), walk.t, 1.0);
  walk.at = walk.pointAt(walk.t);
  Turn turn;
  if (walk.t >= 1) return turn;
  if (tx <= ty) {  // Exactly onto the border, so that both cells agree where it is.
    turn.x = walk.step.x > 0 ? 1 : -1;
    walk.at.x = walk.step.x > 0 ? cell.x_high : cell.x_low;
  }
  if (ty <= tx) {
    turn.y = walk.step.y > 0 ? 1 : -1;
    walk.at.y = walk.step.y > 0 ? cell.y_high : cell.y_low;
  }
  return turn;
}
}  // namespace

Hit firstHit(const HapticSpace& space, GridPoint from, GridPoint to) RELIEVO_REALTIME {
  Walk walk{from, to, to - from, 0, from};
  int col = cellOf(from.x, walk.step.x), row = cellOf(from.y, walk.step.y);
  constexpr int kMostCells = 2 * (kLastCell - kFirstCell + 2);
  for (int visited = 0; visited < kMostCells; ++visited) {
    const Patch cell = patchAt(space, col, row);
    const GridPoint entry = walk.at;
    const Turn turn = advance(walk, cell);
    // Within a cell a straight line's height above the bilinear patch is a quadratic: its values
    // at both ends and its curvature -d du dv give it without cancellation.
    const double above = std::max(0.0, entry.z - cell.height(entry.x, entry.y));
    const double above_exit = walk.at.z - cell.height(walk.at.x, walk.at.y);
    const double curvature = -cell.d * (walk.at.x - entry.x) * (walk.at.y - entry.y);
    const double s = firstCrossing(above, above_exit - above - curvature, curvature);
    if (s < kNever || above_exit < 0) {
      const double part = std::min(s, 1.0);
      const GridPoint p = entry + part * (walk.at - entry);
      return {true, {p.x, p.y, cell.height(p.x, p.y)}};
    }
    if (turn.x == 0 && turn.y == 0) return {false, to};
    col = std::clamp(col + turn.x, kFirstCell, kLastCell);
    row = std::clamp(row + turn.y, kFirstCell, kLastCell);
  }
  return {true, {walk.at.x, walk.at.y, surfaceHeight(space, walk.at.x, walk.at.y)}};
}

double riseRate(const HapticSpace& space, GridPoint from, GridPoint direction) RELIEVO_REALTIME {
  const Patch cell = patchAt(space, cellOf(from.x, direction.x), cellOf(from.y, direction.y));
  return direction.z - cell.slopeX(from.y) * direction.x - cell.slopeY(from.x) * direction.y;
}

}  // namespace relievo
