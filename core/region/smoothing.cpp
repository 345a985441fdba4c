// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/smoothing.h"

#include <cmath>

#include "core/pyramid/kernel.h"

namespace relievo {

// Variances of kernels that follow one another add up:
//   sigma_l^2 = sum_{k < l} v(M) s_k^2
// where v is a step's variance in squared spacings s_k of the level that it starts from.
double smoothingMm(const DetailLadder& ladder, Level level) {
  const double step = kernelVariance(ladder.factor);
  double variance_mm2 = 0;
  for (int k = 0; k < level.value; ++k) {
    const double spacing_mm = ladder.spacings_mm[static_cast<std::size_t>(k)];
    variance_mm2 += step * spacing_mm * spacing_mm;
  }
  return std::sqrt(variance_mm2);
}

}  // namespace relievo
