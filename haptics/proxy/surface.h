// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "haptics/proxy/patch.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

// What rays, solver and normals see of a surface:
//   Patch                     a box and a polynomial with height(x, y) and jet(x, y)
//   patch(x, y, dx, dy)       the one that holds (x, y); on a line between cells the one on the
//                             side of the direction (dx, dy)
//   onLineX(x), onLineY(y)    is that coordinate on a line between two cells?
//   runsOn(patch, x, y)       the surface is C1 from the patch to (x, y), at most one cell away
//   isSmooth(x, y)            nothing breaks in the cell around it
//   deviceMmPerCell()         millimetres of the hand from sample to sample
// Two such surfaces exist, and a third that blends two windows (haptics/proxy/blend.h).

/// Facets over one window.
class BilinearSurface {
 public:
  using Patch = BilinearPatch;
  explicit BilinearSurface(const HapticSpace& space) RELIEVO_REALTIME : space_(space) {}
  Patch patch(double x, double y, double dx, double dy) const RELIEVO_REALTIME {
    return bilinearPatch(space_, cellOf(x, dx), cellOf(y, dy));
  }
  Patch cell(int col, int row) const RELIEVO_REALTIME { return bilinearPatch(space_, col, row); }
  static bool onLineX(double x) RELIEVO_REALTIME { return cellOf(x, 1) != cellOf(x, -1); }
  static bool onLineY(double y) RELIEVO_REALTIME { return cellOf(y, 1) != cellOf(y, -1); }
  static bool runsOn(const Patch&, double, double) RELIEVO_REALTIME { return false; }
  static bool isSmooth(double, double) RELIEVO_REALTIME { return false; }
  const HapticSpace& space() const RELIEVO_REALTIME { return space_; }
  double deviceMmPerCell() const RELIEVO_REALTIME { return space_.deviceMmPerCell(); }

 private:
  const HapticSpace& space_;
};

/// The spline over one window, with its breaks.
class SplineSurface {
 public:
  using Patch = BicubicPatch;
  explicit SplineSurface(const HapticSpace& space) RELIEVO_REALTIME : space_(space) {}
  Patch patch(double x, double y, double dx, double dy) const RELIEVO_REALTIME {
    return bicubicPatch(space_, cellOf(x, dx), cellOf(y, dy));
  }
  Patch cell(int col, int row) const RELIEVO_REALTIME { return bicubicPatch(space_, col, row); }
  static bool onLineX(double x) RELIEVO_REALTIME { return cellOf(x, 1) != cellOf(x, -1); }
  static bool onLineY(double y) RELIEVO_REALTIME { return cellOf(y, 1) != cellOf(y, -1); }
  bool runsOn(const Patch& patch, double x, double y) const RELIEVO_REALTIME {
    return isSmooth(patch.box.x_low, patch.box.y_low) && isSmooth(x, y);
  }
  /// Does the point lie in a cell between samples without a break?
  bool isSmooth(double x, double y) const RELIEVO_REALTIME {
    if (!(x >= 0 && y >= 0 && x < kLastSample && y < kLastSample)) return false;
    return isSmoothCell(space_, static_cast<int>(x), static_cast<int>(y));
  }
  const HapticSpace& space() const RELIEVO_REALTIME { return space_; }
  double deviceMmPerCell() const RELIEVO_REALTIME { return space_.deviceMmPerCell(); }

 private:
  const HapticSpace& space_;
};

/// Calls `work` with the surface that the window was prepared for.
template <class Work>
auto onSurface(const HapticSpace& space, const Work& work) RELIEVO_REALTIME {
  if (space.surface == SurfaceKind::bilinear) return work(BilinearSurface(space));
  return work(SplineSurface(space));
}

/// f(x, y) of the window's surface, grid units.
inline double surfaceHeight(const HapticSpace& space, double x, double y) RELIEVO_REALTIME {
  return onSurface(space, [=](const auto& s) { return s.patch(x, y, 0, 0).height(x, y); });
}

/// The same with its derivatives.
inline Jet surfaceJet(const HapticSpace& space, double x, double y) RELIEVO_REALTIME {
  return onSurface(space, [=](const auto& s) { return s.patch(x, y, 0, 0).jet(x, y); });
}

/// Unit normal; z > 0.
inline GridPoint normalOf(const Jet& jet) RELIEVO_REALTIME {
  const double length = std::sqrt(1 + jet.fx * jet.fx + jet.fy * jet.fy);
  return {-jet.fx / length, -jet.fy / length, 1 / length};
}

/// The closed cells, 1, 2 or 4, that contain a point, as directions to ask patch() for.
struct Sides {
  int count = 1;
  std::array<double, 4> dx{1, 1, 1, 1}, dy{1, 1, 1, 1};
};

template <class Surface>
Sides sidesAt(const Surface& surface, double x, double y) RELIEVO_REALTIME {
  Sides sides;
  const bool two_x = surface.onLineX(x), two_y = surface.onLineY(y);
  if (!two_x && !two_y) return sides;  // The usual case: inside one cell.
  sides.count = 0;
  for (const double dy : {-1.0, 1.0}) {
    if (dy < 0 && !two_y) continue;
    for (const double dx : {-1.0, 1.0}) {
      if (dx < 0 && !two_x) continue;
      sides.dx[static_cast<std::size_t>(sides.count)] = dx;
      sides.dy[static_cast<std::size_t>(sides.count)] = dy;
      ++sides.count;
    }
  }
  return sides;
}

}  // namespace relievo
