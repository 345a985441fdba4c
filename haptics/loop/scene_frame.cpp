// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/scene_frame.h"

#include <algorithm>
#include <cmath>

#include "haptics/space/cell.h"

namespace relievo {

GridPoint SceneFrame::confined(GridPoint hip) RELIEVO_REALTIME {
  return {std::clamp(hip.x, 0.0, kLastSample), std::clamp(hip.y, 0.0, kLastSample), hip.z};
}

GridPoint SceneFrame::felt(const HapticSpace& space, GridPoint hip,
                           GridPoint proxy) RELIEVO_REALTIME {
  const GridPoint inside = confined(hip), over = hip - inside;
  const double beyond = norm(over);
  if (!(beyond > 0)) return hip;
  const double depth = norm(proxy - inside);
  const double most = kMostMm / space.deviceMmPerCell();
  return inside + (std::min({kSoftness * beyond, kMostPart * depth, most}) / beyond) * over;
}

std::uint8_t SceneFrame::push(const HapticSpace& space, GridPoint hip,
                              bool contact) RELIEVO_REALTIME {
  const double most = kPushMm / space.deviceMmPerCell();
  std::uint8_t sides = 0;
  if (hip.x < -most) sides |= kFrameLeft;
  if (hip.x > kLastSample + most) sides |= kFrameRight;
  if (hip.y < -most) sides |= kFrameLow;
  if (hip.y > kLastSample + most) sides |= kFrameHigh;
  pushing_ticks_ = contact && sides != 0 ? pushing_ticks_ + 1 : 0;
  return pushing_ticks_ >= kPushTicks ? sides : std::uint8_t{0};
}

}  // namespace relievo
