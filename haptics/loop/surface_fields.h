// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/proxy/proxy.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// What a surface is beyond its shape. All of it off is F = -k d alone.
struct FieldOptions {
  double softest_part = 1;     ///< Of the stiffness, where the ground is not firm; (0, 1]; 1: off.
  double texture_mm = 0;       ///< Largest rise of the next finer level that is felt; mm of hand.
  double magnet_n = 0;         ///< Largest pull toward the surface from above it.
  double magnet_reach_mm = 3;  ///< It begins this far above, mm of hand; > 0.
  friend bool operator==(const FieldOptions&, const FieldOptions&) = default;
};

inline constexpr double kLeastSoftPart = 0.25, kMostTextureMm = 0.05;
inline constexpr double kMostMagnetN = 1, kLeastReachMm = 1, kMostReachMm = 10;
/// No place of a texture is stiffer along x or y, N/mm: less than what every grip holds without the
/// passivity stage (docs/dev/stability.md).
inline constexpr double kMostTextureStiffness = 0.5;
inline constexpr double kMostTextureN = 0.5;  ///< Of pressing, beyond which texture grows no more.

/// The share of stiffness, force (N) and energy (mJ) of the fields at the proxy of one tick, at
/// full strength. The spring itself is not in them.
struct Fields {
  double part = 1;
  DeviceN force;
  double energy_mj = 0;
  DeviceN soft;  ///< Of `force`: the slope of `part`, which goes with the spring.
};

/// Softness, texture and magnet are one potential, U = 1/2 k part(p) d^2 + T(d) r(p) + V(gap), over
/// proxy p, depth d and the gap above the surface; the force is its slope over the place of the
/// hand. So no closed way of a hand without friction gives work, and what flows is seen by the
/// passivity observer as stored energy. (Where the proxy slips, haptics/loop/soft_spring.h.)
/// @param proxy  of this tick, followed to proxy.hip  @param k  stiffness of firm ground, N/mm
/// @param held   the hand where its spring ends; proxy.hip unless it pushes over the window's frame
Fields fieldsAt(const HapticSpace& space, const ProxyState& proxy, GridPoint held, double k,
                const ProxyOptions& follow, const FieldOptions& options) RELIEVO_REALTIME;

/// Between two surfaces of which `weight` of the newer one is felt.
Fields blended(const Fields& was, const Fields& now, double weight) RELIEVO_REALTIME;

}  // namespace relievo
