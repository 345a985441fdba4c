// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace relievo::samples {
namespace {

Point3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
double norm(const Point3& a) {
  return std::sqrt(dot(a, a));
}

/// Minimum of two distances, rounded over a width of `blend`; never steeper than they are.
double blendedMin(double a, double b, double blend) {
  const double overlap = std::max(0.0, blend - std::abs(a - b)) / blend;
  return std::min(a, b) - 0.25 * blend * overlap * overlap;
}

Limb enclosingBall(const Limb& limb) {
  const Point3 middle{0.5 * (limb.a.x + limb.b.x), 0.5 * (limb.a.y + limb.b.y),
                      0.5 * (limb.a.z + limb.b.z)};
  const double radius = 0.5 * norm(minus(limb.b, limb.a)) + std::max(limb.radius_a, limb.radius_b);
  return {middle, middle, radius, radius};
}

Limb enclosingBall(const std::vector<Limb>& limbs) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Point3 low{kFar, kFar, kFar};
  Point3 high{-kFar, -kFar, -kFar};
  for (const Limb& limb : limbs) {
    for (const auto& [centre, r] : {std::pair{limb.a, limb.radius_a}, {limb.b, limb.radius_b}}) {
      low = {std::min(low.x, centre.x - r), std::min(low.y, centre.y - r),
             std::min(low.z, centre.z - r)};
      high = {std::max(high.x, centre.x + r), std::max(high.y, centre.y + r),
              std::max(high.z, centre.z + r)};
    }
  }
  const Point3 middle{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)};
  const double radius = 0.5 * norm(minus(high, low));
  return {middle, middle, radius, radius};
}

}  // namespace

double distance(const Limb& limb, const Point3& p) {
  const Point3 axis = minus(limb.b, limb.a);
  const Point3 from_a = minus(p, limb.a);
  const double length = norm(axis);
  const double along = dot(from_a, axis) / length;
  const double beside = std::sqrt(std::max(0.0, dot(from_a, from_a) - along * along));
  // The sphere nearest to p is the one at t with d/dt (|p - c(t)| - r(t)) = 0; with sine s of the
  // cone's half angle that is along - t = s |p - c(t)|, so t = along - s / cos * beside.
  const double sine = (limb.radius_a - limb.radius_b) / length;
  const double cosine = std::sqrt(1 - sine * sine);
  const double t = std::clamp(along - sine / cosine * beside, 0.0, length);
  return std::sqrt(beside * beside + (along - t) * (along - t)) - (limb.radius_a - sine * t);
}

Figure::Figure(std::vector<Limb> limbs, double middle_mm, double flatten, double blend_mm)
    : limbs_(std::move(limbs)),
      middle_mm_(middle_mm),
      flatten_(flatten),
      blend_mm_(blend_mm),
      ball_(enclosingBall(limbs_)) {}

double Figure::distance(const Point3& p, double enough) const {
  // Stretching the flattened axis back makes lengths grow by at most 1 / flatten.
  const Point3 own{p.x, p.y, (p.z - middle_mm_) / flatten_};
  const double to_ball = flatten_ * (norm(minus(own, ball_.a)) - ball_.radius_a - blend_mm_);
  if (to_ball > enough) return to_ball;
  double nearest = std::numeric_limits<double>::max();
  for (const Limb& limb : limbs_) {
    nearest = blendedMin(nearest, samples::distance(limb, own), blend_mm_);
  }
  return flatten_ * nearest;
}

Figure Figure::along(const Ray& ray) const {
  const Point3 foot{ray.foot.x, ray.foot.y, (ray.foot.z - middle_mm_) / flatten_};
  Point3 toward{ray.toward.x, ray.toward.y, ray.toward.z / flatten_};
  const double stretch = norm(toward);
  toward = {toward.x / stretch, toward.y / stretch, toward.z / stretch};
  std::vector<Limb> met;
  for (const Limb& limb : limbs_) {
    const Limb ball = enclosingBall(limb);
    const Point3 from_foot = minus(ball.a, foot);
    const double along = dot(from_foot, toward);
    const double reach = ball.radius_a + blend_mm_;
    if (dot(from_foot, from_foot) - along * along < reach * reach) met.push_back(limb);
  }
  return {std::move(met), middle_mm_, flatten_, blend_mm_};
}

}  // namespace relievo::samples
