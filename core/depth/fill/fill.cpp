// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/fill.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/bands.h"
#include "core/base/failure.h"
#include "core/base/large_pages.h"
#include "core/depth/fill/band_fill.h"

namespace relievo {
namespace {

constexpr std::size_t kWorkOfCell = 8;  // A cell here is as much work as so many of others.

/// Rows of a band where everything is in memory: a band for each thread, and more where those would
/// leave the caches.
int rowsInMemory(GridSize size, int threads) {
  constexpr int kMultiple = 8, kFewest = 128, kMost = 512;
  constexpr int kCells = 1 << 21;
  const int most = std::clamp(kCells / std::max(size.cols, 1), kFewest, kMost);
  const int rows = std::clamp((size.rows + threads - 1) / threads, 1, most);
  return (rows + kMultiple - 1) / kMultiple * kMultiple;
}

NumberArgument squareMm(double area_mm2) {
  return {.value = area_mm2, .digits = 4, .form = NumberArgument::Form::significant};
}

}  // namespace

Mask withBetween(Mask measured, std::span<const float> between) {
  for (std::size_t i = 0; i < between.size(); ++i) {
    measured[i] |= static_cast<std::uint8_t>(between[i] == between[i] ? 1 : 0);
  }
  return measured;
}

void markSteepCells(const float* depths, GridSize size, double spacing_mm, Mask& steep) {
  const auto limit = static_cast<float>(kSteepRise * spacing_mm);
  const auto cols = static_cast<std::size_t>(size.cols);
  const auto rows = static_cast<std::size_t>(size.rows);
  // From the cell `step` before to the one `step` after, for cells first ... end - 1.
  const auto mark = [&](std::size_t first, std::size_t end, std::size_t step) {
    const float* before = depths + first - step;
    const float* here = depths + first;
    const float* after = here + step;
    std::uint8_t* to = steep.data() + first;
    for (std::size_t i = 0; i < end - first; ++i) {
      const float in = here[i] - before[i];
      const float out = after[i] - here[i];
      const int up = static_cast<int>(in > limit) & static_cast<int>(out > limit);  // Not for NaN.
      const int down = static_cast<int>(in < -limit) & static_cast<int>(out < -limit);
      to[i] = static_cast<std::uint8_t>(to[i] | up | down);
    }
  };
  for (std::size_t row = 0; row < rows; ++row) {
    if (cols > 2) mark(row * cols + 1, (row + 1) * cols - 1, 1);
    if (row > 0 && row + 1 < rows) mark(row * cols, (row + 1) * cols, cols);
  }
}

bool isToBeFilled(const Hole& hole, const HoleChoice& choice) {
  const bool fills = choice.rule == HoleRule::interpolate || choice.rule == HoleRule::membrane;
  return fills && hole.area_mm2 <= choice.max_area_mm2;
}

CellStatus originOfHole(const Hole& hole, HoleRule rule) {
  if (hole.filled) return CellStatus::interpolated;
  return rule == HoleRule::none ? CellStatus::outside : CellStatus::base_plane;
}

std::optional<Message> holesLeft(const std::vector<Hole>& holes, const HoleChoice& choice) {
  if (choice.rule != HoleRule::interpolate && choice.rule != HoleRule::membrane) {
    return std::nullopt;
  }
  const auto filled =
      std::count_if(holes.begin(), holes.end(), [](const Hole& h) { return h.filled; });
  const auto left =
      std::find_if(holes.begin(), holes.end(), [](const Hole& h) { return !h.filled; });
  if (left == holes.end()) return std::nullopt;
  if (left->area_mm2 > choice.max_area_mm2) {
    return said<MessageId::holes_left_by_limit>(filled, holes.size(), squareMm(left->area_mm2),
                                                squareMm(choice.max_area_mm2));
  }
  return said<MessageId::holes_left_by_membrane>(filled, holes.size(), squareMm(left->area_mm2));
}

FilledMap fillDepths(CapturedDepths&& depths, const GridFrame& frame, const FillSource& source,
                     const HoleChoice& choice, const Task& task) {
  const GridSize size = frame.size;
  const int threads = threadsFor(kWorkOfCell * size.count(), 0);
  std::optional<BitRows> steep;
  if (!depths.steep.empty()) {
    steep.emplace(size).setRows(0, depths.steep);
    depths.steep = {};
  }
  FilledMap result;
  result.quality = std::move(depths.quality);
  RowsOf points;
  if (!result.quality.counts.empty()) {
    points = [&](int first, int rows, float* out) {
      const auto* const counts =
          result.quality.counts.data() + size.index({.col = 0, .row = first});
      std::copy_n(counts, static_cast<std::size_t>(rows) * static_cast<std::size_t>(size.cols),
                  out);
    };
  }
  const BandFill fill({.front = GridRows::inMemory(depths.front, size),
                       .between = GridRows::inMemory(depths.between, size),
                       .steep = steep ? &*steep : nullptr,
                       .one_layer = depths.one_layer,
                       .points = points},
                      frame, source, choice,
                      {.memory_bytes = std::numeric_limits<std::size_t>::max(),
                       .threads = threads,
                       .rows = rowsInMemory(size, threads)},
                      task);
  result.base_z_mm = fill.baseZMm();
  result.holes = fill.holes();
  result.seen_through = fill.seenThrough();
  result.seen_through_points = fill.seenThroughPoints();
  DepthMap& map = result.map;
  map.frame = frame;
  reserveLarge(map.heights_mm, size.count());
  map.heights_mm.resize(size.count());
  reserveLarge(map.origins, size.count());
  map.origins.resize(size.count());
  fill.fillInto(map.heights_mm.data(), map.origins.data(), task);
  return result;
}

}  // namespace relievo
