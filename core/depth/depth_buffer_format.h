// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace relievo {

/// How an OpenGL depth buffer held the depths of a map: what its heights are good for.
struct DepthBufferFormat {
  int bits = 24;
  bool is_float = false;               ///< Else a fixed point number, 0 ... 2^bits - 1.
  double near_z_mm = 0, far_z_mm = 0;  ///< View z of the planes between which it was spread.
  bool triangles = false;              ///< Interpolated across triangles in single precision.

  double rangeMm() const noexcept { return near_z_mm - far_z_mm; }
  /// Largest distance of two depths that follow one another. Floating point: that of the half
  /// farther from the viewer, 2^-24 whatever the format's name, as depths lie in [0, 1].
  double stepMm() const noexcept {
    return rangeMm() * (is_float ? std::ldexp(1.0, -24) : 1 / (std::ldexp(1.0, bits) - 1));
  }
  /// Bound of the error against depths in double precision, away from silhouettes: a step, the
  /// rounding of a vertex and of the depth read back to single precision, and for triangles what
  /// drivers add by interpolating across a tile of pixels.
  double accuracyMm() const noexcept {
    const double rounding = rangeMm() * std::ldexp(1.0, -24);
    return stepMm() + rounding + (triangles ? 2e-5 * rangeMm() : 0);
  }
};

}  // namespace relievo
