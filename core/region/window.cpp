// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/window.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <tuple>
#include <utility>

#include "core/base/error.h"

// Wider vectors where the processor has them; compiled without contraction to fused multiply-add,
// so that all builds give the same bits. The resolver of such functions runs before a sanitizer is
// ready.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RELIEVO_WIDE_VECTORS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define RELIEVO_WIDE_VECTORS
#endif

namespace relievo {
namespace {

/// Where the window's samples along one axis lie on a level's nodes and on the map's cells.
struct AxisPlaces {
  std::array<int, kWindowSamples> low{}, high{};  ///< Nodes on both sides.
  std::array<double, kWindowSamples> part{};      ///< Of the way from low to high.
  std::array<int, kWindowSamples> cell{};         ///< Nearest map cell; -1 beyond the map.
  int first = kWindowSamples, end = 0;            ///< Samples on the map.
};

constexpr double kOnNode = 1e-9;  // Spacings.

struct Axis {
  double first_mm = 0, spacing_mm = 0;
  int count = 0;
};

AxisPlaces placesAlong(const Axis& level, const Axis& map, double start_mm, double step_mm) {
  AxisPlaces places;
  const double map_low = map.first_mm - 0.5 * map.spacing_mm;
  const double map_width = map.count * map.spacing_mm;
  for (int i = 0; i < kWindowSamples; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double position = start_mm + (i + 0.5) * step_mm;
    // Beyond the outermost nodes their value continues.
    const double between =
        std::clamp((position - level.first_mm) / level.spacing_mm, 0.0, level.count - 1.0);
    // What is a node but for rounding is that node.
    const double nearest = std::round(between);
    const double node = std::abs(between - nearest) < kOnNode ? nearest : between;
    places.low[k] = std::min(static_cast<int>(node), std::max(level.count - 2, 0));
    places.high[k] = std::min(places.low[k] + 1, level.count - 1);
    places.part[k] = node - places.low[k];
    const double cell = (position - map_low) / map.spacing_mm;
    const bool on_map =
        position >= map_low && position <= map_low + map_width && cell >= 0 && cell <= map.count;
    places.cell[k] = on_map ? std::min(static_cast<int>(cell), map.count - 1) : -1;
    if (!on_map) continue;
    places.first = std::min(places.first, i);
    places.end = i + 1;
  }
  return places;
}

bool onNodes(const AxisPlaces& places) {
  for (int i = places.first; i < places.end; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (places.part[k] != 0 || places.low[k] != places.low[0] + i) return false;
  }
  return places.first == 0;
}

RELIEVO_WIDE_VECTORS
void mixRows(const float* __restrict low, const float* __restrict high, double part, int first,
             int end, double* __restrict out) {
  for (int k = first; k < end; ++k) {
    out[k] = (1 - part) * static_cast<double>(low[k]) + part * static_cast<double>(high[k]);
  }
}

RELIEVO_WIDE_VECTORS
void mixNeighbours(const double* __restrict mixed, const AxisPlaces& x, double gain,
                   float* __restrict out) {
  const int* low = x.low.data();
  const int* high = x.high.data();
  const double* part = x.part.data();
  for (int i = x.first; i < x.end; ++i) {
    const double between = (1 - part[i]) * mixed[low[i]] + part[i] * mixed[high[i]];
    out[i] = static_cast<float>(gain * static_cast<double>(static_cast<float>(between)));
  }
}

/// Two rows of nodes mixed into one, in one sweep, then neighbours in that.
class RowSampler {
 public:
  RowSampler(const PyramidLevel& level, const AxisPlaces& x)
      : level_(level), x_(x), aligned_(onNodes(x)) {
    if (x.first >= x.end) return;
    first_node_ = x.low[static_cast<std::size_t>(x.first)];
    mixed_.resize(static_cast<std::size_t>(x.high[static_cast<std::size_t>(x.end - 1)]) + 1);
  }

  void sample(int low_row, int high_row, double part, double gain, float* out) {
    const GridSize size = level_.frame.size;
    const float* low = &level_.heights_mm[size.index({.col = 0, .row = low_row})];
    const float* high = &level_.heights_mm[size.index({.col = 0, .row = high_row})];
    if (aligned_ && part == 0 && gain == 1) {
      std::copy_n(low + x_.low[0], x_.end, out);
      return;
    }
    mixRows(low, high, part, first_node_, static_cast<int>(mixed_.size()), mixed_.data());
    mixNeighbours(mixed_.data(), x_, gain, out);
  }

 private:
  const PyramidLevel& level_;
  const AxisPlaces& x_;
  bool aligned_;
  int first_node_ = 0;
  std::vector<double> mixed_;  ///< From node 0 on; filled from first_node_ on.
};

/// In 16 chains side by side: in one, each comparison would wait for the one before.
std::pair<float, float> lowestAndHighest(const std::vector<float>& heights) {
  constexpr std::size_t kChains = 16;
  static_assert(kWindowCount % kChains == 0);
  std::array<float, kChains> low{};
  std::copy_n(heights.begin(), kChains, low.begin());
  std::array<float, kChains> high = low;
  for (std::size_t i = kChains; i < heights.size(); i += kChains) {
    for (std::size_t k = 0; k < kChains; ++k) {
      const float height = heights[i + k];
      low[k] = height < low[k] ? height : low[k];
      high[k] = height > high[k] ? height : high[k];
    }
  }
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

/// Identifies a window by what is in it, so that no counter is shared. Two heights a step, in four
/// chains side by side: one alone would take longer than all the rest.
std::uint64_t contentId(const RegionWindow& window) {
  constexpr std::size_t kStep = 8;
  static_assert(kWindowCount % kStep == 0);
  const auto mix = [](std::uint64_t& hash, std::uint64_t value) {
    hash = (hash ^ value) * 0xbf58476d1ce4e5b9ULL;
    hash ^= hash >> 29U;
  };
  std::array<std::uint64_t, 4> chains{1, 2, 3, 4};
  for (std::size_t i = 0; i < kWindowCount; i += kStep) {
    std::array<std::uint64_t, 4> words{};
    std::memcpy(words.data(), &window.heights_mm[i], sizeof(words));
    mix(chains[0], words[0]);
    mix(chains[1], words[1]);
    mix(chains[2], words[2]);
    mix(chains[3], words[3]);
  }
  auto hash = std::bit_cast<std::uint64_t>(window.region.x_mm);
  mix(hash, std::bit_cast<std::uint64_t>(window.region.y_mm));
  mix(hash, std::bit_cast<std::uint64_t>(window.region.side_mm));
  mix(hash, static_cast<std::uint64_t>(window.region.level.value));
  for (const std::uint64_t chain : chains) mix(hash, chain);
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
  const GridFrame& fine = map.frame;
  const GridFrame& nodes = level.frame;
  const AxisPlaces x =
      placesAlong({nodes.first_x_mm, nodes.spacing_mm, nodes.size.cols},
                  {fine.first_x_mm, fine.spacing_mm, fine.size.cols}, region.x_mm, step);
  const AxisPlaces y =
      placesAlong({nodes.first_y_mm, nodes.spacing_mm, nodes.size.rows},
                  {fine.first_y_mm, fine.spacing_mm, fine.size.rows}, region.y_mm, step);
  RowSampler sampler(level, x);
  std::fill(window.origins.begin(), window.origins.end(), Origin::outside);
  for (int row = y.first; row < y.end; ++row) {
    const auto k = static_cast<std::size_t>(row);
    sampler.sample(y.low[k], y.high[k], y.part[k], gain, &window.heights_mm[k * kWindowSamples]);
    const Origin* from = &map.origins[fine.size.index({.col = 0, .row = y.cell[k]})];
    Origin* to = &window.origins[k * kWindowSamples];
    for (int col = x.first; col < x.end; ++col)
      to[col] = from[x.cell[static_cast<std::size_t>(col)]];
  }
  std::tie(window.min_mm, window.max_mm) = lowestAndHighest(window.heights_mm);
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
