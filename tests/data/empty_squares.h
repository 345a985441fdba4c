// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "data/generate/sample.h"

namespace relievo::samples {

/// Points counted in the squares of a grid over a rectangle.
class SquareCounts {
 public:
  SquareCounts(const Cloud& cloud, double left, double bottom, double width, double height,
               double side)
      : left_(left),
        bottom_(bottom),
        side_(side),
        cols_(static_cast<std::size_t>(width / side)),
        rows_(static_cast<std::size_t>(height / side)),
        counts_(cols_ * rows_) {
    for (const auto& p : cloud.points) {
      const double u = (p[0] - left_) / side_;
      const double v = (p[1] - bottom_) / side_;
      if (u < 0 || v < 0 || u >= static_cast<double>(cols_) || v >= static_cast<double>(rows_)) {
        continue;
      }
      ++counts_[static_cast<std::size_t>(v) * cols_ + static_cast<std::size_t>(u)];
    }
  }

  /// Squares whose middle `wanted(x, y)` accepts and that hold no point.
  template <class Wanted>
  std::size_t empty(const Wanted& wanted) const {
    std::size_t found = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      const std::size_t row = i / cols_;
      const double x = left_ + (static_cast<double>(i % cols_) + 0.5) * side_;
      const double y = bottom_ + (static_cast<double>(row) + 0.5) * side_;
      if (counts_[i] == 0 && wanted(x, y)) ++found;
    }
    return found;
  }

  std::size_t at(double x, double y) const {
    return counts_[static_cast<std::size_t>((y - bottom_) / side_) * cols_ +
                   static_cast<std::size_t>((x - left_) / side_)];
  }

 private:
  double left_, bottom_, side_;
  std::size_t cols_, rows_;
  std::vector<std::size_t> counts_;
};

}  // namespace relievo::samples
