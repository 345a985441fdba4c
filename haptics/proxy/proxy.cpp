// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/proxy.h"

#include "haptics/proxy/surface.h"

namespace relievo {

ProxyState proxyPlace(const HapticSpace& space, GridPoint hip) RELIEVO_REALTIME {
  const double surface = surfaceHeight(space, hip.x, hip.y);
  if (hip.z >= surface) return {hip, hip, false, false};
  return {{hip.x, hip.y, surface}, hip, true, false};
}

ProxyState proxyTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                     const ProxyOptions& options) RELIEVO_REALTIME {
  switch (options.kind) {
    case ProxyKind::equation:
      return equationTick(space, state, hip, options);
    case ProxyKind::successive:
      return successiveTick(space, state, hip, options);
    case ProxyKind::converged:
      break;
  }
  return convergedTick(space, state, hip, options);
}

GridPoint proxyNormal(const HapticSpace& space, const ProxyState& state) RELIEVO_REALTIME {
  return onSurface(space, [&](const auto& surface) RELIEVO_REALTIME {
    const GridPoint p = state.position, out = p - state.hip;
    const Sides sides = sidesAt(surface, p.x, p.y);
    GridPoint best;
    double best_alignment = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sides.count); ++i) {
      const GridPoint n = normalOf(surface.patch(p.x, p.y, sides.dx[i], sides.dy[i]).jet(p.x, p.y));
      const double alignment = dot(n, out);
      if (i == 0 || alignment > best_alignment) {
        best = n;
        best_alignment = alignment;
      }
    }
    return best;
  });
}

}  // namespace relievo
