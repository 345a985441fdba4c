// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/vec3.h"
#include "haptics/device/falcon/protocol.h"
#include "haptics/rt/realtime.h"

namespace relievo::falcon {

// Geometry of the three arms, without input, output or state. Naming follows L.-W. Tsai and
// R. Stamper, "A parallel manipulator with only translational degrees of freedom" (1997):
// theta is an arm's motor angle, p the platform with the grip.

/// Grip seen from the centre of the base: x right, y up, z out of the device toward the user, mm.
using BaseMm = Vec3<struct FalconBaseTag>;
/// Motor angles, rad: top, right, left.
using Angles = std::array<double, kArms>;
/// Torques of the motors on their arms, N mm.
using Torques = std::array<double, kArms>;
/// d theta / d p, rad/mm; row i is arm i.
using AngleJacobian = std::array<std::array<double, 3>, kArms>;

/// The middle of the reachable space is where it is widest all round.
inline constexpr BaseMm kCentre{0, 0, 125};

inline DeviceMm deviceFromBase(BaseMm p) RELIEVO_REALTIME {
  return {p.x - kCentre.x, p.y - kCentre.y, p.z - kCentre.z};
}
inline BaseMm baseFromDevice(DeviceMm p) RELIEVO_REALTIME {
  return {p.x + kCentre.x, p.y + kCentre.y, p.z + kCentre.z};
}

Angles anglesFromEncoders(const std::array<std::int16_t, kArms>& encoders) RELIEVO_REALTIME;
/// Not rounded.
std::array<double, kArms> encodersFromAngles(const Angles& angles) RELIEVO_REALTIME;

/// Where the grip is. Newton's method on the three closure equations from the middle of the space;
/// it needs at most eight steps and no inverse trigonometric function.
/// @return nothing: no place belongs to these angles
std::optional<BaseMm> gripFromAngles(const Angles& angles) RELIEVO_REALTIME;

/// Closed form. @return nothing: out of reach
std::optional<Angles> anglesFromGrip(BaseMm grip) RELIEVO_REALTIME;

/// Precondition: grip and angles belong together. @return nothing: an arm is stretched out
std::optional<AngleJacobian> angleJacobian(BaseMm grip, const Angles& angles) RELIEVO_REALTIME;

/// Torques that push the hand with `force`: tau with H^T tau = F, so that tau . dtheta = F . dp.
/// @return nothing: in this pose some direction cannot be pushed
std::optional<Torques> torquesForForce(const AngleJacobian& jacobian,
                                       DeviceN force) RELIEVO_REALTIME;

/// Motor counts for one N mm. The true value is not known for certain and differs by device: it is
/// a setting that a known weight calibrates.
inline constexpr double kNominalCountsPerNmm = 10.0;

/// Rounded counts; all three are scaled alike if one is beyond 4095, so that the direction stays.
/// Zero if a torque is not finite.
std::array<std::int16_t, kArms> countsForTorques(const Torques& torques,
                                                 double counts_per_n_mm) RELIEVO_REALTIME;

}  // namespace relievo::falcon
