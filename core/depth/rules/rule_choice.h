// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "core/base/task.h"
#include "core/depth/rules/cell_points.h"
#include "core/depth/rules/point_rule.h"

namespace relievo {

/// Points nearer to each other than this many sample distances, along the view, are one surface.
inline constexpr double kOtherLayerCells = 4;

/// Rows worked on together: many, to share what they look at around them, but still in the cache.
int rowsAtOnce(GridSize size);

inline RowRange widened(RowRange range, int by) {
  return {.first = range.first - by, .end = range.end + by};
}

/// Rows by which rule and noise are chosen, without flyers, and as far around them as fits look.
struct RowSample {
  RowRange range;
  RowPoints rows;
};

/// The rows that `samplesOf` asks for: all of a small grid, else every n-th unit, and around them.
std::vector<RowRange> rowsOfSamples(GridSize size);

/// [worker] @throw Cancelled
std::vector<RowSample> samplesOf(const CellPoints& points, const GridFrame& frame, int threads,
                                 const Task& task);

/// As `proposeRule` and `pointNoise` (point_rule.h), from such samples. [worker] @throw Cancelled
RuleProposal proposeRule(const std::vector<RowSample>& samples, const GridFrame& frame,
                         const Task& task);
double pointNoise(const std::vector<RowSample>& samples, const GridFrame& frame, int threads,
                  const Task& task);

}  // namespace relievo
