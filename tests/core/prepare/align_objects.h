// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/cloud/scan.h"
#include "core/prepare/align/align.h"
#include "data/generate/random.h"

/// Objects whose scans are known, and parts of them that stand elsewhere: truth by construction.
namespace relievo::test {

using samples::Random;
using Place = std::array<double, 3>;

/// A surface to take points from. Millimetres.
struct MadeObject {
  std::string name;
  std::function<Place(Random&)> sample;  ///< One point, evenly over the surface.
  Place middle{};
  double diagonal = 0;
};

struct Ball {
  Place centre;
  double radius;
};

/// The outside of balls that overlap.
inline MadeObject ballsObject(const std::string& name, std::vector<Ball> balls) {
  MadeObject object{name, {}, {0, 0, 0}, 200};
  std::vector<double> areas;  // Summed up.
  for (const Ball& ball : balls) {
    areas.push_back(ball.radius * ball.radius + (areas.empty() ? 0 : areas.back()));
  }
  object.sample = [balls = std::move(balls), areas](Random& random) -> Place {
    for (;;) {
      const double at = random.uniform(0, areas.back());
      const auto found = std::upper_bound(areas.begin(), areas.end(), at);
      const std::size_t n =
          std::min(static_cast<std::size_t>(found - areas.begin()), balls.size() - 1);
      const double z = random.uniform(-1, 1);
      const double turn = random.uniform(0, 2 * std::numbers::pi);
      const double flat = std::sqrt(1 - z * z);
      const Ball& ball = balls[n];
      const Place p{ball.centre[0] + ball.radius * flat * std::cos(turn),
                    ball.centre[1] + ball.radius * flat * std::sin(turn),
                    ball.centre[2] + ball.radius * z};
      const bool hidden = std::any_of(balls.begin(), balls.end(), [&](const Ball& other) {
        return &other != &ball && std::hypot(p[0] - other.centre[0], p[1] - other.centre[1],
                                             p[2] - other.centre[2]) < other.radius;
      });
      if (!hidden) return p;
    }
  };
  return object;
}

inline std::vector<Ball> gargoyleBalls() {
  return {{{0, 0, 0}, 45},      {{38, 22, 20}, 22},    {{-40, 12, 30}, 19},  {{10, -42, 24}, 16},
          {{-14, 40, -22}, 24}, {{30, -30, -34}, 14},  {{-44, -26, -8}, 17}, {{6, 10, 52}, 15},
          {{60, -6, 4}, 12},    {{-22, -16, -48}, 13}, {{24, 48, 2}, 10},    {{-8, 24, 60}, 8},
          {{-62, 30, 24}, 9},   {{44, 30, -24}, 11}};
}

/// A body that looks like nothing else from any side; 200 mm across.
inline MadeObject gargoyle() {
  return ballsObject("gargoyle", gargoyleBalls());
}

/// Slender, upright along y, nearly round: small balls on it are all that holds its parts from
/// turning about it.
inline MadeObject column() {
  std::vector<Ball> balls;
  for (int i = 0; i < 15; ++i) {
    balls.push_back({{5 * std::cos(2.1 * i), 12.0 * i - 84, 5 * std::sin(1.7 * i)},
                     15 + 3 * std::sin(2.7 * i)});
  }
  for (int i = 0; i < 8; ++i) {
    const double turn = 2.4 * i;
    balls.push_back({{17 * std::cos(turn), 22.0 * i - 80, 17 * std::sin(turn)}, 6});
  }
  return ballsObject("column", std::move(balls));
}

/// A plate of 100 x 80 mm whose front rises by `height_mm`; 0: flat.
inline MadeObject relief(double height_mm) {
  MadeObject object{
      "relief of " + std::to_string(height_mm) + " mm", {}, {50, 40, 0}, std::hypot(100, 80)};
  object.sample = [height_mm](Random& random) -> Place {
    const double x = random.uniform(0, 100);
    const double y = random.uniform(0, 80);
    constexpr std::array<std::array<double, 4>, 9> kHills{{{18, 20, 9, 1},
                                                           {47, 17, 6, 0.7},
                                                           {80, 24, 11, 0.9},
                                                           {30, 45, 7, 0.8},
                                                           {55, 50, 12, 1},
                                                           {86, 58, 6, 0.6},
                                                           {14, 66, 8, 0.9},
                                                           {44, 72, 5, 0.7},
                                                           {68, 70, 7, 0.8}}};
    double height = 0;
    for (const auto& [hx, hy, width, tall] : kHills) {
      const double away = std::hypot(x - hx, y - hy) / width;
      height = std::max(height, tall * std::exp(-away * away));
    }
    return {x, y, height_mm * height};
  };
  return object;
}

/// The triangles of a scan, brought to 200 mm across.
inline MadeObject meshObject(const Scan& mesh, const std::string& name) {
  std::vector<std::array<Place, 3>> triangles;
  std::vector<double> areas;  // Summed up.
  const FilePoint low = mesh.info.bounds->min;
  const FilePoint high = mesh.info.bounds->max;
  const double scale = 200 / norm(high - low);
  const FilePoint middle = 0.5 * (low + high);
  for (const auto& corners : mesh.triangles) {
    std::array<Place, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
      const FilePoint p = scale * (mesh.point(corners[i]) - middle);
      t[i] = {p.x, p.y, p.z};
    }
    const Place u{t[1][0] - t[0][0], t[1][1] - t[0][1], t[1][2] - t[0][2]};
    const Place v{t[2][0] - t[0][0], t[2][1] - t[0][1], t[2][2] - t[0][2]};
    const double area =
        std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    triangles.push_back(t);
    areas.push_back(area + (areas.empty() ? 0 : areas.back()));
  }
  MadeObject object{name, {}, {0, 0, 0}, 200};
  object.sample = [triangles, areas](Random& random) -> Place {
    const double at = random.uniform(0, areas.back());
    const auto found = std::upper_bound(areas.begin(), areas.end(), at);
    const std::size_t n =
        std::min(static_cast<std::size_t>(found - areas.begin()), triangles.size() - 1);
    double a = random.uniform();
    double b = random.uniform();
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    const auto& t = triangles[n];
    Place p{};
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = t[0][i] + a * (t[1][i] - t[0][i]) + b * (t[2][i] - t[0][i]);
    }
    return p;
  };
  return object;
}

/// A turn by `deg` about an axis, then a shift.
inline Pose motion(double deg, Place axis, Place shift) {
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (double& a : axis) a /= length;
  const double s = std::sin(deg * std::numbers::pi / 180);
  const double c = std::cos(deg * std::numbers::pi / 180);
  Pose pose;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      pose.m[4 * i + j] = (i == j ? c : 0) + (1 - c) * axis[i] * axis[j];
    }
    pose.m[4 * i + 3] = shift[i];
  }
  pose.m[1] -= s * axis[2];
  pose.m[2] += s * axis[1];
  pose.m[4] += s * axis[2];
  pose.m[6] -= s * axis[0];
  pose.m[8] -= s * axis[1];
  pose.m[9] += s * axis[0];
  return pose;
}

/// What one scanner saw: some of the object, its own points, standing elsewhere.
struct Part {
  std::vector<std::array<float, 3>> points;  ///< From `origin`.
  FilePoint origin;
  Pose object_from_part;

  AlignScan scan(const std::string& name) const { return {name, origin, points, {}, 1}; }
};

struct PartRequest {
  std::function<bool(const Place&)> sees;
  std::size_t points = 20000;
  double noise_mm = 0.05;
  Pose part_from_object;
  FilePoint origin;
  std::uint64_t seed = 1;
};

inline Part makePart(const MadeObject& object, const PartRequest& request) {
  Random random(request.seed);
  Part part;
  part.origin = request.origin;
  part.object_from_part = request.part_from_object.inverseOfSimilarity();
  while (part.points.size() < request.points) {
    Place p = object.sample(random);
    if (request.sees && !request.sees(p)) continue;
    for (double& x : p) x += request.noise_mm * random.normal();
    const FilePoint q = request.part_from_object(FilePoint{p[0], p[1], p[2]}) - request.origin;
    part.points.push_back(
        {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)});
  }
  return part;
}

/// Of two halves with `common` of the whole length in both, the one at low x, or at high x.
inline std::function<bool(const Place&)> half(const MadeObject& object, bool low,
                                              double common = 0.3) {
  const double reach = 0.25 * common * object.diagonal;
  return [=, middle = object.middle[0]](const Place& p) {
    return low ? p[0] < middle + reach : p[0] > middle - reach;
  };
}

/// One of four views around the y axis: 90 degrees and `more_deg` to both sides.
inline std::function<bool(const Place&)> quarter(const MadeObject& object, int n,
                                                 double more_deg = 25) {
  return [=, middle = object.middle](const Place& p) {
    const double at = std::atan2(p[2] - middle[2], p[0] - middle[0]) * 180 / std::numbers::pi;
    return std::abs(std::remainder(at - 90.0 * n, 360.0)) < 45 + more_deg;
  };
}

/// Three picks on a scan and the reference, `off_mm` off each; chosen far from each other among
/// points of the part.
inline std::vector<PickedPair> picksOn(const Part& part, const Part& reference, std::uint32_t scan,
                                       double off_mm, std::uint64_t seed) {
  Random random(seed);
  const auto place = [&](std::size_t i) {
    const auto& p = part.points[i];
    return part.origin + FilePoint{static_cast<double>(p[0]), static_cast<double>(p[1]),
                                   static_cast<double>(p[2])};
  };
  std::array<std::size_t, 3> best{};
  double widest = -1;
  for (int i = 0; i < 200; ++i) {
    std::array<std::size_t, 3> three{};
    for (std::size_t& n : three) {
      n = static_cast<std::size_t>(random.uniform() * static_cast<double>(part.points.size()));
    }
    const double width =
        std::min({norm(place(three[0]) - place(three[1])), norm(place(three[1]) - place(three[2])),
                  norm(place(three[2]) - place(three[0]))});
    if (width > widest) {
      widest = width;
      best = three;
    }
  }
  const Pose reference_from_object = reference.object_from_part.inverseOfSimilarity();
  std::vector<PickedPair> picks;
  for (const std::size_t n : best) {
    const FilePoint truth = reference_from_object(part.object_from_part(place(n)));
    FilePoint off{random.normal(), random.normal(), random.normal()};
    off = off_mm / norm(off) * off;
    picks.push_back({scan, place(n), truth + off});
  }
  return picks;
}

/// How far a pose is from the truth.
struct PoseError {
  double deg = 0;
  double mm = 0;  ///< In the middle of the part.
};

inline PoseError errorOf(const Pose& pose, const Part& part, const Part& reference) {
  const Pose reference_from_object = reference.object_from_part.inverseOfSimilarity();
  FilePoint middle;
  for (const auto& p : part.points) {
    middle = middle + FilePoint{static_cast<double>(p[0]), static_cast<double>(p[1]),
                                static_cast<double>(p[2])};
  }
  middle = part.origin + 1.0 / static_cast<double>(part.points.size()) * middle;
  const FilePoint truth = reference_from_object(part.object_from_part(middle));
  PoseError error;
  error.mm = norm(pose(middle) - truth);
  // |R - S| over all entries is sqrt(8) sin(half the angle between them).
  double squares = 0;
  for (const FilePoint axis : {FilePoint{1, 0, 0}, FilePoint{0, 1, 0}, FilePoint{0, 0, 1}}) {
    const FilePoint is = pose(middle + axis) - pose(middle);
    const FilePoint should = reference_from_object(part.object_from_part(middle + axis)) - truth;
    squares += dot(is - should, is - should);
  }
  error.deg = 2 * std::asin(std::min(1.0, std::sqrt(squares / 8))) * 180 / std::numbers::pi;
  return error;
}

/// Median distance of the coarser part's points to their nearest: what errors are held against.
inline double medianSpacing(const Part& part) {
  std::vector<double> nearest;
  const std::size_t step = std::max<std::size_t>(1, part.points.size() / 300);
  for (std::size_t i = 0; i < part.points.size(); i += step) {
    double best = 1e30;
    for (std::size_t j = 0; j < part.points.size(); ++j) {
      if (i == j) continue;
      double squared = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = static_cast<double>(part.points[i][k] - part.points[j][k]);
        squared += d * d;
      }
      best = std::min(best, squared);
    }
    nearest.push_back(std::sqrt(best));
  }
  std::nth_element(nearest.begin(),
                   nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2),
                   nearest.end());
  return nearest[nearest.size() / 2];
}

}  // namespace relievo::test
