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
  ViewMm focal;                      ///< Middle of the rectangle, on the plane of zero parallax.
  ViewMm right, up, towards_viewer;  ///< Of the picture's plane, also of one eye's picture.
  double slant = 0;                  ///< Of the sight lines to the right: a tangent.
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

  /// The same plane of the picture, seen along sight lines slanted by this angle; right > 0. What
  /// lies on the focal plane keeps its place and its size, and nothing moves up or down. This is
  /// what VTK's camera does for the two eyes of its own stereo.
  void slantSight(double turn_deg) { slant = std::tan(turn_deg * std::numbers::pi / 180); }

  bool isUntilted() const { return slant == 0 && towards_viewer.z > 1 - 1e-12; }

  PixelPlace pixelOf(ViewMm p) const {
    const ViewMm d = p - focal;
    return {0.5 * width_px + (dot(d, right) - slant * dot(d, towards_viewer)) / mm_per_pixel,
            0.5 * height_px + dot(d, up) / mm_per_pixel};
  }
  ViewMm viewOf(PixelPlace p, double z_mm) const {
    const ViewMm q = focal + ((p.x - 0.5 * width_px) * mm_per_pixel) * right +
                     ((p.y - 0.5 * height_px) * mm_per_pixel) * up;
    const ViewMm sight = towards_viewer + slant * right;
    if (std::abs(sight.z) < 1e-9) return q;  // Edge-on: no such point on the plane.
    return q + ((z_mm - q.z) / sight.z) * sight;
  }
};

}  // namespace relievo
