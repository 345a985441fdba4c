// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "ui/vtk/offscreen.h"

namespace relievo {

using Rgb = std::array<int, 3>;
inline constexpr Rgb kPinkRgb{0xff, 0x4f, 0xa3};

/// Pixel of a picture, row 0 at the top.
inline Rgb at(const RgbImage& image, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

inline double grey(const Rgb& c) {
  return (c[0] + c[1] + c[2]) / 3.0;
}

inline double meanGrey(const RgbImage& image, int x0, int y0, int x1, int y1) {
  double sum = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) sum += grey(at(image, x, y));
  }
  return sum / ((x1 - x0) * (y1 - y0));
}

inline bool isBlack(const RgbImage& image) {
  return std::all_of(image.rgb.begin(), image.rgb.end(), [](std::uint8_t v) { return v == 0; });
}

struct Box {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< Pixels, x1 and y1 excluded.
};

/// Displacement (pixels, right and down) of channel `b` against channel `a` inside a box: the
/// shift with the best normalised correlation, refined by a parabola through its neighbours.
struct ChannelShift {
  double x = 0, y = 0;
};
inline ChannelShift channelShift(const RgbImage& image, int a, int b, const Box& box, int reach) {
  const auto correlation = [&](int dx, int dy) {
    double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0, n = 0;
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        const double va = at(image, x, y)[static_cast<std::size_t>(a)];
        const double vb = at(image, x + dx, y + dy)[static_cast<std::size_t>(b)];
        sa += va, sb += vb, saa += va * va, sbb += vb * vb, sab += va * vb, n += 1;
      }
    }
    return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
  };
  int best_x = 0, best_y = 0;
  double best = -2;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double c = correlation(dx, dy);
      if (c > best) best = c, best_x = dx, best_y = dy;
    }
  }
  const auto refine = [&](double before, double after) {
    return 0.5 * (before - after) / (before - 2 * best + after);
  };
  return {best_x + refine(correlation(best_x - 1, best_y), correlation(best_x + 1, best_y)),
          best_y + refine(correlation(best_x, best_y - 1), correlation(best_x, best_y + 1))};
}

}  // namespace relievo
