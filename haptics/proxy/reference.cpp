// SPDX-License-Identifier: BSD-3-Clause
// The paper's two forms of the proxy (sec. 3), kept as references to compare with.
#include <cmath>

#include "haptics/proxy/first_hit.h"
#include "haptics/proxy/proxy.h"
#include "haptics/proxy/surface.h"

namespace relievo {

namespace {
GridPoint normalUnder(const HapticSpace& space, GridPoint p) RELIEVO_REALTIME {
  return normalOf(surfaceJet(space, p.x, p.y));
}
}  // namespace

/// Eq. (2), with X_p the proxy, X_h the HIP and delta n of length 0.1 mm along the normal:
///   X_p <- X_p + delta n                             if z_p < f(x_p, y_p)
///   X_p <- X_p + |delta n| (X_h - X_p)/|X_h - X_p|   otherwise
ProxyState equationTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                        const ProxyOptions& options) RELIEVO_REALTIME {
  const double step = options.step_mm / space.deviceMmPerCell();
  GridPoint p = state.position;
  state.contact = false;
  for (int i = 0; i < options.updates_per_tick; ++i) {
    if (p.z < surfaceHeight(space, p.x, p.y)) {
      state.contact = true;
      p = p + step * normalUnder(space, p);
      continue;
    }
    const GridPoint way = hip - p;
    const double distance = norm(way);
    if (distance > 0)
      p = p + (step / distance) * way;  // At the HIP itself eq. (2) has no direction.
  }
  state.position = p;
  state.hip = hip;
  return state;
}

/// Lift P by delta n along the normal to P', aim from P' at the HIP: the intersection nearest P' is
/// the next P. Ends free at the HIP where the way is clear.
ProxyState successiveTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                          const ProxyOptions& options) RELIEVO_REALTIME {
  const double step = options.step_mm / space.deviceMmPerCell();
  GridPoint lifted = state.position;  // In free space there is nothing to lift from.
  for (int i = 0; i < options.updates_per_tick; ++i) {
    if (state.contact) lifted = state.position + step * normalUnder(space, state.position);
    const Hit hit = firstHit(space, lifted, hip);
    const GridPoint moved = hit.point - state.position;
    state.position = hit.point;
    const bool was_in_contact = state.contact;
    state.contact = hit.found;
    if (!hit.found || (was_in_contact && norm(moved) < 1e-9)) break;
  }
  state.hip = hip;
  return state;
}

}  // namespace relievo
