// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/scene_frame.h"

#include <algorithm>
#include <cmath>

#include "haptics/space/cell.h"

namespace relievo {

namespace {
struct Stopped {
  double x = 0, along = 1;
};

/// x up to `width` before `edge`, then ever slower, and `edge` from `width` beyond it on; with
/// a slope that has no step.
Stopped stoppedAt(double edge, double x, double width) RELIEVO_REALTIME {
  const double over = x - (edge - width);
  if (over <= 0) return {x, 1};
  if (over >= 2 * width) return {edge, 0};
  return {x - over * over / (4 * width), 1 - over / (2 * width)};
}

Stopped between(double low, double high, double x, double width) RELIEVO_REALTIME {
  if (2 * x >= low + high) return stoppedAt(high, x, width);
  const Stopped mirrored = stoppedAt(-low, -x, width);
  return {-mirrored.x, mirrored.along};
}

/// Against going beyond `low` or `high`.
double cushionN(double low, double high, double x, double& energy_mj) RELIEVO_REALTIME {
  const double beyond = x > high ? x - high : x < low ? low - x : 0;
  if (!(beyond > 0)) return 0;
  constexpr double kBendMm = SceneFrame::kCushionMostN / SceneFrame::kCushionNPerMm;
  energy_mj += beyond < kBendMm ? 0.5 * SceneFrame::kCushionNPerMm * beyond * beyond
                                : SceneFrame::kCushionMostN * (beyond - 0.5 * kBendMm);
  const double size = std::min(SceneFrame::kCushionNPerMm * beyond, SceneFrame::kCushionMostN);
  return x > high ? -size : size;
}
}  // namespace

FramedHand SceneFrame::framed(const HapticSpace& space, GridPoint hand) RELIEVO_REALTIME {
  const double width = kRoundingMm / space.deviceMmPerCell();
  const Stopped x = between(0, kLastSample, hand.x, width);
  const Stopped y = between(0, kLastSample, hand.y, width);
  return {{x.x, y.x, hand.z}, x.along, y.along};
}

Cushion SceneFrame::cushion(const HapticSpace& space, const Workspace& workspace, DeviceMm hand,
                            bool window) RELIEVO_REALTIME {
  DeviceMm low = -1.0 * workspace.half_extent, high = workspace.half_extent;
  if (window) {
    const DeviceMm first = space.deviceFromGrid({0, 0, 0});
    const DeviceMm last = space.deviceFromGrid({kLastSample, kLastSample, 0});
    low = {first.x, first.y, low.z};
    high = {last.x, last.y, high.z};
  }
  Cushion cushion;
  cushion.force = {cushionN(low.x, high.x, hand.x, cushion.energy_mj),
                   cushionN(low.y, high.y, hand.y, cushion.energy_mj),
                   cushionN(low.z, high.z, hand.z, cushion.energy_mj)};
  return cushion;
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
