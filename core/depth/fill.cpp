// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/depth/mask.h"
#include "core/depth/push_pull.h"
#include "core/depth/see_through.h"

namespace relievo {
namespace {

/// Quantile with linear interpolation between order statistics, position q (n - 1).
double quantile(std::vector<float> values, double q) {
  const double position = q * (static_cast<double>(values.size()) - 1);
  const auto below = static_cast<std::ptrdiff_t>(position);
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const auto low = static_cast<double>(values[static_cast<std::size_t>(below)]);
  const double part = position - static_cast<double>(below);
  if (part == 0) return low;
  const auto next = std::min_element(values.begin() + below + 1, values.end());
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
  for (std::size_t i = 0; i < depths.size(); ++i) measured[i] = std::isnan(depths[i]) ? 0 : 1;
  return measured;
}

/// @throw ArgumentError  there are none
std::vector<float> measuredValues(const FrontDepths& depths) {
  std::vector<float> values;
  std::copy_if(depths.begin(), depths.end(), std::back_inserter(values),
               [](float z) { return !std::isnan(z); });
  if (values.empty()) {
    throw ArgumentError(
        "No cell of the grid was hit by the scan. Nothing was made. Choose another view.");
  }
  return values;
}

}  // namespace

Origin originOfHole(const Hole& hole, HoleRule rule) {
  if (hole.filled) return Origin::interpolated;
  return rule == HoleRule::none ? Origin::outside : Origin::base_plane;
}

FilledMap fillDepths(const FrontDepths& depths, const GridFrame& frame, const FillSource& source,
                     const HoleChoice& choice, const Task& task) {
  FilledMap result;
  const std::size_t count = frame.size.count();
  FrontDepths filled = depths;
  Mask measured = maskOf(filled);
  int radius = source.has_sampling_gaps ? samplingGapRadius(measured, frame.size) : 0;
  if (radius > 0) {
    result.seen_through = dropSeenThrough(filled, frame, radius + 1, task);
    measured = maskOf(filled);
    radius = samplingGapRadius(measured, frame.size);
  }
  task.check();
  result.base_z_mm = quantile(measuredValues(filled), source.base_quantile);
  const Mask covered = closed(measured, frame.size, radius);
  task.check();
  const EmptyAreas areas = emptyAreas(covered, frame.size);
  std::vector<LabelledHole> holes = enclosedHoles(areas, frame);

  std::vector<Origin> origin_of_label(areas.cells.size(), Origin::outside);
  for (LabelledHole& labelled : holes) {
    labelled.hole.filled =
        choice.rule == HoleRule::interpolate && labelled.hole.area_mm2 <= choice.max_area_mm2;
    origin_of_label[static_cast<std::size_t>(labelled.label)] =
        originOfHole(labelled.hole, choice.rule);
    result.holes.push_back(labelled.hole);
  }

  pushPull(filled, measured, frame.size, task);
  task.check();

  DepthMap& map = result.map;
  map.frame = frame;
  map.heights_mm.assign(count, 0.0F);
  map.origins.assign(count, Origin::outside);
  for (std::size_t i = 0; i < count; ++i) {
    const int label = areas.label[i];
    const Origin origin = measured[i] != 0 ? Origin::measured
                          : label < 0      ? Origin::interpolated
                                           : origin_of_label[static_cast<std::size_t>(label)];
    map.origins[i] = origin;
    if (origin == Origin::measured || origin == Origin::interpolated) {
      map.heights_mm[i] = static_cast<float>(static_cast<double>(filled[i]) - result.base_z_mm);
    }
  }
  return result;
}

}  // namespace relievo
