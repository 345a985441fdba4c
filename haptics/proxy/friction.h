// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "haptics/proxy/proxy.h"
#include "haptics/proxy/surface.h"
#include "haptics/rt/realtime.h"

namespace relievo {

// Coulomb friction as a cone on the proxy (Ruspini 1997): the proxy stays while the force lies
// within the static cone about the normal, else it goes toward its place without friction only as
// far as the dynamic cone asks. The proxy's move is all the memory there is, so that a hand at rest
// feels no drift, and every move lets the spring relax: work is only ever lost.
//
// A hand that goes on slowly stands still between two counts of its encoders. Rest is therefore a
// proxy that has stayed for kRestTicks (Karnopp 1985: a speed too small to be told from none counts
// as none); before, it slides on, and the static cone does not come back at every count.

/// At 1 kHz: a count of 0.0635 mm in so many ticks is 2.5 mm/s.
inline constexpr std::uint8_t kRestTicks = 25;

/// Tangent of the angle between the force at p and the surface's normal; infinite if it pulls.
inline double forceSlope(const Jet& jet, GridPoint p, GridPoint hip) RELIEVO_REALTIME {
  const GridPoint n = normalOf(jet), out = p - hip;
  const double along = dot(out, n);
  if (!(along > 0)) return std::numeric_limits<double>::infinity();
  return norm(out - along * n) / along;
}

/// The least such tangent over the cells that meet at the proxy: an edge holds what one side holds.
template <class Surface>
double leastForceSlope(const Surface& surface, GridPoint p, GridPoint hip) RELIEVO_REALTIME {
  const Sides sides = sidesAt(surface, p.x, p.y);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < static_cast<std::size_t>(sides.count); ++i) {
    const Jet jet = surface.patch(p.x, p.y, sides.dx[i], sides.dy[i]).jet(p.x, p.y);
    least = std::min(least, forceSlope(jet, p, hip));
  }
  return least;
}

/// Does the old proxy hold?
template <class Surface>
bool sticks(const Surface& surface, ProxyState& state,
            const ProxyOptions& options) RELIEVO_REALTIME {
  // What slides comes to rest on the dynamic cone itself; rounding must not let it creep.
  constexpr double kRounding = 1 + 1e-9;
  const double cone = state.slides ? std::min(options.dynamic_friction, options.static_friction)
                                   : options.static_friction;
  const bool holds = leastForceSlope(surface, state.position, state.hip) <= cone * kRounding;
  if (!holds) {
    state.slides = true;
    state.still = 0;
  } else if (state.slides && ++state.still >= kRestTicks) {
    state.slides = false;
  }
  return holds;
}

/// Where a proxy that came from `before` stays behind its frictionless place `state.position`: the
/// first point of that way on which the force lies within the dynamic cone.
template <class Surface>
GridPoint heldBack(const Surface& surface, GridPoint before, const ProxyState& state,
                   const ProxyOptions& options) RELIEVO_REALTIME {
  const GridPoint goal = state.position;
  const double cone = std::min(options.dynamic_friction, options.static_friction);
  // Part 0 is the goal, part 1 where it came from; below `inner` the force lies within the cone.
  const auto point_at = [&](double part) RELIEVO_REALTIME {
    GridPoint p{goal.x + part * (before.x - goal.x), goal.y + part * (before.y - goal.y), 0};
    p.z = surface.patch(p.x, p.y, 0, 0).height(p.x, p.y);
    return p;
  };
  const auto excess = [&](GridPoint p) RELIEVO_REALTIME {
    return std::min(leastForceSlope(surface, p, state.hip), 1e3) - cone;
  };
  double inner = 0, outer = 1, inner_excess = -cone, outer_excess = excess(before);
  if (!(outer_excess > 0)) return before;
  GridPoint held = goal;
  constexpr int kMostProbes = 24;
  for (int i = 0; i < kMostProbes && outer - inner > 1e-9; ++i) {
    // Illinois' rule of false position: the slope grows almost evenly along the way.
    double part = inner - inner_excess * (outer - inner) / (outer_excess - inner_excess);
    part = std::clamp(part, inner + 0.01 * (outer - inner), outer - 0.01 * (outer - inner));
    const GridPoint p = point_at(part);
    const double at = excess(p);
    if (at <= 0) {
      inner = part;
      inner_excess = at;
      outer_excess *= 0.5;
      held = p;
      if (at > -1e-9 * cone) break;
    } else {
      outer = part;
      outer_excess = at;
      inner_excess *= 0.5;
    }
  }
  // Only a move that relaxes the spring loses work.
  return norm(held - state.hip) <= norm(before - state.hip) ? held : goal;
}

}  // namespace relievo
