// SPDX-License-Identifier: BSD-3-Clause
// Compiled with -O3 and without contraction to fused multiply-add: all builds of a loop below give
// the same bits.
#include "core/pyramid/halve.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/base/bands.h"
#include "core/base/wide_vectors.h"
#include "core/pyramid/kernel.h"

namespace relievo {
namespace {

/// 16 times the five rows' weighted mean. Meanwhile asks for the two rows that the next call needs
/// and this one does not: from memory they take as long as the sums.
RELIEVO_WIDE_VECTORS
void sumRows(const FiveRows& rows, const TwoRows& next, int cols, float* __restrict out) {
  constexpr std::ptrdiff_t kPiece = 64;
  constexpr std::ptrdiff_t kLine = 16;  // Of the cache: 64 bytes.
  constexpr int kSecondCache = 2;  // Rows of 2^n samples would push each other out of the first.
  const float* a = rows[0];
  const float* b = rows[1];
  const float* c = rows[2];
  const float* d = rows[3];
  const float* e = rows[4];
  const std::ptrdiff_t pieces_end = cols - cols % kPiece;
  for (std::ptrdiff_t first = 0; first < pieces_end; first += kPiece) {
    for (std::ptrdiff_t k = first; k < first + kPiece; k += kLine) {
      __builtin_prefetch(next[0] + k, 0, kSecondCache);
      __builtin_prefetch(next[1] + k, 0, kSecondCache);
    }
    for (std::ptrdiff_t i = first; i < first + kPiece; ++i) {
      out[i] = (a[i] + e[i]) + 4 * (b[i] + d[i]) + 6 * c[i];
    }
  }
  for (std::ptrdiff_t i = pieces_end; i < cols; ++i) {
    out[i] = (a[i] + e[i]) + 4 * (b[i] + d[i]) + 6 * c[i];
  }
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
  const auto pairs = (static_cast<std::size_t>(cols) + 1) / 2 + 2;
  padded_.resize(2 * pairs);
  even_.resize(pairs);
  odd_.resize(pairs);
}

void RowHalver::operator()(const FiveRows& rows, const TwoRows& next, float* out) {
  float* row = padded_.data() + 2;
  sumRows(rows, next, cols_, row);
  for (const int i : {-2, -1, cols_, cols_ + 1}) row[i] = row[mirrored(i, cols_)];
  const int out_cols = (cols_ + 1) / 2;
  split(padded_.data(), out_cols + 2, even_.data(), odd_.data());
  sumAlongRow(even_.data(), odd_.data(), out_cols, out);
}

namespace {

/// One row of shares: the kernel of the rows, then along the row, in whole numbers.
class RowShares {
 public:
  explicit RowShares(int cols)
      : cols_(cols), sums_(2 * ((static_cast<std::size_t>(cols) + 1) / 2 + 2)) {}

  void operator()(const std::array<const CellStatus*, 5>& rows, float* out) {
    std::uint8_t* const row = sums_.data() + 2;
    sumMeasured(rows, cols_, row);
    for (const int i : {-2, -1, cols_, cols_ + 1}) row[i] = row[mirrored(i, cols_)];
    sumAlong(sums_.data(), (cols_ + 1) / 2, out);
  }

 private:
  RELIEVO_WIDE_VECTORS
  static void sumMeasured(const std::array<const CellStatus*, 5>& rows, int cols,
                          std::uint8_t* __restrict out) {
    const CellStatus* a = rows[0];
    const CellStatus* b = rows[1];
    const CellStatus* c = rows[2];
    const CellStatus* d = rows[3];
    const CellStatus* e = rows[4];
    const auto one = [](CellStatus origin) {
      return static_cast<std::uint8_t>(origin == CellStatus::measured ? 1 : 0);
    };
    for (int i = 0; i < cols; ++i) {
      out[i] = static_cast<std::uint8_t>(one(a[i]) + one(e[i]) + 4 * (one(b[i]) + one(d[i])) +
                                         6 * one(c[i]));
    }
  }
  /// @param in  begins with the sample -2
  RELIEVO_WIDE_VECTORS
  static void sumAlong(const std::uint8_t* __restrict in, int out_cols, float* __restrict out) {
    for (std::ptrdiff_t i = 0; i < out_cols; ++i) {
      const std::uint8_t* at = in + 2 * i;
      const int sum = at[0] + at[4] + 4 * (at[1] + at[3]) + 6 * at[2];
      out[i] = static_cast<float>(sum) * (1.0F / 256);
    }
  }

  int cols_;
  std::vector<std::uint8_t> sums_;
};

}  // namespace

LargeArray<float> halved(std::span<const float> in, GridSize size, GridSize out_size, int threads,
                         const Task& task) {
  LargeArray<float> out(out_size.count());
  const auto row_at = [&](int row) {
    return in.data() + size.index({.col = 0, .row = mirrored(row, size.rows)});
  };
  parallelFor(out_size.rows, threadsFor(size.count(), threads), [&](int first, int end) {
    RowHalver halve(size.cols);
    for (int j = first; j < end; ++j) {
      if (j % 64 == 0) task.check();
      FiveRows rows{};
      for (int n = 0; n < 5; ++n) rows[static_cast<std::size_t>(n)] = row_at(2 * j - 2 + n);
      halve(rows, {row_at(2 * j + 3), row_at(2 * j + 4)},
            &out[out_size.index({.col = 0, .row = j})]);
    }
  });
  return out;
}

LargeArray<float> halvedShares(std::span<const CellStatus> origins, GridSize size,
                               GridSize out_size, int threads, const Task& task) {
  LargeArray<float> out(out_size.count());
  parallelFor(out_size.rows, threadsFor(size.count(), threads), [&](int first, int end) {
    RowShares shares(size.cols);
    for (int j = first; j < end; ++j) {
      if (j % 64 == 0) task.check();
      std::array<const CellStatus*, 5> rows{};
      for (int n = 0; n < 5; ++n) {
        const int from = mirrored(2 * j - 2 + n, size.rows);
        rows[static_cast<std::size_t>(n)] = origins.data() + size.index({.col = 0, .row = from});
      }
      shares(rows, &out[out_size.index({.col = 0, .row = j})]);
    }
  });
  return out;
}

}  // namespace relievo
