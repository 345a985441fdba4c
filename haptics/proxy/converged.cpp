// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/follow.h"
#include "haptics/proxy/proxy.h"

namespace relievo {

ProxyState convergedTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                         const ProxyOptions& options) RELIEVO_REALTIME {
  return onSurface(space, [&](const auto& surface) RELIEVO_REALTIME {
    return Follower(surface, state, options).to(hip);
  });
}

}  // namespace relievo
