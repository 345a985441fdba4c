// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/scene_change.h"

#include <algorithm>
#include <cmath>

#include "haptics/proxy/blend.h"
#include "haptics/proxy/follow.h"
#include "haptics/proxy/texture.h"

namespace relievo {

namespace {
/// The proxy where the surface has moved and the hand has not.
ProxyState liftedOn(const BlendedSurface& surface, ProxyState proxy) RELIEVO_REALTIME {
  GridPoint& p = proxy.position;
  const double height = surface.patch(p.x, p.y, 0, 0).height(p.x, p.y);
  if (!proxy.contact && p.z >= height) return proxy;
  p.z = height;
  proxy.contact = true;
  return proxy;
}
}  // namespace

/// What the whole change would do to the force of a proxy that keeps its place, in newtons: the
/// height moves it, the slope turns the force, the spring scales it.
double SceneChange::wholeDifference(const HapticSpace& was, const HapticSpace& now,
                                    const ProxyState& proxy) const RELIEVO_REALTIME {
  const GridPoint p = proxy.position;
  const Jet a = BlendedSurface(was, now, 0).patch(p.x, p.y, 0, 0).jet(p.x, p.y);
  const Jet b = BlendedSurface(was, now, 1).patch(p.x, p.y, 0, 0).jet(p.x, p.y);
  const double depth = proxy.contact ? norm(p - proxy.hip) : 0;
  const double moved = std::abs(a.f - b.f) + norm(normalOf(a) - normalOf(b)) * depth;
  // Ground that was soft may be firm now.
  const GridPoint q = gridFromGrid(was, now)(p);
  const auto part = [&](const HapticSpace& space, GridPoint at) RELIEVO_REALTIME {
    return 1 - (1 - spring_.softest_part) * (1 - firmnessAt(space, at.x, at.y).value);
  };
  const double scaled =
      std::abs(spring_.now_n_per_mm * part(now, p) - spring_.was_n_per_mm * part(was, q)) * depth;
  return now.deviceMmPerCell() *
         (std::max(spring_.was_n_per_mm, spring_.now_n_per_mm) * moved + scaled);
}

ProxyState SceneChange::begin(const HapticSpace& was, const HapticSpace& now, ProxyState proxy,
                              SpringChange spring) RELIEVO_REALTIME {
  const GridFromGrid now_from_was = gridFromGrid(now, was);
  proxy.position = now_from_was(proxy.position);
  proxy.hip = proxy.contact ? now_from_was(proxy.hip) : proxy.position;
  running_ = true;
  weight_ = ticks_ = 0;
  spring_ = spring;
  // The steepest part of the smooth step is 1.5 times its mean.
  length_ = std::max(kLeastTicks, 1.5 * wholeDifference(was, now, proxy) / kMostStepN);
  return proxy;
}

ProxyState SceneChange::follow(const HapticSpace& was, const HapticSpace& now, ProxyState proxy,
                               GridPoint hip, const ProxyOptions& options) RELIEVO_REALTIME {
  constexpr int kMostHalvings = 12;
  ticks_ += 1;
  const double cell_mm = now.deviceMmPerCell();
  const auto force = [&](const ProxyState& state) RELIEVO_REALTIME {
    return state.contact ? stiffness() * cell_mm * (state.position - state.hip) : GridPoint{};
  };
  const GridPoint before = force(proxy);
  const auto changed = [&](const ProxyState& state)
                           RELIEVO_REALTIME { return norm(force(state) - before); };

  // The surface takes a touching proxy with it and picks a free one up from below, along a smooth
  // step, or slower where the hand has moved to more of a difference.
  const double s = std::min(1.0, ticks_ / length_);
  const double weight = weight_;
  double step = std::max(0.0, s * s * (3 - 2 * s) - weight);
  ProxyState lifted;
  for (int i = 0; i < kMostHalvings; ++i, step *= 0.5) {
    weight_ = std::min(1.0, weight + step);
    lifted = liftedOn(BlendedSurface(was, now, weight_), proxy);
    if (changed(lifted) <= kMostStepN) break;
  }

  // Relief moves the proxy sideways as well, and one that is deep can slip from one hollow into the
  // next at once: then it creeps there.
  const BlendedSurface surface(was, now, weight_);
  ProxyState state = Follower(surface, lifted, options).to(hip);
  const double hand_n = stiffness() * cell_mm * norm(hip - proxy.hip);
  bool creeps = false;
  double part = 1;
  const GridPoint goal = state.position;
  for (int i = 0; i < kMostHalvings && state.contact && lifted.contact; ++i) {
    if (changed(state) <= kMostStepN + 2 * hand_n) break;
    creeps = true;
    part *= 0.5;
    GridPoint& p = state.position;
    p = lifted.position + part * (goal - lifted.position);
    p.z = surface.patch(p.x, p.y, 0, 0).height(p.x, p.y);
  }
  running_ = weight_ < 1 || (creeps && ticks_ < length_ + kMostCreepTicks);
  return state;
}

GridPoint SceneChange::normal(const HapticSpace& was, const HapticSpace& now,
                              const ProxyState& proxy) const RELIEVO_REALTIME {
  const GridPoint p = proxy.position;
  return normalOf(BlendedSurface(was, now, weight_).patch(p.x, p.y, 0, 0).jet(p.x, p.y));
}

}  // namespace relievo
