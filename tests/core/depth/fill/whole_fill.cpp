// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/depth/fill/whole_fill.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <utility>

#include "core/base/bands.h"
#include "core/base/failure.h"
#include "core/base/large_pages.h"
#include "core/depth/fill/mask.h"
#include "core/depth/fill/membrane.h"
#include "core/depth/fill/push_pull.h"
#include "core/depth/layers/hidden_points.h"

namespace relievo::test {
namespace {

constexpr std::size_t kWorkOfCell = 8;  // A cell here is as much work as so many of others.

/// Calls work(first, end) for parts of so many cells, side by side.
template <class Work>
void forCells(std::size_t count, const Work& work) {
  const auto parts = static_cast<std::size_t>(threadsFor(2 * count, 0));
  parallelFor(static_cast<int>(parts), static_cast<int>(parts), [&](int number, int) {
    const auto part = static_cast<std::size_t>(number);
    work(count * part / parts, count * (part + 1) / parts);
  });
}

/// Keeps the lowest of many values.
class Lowest {
 public:
  explicit Lowest(std::size_t count) : count_(count) {}

  void add(const float* values, std::size_t count) {
    float bound = bound_;
    for (std::size_t i = 0; i < count; ++i) {
      if (!(values[i] <= bound)) continue;  // Nor NaN.
      kept_.push_back(values[i]);
      if (kept_.size() < 2 * count_ + 1024) continue;
      const auto end = kept_.begin() + static_cast<std::ptrdiff_t>(count_);
      std::nth_element(kept_.begin(), end - 1, kept_.end());
      bound = *(end - 1);
      kept_.erase(end, kept_.end());
    }
    bound_ = bound;
  }
  /// Some more than asked for, in no order.
  std::vector<float> take() { return std::move(kept_); }

 private:
  std::size_t count_;
  float bound_ = std::numeric_limits<float>::infinity();
  std::vector<float> kept_;
};

/// Quantile of the values that are not NaN, with linear interpolation between order statistics,
/// position q (n - 1).
double quantile(const std::vector<float>& values, std::size_t count, double q) {
  const double position = q * (static_cast<double>(count) - 1);
  const auto below = static_cast<std::ptrdiff_t>(position);
  const double part = position - static_cast<double>(below);
  std::vector<float> candidates;
  std::mutex joining;
  forCells(values.size(), [&](std::size_t first, std::size_t end) {
    Lowest lowest(static_cast<std::size_t>(below) + 2);
    lowest.add(values.data() + first, end - first);
    const std::vector<float> found = lowest.take();
    const std::lock_guard lock(joining);
    candidates.insert(candidates.end(), found.begin(), found.end());
  });
  std::nth_element(candidates.begin(), candidates.begin() + below, candidates.end());
  const auto low = static_cast<double>(candidates[static_cast<std::size_t>(below)]);
  if (part == 0) return low;
  const auto next = std::min_element(candidates.begin() + below + 1, candidates.end());
  return low + part * (static_cast<double>(*next) - low);
}

/// 4-connected components of the cells where `mask` is 0.
struct EmptyAreas {
  std::vector<int> label;          ///< Per cell: index into the lists below, -1 where mask is 1.
  std::vector<std::size_t> cells;  ///< Size of each component.
  std::vector<bool> at_border;     ///< Touches the border of the grid: outside the object.
};

EmptyAreas emptyAreas(const Mask& mask, GridSize size) {
  EmptyAreas areas;
  areas.label.assign(mask.size(), -1);
  std::vector<Cell> stack;
  for (int row = 0; row < size.rows; ++row) {
    const std::uint8_t* const cells = mask.data() + size.index({.col = 0, .row = row});
    for (int col = 0; col < size.cols; ++col) {
      // Nearly all are covered.
      const void* const empty =
          std::memchr(cells + col, 0, static_cast<std::size_t>(size.cols - col));
      if (empty == nullptr) break;
      col = static_cast<int>(static_cast<const std::uint8_t*>(empty) - cells);
      const std::size_t start = size.index({.col = col, .row = row});
      if (areas.label[start] >= 0) continue;
      const int label = static_cast<int>(areas.cells.size());
      areas.cells.push_back(0);
      areas.at_border.push_back(false);
      areas.label[start] = label;
      stack.push_back({.col = col, .row = row});
      while (!stack.empty()) {
        const Cell cell = stack.back();
        stack.pop_back();
        ++areas.cells.back();
        for (const Cell next : {Cell{cell.col - 1, cell.row}, Cell{cell.col + 1, cell.row},
                                Cell{cell.col, cell.row - 1}, Cell{cell.col, cell.row + 1}}) {
          if (!size.contains(next)) {
            areas.at_border.back() = true;
            continue;
          }
          const std::size_t index = size.index(next);
          if (mask[index] != 0 || areas.label[index] >= 0) continue;
          areas.label[index] = label;
          stack.push_back(next);
        }
      }
    }
  }
  return areas;
}

struct LabelledHole {
  int label = 0;
  Hole hole;
};

/// Enclosed areas with size and centre, largest first.
std::vector<LabelledHole> enclosedHoles(const EmptyAreas& areas, const GridFrame& frame) {
  std::vector<LabelledHole> holes;
  std::vector<std::size_t> hole_of_label(areas.cells.size(), 0);
  for (std::size_t label = 0; label < areas.cells.size(); ++label) {
    if (areas.at_border[label]) continue;
    hole_of_label[label] = holes.size();
    const auto cells = areas.cells[label];
    holes.push_back(
        {.label = static_cast<int>(label),
         .hole = {.cells = cells,
                  .area_mm2 = static_cast<double>(cells) * frame.spacing_mm * frame.spacing_mm}});
  }
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const int label = areas.label[frame.size.index({.col = col, .row = row})];
      if (label < 0 || areas.at_border[static_cast<std::size_t>(label)]) continue;
      Hole& hole = holes[hole_of_label[static_cast<std::size_t>(label)]].hole;
      hole.centre_x_mm += frame.xMm(col) / static_cast<double>(hole.cells);
      hole.centre_y_mm += frame.yMm(row) / static_cast<double>(hole.cells);
    }
  }
  std::stable_sort(holes.begin(), holes.end(), [](const LabelledHole& a, const LabelledHole& b) {
    return a.hole.cells > b.hole.cells;
  });
  return holes;
}

Mask maskOf(const FrontDepths& depths) {
  Mask measured(depths.size());
  forCells(depths.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) measured[i] = depths[i] == depths[i] ? 1 : 0;
  });
  return measured;
}

/// @throw ArgumentError  nothing is measured
double baseOf(const FrontDepths& depths, const Mask& measured, double base_quantile) {
  const auto count = std::count(measured.begin(), measured.end(), std::uint8_t{1});
  if (count == 0) {
    throw failure<MessageId::no_cell_hit>();
  }
  return quantile(depths, static_cast<std::size_t>(count), base_quantile);
}

/// Cells of every hole that gets a membrane, in the order of `holes`.
std::vector<std::vector<std::size_t>> cellsOf(const std::vector<LabelledHole>& holes,
                                              const EmptyAreas& areas) {
  std::vector<std::vector<std::size_t>> cells(holes.size());
  std::vector<int> hole_of_label(areas.cells.size(), -1);
  for (std::size_t k = 0; k < holes.size(); ++k) {
    if (holes[k].hole.filled) {
      hole_of_label[static_cast<std::size_t>(holes[k].label)] = static_cast<int>(k);
    }
  }
  for (std::size_t i = 0; i < areas.label.size(); ++i) {
    if (areas.label[i] < 0) continue;
    const int k = hole_of_label[static_cast<std::size_t>(areas.label[i])];
    if (k >= 0) cells[static_cast<std::size_t>(k)].push_back(i);
  }
  return cells;
}

/// Membranes over the holes that are to be filled; a hole that cannot be is no longer.
void layMembranes(std::vector<LabelledHole>& holes, const EmptyAreas& areas, const Mask& covered,
                  FrontDepths& depths, GridSize size) {
  const auto cells = cellsOf(holes, areas);
  for (std::size_t k = 0; k < holes.size(); ++k) {
    if (!holes[k].hole.filled) continue;
    Rim rim;
    for (const std::size_t cell : cells[k]) {
      const auto cols = static_cast<std::size_t>(size.cols);
      for (const Cell reach : kRimReach) {
        const Cell beside{.col = static_cast<int>(cell % cols) + reach.col,
                          .row = static_cast<int>(cell / cols) + reach.row};
        if (!size.contains(beside) || covered[size.index(beside)] == 0) continue;
        rim.emplace(size.index(beside), depths[size.index(beside)]);
      }
    }
    const std::vector<float> plate = membraneOver(cells[k], rim, size);
    holes[k].hole.filled = !plate.empty();
    for (std::size_t i = 0; i < plate.size(); ++i) depths[cells[k][i]] = plate[i];
  }
}

/// Measured cells that are steep, by the whole grid.
Mask steepCells(const CapturedDepths& depths, const Mask& measured, const GridFrame& frame) {
  Mask steep = depths.steep.empty() ? Mask(measured.size(), 0) : depths.steep;
  markSteepCells(depths.front.data(), frame.size, frame.spacing_mm, steep);
  for (std::size_t i = 0; i < steep.size(); ++i) steep[i] &= measured[i];
  return steep;
}

/// Share of occupied cells per tile; only tiles that hold something.
std::vector<double> tileOccupancy(const Mask& mask, GridSize size, int tile) {
  std::vector<double> shares;
  for (int row0 = 0; row0 + tile <= size.rows; row0 += tile) {
    for (int col0 = 0; col0 + tile <= size.cols; col0 += tile) {
      int ones = 0;
      for (int row = row0; row < row0 + tile; ++row) {
        for (int col = col0; col < col0 + tile; ++col) {
          ones += mask[size.index({.col = col, .row = row})];
        }
      }
      if (ones > 0) shares.push_back(static_cast<double>(ones) / (tile * tile));
    }
  }
  return shares;
}

int occupancySide(std::size_t measured_cells, GridSize size) {
  if (measured_cells == 0) return 0;
  // Tiles large enough to hold about 30 occupied cells on average.
  const double share = static_cast<double>(measured_cells) / static_cast<double>(size.count());
  const int longest = std::max(4, std::min(size.cols, size.rows) / 4);
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(30 / share))), 4, longest);
}

int samplingGapRadius(const Mask& measured, GridSize size) {
  const auto ones =
      static_cast<std::size_t>(std::count(measured.begin(), measured.end(), std::uint8_t{1}));
  if (ones == 0) return 0;
  return relievo::samplingGapRadius(tileOccupancy(measured, size, occupancySide(ones, size)), size);
}

/// Push: bilinear value of the coarse grid under a fine cell; fine cell f lies at (f - 0.5) / 2.
float coarseValue(const PushPullLayer& coarse, Cell fine) {
  const auto split = [](int f, int count, int& low, int& high) {
    const double x = std::clamp((f - 0.5) / 2, 0.0, count - 1.0);
    low = static_cast<int>(x);
    high = std::min(low + 1, count - 1);
    return static_cast<float>(x - low);
  };
  int c0 = 0;
  int c1 = 0;
  int r0 = 0;
  int r1 = 0;
  const float u = split(fine.col, coarse.size.cols, c0, c1);
  const float v = split(fine.row, coarse.size.rows, r0, r1);
  const auto at = [&](int col, int row) {
    return coarse.values[coarse.size.index({.col = col, .row = row})];
  };
  return (1 - v) * ((1 - u) * at(c0, r0) + u * at(c1, r0)) +
         v * ((1 - u) * at(c0, r1) + u * at(c1, r1));
}

/// From sums of weighted values to means.
void finishPull(PushPullLayer& coarse) {
  for (std::size_t i = 0; i < coarse.values.size(); ++i) {
    if (coarse.weights[i] > 0) coarse.values[i] /= coarse.weights[i];
    coarse.weights[i] = std::min(coarse.weights[i], 1.0F);
  }
}

void pushPull(std::vector<float>& values, const Mask& known, GridSize size) {
  // As `pulled` and `pushInto`, with the mask for the weights of the finest layer.
  std::vector<PushPullLayer> layers(1);
  layers[0].size = {.cols = (size.cols + 1) / 2, .rows = (size.rows + 1) / 2};
  layers[0].values.assign(layers[0].size.count(), 0.0F);
  layers[0].weights.assign(layers[0].size.count(), 0.0F);
  const int threads = threadsFor(2 * size.count(), 0);
  parallelFor(layers[0].size.rows, threads, [&](int first, int end) {
    for (int row = 2 * first; row < std::min(2 * end, size.rows); ++row) {
      for (int col = 0; col < size.cols; ++col) {
        const std::size_t from = size.index({.col = col, .row = row});
        if (known[from] == 0) continue;
        const std::size_t to = layers[0].size.index({.col = col / 2, .row = row / 2});
        layers[0].values[to] += values[from];
        layers[0].weights[to] += 1;
      }
    }
  });
  finishPull(layers[0]);
  while (layers.back().size.cols > 1 || layers.back().size.rows > 1) {
    layers.push_back(pulled(layers.back()));
  }
  for (std::size_t level = layers.size() - 1; level-- > 0;) {
    pushInto(layers[level], layers[level + 1]);
  }
  parallelFor(size.rows, threads, [&](int first, int end) {
    for (int row = first; row < end; ++row) {
      for (int col = 0; col < size.cols; ++col) {
        const std::size_t i = size.index({.col = col, .row = row});
        if (known[i] == 0) values[i] = coarseValue(layers[0], {.col = col, .row = row});
      }
    }
  });
}

}  // namespace

FilledMap fillWholeMap(CapturedDepths&& depths, const GridFrame& frame, const FillSource& source,
                       const HoleChoice& choice) {
  FilledMap result;
  const std::size_t count = frame.size.count();
  const int threads = threadsFor(kWorkOfCell * count, 0);
  const Mask had_points = maskOf(depths.front);
  // By the depths as given; asked for cells that stay measured only.
  const Mask steep = steepCells(depths, had_points, frame);
  depths.steep = {};
  FrontDepths filled = std::move(depths.front);
  Mask measured = had_points;
  const bool looks_for_gaps = source.has_sampling_gaps && !source.gaps_are_known;
  int radius = looks_for_gaps ? samplingGapRadius(measured, frame.size) : 0;
  // A back can hide all gaps: then no cell is empty, and the radius is 0.
  if (looks_for_gaps && !depths.one_layer) {
    result.seen_through = dropSeenThrough(filled, frame, radius + 1);
    for (std::size_t i = 0; i < depths.quality.counts.size(); ++i) {
      if (measured[i] != 0 && std::isnan(filled[i])) {
        result.seen_through_points += depths.quality.counts[i];
      }
    }
    measured = maskOf(filled);
    radius = samplingGapRadius(measured, frame.size);
  }
  result.base_z_mm = source.base_z_mm.value_or(baseOf(filled, measured, source.base_quantile));
  const Mask covered = source.gaps_are_known
                           ? closed(withBetween(measured, depths.between), frame.size, kCrackRadius)
                           : closed(measured, frame.size, radius);
  const EmptyAreas areas = emptyAreas(covered, frame.size);
  std::vector<LabelledHole> holes = enclosedHoles(areas, frame);
  for (LabelledHole& labelled : holes) labelled.hole.filled = isToBeFilled(labelled.hole, choice);

  // What the rule found between the points stands; the rest comes from the cells around. In a cell
  // that showed the back the rule found the back.
  Mask known = measured;
  forCells(depths.between.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      if (known[i] != 0 || covered[i] == 0 || std::isnan(depths.between[i])) continue;
      if (had_points[i] != 0) continue;
      filled[i] = depths.between[i];
      known[i] = 1;
    }
  });
  depths.between = {};
  pushPull(filled, known, frame.size);
  Mask gaps = covered;
  forCells(count, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      gaps[i] &= static_cast<std::uint8_t>(known[i] ^ 1U);
    }
  });
  keepWithinNeighbours(filled, Mask(known), gaps, frame.size);
  if (choice.rule == HoleRule::membrane) {
    layMembranes(holes, areas, covered, filled, frame.size);
  }

  std::vector<CellStatus> origin_of_label(areas.cells.size(), CellStatus::outside);
  for (const LabelledHole& labelled : holes) {
    origin_of_label[static_cast<std::size_t>(labelled.label)] =
        originOfHole(labelled.hole, choice.rule);
    result.holes.push_back(labelled.hole);
  }

  result.quality = std::move(depths.quality);
  DepthMap& map = result.map;
  map.frame = frame;
  reserveLarge(map.origins, count);
  map.origins.assign(count, CellStatus::outside);
  // In place: the depths are not needed any more.
  parallelFor(frame.size.rows, threads, [&](int first, int end) {
    for (std::size_t i = frame.size.index({.col = 0, .row = first});
         i < frame.size.index({.col = 0, .row = end}); ++i) {
      const int label = areas.label[i];
      const CellStatus origin = measured[i] != 0
                                    ? (steep[i] != 0 ? CellStatus::steep : CellStatus::measured)
                                : label < 0 ? CellStatus::interpolated
                                            : origin_of_label[static_cast<std::size_t>(label)];
      map.origins[i] = origin;
      const bool on_base = origin == CellStatus::base_plane || origin == CellStatus::outside;
      const double height = static_cast<double>(filled[i]) - result.base_z_mm;
      filled[i] = on_base ? 0.0F : static_cast<float>(height);
    }
  });
  map.heights_mm = std::move(filled);
  return result;
}

}  // namespace relievo::test
