// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace relievo {
namespace {

// conventions: file axes that become view x, y, z.
const std::array<std::pair<std::string_view, Rotation>, 6> kStandardViews{{
    {"top", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"front", {1, 0, 0, 0, 0, 1, 0, -1, 0}},
    {"right", {0, 1, 0, 0, 0, 1, 1, 0, 0}},
    {"back", {-1, 0, 0, 0, 0, 1, 0, 1, 0}},
    {"left", {0, -1, 0, 0, 0, 1, -1, 0, 0}},
    {"bottom", {1, 0, 0, 0, -1, 0, 0, 0, -1}},
}};

ViewMm rotate(const Rotation& r, const FilePoint& p) noexcept {
  return {r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
          r[6] * p.x + r[7] * p.y + r[8] * p.z};
}

FilePoint localPoint(const Scan& scan, std::size_t i) noexcept {
  const auto& p = scan.points[i];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// A look at the scan from one side on a coarse grid.
struct Look {
  double area = 0;     ///< Occupied cells times cell size squared.
  double visible = 0;  ///< Share of the points that are not hidden behind others.
};

constexpr std::size_t kMostPoints = 200'000;

Look lookFrom(const Scan& scan, const Rotation& rotation) {
  const std::size_t stride = std::max<std::size_t>(1, scan.points.size() / kMostPoints);
  std::vector<ViewMm> points;
  points.reserve(scan.points.size() / stride + 1);
  ViewMm low{1e300, 1e300, 1e300};
  ViewMm high{-1e300, -1e300, -1e300};
  for (std::size_t i = 0; i < scan.points.size(); i += stride) {
    const ViewMm p = rotate(rotation, localPoint(scan, i));
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    points.push_back(p);
  }
  const double side = std::max(high.x - low.x, high.y - low.y);
  if (points.empty() || !(side > 0)) return {};
  const int cells =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(points.size())) / 2), 8, 128);
  const double cell = side / cells;
  const auto index = [&](const ViewMm& p) {
    const int col = std::min(cells - 1, static_cast<int>((p.x - low.x) / cell));
    const int row = std::min(cells - 1, static_cast<int>((p.y - low.y) / cell));
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells) +
           static_cast<std::size_t>(col);
  };
  std::vector<double> front(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells),
                            -std::numeric_limits<double>::infinity());
  for (const ViewMm& p : points) front[index(p)] = std::max(front[index(p)], p.z);
  std::size_t visible = 0;
  for (const ViewMm& p : points) visible += p.z >= front[index(p)] - 2 * cell ? 1 : 0;
  const auto occupied =
      std::count_if(front.begin(), front.end(), [](double z) { return z > -1e300; });
  return {.area = static_cast<double>(occupied) * cell * cell,
          .visible = static_cast<double>(visible) / static_cast<double>(points.size())};
}

/// Mean facing of the triangles, -1 (all seen from behind) to 1; 0 for clouds and closed meshes.
double facing(const Scan& scan, const Rotation& rotation) {
  double signed_area = 0;
  double area = 0;
  for (const auto& t : scan.triangles) {
    const ViewMm a = rotate(rotation, localPoint(scan, t[0]));
    const ViewMm b = rotate(rotation, localPoint(scan, t[1]));
    const ViewMm c = rotate(rotation, localPoint(scan, t[2]));
    const double twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    signed_area += twice;
    area += std::abs(twice);
  }
  return area > 0 ? signed_area / area : 0;
}

/// A depth camera stands at the file's origin, well in front of what it sees, and the origin lies
/// roughly behind the middle of the picture. 1: this view looks from there; -1: from the far side.
int sensorSide(const Scan& scan, const Rotation& rotation) {
  if (!scan.triangles.empty() || !scan.info.bounds) return 0;
  const RotatedBounds box = rotatedBounds(scan, rotation, 1.0);
  const double width = box.max.x - box.min.x;
  const double height = box.max.y - box.min.y;
  const bool behind_middle = box.min.x - width < 0 && box.max.x + width > 0 &&
                             box.min.y - height < 0 && box.max.y + height > 0;
  const double distance = std::max(-box.max.z, box.min.z);
  if (!behind_middle || distance < 0.4 * std::max(width, height)) return 0;
  return box.max.z < 0 ? 1 : -1;
}

}  // namespace

std::optional<Rotation> standardRotation(std::string_view name) {
  for (const auto& [known, rotation] : kStandardViews) {
    if (known == name) return rotation;
  }
  return std::nullopt;
}

NamedRotation automaticRotation(const Scan& scan, const Task& task) {
  NamedRotation best{.name = std::string(kStandardViews[0].first),
                     .rotation = kStandardViews[0].second};
  double best_score = -1;
  // What is seen about equally well from several sides is seen from above: airborne scans differ by
  // a few flyers only.
  constexpr double kFromAbove = 1.15;
  for (const auto& [name, rotation] : kStandardViews) {
    task.check();
    const Look look = lookFrom(scan, rotation);
    const double score = look.area * look.visible * (1 + 0.25 * facing(scan, rotation)) *
                         (1 + 0.25 * sensorSide(scan, rotation)) * (name == "top" ? kFromAbove : 1);
    if (score > best_score * 1.02) {
      best_score = score;
      best = {.name = std::string(name), .rotation = rotation};
    }
  }
  return best;
}

RotatedBounds rotatedBounds(const Scan& scan, const Rotation& rotation, double mm_per_unit) {
  constexpr double kHuge = std::numeric_limits<double>::infinity();
  RotatedBounds box{.min = {kHuge, kHuge, kHuge}, .max = {-kHuge, -kHuge, -kHuge}};
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const ViewMm p = rotate(rotation, localPoint(scan, i));
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  const ViewMm shift = rotate(rotation, scan.origin);
  box.min = mm_per_unit * (box.min + shift);
  box.max = mm_per_unit * (box.max + shift);
  return box;
}

}  // namespace relievo
