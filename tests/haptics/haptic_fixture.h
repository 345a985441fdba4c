// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <memory>

#include "core/region/window.h"
#include "haptics/proxy/surface.h"
#include "haptics/space/haptic_space.h"

namespace relievo::test {

/// A window over [0, side] x [0, side] whose samples follow a function of the view position.
inline RegionWindow windowOf(double side_mm, const std::function<double(double, double)>& height,
                             std::uint64_t id = 1) {
  RegionWindow window;
  window.id = id;
  window.region = {0, 0, side_mm, {}};
  window.heights_mm.resize(kWindowCount);
  window.origins.assign(kWindowCount, CellStatus::measured);
  window.min_mm = std::numeric_limits<float>::max();
  window.max_mm = std::numeric_limits<float>::lowest();
  const double cell = side_mm / kWindowSamples;
  for (int row = 0; row < kWindowSamples; ++row) {
    for (int col = 0; col < kWindowSamples; ++col) {
      const auto h = static_cast<float>(height((col + 0.5) * cell, (row + 0.5) * cell));
      window.heights_mm[static_cast<std::size_t>(row) * kWindowSamples +
                        static_cast<std::size_t>(col)] = h;
      window.min_mm = std::min(window.min_mm, h);
      window.max_mm = std::max(window.max_mm, h);
    }
  }
  return window;
}

/// The haptic space of such a window; bilinear, for which closed forms hold to the last digits.
inline std::unique_ptr<HapticSpace> spaceOf(double side_mm,
                                            const std::function<double(double, double)>& height,
                                            std::uint64_t id = 1, DetailStep step = {},
                                            SurfaceKind kind = SurfaceKind::bilinear) {
  auto space = std::make_unique<HapticSpace>();
  fill(*space, windowOf(side_mm, height, id), step, kind);
  return space;
}

/// How far a point lies below the surface, view mm; negative above it.
inline double belowMm(const HapticSpace& space, ViewMm p) {
  const GridPoint g = space.gridFromView(p);
  return space.cell_mm * (surfaceHeight(space, g.x, g.y) - g.z);
}

template <class Tag>
double angleDegrees(Vec3<Tag> a, Vec3<Tag> b) {
  const Vec3<Tag> cross{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return std::atan2(norm(cross), dot(a, b)) * 180 / std::acos(-1.0);
}

}  // namespace relievo::test
