// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/prepare/recipe.h"

/// What the files of the alignment share and nobody else sees: poses between the scans' middles.
namespace relievo::align {

/// From a scan's middle to another's, axes as in their files; file units.
using LocalPose = Eigen::Isometry3d;

inline Eigen::Vector3d vector(const std::array<float, 3>& p) noexcept {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}
inline Eigen::Vector3d vector(const FilePoint& p) noexcept {
  return {p.x, p.y, p.z};
}

/// Turns by |turn| radians about it through `centre`, then moves.
LocalPose motionAbout(const Eigen::Vector3d& centre, const Eigen::Vector3d& turn,
                      const Eigen::Vector3d& move);

/// With the nearest true rotation: what many products, or floats, have lost of it.
LocalPose exactlyRigid(const LocalPose& pose);

double turnOf(const LocalPose& pose);  ///< Radians, [0, pi].

Pose fileFromMiddles(const LocalPose& pose, const FilePoint& reference_middle,
                     const FilePoint& scan_middle);
LocalPose middlesFromFile(const Pose& pose, const FilePoint& reference_middle,
                          const FilePoint& scan_middle);

}  // namespace relievo::align
