// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/finer_heights.h"

#include <algorithm>

#include "core/region/window.h"
#include "core/session/large/tiled_surface.h"

namespace relievo {

std::vector<float> finerHeights(const Surface& surface, const Region& region, double gain) {
  if (region.level.value <= 0) return {};
  constexpr std::size_t kSide = 2 * std::size_t{kWindowSamples};
  std::vector<float> heights_mm(kSide * kSide);
  const double half = 0.5 * region.side_mm;
  for (const std::size_t low : {std::size_t{0}, std::size_t{kWindowSamples}}) {
    for (const std::size_t left : {std::size_t{0}, std::size_t{kWindowSamples}}) {
      const Region quarter{region.x_mm + (left > 0 ? half : 0), region.y_mm + (low > 0 ? half : 0),
                           half, Level{region.level.value - 1}};
      const RegionWindow window = windowOf(surface, quarter, gain);
      for (std::size_t row = 0; row < kWindowSamples; ++row) {
        std::copy_n(window.heights_mm.begin() + static_cast<std::ptrdiff_t>(row * kWindowSamples),
                    kWindowSamples,
                    heights_mm.begin() + static_cast<std::ptrdiff_t>((low + row) * kSide + left));
      }
    }
  }
  return heights_mm;
}

}  // namespace relievo
