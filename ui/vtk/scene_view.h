// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/vec3.h"
#include "ui/vtk/relief_scene.h"

namespace relievo {

/// Place in a picture, pixels from its lower left corner (VTK's display coordinates).
struct PixelPlace {
  double x = 0, y = 0;
};

/// An orthographic camera over a picture of given size: the exact map between view millimetres and
/// pixels. Pure geometry; VTK's camera is set from it.
struct SceneView {
  ViewMm focal;  ///< Middle of the rectangle, on the plane of zero parallax.
  ViewMm right, up, towards_viewer;
  double mm_per_pixel = 1;
  int width_px = 1, height_px = 1;

  SceneView(const ReliefCamera& camera, double focal_z_mm, int width, int height)
      : focal{camera.rect.x_mm + 0.5 * camera.rect.width_mm,
              camera.rect.y_mm + 0.5 * camera.rect.height_mm, focal_z_mm},
        width_px(std::max(width, 1)),
        height_px(std::max(height, 1)) {
    const double a = camera.azimuth_deg * std::numbers::pi / 180;
    const double e = camera.elevation_deg * std::numbers::pi / 180;
    right = {std::cos(a), 0, -std::sin(a)};
    up = {-std::sin(e) * std::sin(a), std::cos(e), -std::sin(e) * std::cos(a)};
    towards_viewer = {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
    mm_per_pixel = std::max(camera.rect.width_mm / width_px, camera.rect.height_mm / height_px);
  }

  /// The same picture from a sight line turned about its upright; right > 0. What lies on the focal
  /// plane's upright through `focal` keeps its place, and nothing moves up or down.
  void turnEye(double turn_deg) {
    const double a = turn_deg * std::numbers::pi / 180;
    const ViewMm r = right, t = towards_viewer;
    right = std::cos(a) * r + (-std::sin(a)) * t;
    towards_viewer = std::cos(a) * t + std::sin(a) * r;
  }

  bool isUntilted() const { return towards_viewer.z > 1 - 1e-12; }

  PixelPlace pixelOf(ViewMm p) const {
    const ViewMm d = p - focal;
    return {0.5 * width_px + dot(d, right) / mm_per_pixel,
            0.5 * height_px + dot(d, up) / mm_per_pixel};
  }
  ViewMm viewOf(PixelPlace p, double z_mm) const {
    const ViewMm q = focal + ((p.x - 0.5 * width_px) * mm_per_pixel) * right +
                     ((p.y - 0.5 * height_px) * mm_per_pixel) * up;
    if (std::abs(towards_viewer.z) < 1e-9) return q;  // Edge-on: no such point on the plane.
    return q + ((z_mm - q.z) / towards_viewer.z) * towards_viewer;
  }
};

}  // namespace relievo
