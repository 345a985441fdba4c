// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/scene_change.h"

#include <algorithm>
#include <cmath>

#include "haptics/force/passivity.h"
#include "haptics/proxy/blend.h"
#include "haptics/proxy/follow.h"
#include "haptics/proxy/texture.h"

namespace relievo {

namespace {
double heightAt(const BlendedSurface& surface, GridPoint p) RELIEVO_REALTIME {
  return surface.patch(p.x, p.y, 0, 0).height(p.x, p.y);
}

/// The proxy where the surface has moved and the hand has not.
/// @param rests  the proxy is on the surface and goes down with it; else it is only picked up
ProxyState liftedOn(const BlendedSurface& surface, ProxyState proxy, bool rests) RELIEVO_REALTIME {
  const double height = heightAt(surface, proxy.position);
  if (!rests && proxy.position.z >= height) return proxy;
  proxy.position.z = height;
  proxy.contact = true;
  return proxy;
}

double springMm(const ProxyState& proxy, double cell_mm) RELIEVO_REALTIME {
  return proxy.contact ? cell_mm * norm(proxy.position - proxy.hip) : 0;
}
}  // namespace

double SurfaceLift::givenMj(double k, double most_n) const RELIEVO_REALTIME {
  return springEnergyMj(k, after_mm, most_n) - springEnergyMj(softer * k, before_mm, most_n);
}

/// What the whole change would do to the force of a proxy that keeps its place and its depth, in
/// newtons: the slope turns the force, the spring scales it.
double SceneChange::differenceInPlace(const HapticSpace& was, const HapticSpace& now,
                                      const ProxyState& proxy) const RELIEVO_REALTIME {
  const GridPoint p = proxy.position;
  const Jet a = BlendedSurface(was, now, 0).patch(p.x, p.y, 0, 0).jet(p.x, p.y);
  const Jet b = BlendedSurface(was, now, 1).patch(p.x, p.y, 0, 0).jet(p.x, p.y);
  const double depth = proxy.contact ? norm(p - proxy.hip) : 0;
  const double turned = norm(normalOf(a) - normalOf(b)) * depth;
  // Ground that was soft may be firm now.
  const GridPoint q = gridFromGrid(was, now)(p);
  const auto part = [&](const HapticSpace& space, GridPoint at) RELIEVO_REALTIME {
    return 1 - (1 - spring_.softest_part) * (1 - firmnessAt(space, at.x, at.y).value);
  };
  const double scaled =
      std::abs(spring_.now_n_per_mm * part(now, p) - spring_.was_n_per_mm * part(was, q)) * depth;
  return now.deviceMmPerCell() *
         (std::max(spring_.was_n_per_mm, spring_.now_n_per_mm) * turned + scaled);
}

ProxyState SceneChange::begin(const HapticSpace& was, const HapticSpace& now, ProxyState proxy,
                              SpringChange spring) RELIEVO_REALTIME {
  const GridFromGrid now_from_was = gridFromGrid(now, was);
  proxy.position = now_from_was(proxy.position);
  proxy.hip = proxy.contact ? now_from_was(proxy.hip) : proxy.position;
  running_ = true;
  weight_ = creep_ticks_ = 0;
  lets_go_ = false;
  spring_ = spring;
  return proxy;
}

/// Largest step of the weight that anything but the surface's height allows.
double SceneChange::mostStep(const HapticSpace& was, const HapticSpace& now,
                             const ProxyState& proxy,
                             const FeltSpring& felt) const RELIEVO_REALTIME {
  if (!(felt.gain > 0)) return 1;
  if (!proxy.contact) return felt.pull_n > 0 ? kMostStepN / (felt.gain * felt.pull_n) : 1;
  const double other_n = felt.gain * differenceInPlace(was, now, proxy);
  return std::min(1 / kLeastTicks, kMostStepN / std::max(other_n, 1e-9));
}

GridPoint SceneChange::felt(const ProxyState& state, double cell_mm,
                            const FeltSpring& felt) const RELIEVO_REALTIME {
  const GridPoint out = state.position - state.hip;
  // A surface that has sunk below the hand lets it go.
  if (!state.contact || !(out.z > 0 || lets_go_)) return {};
  const GridPoint n = felt.gain * stiffness() * cell_mm * out;
  const double size = norm(n);
  return size > felt.limit_n ? (felt.limit_n / size) * n : n;
}

/// Where the hand would come to from `at`: a proxy that lets go is in the air, and falls from
/// there.
ProxyState SceneChange::goal(const BlendedSurface& surface, ProxyState at, GridPoint hip,
                             const ProxyOptions& options) const RELIEVO_REALTIME {
  if (lets_go_) at.contact = false;
  return Follower(surface, at, options).to(hip);
}

SurfaceLift SceneChange::follow(const HapticSpace& was, const HapticSpace& now, ProxyState& proxy,
                                GridPoint hip, const ProxyOptions& options,
                                const FeltSpring& spring) RELIEVO_REALTIME {
  constexpr int kMostHalvings = 16;
  const double cell_mm = now.deviceMmPerCell();
  const GridPoint before = felt(proxy, cell_mm, spring);
  const auto changed = [&](const ProxyState& state)
                           RELIEVO_REALTIME { return norm(felt(state, cell_mm, spring) - before); };

  // The surface takes a touching proxy with it and picks a free one up from below.
  const double weight = weight_;
  const double stiffness_before = stiffness();
  double step = std::min(1 - weight, mostStep(was, now, proxy, spring));
  ProxyState lifted;
  for (int i = 0; i < kMostHalvings; ++i, step *= 0.5) {
    weight_ = std::min(1.0, weight + step);
    lifted = liftedOn(BlendedSurface(was, now, weight_), proxy, proxy.contact && !lets_go_);
    if (changed(lifted) <= kMostStepN) break;
  }
  const SurfaceLift lift{springMm(proxy, cell_mm), springMm(lifted, cell_mm),
                         stiffness_before / stiffness()};

  // Relief moves the proxy sideways as well, and one that is deep can slip from one hollow into the
  // next at once, or off a flank that is no longer there: then it creeps there.
  const BlendedSurface surface(was, now, weight_);
  if (lets_go_ && lifted.position.z <= heightAt(surface, lifted.position)) lets_go_ = false;
  const ProxyState end = goal(surface, lifted, hip, options);
  ProxyState state = end;
  const double most_n =
      kMostStepN + 2 * spring.gain * stiffness() * cell_mm * norm(hip - proxy.hip);
  bool creeps = false;
  const bool in_air = lets_go_ || (lifted.contact && !end.contact);
  double part = 1;
  for (int i = 0; i < kMostHalvings && lifted.contact; ++i) {
    if (changed(state) <= most_n) break;
    creeps = true;
    part *= 0.5;
    state = end;
    state.contact = true;
    GridPoint& p = state.position;
    p = lifted.position + part * (end.position - lifted.position);
    const double height = heightAt(surface, p);
    // Never below the surface, nor so that it would draw the hand down.
    p.z = in_air ? std::max({p.z, height, hip.z}) : height;
    lets_go_ = in_air;
  }
  if (!creeps) lets_go_ = false;
  if (weight_ >= 1) creep_ticks_ += 1;
  running_ = weight_ < 1 || (creeps && creep_ticks_ < kMostCreepTicks);
  proxy = state;
  return lift;
}

GridPoint SceneChange::normal(const HapticSpace& was, const HapticSpace& now,
                              const ProxyState& proxy) const RELIEVO_REALTIME {
  const GridPoint p = proxy.position;
  return normalOf(BlendedSurface(was, now, weight_).patch(p.x, p.y, 0, 0).jet(p.x, p.y));
}

}  // namespace relievo
