// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/upright.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {
namespace {

constexpr double kGolden = 0.6180339887498949;
constexpr double kPlastic = 0.7548776662466927;

FilePoint localPoint(const Scan& scan, std::size_t i) {
  const auto& p = scan.points[i];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

double along(const FilePoint& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

std::vector<FilePoint> sampleOfMesh(const Scan& scan, std::size_t most) {
  std::vector<double> until;  // Area up to and with each triangle.
  until.reserve(scan.triangles.size());
  double area = 0;
  for (const auto& t : scan.triangles) {
    const FilePoint a = localPoint(scan, t[0]);
    const FilePoint u = localPoint(scan, t[1]) - a;
    const FilePoint v = localPoint(scan, t[2]) - a;
    area += std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
    until.push_back(area);
  }
  std::vector<FilePoint> points;
  if (!(area > 0) || !std::isfinite(area)) return points;
  points.reserve(most);
  std::size_t triangle = 0;
  double r1 = 0.5;
  double r2 = 0.5;
  for (std::size_t i = 0; i < most; ++i) {
    const double at = area * (static_cast<double>(i) + 0.5) / static_cast<double>(most);
    while (triangle + 1 < until.size() && until[triangle] < at) ++triangle;
    r1 = r1 + kPlastic - std::floor(r1 + kPlastic);
    r2 = r2 + kPlastic * kPlastic - std::floor(r2 + kPlastic * kPlastic);
    double s = r1;
    double t = r2;
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    const auto& corners = scan.triangles[triangle];
    const FilePoint a = localPoint(scan, corners[0]);
    points.push_back(a + s * (localPoint(scan, corners[1]) - a) +
                     t * (localPoint(scan, corners[2]) - a));
  }
  return points;
}

/// Share of the outline, seen along an axis, that lies level at its lower and at its upper end.
struct Contact {
  double low = 0, high = 0;
};

constexpr int kCells = 40;
constexpr double kLevel = 0.02;  // Of the extent: so far from the end is still on the ground.

Contact contactAlong(const std::vector<FilePoint>& sample, int axis) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  FilePoint low = sample.front();
  FilePoint high = low;
  for (const FilePoint& p : sample) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double side = std::max(along(high, u) - along(low, u), along(high, v) - along(low, v));
  const double extent = along(high, axis) - along(low, axis);
  if (!(side > 0) || !(extent > 0)) return {};
  constexpr auto kCount = static_cast<std::size_t>(kCells) * kCells;
  std::vector<std::uint8_t> any(kCount), at_low(kCount), at_high(kCount);
  const auto cell = [&](const FilePoint& p, int a) {
    return static_cast<std::size_t>(
        std::min(kCells - 1, static_cast<int>(kCells * (along(p, a) - along(low, a)) / side)));
  };
  for (const FilePoint& p : sample) {
    const std::size_t index = cell(p, v) * kCells + cell(p, u);
    any[index] = 1;
    if (along(p, axis) - along(low, axis) <= kLevel * extent) at_low[index] = 1;
    if (along(high, axis) - along(p, axis) <= kLevel * extent) at_high[index] = 1;
  }
  const auto count = [](const std::vector<std::uint8_t>& cells) {
    return static_cast<double>(std::count(cells.begin(), cells.end(), std::uint8_t{1}));
  };
  return {.low = count(at_low) / count(any), .high = count(at_high) / count(any)};
}

bool isFormat(const Scan& scan, const char* name) {
  return scan.info.format.rfind(name, 0) == 0;
}

/// What is known before the object is looked at: modellers and photogrammetry export OBJ with y
/// upward, scanners, printers and surveys have z upward; upside down is rarer than either.
double prior(const Scan& scan, const FileDirection& up) {
  if (up.sign < 0) return -0.1;
  if (up.axis == 0) return -0.05;
  const bool y_up = isFormat(scan, "OBJ");
  if (up.axis == 1) return y_up ? 0.15 : 0.05;
  const bool survey = isFormat(scan, "LAS") || isFormat(scan, "LAZ") || isFormat(scan, "E57") ||
                      isFormat(scan, "PTX");
  return y_up ? 0.05 : survey ? 0.3 : 0.12;
}

}  // namespace

std::vector<FilePoint> surfaceSample(const Scan& scan, std::size_t most) {
  if (!scan.triangles.empty()) {
    std::vector<FilePoint> points = sampleOfMesh(scan, most);
    if (!points.empty()) return points;
  }
  std::vector<FilePoint> points;
  const std::size_t count = scan.points.size();
  const std::size_t taken = std::min(count, most);
  points.reserve(taken);
  // Steps of the golden ratio: an even stride through stored rows would see some columns only.
  double position = 0;
  for (std::size_t i = 0; i < taken; ++i) {
    points.push_back(localPoint(
        scan,
        taken == count ? i : static_cast<std::size_t>(position * static_cast<double>(count))));
    position += kGolden;
    if (position >= 1) position -= 1;
  }
  return points;
}

Standing standingOf(const Scan& scan, const std::vector<FilePoint>& sample) {
  Standing standing;
  if (sample.empty() || !scan.info.bounds) return standing;
  const FileBounds& box = *scan.info.bounds;
  const FilePoint size = box.max - box.min;
  standing.size = {size.x, size.y, size.z};
  std::array<double, 3> sorted = standing.size;
  std::sort(sorted.begin(), sorted.end());
  constexpr double kFlat = 0.3;
  standing.is_flat = sorted[0] < kFlat * sorted[1];
  constexpr double kLonger = 1.25;
  constexpr double kForLongest = 0.08;
  constexpr double kForOrigin = 0.15;
  constexpr double kOnGround = 0.005;
  double best = -std::numeric_limits<double>::infinity();
  double second = best;
  for (int axis = 0; axis < 3; ++axis) {
    const Contact contact = contactAlong(sample, axis);
    const double extent = standing.size[static_cast<std::size_t>(axis)];
    for (const int sign : {1, -1}) {
      const FileDirection up{.axis = axis, .sign = sign};
      double score = prior(scan, up);
      score += sign * (contact.low - contact.high);
      if (extent == sorted[2] && extent > kLonger * sorted[1]) score += kForLongest;
      const double ground = sign > 0 ? along(box.min, axis) : along(box.max, axis);
      if (std::abs(ground) < kOnGround * extent) score += kForOrigin;
      if (score > best) {
        second = best;
        best = score;
        standing.up = up;
      } else {
        second = std::max(second, score);
      }
    }
  }
  standing.lead = best - second;
  return standing;
}

}  // namespace relievo
