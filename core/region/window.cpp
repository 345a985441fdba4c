// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/window.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/error.h"

namespace relievo {
namespace {

/// Bilinear between the nodes of a level; beyond the outermost nodes their value continues.
float levelHeight(const PyramidLevel& level, double x_mm, double y_mm) {
  const GridFrame& frame = level.frame;
  const auto split = [&](double position, double first, int count, int& low, int& high) {
    const double index = std::clamp((position - first) / frame.spacing_mm, 0.0, count - 1.0);
    low = std::min(static_cast<int>(index), std::max(count - 2, 0));
    high = std::min(low + 1, count - 1);
    return index - low;
  };
  int c0 = 0;
  int c1 = 0;
  int r0 = 0;
  int r1 = 0;
  const double u = split(x_mm, frame.first_x_mm, frame.size.cols, c0, c1);
  const double v = split(y_mm, frame.first_y_mm, frame.size.rows, r0, r1);
  const auto at = [&](int col, int row) {
    return static_cast<double>(level.heights_mm[frame.size.index({.col = col, .row = row})]);
  };
  return static_cast<float>((1 - v) * ((1 - u) * at(c0, r0) + u * at(c1, r0)) +
                            v * ((1 - u) * at(c0, r1) + u * at(c1, r1)));
}

Origin originAt(const DepthMap& map, double x_mm, double y_mm) {
  const double u = (x_mm - map.leftMm()) / map.frame.spacing_mm;
  const double v = (y_mm - map.bottomMm()) / map.frame.spacing_mm;
  if (u < 0 || v < 0 || u > map.frame.size.cols || v > map.frame.size.rows) return Origin::outside;
  return map.origin({.col = std::min(static_cast<int>(u), map.frame.size.cols - 1),
                     .row = std::min(static_cast<int>(v), map.frame.size.rows - 1)});
}

bool onMap(const DepthMap& map, double x_mm, double y_mm) {
  return x_mm >= map.leftMm() && x_mm <= map.leftMm() + map.widthMm() && y_mm >= map.bottomMm() &&
         y_mm <= map.bottomMm() + map.heightExtentMm();
}

/// Identifies a window by what is in it (splitmix64 steps), so that no counter is shared.
std::uint64_t contentId(const RegionWindow& window) {
  auto hash = std::bit_cast<std::uint64_t>(window.region.x_mm);
  const auto mix = [&hash](std::uint64_t value) {
    hash += 0x9e3779b97f4a7c15ULL + value;
    hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    hash ^= hash >> 27U;
  };
  mix(std::bit_cast<std::uint64_t>(window.region.y_mm));
  mix(std::bit_cast<std::uint64_t>(window.region.side_mm));
  mix(static_cast<std::uint64_t>(window.region.level.value));
  for (const float height : window.heights_mm) mix(std::bit_cast<std::uint32_t>(height));
  hash >>= 16U;                 // 48 bits: exact in spreadsheets and JSON, which count in doubles.
  return hash == 0 ? 1 : hash;  // 0 means no window.
}

}  // namespace

RegionWindow sampleWindow(const DepthMap& map, const Pyramid& pyramid, const Region& region,
                          double gain) {
  if (!(region.side_mm > 0) || !std::isfinite(region.side_mm) || !std::isfinite(region.x_mm) ||
      !std::isfinite(region.y_mm)) {
    throw ArgumentError("A region needs a finite position and a side above 0 mm.");
  }
  if (!(gain > 0) || !std::isfinite(gain)) {
    throw ArgumentError("The height gain must be a finite number above 0; 1 is true to scale.");
  }
  if (region.level.value < 0 || region.level.value >= static_cast<int>(pyramid.levels.size())) {
    throw ArgumentError("The region names a level that the pyramid does not have.");
  }
  const PyramidLevel& level = pyramid.levels[static_cast<std::size_t>(region.level.value)];
  RegionWindow window;
  window.region = region;
  window.gain = gain;
  window.heights_mm.resize(kWindowCount);
  window.origins.resize(kWindowCount);
  const double step = region.side_mm / kWindowSamples;
  std::size_t i = 0;
  for (int row = 0; row < kWindowSamples; ++row) {
    const double y = region.y_mm + (row + 0.5) * step;
    for (int col = 0; col < kWindowSamples; ++col, ++i) {
      const double x = region.x_mm + (col + 0.5) * step;
      window.origins[i] = originAt(map, x, y);
      if (onMap(map, x, y)) {
        window.heights_mm[i] =
            static_cast<float>(gain * static_cast<double>(levelHeight(level, x, y)));
      }
    }
  }
  const auto [low, high] = std::minmax_element(window.heights_mm.begin(), window.heights_mm.end());
  window.min_mm = *low;
  window.max_mm = *high;
  window.levels = static_cast<int>(pyramid.levels.size());
  window.id = contentId(window);
  return window;
}

DepthMap windowMap(const RegionWindow& window, int ring) {
  const double step = window.spacingMm();
  const int across = kWindowSamples + 2 * ring;
  DepthMap map;
  map.frame = {.size = {.cols = across, .rows = across},
               .spacing_mm = step,
               .first_x_mm = window.region.x_mm + (0.5 - ring) * step,
               .first_y_mm = window.region.y_mm + (0.5 - ring) * step};
  const auto inside = [ring](int i) {
    return static_cast<std::size_t>(std::clamp(i - ring, 0, kWindowSamples - 1));
  };
  for (int row = 0; row < across; ++row) {
    for (int col = 0; col < across; ++col) {
      const std::size_t i = inside(row) * kWindowSamples + inside(col);
      map.heights_mm.push_back(window.heights_mm[i]);
      map.origins.push_back(window.origins[i]);
    }
  }
  return map;
}

HandMapping handMapping(const RegionWindow& window) {
  HandMapping mapping;
  const double range = static_cast<double>(window.max_mm) - static_cast<double>(window.min_mm);
  double scale = kHandWidthMm / window.region.side_mm;
  if (range > 0) scale = std::min(scale, kHandHeightMm / range);
  const double middle =
      0.5 * (static_cast<double>(window.min_mm) + static_cast<double>(window.max_mm));
  mapping.device_per_view = scale;
  mapping.device_from_view.m = {scale, 0,     0,     -scale * window.region.centreX(),
                                0,     scale, 0,     -scale * window.region.centreY(),
                                0,     0,     scale, -scale * middle,
                                0,     0,     0,     1};
  return mapping;
}

}  // namespace relievo
