// SPDX-License-Identifier: BSD-3-Clause
// Ear clipping (Meisters 1975) in the plane of the polygon's normal by Newell's sums.
#include "core/io/formats/polygon.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

using Flat = std::array<double, 2>;

/// Above it the quadratic time of ears is no longer small beside reading.
constexpr std::size_t kMostEars = 4096;

/// Twice the signed area of a, b, c: above 0 where they turn left.
double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The corners seen along the polygon's normal, counter-clockwise; dropping the axis in which the
/// normal is longest keeps their order and needs no square root.
std::vector<Flat> flattened(std::span<const std::array<float, 3>> corners) {
  std::array<double, 3> normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& p = corners[i];
    const auto& q = corners[(i + 1) % corners.size()];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto pu = static_cast<double>(p[u]), qu = static_cast<double>(q[u]);
      const auto pv = static_cast<double>(p[v]), qv = static_cast<double>(q[v]);
      // Relative to the first corner, so that a place far from zero costs no digits.
      const auto u0 = static_cast<double>(corners[0][u]), v0 = static_cast<double>(corners[0][v]);
      normal[axis] += (pu - u0) * (qv - v0) - (qu - u0) * (pv - v0);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > std::abs(normal[longest])) longest = axis;
  }
  const double sign = normal[longest] < 0 ? -1 : 1;
  std::vector<Flat> flat;
  flat.reserve(corners.size());
  for (const auto& p : corners) {
    flat.push_back({static_cast<double>(p[(longest + 1) % 3]) -
                        static_cast<double>(corners[0][(longest + 1) % 3]),
                    sign * (static_cast<double>(p[(longest + 2) % 3]) -
                            static_cast<double>(corners[0][(longest + 2) % 3]))});
  }
  return flat;
}

bool isConvex(const std::vector<Flat>& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0) return false;
  }
  return true;
}

void fan(std::size_t corners, std::vector<PolygonTriangle>& triangles) {
  for (std::uint32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
}

bool holds(const Flat& a, const Flat& b, const Flat& c, const Flat& p) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

class Ears {
 public:
  Ears(const std::vector<Flat>& flat, std::vector<PolygonTriangle>& triangles)
      : flat_(flat), triangles_(triangles), ring_(flat.size()) {
    for (std::uint32_t i = 0; i < ring_.size(); ++i) ring_[i] = i;
  }

  void cut() {
    std::size_t at = 0, tried = 0;
    while (ring_.size() > 3) {
      // A polygon that crosses itself may have no ear left; then the best corner goes.
      const bool forced = tried >= ring_.size();
      if (forced) at = sharpest();
      if (forced || isEar(at)) {
        clip(at);
        tried = 0;
        if (at >= ring_.size()) at = 0;
      } else {
        ++tried;
        at = (at + 1) % ring_.size();
      }
    }
    triangles_.push_back({ring_[0], ring_[1], ring_[2]});
  }

 private:
  const Flat& corner(std::size_t at, std::size_t further) const {
    return flat_[ring_[(at + further) % ring_.size()]];
  }
  std::size_t before(std::size_t at) const { return at + ring_.size() - 1; }

  bool isEar(std::size_t at) const {
    const Flat &a = corner(before(at), 0), &b = corner(at, 0), &c = corner(at, 1);
    const double area = turn(a, b, c);
    if (area < 0) return false;
    for (std::size_t other = 2; other + 1 < ring_.size(); ++other) {
      const Flat& p = corner(at, other);
      // A corner at the same place as one of the ear's is where the outline touches itself.
      if (p == a || p == b || p == c) continue;
      if (holds(a, b, c, p)) return false;
    }
    return true;
  }

  std::size_t sharpest() const {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t at = 0; at < ring_.size(); ++at) {
      const double area = turn(corner(before(at), 0), corner(at, 0), corner(at, 1));
      if (at == 0 || area > most) {
        best = at;
        most = area;
      }
    }
    return best;
  }

  void clip(std::size_t at) {
    const std::size_t n = ring_.size();
    triangles_.push_back({ring_[before(at) % n], ring_[at], ring_[(at + 1) % n]});
    ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  const std::vector<Flat>& flat_;
  std::vector<PolygonTriangle>& triangles_;
  std::vector<std::uint32_t> ring_;  ///< Corners not yet cut off.
};

}  // namespace

bool cutPolygon(std::span<const std::array<float, 3>> corners,
                std::vector<PolygonTriangle>& triangles) {
  triangles.clear();
  if (corners.size() == 3) {
    triangles.push_back({0, 1, 2});
    return true;
  }
  const std::vector<Flat> flat = flattened(corners);
  const bool convex = isConvex(flat);
  if (convex || corners.size() > kMostEars) {
    fan(corners.size(), triangles);
    return convex;
  }
  Ears(flat, triangles).cut();
  return true;
}

}  // namespace relievo
