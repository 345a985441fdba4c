// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: all builds of a loop below give
// the same bits.
#include "core/depth/row_fits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/wide_vectors.h"

#define RELIEVO_INLINE inline __attribute__((always_inline))

namespace relievo {
namespace {

constexpr int kReach = RowFits::kReach;
constexpr std::size_t kSums = RowFits::kSums;
constexpr std::size_t kUnknowns = 6;  // 1, u, v, u^2, uv, v^2
constexpr std::size_t kLanes = 8;

// Planes: for every power b of v those of u, then the same for z times them, then z^2.
//   b = 0: u^0 .. u^4, b = 1: u^0 .. u^3, ...
constexpr std::array<std::size_t, 5> kFirstOfPower{0, 5, 9, 12, 14};
constexpr std::array<std::size_t, 3> kFirstOfHeightPower{15, 18, 20};
constexpr std::size_t kSquares = 21;

constexpr std::size_t plane(int a, int b) {
  return kFirstOfPower[static_cast<std::size_t>(b)] + static_cast<std::size_t>(a);
}
constexpr std::size_t heightPlane(int a, int b) {
  return kFirstOfHeightPower[static_cast<std::size_t>(b)] + static_cast<std::size_t>(a);
}

constexpr double power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}
constexpr double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// Sum over the window's columns of (u + e)^A = sum_i binomial(A, i) e^(A - i) u^i.
/// @param in  plane of u^0; those of u^1 ... u^A follow, `stride` apart
template <int A>
RELIEVO_INLINE void sumPower(const double* __restrict in, std::ptrdiff_t stride, int cols,
                             double* __restrict out) {
  for (int c = 0; c < cols; ++c) {
    double sum = 0;
    for (int e = -kReach; e <= kReach; ++e) {
      for (int i = 0; i <= A; ++i) {
        const double factor = binomial(A, i) * power(e, A - i);
        if (factor != 0) sum += factor * in[i * stride + c + e + kReach];
      }
    }
    out[c] = sum;
  }
}

using CellRows = std::array<const double*, 2 * kReach + 1>;

/// Sum over the window's rows of u^A (v + e)^B = sum_i binomial(B, i) e^(B - i) u^A v^i, as above;
/// z times that with `kHeights`.
template <int A, int B, bool kHeights>
RELIEVO_INLINE void sumDown(const CellRows& rows, std::ptrdiff_t stride, double* __restrict out) {
  constexpr auto kPlane = [](int b) {
    return static_cast<std::ptrdiff_t>(kHeights ? heightPlane(A, b) : plane(A, b));
  };
  const double* __restrict r0 = rows[0];
  const double* __restrict r1 = rows[1];
  const double* __restrict r2 = rows[2];
  const double* __restrict r3 = rows[3];
  const double* __restrict r4 = rows[4];
  double* const to = out + kPlane(B) * stride;
  for (std::ptrdiff_t c = 0; c < stride; ++c) {
    double sum = 0;
    for (int i = 0; i <= B; ++i) {
      const std::ptrdiff_t at = kPlane(i) * stride + c;
      const double one = binomial(B, i);
      const double two = one * power(2, B - i);
      const double odd = (B - i) % 2 == 0 ? 1 : -1;
      sum += two * (r4[at] + odd * r0[at]) + one * (r3[at] + odd * r1[at]);
    }
    to[c] = sum + r2[kPlane(B) * stride + c];
  }
}

/// From sums over the cells to sums down the columns.
RELIEVO_WIDE_VECTORS
void sumColumns(const CellRows& cells, std::ptrdiff_t stride, double* columns) {
  static_assert(kReach == 2);
  sumDown<0, 0, false>(cells, stride, columns);
  sumDown<0, 1, false>(cells, stride, columns);
  sumDown<0, 2, false>(cells, stride, columns);
  sumDown<0, 3, false>(cells, stride, columns);
  sumDown<0, 4, false>(cells, stride, columns);
  sumDown<1, 0, false>(cells, stride, columns);
  sumDown<1, 1, false>(cells, stride, columns);
  sumDown<1, 2, false>(cells, stride, columns);
  sumDown<1, 3, false>(cells, stride, columns);
  sumDown<2, 0, false>(cells, stride, columns);
  sumDown<2, 1, false>(cells, stride, columns);
  sumDown<2, 2, false>(cells, stride, columns);
  sumDown<3, 0, false>(cells, stride, columns);
  sumDown<3, 1, false>(cells, stride, columns);
  sumDown<4, 0, false>(cells, stride, columns);
  sumDown<0, 0, true>(cells, stride, columns);
  sumDown<0, 1, true>(cells, stride, columns);
  sumDown<0, 2, true>(cells, stride, columns);
  sumDown<1, 0, true>(cells, stride, columns);
  sumDown<1, 1, true>(cells, stride, columns);
  sumDown<2, 0, true>(cells, stride, columns);
  const std::ptrdiff_t squares = static_cast<std::ptrdiff_t>(kSquares) * stride;
  for (std::ptrdiff_t c = squares; c < squares + stride; ++c) {
    columns[c] = ((cells[0][c] + cells[4][c]) + (cells[1][c] + cells[3][c])) + cells[2][c];
  }
}

/// From sums down the columns to sums over the windows.
RELIEVO_WIDE_VECTORS
void sumWindows(const double* columns, std::ptrdiff_t stride, int cols, double* windows) {
  const auto sum = [&](std::size_t first, int powers) {
    const double* in = columns + static_cast<std::ptrdiff_t>(first) * stride;
    double* out = windows + static_cast<std::ptrdiff_t>(first) * stride;
    sumPower<0>(in, stride, cols, out);
    if (powers > 1) sumPower<1>(in, stride, cols, out + stride);
    if (powers > 2) sumPower<2>(in, stride, cols, out + 2 * stride);
    if (powers > 3) sumPower<3>(in, stride, cols, out + 3 * stride);
    if (powers > 4) sumPower<4>(in, stride, cols, out + 4 * stride);
  };
  for (int b = 0; b <= 4; ++b) sum(kFirstOfPower[static_cast<std::size_t>(b)], 5 - b);
  for (int b = 0; b <= 2; ++b) sum(kFirstOfHeightPower[static_cast<std::size_t>(b)], 3 - b);
  sum(kSquares, 1);
}

struct Exponents {
  int a, b;
};
constexpr std::array<Exponents, kUnknowns> kBasis{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

/// Normal equations of eight windows side by side, by L D L^T: no roots, one division a column.
RELIEVO_WIDE_VECTORS
void solve(const double* windows, std::ptrdiff_t stride, int blocks, double* heights, double* rms,
           double* fitted) {
  using Lanes = std::array<double, kLanes>;
  for (int block = 0; block < blocks; ++block) {
    const double* at = windows + static_cast<std::ptrdiff_t>(block) * static_cast<int>(kLanes);
    Lanes l[kUnknowns][kUnknowns];
    Lanes d[kUnknowns];
    Lanes y[kUnknowns];
    Lanes good;
    good.fill(1);
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const double* m = at + static_cast<std::ptrdiff_t>(
                                   plane(kBasis[i].a + kBasis[j].a, kBasis[i].b + kBasis[j].b)) *
                                   stride;
        for (std::size_t n = 0; n < kLanes; ++n) l[i][j][n] = m[n];
        // Columns before j are scaled by their pivots already: l[i][k] d[k] l[j][k].
        for (std::size_t k = 0; k < j; ++k) {
          for (std::size_t n = 0; n < kLanes; ++n) l[i][j][n] -= l[i][k][n] * d[k][n] * l[j][k][n];
        }
        if (i == j) {
          for (std::size_t n = 0; n < kLanes; ++n) {
            good[n] = l[i][i][n] > 1e-7 * at[n] ? good[n] : 0.0;
            d[i][n] = l[i][i][n];
          }
        } else {
          for (std::size_t n = 0; n < kLanes; ++n) l[i][j][n] /= d[j][n];
        }
      }
      const double* z =
          at + static_cast<std::ptrdiff_t>(heightPlane(kBasis[i].a, kBasis[i].b)) * stride;
      for (std::size_t n = 0; n < kLanes; ++n) y[i][n] = z[n];
      for (std::size_t k = 0; k < i; ++k) {
        for (std::size_t n = 0; n < kLanes; ++n) y[i][n] -= l[i][k][n] * y[k][n];
      }
    }
    // What the fit explains of the sum of squares is y^T D^-1 y.
    const double* squares = at + static_cast<std::ptrdiff_t>(kSquares) * stride;
    Lanes rest;
    for (std::size_t n = 0; n < kLanes; ++n) rest[n] = squares[n];
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t n = 0; n < kLanes; ++n) {
        rest[n] -= y[i][n] * y[i][n] / d[i][n];
        y[i][n] /= d[i][n];
      }
    }
    for (std::size_t i = kUnknowns; i-- > 0;) {
      for (std::size_t k = i + 1; k < kUnknowns; ++k) {
        for (std::size_t n = 0; n < kLanes; ++n) y[i][n] -= l[k][i][n] * y[k][n];
      }
    }
    const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(block) * static_cast<int>(kLanes);
    for (std::size_t n = 0; n < kLanes; ++n) {
      const double freedom = at[n] - static_cast<double>(kUnknowns);
      heights[to + static_cast<std::ptrdiff_t>(n)] = y[0][n];
      rms[to + static_cast<std::ptrdiff_t>(n)] = (rest[n] > 0 ? rest[n] : 0.0) / freedom;
      fitted[to + static_cast<std::ptrdiff_t>(n)] = at[n] >= RowFits::kFewest ? good[n] : 0.0;
    }
  }
}

}  // namespace

void RowFits::resize(int cols) {
  const std::size_t blocks = (static_cast<std::size_t>(cols) + kLanes - 1) / kLanes;
  const std::size_t stride = blocks * kLanes + 2 * kReach;
  if (stride == stride_) return;
  stride_ = stride;
  for (std::vector<double>& row : cells_) row.assign(kSums * stride_, 0.0);
  columns_.assign(kSums * stride_, 0.0);
  windows_.assign(kSums * stride_, 0.0);
  heights_mm_.assign(blocks * kLanes, 0.0);
  rms_mm_.assign(blocks * kLanes, 0.0);
  fitted_.assign(blocks * kLanes, 0.0);
}

void RowFits::sumCells(const RowPoints& rows, int row) {
  // One beyond the grid is empty; rows begin at -kReach.
  std::vector<double>& to = cells_[static_cast<std::size_t>(row + kRows) % kRows];
  if (row < rows.first_row || row >= rows.end_row) {
    std::fill(to.begin(), to.end(), 0.0);
    return;
  }
  for (int col = 0; col < rows.cols; ++col) {
    // One cell's sums stay in registers; the planes are written once.
    std::array<double, kSums> sums{};
    for (const PlacedPoint& p : rows.of(col, col + 1, row)) {
      const auto u = static_cast<double>(p.du);
      const auto v = static_cast<double>(p.dv);
      const auto z = static_cast<double>(p.z);
      const double uu = u * u;
      const double uv = u * v;
      const double vv = v * v;
      const std::array<double, kSums> terms{1,      u,       uu,      u * uu, uu * uu, v,
                                            uv,     uv * u,  uv * uu, vv,     uv * v,  uv * uv,
                                            vv * v, uv * vv, vv * vv, z,      z * u,   z * uu,
                                            z * v,  z * uv,  z * vv,  z * z};
      for (std::size_t k = 0; k < kSums; ++k) sums[k] += terms[k];
    }
    double* const out = to.data() + kReach + col;
    for (std::size_t k = 0; k < kSums; ++k) out[k * stride_] = sums[k];
  }
}

void RowFits::compute(const RowPoints& rows, int row, bool first) {
  resize(rows.cols);
  for (int r = first ? row - kReach : row + kReach; r <= row + kReach; ++r) sumCells(rows, r);
  CellRows cells{};
  for (int e = -kReach; e <= kReach; ++e) {
    cells[static_cast<std::size_t>(e + kReach)] =
        cells_[static_cast<std::size_t>(row + e + kRows) % kRows].data();
  }
  const auto stride = static_cast<std::ptrdiff_t>(stride_);
  sumColumns(cells, stride, columns_.data());
  sumWindows(columns_.data(), stride, rows.cols, windows_.data());
  solve(windows_.data(), stride, static_cast<int>(heights_mm_.size() / kLanes), heights_mm_.data(),
        rms_mm_.data(), fitted_.data());
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows.cols); ++i) {
    rms_mm_[i] = std::sqrt(rms_mm_[i]);
  }
}

}  // namespace relievo
