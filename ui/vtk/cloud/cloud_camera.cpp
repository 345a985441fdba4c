// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/cloud/cloud_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {

constexpr double kMargin = 1.08;
constexpr double kLeastHeight = 1e-9;

FilePoint row(const Rotation& r, std::size_t i) noexcept {
  return {r[3 * i], r[3 * i + 1], r[3 * i + 2]};
}

double unitsPerPixel(const CloudCamera& camera, const PictureSize& size) noexcept {
  return camera.height / std::max(1, size.height);
}

}  // namespace

std::array<double, 3> seenAt(const CloudCamera& camera, const FilePoint& p) noexcept {
  return {dot(row(camera.view, 0), p), dot(row(camera.view, 1), p), dot(row(camera.view, 2), p)};
}

PicturePlace placeOf(const CloudCamera& camera, const PictureSize& size,
                     const FilePoint& p) noexcept {
  const double unit = unitsPerPixel(camera, size);
  const FilePoint from_middle = p - camera.middle;
  return {0.5 * size.width + dot(row(camera.view, 0), from_middle) / unit,
          0.5 * size.height - dot(row(camera.view, 1), from_middle) / unit};
}

std::array<double, 2> seenUnder(const CloudCamera& camera, const PictureSize& size,
                                const PicturePlace& place) noexcept {
  const double unit = unitsPerPixel(camera, size);
  const auto middle = seenAt(camera, camera.middle);
  return {middle[0] + (place.x - 0.5 * size.width) * unit,
          middle[1] + (0.5 * size.height - place.y) * unit};
}

CloudCamera turnedBy(const CloudCamera& camera, double right_deg, double up_deg,
                     double tilt_deg) noexcept {
  // The object turns about the picture's y by right_deg and about its x by -up_deg.
  CloudCamera result = camera;
  result.view = turned(camera.view, {-up_deg, right_deg, tilt_deg});
  return result;
}

CloudCamera fitted(const CloudCamera& camera, const FileBounds& box, const PictureSize& size) {
  CloudCamera result = camera;
  result.middle = 0.5 * (box.min + box.max);
  const FilePoint half = 0.5 * (box.max - box.min);
  const auto reach = [&](std::size_t i) {
    const FilePoint axis = row(camera.view, i);
    return std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
  };
  const double shape = static_cast<double>(std::max(1, size.width)) / std::max(1, size.height);
  const double height = 2 * kMargin * std::max(reach(1), reach(0) / shape);
  result.height = height > kLeastHeight ? height : 1;
  return result;
}

std::optional<std::size_t> pointUnder(const CloudCamera& camera, const PictureSize& size,
                                      const PicturePlace& place, double radius_px,
                                      const FilePoint& origin,
                                      std::span<const std::array<float, 3>> points) {
  const double unit = unitsPerPixel(camera, size);
  const double reach = radius_px * unit;
  const auto under = seenUnder(camera, size, place);
  const auto shift = seenAt(camera, origin);
  const Rotation& r = camera.view;
  std::optional<std::size_t> best;
  double best_value = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto x = static_cast<double>(points[i][0]), y = static_cast<double>(points[i][1]),
               z = static_cast<double>(points[i][2]);
    const double dx = shift[0] + r[0] * x + r[1] * y + r[2] * z - under[0];
    if (std::abs(dx) > reach) continue;
    const double dy = shift[1] + r[3] * x + r[4] * y + r[5] * z - under[1];
    const double aside = std::hypot(dx, dy);
    if (aside > reach) continue;
    // Of a surface seen at a slant the point under the place counts, not the nearest of the rim.
    const double value = r[6] * x + r[7] * y + r[8] * z - 2 * aside;
    if (best && value <= best_value) continue;
    best = i;
    best_value = value;
  }
  return best;
}

}  // namespace relievo
