// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/automatic_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bands.h"
#include "core/depth/layers/upright.h"

namespace relievo {
namespace {

ViewMm rotate(const Rotation& r, const FilePoint& p) noexcept {
  return {r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
          r[6] * p.x + r[7] * p.y + r[8] * p.z};
}

FilePoint fromFloats(const std::array<float, 3>& p) noexcept {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}
FilePoint localPoint(const Scan& scan, std::size_t i) noexcept {
  return fromFloats(scan.points[i]);
}

/// A look at the scan from one side on a coarse grid.
struct Look {
  double area = 0;     ///< Occupied cells times cell size squared.
  double visible = 0;  ///< Share of the points that are not hidden behind others.
};

constexpr std::size_t kMostPoints = 200'000;

/// Evenly many of the scan's points, side by side in memory: they are looked at from many sides.
std::vector<std::array<float, 3>> sampleOf(const Scan& scan) {
  const std::size_t stride = std::max<std::size_t>(1, scan.points.size() / kMostPoints);
  std::vector<std::array<float, 3>> sample;
  sample.reserve(scan.points.size() / stride + 1);
  for (std::size_t i = 0; i < scan.points.size(); i += stride) sample.push_back(scan.points[i]);
  return sample;
}

Look lookFrom(const std::vector<std::array<float, 3>>& sample, const Rotation& rotation) {
  std::vector<ViewMm> points;
  points.reserve(sample.size());
  ViewMm low{1e300, 1e300, 1e300};
  ViewMm high{-1e300, -1e300, -1e300};
  for (const std::array<float, 3>& at : sample) {
    const ViewMm p = rotate(rotation, fromFloats(at));
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
    return static_cast<std::uint32_t>(row * cells + col);
  };
  std::vector<double> front(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells),
                            -std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> cell_of;
  cell_of.reserve(points.size());
  for (const ViewMm& p : points) {
    cell_of.push_back(index(p));
    front[cell_of.back()] = std::max(front[cell_of.back()], p.z);
  }
  std::size_t visible = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    visible += points[i].z >= front[cell_of[i]] - 2 * cell ? 1 : 0;
  }
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

/// A box around points along the file's axes, seen along axes of the file: what rotatedBounds
/// finds, without a look at the points, because nothing is rounded but signs change places.
RotatedBounds turnedBox(const RotatedBounds& box, const Rotation& r) {
  const std::array<double, 3> low{box.min.x, box.min.y, box.min.z};
  const std::array<double, 3> high{box.max.x, box.max.y, box.max.z};
  std::array<double, 3> min{}, max{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double sign = r[3 * row + axis];
      if (sign == 0) continue;
      min[row] = sign > 0 ? low[axis] : -high[axis];
      max[row] = sign > 0 ? high[axis] : -low[axis];
    }
  }
  return {.min = {min[0], min[1], min[2]}, .max = {max[0], max[1], max[2]}};
}

bool isAlongAxes(const Rotation& r) {
  return std::all_of(r.begin(), r.end(), [](double c) { return c == 0 || c == 1 || c == -1; });
}

/// What several looks at one scan have in common.
class Sides {
 public:
  explicit Sides(const Scan& scan) : scan_(scan), sample_(sampleOf(scan)) {
    if (scan.triangles.empty() && scan.info.bounds) {
      box_ = rotatedBounds(scan, *standardRotation("top"), 1.0);
    }
  }

  double shownFrom(const Rotation& rotation) const {
    const Look look = lookFrom(sample_, rotation);
    return look.area * look.visible * (1 + 0.25 * facing(scan_, rotation)) *
           (1 + 0.25 * sensorSide(rotation));
  }

  /// A depth camera stands at the file's origin, well in front of what it sees, and the origin lies
  /// roughly behind the middle of the picture. 1: this view looks from there; -1: from the far
  /// side.
  int sensorSide(const Rotation& rotation) const {
    if (!box_) return 0;
    const RotatedBounds box =
        isAlongAxes(rotation) ? turnedBox(*box_, rotation) : rotatedBounds(scan_, rotation, 1.0);
    const double width = box.max.x - box.min.x;
    const double height = box.max.y - box.min.y;
    const bool behind_middle = box.min.x - width < 0 && box.max.x + width > 0 &&
                               box.min.y - height < 0 && box.max.y + height > 0;
    const double distance = std::max(-box.max.z, box.min.z);
    if (!behind_middle || distance < 0.4 * std::max(width, height)) return 0;
    return box.max.z < 0 ? 1 : -1;
  }

  /// shownFrom, of all of them side by side.
  std::vector<double> shownFrom(const std::vector<Rotation>& rotations, const Task& task) const {
    std::vector<double> shown(rotations.size());
    parallelFor(static_cast<int>(rotations.size()), threadsFor(scan_.points.size(), 0),
                [&](int first, int end) {
                  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end);
                       ++i) {
                    task.check();
                    shown[i] = shownFrom(rotations[i]);
                  }
                });
    return shown;
  }

 private:
  const Scan& scan_;
  std::vector<std::array<float, 3>> sample_;
  std::optional<RotatedBounds> box_;  ///< Along the file's axes; nothing: no camera took it.
};

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
bool hasKnownAxes(const Scan& scan, const Sides& sides, const NamedRotation& face) {
  if (scan.info.format.rfind("LAS", 0) == 0 || scan.info.format.rfind("LAZ", 0) == 0) return true;
  const FileBounds& box = *scan.info.bounds;
  const double width = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const double off = std::max(std::abs(box.min.x + box.max.x), std::abs(box.min.y + box.max.y)) / 2;
  constexpr double kPlace = 1e4;  // Coordinates of a map projection.
  if (off > kPlace && off > 2 * width) return true;
  return sides.sensorSide(face.rotation) > 0;
}

/// Where an object's face is by convention, if this is up: +z of y-up models; of one that was
/// turned over, -z.
bool isConventionalFront(const Direction& toward, const FileDirection& up) {
  return up.axis == 1 && toward[2] == up.sign;
}

/// From around the object, or from above, whichever shows most; never from below.
Rotation standing(const Sides& sides, const FileDirection& up, const Task& task) {
  constexpr double kConventional = 1.3;
  std::vector<Direction> directions;
  std::vector<Rotation> rotations;
  for (const int sign : {1, -1}) {
    for (const int axis : {2, 1, 0}) {
      const FileDirection side{.axis = axis, .sign = sign};
      if (side == FileDirection{.axis = up.axis, .sign = -up.sign}) continue;
      directions.push_back(directionOf(side));
      rotations.push_back(seenFrom(directions.back(), up));
    }
  }
  const std::vector<double> shown = sides.shownFrom(rotations, task);
  Rotation best{};
  double most = -1;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const double score = shown[i] * (isConventionalFront(directions[i], up) ? kConventional : 1);
    if (score > most * 1.02) {
      most = score;
      best = rotations[i];
    }
  }
  return best;
}

NamedRotation faceOf(const Sides& sides, const Task& task) {
  constexpr std::array<std::string_view, 6> kNames{"top",  "front", "right",
                                                   "back", "left",  "bottom"};
  // What is seen about equally well from several sides is seen from above: airborne scans differ by
  // a few outliers only.
  constexpr double kFromAbove = 1.15;
  std::vector<Rotation> rotations;
  rotations.reserve(kNames.size());
  for (const std::string_view name : kNames) rotations.push_back(*standardRotation(name));
  const std::vector<double> shown = sides.shownFrom(rotations, task);
  NamedRotation best{.name = "top", .rotation = *standardRotation("top")};
  double best_score = -1;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const double score = shown[i] * (kNames[i] == "top" ? kFromAbove : 1);
    if (score > best_score * 1.02) {
      best_score = score;
      best = {.name = std::string(kNames[i]), .rotation = rotations[i]};
    }
  }
  return best;
}

}  // namespace

double shownFrom(const Scan& scan, const Rotation& rotation) {
  return Sides(scan).shownFrom(rotation);
}

NamedRotation automaticFace(const Scan& scan, const Task& task) {
  task.check();
  return faceOf(Sides(scan), task);
}

NamedRotation automaticRotation(const Scan& scan, const Task& task) {
  task.check();
  const Sides sides(scan);
  NamedRotation face = faceOf(sides, task);
  if (!scan.info.bounds || hasKnownAxes(scan, sides, face)) return face;
  constexpr std::size_t kSample = 100'000;
  const Standing found = standingOf(scan, surfaceSample(scan, kSample));
  if (found.lead < kWeakStanding) {
    // A relief is looked at along its thin axis; only what is up in the picture is open.
    face.is_weak = !found.is_flat;
    return face;
  }
  // What a relief rests on says nothing: one edge is as straight as the other.
  if (found.is_flat || found.up == FileDirection{.axis = 2, .sign = 1}) return face;
  const Rotation rotation = standing(sides, found.up, task);
  return {.name = nameOf(rotation), .rotation = rotation};
}

}  // namespace relievo
