// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/crossing.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
/// Smallest s in [0, 1] from which g(s) = g0 + b s + a s^2 is below zero, for g0 >= 0; kNever if
/// there is none. Written without the difference of nearly equal numbers.
double firstRoot(double g0, double b, double a) RELIEVO_REALTIME {
  if (b >= 0 && a >= 0) return kNever;
  const double discriminant = b * b - 4 * a * g0;
  if (discriminant < 0) return kNever;  // Convex, and its lowest point is above the surface.
  const double root = std::sqrt(discriminant);
  const double s = b < 0 ? 2 * g0 / (root - b) : -(b + root) / (2 * a);
  return s <= 1 ? s : kNever;
}

/// Coefficients over the Bernstein polynomials of degree 6: the polynomial lies in their hull.
Sextic bernstein(const Sextic& power) RELIEVO_REALTIME {
  constexpr Sextic kBinomial{1, 6, 15, 20, 15, 6, 1};
  Sextic b{};
  for (std::size_t i = 0; i < 7; ++i) b[i] = power[i] / kBinomial[i];
  for (std::size_t level = 1; level < 7; ++level) {
    for (std::size_t i = 6; i >= level; --i) b[i] += b[i - 1];
  }
  return b;
}

/// de Casteljau at one half: `b` becomes the second half.
Sextic splitHalf(Sextic& b) RELIEVO_REALTIME {
  Sextic first{};
  for (std::size_t level = 0; level < 7; ++level) {
    first[level] = b[0];
    for (std::size_t i = 0; i + level + 1 < 7; ++i) b[i] = 0.5 * (b[i] + b[i + 1]);
  }
  return first;
}

/// The only root between low (value >= 0) and high (value < 0): Newton, kept in by bisection.
double onlyRoot(const Sextic& power, double low, double high) RELIEVO_REALTIME {
  double s = low;
  for (int i = 0; i < 60 && high - low > 1e-16; ++i) {
    double value = power[6], slope = 0;
    for (std::size_t k = 6; k-- > 0;) {
      slope = value + s * slope;
      value = power[k] + s * value;
    }
    (value >= 0 ? low : high) = s;
    const double step = value / slope;
    double next = s - step;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - s) <= 1e-15) return std::min(next, s);
    s = next;
  }
  return low;
}

/// firstBelowZero on the piece [low, low + width], given the piece's Bernstein coefficients.
double firstBelow(const Sextic& power, Sextic b, double low, double width,
                  int depth) RELIEVO_REALTIME {
  std::size_t negative = 0;
  while (negative < 7 && b[negative] >= 0) ++negative;
  if (negative == 7) return kNever;
  if (negative == 0) return low;
  const bool changes_once = std::all_of(b.begin() + static_cast<std::ptrdiff_t>(negative), b.end(),
                                        [](double c) { return c < 0; });
  if (changes_once) return onlyRoot(power, low, low + width);
  constexpr int kDeepest = 40;  // Pieces of 1e-12: what is still undecided only grazes.
  if (depth == kDeepest) return b[6] < 0 ? low : kNever;
  const Sextic first = splitHalf(b);
  const double s = firstBelow(power, first, low, 0.5 * width, depth + 1);
  return s < kNever ? s : firstBelow(power, b, low + 0.5 * width, 0.5 * width, depth + 1);
}
}  // namespace

double crossing(const BilinearPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME {
  // A straight line's height above the bilinear patch is a quadratic: its values at both ends and
  // its curvature -d du dv give it without cancellation.
  const double above = std::max(0.0, from.z - patch.height(from.x, from.y));
  const double above_exit = to.z - patch.height(to.x, to.y);
  const double curvature = -patch.d * (to.x - from.x) * (to.y - from.y);
  const double s = firstRoot(above, above_exit - above - curvature, curvature);
  return s == kNever && above_exit < 0 ? 1 : s;
}

Sextic heightAbove(const BicubicPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME {
  const double u = from.x - patch.x0, v = from.y - patch.y0;
  const double du = to.x - from.x, dv = to.y - from.y;
  // Column i of the patch along the way: a cubic of s. Then Horner's rule over u + du s.
  Sextic f{};
  for (std::size_t i = 4; i-- > 0;) {
    for (std::size_t k = 6; k > 0; --k) f[k] = u * f[k] + du * f[k - 1];
    f[0] *= u;
    const double c0 = patch.c[0][i], c1 = patch.c[1][i], c2 = patch.c[2][i], c3 = patch.c[3][i];
    f[0] += c0 + v * (c1 + v * (c2 + v * c3));
    f[1] += dv * (c1 + v * (2 * c2 + 3 * v * c3));
    f[2] += dv * dv * (c2 + 3 * v * c3);
    f[3] += dv * dv * dv * c3;
  }
  Sextic above{};
  for (std::size_t k = 0; k < 7; ++k) above[k] = -f[k];
  above[0] += from.z;
  above[1] += to.z - from.z;
  return above;
}

double firstBelowZero(const Sextic& polynomial) RELIEVO_REALTIME {
  return firstBelow(polynomial, bernstein(polynomial), 0, 1, 0);
}

double crossing(const BicubicPatch& patch, GridPoint from, GridPoint to) RELIEVO_REALTIME {
  Sextic above = heightAbove(patch, from, to);
  above[0] = std::max(0.0, above[0]);
  const double s = firstBelowZero(above);
  return s == kNever && to.z < patch.height(to.x, to.y) ? 1 : s;
}

}  // namespace relievo
