// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/fill.h"

#include <algorithm>
#include <cmath>
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

namespace relievo {
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
                  FrontDepths& depths, GridSize size, const Task& task) {
  const auto cells = cellsOf(holes, areas);
  for (std::size_t k = 0; k < holes.size(); ++k) {
    if (!holes[k].hole.filled) continue;
    task.report("Filling holes", static_cast<double>(k) / static_cast<double>(holes.size()));
    holes[k].hole.filled = fillWithMembrane(depths, covered, cells[k], size, task);
  }
}

NumberArgument squareMm(double area_mm2) {
  return {.value = area_mm2, .digits = 4, .form = NumberArgument::Form::significant};
}

}  // namespace

Mask withBetween(Mask measured, const FrontDepths& between) {
  for (std::size_t i = 0; i < between.size(); ++i) {
    measured[i] |= static_cast<std::uint8_t>(between[i] == between[i] ? 1 : 0);
  }
  return measured;
}

Mask steepCells(const CapturedDepths& depths, const Mask& measured, const GridFrame& frame) {
  Mask steep = depths.steep.empty() ? Mask(measured.size(), 0) : depths.steep;
  const auto limit = static_cast<float>(kSteepRise * frame.spacing_mm);
  const auto cols = static_cast<std::size_t>(frame.size.cols);
  const auto rows = static_cast<std::size_t>(frame.size.rows);
  // From the cell `step` before to the one `step` after, for cells first ... end - 1.
  const auto mark = [&](std::size_t first, std::size_t end, std::size_t step) {
    const float* before = depths.front.data() + first - step;
    const float* here = depths.front.data() + first;
    const float* after = here + step;
    const std::uint8_t* has_height = measured.data() + first;
    std::uint8_t* to = steep.data() + first;
    for (std::size_t i = 0; i < end - first; ++i) {
      const float in = here[i] - before[i];
      const float out = after[i] - here[i];
      const int up = static_cast<int>(in > limit) & static_cast<int>(out > limit);  // Not for NaN.
      const int down = static_cast<int>(in < -limit) & static_cast<int>(out < -limit);
      to[i] = static_cast<std::uint8_t>(to[i] | (has_height[i] & (up | down)));
    }
  };
  const int threads = threadsFor(kWorkOfCell * measured.size(), 0);
  parallelFor(frame.size.rows, threads, [&](int first, int end) {
    for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(end); ++row) {
      if (cols > 2) mark(row * cols + 1, (row + 1) * cols - 1, 1);
      if (row > 0 && row + 1 < rows) mark(row * cols, (row + 1) * cols, cols);
    }
  });
  return steep;
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
    result.seen_through = dropSeenThrough(filled, frame, radius + 1, task);
    for (std::size_t i = 0; i < depths.quality.counts.size(); ++i) {
      if (measured[i] != 0 && std::isnan(filled[i])) {
        result.seen_through_points += depths.quality.counts[i];
      }
    }
    measured = maskOf(filled);
    radius = samplingGapRadius(measured, frame.size);
  }
  task.check();
  result.base_z_mm = source.base_z_mm.value_or(baseOf(filled, measured, source.base_quantile));
  const Mask covered = source.gaps_are_known
                           ? closed(withBetween(measured, depths.between), frame.size, kCrackRadius)
                           : closed(measured, frame.size, radius);
  task.check();
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
  pushPull(filled, known, frame.size, task);
  task.check();
  Mask gaps = covered;
  forCells(count, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      gaps[i] &= static_cast<std::uint8_t>(known[i] ^ 1U);
    }
  });
  keepWithinNeighbours(filled, known, gaps, frame.size);
  if (choice.rule == HoleRule::membrane) {
    layMembranes(holes, areas, covered, filled, frame.size, task);
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

}  // namespace relievo
