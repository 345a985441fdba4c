// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: all builds of a loop below give
// the same bits.
#include "core/depth/rules/row_fits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

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

using CellRows = std::array<const double*, 2 * kReach + 1>;

/// Sums over the window's rows of u^A (v + e)^B = sum_i binomial(B, i) e^(B - i) u^A v^i for all B;
/// z times that with `kHeights`. All B at once: each plane is read once.
template <int A, bool kHeights>
RELIEVO_INLINE void sumDown(const CellRows& rows, std::ptrdiff_t stride, double* __restrict out) {
  static_assert(kReach == 2);
  constexpr int kPowers = (kHeights ? 3 : 5) - A;
  constexpr auto kPlane = [](int b) {
    return static_cast<std::ptrdiff_t>(kHeights ? heightPlane(A, b) : plane(A, b));
  };
  const double* __restrict r0 = rows[0];
  const double* __restrict r1 = rows[1];
  const double* __restrict r2 = rows[2];
  const double* __restrict r3 = rows[3];
  const double* __restrict r4 = rows[4];
  for (std::ptrdiff_t c = 0; c < stride; ++c) {
    // Of the rows two and one beside the middle: sums for even powers of e, differences for odd.
    double outer[kPowers][2];
    double inner[kPowers][2];
#pragma GCC unroll 5
    for (int i = 0; i < kPowers; ++i) {
      const std::ptrdiff_t at = kPlane(i) * stride + c;
      outer[i][0] = r4[at] + r0[at];
      outer[i][1] = r4[at] - r0[at];
      inner[i][0] = r3[at] + r1[at];
      inner[i][1] = r3[at] - r1[at];
    }
#pragma GCC unroll 5
    for (int b = 0; b < kPowers; ++b) {
      double sum = 0;
#pragma GCC unroll 5
      for (int i = 0; i <= b; ++i) {
        const double one = binomial(b, i);
        const double two = one * power(2, b - i);
        sum += two * outer[i][(b - i) % 2] + one * inner[i][(b - i) % 2];
      }
      const std::ptrdiff_t at = kPlane(b) * stride + c;
      out[at] = sum + r2[at];
    }
  }
}

/// From sums over the cells to sums down the columns.
RELIEVO_WIDE_VECTORS
void sumColumns(const CellRows& cells, std::ptrdiff_t stride, double* columns) {
  sumDown<0, false>(cells, stride, columns);
  sumDown<1, false>(cells, stride, columns);
  sumDown<2, false>(cells, stride, columns);
  sumDown<3, false>(cells, stride, columns);
  sumDown<4, false>(cells, stride, columns);
  sumDown<0, true>(cells, stride, columns);
  sumDown<1, true>(cells, stride, columns);
  sumDown<2, true>(cells, stride, columns);
  const std::ptrdiff_t squares = static_cast<std::ptrdiff_t>(kSquares) * stride;
  for (std::ptrdiff_t c = squares; c < squares + stride; ++c) {
    columns[c] = ((cells[0][c] + cells[4][c]) + (cells[1][c] + cells[3][c])) + cells[2][c];
  }
}

/// Sums over the window's columns of (u + e)^A = sum_i binomial(A, i) e^(A - i) u^i for all
/// A < kPowers, likewise.
/// @param in  plane of u^0; those of u^1 ... follow, `stride` apart
template <int kPowers>
RELIEVO_INLINE void sumAlong(const double* __restrict in, std::ptrdiff_t stride, int cols,
                             double* __restrict out) {
  for (std::ptrdiff_t c = 0; c < cols; ++c) {
#pragma GCC unroll 5
    for (int a = 0; a < kPowers; ++a) {
      double sum = 0;
#pragma GCC unroll 5
      for (int e = -kReach; e <= kReach; ++e) {
#pragma GCC unroll 5
        for (int i = 0; i <= a; ++i) {
          const double factor = binomial(a, i) * power(e, a - i);
          if (factor != 0) sum += factor * in[i * stride + c + e + kReach];
        }
      }
      out[a * stride + c] = sum;
    }
  }
}

/// From sums down the columns to sums over the windows.
RELIEVO_WIDE_VECTORS
void sumWindows(const double* columns, std::ptrdiff_t stride, int cols, double* windows) {
  const auto at = [stride](std::size_t plane) {
    return static_cast<std::ptrdiff_t>(plane) * stride;
  };
  const auto& power = kFirstOfPower;
  const auto& height = kFirstOfHeightPower;
  sumAlong<5>(columns + at(power[0]), stride, cols, windows + at(power[0]));
  sumAlong<4>(columns + at(power[1]), stride, cols, windows + at(power[1]));
  sumAlong<3>(columns + at(power[2]), stride, cols, windows + at(power[2]));
  sumAlong<2>(columns + at(power[3]), stride, cols, windows + at(power[3]));
  sumAlong<1>(columns + at(power[4]), stride, cols, windows + at(power[4]));
  sumAlong<3>(columns + at(height[0]), stride, cols, windows + at(height[0]));
  sumAlong<2>(columns + at(height[1]), stride, cols, windows + at(height[1]));
  sumAlong<1>(columns + at(height[2]), stride, cols, windows + at(height[2]));
  sumAlong<1>(columns + at(kSquares), stride, cols, windows + at(kSquares));
}

struct Exponents {
  int a, b;
};
constexpr std::array<Exponents, kUnknowns> kBasis{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

/// Eight numbers side by side: one register where there are such, else several. In an array they
/// lie anywhere.
using Lanes [[gnu::vector_size(kLanes * sizeof(double))]] = double;
using LanesInArray
    [[gnu::vector_size(kLanes * sizeof(double)), gnu::aligned(sizeof(double)), gnu::may_alias]] =
        double;
using Floats [[gnu::vector_size(kLanes * sizeof(float))]] = float;

RELIEVO_INLINE const LanesInArray& lanesAt(const double* from) {
  return *reinterpret_cast<const LanesInArray*>(from);
}
RELIEVO_INLINE LanesInArray& lanesAt(double* to) {
  return *reinterpret_cast<LanesInArray*>(to);
}

/// Normal equations of eight windows side by side, by L D L^T: no roots, one division a column.
RELIEVO_WIDE_VECTORS
void solve(const double* windows, std::ptrdiff_t stride, int blocks, double* heights, double* rms,
           double* fitted) {
  for (std::ptrdiff_t block = 0; block < blocks; ++block) {
    const std::ptrdiff_t to = block * static_cast<std::ptrdiff_t>(kLanes);
    const double* const at = windows + to;
    const auto sums = [&](std::size_t plane) -> const LanesInArray& {
      return lanesAt(at + static_cast<std::ptrdiff_t>(plane) * stride);
    };
    const Lanes count = lanesAt(at);
    const Lanes zero{};
    Lanes l[kUnknowns][kUnknowns];
    Lanes d[kUnknowns];
    Lanes y[kUnknowns];
    Lanes good = zero + 1;
#pragma GCC unroll 6
    for (std::size_t i = 0; i < kUnknowns; ++i) {
#pragma GCC unroll 6
      for (std::size_t j = 0; j <= i; ++j) {
        Lanes m = sums(plane(kBasis[i].a + kBasis[j].a, kBasis[i].b + kBasis[j].b));
        // Columns before j are scaled by their pivots already: l[i][k] d[k] l[j][k].
#pragma GCC unroll 6
        for (std::size_t k = 0; k < j; ++k) m -= l[i][k] * d[k] * l[j][k];
        if (i == j) {
          good = m > 1e-7 * count ? good : zero;
          d[i] = m;
        } else {
          l[i][j] = m / d[j];
        }
      }
      y[i] = sums(heightPlane(kBasis[i].a, kBasis[i].b));
#pragma GCC unroll 6
      for (std::size_t k = 0; k < i; ++k) y[i] -= l[i][k] * y[k];
    }
    // What the fit explains of the sum of squares is y^T D^-1 y.
    Lanes rest = sums(kSquares);
#pragma GCC unroll 6
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      rest -= y[i] * y[i] / d[i];
      y[i] /= d[i];
    }
#pragma GCC unroll 6
    for (std::size_t i = kUnknowns; i-- > 0;) {
#pragma GCC unroll 6
      for (std::size_t k = i + 1; k < kUnknowns; ++k) y[i] -= l[k][i] * y[k];
    }
    const Lanes freedom = count - static_cast<double>(kUnknowns);
    const Lanes variance = (rest > zero ? rest : zero) / freedom;
    // Points all around keep a quadratic's middle near their mean: a bowl's is 1.73 deviations off,
    // a slope's at the corner of the map 2.45. Beyond, LocalFit says whether to believe it.
    const Lanes mean = sums(heightPlane(0, 0)) / count;
    const Lanes square = sums(kSquares) / count;
    const Lanes off = y[0] - mean;
    const Lanes rounding = 1e-12 * square;
    const Lanes near = off * off <= 6.25 * (square - mean * mean) + rounding ? good : zero;
    const Lanes is_fitted = count >= RowFits::kFewest ? near : zero;
    lanesAt(heights + to) = y[0];
    lanesAt(rms + to) = variance;
    lanesAt(fitted + to) = is_fitted;
  }
}

/// Sums of the powers in every cell of some columns of a row, eight cells side by side: the first
/// point of each, then the second of those that have one ... A cell's points come in turn.
RELIEVO_WIDE_VECTORS
void sumPoints(const std::uint32_t* __restrict starts, const PlacedPoint* __restrict points,
               int cols, std::ptrdiff_t stride, double* __restrict out) {
  for (int first = 0; first < cols; first += static_cast<int>(kLanes)) {
    std::array<std::uint32_t, kLanes> next{};
    std::array<std::uint32_t, kLanes> end{};
    const auto cells = std::min(kLanes, static_cast<std::size_t>(cols - first));
    std::uint32_t most = 0;
    for (std::size_t n = 0; n < cells; ++n) {
      next[n] = starts[first + static_cast<int>(n)];
      end[n] = starts[first + static_cast<int>(n) + 1];
      most = std::max(most, end[n] - next[n]);
    }
    Lanes sums[kSums]{};
    for (std::uint32_t p = 0; p < most; ++p) {
      Floats one{};
      Floats du{};
      Floats dv{};
      Floats dz{};
      for (std::size_t n = 0; n < kLanes; ++n) {
        if (next[n] == end[n]) continue;
        const PlacedPoint& point = points[next[n]++];
        one[n] = 1;
        du[n] = point.du;
        dv[n] = point.dv;
        dz[n] = point.z;
      }
      const Lanes u = __builtin_convertvector(du, Lanes);
      const Lanes v = __builtin_convertvector(dv, Lanes);
      const Lanes z = __builtin_convertvector(dz, Lanes);
      const Lanes uu = u * u;
      const Lanes uv = u * v;
      const Lanes vv = v * v;
      const Lanes terms[kSums]{__builtin_convertvector(one, Lanes),
                               u,
                               uu,
                               u * uu,
                               uu * uu,
                               v,
                               uv,
                               uv * u,
                               uv * uu,
                               vv,
                               uv * v,
                               uv * uv,
                               vv * v,
                               uv * vv,
                               vv * vv,
                               z,
                               z * u,
                               z * uu,
                               z * v,
                               z * uv,
                               z * vv,
                               z * z};
#pragma GCC unroll 22
      for (std::size_t k = 0; k < kSums; ++k) sums[k] += terms[k];
    }
#pragma GCC unroll 22
    for (std::size_t k = 0; k < kSums; ++k) {
      lanesAt(out + static_cast<std::ptrdiff_t>(k) * stride + first) = sums[k];
    }
  }
}

}  // namespace

void RowFits::resize(int cols) {
  const std::size_t blocks = (static_cast<std::size_t>(cols) + kLanes - 1) / kLanes;
  // The cells begin kReach before the first column and are summed in whole blocks, too, which at
  // the grid's border begin kReach later.
  const std::size_t stride = (blocks + 2) * kLanes;
  static_assert(2 * kReach <= static_cast<int>(kLanes));
  if (stride == stride_) return;
  stride_ = stride;
  for (std::vector<double>& row : cells_) row.assign(kSums * stride_, 0.0);
  columns_.assign(kSums * stride_, 0.0);
  windows_.assign(kSums * stride_, 0.0);
  heights_mm_.assign(blocks * kLanes, 0.0);
  rms_mm_.assign(blocks * kLanes, 0.0);
  fitted_.assign(blocks * kLanes, 0.0);
}

void RowFits::sumCells(const RowPoints& rows, int row, int end_col) {
  // One beyond the grid is empty; rows begin at -kReach.
  std::vector<double>& to = cells_[placeOf(row)];
  const int first = std::max(first_col_ - kReach, 0);
  const int end = std::min(end_col + kReach, rows.cols);
  const bool is_whole = first == first_col_ - kReach && end == end_col + kReach;
  const bool is_row = row >= rows.first_row && row < rows.end_row;
  if (!is_whole || !is_row) std::fill(to.begin(), to.end(), 0.0);
  if (!is_row) return;
  sumPoints(rows.starts.data() + rows.cell(first, row), rows.points.data(), end - first,
            static_cast<std::ptrdiff_t>(stride_), to.data() + (first - (first_col_ - kReach)));
}

void RowFits::compute(const RowPoints& rows, int row, int first_col, int end_col, bool first) {
  resize(end_col - first_col);
  first_col_ = first_col;
  for (int r = first ? row - kReach : row + kReach; r <= row + kReach; ++r) {
    sumCells(rows, r, end_col);
  }
  CellRows cells{};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k] = cells_[placeOf(row - kReach + static_cast<int>(k))].data();
  }
  const auto stride = static_cast<std::ptrdiff_t>(stride_);
  sumColumns(cells, stride, columns_.data());
  sumWindows(columns_.data(), stride, end_col - first_col, windows_.data());
  solve(windows_.data(), stride, static_cast<int>(heights_mm_.size() / kLanes), heights_mm_.data(),
        rms_mm_.data(), fitted_.data());
  for (std::size_t i = 0; i < index(end_col); ++i) rms_mm_[i] = std::sqrt(rms_mm_[i]);
}

}  // namespace relievo
