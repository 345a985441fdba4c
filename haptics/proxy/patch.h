// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/rt/realtime.h"
#include "haptics/space/cell.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// Height of the surface at a point with its first and second derivatives, grid units.
struct Jet {
  double f = 0, fx = 0, fy = 0, fxx = 0, fxy = 0, fyy = 0;
};

/// A closed cell. Cell (i, j) lies between samples i and i + 1; cells -1 and 199 are the borders:
/// infinitely wide, they continue the outermost samples, f(x, y) = f(clamp x, clamp y).
struct CellBox {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
};

inline CellBox cellBox(int col, int row) RELIEVO_REALTIME {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {col < 0 ? -kInfinity : col, col == kLastCell ? kInfinity : col + 1,
          row < 0 ? -kInfinity : row, row == kLastCell ? kInfinity : row + 1};
}

/// The bilinear surface of one cell (paper sec. 3, fig. 2): f(x, y) = a + b u + c v + d u v with
/// u = x - x0, v = y - y0.
struct BilinearPatch {
  CellBox box;
  double x0 = 0, y0 = 0;
  double a = 0, b = 0, c = 0, d = 0;

  double height(double x, double y) const RELIEVO_REALTIME {
    const double u = x - x0, v = y - y0;
    return a + b * u + v * (c + d * u);
  }
  Jet jet(double x, double y) const RELIEVO_REALTIME {
    const double u = x - x0, v = y - y0;
    return {a + b * u + v * (c + d * u), b + d * v, c + d * u, 0, d, 0};
  }
};

BilinearPatch bilinearPatch(const HapticSpace& space, int col, int row) RELIEVO_REALTIME;

/// A bicubic surface: f(x, y) = sum of c[j][i] u^i v^j.
struct BicubicPatch {
  CellBox box;
  double x0 = 0, y0 = 0;
  std::array<std::array<double, 4>, 4> c{};

  double height(double x, double y) const RELIEVO_REALTIME {
    const double u = x - x0, v = y - y0;
    std::array<double, 4> p{};
    for (std::size_t i = 0; i < 4; ++i)
      p[i] = c[0][i] + v * (c[1][i] + v * (c[2][i] + v * c[3][i]));
    return p[0] + u * (p[1] + u * (p[2] + u * p[3]));
  }
  Jet jet(double x, double y) const RELIEVO_REALTIME {
    const double u = x - x0, v = y - y0;
    std::array<double, 4> p{}, q{}, r{};  // Along v: value and two derivatives, by powers of u.
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = c[0][i] + v * (c[1][i] + v * (c[2][i] + v * c[3][i]));
      q[i] = c[1][i] + v * (2 * c[2][i] + 3 * v * c[3][i]);
      r[i] = 2 * c[2][i] + 6 * v * c[3][i];
    }
    return {p[0] + u * (p[1] + u * (p[2] + u * p[3])), p[1] + u * (2 * p[2] + 3 * u * p[3]),
            q[0] + u * (q[1] + u * (q[2] + u * q[3])), 2 * p[2] + 6 * u * p[3],
            q[1] + u * (2 * q[2] + 3 * u * q[3]),      r[0] + u * (r[1] + u * (r[2] + u * r[3]))};
  }
};

BicubicPatch bicubicPatch(const HapticSpace& space, int col, int row) RELIEVO_REALTIME;

/// Cell that holds coordinate x; on a border between cells the one on the side of `direction`.
inline int cellOf(double x, double direction) RELIEVO_REALTIME {
  if (x < 0 || (x <= 0 && direction < 0)) return kFirstCell;
  if (x > kLastSample || (x >= kLastSample && direction >= 0)) return kLastCell;
  const int cell = static_cast<int>(x);  // Rounds down: x is not negative here.
  return (x <= cell && direction < 0) ? cell - 1 : cell;
}

}  // namespace relievo
