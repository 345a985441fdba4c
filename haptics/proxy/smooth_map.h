// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "haptics/rt/realtime.h"

namespace relievo {

/// Value of a map of numbers at a place, and how it grows from sample to sample.
struct MapValue {
  double value = 0, along_x = 0, along_y = 0;
};

/// A square map of `samples` per side, read as a quadratic B-spline: smooth in value and slope, and
/// never beyond the numbers around. (x, y) in samples; beyond its border a map goes on as it ends.
/// @param at  gives number (col, row)
template <class At>
MapValue smoothMap(int samples, double x, double y, const At& at) RELIEVO_REALTIME {
  const double last = samples - 1;
  const double u = std::clamp(x, 0.0, last), v = std::clamp(y, 0.0, last);
  const auto weights = [](double t) RELIEVO_REALTIME {
    return std::array<double, 3>{0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t,
                                 0.5 * (0.5 + t) * (0.5 + t)};
  };
  const auto slopes = [](double t) RELIEVO_REALTIME {
    return std::array<double, 3>{t - 0.5, -2 * t, t + 0.5};
  };
  const int col = static_cast<int>(std::floor(u + 0.5)),
            row = static_cast<int>(std::floor(v + 0.5));
  const double s = u - col, t = v - row;
  const std::array<double, 3> wx = weights(s), wy = weights(t), dx = slopes(s), dy = slopes(t);
  MapValue sum;
  for (int j = 0; j < 3; ++j) {
    const int in_row = std::clamp(row + j - 1, 0, samples - 1);
    double line = 0, line_slope = 0;
    for (int i = 0; i < 3; ++i) {
      const double number = at(std::clamp(col + i - 1, 0, samples - 1), in_row);
      line += wx[static_cast<std::size_t>(i)] * number;
      line_slope += dx[static_cast<std::size_t>(i)] * number;
    }
    sum.value += wy[static_cast<std::size_t>(j)] * line;
    sum.along_x += wy[static_cast<std::size_t>(j)] * line_slope;
    sum.along_y += dy[static_cast<std::size_t>(j)] * line;
  }
  if (u != x) sum.along_x = 0;
  if (v != y) sum.along_y = 0;
  return sum;
}

}  // namespace relievo
