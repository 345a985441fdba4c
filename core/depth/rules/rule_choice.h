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

/// Rows by which rule and noise are chosen, without outliers, and as far around them as fits look.
struct RowSample {
  RowRange range;
  RowPoints rows;
};

/// The rows that `samplesOf` asks for: all of a small grid, else every n-th unit, and around them.
std::vector<RowRange> rowsOfSamples(GridSize size);

/// What lies within one of these ranges, so that they can be had one after the other where all
/// together are too many points. @param points  of at least `range`, one of rowsOfSamples
/// [worker] @throw Cancelled
RowSample sampleOf(const CellPoints& points, RowRange range, const GridFrame& frame);

/// [worker] @throw Cancelled
std::vector<RowSample> samplesOf(const CellPoints& points, const GridFrame& frame, int threads,
                                 const Task& task);

/// What `proposeRule` counts in such samples; they can be added one after the other.
struct SampleCounts {
  std::size_t points = 0;
  std::size_t inside = 0;  ///< Cells with a point in the 3 x 3 around: the object, gaps included.
  std::size_t occupied = 0, layered = 0, off_samples = 0;

  void add(const RowSample& sample, double spacing_mm);
  double pointsPerCell() const noexcept;
};
RuleProposal proposeRule(const SampleCounts& found);
/// Noise in one sample; `pointNoise` is the median of these.
double noiseOf(const RowSample& sample, double spacing_mm);
double middleNoise(std::vector<double> noises);

/// As `proposeRule` and `pointNoise` (point_rule.h), from such samples. [worker] @throw Cancelled
RuleProposal proposeRule(const std::vector<RowSample>& samples, const GridFrame& frame, int threads,
                         const Task& task);
double pointNoise(const std::vector<RowSample>& samples, const GridFrame& frame, int threads,
                  const Task& task);

}  // namespace relievo
