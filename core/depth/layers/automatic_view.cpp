// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/automatic_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/depth/layers/upright.h"

namespace relievo {
namespace {

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

using Direction = std::array<double, 3>;

Direction directionOf(const FileDirection& d) {
  Direction direction{};
  direction[static_cast<std::size_t>(d.axis)] = d.sign;
  return direction;
}

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1] + 0.0, a[2] * b[0] - a[0] * b[2] + 0.0,
          a[0] * b[1] - a[1] * b[0] + 0.0};
}

/// Seen from `toward`; where that is not from above, `up` is up in the picture.
Rotation seenFrom(const Direction& toward, const FileDirection& up) {
  Direction right = cross(directionOf(up), toward);
  if (right == Direction{}) right = up.axis == 0 ? Direction{0, 1, 0} : Direction{1, 0, 0};
  const Direction above = cross(toward, right);
  return {right[0], right[1],  right[2],  above[0], above[1],
          above[2], toward[0], toward[1], toward[2]};
}

/// A camera's own frame, or a survey: their axes are known, how the object stands says nothing.
bool hasKnownAxes(const Scan& scan, const NamedRotation& face) {
  if (scan.info.format.rfind("LAS", 0) == 0 || scan.info.format.rfind("LAZ", 0) == 0) return true;
  const FileBounds& box = *scan.info.bounds;
  const double width = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const double off = std::max(std::abs(box.min.x + box.max.x), std::abs(box.min.y + box.max.y)) / 2;
  constexpr double kPlace = 1e4;  // Coordinates of a map projection.
  if (off > kPlace && off > 2 * width) return true;
  return sensorSide(scan, face.rotation) > 0;
}

/// Where an object's face is by convention, if this is up: +z of y-up models; of one that was
/// turned over, -z.
bool isConventionalFront(const Direction& toward, const FileDirection& up) {
  return up.axis == 1 && toward[2] == up.sign;
}

/// From around the object, or from above, whichever shows most; never from below.
Rotation standing(const Scan& scan, const FileDirection& up, const Task& task) {
  constexpr double kConventional = 1.3;
  Rotation best{};
  double most = -1;
  for (const int sign : {1, -1}) {
    for (const int axis : {2, 1, 0}) {
      const FileDirection side{.axis = axis, .sign = sign};
      if (side == FileDirection{.axis = up.axis, .sign = -up.sign}) continue;
      task.check();
      const Rotation rotation = seenFrom(directionOf(side), up);
      const double score = shownFrom(scan, rotation) *
                           (isConventionalFront(directionOf(side), up) ? kConventional : 1);
      if (score > most * 1.02) {
        most = score;
        best = rotation;
      }
    }
  }
  return best;
}

}  // namespace

double shownFrom(const Scan& scan, const Rotation& rotation) {
  const Look look = lookFrom(scan, rotation);
  return look.area * look.visible * (1 + 0.25 * facing(scan, rotation)) *
         (1 + 0.25 * sensorSide(scan, rotation));
}

NamedRotation automaticFace(const Scan& scan, const Task& task) {
  NamedRotation best{.name = "top", .rotation = *standardRotation("top")};
  double best_score = -1;
  // What is seen about equally well from several sides is seen from above: airborne scans differ by
  // a few flyers only.
  constexpr double kFromAbove = 1.15;
  for (const std::string_view name : {"top", "front", "right", "back", "left", "bottom"}) {
    task.check();
    const Rotation rotation = *standardRotation(name);
    const double score = shownFrom(scan, rotation) * (name == "top" ? kFromAbove : 1);
    if (score > best_score * 1.02) {
      best_score = score;
      best = {.name = std::string(name), .rotation = rotation};
    }
  }
  return best;
}

NamedRotation automaticRotation(const Scan& scan, const Task& task) {
  NamedRotation face = automaticFace(scan, task);
  if (!scan.info.bounds || hasKnownAxes(scan, face)) return face;
  constexpr std::size_t kSample = 100'000;
  const Standing found = standingOf(scan, surfaceSample(scan, kSample));
  if (found.lead < kWeakStanding) {
    // A relief is looked at along its thin axis; only what is up in the picture is open.
    face.is_weak = !found.is_flat;
    return face;
  }
  // What a relief rests on says nothing: one edge is as straight as the other.
  if (found.is_flat || found.up == FileDirection{.axis = 2, .sign = 1}) return face;
  const Rotation rotation = standing(scan, found.up, task);
  return {.name = nameOf(rotation), .rotation = rotation};
}

}  // namespace relievo
