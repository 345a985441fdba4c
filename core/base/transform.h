// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/base/vec3.h"

namespace relievo {

/// Affine map from frame `From` to frame `To`; 4 x 4, row-major, last row 0 0 0 1.
/// Named targetFromSource, as in `view_from_file`.
template <class To, class From>
struct Transform {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  constexpr To operator()(From p) const noexcept {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
            m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
  }

  /// Inverse of a map that is rotation times one positive scale, plus a translation.
  constexpr Transform<From, To> inverseOfSimilarity() const noexcept {
    const double scale_squared = m[0] * m[0] + m[4] * m[4] + m[8] * m[8];
    Transform<From, To> r;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) r.m[4 * i + j] = m[4 * j + i] / scale_squared;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      r.m[4 * i + 3] = -(r.m[4 * i] * m[3] + r.m[4 * i + 1] * m[7] + r.m[4 * i + 2] * m[11]);
    }
    return r;
  }

  friend constexpr bool operator==(const Transform&, const Transform&) noexcept = default;
};

using ViewFromFile = Transform<ViewMm, FilePoint>;
using DeviceFromView = Transform<DeviceMm, ViewMm>;
using ViewFromDevice = Transform<ViewMm, DeviceMm>;

}  // namespace relievo
