// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace relievo {

/// Triple of doubles that belongs to one frame and one unit, both named by `Tag`.
/// Values with different tags do not mix; conversion is always a named function.
template <class Tag>
struct Vec3 {
  double x = 0, y = 0, z = 0;

  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vec3 operator*(double s, Vec3 v) noexcept { return {s * v.x, s * v.y, s * v.z}; }
  friend constexpr double dot(Vec3 a, Vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend double norm(Vec3 v) noexcept { return std::sqrt(dot(v, v)); }
  friend bool isFinite(Vec3 v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  }
  friend constexpr bool operator==(Vec3, Vec3) noexcept = default;
};

using FilePoint = Vec3<struct FilePointTag>;  ///< As stored in the file: its axes, its unit.
using ViewMm =
    Vec3<struct ViewMmTag>;  ///< Oriented object: x right, y up, z toward the viewer, mm.
using DeviceMm =
    Vec3<struct DeviceMmTag>;  ///< Hand: same axes, origin at the workspace centre, mm.
using DeviceMmPerS = Vec3<struct DeviceMmPerSTag>;  ///< Velocity of the hand, mm/s.
using DeviceN = Vec3<struct DeviceNTag>;            ///< Force on the hand, newtons, device axes.

}  // namespace relievo
