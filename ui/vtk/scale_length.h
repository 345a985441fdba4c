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

}  // namespace relievo
