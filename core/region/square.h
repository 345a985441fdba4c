// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/grid.h"

namespace relievo {

/// What is shown in detail and touched: a square in view millimetres and the level that feeds it.
struct Region {
  double x_mm = 0, y_mm = 0;  ///< Lower left corner.
  double side_mm = 0;
  Level level;
  friend bool operator==(const Region&, const Region&) = default;

  double centreX() const noexcept { return x_mm + 0.5 * side_mm; }
  double centreY() const noexcept { return y_mm + 0.5 * side_mm; }
};

}  // namespace relievo
