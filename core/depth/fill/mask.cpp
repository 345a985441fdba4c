// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/bands.h"

namespace relievo {
namespace {

constexpr std::size_t kWorkOfCell = 2;  // A cell here is as much work as so many of others.

/// Whether any (dilate) or all (erode) of the in-grid neighbours within `radius` are 1, along rows
/// and then along columns; both by whole rows at a time, at a cost independent of the radius.
class SquareSlide {
 public:
  SquareSlide(GridSize size, std::size_t radius, bool dilate)
      : cols_(static_cast<std::size_t>(size.cols)),
        rows_(static_cast<std::size_t>(size.rows)),
        radius_(radius),
        dilate_(dilate) {}

  Mask operator()(const Mask& mask, int threads) const {
    Mask along_rows(mask.size());
    Mask result(mask.size());
    parallelFor(static_cast<int>(rows_), threads, [&](int first, int end) {
      std::vector<std::uint8_t> line(cols_ + 2 * radius_);
      for (int row = first; row < end; ++row) {
        const std::size_t at = static_cast<std::size_t>(row) * cols_;
        slideLine(&mask[at], &along_rows[at], line);
      }
    });
    parallelFor(static_cast<int>(rows_), threads, [&](int first, int end) {
      slideRows(along_rows, static_cast<std::size_t>(first), static_cast<std::size_t>(end), result);
    });
    return result;
  }

 private:
  /// By doubling: after each step line[i] stands for the next `known` cells.
  void slideLine(const std::uint8_t* in, std::uint8_t* out, std::vector<std::uint8_t>& line) const {
    const std::uint8_t beyond = dilate_ ? 0 : 1;
    std::fill(line.begin(), line.end(), beyond);
    std::copy_n(in, cols_, line.begin() + static_cast<std::ptrdiff_t>(radius_));
    const std::size_t width = 2 * radius_ + 1;
    for (std::size_t known = 1; known < width;) {
      const std::size_t more = std::min(known, width - known);
      const std::size_t count = line.size() - more;
      // Forward, so that what is read was not yet written.
      if (dilate_) {
        for (std::size_t i = 0; i < count; ++i) line[i] |= line[i + more];
      } else {
        for (std::size_t i = 0; i < count; ++i) line[i] &= line[i + more];
      }
      known += more;
    }
    std::copy_n(line.begin(), cols_, out);
  }

  /// How many ones are in the rows around, from row to row.
  void slideRows(const Mask& in, std::size_t first, std::size_t end, Mask& out) const {
    std::vector<std::uint16_t> ones(cols_, 0);
    const auto add = [&](std::size_t row) {
      const std::uint8_t* from = &in[row * cols_];
      for (std::size_t i = 0; i < cols_; ++i)
        ones[i] = static_cast<std::uint16_t>(ones[i] + from[i]);
    };
    const auto subtract = [&](std::size_t row) {
      const std::uint8_t* from = &in[row * cols_];
      for (std::size_t i = 0; i < cols_; ++i)
        ones[i] = static_cast<std::uint16_t>(ones[i] - from[i]);
    };
    for (std::size_t row = first > radius_ ? first - radius_ : 0;
         row < std::min(first + radius_, rows_); ++row) {
      add(row);
    }
    for (std::size_t row = first; row < end; ++row) {
      if (row + radius_ < rows_) add(row + radius_);
      if (row > first && row > radius_) subtract(row - radius_ - 1);
      const std::size_t lowest = row > radius_ ? row - radius_ : 0;
      const std::size_t highest = std::min(row + radius_, rows_ - 1);
      const auto enough = static_cast<std::uint16_t>(dilate_ ? 1 : highest - lowest + 1);
      std::uint8_t* to = &out[row * cols_];
      for (std::size_t i = 0; i < cols_; ++i) to[i] = ones[i] >= enough ? 1 : 0;
    }
  }

  std::size_t cols_, rows_, radius_;
  bool dilate_;
};

/// Side of the squares whose occupancy is looked at; 0 if nothing is measured.
int occupancySide(std::size_t measured_cells, GridSize size) {
  if (measured_cells == 0) return 0;
  // Tiles large enough to hold about 30 occupied cells on average.
  const double share = static_cast<double>(measured_cells) / static_cast<double>(size.count());
  const int longest = std::max(4, std::min(size.cols, size.rows) / 4);
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(30 / share))), 4, longest);
}

}  // namespace

Mask closed(const Mask& mask, GridSize size, int radius, int threads) {
  if (radius <= 0 || mask.empty()) return mask;
  const auto r = static_cast<std::size_t>(radius);
  const int used = threadsFor(kWorkOfCell * size.count(), threads);
  return SquareSlide(size, r, false)(SquareSlide(size, r, true)(mask, used), used);
}

int samplingGapRadius(const BitRows& measured) {
  const GridSize size = measured.size();
  const int side = occupancySide(measured.count(), size);
  if (side == 0) return 0;
  std::vector<double> shares;  // Not of squares that reach over the grid.
  for (int row = 0; row + side <= size.rows; row += side) {
    for (int col = 0; col + side <= size.cols; col += side) {
      const int ones = measured.countInSquare({.col = col, .row = row}, side);
      if (ones > 0) shares.push_back(static_cast<double>(ones) / (side * side));
    }
  }
  return samplingGapRadius(std::move(shares), size);
}

int samplingGapRadius(std::vector<double> shares, GridSize size) {
  if (shares.empty()) return 0;
  // The sparser tiles decide, but not those that the outline or a hole cuts: the sparsest
  // sixteenth of the tiles that are at least half as full as the median one.
  std::sort(shares.begin(), shares.end());
  const double median = shares[shares.size() / 2];
  const auto first = std::lower_bound(shares.begin(), shares.end(), 0.5 * median);
  const auto rest = static_cast<std::size_t>(shares.end() - first);
  const double sparse = *(first + static_cast<std::ptrdiff_t>(rest / 16));
  if (sparse >= 1 - 1e-9) return 0;
  const double density = -std::log(1 - sparse);
  // exp(-density (2r+1)^2) <= 1e-4.
  const double width = std::sqrt(9.2 / density);
  const int radius = static_cast<int>(std::ceil((width - 1) / 2));
  return std::clamp(radius, 0, std::max(size.cols, size.rows) / 8);
}

}  // namespace relievo
