// SPDX-License-Identifier: BSD-3-Clause
// closed_solids [NAME...]: clouds sampled on solids whose distance is known in closed form,
// gridded, and held against the place where each ray meets the solid, found by that distance alone
// to 1e-9 of the size: no mesh, no code of the program. A line a cloud and the bars as in
// closed_clouds, with its CLOSED_CLOUDS_VIEW, _LEAST, _MOST and _PITS; "fine": within two of 600
// samples across. Exact distances: I. Quilez, "Distance functions" (ball, torus, box, capsule,
// link, shell).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "core/session/surface.h"
#include "tests/benchmark/closed_cloud_judge.h"

namespace {

using namespace relievo;
using namespace relievo::benchmark;

using Point = std::array<double, 3>;

constexpr double kSize = 100;  // mm; each solid is about so long.
constexpr double kHalfBox = 60;
constexpr double kFineMm = kSize / 600;

struct Solid {
  const char* name;
  std::function<double(const Point&)> distance;  // mm, negative inside.
};

double length(double x, double y, double z = 0) {
  return std::sqrt(x * x + y * y + z * z);
}

double box(const Point& p, const Point& half, double round) {
  const Point q{std::abs(p[0]) - half[0] + round, std::abs(p[1]) - half[1] + round,
                std::abs(p[2]) - half[2] + round};
  const double outside = length(std::max(q[0], 0.0), std::max(q[1], 0.0), std::max(q[2], 0.0));
  return outside + std::min(std::max({q[0], q[1], q[2]}), 0.0) - round;
}

/// None of them lies along the axes of the file.
Point turned(const Point& p) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Point q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return {q[0], c * q[1] - s * q[2], s * q[1] + c * q[2]};
}

std::vector<Solid> solids() {
  return {{"ball", [](const Point& p) { return length(p[0], p[1], p[2]) - 50; }},
          {"torus", [](const Point& p) { return length(length(p[0], p[1]) - 36, p[2]) - 14; }},
          {"rounded box",
           [](const Point& p) {
             return box(p, {50, 35, 15}, 4);
           }},
          {"slab 1 : 20",
           [](const Point& p) {
             return box(p, {50, 35, 2.5}, 1);
           }},
          {"capsule",
           [](const Point& p) {
             return length(p[0] - std::clamp(p[0], -35.0, 35.0), p[1], p[2]) - 15;
           }},
          {"link",
           [](const Point& p) {
             const double along = std::max(std::abs(p[1]) - 18, 0.0);
             return length(length(p[0], along) - 22, p[2]) - 10;
           }},
          {"shell of 2 mm",
           [](const Point& p) { return std::abs(length(p[0], p[1], p[2]) - 49) - 1; }}};
}

Point onSurface(const Solid& solid, Point p) {
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 4; ++i) {
    const double d = solid.distance(turned(p));
    Point gradient{};
    for (std::size_t k = 0; k < 3; ++k) {
      Point q = p;
      q[k] += kStep;
      gradient[k] = (solid.distance(turned(q)) - d) / kStep;
    }
    const double norm = length(gradient[0], gradient[1], gradient[2]);
    for (std::size_t k = 0; k < 3; ++k) p[k] -= d * gradient[k] / norm;
  }
  return p;
}

Scan sampled(const Solid& solid, const Sampling& how) {
  constexpr double kNear = 0.5;  // mm: a layer so thin has points as its surface has area.
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> side(-kHalfBox, kHalfBox), unit(0, 1);
  std::normal_distribution<double> noise(0, how.noise * kSize);
  Scan cloud;
  cloud.info.file = "solid.ply";
  cloud.info.format = "PLY binary_little_endian";
  while (cloud.points.size() < how.points) {
    Point p{side(random), side(random), side(random)};
    if (unit(random) >= how.strays) {
      do {
        p = {side(random), side(random), side(random)};
      } while (std::abs(solid.distance(turned(p))) > kNear);
      p = onSurface(solid, p);
      const double along = std::clamp((p[0] + 50) / 100, 0.0, 1.0);
      if (unit(random) > 1 / how.unevenness + (1 - 1 / how.unevenness) * along) continue;
      for (double& value : p) value += how.noise > 0 ? noise(random) : 0.0;
    } else {
      for (double& value : p) value *= 50 / kHalfBox;
    }
    cloud.points.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  cloud.info.points = cloud.info.finite_points = cloud.points.size();
  FileBounds bounds{cloud.point(0), cloud.point(0)};
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const FilePoint q = cloud.point(i);
    bounds.min = {std::min(bounds.min.x, q.x), std::min(bounds.min.y, q.y),
                  std::min(bounds.min.z, q.z)};
    bounds.max = {std::max(bounds.max.x, q.x), std::max(bounds.max.y, q.y),
                  std::max(bounds.max.z, q.z)};
  }
  cloud.info.bounds = bounds;
  return cloud;
}

/// Height at which a ray along -z of the view meets the solid, mm of the view; NaN: it does not.
class Rays {
 public:
  Rays(const Solid& solid, const ViewFromFile& view) : solid_(solid), m_(view.m) {}

  double heightAt(double x, double y) const {
    constexpr double kHit = 1e-7;
    constexpr int kMostSteps = 2000;
    // The middle of the solid is the file's origin.
    double z = m_[11] + 2 * kHalfBox;
    for (int i = 0; i < kMostSteps && z > m_[11] - 2 * kHalfBox; ++i) {
      const double d = solid_.distance(turned(fileAt(x, y, z)));
      if (d < kHit) return z;
      z -= d;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  Point fileAt(double x, double y, double z) const {
    const Point v{x - m_[3], y - m_[7], z - m_[11]};
    Point p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = m_[k] * v[0] + m_[4 + k] * v[1] + m_[8 + k] * v[2];
    return p;
  }
  const Solid& solid_;
  std::array<double, 16> m_;
};

/// Of the 5 x 5 places around one: the lowest; NaN if the solid is not at all of them, or rises
/// by more than eight cells a cell there, too steep to be measured.
double lowestAround(const Rays& rays, double x, double y) {
  constexpr double kSteep = 8 * 4 * kFineMm;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int r = -2; r <= 2; ++r) {
    for (int c = -2; c <= 2; ++c) {
      const double z = rays.heightAt(x + c * kFineMm, y + r * kFineMm);
      if (std::isnan(z)) return z;
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  return high - low > kSteep ? std::numeric_limits<double>::quiet_NaN() : low;
}

Found judged(const Surface& surface, const Solid& solid) {
  const GridFrame& frame = surface.map.frame;
  const Rays rays(solid, surface.view_from_file);
  std::vector<float> truth(frame.size.count());
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      truth[frame.size.index({.col = col, .row = row})] =
          static_cast<float>(rays.heightAt(frame.xMm(col), frame.yMm(row)));
    }
  }
  Found found = compared(surface, truth);
  double cells = 0;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const std::size_t i = frame.size.index({.col = col, .row = row});
      if (std::isnan(truth[i])) continue;
      ++cells;
      const CellStatus origin = surface.map.origins[i];
      const bool is_there = origin == CellStatus::measured || origin == CellStatus::interpolated;
      const double height = surface.map.heights_mm[i];
      if (is_there && height > static_cast<double>(truth[i]) - 0.03 * kSize) continue;
      const double low = lowestAround(rays, frame.xMm(col), frame.yMm(row));
      if (std::isnan(low)) continue;
      found.fine_lost += is_there ? 0 : 1;
      if (!is_there && std::getenv("CLOSED_CLOUDS_PITS") != nullptr) {
        const double half = frame.spacing_mm / 2, x = frame.xMm(col), y = frame.yMm(row);
        const auto rise = [&](double right, double up) {
          return std::abs(rays.heightAt(x + right, y + up) - rays.heightAt(x - right, y - up));
        };
        std::printf("  lost at %d %d origin %d: the solid rises by %.1f a cell\n", col, row,
                    static_cast<int>(origin),
                    std::max(rise(half, 0), rise(0, half)) / frame.spacing_mm);
      }
      found.fine_pits += is_there && height < low - 0.03 * kSize ? 1 : 0;
    }
  }
  found.fine_pits *= 100 / std::max(cells, 1.0);
  found.fine_lost *= 100 / std::max(cells, 1.0);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  Judgement judgement;
  for (const Solid& solid : solids()) {
    const auto is_meant = [&solid](const char* name) { return std::string(solid.name) == name; };
    if (argc > 1 && std::none_of(argv + 1, argv + argc, is_meant)) continue;
    judgement.judge(
        solid.name, [&solid](const Sampling& how) { return sampled(solid, how); },
        [&solid](const Surface& surface, const SurfaceOptions&) { return judged(surface, solid); });
  }
  return judgement.end();
}
