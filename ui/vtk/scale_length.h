// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// A round length for a scale bar and its label.
struct ScaleLength {
  double mm = 0;
  std::string label;  ///< "5 mm", "20 cm", "2 m".
};
/// The longest of 1, 2, 5 x 10^n mm that is not longer than `at_most_mm` (> 0).
ScaleLength scaleLength(double at_most_mm);

/// How large marks are drawn in a view of so many pixels: as wanted, but where the view is so small
/// that the scale bar would not fit. 1 at least, at which its numbers can just be read.
double fittingMarkScale(double wanted, int width_px, int height_px);

}  // namespace relievo
