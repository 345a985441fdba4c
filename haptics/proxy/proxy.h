// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// How the proxy follows the hand.
enum class ProxyKind : std::uint8_t {
  converged,   ///< The nearest point that can be reached on the surface; the default.
  equation,    ///< The paper's eq. (2) to the letter.
  successive,  ///< The paper's successive approximation (sec. 3, fig. 1d).
};

inline constexpr double kMostFriction = 2;  ///< Beyond, a proxy sticks to any relief.

struct ProxyOptions {
  ProxyKind kind = ProxyKind::converged;
  double step_mm = 0.1;        ///< The paper's |delta n|, mm of hand; equation and successive only.
  int updates_per_tick = 100;  ///< Proxy runs 100 times faster than the 1 kHz force loop; likewise.
  /// Coulomb friction of the converged proxy: the largest ratio of the force along the surface to
  /// the force against it at which the proxy stays, and at which it slides. 0: none.
  double static_friction = 0, dynamic_friction = 0;
};

/// The proxy and the hand it has followed so far. In free space the two coincide.
struct ProxyState {
  GridPoint position;
  GridPoint hip;
  bool contact = false;
  bool slides = false;     ///< With friction: has not rested yet, so that the dynamic cone holds.
  std::uint8_t still = 0;  ///< Ticks in a row in which it stayed, while it slides.
  /// The way on which it trails behind its hand while it slides, of length 1 in x and y; of length
  /// 0 where it has not slid yet.
  double trail_x = 0, trail_y = 0;
};

/// Start of a stroke: free at the HIP, or, if the HIP is below the surface, on the surface straight
/// above it.
ProxyState proxyPlace(const HapticSpace& space, GridPoint hip) RELIEVO_REALTIME;

/// One millisecond: the hand has moved from state.hip to `hip` (finite). Contact is decided by the
/// proxy's own way only, never by where the HIP is: thin walls hold (paper sec. 2).
ProxyState proxyTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                     const ProxyOptions& options) RELIEVO_REALTIME;

/// Unit normal of the surface under the proxy, z > 0. On an edge between patches the normal of the
/// patch that faces the force.
GridPoint proxyNormal(const HapticSpace& space, const ProxyState& state) RELIEVO_REALTIME;

// The three kinds; proxyTick chooses.
ProxyState convergedTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                         const ProxyOptions& options) RELIEVO_REALTIME;
ProxyState equationTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                        const ProxyOptions& options) RELIEVO_REALTIME;
ProxyState successiveTick(const HapticSpace& space, ProxyState state, GridPoint hip,
                          const ProxyOptions& options) RELIEVO_REALTIME;

}  // namespace relievo
