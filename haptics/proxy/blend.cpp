// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/blend.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
/// A line of the old grid is not a round number in the new one: what is so near lies on it.
constexpr double kOnLine = 1e-9;

/// Old cell on the side of `direction`, for a coordinate that may lie on a line but for rounding.
int oldCell(double x, double direction) RELIEVO_REALTIME {
  return cellOf(x + (direction < 0 ? -kOnLine : kOnLine), direction);
}

bool smoothAt(const HapticSpace& space, double x, double y) RELIEVO_REALTIME {
  return SplineSurface(space).isSmooth(x, y);
}
}  // namespace

GridFromGrid gridFromGrid(const HapticSpace& to, const HapticSpace& from) RELIEVO_REALTIME {
  return {from.deviceMmPerCell() / to.deviceMmPerCell(),
          to.gridFromDevice(from.deviceFromGrid({0, 0, 0}))};
}

Jet BlendedPatch::jet(double x, double y) const RELIEVO_REALTIME {
  const GridPoint q = was_from_now({x, y, 0});
  const Jet a = now.jet(x, y), b = was.jet(q.x, q.y);
  const double s = was_from_now.scale, v = 1 - weight;
  return {weight * a.f + v * (b.f - was_from_now.translation.z) / s,
          weight * a.fx + v * b.fx,
          weight * a.fy + v * b.fy,
          weight * a.fxx + v * s * b.fxx,
          weight * a.fxy + v * s * b.fxy,
          weight * a.fyy + v * s * b.fyy};
}

double crossing(const BlendedPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME {
  const Sextic now = heightAbove(patch.now, from, to);
  const Sextic was = heightAbove(patch.was, patch.was_from_now(from), patch.was_from_now(to));
  Sextic above{};
  for (std::size_t k = 0; k < above.size(); ++k) {
    above[k] = patch.weight * now[k] + (1 - patch.weight) * was[k] / patch.was_from_now.scale;
  }
  above[0] = std::max(0.0, above[0]);
  const double s = firstBelowZero(above);
  return s == kNever && to.z < patch.height(to.x, to.y) ? 1 : s;
}

BlendedPatch BlendedSurface::patch(double x, double y, double dx,
                                   double dy) const RELIEVO_REALTIME {
  const GridPoint q = was_from_now_({x, y, 0});
  BlendedPatch p;
  p.now = bicubicPatch(now_, cellOf(x, dx), cellOf(y, dy));
  p.was = bicubicPatch(was_, oldCell(q.x, dx), oldCell(q.y, dy));
  p.was_from_now = was_from_now_;
  p.weight = weight_;
  const double s = was_from_now_.scale;
  const GridPoint t = was_from_now_.translation;
  p.box = {std::max(p.now.box.x_low, (p.was.box.x_low - t.x) / s),
           std::min(p.now.box.x_high, (p.was.box.x_high - t.x) / s),
           std::max(p.now.box.y_low, (p.was.box.y_low - t.y) / s),
           std::min(p.now.box.y_high, (p.was.box.y_high - t.y) / s)};
  return p;
}

bool BlendedSurface::onLineX(double x) const RELIEVO_REALTIME {
  const double q = was_from_now_({x, 0, 0}).x;
  return SplineSurface::onLineX(x) || oldCell(q, 1) != oldCell(q, -1);
}

bool BlendedSurface::onLineY(double y) const RELIEVO_REALTIME {
  const double q = was_from_now_({0, y, 0}).y;
  return SplineSurface::onLineY(y) || oldCell(q, 1) != oldCell(q, -1);
}

bool BlendedSurface::isSmooth(double x, double y) const RELIEVO_REALTIME {
  const GridPoint q = was_from_now_({x, y, 0});
  return smoothAt(now_, x, y) && smoothAt(was_, q.x, q.y);
}

bool BlendedSurface::runsOn(const Patch& patch, double x, double y) const RELIEVO_REALTIME {
  const CellBox& box = patch.box;
  return isSmooth(0.5 * (box.x_low + box.x_high), 0.5 * (box.y_low + box.y_high)) && isSmooth(x, y);
}

Hit firstHit(const BlendedSurface& surface, GridPoint from, GridPoint to) RELIEVO_REALTIME {
  const GridPoint step = to - from;
  GridPoint at = from;
  // Where the way leaves a box along one axis; never behind where it is.
  const auto leaves = [](double start, double along, double low, double high) RELIEVO_REALTIME {
    if (along > 0) return (high - start) / along;
    if (along < 0) return (low - start) / along;
    return kNever;
  };
  constexpr int kMostCells = 2000;
  double t = 0;
  for (int visited = 0; visited < kMostCells; ++visited) {
    const BlendedPatch cell = surface.patch(at.x, at.y, step.x, step.y);
    const double tx = leaves(from.x, step.x, cell.box.x_low, cell.box.x_high);
    const double ty = leaves(from.y, step.y, cell.box.y_low, cell.box.y_high);
    t = std::max(t, std::min(tx, ty));
    GridPoint exit = t >= 1 ? to : from + t * step;
    if (t < 1 && tx <= ty) exit.x = step.x > 0 ? cell.box.x_high : cell.box.x_low;
    if (t < 1 && ty <= tx) exit.y = step.y > 0 ? cell.box.y_high : cell.box.y_low;
    const double part = crossing(cell, at, exit);
    if (part <= 1) {
      const GridPoint p = at + part * (exit - at);
      return {true, {p.x, p.y, cell.height(p.x, p.y)}};
    }
    if (t >= 1) return {false, to};
    at = exit;
  }
  return {true, {at.x, at.y, surface.patch(at.x, at.y, 0, 0).height(at.x, at.y)}};
}

}  // namespace relievo
