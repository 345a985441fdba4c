// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/origin.h"
#include "core/region/square.h"

namespace relievo {

/// The paper's fixed haptic space has 200 x 200 samples (sec. 6).
inline constexpr int kWindowSamples = 200;
inline constexpr std::size_t kWindowCount = std::size_t{kWindowSamples} * kWindowSamples;

/// The surface that is shown in detail and lies under the hand: one region resampled to 200 x 200.
/// Sample (i, j) sits at x_mm + (i + 0.5) side/200, y_mm + (j + 0.5) side/200; row 0 lowest y.
struct RegionWindow {
  std::uint64_t id = 0;  ///< Differs between windows whose samples differ.
  Region region;
  double gain = 1;                ///< Already applied to the heights.
  std::vector<float> heights_mm;  ///< kWindowCount values, view mm above the base plane.
  std::vector<CellStatus>
      origins;                   ///< Of the map cell nearest each sample; outside beyond the map.
  float min_mm = 0, max_mm = 0;  ///< Of heights_mm.
  int levels = 1;                ///< Of the pyramid; the window is Detail levels - level of levels.

  double spacingMm() const noexcept { return region.side_mm / kWindowSamples; }
};

}  // namespace relievo
