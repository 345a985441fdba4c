// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: all builds of a loop below give
// the same bits.
#include "core/pyramid/halve.h"

#include <cstddef>

#include "core/base/bands.h"
#include "core/base/wide_vectors.h"
#include "core/pyramid/kernel.h"

namespace relievo {
namespace {

/// 16 times the five rows' weighted mean.
RELIEVO_WIDE_VECTORS
void sumRows(const FiveRows& rows, int cols, float* __restrict out) {
  const float* a = rows[0];
  const float* b = rows[1];
  const float* c = rows[2];
  const float* d = rows[3];
  const float* e = rows[4];
  for (int i = 0; i < cols; ++i) out[i] = (a[i] + e[i]) + 4 * (b[i] + d[i]) + 6 * c[i];
}

/// Sorted into samples 0, 2, 4 ... and 1, 3, 5 ..., so that the taps below are contiguous.
RELIEVO_WIDE_VECTORS
void split(const float* __restrict in, int pairs, float* __restrict even, float* __restrict odd) {
  for (std::ptrdiff_t i = 0; i < pairs; ++i) {
    even[i] = in[2 * i];
    odd[i] = in[2 * i + 1];
  }
}

/// @param even, odd  begin with the samples -2 and -1
RELIEVO_WIDE_VECTORS
void sumAlongRow(const float* __restrict even, const float* __restrict odd, int out_cols,
                 float* __restrict out) {
  for (int i = 0; i < out_cols; ++i) {
    out[i] = ((even[i] + even[i + 2]) + 4 * (odd[i] + odd[i + 1]) + 6 * even[i + 1]) * (1.0F / 256);
  }
}

}  // namespace

RowHalver::RowHalver(int cols) : cols_(cols) {
  const auto pairs = static_cast<std::size_t>((cols + 1) / 2 + 2);
  padded_.resize(2 * pairs);
  even_.resize(pairs);
  odd_.resize(pairs);
}

void RowHalver::operator()(const FiveRows& rows, float* out) {
  float* row = padded_.data() + 2;
  sumRows(rows, cols_, row);
  for (const int i : {-2, -1, cols_, cols_ + 1}) row[i] = row[mirrored(i, cols_)];
  const int out_cols = (cols_ + 1) / 2;
  split(padded_.data(), out_cols + 2, even_.data(), odd_.data());
  sumAlongRow(even_.data(), odd_.data(), out_cols, out);
}

std::vector<float> halved(const std::vector<float>& in, GridSize size, GridSize out_size,
                          int threads, const Task& task) {
  const auto halve_row = [&](RowHalver& halve, int j, float* out) {
    if (j % 64 == 0) task.check();
    FiveRows rows{};
    for (int n = 0; n < 5; ++n) {
      const int from = mirrored(2 * j - 2 + n, size.rows);
      rows[static_cast<std::size_t>(n)] = in.data() + size.index({.col = 0, .row = from});
    }
    halve(rows, out);
  };
  std::vector<float> out;
  const int bands = threadsFor(size.count(), threads);
  if (bands == 1) {
    // Appended: setting all to zero first would take a fifth of the time.
    RowHalver halve(size.cols);
    std::vector<float> line(static_cast<std::size_t>(out_size.cols));
    out.reserve(out_size.count());
    for (int j = 0; j < out_size.rows; ++j) {
      halve_row(halve, j, line.data());
      out.insert(out.end(), line.begin(), line.end());
    }
    return out;
  }
  out.resize(out_size.count());
  inBands(out_size.rows, bands, [&](int first, int end) {
    RowHalver halve(size.cols);
    for (int j = first; j < end; ++j) {
      halve_row(halve, j, out.data() + out_size.index({.col = 0, .row = j}));
    }
  });
  return out;
}

}  // namespace relievo
