// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/patch.h"

namespace relievo {

namespace {
/// Cubic with given values and slopes at u = 0 and 1, as powers of u.
std::array<double, 4> cubic(double f0, double d0, double f1, double d1) RELIEVO_REALTIME {
  const double rise = f1 - f0;
  return {f0, d0, 3 * rise - 2 * d0 - d1, d0 + d1 - 2 * rise};
}

/// The cell between samples that a border cell continues, and the corners it sees there.
Corners borderCorners(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  const int in_col = std::clamp(col, 0, kLastCell - 1);
  const int in_row = std::clamp(row, 0, kLastCell - 1);
  Corners c = cornersOf(space, in_col, in_row);
  if (col != in_col) {  // Constant in x.
    for (const std::size_t low : {0U, 2U}) {
      Corner& edge = col < 0 ? c[low] : c[low + 1];
      edge.fx = edge.fxy = 0;
      (col < 0 ? c[low + 1] : c[low]) = edge;
    }
  }
  if (row != in_row) {
    for (const std::size_t left : {0U, 1U}) {
      Corner& edge = row < 0 ? c[left] : c[left + 2];
      edge.fy = edge.fxy = 0;
      (row < 0 ? c[left + 2] : c[left]) = edge;
    }
  }
  return c;
}

bool isBorder(int col, int row) RELIEVO_REALTIME {
  return col < 0 || row < 0 || col == kLastCell || row == kLastCell;
}
}  // namespace

BilinearPatch bilinearPatch(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  const int left = std::max(col, 0), right = std::min(col + 1, kWindowSamples - 1);
  const int low = std::max(row, 0), high = std::min(row + 1, kWindowSamples - 1);
  BilinearPatch p;
  p.box = cellBox(col, row);
  p.x0 = left;
  p.y0 = low;
  p.a = space.gridHeight(left, low);
  // In a border cell left == right (or low == high), so that its slopes are exactly zero.
  const double to_right = space.gridHeight(right, low), to_top = space.gridHeight(left, high);
  p.b = to_right - p.a;
  p.c = to_top - p.a;
  p.d = (space.gridHeight(right, high) - to_top) - p.b;
  return p;
}

BicubicPatch bicubicPatch(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  BicubicPatch p;
  p.box = cellBox(col, row);
  const bool border = isBorder(col, row);
  p.x0 = border ? std::clamp(col, 0, kLastCell - 1) : col;
  p.y0 = border ? std::clamp(row, 0, kLastCell - 1) : row;
  const Corners k = border ? borderCorners(space, col, row) : cornersOf(space, col, row);
  const std::array<double, 4> low = cubic(k[0].f, k[0].fx, k[1].f, k[1].fx);
  const std::array<double, 4> top = cubic(k[2].f, k[2].fx, k[3].f, k[3].fx);
  const std::array<double, 4> low_y = cubic(k[0].fy, k[0].fxy, k[1].fy, k[1].fxy);
  const std::array<double, 4> top_y = cubic(k[2].fy, k[2].fxy, k[3].fy, k[3].fxy);
  for (std::size_t i = 0; i < 4; ++i) {
    const double rise = top[i] - low[i];
    p.c[0][i] = low[i];
    p.c[1][i] = low_y[i];
    p.c[2][i] = 3 * rise - 2 * low_y[i] - top_y[i];
    p.c[3][i] = low_y[i] + top_y[i] - 2 * rise;
  }
  return p;
}

}  // namespace relievo
