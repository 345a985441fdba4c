// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace relievo {
namespace {

/// out[i] = 1 if any (dilate) or all (erode) of the in-grid neighbours within radius are 1, along
/// one line of `count` cells that are `stride` apart.
void slideLine(const std::uint8_t* in, std::uint8_t* out, std::size_t count, std::size_t stride,
               std::size_t radius, bool dilate) {
  std::size_t ones = 0;
  const std::size_t head = std::min(radius, count);
  for (std::size_t i = 0; i < head; ++i) ones += in[i * stride];
  for (std::size_t i = 0; i < count; ++i) {
    if (i + radius < count) ones += in[(i + radius) * stride];
    if (i > radius) ones -= in[(i - radius - 1) * stride];
    const std::size_t first = i > radius ? i - radius : 0;
    const std::size_t last = std::min(i + radius, count - 1);
    out[i * stride] = dilate ? ones > 0 : ones == last - first + 1;
  }
}

Mask slideSquare(const Mask& mask, GridSize size, std::size_t radius, bool dilate) {
  const auto cols = static_cast<std::size_t>(size.cols);
  const auto rows = static_cast<std::size_t>(size.rows);
  Mask along_rows(mask.size());
  for (std::size_t row = 0; row < rows; ++row) {
    slideLine(&mask[row * cols], &along_rows[row * cols], cols, 1, radius, dilate);
  }
  Mask result(mask.size());
  for (std::size_t col = 0; col < cols; ++col) {
    slideLine(&along_rows[col], &result[col], rows, cols, radius, dilate);
  }
  return result;
}

/// Share of occupied cells per tile; only tiles that hold something.
std::vector<double> tileOccupancy(const Mask& mask, GridSize size, int tile) {
  std::vector<double> shares;
  for (int row0 = 0; row0 + tile <= size.rows; row0 += tile) {
    for (int col0 = 0; col0 + tile <= size.cols; col0 += tile) {
      int ones = 0;
      for (int row = row0; row < row0 + tile; ++row) {
        for (int col = col0; col < col0 + tile; ++col) {
          ones += mask[size.index({.col = col, .row = row})];
        }
      }
      if (ones > 0) shares.push_back(static_cast<double>(ones) / (tile * tile));
    }
  }
  return shares;
}

}  // namespace

Mask closed(const Mask& mask, GridSize size, int radius) {
  if (radius <= 0 || mask.empty()) return mask;
  const auto r = static_cast<std::size_t>(radius);
  return slideSquare(slideSquare(mask, size, r, true), size, r, false);
}

int occupancySide(std::size_t measured_cells, GridSize size) {
  if (measured_cells == 0) return 0;
  // Tiles large enough to hold about 30 occupied cells on average.
  const double share = static_cast<double>(measured_cells) / static_cast<double>(size.count());
  const int longest = std::max(4, std::min(size.cols, size.rows) / 4);
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(30 / share))), 4, longest);
}

int samplingGapRadius(const Mask& measured, GridSize size) {
  const auto ones =
      static_cast<std::size_t>(std::count(measured.begin(), measured.end(), std::uint8_t{1}));
  if (ones == 0) return 0;
  return samplingGapRadius(tileOccupancy(measured, size, occupancySide(ones, size)), size);
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

EmptyAreas emptyAreas(const Mask& mask, GridSize size) {
  EmptyAreas areas;
  areas.label.assign(mask.size(), -1);
  std::vector<Cell> stack;
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const std::size_t start = size.index({.col = col, .row = row});
      if (mask[start] != 0 || areas.label[start] >= 0) continue;
      const int label = static_cast<int>(areas.cells.size());
      areas.cells.push_back(0);
      areas.at_border.push_back(false);
      areas.label[start] = label;
      stack.push_back({.col = col, .row = row});
      while (!stack.empty()) {
        const Cell cell = stack.back();
        stack.pop_back();
        ++areas.cells.back();
        for (const Cell next : {Cell{cell.col - 1, cell.row}, Cell{cell.col + 1, cell.row},
                                Cell{cell.col, cell.row - 1}, Cell{cell.col, cell.row + 1}}) {
          if (!size.contains(next)) {
            areas.at_border.back() = true;
            continue;
          }
          const std::size_t index = size.index(next);
          if (mask[index] != 0 || areas.label[index] >= 0) continue;
          areas.label[index] = label;
          stack.push_back(next);
        }
      }
    }
  }
  return areas;
}

}  // namespace relievo
