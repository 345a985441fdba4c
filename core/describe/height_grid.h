// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "core/region/region_window.h"

namespace relievo {

/// Samples that hang together, side by side.
struct GridArea {
  int samples = 0;
  double col = 0, row = 0;  ///< Centroid.
  int first_col = 0, first_row = 0, last_col = 0, last_row = 0;
  bool has_its_centroid = false;

  void add(int index);
};

/// The heights of a window where there is an object that was seen: not outside of it, nor on the
/// base plane of a hole.
class HeightGrid {
 public:
  static constexpr int kSide = kWindowSamples, kCount = kSide * kSide;

  explicit HeightGrid(const RegionWindow& window);

  bool has(int index) const { return has_[static_cast<std::size_t>(index)]; }
  float heightMm(int index) const { return heights_mm_[static_cast<std::size_t>(index)]; }
  double stepMm() const { return step_mm_; }
  double xMm(double col) const { return left_mm_ + (col + 0.5) * step_mm_; }
  double yMm(double row) const { return bottom_mm_ + (row + 0.5) * step_mm_; }

  /// The means of 5 x 5 samples; only where all of them are there.
  HeightGrid smoothed() const;
  /// The difference, where both have a height.
  HeightGrid without(const HeightGrid& other) const;
  /// Correlation with the mirror image, of what has a height on both sides; nothing where these are
  /// few, or the heights all the same.
  std::optional<double> mirrored(bool left_and_right) const;
  /// Areas of samples that are so, largest first.
  std::vector<GridArea> areas(const std::function<bool(int index)>& is_so) const;

 private:
  double left_mm_, bottom_mm_, step_mm_;
  std::vector<float> heights_mm_;
  std::vector<bool> has_;
};

}  // namespace relievo
