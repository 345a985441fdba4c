// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

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
//
// A count across the way would turn the pull of a proxy that trails close behind, by k times the
// count. Friction is against the way of sliding, not against the last count of it: the proxy trails
// along a line of at least kTrailMm, and of 1.5 times what it trails by, drawn behind the hand like
// its own way (a tractrix): the count turns the pull by two thirds of what it turns the spring.

/// At 1 kHz: a count of 0.0635 mm in so many ticks is 2.5 mm/s.
inline constexpr std::uint8_t kRestTicks = 25;
/// Millimetres of the hand. A count of 0.0635 mm turns a line of this length by 0.064.
inline constexpr double kTrailMm = 1;
/// The least that the line is longer than the proxy's own way, as a part of that. Rough ground on a
/// spring of 0.5 N/mm would ripple by k times the count without it: 0.032 to 0.039 N.
inline constexpr double kTrailShare = 0.5;
/// The line may turn the proxy by no more than so many millimetres of the hand off its own way: two
/// counts of the coarsest device, so that a hand that turns is followed at once.
inline constexpr double kMostTurnMm = 0.15;

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
    state.trail_x = state.trail_y = 0;
  }
  return holds;
}

template <class Surface>
GridPoint onGround(const Surface& surface, double x, double y) RELIEVO_REALTIME {
  return {x, y, surface.patch(x, y, 0, 0).height(x, y)};
}

/// Draws the line on which the proxy trails behind its frictionless place `state.position`, from
/// `before` where it still is.
inline void drawTrail(ProxyState& state, GridPoint before, double mm_per_cell) RELIEVO_REALTIME {
  const double x = before.x - state.position.x, y = before.y - state.position.y;
  const double length = std::hypot(x, y);
  if (!(length > 0)) return;
  const double own_x = x / length, own_y = y / length;
  // What the line is longer than the proxy's own way, still on its old course.
  const double rest = std::max(kTrailMm / mm_per_cell - length, kTrailShare * length);
  const double line_x = x + rest * state.trail_x, line_y = y + rest * state.trail_y;
  const double along = line_x * own_x + line_y * own_y, across = own_x * line_y - own_y * line_x;
  state.trail_x = own_x;
  state.trail_y = own_y;
  // A hand that has turned back pulls on its own way.
  if (!(along > length)) return;
  const double most = kMostTurnMm / mm_per_cell / length;  // Sine of the turn.
  const double size = std::hypot(along, across);
  const double turn = std::clamp(across / size, -std::min(most, 1.0), std::min(most, 1.0));
  const double straight = std::sqrt(1 - turn * turn);
  state.trail_x = straight * own_x - turn * own_y;
  state.trail_y = straight * own_y + turn * own_x;
}

/// The first point of the way from `start` to the proxy's frictionless place `state.position` on
/// which the force lies within the dynamic cone; nothing: it does at the start.
template <class Surface>
std::optional<GridPoint> heldOnTheWay(const Surface& surface, GridPoint start,
                                      const ProxyState& state,
                                      const ProxyOptions& options) RELIEVO_REALTIME {
  const GridPoint goal = state.position;
  const double cone = std::min(options.dynamic_friction, options.static_friction);
  // Part 0 is the goal, part 1 the start; below `inner` the force lies within the cone.
  const auto point_at = [&](double part) RELIEVO_REALTIME {
    return onGround(surface, goal.x + part * (start.x - goal.x),
                    goal.y + part * (start.y - goal.y));
  };
  const auto excess = [&](GridPoint p) RELIEVO_REALTIME {
    return std::min(leastForceSlope(surface, p, state.hip), 1e3) - cone;
  };
  double inner = 0, outer = 1, inner_excess = -cone, outer_excess = excess(start);
  if (!(outer_excess > 0)) return std::nullopt;
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
  return held;
}

/// Where a proxy that came from `before` stays behind its frictionless place `state.position`, on
/// the line that it trails on.
template <class Surface>
GridPoint heldBack(const Surface& surface, GridPoint before, ProxyState& state,
                   const ProxyOptions& options, double mm_per_cell) RELIEVO_REALTIME {
  const GridPoint goal = state.position;
  // Only a move that relaxes the spring loses work.
  const auto relaxes = [&](GridPoint p) RELIEVO_REALTIME {
    return norm(p - state.hip) <= norm(before - state.hip);
  };
  drawTrail(state, before, mm_per_cell);
  const double length = std::hypot(before.x - goal.x, before.y - goal.y);
  const GridPoint behind =
      onGround(surface, goal.x + length * state.trail_x, goal.y + length * state.trail_y);
  if (const auto held = heldOnTheWay(surface, behind, state, options); held && relaxes(*held)) {
    return *held;
  }
  const GridPoint held = heldOnTheWay(surface, before, state, options).value_or(before);
  return relaxes(held) ? held : goal;
}

}  // namespace relievo
