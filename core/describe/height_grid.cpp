// SPDX-License-Identifier: BSD-3-Clause
#include "core/describe/height_grid.h"

#include <cmath>

namespace relievo {

void GridArea::add(int index) {
  const int c = index % HeightGrid::kSide, r = index / HeightGrid::kSide;
  col = (col * samples + c) / (samples + 1);
  row = (row * samples + r) / (samples + 1);
  ++samples;
  first_col = std::min(first_col, c);
  last_col = std::max(last_col, c);
  first_row = std::min(first_row, r);
  last_row = std::max(last_row, r);
}

HeightGrid::HeightGrid(const RegionWindow& window)
    : left_mm_(window.region.x_mm),
      bottom_mm_(window.region.y_mm),
      step_mm_(window.spacingMm()),
      heights_mm_(window.heights_mm),
      has_(kWindowCount) {
  for (std::size_t i = 0; i < kWindowCount; ++i) {
    has_[i] =
        window.origins[i] != CellStatus::outside && window.origins[i] != CellStatus::base_plane;
  }
}

HeightGrid HeightGrid::smoothed() const {
  constexpr int kReach = 2;
  HeightGrid mean = *this;
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      double sum = 0;
      bool all = row >= kReach && col >= kReach && row < kSide - kReach && col < kSide - kReach;
      for (int dr = -kReach; all && dr <= kReach; ++dr) {
        for (int dc = -kReach; all && dc <= kReach; ++dc) {
          const int i = (row + dr) * kSide + col + dc;
          all = has(i);
          if (all) sum += heightMm(i);
        }
      }
      const auto at = static_cast<std::size_t>(row * kSide + col);
      mean.has_[at] = all;
      mean.heights_mm_[at] = static_cast<float>(sum / 25);
    }
  }
  return mean;
}

HeightGrid HeightGrid::without(const HeightGrid& other) const {
  HeightGrid rest = *this;
  for (std::size_t i = 0; i < kWindowCount; ++i) {
    rest.has_[i] = has_[i] && other.has_[i];
    rest.heights_mm_[i] = heights_mm_[i] - other.heights_mm_[i];
  }
  return rest;
}

std::optional<double> HeightGrid::mirrored(bool left_and_right) const {
  int pairs = 0, samples = 0;
  double sum = 0, squares = 0, products = 0;
  for (int i = 0; i < kCount; ++i) {
    if (!has(i)) continue;
    ++samples;
    const int col = i % kSide, row = i / kSide;
    const int other =
        left_and_right ? row * kSide + kSide - 1 - col : (kSide - 1 - row) * kSide + col;
    if (!has(other)) continue;
    ++pairs;
    const double h = heightMm(i), mirror = heightMm(other);
    sum += h;  // Each sample is in two pairs, once on either side: their means are the same.
    squares += h * h;
    products += h * mirror;
  }
  if (pairs == 0 || 2 * pairs < samples) return std::nullopt;
  const double mean = sum / pairs, variance = squares / pairs - mean * mean;
  if (variance <= 1e-12 * squares / pairs) return std::nullopt;
  return (products / pairs - mean * mean) / variance;
}

std::vector<GridArea> HeightGrid::areas(const std::function<bool(int index)>& is_so) const {
  std::vector<int> area_of(kWindowCount, -1);
  std::vector<GridArea> found;
  std::vector<int> left;
  for (int start = 0; start < kCount; ++start) {
    if (area_of[static_cast<std::size_t>(start)] >= 0 || !is_so(start)) continue;
    const int number = static_cast<int>(found.size());
    GridArea area{.first_col = kSide, .first_row = kSide};
    const auto reach = [&](int index) {
      int& of = area_of[static_cast<std::size_t>(index)];
      if (of >= 0 || !is_so(index)) return;
      of = number;
      left.push_back(index);
    };
    reach(start);
    while (!left.empty()) {
      const int i = left.back();
      left.pop_back();
      area.add(i);
      if (i % kSide > 0) reach(i - 1);
      if (i % kSide < kSide - 1) reach(i + 1);
      if (i >= kSide) reach(i - kSide);
      if (i < kCount - kSide) reach(i + kSide);
    }
    const auto middle =
        static_cast<std::size_t>(std::lround(area.row) * kSide + std::lround(area.col));
    area.has_its_centroid = area_of[middle] == number;
    found.push_back(area);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const GridArea& a, const GridArea& b) { return a.samples > b.samples; });
  return found;
}

}  // namespace relievo
