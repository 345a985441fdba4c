// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace relievo::test {

/// A point of a profile, and of the hand in its plane.
struct Point2 {
  double x = 0, z = 0;
};

/// Independent god-object in the plane: the surface is a polyline over x, constant beyond its ends.
/// Written without a look at the solver it checks: segments instead of cells, projections instead
/// of Newton steps, many small movements of the hand.
class PolylineProxy {
 public:
  explicit PolylineProxy(std::vector<Point2> vertices) : v_(std::move(vertices)) {
    constexpr double kFar = 1e4;
    v_.insert(v_.begin(), {v_.front().x - kFar, v_.front().z});
    v_.push_back({v_.back().x + kFar, v_.back().z});
  }

  void place(Point2 hand) { hand_ = proxy_ = hand; }  ///< In free space.

  void follow(Point2 hand, int sub_steps = 50) {
    const Point2 from = hand_;
    for (int i = 1; i <= sub_steps; ++i) {
      const double part = static_cast<double>(i) / sub_steps;
      hand_ = {from.x + part * (hand.x - from.x), from.z + part * (hand.z - from.z)};
      settle();
    }
    hand_ = hand;
  }

  bool contact() const { return contact_; }
  Point2 proxy() const { return proxy_; }
  Point2 force() const { return {proxy_.x - hand_.x, proxy_.z - hand_.z}; }

 private:
  void settle() {
    for (int guard = 0; guard < 2000; ++guard) {
      if (!contact_ || isFree()) {
        if (!shoot()) return;
        continue;
      }
      if (!slide()) return;
    }
  }
  double slope(std::size_t k) const { return (v_[k + 1].z - v_[k].z) / (v_[k + 1].x - v_[k].x); }
  bool atLeftEnd() const { return proxy_.x == v_[segment_].x; }
  bool atRightEnd() const { return proxy_.x == v_[segment_ + 1].x; }

  /// Does the way to the hand lead off the surface?
  bool isFree() const {
    const double dx = hand_.x - proxy_.x, dz = hand_.z - proxy_.z;
    std::size_t k = segment_;
    if (dx > 0 && atRightEnd() && k + 2 < v_.size()) ++k;
    if (dx < 0 && atLeftEnd() && k > 0) --k;
    return dz - slope(k) * dx > 1e-12;
  }

  /// Straight to the hand, or onto the first segment in the way. @return false: arrived
  bool shoot() {
    const double dx = hand_.x - proxy_.x, dz = hand_.z - proxy_.z;
    double first = std::numeric_limits<double>::infinity();
    std::size_t hit = 0;
    for (std::size_t k = 0; k + 1 < v_.size(); ++k) {
      const double fall = dz - slope(k) * dx;  // Of the way against the segment's line.
      if (fall >= -1e-15) continue;            // Leaves it on the upper side.
      const double above = proxy_.z - (v_[k].z + slope(k) * (proxy_.x - v_[k].x));
      const double t = above / -fall;
      const double x = proxy_.x + t * dx;
      if (t < 0 || t > 1 || x < v_[k].x || x > v_[k + 1].x || t >= first) continue;
      if (t < 1e-12 && contact_) continue;  // Where it just left.
      first = t;
      hit = k;
    }
    contact_ = first <= 1;
    if (!contact_) {
      proxy_ = hand_;
      return false;
    }
    segment_ = hit;
    const double x = proxy_.x + first * dx;
    proxy_ = {x, v_[hit].z + slope(hit) * (x - v_[hit].x)};
    return true;
  }

  /// How far toward the hand along segment k, per unit of its length.
  double pull(std::size_t k) const {
    const double s = slope(k);
    return ((hand_.x - proxy_.x) + s * (hand_.z - proxy_.z)) / std::sqrt(1 + s * s);
  }

  /// To the foot of the perpendicular on the segment, or to its end. @return false: at rest
  bool slide() {
    std::size_t k = segment_;
    if (atRightEnd() && k + 2 < v_.size() && pull(k + 1) > std::max(0.0, -pull(k)))
      ++k;
    else if (atLeftEnd() && k > 0 && -pull(k - 1) > std::max(0.0, pull(k)))
      --k;
    segment_ = k;
    const double s = slope(k), p = pull(k);
    double x = proxy_.x + p / std::sqrt(1 + s * s);
    x = std::min(std::max(x, v_[k].x), v_[k + 1].x);
    if (std::abs(x - proxy_.x) * std::sqrt(1 + s * s) < 1e-12) return false;
    proxy_.x = x;
    proxy_.z = x == v_[k + 1].x ? v_[k + 1].z : v_[k].z + s * (x - v_[k].x);
    return true;
  }

  std::vector<Point2> v_;
  Point2 proxy_, hand_;
  std::size_t segment_ = 0;
  bool contact_ = false;
};

}  // namespace relievo::test
