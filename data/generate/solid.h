// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace relievo::samples {

struct Point3 {
  double x = 0, y = 0, z = 0;
};

/// A ray toward a viewer: all foot + t * toward.
struct Ray {
  Point3 foot;    ///< At z = 0.
  Point3 toward;  ///< Unit vector, z > 0.

  Point3 at(double t) const {
    return {foot.x + t * toward.x, foot.y + t * toward.y, foot.z + t * toward.z};
  }
};

/// All spheres whose centre runs from `a` to `b` while the radius goes from `radius_a` to
/// `radius_b`: an arm, a leg, a leaf. |radius_a - radius_b| must be less than the length.
struct Limb {
  Point3 a, b;
  double radius_a = 0, radius_b = 0;
};

/// Distance from `p` to the limb, negative inside; exact.
double distance(const Limb& limb, const Point3& p);

/// A body made of limbs that flow into one another, flattened toward the ground as in a bas-relief.
class Figure {
 public:
  /// Limbs stand in the figure's own space; z there is counted from the figure's middle.
  /// @param middle_mm  height of the middle above the ground
  /// @param flatten    (0, 1]: depth is multiplied by this
  /// @param blend_mm   how wide the joints are rounded
  Figure(std::vector<Limb> limbs, double middle_mm, double flatten, double blend_mm);

  /// A lower bound of the distance to the figure, exact enough to walk along a ray until it is
  /// zero. May stop early, with another lower bound, once it is clear that it exceeds `enough`.
  double distance(const Point3& p, double enough) const;

  /// The figure with only those limbs that the ray can meet: the same surface along the ray,
  /// found much sooner.
  Figure along(const Ray& ray) const;

  bool empty() const { return limbs_.empty(); }

 private:
  std::vector<Limb> limbs_;
  double middle_mm_, flatten_, blend_mm_;
  Limb ball_;  ///< Encloses all limbs.
};

}  // namespace relievo::samples
