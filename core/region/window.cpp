// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/window.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/base/failure.h"
#include "core/base/wide_vectors.h"

namespace relievo {
namespace {

constexpr double kOnNode = 1e-9;  // Spacings.

/// Where the window's samples lie along one axis.
struct Axis {
  std::array<int, kWindowSamples> low{};       ///< Node before; the one after is `to_high` on.
  std::array<int, kWindowSamples> cell{};      ///< Of the origin; -1 off the map.
  std::array<double, kWindowSamples> part{};   ///< Way from the one to the other, [0, 1].
  int to_high = 1;                             ///< 0 where the level has one node only.
  int first_on_map = 0, end_on_map = 0;        ///< Samples that have heights, ...
  int first_with_cell = 0, end_with_cell = 0;  ///< ... and an origin.
  int first_node = 0, nodes = 0;               ///< All that low and its next name.
  int first_cell = 0, cells = 0;
  bool nodes_in_turn = true;  ///< Each sample has the next node.
  bool cells_in_turn = true;
};

/// One axis of a grid.
struct Line {
  int count = 0;
  double first_mm = 0, spacing_mm = 0;
};
Line lineX(const GridFrame& f) {
  return {.count = f.size.cols, .first_mm = f.first_x_mm, .spacing_mm = f.spacing_mm};
}
Line lineY(const GridFrame& f) {
  return {.count = f.size.rows, .first_mm = f.first_y_mm, .spacing_mm = f.spacing_mm};
}

/// Beyond the outermost nodes their value continues; beyond the map there is nothing.
Axis axisOf(double start_mm, double step_mm, const Line& map, const Line& nodes,
            const Line& cells) {
  Axis axis;
  const double map_start = map.first_mm - 0.5 * map.spacing_mm;
  const double map_end = map_start + map.count * map.spacing_mm;
  const double cells_start = cells.first_mm - 0.5 * cells.spacing_mm;
  axis.to_high = nodes.count > 1 ? 1 : 0;
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const int sample = static_cast<int>(i);
    const double at = start_mm + (sample + 0.5) * step_mm;
    const double between =
        std::clamp((at - nodes.first_mm) / nodes.spacing_mm, 0.0, nodes.count - 1.0);
    // What is a node but for rounding is that node.
    const double nearest = std::round(between);
    const double index = std::abs(between - nearest) < kOnNode ? nearest : between;
    const int low = std::min(static_cast<int>(index), std::max(nodes.count - 2, 0));
    axis.low[i] = low;
    axis.part[i] = index - low;
    axis.nodes_in_turn = axis.nodes_in_turn && low == axis.low[0] + sample;
    const bool on_map = at >= map_start && at <= map_end;
    const double u = (at - cells_start) / cells.spacing_mm;
    const bool has_origin = on_map && u >= 0;
    axis.cell[i] = has_origin ? std::min(static_cast<int>(u), cells.count - 1) : -1;
    // The samples rise, so both kinds lie in one run.
    if (on_map) {
      if (axis.end_on_map == 0) axis.first_on_map = sample;
      axis.end_on_map = sample + 1;
    }
    if (has_origin) {
      if (axis.end_with_cell == 0) axis.first_with_cell = sample;
      axis.end_with_cell = sample + 1;
    }
  }
  axis.first_node = axis.low.front();
  axis.nodes = axis.low.back() + axis.to_high - axis.first_node + 1;
  if (axis.end_with_cell > 0) {
    const auto first = static_cast<std::size_t>(axis.first_with_cell);
    const auto last = static_cast<std::size_t>(axis.end_with_cell - 1);
    axis.first_cell = axis.cell[first];
    axis.cells = axis.cell[last] - axis.first_cell + 1;
    axis.cells_in_turn = axis.cells == axis.end_with_cell - axis.first_with_cell;
    for (std::size_t i = first; i < last; ++i) {
      axis.cells_in_turn = axis.cells_in_turn && axis.cell[i + 1] == axis.cell[i] + 1;
    }
  }
  return axis;
}

/// Sixteen numbers side by side, in an array anywhere.
using Floats [[gnu::vector_size(64)]] = float;
using FloatsInArray [[gnu::vector_size(64), gnu::aligned(4), gnu::may_alias]] = float;
using Places [[gnu::vector_size(64)]] = int;
using PlacesInArray [[gnu::vector_size(64), gnu::aligned(4), gnu::may_alias]] = int;
using Doubles [[gnu::vector_size(64)]] = double;
using DoublesInArray [[gnu::vector_size(64), gnu::aligned(8), gnu::may_alias]] = double;
[[maybe_unused]] constexpr int kAtOnce = 16;

/// As below, where the samples do not have the nodes in turn. Sixteen samples that lie among 32
/// nodes are picked from these at once, which takes half the time of reading each by itself.
RELIEVO_WIDE_VECTORS
void mixPicked(const float* heights, const Axis& columns, double* out) {
  const double* part = columns.part.data();
  const int* low = columns.low.data();
  int i = 0;
#if defined(__GNUC__) && !defined(__clang__)  // Which knows no shuffle by a variable.
  for (; columns.to_high == 1 && i + kAtOnce <= kWindowSamples; i += kAtOnce) {
    const int from = low[i] - columns.first_node;
    if (low[i + kAtOnce - 1] + 1 - low[i] >= 2 * kAtOnce || from + 2 * kAtOnce > columns.nodes) {
      break;
    }
    const Floats first = *reinterpret_cast<const FloatsInArray*>(heights + from);
    const Floats second = *reinterpret_cast<const FloatsInArray*>(heights + from + kAtOnce);
    const Places places = *reinterpret_cast<const PlacesInArray*>(low + i) - low[i];
    const Floats before = __builtin_shuffle(first, second, places);
    const Floats after = __builtin_shuffle(first, second, places + 1);
    const Doubles before_low = __builtin_convertvector(
        __builtin_shufflevector(before, before, 0, 1, 2, 3, 4, 5, 6, 7), Doubles);
    const Doubles before_high = __builtin_convertvector(
        __builtin_shufflevector(before, before, 8, 9, 10, 11, 12, 13, 14, 15), Doubles);
    const Doubles after_low = __builtin_convertvector(
        __builtin_shufflevector(after, after, 0, 1, 2, 3, 4, 5, 6, 7), Doubles);
    const Doubles after_high = __builtin_convertvector(
        __builtin_shufflevector(after, after, 8, 9, 10, 11, 12, 13, 14, 15), Doubles);
    const Doubles p_low = *reinterpret_cast<const DoublesInArray*>(part + i);
    const Doubles p_high = *reinterpret_cast<const DoublesInArray*>(part + i + kAtOnce / 2);
    *reinterpret_cast<DoublesInArray*>(out + i) = (1 - p_low) * before_low + p_low * after_low;
    *reinterpret_cast<DoublesInArray*>(out + i + kAtOnce / 2) =
        (1 - p_high) * before_high + p_high * after_high;
  }
#endif
  for (; i < kWindowSamples; ++i) {
    const float* node = heights + (low[i] - columns.first_node);
    out[i] = (1 - part[i]) * static_cast<double>(node[0]) +
             part[i] * static_cast<double>(node[columns.to_high]);
  }
}

/// Bilinear along one row, at the window's columns. @param heights  from the axis' first node on
RELIEVO_WIDE_VECTORS
void mixAlongRow(const float* heights, const Axis& columns, double* out) {
  const double* part = columns.part.data();
  const float* next = heights + columns.to_high;
  if (columns.nodes_in_turn) {
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      out[i] =
          (1 - part[i]) * static_cast<double>(heights[i]) + part[i] * static_cast<double>(next[i]);
    }
    return;
  }
  mixPicked(heights, columns, out);
}

/// ... and between two of those rows.
RELIEVO_WIDE_VECTORS
void mixRows(const double* low, const double* high, double v, double gain, float* out) {
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const auto height = static_cast<float>((1 - v) * low[i] + v * high[i]);
    out[i] = static_cast<float>(gain * static_cast<double>(height));
  }
}

/// A row of the level at the window's columns, kept while window rows lie beside it.
class RowAtColumns {
 public:
  const double* at(int row, const WindowRows& rows, const Axis& columns) {
    if (row == row_) return values_.data();
    mixAlongRow(rows.heights(row, columns.first_node, columns.nodes), columns, values_.data());
    row_ = row;
    return values_.data();
  }
  int row() const noexcept { return row_; }

 private:
  int row_ = -1;
  std::array<double, kWindowSamples> values_{};
};

/// Bilinear between the nodes.
void sampleHeights(const WindowRows& rows, const Axis& columns, const Axis& lines,
                   RegionWindow& window) {
  std::array<RowAtColumns, 2> kept;
  RowAtColumns* below = kept.data();
  RowAtColumns* above = &kept[1];
  for (int line = lines.first_on_map; line < lines.end_on_map; ++line) {
    const auto j = static_cast<std::size_t>(line);
    if (lines.low[j] == above->row()) std::swap(below, above);
    const double* low = below->at(lines.low[j], rows, columns);
    const double* high = above->at(lines.low[j] + lines.to_high, rows, columns);
    float* out = &window.heights_mm[j * kWindowSamples];
    mixRows(low, high, lines.part[j], window.gain, out);
    std::fill_n(out, columns.first_on_map, 0.0F);
    std::fill(out + columns.end_on_map, out + kWindowSamples, 0.0F);
  }
}

void sampleOrigins(const WindowRows& rows, const Axis& columns, const Axis& lines,
                   RegionWindow& window) {
  if (columns.cells == 0) return;
  for (int line = lines.first_with_cell; line < lines.end_with_cell; ++line) {
    const auto j = static_cast<std::size_t>(line);
    CellStatus* out = &window.origins[j * kWindowSamples];
    if (line > lines.first_with_cell && lines.cell[j] == lines.cell[j - 1]) {
      std::copy_n(out - kWindowSamples, kWindowSamples, out);
      continue;
    }
    const CellStatus* origins = rows.origins(lines.cell[j], columns.first_cell, columns.cells);
    if (columns.cells_in_turn) {
      std::copy_n(origins, columns.cells, out + columns.first_with_cell);
      continue;
    }
    const int* const cell = columns.cell.data();
    for (int i = columns.first_with_cell; i < columns.end_with_cell; ++i) {
      out[i] = origins[cell[i] - columns.first_cell];
    }
  }
}

/// Identifies a window by what is in it (splitmix64 steps), so that no counter is shared. Four
/// chains at once: one would take longer than all the rest.
std::uint64_t contentId(const RegionWindow& window) {
  const auto mix = [](std::uint64_t& hash, std::uint64_t value) {
    hash += 0x9e3779b97f4a7c15ULL + value;
    hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    hash ^= hash >> 27U;
  };
  std::array<std::uint64_t, 4> chains{std::bit_cast<std::uint64_t>(window.region.x_mm),
                                      std::bit_cast<std::uint64_t>(window.region.y_mm),
                                      std::bit_cast<std::uint64_t>(window.region.side_mm),
                                      static_cast<std::uint64_t>(window.region.level.value)};
  static_assert(kWindowCount % 8 == 0);
  for (std::size_t i = 0; i < kWindowCount; i += 8) {
    std::array<std::uint64_t, 4> values{};
    std::memcpy(values.data(), &window.heights_mm[i], sizeof(values));
    for (std::size_t k = 0; k < 4; ++k) mix(chains[k], values[k]);
  }
  std::uint64_t hash = chains[0];
  for (std::size_t k = 1; k < 4; ++k) mix(hash, chains[k]);
  hash >>= 16U;                 // 48 bits: exact in spreadsheets and JSON, which count in doubles.
  return hash == 0 ? 1 : hash;  // 0 means no window.
}

RELIEVO_WIDE_VECTORS
void findRange(RegionWindow& window) {
  constexpr std::size_t kLanes = 32;
  static_assert(kWindowCount % kLanes == 0);
  std::array<float, kLanes> low{};
  std::array<float, kLanes> high{};
  std::copy_n(window.heights_mm.begin(), kLanes, low.begin());
  high = low;
  for (std::size_t i = kLanes; i < kWindowCount; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const float height = window.heights_mm[i + k];
      low[k] = height < low[k] ? height : low[k];
      high[k] = height > high[k] ? height : high[k];
    }
  }
  window.min_mm = *std::min_element(low.begin(), low.end());
  window.max_mm = *std::max_element(high.begin(), high.end());
}

}  // namespace

RegionWindow sampleWindow(const DepthMap& map, const Pyramid& pyramid, const Region& region,
                          double gain) {
  if (region.level.value < 0 || region.level.value >= static_cast<int>(pyramid.levels.size())) {
    throw failure<MessageId::pyramid_has_no_level>();
  }
  const PyramidLevel& level = pyramid.levels[static_cast<std::size_t>(region.level.value)];
  const auto heights = [&level](int row, int col, int) {
    return &level.heights_mm[level.frame.size.index({.col = col, .row = row})];
  };
  const auto origins = [&map](int row, int col, int) {
    return &map.origins[map.frame.size.index({.col = col, .row = row})];
  };
  return sampleWindow({.map = map.frame,
                       .nodes = level.frame,
                       .cells = map.frame,
                       .levels = static_cast<int>(pyramid.levels.size()),
                       .heights = heights,
                       .origins = origins},
                      region, gain);
}

RegionWindow sampleWindow(const WindowRows& rows, const Region& region, double gain) {
  if (!(region.side_mm > 0) || !std::isfinite(region.side_mm) || !std::isfinite(region.x_mm) ||
      !std::isfinite(region.y_mm)) {
    throw failure<MessageId::region_not_finite>();
  }
  if (!(gain > 0) || !std::isfinite(gain)) {
    throw failure<MessageId::gain_not_positive>();
  }
  RegionWindow window;
  window.region = region;
  window.gain = gain;
  window.heights_mm.resize(kWindowCount);
  window.origins.resize(kWindowCount, CellStatus::outside);
  const double step = region.side_mm / kWindowSamples;
  const Axis columns =
      axisOf(region.x_mm, step, lineX(rows.map), lineX(rows.nodes), lineX(rows.cells));
  const Axis lines =
      axisOf(region.y_mm, step, lineY(rows.map), lineY(rows.nodes), lineY(rows.cells));
  sampleHeights(rows, columns, lines, window);
  sampleOrigins(rows, columns, lines, window);
  findRange(window);
  window.levels = rows.levels;
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
