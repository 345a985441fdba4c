// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/proxy/crossing.h"
#include "haptics/proxy/first_hit.h"
#include "haptics/proxy/surface.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// Grid coordinates of one window to those of another, in x, y and z: both lie in the same hand's
/// space with one scale for all axes, so that this is one scale and a translation.
struct GridFromGrid {
  double scale = 1;
  GridPoint translation;
  GridPoint operator()(GridPoint p) const RELIEVO_REALTIME { return scale * p + translation; }
};
GridFromGrid gridFromGrid(const HapticSpace& to, const HapticSpace& from) RELIEVO_REALTIME;

/// (1 - weight) of an old patch and weight of a new one, over the part of the plane that both
/// cover; the new window's grid. Height, slopes and curvature are linear in the weight.
struct BlendedPatch {
  CellBox box;
  BicubicPatch now, was;
  GridFromGrid was_from_now;
  double weight = 1;

  double height(double x, double y) const RELIEVO_REALTIME {
    const GridPoint q = was_from_now({x, y, 0});
    return weight * now.height(x, y) +
           (1 - weight) * (was.height(q.x, q.y) - was_from_now.translation.z) / was_from_now.scale;
  }
  Jet jet(double x, double y) const RELIEVO_REALTIME;
};

double crossing(const BlendedPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME;

/// A surface on its way from one window to the next, for rays and solver like any other: its cells
/// are those of both grids laid over each other.
class BlendedSurface {
 public:
  using Patch = BlendedPatch;
  /// @param weight  0: the surface of `was`; 1: that of `now`
  BlendedSurface(const HapticSpace& was, const HapticSpace& now, double weight) RELIEVO_REALTIME
      : was_(was),
        now_(now),
        was_from_now_(gridFromGrid(was, now)),
        weight_(weight) {}
  Patch patch(double x, double y, double dx, double dy) const RELIEVO_REALTIME;
  bool onLineX(double x) const RELIEVO_REALTIME;
  bool onLineY(double y) const RELIEVO_REALTIME;
  bool runsOn(const Patch& patch, double x, double y) const RELIEVO_REALTIME;
  bool isSmooth(double x, double y) const RELIEVO_REALTIME;
  double deviceMmPerCell() const RELIEVO_REALTIME { return now_.deviceMmPerCell(); }

 private:
  const HapticSpace& was_;
  const HapticSpace& now_;
  GridFromGrid was_from_now_;
  double weight_;
};

Hit firstHit(const BlendedSurface& surface, GridPoint from, GridPoint to) RELIEVO_REALTIME;

}  // namespace relievo
