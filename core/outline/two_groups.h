// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace relievo {

/// Heights parted in two: Otsu's threshold (1979), of all ways to part them the one with the
/// largest variance between the parts.
struct TwoGroups {
  double threshold_mm = 0;
  double separability = 0;  ///< That variance's share of the whole, 0 .. 1; 0: all are the same.
};

/// Exact, as the heights are in order. @param ascending  mm; may be empty
TwoGroups partedInTwo(std::span<const float> ascending);

}  // namespace relievo
