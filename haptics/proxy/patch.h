// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// The bilinear surface of one closed cell (paper sec. 3, fig. 2), grid units:
/// f(x, y) = a + b u + c v + d u v with u = x - x0, v = y - y0.
/// Cell (i, j) lies between samples i and i + 1. Cells -1 and 199 are the borders: infinitely
/// wide, they continue the outermost samples as constants, f(x, y) = f(clamp x, clamp y).
struct Patch {
  double x0 = 0, y0 = 0;
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;  ///< The cell; infinite at the borders.
  double a = 0, b = 0, c = 0, d = 0;

  double height(double x, double y) const RELIEVO_REALTIME {
    const double u = x - x0, v = y - y0;
    return a + b * u + v * (c + d * u);
  }
  double slopeX(double y) const RELIEVO_REALTIME { return b + d * (y - y0); }
  double slopeY(double x) const RELIEVO_REALTIME { return c + d * (x - x0); }
};

inline constexpr int kFirstCell = -1;                 ///< The border below or left of the samples.
inline constexpr int kLastCell = kWindowSamples - 1;  ///< The border above or right of them.
inline constexpr double kLastSample = kWindowSamples - 1;

/// Cell that holds coordinate x; on a border between cells the one on the side of `direction`.
inline int cellOf(double x, double direction) RELIEVO_REALTIME {
  if (x < 0 || (x <= 0 && direction < 0)) return kFirstCell;
  if (x > kLastSample || (x >= kLastSample && direction >= 0)) return kLastCell;
  const int cell = static_cast<int>(x);  // Rounds down: x is not negative here.
  return (x <= cell && direction < 0) ? cell - 1 : cell;
}

inline Patch patchAt(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const int left = std::max(col, 0), right = std::min(col + 1, kWindowSamples - 1);
  const int low = std::max(row, 0), high = std::min(row + 1, kWindowSamples - 1);
  Patch p;
  p.x0 = left;
  p.y0 = low;
  p.x_low = col < 0 ? -kInfinity : col;
  p.x_high = col == kLastCell ? kInfinity : col + 1;
  p.y_low = row < 0 ? -kInfinity : row;
  p.y_high = row == kLastCell ? kInfinity : row + 1;
  p.a = space.gridHeight(left, low);
  // In a border cell left == right (or low == high), so that its slopes are exactly zero.
  const double to_right = space.gridHeight(right, low), to_top = space.gridHeight(left, high);
  p.b = to_right - p.a;
  p.c = to_top - p.a;
  p.d = (space.gridHeight(right, high) - to_top) - p.b;
  return p;
}

/// f(x, y) of the whole surface, grid units.
inline double surfaceHeight(const HapticSpace& space, double x, double y) RELIEVO_REALTIME {
  return patchAt(space, cellOf(x, 0), cellOf(y, 0)).height(x, y);
}

/// Unit normal of the bilinear patch at (x, y); z > 0.
inline GridPoint patchNormal(const Patch& patch, double x, double y) RELIEVO_REALTIME {
  const double fx = patch.slopeX(y), fy = patch.slopeY(x);
  const double length = std::sqrt(1 + fx * fx + fy * fy);
  return {-fx / length, -fy / length, 1 / length};
}

}  // namespace relievo
