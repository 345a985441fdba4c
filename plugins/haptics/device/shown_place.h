// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace relievo {

/// A coordinate for a text of one decimal, mm: never "-0.0".
inline double withoutMinusZero(double mm) {
  return std::abs(mm) < 0.05 ? 0 : mm;
}

}  // namespace relievo
