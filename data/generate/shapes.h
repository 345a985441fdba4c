// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace relievo::samples {

struct Point2 {
  double x = 0, y = 0;
};

/// 0 up to `low`, 1 from `high` on, smooth between.
inline double smoothStep(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

inline double distanceToSegment(Point2 p, Point2 a, Point2 b) {
  const double ax = p.x - a.x;
  const double ay = p.y - a.y;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp((ax * dx + ay * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(ax - t * dx, ay - t * dy);
}

/// To a multiple of `step`: what a file can hold, and the same on every machine.
inline double rounded(double value, double step) {
  return std::round(value / step) * step;
}

}  // namespace relievo::samples
