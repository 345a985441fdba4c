// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace relievo {

/// Numbers at the crossings of a grid; where there is none no line runs.
struct Samples {
  int cols = 0, rows = 0;
  std::vector<double> values;  ///< Row 0 first; cols * rows.
  std::vector<bool> has;       ///< Likewise.

  std::size_t at(int col, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols) +
           static_cast<std::size_t>(col);
  }
};

/// A place between the samples; sample (col, row) lies at (col, row).
struct SamplePlace {
  double col = 0, row = 0;
};

/// The closed lines on which the values are `level`, by marching squares: linear between two
/// samples, and in a cell that could be parted in two ways as its mean says. What is higher lies
/// left of the line; the first place is not said again. A line that reaches the border, or a place
/// without a value, is not closed and is left out.
std::vector<std::vector<SamplePlace>> closedLevelLines(const Samples& samples, double level);

/// In samples squared; > 0: what is higher lies inside.
double signedArea(const std::vector<SamplePlace>& line);

}  // namespace relievo
